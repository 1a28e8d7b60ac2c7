// SPDX-License-Identifier: MIT
// Rows of voxels of a mesh with holes.
//
// Along a row, let M(x) be the crossings of the mesh up to x, P(x) those of the patches over its
// holes (both signed), and w(x) the patches' winding number. Mesh and patches are closed, so M + P
// is their winding number, and the mesh's own is M + P - w: solid where that is at least a half,
// that is where M + P - round(w) >= 1.
//
// w is smooth but for jumps where the row crosses a patch, and P jumps there as well; so
// round(w) - P changes only where w passes a half. An interval in which w stays clear of that needs
// one look, at its middle: its distance from a half against the steepest slope around it. Other
// intervals are halved, down to single voxels, which are judged by their own. Far from the holes a
// row is one interval; only where the surface that spans a hole is met, they get short. What an
// interval decides is what each of its voxels would: the result is that of the plain formula.

#include "mesh/hole.h"

#include <math.h>

typedef struct interval {
    uint32_t x0, x1;
} interval;

typedef struct open_row {
    sfi_lane *lane;
    size_t change_count; // changes made sums: mesh and cap count from the row's start
    const sfi_skin *skin;
    int32_t y, z;
    uint64_t *words;
} open_row;

static sfi_point voxel_center(const open_row *row, uint32_t x)
{
    sfi_point q = {(int32_t)(x * SFI_UNITS + SFI_UNITS / 2), row->y, row->z};
    return q;
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

// Whether one look settles the interval; if so it is filled.
static int settle(const open_row *row, interval i)
{
    const sfi_winding *w = &row->skin->winding;
    uint32_t middle = i.x0 + (i.x1 - i.x0) / 2;
    sfi_point q = voxel_center(row, middle);
    double reach = (double)(middle - i.x0) * SFI_UNITS;
    double slope = sfi_winding_slope(w, row->skin->points, q, reach);
    if (!(slope * reach < 0.5)) {
        return 0;
    }
    double error, value = sfi_winding_estimate(w, row->skin->points, q, 0x1p-8, &error);
    double whole = floor(value + 0.5);
    if (!(fabs(value - whole) + error + slope * reach < 0.5)) {
        return 0;
    }
    fill_interval(row, i, (int64_t)whole - patches_at(row, middle));
    return 1;
}

static void judge_voxel(const open_row *row, uint32_t x)
{
    int64_t w = sfi_winding_round(&row->skin->winding, row->skin->points, voxel_center(row, x));
    interval i = {x, x + 1};
    fill_interval(row, i, w - patches_at(row, x));
}

void sfi_row_fill_open(sfi_lane *lane, size_t change_count, const sfi_frame *frame,
                       const sfi_skin *skin, uint32_t y, uint32_t k, uint64_t *words)
{
    open_row row = {lane, change_count, skin, 0, sfi_frame_center(frame, k), words};
    row.y = (int32_t)(y * SFI_UNITS + SFI_UNITS / 2);
    interval stack[40]; // one waiting half for each halving of at most 2^16 voxels
    size_t depth = 0;
    sum_changes(lane->changes, change_count);
    stack[depth++] = (interval){0, frame->nx};
    for (uint32_t word = 0; word < (frame->nx + 63) / 64; word++) {
        words[word] = 0;
    }
    while (depth > 0) {
        interval i = stack[--depth];
        if (i.x1 - i.x0 == 1) {
            judge_voxel(&row, i.x0);
        } else if (!settle(&row, i)) {
            uint32_t middle = i.x0 + (i.x1 - i.x0) / 2;
            stack[depth++] = (interval){middle, i.x1};
            stack[depth++] = (interval){i.x0, middle};
        }
    }
}
