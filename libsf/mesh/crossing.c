// SPDX-License-Identifier: MIT
// Scanline crossings: exact, each edge counted once.
//
// A row is the line along x through a layer's voxel centres. Seen along x, a triangle is a triangle
// in (y, z), and the row is a point there. The point is inside when three edge functions are not
// negative, where 0 counts on edges that run down (dz < 0), or level to the right (dz = 0, dy > 0).
// This is the same as moving every row by (e, e^2) in (y, z) for a tiny e: no row then meets an
// edge or corner, so the triangles around any closed fan count it as often forwards as backwards.
// Hence a closed mesh moves the winding number by 0 in total along every row, always
// (the fill rule makes the projected mesh a chain without boundary).
//
// The crossing lies at x = x_a + (w_b (x_b - x_a) + w_c (x_c - x_a)) / det, with the edge functions
// as weights. A voxel is inside when its centre is at or beyond the crossing, so the first voxel
// inside is ceil((x - 128) / 256) in units, and ceil(ceil(q) / n) = ceil(q / n) lets us round the
// quotient to a whole unit first. Where a triangle spans at most 2^17 units (512 voxels) along each
// axis, numerator and denominator are integers below 2^53, the quotient differs from any integer by
// at least 2^-35 unless it is one, and its double error is below 2^-36: the answer is exact. For
// larger triangles it is within a millionth of a unit, the same on every machine.
//
// Crossings left of the lattice are counted at voxel 0, those right of it at voxel nx, so that a
// mesh that leaves the lattice is no leak.
//
// Source: J. Pineda, "A parallel algorithm for polygon rasterization", 1988 (edge functions); the
// top-left rule of graphics hardware; design notes on robust voxelisation, 7.1.

#include "mesh/crossing.h"

// One triangle, turned so that its projection runs counter-clockwise.
typedef struct span {
    sfi_point a;
    int64_t dy[3], dz[3]; // edges ab, bc, ca
    double dxb, dxc, det; // x of b and c against a; twice the projected area
    uint32_t mark;        // low bits of the steps
} span;

// Whether an edge owns the rows exactly on it: 0, else the -1 that excludes them.
static int64_t edge_bias(int64_t dy, int64_t dz)
{
    return dz < 0 || (dz == 0 && dy > 0) ? 0 : -1;
}

static void set_edge(span *s, int i, const sfi_point *from, const sfi_point *to)
{
    s->dy[i] = (int64_t)to->y - from->y;
    s->dz[i] = (int64_t)to->z - from->z;
}

// Returns 0 where the triangle projects to a line.
static int span_begin(span *s, const sfi_point *a, const sfi_point *b, const sfi_point *c,
                      uint32_t mark)
{
    int64_t det = ((int64_t)b->y - a->y) * ((int64_t)c->z - a->z) -
                  ((int64_t)b->z - a->z) * ((int64_t)c->y - a->y);
    if (det == 0) {
        return 0;
    }
    if (det > 0) { // the outward normal looks along +x, so the row leaves
        mark ^= SFI_STEP_LEAVES;
    } else {
        const sfi_point *swap = b;
        b = c;
        c = swap;
        det = -det;
    }
    s->a = *a;
    s->mark = mark;
    s->det = (double)det;
    s->dxb = (double)((int64_t)b->x - a->x);
    s->dxc = (double)((int64_t)c->x - a->x);
    set_edge(s, 0, a, b);
    set_edge(s, 1, b, c);
    set_edge(s, 2, c, a);
    return 1;
}

static uint32_t step_at(const span *s, int64_t wb, int64_t wc, uint32_t nx)
{
    double q = ((double)wb * s->dxb + (double)wc * s->dxc) / s->det;
    int64_t whole = (int64_t)q;
    whole += (double)whole < q;
    int64_t x = s->a.x + whole - SFI_UNITS / 2;
    if (x <= 0) {
        return s->mark;
    }
    uint64_t voxel = ((uint64_t)x + (SFI_UNITS - 1)) >> SFI_UNIT_BITS;
    return (uint32_t)(voxel < nx ? voxel : nx) << SFI_STEP_SHIFT | s->mark;
}

// Shrink [*j0, *j1) to where value + (j - *j0) * slope >= 0.
static void clip_range(int64_t value, int64_t slope, uint32_t *j0, uint32_t *j1)
{
    if (slope > 0 && value < 0) {
        int64_t skip = (-value + slope - 1) / slope;
        *j0 = skip < *j1 - *j0 ? *j0 + (uint32_t)skip : *j1;
    } else if (slope < 0) {
        int64_t length = value < 0 ? 0 : value / -slope + 1;
        *j1 = length < *j1 - *j0 ? *j0 + (uint32_t)length : *j1;
    } else if (value < 0) {
        *j1 = *j0;
    }
}

// Where ranges are long, find the rows inside at once instead of row by row.
static void narrow(const int64_t value[3], const int64_t slope[3], uint32_t *j0, uint32_t *j1)
{
    uint32_t from = *j0;
    for (int i = 0; i < 3 && *j0 < *j1; i++) {
        clip_range(value[i] + (int64_t)(*j0 - from) * slope[i], slope[i], j0, j1);
    }
}

#define NARROW_FROM 24u

static void cross_layer(sfi_crossings *out, const span *s, int64_t z, uint32_t j0, uint32_t j1,
                        uint32_t first_row, uint32_t nx)
{
    int64_t y = (int64_t)j0 * SFI_UNITS + SFI_UNITS / 2 - s->a.y, value[3], slope[3], bias[3];
    int64_t ey = y, ez = z - s->a.z;
    for (int i = 0; i < 3; i++) {
        bias[i] = edge_bias(s->dy[i], s->dz[i]);
        value[i] = s->dy[i] * ez - s->dz[i] * ey + bias[i];
        slope[i] = -s->dz[i] * SFI_UNITS;
        ey -= s->dy[i];
        ez -= s->dz[i];
    }
    if (j1 - j0 >= NARROW_FROM) {
        uint32_t from = j0;
        narrow(value, slope, &j0, &j1);
        for (int i = 0; i < 3; i++) {
            value[i] += (int64_t)(j0 - from) * slope[i];
        }
        first_row += j0 - from;
    }
    for (; j0 < j1; j0++, first_row++) {
        if ((value[0] | value[1] | value[2]) >= 0) {
            uint32_t step = step_at(s, value[2] - bias[2], value[0] - bias[0], nx);
            out->items[out->count++] = (uint64_t)first_row << 32 | step;
            out->row_counts[first_row]++;
        }
        value[0] += slope[0];
        value[1] += slope[1];
        value[2] += slope[2];
    }
}

static int32_t least(int32_t a, int32_t b, int32_t c)
{
    int32_t low = a < b ? a : b;
    return low < c ? low : c;
}

static int32_t most(int32_t a, int32_t b, int32_t c)
{
    int32_t high = a > b ? a : b;
    return high > c ? high : c;
}

// The rows and layers of the window whose centres lie in the triangle's box. Returns their number.
static uint64_t touched(const sfi_frame *frame, const sfi_point *a, const sfi_point *b,
                        const sfi_point *c, sfi_window *window)
{
    uint32_t k0, k1, j0, j1;
    sfi_frame_layers(frame, least(a->z, b->z, c->z), most(a->z, b->z, c->z), &k0, &k1);
    k0 = k0 > window->k0 ? k0 : window->k0;
    k1 = k1 < window->k1 ? k1 : window->k1;
    if (k0 >= k1) {
        return 0;
    }
    sfi_frame_range(least(a->y, b->y, c->y), most(a->y, b->y, c->y), frame->ny, &j0, &j1);
    j0 = j0 > window->y0 ? j0 : window->y0;
    j1 = j1 < window->y1 ? j1 : window->y1;
    if (j0 >= j1) {
        return 0;
    }
    *window = (sfi_window){k0, k1, j0, j1};
    return (uint64_t)(k1 - k0) * (j1 - j0);
}

size_t sfi_crossings_add(sfi_crossings *crossings, const sfi_frame *frame, const sfi_skin *skin,
                         const uint32_t *list, size_t count, sfi_window window)
{
    uint32_t rows = window.y1 - window.y0;
    for (size_t n = 0; n < count; n++) {
        const uint32_t *corner = skin->triangles + 3 * (size_t)list[n];
        const sfi_point *a = skin->points + corner[0], *b = skin->points + corner[1],
                        *c = skin->points + corner[2];
        sfi_window box = window;
        uint64_t need = touched(frame, a, b, c, &box);
        span s;
        if (need == 0 || !span_begin(&s, a, b, c, sfi_skin_mark(skin, list[n]))) {
            continue;
        }
        if (need > crossings->capacity - crossings->count) {
            return n;
        }
        for (uint32_t k = box.k0; k < box.k1; k++) {
            cross_layer(crossings, &s, sfi_frame_center(frame, k), box.y0, box.y1,
                        (k - window.k0) * rows + box.y0 - window.y0, frame->nx);
        }
    }
    return count;
}
