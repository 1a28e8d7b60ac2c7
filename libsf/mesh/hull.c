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

static sf_status allocate(sfi_hull *h, size_t corners, size_t faces, size_t edges,
                          const sf_allocator *allocator)
{
    h->corners = sfi_alloc_array(allocator, corners, sizeof *h->corners);
    h->corner_count = h->corners != NULL ? corners : 0;
    h->starts = sfi_alloc_array(allocator, faces + 1, sizeof *h->starts);
    if (h->corners == NULL || h->starts == NULL) {
        sfi_free_array(allocator, h->starts, faces + 1, sizeof *h->starts);
        h->starts = NULL;
        return SF_ERR_MEMORY;
    }
    h->face_count = faces;
    h->starts[faces] = edges;
    if (edges > 0) {
        h->loops = sfi_alloc_array(allocator, edges, sizeof *h->loops);
        h->across = sfi_alloc_array(allocator, edges, sizeof *h->across);
    }
    return edges == 0 || (h->loops != NULL && h->across != NULL) ? SF_OK : SF_ERR_MEMORY;
}

// A point or a segment, from the least to the greatest.
static sf_status make_line(const double *at, size_t count, uint32_t least,
                           const sf_allocator *allocator, sfi_hull *h)
{
    uint32_t greatest = least;
    for (uint32_t p = 0; p < count; p++) {
        greatest = is_before(at, greatest, p) ? p : greatest;
    }
    SF_TRY(allocate(h, (size_t)h->dimension + 1, 0, 0, allocator));
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
    SF_TRY(allocate(h, count, 2, 2 * count, allocator));
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
// Faces out of triangles
// ---------------------------------------------------------------------------------------------

typedef struct merger {
    const double *at;
    size_t point_count;
    const sfi_faces *from;
    uint32_t *face_of; // of each triangle
    uint32_t *stack;   // of triangles; then the successor of a point around a face
    uint32_t *meeting; // faces that meet in a point; then its place among the corners
    size_t face_count, edge_count, corner_count;
} merger;

// Triangles of one plane get one number.
static void number_faces(merger *m)
{
    const sfi_face *t = m->from->faces;
    for (size_t i = 0; i < m->from->count; i++) {
        m->face_of[i] = UINT32_MAX;
    }
    for (size_t i = 0; i < m->from->count; i++) {
        size_t depth = 0;
        if (t[i].is_gone || m->face_of[i] != UINT32_MAX) {
            continue;
        }
        m->stack[depth++] = (uint32_t)i;
        m->face_of[i] = (uint32_t)m->face_count;
        while (depth > 0) {
            const sfi_face *f = &t[m->stack[--depth]];
            for (int j = 0; j < 3; j++) {
                const sfi_face *g = &t[f->beside[j]];
                uint32_t a = f->corner[j], b = f->corner[(j + 1) % 3];
                uint32_t far = g->corner[0] != a && g->corner[0] != b   ? g->corner[0]
                               : g->corner[1] != a && g->corner[1] != b ? g->corner[1]
                                                                        : g->corner[2];
                if (m->face_of[f->beside[j]] == UINT32_MAX &&
                    sfi_side(m->at, f->corner[0], f->corner[1], f->corner[2], far) == 0) {
                    m->face_of[f->beside[j]] = (uint32_t)m->face_count;
                    m->stack[depth++] = f->beside[j];
                }
            }
        }
        m->face_count++;
    }
}

static int is_rim(const merger *m, size_t triangle, int j)
{
    const sfi_face *f = &m->from->faces[triangle];
    return !f->is_gone && m->face_of[f->beside[j]] != m->face_of[triangle];
}

// Count faces around points, corners, and edges between corners.
static void count_corners(merger *m)
{
    for (size_t p = 0; p < m->point_count; p++) {
        m->meeting[p] = 0;
    }
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < m->from->count; i++) {
            for (int j = 0; j < 3; j++) {
                uint32_t p = m->from->faces[i].corner[j];
                if (is_rim(m, i, j)) {
                    m->meeting[p] += pass == 0;
                    m->edge_count += pass == 1 && m->meeting[p] >= 3;
                }
            }
        }
    }
    for (size_t p = 0; p < m->point_count; p++) {
        m->corner_count += m->meeting[p] >= 3;
    }
}

// Number the corners by their points, and let each face have as many places as it has corners.
static void lay_out(merger *m, sfi_hull *h)
{
    uint32_t corners = 0;
    for (size_t f = 0; f < h->face_count; f++) {
        h->starts[f] = 0;
    }
    for (size_t i = 0; i < m->from->count; i++) {
        for (int j = 0; j < 3; j++) {
            if (is_rim(m, i, j) && m->meeting[m->from->faces[i].corner[j]] >= 3) {
                h->starts[m->face_of[i]]++;
            }
        }
    }
    size_t sum = 0;
    for (size_t f = 0; f < h->face_count; f++) {
        size_t here = h->starts[f];
        h->starts[f] = sum;
        sum += here;
    }
    for (size_t p = 0; p < m->point_count; p++) {
        int is_corner = m->meeting[p] >= 3;
        if (is_corner) {
            h->corners[corners] = (uint32_t)p;
        }
        m->meeting[p] = is_corner ? corners++ : UINT32_MAX;
    }
}

// The place of a point among a triangle's corners.
static int place_of(const sfi_face *f, uint32_t point)
{
    return f->corner[0] == point ? 0 : f->corner[1] == point ? 1 : 2;
}

// The edge of the rim after an edge of the rim: the face's triangles around its end, one by one.
static void advance(const merger *m, size_t *triangle, int *j)
{
    const sfi_face *t = m->from->faces;
    uint32_t point = t[*triangle].corner[(*j + 1) % 3];
    *j = (*j + 1) % 3;
    while (!is_rim(m, *triangle, *j)) {
        *triangle = t[*triangle].beside[*j];
        *j = place_of(&t[*triangle], point);
    }
}

// Walk around the face of a triangle from an edge of its rim that begins in a corner.
static void walk(const merger *m, size_t triangle, int j, sfi_hull *h)
{
    const sfi_face *t = m->from->faces;
    size_t from = triangle, place = h->starts[m->face_of[triangle]];
    int from_j = j;
    do {
        uint32_t corner = m->meeting[t[triangle].corner[j]];
        if (corner != UINT32_MAX) {
            h->loops[place] = corner;
            h->across[place++] = m->face_of[t[triangle].beside[j]];
        }
        advance(m, &triangle, &j);
    } while (triangle != from || j != from_j);
}

static void fill_loops(merger *m, sfi_hull *h)
{
    for (size_t f = 0; f < m->face_count; f++) {
        m->stack[f] = 0; // not done
    }
    for (size_t i = 0; i < m->from->count; i++) {
        for (int j = 0; j < 3; j++) {
            if (is_rim(m, i, j) && m->meeting[m->from->faces[i].corner[j]] != UINT32_MAX &&
                m->stack[m->face_of[i]] == 0) {
                m->stack[m->face_of[i]] = 1;
                walk(m, i, j, h);
            }
        }
    }
}

static sf_status merge(const double *at, size_t count, const sfi_faces *triangles,
                       const sf_allocator *allocator, sfi_hull *h)
{
    merger m = {.at = at, .point_count = count, .from = triangles};
    m.face_of = sfi_alloc_array(allocator, triangles->count, sizeof *m.face_of);
    m.stack = sfi_alloc_array(allocator, triangles->count, sizeof *m.stack);
    m.meeting = sfi_alloc_array(allocator, count, sizeof *m.meeting);
    sf_status status = SF_ERR_MEMORY;
    if (m.face_of != NULL && m.stack != NULL && m.meeting != NULL) {
        number_faces(&m);
        count_corners(&m);
        status = allocate(h, m.corner_count, m.face_count, m.edge_count, allocator);
    }
    if (status == SF_OK) {
        lay_out(&m, h);
        fill_loops(&m, h);
    }
    sfi_free_array(allocator, m.face_of, triangles->count, sizeof *m.face_of);
    sfi_free_array(allocator, m.stack, triangles->count, sizeof *m.stack);
    sfi_free_array(allocator, m.meeting, count, sizeof *m.meeting);
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
    sf_status status = merge(at, count, &triangles, allocator, h);
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
