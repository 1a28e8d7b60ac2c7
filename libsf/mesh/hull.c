// SPDX-License-Identifier: MIT
// The convex hull of points in space, with its faces as polygons.
//
// Points are rounded to whole numbers of 41 bits; from there on all is exact, and the same
// everywhere. Points in one place, on a line or in a plane have hulls of fewer dimensions, found
// first: the least point, the one furthest from it, the one furthest from their line, the one
// furthest from that plane. Where the furthest is not off at all by its exact sign, every point is
// asked. A flat hull is that of the plane, seen from both sides.
//
// A solid one comes as triangles. Neighbours in one plane are one face; an edge of a triangle is
// one of its face where the triangle across belongs to another. A point on these edges is a corner
// of the hull where at least three faces meet: with two it lies in the middle of an edge.

#include "mesh/hull.h"

#include "base/exact.h"
#include "base/memory.h"
#include "base/polygon.h"
#include "base/status.h"
#include "mesh/flats.h"
#include "mesh/quickhull.h"
#include "mesh/vector.h"

#include <math.h>

// ---------------------------------------------------------------------------------------------
// Rounding
// ---------------------------------------------------------------------------------------------

static void round_points(const double *points, size_t count, double *at)
{
    double low[3] = {points[0], points[1], points[2]}, extent = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < 3 * count; i++) {
            double p = points[i];
            if (pass == 0) {
                low[i % 3] = p < low[i % 3] ? p : low[i % 3];
            } else {
                extent = p - low[i % 3] > extent ? p - low[i % 3] : extent;
            }
        }
    }
    double scale = sfi_exact_scale(extent, SFI_HULL_BITS);
    for (size_t i = 0; i < 3 * count; i++) {
        at[i] = floor((points[i] - low[i % 3]) * scale + 0.5);
    }
}

// ---------------------------------------------------------------------------------------------
// Dimensions
// ---------------------------------------------------------------------------------------------

static int is_same(const double *at, uint32_t a, uint32_t b)
{
    const double *p = at + 3 * (size_t)a, *q = at + 3 * (size_t)b;
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

static int is_before(const double *at, uint32_t a, uint32_t b)
{
    const double *p = at + 3 * (size_t)a, *q = at + 3 * (size_t)b;
    return p[0] != q[0] ? p[0] < q[0] : p[1] != q[1] ? p[1] < q[1] : p[2] < q[2];
}

// Whether c lies on the line through a and b: its shadows do, along all axes.
static int is_in_line(const double *at, uint32_t a, uint32_t b, uint32_t c)
{
    const double *p = at + 3 * (size_t)a, *q = at + 3 * (size_t)b, *r = at + 3 * (size_t)c;
    for (int d = 0; d < 3; d++) {
        int e = (d + 1) % 3;
        if (sfi_exact_turn((int64_t)(q[d] - p[d]), (int64_t)(q[e] - p[e]), (int64_t)(r[d] - p[d]),
                           (int64_t)(r[e] - p[e])) != 0) {
            return 0;
        }
    }
    return 1;
}

// How far a point is from the first `known` points' place, line or plane, by any measure.
static double measure(const double *at, const uint32_t s[4], int known, uint32_t p)
{
    const double *o = at + 3 * (size_t)s[0];
    double from[3], u[3], v[3], n[3];
    sfi_subtract(at + 3 * (size_t)p, o, from);
    if (known == 1) {
        return sfi_dot(from, from);
    }
    sfi_subtract(at + 3 * (size_t)s[1], o, u);
    if (known == 2) {
        sfi_cross(u, from, n);
        return sfi_dot(n, n);
    }
    sfi_subtract(at + 3 * (size_t)s[2], o, v);
    sfi_cross(u, v, n);
    return fabs(sfi_dot(n, from));
}

static int is_off(const double *at, const uint32_t s[4], int known, uint32_t p)
{
    return known == 1   ? !is_same(at, s[0], p)
           : known == 2 ? !is_in_line(at, s[0], s[1], p)
                        : sfi_side(at, s[0], s[1], s[2], p) != 0;
}

// Find points that span as much as there is; returns the dimension.
static int find_simplex(const double *at, size_t count, uint32_t s[4])
{
    s[0] = 0;
    for (uint32_t p = 1; p < count; p++) {
        s[0] = is_before(at, p, s[0]) ? p : s[0];
    }
    for (int known = 1; known < 4; known++) {
        double most = -1;
        for (uint32_t p = 0; p < count; p++) {
            double far = measure(at, s, known, p);
            if (far > most) {
                most = far;
                s[known] = p;
            }
        }
        uint32_t p = s[known];
        for (uint32_t i = 0; i < count && !is_off(at, s, known, p); i++) {
            p = i;
        }
        if (!is_off(at, s, known, p)) {
            return known - 1;
        }
        s[known] = p;
    }
    return 3;
}

// ---------------------------------------------------------------------------------------------
// Hulls of fewer dimensions
// ---------------------------------------------------------------------------------------------

// A point or a segment, from the least to the greatest.
static sf_status make_line(const double *at, size_t count, uint32_t least,
                           const sf_allocator *allocator, sfi_hull *h)
{
    uint32_t greatest = least;
    for (uint32_t p = 0; p < count; p++) {
        greatest = is_before(at, greatest, p) ? p : greatest;
    }
    SF_TRY(sfi_hull_allocate(h, (size_t)h->dimension + 1, 0, 0, allocator));
    h->corners[0] = least;
    if (h->dimension == 1) {
        h->corners[1] = greatest;
    }
    return SF_OK;
}

// The axis along which a plane's shadow is largest.
static int drop_axis(const double *at, const uint32_t s[4])
{
    double u[3], v[3], n[3];
    sfi_subtract(at + 3 * (size_t)s[1], at + 3 * (size_t)s[0], u);
    sfi_subtract(at + 3 * (size_t)s[2], at + 3 * (size_t)s[0], v);
    sfi_cross(u, v, n);
    int axis = 0;
    for (int d = 1; d < 3; d++) {
        axis = fabs(n[d]) > fabs(n[axis]) ? d : axis;
    }
    return axis;
}

static sf_status fill_flat(sfi_hull *h, const sfi_corner *corners, size_t count,
                           const sf_allocator *allocator)
{
    SF_TRY(sfi_hull_allocate(h, count, 2, 2 * count, allocator));
    h->starts[0] = 0;
    h->starts[1] = count;
    for (size_t i = 0; i < count; i++) {
        h->corners[i] = corners[i].name;
        h->loops[i] = (uint32_t)i;
        h->loops[count + i] = (uint32_t)(count - 1 - i);
        h->across[i] = 1;
        h->across[count + i] = 0;
    }
    return SF_OK;
}

static sf_status make_flat(const double *at, size_t count, const uint32_t s[4],
                           const sf_allocator *allocator, sfi_hull *h)
{
    int axis = drop_axis(at, s);
    size_t x = (size_t)(axis + 1) % 3, y = (size_t)(axis + 2) % 3;
    sfi_corner *corners = sfi_alloc_array(allocator, count, sizeof *corners);
    if (corners == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t p = 0; p < count; p++) {
        sfi_corner c = {(int64_t)at[3 * p + x], (int64_t)at[3 * p + y], (uint32_t)p};
        corners[p] = c;
    }
    sf_status status = fill_flat(h, corners, sfi_polygon_hull(corners, count), allocator);
    sfi_free_array(allocator, corners, count, sizeof *corners);
    return status;
}

// ---------------------------------------------------------------------------------------------
// All of it
// ---------------------------------------------------------------------------------------------

static sf_status make(const double *at, size_t count, const sf_allocator *allocator, sfi_hull *h)
{
    uint32_t simplex[4];
    h->dimension = find_simplex(at, count, simplex);
    if (h->dimension < 2) {
        return make_line(at, count, simplex[0], allocator, h);
    }
    if (h->dimension == 2) {
        return make_flat(at, count, simplex, allocator, h);
    }
    sfi_faces triangles = {NULL, 0, 0};
    SF_TRY(sfi_quickhull(at, count, simplex, allocator, &triangles));
    sf_status status = sfi_hull_merge(at, count, &triangles, allocator, h);
    sfi_faces_destroy(&triangles, allocator);
    return status;
}

sf_status sfi_hull_create(const double *points, size_t count, const sf_allocator *allocator,
                          sfi_hull *hull)
{
    sfi_hull made = {0, NULL, 0, 0, NULL, NULL, NULL};
    if (count > SFI_HULL_POINTS_MAX) {
        return SF_ERR_OVERFLOW;
    }
    double *at = sfi_alloc_array(allocator, count, 3 * sizeof *at);
    if (at == NULL) {
        return SF_ERR_MEMORY;
    }
    round_points(points, count, at);
    sf_status status = make(at, count, allocator, &made);
    sfi_free_array(allocator, at, count, 3 * sizeof *at);
    if (status != SF_OK) {
        sfi_hull_destroy(&made, allocator);
        return status;
    }
    *hull = made;
    return SF_OK;
}

void sfi_hull_destroy(sfi_hull *h, const sf_allocator *allocator)
{
    size_t edges = h->starts != NULL ? h->starts[h->face_count] : 0;
    sfi_free_array(allocator, h->loops, edges, sizeof *h->loops);
    sfi_free_array(allocator, h->across, edges, sizeof *h->across);
    sfi_free_array(allocator, h->corners, h->corner_count, sizeof *h->corners);
    sfi_free_array(allocator, h->starts, h->face_count + 1, sizeof *h->starts);
}

// ---------------------------------------------------------------------------------------------
// What is asked of it
// ---------------------------------------------------------------------------------------------

static const double *corner_of(const sfi_hull *h, const double *points, size_t corner)
{
    return points + 3 * (size_t)h->corners[corner];
}

static void scale_to_one(double v[3])
{
    double length = sqrt(sfi_dot(v, v));
    for (int d = 0; d < 3 && length > 0; d++) {
        v[d] /= length;
    }
}

void sfi_hull_normal(const sfi_hull *h, const double *points, size_t face, double normal[3])
{
    const uint32_t *loop = h->loops + h->starts[face];
    size_t count = h->starts[face + 1] - h->starts[face];
    const double *o = corner_of(h, points, loop[0]);
    double sum[3] = {0, 0, 0};
    for (size_t i = 1; i + 1 < count; i++) {
        double u[3], v[3], n[3];
        sfi_subtract(corner_of(h, points, loop[i]), o, u);
        sfi_subtract(corner_of(h, points, loop[i + 1]), o, v);
        sfi_cross(u, v, n);
        for (int d = 0; d < 3; d++) {
            sum[d] += n[d];
        }
    }
    scale_to_one(sum);
    for (int d = 0; d < 3; d++) {
        normal[d] = sum[d];
    }
}

// How far a place lies beyond the sides of the first face, in its plane.
static double beside_polygon(const sfi_hull *h, const double *points, const double place[3])
{
    double normal[3], most = 0;
    sfi_hull_normal(h, points, 0, normal);
    for (size_t i = 0; i < h->starts[1]; i++) {
        const double *a = corner_of(h, points, h->loops[i]);
        double along[3], out[3], from[3];
        sfi_subtract(corner_of(h, points, h->loops[(i + 1) % h->starts[1]]), a, along);
        sfi_cross(along, normal, out);
        scale_to_one(out);
        sfi_subtract(place, a, from);
        double far = sfi_dot(out, from);
        most = far > most ? far : most;
    }
    return most;
}

static double from_segment(const sfi_hull *h, const double *points, const double place[3])
{
    const double *a = corner_of(h, points, 0), *b = corner_of(h, points, h->corner_count - 1);
    double along[3], from[3];
    sfi_subtract(b, a, along);
    sfi_subtract(place, a, from);
    double length = sfi_dot(along, along), share = length > 0 ? sfi_dot(along, from) / length : 0;
    share = share < 0 ? 0 : share > 1 ? 1 : share;
    for (int d = 0; d < 3; d++) {
        from[d] -= share * along[d];
    }
    return sqrt(sfi_dot(from, from));
}

double sfi_hull_outside(const sfi_hull *h, const double *points, const double place[3])
{
    if (h->dimension < 2) {
        return from_segment(h, points, place);
    }
    double most = h->dimension == 2 ? beside_polygon(h, points, place) : 0;
    for (size_t f = 0; f < h->face_count; f++) {
        double normal[3], from[3];
        sfi_hull_normal(h, points, f, normal);
        sfi_subtract(place, corner_of(h, points, h->loops[h->starts[f]]), from);
        double far = sfi_dot(normal, from);
        most = far > most ? far : most;
    }
    return most;
}
