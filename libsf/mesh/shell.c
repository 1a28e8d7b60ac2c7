// SPDX-License-Identifier: MIT
// Every voxel that a surface touches.
//
// Voxels are closed boxes here: a face that lies between two layers of voxels touches both. Whether
// a snapped triangle touches a box is decided in integers, by the thirteen axes that can separate
// the two: the box's three, the triangle's normal, and the nine that are across an edge of each.
//
// That test is too slow to be made for every voxel of a large triangle's box, and it need not be.
// What a triangle has in common with a row of voxels is convex, so the voxels of the row are one
// run. Its ends are estimated by clipping the triangle to the row, in doubles and with a margin,
// and only voxels at the ends are tested.
//
// Bounds. Edges are below 2^30 units, so are distances between a corner and a voxel of the lattice:
// projections on edge-edge axes stay below 2^62. The normal has 61 bits, and its projections are
// summed in two halves.
//
// Source: T. Akenine-Moeller, "Fast 3D triangle-box overlap testing", 2001 (the axes); M. Schwarz,
// H.-P. Seidel, "Fast parallel surface and solid voxelization on GPUs", 2010 (conservative rule).

#include "mesh/shell.h"

#include "mesh/row.h"

typedef struct box {
    int64_t low[3], high[3];
} box;

typedef struct corners {
    int64_t at[3][3], edge[3][3], normal[3];
    int64_t low[3], high[3];
} corners;

static void read_corners(const sfi_skin *skin, size_t triangle, corners *t)
{
    for (int i = 0; i < 3; i++) {
        const sfi_point *p = skin->points + skin->triangles[3 * triangle + (size_t)i];
        t->at[i][0] = p->x;
        t->at[i][1] = p->y;
        t->at[i][2] = p->z;
    }
    for (int c = 0; c < 3; c++) {
        int64_t low = t->at[0][c], high = low;
        for (int i = 0; i < 3; i++) {
            t->edge[i][c] = t->at[(i + 1) % 3][c] - t->at[i][c];
            low = t->at[i][c] < low ? t->at[i][c] : low;
            high = t->at[i][c] > high ? t->at[i][c] : high;
        }
        t->low[c] = low;
        t->high[c] = high;
    }
    for (int c = 0; c < 3; c++) {
        int u = (c + 1) % 3, v = (c + 2) % 3;
        t->normal[c] = t->edge[0][u] * t->edge[1][v] - t->edge[0][v] * t->edge[1][u];
    }
}

static int64_t floor_divide(int64_t a, int64_t b)
{
    return a / b - (a % b < 0);
}

// Sign of n . p, where n has up to 62 bits and p up to 31.
static int dot_sign(const int64_t n[3], const int64_t p[3])
{
    const int64_t half = (int64_t)1 << 31;
    int64_t high = 0, low = 0;
    for (int c = 0; c < 3; c++) {
        int64_t top = floor_divide(n[c], half);
        high += top * p[c];
        low += (n[c] - top * half) * p[c];
    }
    int64_t carry = floor_divide(low, half);
    high += carry;
    low -= carry * half;
    return high != 0 ? (high > 0) - (high < 0) : low > 0;
}

static int plane_meets(const corners *t, const box *b)
{
    int64_t back[3], front[3]; // corners of the box furthest against and along the normal
    for (int c = 0; c < 3; c++) {
        int up = t->normal[c] > 0;
        back[c] = (up ? b->low[c] : b->high[c]) - t->at[0][c];
        front[c] = (up ? b->high[c] : b->low[c]) - t->at[0][c];
    }
    return dot_sign(t->normal, back) <= 0 && dot_sign(t->normal, front) >= 0;
}

// Whether edge e, looked at along axis c, leaves box and triangle on different sides. The third
// corner and the edge span the triangle's projection on the axis across both.
static int edge_parts(const corners *t, const box *b, int e, int c)
{
    int u = (c + 1) % 3, v = (c + 2) % 3, far = (e + 2) % 3;
    int64_t nu = -t->edge[e][v], nv = t->edge[e][u];
    int64_t third = nu * (t->at[far][u] - t->at[e][u]) + nv * (t->at[far][v] - t->at[e][v]);
    int64_t low = third < 0 ? third : 0, high = third > 0 ? third : 0;
    int64_t u0 = b->low[u] - t->at[e][u], u1 = b->high[u] - t->at[e][u];
    int64_t v0 = b->low[v] - t->at[e][v], v1 = b->high[v] - t->at[e][v];
    int64_t least = nu * (nu > 0 ? u0 : u1) + nv * (nv > 0 ? v0 : v1);
    int64_t most = nu * (nu > 0 ? u1 : u0) + nv * (nv > 0 ? v1 : v0);
    return least > high || most < low;
}

static int touches(const corners *t, const box *b)
{
    for (int c = 0; c < 3; c++) {
        if (t->low[c] > b->high[c] || t->high[c] < b->low[c]) {
            return 0;
        }
    }
    for (int e = 0; e < 3; e++) {
        for (int c = 0; c < 3; c++) {
            if (edge_parts(t, b, e, c)) {
                return 0;
            }
        }
    }
    return plane_meets(t, b);
}

typedef struct polygon {
    double at[8][3]; // three corners, and at most one more for each of four clips
    int count;
} polygon;

// Keep what lies where side * (value[c] - limit) <= 0.
static void clip(polygon *p, int c, double limit, double side)
{
    polygon out;
    out.count = 0;
    for (int i = 0; i < p->count; i++) {
        const double *a = p->at[i], *b = p->at[(i + 1) % p->count];
        double da = side * (a[c] - limit), db = side * (b[c] - limit);
        if (da <= 0.0) {
            for (int n = 0; n < 3; n++) {
                out.at[out.count][n] = a[n];
            }
            out.count++;
        }
        if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0)) {
            double t = da / (da - db);
            for (int n = 0; n < 3; n++) {
                out.at[out.count][n] = a[n] + t * (b[n] - a[n]);
            }
            out.count++;
        }
    }
    *p = out;
}

#define MARGIN 1.0 // units; the clips err by less than a thousandth

static void set_row(const corners *t, polygon p, box b, uint32_t nx, uint64_t *words)
{
    clip(&p, 1, (double)b.low[1] - MARGIN, -1.0);
    clip(&p, 1, (double)b.high[1] + MARGIN, 1.0);
    if (p.count == 0) {
        return;
    }
    double low = p.at[0][0], high = low;
    for (int i = 1; i < p.count; i++) {
        low = p.at[i][0] < low ? p.at[i][0] : low;
        high = p.at[i][0] > high ? p.at[i][0] : high;
    }
    int64_t x0 = floor_divide((int64_t)low - 3, SFI_UNITS);
    int64_t x1 = floor_divide((int64_t)high + 3, SFI_UNITS);
    x0 = x0 < 0 ? 0 : x0;
    x1 = x1 < nx ? x1 : (int64_t)nx - 1;
    for (; x0 <= x1; x0++) {
        b.low[0] = x0 * SFI_UNITS;
        b.high[0] = b.low[0] + SFI_UNITS;
        if (touches(t, &b)) {
            break;
        }
    }
    for (; x0 <= x1; x1--) {
        b.low[0] = x1 * SFI_UNITS;
        b.high[0] = b.low[0] + SFI_UNITS;
        if (touches(t, &b)) {
            sfi_row_set(words, (uint32_t)x0, (uint32_t)x1 + 1);
            return;
        }
    }
}

static void set_layer(const corners *t, const sfi_frame *frame, uint32_t k, sf_slice slice)
{
    box b = {{0, 0, 0}, {0, 0, 0}};
    polygon p;
    b.low[2] = frame->bottoms != NULL ? frame->bottoms[k] : (int64_t)k * SFI_UNITS;
    b.high[2] = frame->bottoms != NULL ? frame->bottoms[k + 1] : b.low[2] + SFI_UNITS;
    p.count = 3;
    for (int i = 0; i < 9; i++) {
        p.at[i / 3][i % 3] = (double)t->at[i / 3][i % 3];
    }
    clip(&p, 2, (double)b.low[2] - MARGIN, -1.0);
    clip(&p, 2, (double)b.high[2] + MARGIN, 1.0);
    if (p.count == 0 || t->low[2] > b.high[2] || t->high[2] < b.low[2]) {
        return;
    }
    double low = p.at[0][1], high = low;
    for (int i = 1; i < p.count; i++) {
        low = p.at[i][1] < low ? p.at[i][1] : low;
        high = p.at[i][1] > high ? p.at[i][1] : high;
    }
    int64_t y0 = floor_divide((int64_t)low - 3, SFI_UNITS);
    int64_t y1 = floor_divide((int64_t)high + 3, SFI_UNITS);
    y0 = y0 < 0 ? 0 : y0;
    y1 = y1 < frame->ny ? y1 : (int64_t)frame->ny - 1;
    for (int64_t y = y0; y <= y1; y++) {
        b.low[1] = y * SFI_UNITS;
        b.high[1] = b.low[1] + SFI_UNITS;
        set_row(t, p, b, frame->nx, slice.words + (size_t)y * slice.stride);
    }
}

// Number of boundaries between layers, the first bottom and the top included, below z, or at or
// below it.
static uint32_t bottoms_below(const sfi_frame *frame, int64_t z, int at)
{
    uint32_t low = 0, high = frame->nz + 1;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (frame->bottoms[middle] < z || (at && frame->bottoms[middle] == z)) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

void sfi_shell_reach(const sfi_frame *frame, const sfi_skin *skin, size_t triangle, uint32_t *k0,
                     uint32_t *k1)
{
    const uint32_t *corner = skin->triangles + 3 * triangle;
    int64_t low = INT32_MAX, high = INT32_MIN, first, end;
    for (int i = 0; i < 3; i++) {
        int64_t z = skin->points[corner[i]].z;
        low = z < low ? z : low;
        high = z > high ? z : high;
    }
    if (frame->bottoms != NULL) {
        first = (int64_t)bottoms_below(frame, low, 0) - 1;
        end = bottoms_below(frame, high, 1);
    } else {
        first = floor_divide(low - 1, SFI_UNITS);
        end = floor_divide(high, SFI_UNITS) + 1;
    }
    *k0 = (uint32_t)(first < 0 ? 0 : first < frame->nz ? first : frame->nz);
    *k1 = (uint32_t)(end < 0 ? 0 : end < frame->nz ? end : frame->nz);
}

void sfi_shell_add(const sfi_frame *frame, const sfi_skin *skin, const uint32_t *list, size_t count,
                   uint32_t k, sf_slice slice)
{
    for (size_t n = 0; n < count; n++) {
        uint32_t k0, k1;
        sfi_shell_reach(frame, skin, list[n], &k0, &k1);
        if (k >= k0 && k < k1) {
            corners t;
            read_corners(skin, list[n], &t);
            set_layer(&t, frame, k, slice);
        }
    }
}
