// SPDX-License-Identifier: MIT
// Rows of voxels of a mesh with holes.
//
// Along a row, let M(x) be the crossings of the mesh up to x, P(x) those of the patches over its
// holes (both signed), and w(x) the patches' winding number. Mesh and patches are closed, so M + P
// is their winding number, and the mesh's own is M + P - w: solid where that is at least a half,
// that is where M + P - round(w) >= 1.
//
// Away from the boundary of the holes, w changes smoothly but where a patch is crossed, and there P
// takes the same step. So u = w - P is smooth along a row, a voxel is solid where u <= M - 1/2, and
// nothing has to be known of u but that it is clear of that. The lattice is cut into boxes of 32
// voxels a side, those into boxes of 16, and so on down to 2. A box is surveyed once for all its
// rows: it knows w in it but for whole turns, with a bound (survey.c). The whole turns come from
// the box before, at the place between both; from P, where no patch comes into the box; or from one
// voxel, looked at by itself. What a box cannot tell of a row is left to the boxes within, and at
// last to the voxels: those that lie at the surface where the winding number of the mesh is a half,
// or at the boundary of a hole.
//
// Boxes lie on the lattice and depend on nothing else, so it does not matter who fills which row.

#include "mesh/hole.h"

#include "base/memory.h"
#include "simd/kernels.h"

#include <math.h>
#include <string.h>

#define LAST (SFI_HOLE_LEVELS - 1)

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
    size_t next;            // change after the voxel that the row has come to
    int64_t mesh, patches;  // M and P there
    double place[3];        // of its first voxel, in lengths
    int known;              // whether u half a voxel before the next voxel is known
    double before, mistake; // u there, to within its mistake
    const sfi_winding_box *around[SFI_HOLE_LEVELS]; // the boxes around the next voxel
    double turns[SFI_HOLE_LEVELS]; // what u is beyond the smooth ones' in this row: whole turns
} open_row;

static uint32_t side_of(int level)
{
    return SFI_HOLE_BOX >> level;
}

sf_status sfi_hole_lane_create(uint32_t nx, const sf_allocator *allocator, sfi_hole_lane *lane)
{
    memset(lane, 0, sizeof *lane);
    for (int level = 0; level < SFI_HOLE_LEVELS; level++) {
        uint32_t count = (nx - 1) / side_of(level) + 1;
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
    for (int level = 0; level < SFI_HOLE_LEVELS; level++) {
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

// The box around voxel x of the row, which lies in `parent`.
static const sfi_winding_box *box_at(const open_row *row, int level, uint32_t x,
                                     const sfi_winding_box *parent)
{
    sfi_hole_lane *holes = row->holes;
    uint32_t side = side_of(level), box = x / side;
    if (holes->tile_y[level] != row->y / side || holes->tile_k[level] != row->k / side) {
        holes->tile_y[level] = row->y / side;
        holes->tile_k[level] = row->k / side;
        memset(holes->known[level], 0, holes->counts[level]);
    }
    if (!holes->known[level][box]) {
        sfi_point low, high;
        box_corners(row, x, side, &low, &high);
        sfi_winding_survey(&row->skin->winding, row->skin->points, low, high, parent,
                           &holes->boxes[level][box]);
        holes->known[level][box] = 1;
    }
    return &holes->boxes[level][box];
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

// Come to voxel x. Rows are filled from left to right. Returns where M or P may change next.
static uint32_t come_to(open_row *row, uint32_t x)
{
    const sfi_change *changes = row->lane->changes;
    while (row->next < row->change_count && changes[row->next].voxel <= x) {
        row->mesh = changes[row->next].mesh;
        row->patches = changes[row->next].cap;
        row->next++;
    }
    return row->next < row->change_count ? changes[row->next].voxel : row->frame->nx;
}

// Where voxel x is, half a voxel more or less, as seen from the middle of a box.
static inline void see_voxel(const open_row *row, const sfi_winding_box *box, uint32_t x,
                             double half, double at[3])
{
    at[0] = (double)(x * SFI_UNITS + SFI_UNITS / 2) + half * SFI_UNITS - box->place[0];
    at[1] = row->place[1] - box->place[1];
    at[2] = row->place[2] - box->place[2];
}

// Whether voxel x is solid, by the smallest box that can tell, not below `level`.
static int judge_voxel(const open_row *row, int level, uint32_t x)
{
    const sfi_winding *winding = &row->skin->winding;
    sfi_point q = voxel_center(row->frame, x, row->y, row->k);
    double half = (double)row->mesh + (double)row->patches - 0.5; // solid where w is below
    for (; level >= 0 && !row->around[level]->dense; level--) {
        double error,
            value = sfi_winding_in(winding, row->skin->points, row->around[level], q, &error);
        if (fabs(value - half) > error) {
            return value < half;
        }
    }
    return row->mesh + row->patches > sfi_winding_round(winding, row->skin->points, q);
}

// Whole turns that u is beyond what a smooth box says about it, where the row comes to voxel x.
static double turns_at(const open_row *row, const sfi_winding_box *box, uint32_t x)
{
    double at[3], patches = (double)row->patches, error;
    if (box->plain) {
        return -patches;
    }
    see_voxel(row, box, x, -0.5, at);
    if (row->known && row->mistake + sfi_jet_error(&box->all, at) < 0.5) {
        return floor(row->before - sfi_jet_at(&box->all, at) + 0.5);
    }
    sfi_point q = voxel_center(row->frame, x, row->y, row->k);
    double value = sfi_winding_in(&row->skin->winding, row->skin->points, box, q, &error);
    see_voxel(row, box, x, 0.0, at);
    return floor(value - patches - sfi_jet_at(&box->all, at) + 0.5);
}

static void enter_box(open_row *row, int level, uint32_t x)
{
    row->around[level] = box_at(row, level, x, level > 0 ? row->around[level - 1] : NULL);
    if (row->around[level]->smooth) {
        row->turns[level] = turns_at(row, row->around[level], x);
    }
}

// Remember u at the end of what a smooth box has filled.
static void leave_at(open_row *row, int level, uint32_t x)
{
    double at[3];
    see_voxel(row, row->around[level], x, -0.5, at);
    row->known = 1;
    row->before = row->turns[level] + sfi_jet_at(&row->around[level]->all, at);
    row->mistake = sfi_jet_error(&row->around[level]->all, at);
}

// What a smooth box says about the voxels of an interval: u, how it changes, how wrong that is.
typedef struct outlook {
    double value, spread, error;
} outlook;

static outlook look_along(const open_row *row, int level, interval i)
{
    const sfi_winding_box *box = row->around[level];
    double first[3], last[3], middle[3], half = (double)(i.x1 - 1 - i.x0) / 2 * SFI_UNITS;
    see_voxel(row, box, i.x0, 0.0, first);
    see_voxel(row, box, i.x1 - 1, 0.0, last);
    see_voxel(row, box, i.x0, 0.0, middle);
    middle[0] += half;
    const double *bend = box->all.bend;
    double slope =
        box->all.slope[0] + bend[0] * middle[0] + bend[3] * middle[1] + bend[5] * middle[2];
    double before = sfi_jet_error(&box->all, first), after = sfi_jet_error(&box->all, last);
    outlook seen = {row->turns[level] + sfi_jet_at(&box->all, middle),
                    fabs(slope) * half + 0.5 * fabs(bend[0]) * half * half,
                    before > after ? before : after};
    return seen;
}

// Fill what a smooth box can tell of an interval in which M does not change, voxel by voxel.
// Returns the first that it cannot tell.
static uint32_t fill_voxels(const open_row *row, int level, interval i)
{
    const sfi_jet *jet = &row->around[level]->all;
    double at[3], half = (double)row->mesh - 0.5 - row->turns[level];
    see_voxel(row, row->around[level], i.x0, 0.0, at);
    for (; i.x0 < i.x1; i.x0++, at[0] += SFI_UNITS) {
        double off = sfi_jet_at(jet, at) - half;
        if (fabs(off) <= sfi_jet_error(jet, at)) {
            break;
        }
        if (off < 0.0) {
            set_run(row, i.x0, i.x0 + 1);
        }
    }
    return i.x0;
}

// Fill what a smooth box can tell of an interval, at once where u stays clear of M - 1/2. Returns
// the first voxel that it cannot tell.
static uint32_t fill_smooth(open_row *row, int level, interval i)
{
    outlook seen = look_along(row, level, i);
    uint32_t x = i.x0;
    while (x < i.x1) {
        uint32_t end = come_to(row, x);
        interval part = {x, end < i.x1 ? end : i.x1};
        double off = seen.value - ((double)row->mesh - 0.5);
        if (fabs(off) <= seen.spread + seen.error) {
            x = fill_voxels(row, level, part);
        } else {
            if (off < 0.0) {
                set_run(row, part.x0, part.x1);
            }
            x = part.x1;
        }
        if (x < part.x1) {
            break;
        }
    }
    if (x > i.x0) {
        leave_at(row, level, x);
    }
    return x;
}

// Through a row: by the largest box that can tell, down to the smallest, and then by the voxel.
static void fill_row(open_row *row)
{
    const uint32_t nx = row->frame->nx;
    int level = -1;
    for (uint32_t x = 0; x < nx;) {
        come_to(row, x);
        if (level < LAST && (level < 0 || !row->around[level]->smooth)) {
            enter_box(row, ++level, x);
            continue;
        }
        interval part = {x, (x / side_of(level) + 1) * side_of(level)};
        part.x1 = part.x1 < nx ? part.x1 : nx;
        uint32_t end = row->around[level]->smooth ? fill_smooth(row, level, part) : x;
        if (end == x && level < LAST - 1) {
            enter_box(row, ++level, x);
            continue;
        }
        if (end == x) {
            if (judge_voxel(row, level, x)) {
                set_run(row, x, x + 1);
            }
            row->known = 0;
            end++;
        }
        for (x = end; level >= 0 && x % side_of(level) == 0;) {
            level--; // out of the box
        }
    }
}

void sfi_row_fill_open(sfi_lane *lane, sfi_hole_lane *holes, size_t change_count,
                       const sfi_frame *frame, const sfi_skin *skin, uint32_t y, uint32_t k,
                       uint64_t *words)
{
    open_row row = {.lane = lane,
                    .holes = holes,
                    .change_count = change_count,
                    .frame = frame,
                    .skin = skin,
                    .y = y,
                    .k = k,
                    .words = words};
    sum_changes(lane->changes, change_count);
    memset(words, 0, sfi_row_words(frame->nx) * sizeof *words);
    sfi_point q = voxel_center(frame, 0, y, k);
    sfi_winding_place(&skin->winding, &q, row.place);
    fill_row(&row);
}
