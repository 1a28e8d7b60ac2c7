// SPDX-License-Identifier: MIT
// Rows of voxels of a mesh with holes.
//
// Along a row, let M(x) be the crossings of the mesh up to x, P(x) those of the patches over its
// holes (both signed), and w(x) the patches' winding number. Mesh and patches are closed, so M + P
// is their winding number, and the mesh's own is M + P - w: solid where that is at least a half,
// that is where M + P - round(w) >= 1.
//
// The lattice is cut into boxes of 32 voxels a side, and those into boxes of 8. A box is surveyed
// once for all its rows. Where no patch comes near and w stays clear of a half, round(w) is the
// same everywhere: such a box costs a row no more than its crossings. The other voxels are judged
// one by one, and they are few: those that lie near the surface that spans a hole.
//
// Boxes lie on the lattice and depend on nothing else, so it does not matter who fills which row.

#include "mesh/hole.h"

#include "base/memory.h"
#include "simd/kernels.h"

#include <string.h>

static const uint32_t sides[2] = {4 * SFI_HOLE_BOX, SFI_HOLE_BOX};

typedef struct interval {
    uint32_t x0, x1;
} interval;

typedef struct open_row {
    sfi_lane *lane;
    sfi_hole_lane *holes;
    size_t change_count; // changes made sums: mesh and cap count from the row's start
    const sfi_frame *frame;
    const sfi_skin *skin;
    uint32_t y, k;
    uint64_t *words;
} open_row;

sf_status sfi_hole_lane_create(uint32_t nx, const sf_allocator *allocator, sfi_hole_lane *lane)
{
    memset(lane, 0, sizeof *lane);
    for (int level = 0; level < 2; level++) {
        uint32_t count = (nx - 1) / sides[level] + 1;
        lane->counts[level] = count;
        lane->tile_y[level] = lane->tile_k[level] = UINT32_MAX;
        lane->boxes[level] = sfi_alloc_array(allocator, count, sizeof *lane->boxes[level]);
        lane->known[level] = sfi_alloc_array(allocator, count, 1);
        if (lane->boxes[level] == NULL || lane->known[level] == NULL) {
            sfi_hole_lane_destroy(lane, allocator);
            return SF_ERR_MEMORY;
        }
    }
    return SF_OK;
}

void sfi_hole_lane_destroy(sfi_hole_lane *lane, const sf_allocator *allocator)
{
    for (int level = 0; level < 2; level++) {
        uint32_t count = lane->counts[level];
        sfi_free_array(allocator, lane->boxes[level], count, sizeof *lane->boxes[level]);
        sfi_free_array(allocator, lane->known[level], count, 1);
    }
    memset(lane, 0, sizeof *lane);
}

static sfi_point voxel_center(const sfi_frame *frame, uint32_t x, uint32_t y, uint32_t k)
{
    sfi_point q = {(int32_t)(x * SFI_UNITS + SFI_UNITS / 2),
                   (int32_t)(y * SFI_UNITS + SFI_UNITS / 2), sfi_frame_center(frame, k)};
    return q;
}

static uint32_t box_last(uint32_t box, uint32_t side, uint32_t count)
{
    uint32_t end = (box + 1) * side;
    return (end < count ? end : count) - 1;
}

// Corner centres of the box around a row at voxel x.
static void box_corners(const open_row *row, uint32_t x, uint32_t side, sfi_point *low,
                        sfi_point *high)
{
    const sfi_frame *f = row->frame;
    uint32_t bx = x / side, by = row->y / side, bk = row->k / side;
    *low = voxel_center(f, bx * side, by * side, bk * side);
    *high = voxel_center(f, box_last(bx, side, f->nx), box_last(by, side, f->ny),
                         box_last(bk, side, f->nz));
}

static const sfi_winding_block *box_at(const open_row *row, int level, uint32_t x)
{
    sfi_hole_lane *holes = row->holes;
    uint32_t side = sides[level], box = x / side;
    if (holes->tile_y[level] != row->y / side || holes->tile_k[level] != row->k / side) {
        holes->tile_y[level] = row->y / side;
        holes->tile_k[level] = row->k / side;
        memset(holes->known[level], 0, holes->counts[level]);
    }
    if (!holes->known[level][box]) {
        sfi_point low, high;
        box_corners(row, x, side, &low, &high);
        sfi_winding_survey(&row->skin->winding, row->skin->points, low, high,
                           &holes->boxes[level][box]);
        holes->known[level][box] = 1;
    }
    return &holes->boxes[level][box];
}

// How many changes have happened at voxel x.
static size_t changes_until(const open_row *row, uint32_t x)
{
    size_t low = 0, high = row->change_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (row->lane->changes[middle].voxel <= x) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

static void sum_changes(sfi_change *changes, size_t count)
{
    for (size_t i = 1; i < count; i++) {
        changes[i].mesh += changes[i - 1].mesh;
        changes[i].cap += changes[i - 1].cap;
    }
}

static void set_run(const open_row *row, uint32_t x0, uint32_t x1)
{
    sfi_row_set(row->words, x0, x1);
    row->lane->solid_voxels += x1 - x0;
}

// Fill an interval in which round(w) - P is `threshold` everywhere.
static void fill_interval(const open_row *row, interval i, int64_t threshold)
{
    const sfi_change *changes = row->lane->changes;
    size_t next = changes_until(row, i.x0);
    while (i.x0 < i.x1) {
        int64_t mesh = next > 0 ? changes[next - 1].mesh : 0;
        uint32_t end = next < row->change_count ? changes[next].voxel : i.x1;
        end = end < i.x1 ? end : i.x1;
        if (mesh > threshold && end > i.x0) {
            set_run(row, i.x0, end);
        }
        i.x0 = end > i.x0 ? end : i.x0;
        next++;
    }
}

static int64_t patches_at(const open_row *row, uint32_t x)
{
    size_t n = changes_until(row, x);
    return n > 0 ? row->lane->changes[n - 1].cap : 0;
}

static double share_of(int32_t low, int32_t at, int32_t high)
{
    return high > low ? (double)(at - low) / (double)(high - low) : 0.0;
}

static void judge_voxels(const open_row *row, interval i, const sfi_winding_block *box)
{
    sfi_point low, high, q = voxel_center(row->frame, i.x0, row->y, row->k);
    box_corners(row, i.x0, SFI_HOLE_BOX, &low, &high);
    double share[3] = {0.0, share_of(low.y, q.y, high.y), share_of(low.z, q.z, high.z)};
    for (uint32_t x = i.x0; x < i.x1; x++) {
        interval one = {x, x + 1};
        q.x = voxel_center(row->frame, x, row->y, row->k).x;
        share[0] = share_of(low.x, q.x, high.x);
        int64_t w = sfi_winding_round_in(&row->skin->winding, row->skin->points, box, share, q);
        fill_interval(row, one, w - patches_at(row, x));
    }
}

// Fill what a large box holds of the row, by its small ones where that cannot be done at once.
static void fill_boxes(const open_row *row, interval i)
{
    const sfi_winding_block *box = box_at(row, 0, i.x0);
    if (box->uniform) {
        fill_interval(row, i, box->whole - patches_at(row, i.x0));
        return;
    }
    while (i.x0 < i.x1) {
        uint32_t end = i.x0 + SFI_HOLE_BOX < i.x1 ? i.x0 + SFI_HOLE_BOX : i.x1;
        interval part = {i.x0, end};
        box = box_at(row, 1, i.x0);
        if (box->uniform) {
            fill_interval(row, part, box->whole - patches_at(row, i.x0));
        } else {
            judge_voxels(row, part, box);
        }
        i.x0 = end;
    }
}

void sfi_row_fill_open(sfi_lane *lane, sfi_hole_lane *holes, size_t change_count,
                       const sfi_frame *frame, const sfi_skin *skin, uint32_t y, uint32_t k,
                       uint64_t *words)
{
    open_row row = {lane, holes, change_count, frame, skin, y, k, words};
    sum_changes(lane->changes, change_count);
    memset(words, 0, sfi_row_words(frame->nx) * sizeof *words);
    for (uint32_t x = 0; x < frame->nx; x += sides[0]) {
        interval part = {x, x + sides[0] < frame->nx ? x + sides[0] : frame->nx};
        fill_boxes(&row, part);
    }
}
