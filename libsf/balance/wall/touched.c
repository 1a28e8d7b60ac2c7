// SPDX-License-Identifier: MIT
// Voxels that a surface touches, on a lattice and as far beyond it as matters.
//
// A triangle is clipped to each layer that it reaches, what is left to each row of voxels in it,
// and what then is left covers an interval of x: all voxels of that interval are touched. Clipping
// keeps what lies on a border, so a triangle in the plane between two layers touches both. Most
// triangles of scanned shapes are smaller than a voxel and lie in one row to begin with: those are
// not clipped at all.
//
// What comes within 2^-24 of a voxel counts as touched; the clipping, which rounds, may still lose
// a voxel whose share is less than that. Who uses this allows for both.

#include "balance/wall/touched.h"

#include "balance/wall/levels.h"
#include "base/memory.h"
#include "base/status.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

#define CORNERS 8 // of a triangle that was clipped by four planes, and one to spare
#define LAYERS_MOST ((double)SF_LAYER_MAX)
#define STEPS_AT_ONCE 4096
#define HAIR 0x1p-24 // of a voxel: so near is touched, whatever rounding does

// ---------------------------------------------------------------------------------------------
// The lattice
// ---------------------------------------------------------------------------------------------

// Voxels that the lattice goes on for where the mesh lies beyond it by so much.
static double voxels_beyond(double beyond_mm, double reach_mm, double pitch_mm)
{
    double length = beyond_mm < reach_mm ? beyond_mm : reach_mm;
    return length + 0.5 * pitch_mm < 0 ? 0 : floor(length / pitch_mm) + 2;
}

static sf_status choose_lattice(const sf_lattice *l, sf_mesh_view mesh, double reach_mm,
                                sfi_touched *t, sf_lattice *made)
{
    double low[3], high[3], counts[3] = {l->nx, l->ny, l->nz};
    double first[3] = {l->pitch_x_mm, l->pitch_y_mm, sf_lattice_layer_height(l, 0)};
    double last[3] = {l->pitch_x_mm, l->pitch_y_mm, sf_lattice_layer_height(l, l->nz - 1)};
    double end[3] = {l->origin_mm[0] + l->nx * l->pitch_x_mm,
                     l->origin_mm[1] + l->ny * l->pitch_y_mm, sf_lattice_layer_bottom(l, l->nz)};
    *made = *l;
    SF_TRY(sf_mesh_bounds(mesh, low, high));
    for (int i = 0; i < 3; i++) {
        double before = voxels_beyond(l->origin_mm[i] - low[i], reach_mm, first[i]);
        before = i == 0 ? 64 * floor((before + 63) / 64) : before;
        counts[i] += before + voxels_beyond(high[i] - end[i], reach_mm, last[i]);
        if (counts[i] > (i < 2 ? SF_EXTENT_MAX : LAYERS_MOST)) {
            return SF_ERR_OVERFLOW;
        }
        t->before[i] = (uint32_t)before;
        made->origin_mm[i] -= before * first[i];
    }
    made->nx = (uint32_t)counts[0];
    made->ny = (uint32_t)counts[1];
    made->nz = t->layers = (uint32_t)counts[2];
    made->layer_mm = first[2];
    made->heights_mm = NULL; // its own levels say where its layers lie
    return SF_OK;
}

// Beyond the lattice layers go on as its first and its last.
static double height_of(const sfi_touched *t, const sf_lattice *l, uint32_t k)
{
    uint32_t inside = k < t->before[2] ? 0 : k - t->before[2];
    return sf_lattice_layer_height(l, inside < l->nz ? inside : l->nz - 1);
}

static void lay_levels(sfi_touched *t, const sf_lattice *l)
{
    t->levels[t->before[2]] = l->origin_mm[2];
    for (uint32_t k = t->before[2]; k < t->layers; k++) {
        double count = k - t->before[2] + 1.0;
        t->levels[k + 1] = l->heights_mm != NULL ? t->levels[k] + height_of(t, l, k)
                                                 : l->origin_mm[2] + count * l->layer_mm;
    }
    for (uint32_t k = t->before[2]; k > 0; k--) {
        t->levels[k - 1] = t->levels[k] - height_of(t, l, 0);
    }
}

// ---------------------------------------------------------------------------------------------
// Triangles
// ---------------------------------------------------------------------------------------------

// How coordinates become voxels: subtract the origin, and multiply. per_mm[2] is 0 where layers
// differ in height.
typedef struct steps {
    uint32_t nx, ny;
    double pitch_y_mm, origin_mm[3], per_mm[3];
} steps;

typedef struct polygon {
    int count;
    double at[CORNERS][3];
} polygon;

// A half-open range of voxels, rows or layers, and whether it is just one of them and nothing lies
// beyond it, so that nothing needs to be clipped.
typedef struct range {
    uint32_t first, end;
    int is_one;
} range;

static void extent(const polygon *p, int axis, double *low, double *high)
{
    *low = *high = p->at[0][axis];
    for (int i = 1; i < p->count; i++) {
        double v = p->at[i][axis];
        *low = v < *low ? v : *low;
        *high = v > *high ? v : *high;
    }
}

// What of a polygon has sign * (coordinate - border) >= 0.
static void clip(const polygon *from, int axis, double sign, double border, polygon *to)
{
    to->count = 0;
    for (int i = 0; i < from->count; i++) {
        const double *p = from->at[i], *q = from->at[(i + 1) % from->count];
        double dp = sign * (p[axis] - border), dq = sign * (q[axis] - border);
        if (dp >= 0) {
            memcpy(to->at[to->count++], p, sizeof to->at[0]);
        }
        if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) {
            double *on = to->at[to->count++], share = dp / (dp - dq);
            for (int j = 0; j < 3; j++) {
                on[j] = p[j] + share * (q[j] - p[j]);
            }
            on[axis] = border;
        }
    }
}

// What of a polygon lies between two borders, or within a hair of that: what lies in the plane
// between two rows is in both, however their borders are rounded.
static void clip_between(const polygon *from, int axis, double low, double high, polygon *to)
{
    polygon above;
    double hair = HAIR * (high - low);
    clip(from, axis, 1, low - hair, &above);
    clip(&above, axis, -1, high + hair, to);
}

// Voxels of equal size that an interval touches, its ends included.
static range voxels_in(double low, double high, double origin, double per_mm, uint32_t count)
{
    double first = (low - origin) * per_mm - HAIR, last = (high - origin) * per_mm + HAIR;
    range r = {0, 0, 0};
    if (last >= 0 && first < count) {
        r.first = first > 0 ? (uint32_t)first : 0;
        r.end = last < count ? (uint32_t)last + 1 : count;
        r.is_one = first >= 0 && last < count && r.first + 1 == r.end;
    }
    return r;
}

// The same for layers of any height.
static range layers_in(double low, double high, const double *levels, uint32_t count)
{
    double hair = HAIR * (levels[count] - levels[0]) / count;
    uint32_t a = 0, b = count;
    while (a < b) { // the first whose top is not below
        uint32_t middle = a + (b - a) / 2;
        *(levels[middle + 1] < low - hair ? &a : &b) =
            levels[middle + 1] < low - hair ? middle + 1 : middle;
    }
    range r = {a, a, 0};
    while (r.end < count && levels[r.end] <= high + hair) {
        r.end++;
    }
    r.is_one = r.first + 1 == r.end && low >= levels[0] && high <= levels[count];
    return r;
}

static void set_run(sf_slice slice, uint32_t y, range x)
{
    uint64_t *row = sfi_slice_row(slice, y);
    for (uint32_t at = x.first; at < x.end; at = at - at % 64 + 64) {
        uint64_t head = ~UINT64_C(0) << (at % 64);
        row[at / 64] |= at / 64 == (x.end - 1) / 64 ? head & sfi_tail_mask(x.end) : head;
    }
}

static range rows_of(const steps *s, const polygon *p)
{
    double low, high;
    extent(p, 1, &low, &high);
    return voxels_in(low, high, s->origin_mm[1], s->per_mm[1], s->ny);
}

static range columns_of(const steps *s, const polygon *p)
{
    double low, high;
    extent(p, 0, &low, &high);
    return voxels_in(low, high, s->origin_mm[0], s->per_mm[0], s->nx);
}

static void add_layer(const steps *s, const polygon *p, sf_slice slice)
{
    polygon part;
    range y = rows_of(s, p);
    if (y.is_one) {
        set_run(slice, y.first, columns_of(s, p));
        return;
    }
    for (uint32_t j = y.first; j < y.end; j++) {
        double bottom = s->origin_mm[1] + j * s->pitch_y_mm;
        clip_between(p, 1, bottom, bottom + s->pitch_y_mm, &part);
        if (part.count > 0) {
            set_run(slice, j, columns_of(s, &part));
        }
    }
}

static void add_triangle(const sfi_touched *t, const steps *s, const polygon *triangle)
{
    double low, high;
    polygon part;
    extent(triangle, 2, &low, &high);
    range z = s->per_mm[2] > 0 ? voxels_in(low, high, s->origin_mm[2], s->per_mm[2], t->layers)
                               : layers_in(low, high, t->levels, t->layers);
    if (z.is_one) {
        add_layer(s, triangle, sf_grid_slice(t->grid, z.first));
        return;
    }
    for (uint32_t k = z.first; k < z.end; k++) {
        clip_between(triangle, 2, t->levels[k], t->levels[k + 1], &part);
        if (part.count > 0) {
            add_layer(s, &part, sf_grid_slice(t->grid, k));
        }
    }
}

static sf_status add_all(const sfi_touched *t, const steps *s, sf_mesh_view mesh, sf_task *task)
{
    polygon p;
    p.count = 3;
    for (size_t i = 0; i < mesh.triangle_count; i++) {
        if (i % STEPS_AT_ONCE == 0 && sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        for (size_t j = 0; j < 3; j++) {
            memcpy(p.at[j], mesh.vertices + 3 * (size_t)mesh.triangles[3 * i + j], sizeof p.at[0]);
        }
        add_triangle(t, s, &p);
    }
    return SF_OK;
}

sf_status sfi_touched_create(sf_mesh_view mesh, const sf_lattice *lattice, double reach_mm,
                             const sf_allocator *allocator, sf_task *task, sfi_touched *touched)
{
    sf_lattice made;
    memset(touched, 0, sizeof *touched);
    SF_TRY(choose_lattice(lattice, mesh, reach_mm, touched, &made));
    touched->levels =
        sfi_alloc_array(allocator, (size_t)touched->layers + 1, sizeof *touched->levels);
    sf_status status = SF_ERR_MEMORY;
    if (touched->levels != NULL) {
        lay_levels(touched, lattice);
        status = sf_grid_create(&made, allocator, &touched->grid);
    }
    if (status == SF_OK) {
        steps s = {made.nx, made.ny, made.pitch_y_mm, {0, 0, 0}, {0, 0, 0}};
        memcpy(s.origin_mm, made.origin_mm, sizeof s.origin_mm);
        s.per_mm[0] = 1 / made.pitch_x_mm;
        s.per_mm[1] = 1 / made.pitch_y_mm;
        s.per_mm[2] = lattice->heights_mm == NULL ? 1 / made.layer_mm : 0;
        status = add_all(touched, &s, mesh, task);
    }
    if (status != SF_OK) {
        sfi_touched_destroy(touched, allocator);
    }
    return status;
}

void sfi_touched_destroy(sfi_touched *touched, const sf_allocator *allocator)
{
    sf_grid_destroy(touched->grid);
    sfi_free_array(allocator, touched->levels, (size_t)touched->layers + 1,
                   sizeof *touched->levels);
    memset(touched, 0, sizeof *touched);
}
