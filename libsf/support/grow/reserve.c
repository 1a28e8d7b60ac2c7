// SPDX-License-Identifier: MIT
// Reserve: the slack of a grid's living voxels in a quarter of the memory that a byte each takes.
//
// Inside a shape, over its walls and a step above what carries it a voxel has all the slack there
// is; on shapes one living voxel in fifty has less, along overhangs. So a bit for each voxel says
// whether it has less, and only then there is a byte, which is found by the place of the row's
// first and the number of such voxels before it. At 512^3 that is 16 MB of bits, 2 MB of places and
// the bytes.

#include "support/grow/reserve.h"

#include "base/bits.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "support/rule/codes.h"
#include "voxel/slice.h"

#define WORD 64

void sfi_reserve_destroy(sfi_reserve *reserve)
{
    const sf_allocator *from = &reserve->allocator;
    sf_grid_destroy(reserve->below);
    sfi_free_array(from, reserve->starts, reserve->row_count, sizeof *reserve->starts);
    sfi_free_array(from, reserve->codes, reserve->capacity, sizeof *reserve->codes);
    reserve->below = NULL;
    reserve->starts = NULL;
    reserve->codes = NULL;
    reserve->capacity = 0;
}

sf_status sfi_reserve_create(const sf_rule *rule, const sf_lattice *lattice,
                             const sf_allocator *allocator, sfi_reserve *reserve)
{
    sfi_reserve r = {.height = lattice->ny, .top = (uint8_t)(rule->slack_cap + 1)};
    r.allocator = sfi_allocator_or_default(allocator);
    if (!sfi_size_mul(lattice->nz, lattice->ny, &r.row_count)) {
        return SF_ERR_OVERFLOW;
    }
    SF_TRY(sf_grid_create(lattice, allocator, &r.below));
    r.starts = sfi_alloc_array(&r.allocator, r.row_count, sizeof *r.starts);
    if (r.starts == NULL) {
        sfi_reserve_destroy(&r);
        return SF_ERR_MEMORY;
    }
    *reserve = r;
    return SF_OK;
}

// Which of 64 voxels have less than the cap.
static uint64_t find_below(const uint8_t *codes, uint64_t alive, uint8_t top)
{
    uint64_t below = 0, all = top * UINT64_C(0x0101010101010101);
    uint8_t differ = 0;
    if (alive == 0) {
        return 0;
    }
    for (unsigned b = 0; b < WORD; b++) {
        differ |= (uint8_t)(codes[b] ^ top);
    }
    if (differ == 0) {
        return 0;
    }
    for (unsigned b = 0; b < WORD; b += 8) {
        below |= sfi_gather_bytes(sfi_load_bytes(codes + b) ^ all) << b;
    }
    return below & alive;
}

static sf_status append(sfi_reserve *r, const uint8_t *codes, uint64_t below)
{
    void *all = r->codes;
    size_t need;
    if (below == 0) {
        return SF_OK;
    }
    if (!sfi_size_add(r->count, WORD, &need)) {
        return SF_ERR_OVERFLOW;
    }
    if (!sfi_grow_array(&r->allocator, &all, &r->capacity, need, sizeof *r->codes)) {
        return SF_ERR_MEMORY;
    }
    r->codes = all;
    for (; below != 0; below &= below - 1) {
        r->codes[r->count++] = codes[sfi_lowest_bit(below)];
    }
    return SF_OK;
}

sf_status sfi_reserve_add(sfi_reserve *reserve, uint32_t k, const sfi_front *front)
{
    sf_slice below = sf_grid_slice(reserve->below, k);
    size_t words = sfi_row_words(below.width);
    for (uint32_t y = 0; y < below.height; y++) {
        const uint64_t *alive = sfi_slice_row(front->alive, y);
        const uint8_t *codes = front->slack + y * sfi_slack_stride(below.width);
        uint64_t *row = sfi_slice_row(below, y);
        reserve->starts[(size_t)k * below.height + y] = reserve->count;
        for (size_t i = 0; i < words; i++) {
            row[i] = find_below(codes + i * WORD, alive[i], reserve->top);
            SF_TRY(append(reserve, codes + i * WORD, row[i]));
        }
    }
    return SF_OK;
}

uint32_t sfi_reserve_slack(const sfi_reserve *reserve, sf_voxel v)
{
    const uint64_t *row = sfi_slice_row(sf_grid_slice(reserve->below, v.z), v.y);
    uint64_t bit = UINT64_C(1) << (v.x % WORD), before = row[v.x / WORD] & (bit - 1);
    if ((row[v.x / WORD] & bit) == 0) {
        return reserve->top - 1u;
    }
    const sfi_kernels *kernels = sfi_kernels_get();
    uint64_t rank = kernels->popcount(&before, 1);
    rank += v.x >= WORD ? kernels->popcount(row, v.x / WORD) : 0;
    return reserve->codes[reserve->starts[(size_t)v.z * reserve->height + v.y] + rank] - 1u;
}
