// SPDX-License-Identifier: MIT
// From the crossings of rows to their voxels.
//
// The crossings of a window come in the order of its triangles. A counting sort puts them in order
// of rows; a row has few of them, and an insertion sort does the rest. A row that has many (a soup
// of triangles, a brush) is summed into one counter per voxel instead, so that the work is linear
// however bad the mesh is, and where even one row's crossings do not fit the buffer they are summed
// piecemeal.

#include "mesh/row.h"

#include "base/memory.h"
#include "simd/kernels.h"

#include <string.h>

sf_status sfi_lane_create(uint32_t nx, size_t rows, size_t crossings, const sf_allocator *allocator,
                          sfi_lane *lane)
{
    memset(lane, 0, sizeof *lane);
    lane->voxel_count = (size_t)nx + 1;
    lane->row_capacity = rows;
    lane->crossings.capacity = crossings;
    lane->crossings.items = sfi_alloc_array(allocator, crossings, sizeof(uint64_t));
    lane->crossings.row_counts = sfi_alloc_array(allocator, rows, sizeof(uint32_t));
    lane->steps = sfi_alloc_array(allocator, crossings, sizeof(uint32_t));
    lane->row_ends = sfi_alloc_array(allocator, rows, sizeof(size_t));
    lane->sums = sfi_alloc_array(allocator, lane->voxel_count, 2 * sizeof(int32_t));
    size_t changes = lane->voxel_count > SFI_SORT_MAX ? lane->voxel_count : SFI_SORT_MAX;
    lane->changes = sfi_alloc_array(allocator, changes, sizeof(sfi_change));
    if (lane->crossings.items == NULL || lane->crossings.row_counts == NULL ||
        lane->steps == NULL || lane->row_ends == NULL || lane->sums == NULL ||
        lane->changes == NULL) {
        sfi_lane_destroy(lane, allocator);
        return SF_ERR_MEMORY;
    }
    memset(lane->sums, 0, lane->voxel_count * 2 * sizeof(int32_t));
    return SF_OK;
}

void sfi_lane_destroy(sfi_lane *lane, const sf_allocator *allocator)
{
    size_t crossings = lane->crossings.capacity, rows = lane->row_capacity;
    size_t changes = lane->voxel_count > SFI_SORT_MAX ? lane->voxel_count : SFI_SORT_MAX;
    sfi_free_array(allocator, lane->crossings.items, crossings, sizeof(uint64_t));
    sfi_free_array(allocator, lane->crossings.row_counts, rows, sizeof(uint32_t));
    sfi_free_array(allocator, lane->steps, crossings, sizeof(uint32_t));
    sfi_free_array(allocator, lane->row_ends, rows, sizeof(size_t));
    sfi_free_array(allocator, lane->sums, lane->voxel_count, 2 * sizeof(int32_t));
    sfi_free_array(allocator, lane->changes, changes, sizeof(sfi_change));
    memset(lane, 0, sizeof *lane);
}

void sfi_lane_clear(sfi_lane *lane, size_t rows)
{
    lane->crossings.count = 0;
    lane->spilled = 0;
    memset(lane->crossings.row_counts, 0, (rows) * sizeof(uint32_t));
}

static void add_step(int32_t *sums, uint32_t step)
{
    size_t slot = 2 * (size_t)(step >> SFI_STEP_SHIFT) + ((step & SFI_STEP_CAP) != 0);
    sums[slot] += (step & SFI_STEP_LEAVES) != 0 ? -1 : 1;
}

void sfi_lane_spill(sfi_lane *lane)
{
    for (size_t i = 0; i < lane->crossings.count; i++) {
        add_step(lane->sums, (uint32_t)lane->crossings.items[i]);
    }
    lane->crossings.count = 0;
    lane->spilled = 1;
}

void sfi_lane_sort(sfi_lane *lane, size_t rows)
{
    size_t start = 0;
    for (size_t row = 0; row < rows; row++) {
        lane->row_ends[row] = start;
        start += lane->crossings.row_counts[row];
    }
    for (size_t i = 0; i < lane->crossings.count; i++) {
        uint64_t item = lane->crossings.items[i];
        lane->steps[lane->row_ends[item >> 32]++] = (uint32_t)item;
    }
}

static size_t changes_from_sums(sfi_lane *lane)
{
    size_t count = 0;
    for (size_t x = 0; x < lane->voxel_count; x++) {
        int32_t mesh = lane->sums[2 * x], cap = lane->sums[2 * x + 1];
        if (mesh != 0 || cap != 0) {
            lane->changes[count++] = (sfi_change){(uint32_t)x, mesh, cap};
        }
    }
    memset(lane->sums, 0, lane->voxel_count * 2 * sizeof(int32_t));
    return count;
}

static void sort_steps(uint32_t *steps, size_t count)
{
    for (size_t i = 1; i < count; i++) {
        uint32_t step = steps[i];
        size_t j = i;
        for (; j > 0 && steps[j - 1] > step; j--) {
            steps[j] = steps[j - 1];
        }
        steps[j] = step;
    }
}

size_t sfi_lane_row(sfi_lane *lane, size_t row)
{
    if (lane->spilled) {
        sfi_lane_spill(lane);
        return changes_from_sums(lane);
    }
    size_t count = lane->crossings.row_counts[row];
    uint32_t *steps = lane->steps + (lane->row_ends[row] - count);
    if (count > SFI_SORT_MAX) {
        for (size_t i = 0; i < count; i++) {
            add_step(lane->sums, steps[i]);
        }
        return changes_from_sums(lane);
    }
    sort_steps(steps, count);
    for (size_t i = 0; i < count; i++) {
        int32_t move = (steps[i] & SFI_STEP_LEAVES) != 0 ? -1 : 1;
        int cap = (steps[i] & SFI_STEP_CAP) != 0;
        lane->changes[i] = (sfi_change){steps[i] >> SFI_STEP_SHIFT, cap ? 0 : move, cap ? move : 0};
    }
    return count;
}

void sfi_row_set(uint64_t *words, uint32_t x0, uint32_t x1)
{
    if (x0 >= x1) {
        return;
    }
    uint32_t first = x0 / 64, last = (x1 - 1) / 64;
    uint64_t head = UINT64_MAX << x0 % 64, tail = UINT64_MAX >> (63 - (x1 - 1) % 64);
    if (first == last) {
        words[first] |= head & tail;
        return;
    }
    words[first] |= head;
    for (uint32_t i = first + 1; i < last; i++) {
        words[i] = UINT64_MAX;
    }
    words[last] |= tail;
}

// From its changes.
static void fill_row(sfi_lane *lane, size_t change_count, sf_fill fill, uint64_t *words)
{
    uint32_t nx = (uint32_t)(lane->voxel_count - 1), start = nx;
    int32_t winding = 0;
    int inside = 0;
    memset(words, 0, sfi_row_words(nx) * sizeof(uint64_t));
    for (size_t i = 0; i < change_count; i++) {
        sfi_change change = lane->changes[i];
        winding += change.mesh + change.cap;
        int now = fill == SF_FILL_PARITY ? winding % 2 != 0 : winding >= 1;
        if (now && !inside) {
            start = change.voxel;
        } else if (inside && !now) {
            sfi_row_set(words, start, change.voxel);
            lane->solid_voxels += change.voxel - start;
        }
        inside = now;
    }
    if (inside) { // the row leaks
        sfi_row_set(words, start, nx);
        lane->solid_voxels += nx - start;
    }
    lane->odd_rows += fill == SF_FILL_PARITY ? winding % 2 != 0 : winding != 0;
}

// Most rows have few crossings, and their changes need not be written down.
void sfi_lane_fill(sfi_lane *lane, size_t row, sf_fill fill, uint64_t *words)
{
    uint32_t count = lane->crossings.row_counts[row];
    if (count > SFI_SORT_MAX || lane->spilled) {
        fill_row(lane, sfi_lane_row(lane, row), fill, words);
        return;
    }
    uint32_t nx = (uint32_t)(lane->voxel_count - 1), start = nx;
    for (size_t i = 0, end = sfi_row_words(nx); i < end; i++) {
        words[i] = 0;
    }
    if (count == 0) {
        return;
    }
    uint32_t *steps = lane->steps + (lane->row_ends[row] - count);
    if (count == 2) { // one way in, one out: which comes first is a coin toss, so no branch asks
        uint32_t low = steps[0] < steps[1] ? steps[0] : steps[1], high = steps[0] ^ steps[1] ^ low;
        if ((low & SFI_STEP_LEAVES) == 0 && (high & SFI_STEP_LEAVES) != 0) {
            sfi_row_set(words, low >> SFI_STEP_SHIFT, high >> SFI_STEP_SHIFT);
            lane->solid_voxels += (high >> SFI_STEP_SHIFT) - (low >> SFI_STEP_SHIFT);
            return;
        }
    }
    sort_steps(steps, count);
    int32_t winding = 0, inside = 0, parity = fill == SF_FILL_PARITY;
    for (uint32_t i = 0; i < count; i++) {
        winding += (steps[i] & SFI_STEP_LEAVES) != 0 ? -1 : 1;
        int now = parity ? winding & 1 : winding >= 1;
        uint32_t voxel = steps[i] >> SFI_STEP_SHIFT;
        if (inside && !now) {
            sfi_row_set(words, start, voxel);
            lane->solid_voxels += voxel - start;
        }
        start = now && !inside ? voxel : start;
        inside = now;
    }
    if (inside) {
        sfi_row_set(words, start, nx);
        lane->solid_voxels += nx - start;
    }
    lane->odd_rows += parity ? (winding & 1) != 0 : winding != 0;
}
