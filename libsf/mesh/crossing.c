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
// larger triangles it is within a millionth of a unit, the same on every machine. Small triangles
// (256 voxels) multiply by an inverse instead of dividing, and divide only next to a whole voxel.
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
    double inverse;       // of det
    int narrow;           // no side is longer than SHORT: products stay exact in doubles
    uint32_t mark;        // low bits of the steps
} span;

#define SHORT 65536 // units

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
    s->inverse = 1.0 / s->det;
    s->dxb = (double)((int64_t)b->x - a->x);
    s->dxc = (double)((int64_t)c->x - a->x);
    s->narrow = s->dxb < SHORT && s->dxb > -SHORT && s->dxc < SHORT && s->dxc > -SHORT;
    set_edge(s, 0, a, b);
    set_edge(s, 1, b, c);
    set_edge(s, 2, c, a);
    for (int i = 0; i < 3; i++) {
        s->narrow &= s->dy[i] < SHORT && s->dy[i] > -SHORT && s->dz[i] < SHORT && s->dz[i] > -SHORT;
    }
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

// The edge functions along one row of centres, and where their rows go.
typedef struct walk {
    int64_t value[3], slope[3], bias[3];
    uint32_t j0, j1, row; // row: number of row j0 in the window
} walk;

static void walk_begin(walk *w, const span *s, int64_t z, uint32_t j0)
{
    int64_t ey = (int64_t)j0 * SFI_UNITS + SFI_UNITS / 2 - s->a.y, ez = z - s->a.z;
    for (int i = 0; i < 3; i++) {
        w->bias[i] = edge_bias(s->dy[i], s->dz[i]);
        w->value[i] = s->dy[i] * ez - s->dz[i] * ey + w->bias[i];
        w->slope[i] = -s->dz[i] * SFI_UNITS;
        ey -= s->dy[i];
        ez -= s->dz[i];
    }
}

static void cross_wide(sfi_crossings *out, const span *s, walk *w, uint32_t nx)
{
    for (; w->j0 < w->j1; w->j0++, w->row++) {
        if ((w->value[0] | w->value[1] | w->value[2]) >= 0) {
            uint32_t step = step_at(s, w->value[2] - w->bias[2], w->value[0] - w->bias[0], nx);
            out->items[out->count++] = (uint64_t)w->row << 32 | step;
            out->row_counts[w->row]++;
        }
        for (int i = 0; i < 3; i++) {
            w->value[i] += w->slope[i];
        }
    }
}

#define FINE_BITS 20
#define FINE_MASK (((int64_t)1 << FINE_BITS) - 1)
#define FAR_LEFT ((int64_t)1 << 22) // voxels; no crossing of the lattice's frame is further left

// Without branches that a processor cannot foresee: every row of the box is written, and counts if
// it is inside. The numerator is an integer below 2^52, and goes up by the same for each row. The
// product with the inverse, in 2^-20 of a voxel, is off by less than one; where that could matter,
// next to a whole voxel, the quotient is taken.
static void cross_narrow(sfi_crossings *out, const span *s, const walk *w, uint32_t nx)
{
    const int64_t fine = (int64_t)1 << FINE_BITS;
    double top =
        (double)(w->value[2] - w->bias[2]) * s->dxb + (double)(w->value[0] - w->bias[0]) * s->dxc;
    double rise = (double)w->slope[2] * s->dxb + (double)w->slope[0] * s->dxc;
    double inverse = s->inverse * (double)(fine / SFI_UNITS);
    double start = (double)((s->a.x - SFI_UNITS / 2) * (fine / SFI_UNITS) + FAR_LEFT * fine);
    // Copies, since stores to the lists might change what pointers lead to.
    int64_t v0 = w->value[0], v1 = w->value[1], v2 = w->value[2], last = nx;
    const int64_t s0 = w->slope[0], s1 = w->slope[1], s2 = w->slope[2];
    uint64_t *items = out->items + out->count, *const first = items;
    uint64_t key = (uint64_t)w->row << 32 | s->mark;
    uint32_t *counts = out->row_counts + w->row, *const end = counts + (w->j1 - w->j0);
    for (; counts < end; counts++) {
        int64_t x = (int64_t)(top * inverse + start);
        int64_t voxel = ((x + FINE_MASK) >> FINE_BITS) - FAR_LEFT;
        uint32_t inside = (v0 | v1 | v2) >= 0;
        if (((x + 1) & FINE_MASK) <= 2 && inside) {
            voxel = step_at(s, v2 - w->bias[2], v0 - w->bias[0], nx) >> SFI_STEP_SHIFT;
        }
        voxel = voxel < 0 ? 0 : voxel;
        voxel = voxel < last ? voxel : last;
        *items = key | (uint64_t)voxel << SFI_STEP_SHIFT;
        items += inside;
        *counts += inside;
        key += (uint64_t)1 << 32;
        top += rise;
        v0 += s0;
        v1 += s1;
        v2 += s2;
    }
    out->count += (size_t)(items - first);
}

// The rows j0..j1 of one layer, at w->value.
static void cross_layer(sfi_crossings *out, const span *s, walk w, uint32_t j0, uint32_t j1,
                        uint32_t row, uint32_t nx)
{
    w.j0 = j0;
    w.j1 = j1;
    w.row = row;
    if (j1 - j0 >= NARROW_FROM) {
        narrow(w.value, w.slope, &w.j0, &w.j1);
        for (int i = 0; i < 3; i++) {
            w.value[i] += (int64_t)(w.j0 - j0) * w.slope[i];
        }
        w.row += w.j0 - j0;
    }
    if (w.j0 < w.j1 && s->narrow) {
        cross_narrow(out, s, &w, nx);
    } else if (w.j0 < w.j1) {
        cross_wide(out, s, &w, nx);
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
        walk w;
        int32_t z = sfi_frame_center(frame, box.k0);
        walk_begin(&w, &s, z, box.y0);
        for (uint32_t k = box.k0; k < box.k1; k++) {
            int64_t up = sfi_frame_center(frame, k) - z;
            for (int i = 0; i < 3; i++) {
                w.value[i] += s.dy[i] * up;
            }
            z += (int32_t)up;
            cross_layer(crossings, &s, w, box.y0, box.y1,
                        (k - window.k0) * rows + box.y0 - window.y0, frame->nx);
        }
    }
    return count;
}
