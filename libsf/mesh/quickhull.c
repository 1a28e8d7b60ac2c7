// SPDX-License-Identifier: MIT
// Convex hulls of points in space, as triangles: quickhull with exact signs.
//
// Begin with a tetrahedron. Each face keeps a list of points that lie outside of it, each point in
// one list. As long as a list is not empty: take its furthest point, find the faces that it sees,
// which are joined by edges, take them away, span faces from the point to the rim that they leave,
// and share out their points among the new faces. A point that lies outside of none is inside the
// hull for good.
//
// That last step is right, though a point may still lie outside of some old face: let x be inside
// of a face V that is taken away and p be outside of V and of the new hull. The way from x to p
// leaves the old hull at once, so where it leaves the new hull it is not on an old face, but on a
// new one, and p lies outside of that.
//
// A face is seen only from strictly outside of its plane. With exact signs this makes the rim one
// closed line that passes no corner twice, and no flat triangle: a new point in line with an edge
// of the rim lies in the planes of both its faces and sees neither. So points in one plane, in one
// line and in one place need no care and no tolerance. A sign is first worked out in doubles, and
// in integers of 128 bits where its error may be larger than itself.
//
// Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull Algorithm for Convex Hulls",
// 1996; the error of the sign is that of J. R. Shewchuk, "Adaptive Precision Floating-Point
// Arithmetic and Fast Robust Geometric Predicates", 1997, rounded up.

#include "mesh/quickhull.h"

#include "base/exact.h"
#include "base/memory.h"
#include "base/status.h"
#include "mesh/vector.h"

#include <math.h>

// A list of numbers that grows.
typedef struct list {
    uint32_t *items;
    size_t count, capacity;
} list;

typedef struct work {
    const double *at;
    size_t count;
    sf_allocator allocator;
    sfi_faces hull;
    uint32_t *next;  // of a point in its list
    uint32_t *from;  // the new face whose rim edge begins at a point
    list pending;    // faces that may have points outside
    list seen, made; // by the point that is being added
    list spare;      // faces that are gone
} work;

static int push(work *w, list *to, uint32_t item)
{
    void *items = to->items;
    if (!sfi_grow_array(&w->allocator, &items, &to->capacity, to->count + 1, sizeof *to->items)) {
        return 0;
    }
    to->items = items;
    to->items[to->count++] = item;
    return 1;
}

// ---------------------------------------------------------------------------------------------
// Sides
// ---------------------------------------------------------------------------------------------

int sfi_side(const double *at, uint32_t a, uint32_t b, uint32_t c, uint32_t p)
{
    int64_t u[3], v[3], w[3];
    for (int d = 0; d < 3; d++) {
        double from = at[3 * (size_t)a + (size_t)d];
        u[d] = (int64_t)(at[3 * (size_t)b + (size_t)d] - from);
        v[d] = (int64_t)(at[3 * (size_t)c + (size_t)d] - from);
        w[d] = (int64_t)(at[3 * (size_t)p + (size_t)d] - from);
    }
    sfi_exact sum = {0, 0}; // differences below 2^41, products below 2^123
    for (int d = 0; d < 3; d++) {
        int e = (d + 1) % 3, f = (d + 2) % 3;
        sfi_exact minor = sfi_exact_subtract(sfi_exact_times(sfi_exact_of(u[e]), v[f]),
                                             sfi_exact_times(sfi_exact_of(u[f]), v[e]));
        sum = sfi_exact_add(sum, sfi_exact_times(minor, w[d]));
    }
    return sfi_exact_sign(sum);
}

// Which side of a face a point lies on, and a measure of how far from its plane. The normal's
// components are off by no more than 2.01 ulp of the sum of magnitudes of their two products, and
// the sum below adds three more roundings.
static int side_of(const work *w, const sfi_face *f, uint32_t p, double *reach)
{
    double from[3], size;
    sfi_subtract(w->at + 3 * (size_t)p, w->at + 3 * (size_t)f->corner[0], from);
    *reach = sfi_dot(f->normal, from);
    size = fabs(from[0]) + fabs(from[1]) + fabs(from[2]);
    if (fabs(*reach) > f->doubt * size) {
        return *reach > 0 ? 1 : -1;
    }
    return sfi_side(w->at, f->corner[0], f->corner[1], f->corner[2], p);
}

static void set_plane(const work *w, sfi_face *f)
{
    double u[3], v[3], most = 0;
    const double *a = w->at + 3 * (size_t)f->corner[0];
    sfi_subtract(w->at + 3 * (size_t)f->corner[1], a, u);
    sfi_subtract(w->at + 3 * (size_t)f->corner[2], a, v);
    sfi_cross(u, v, f->normal);
    for (int d = 0; d < 3; d++) {
        int e = (d + 1) % 3, g = (d + 2) % 3;
        double size = fabs(u[e] * v[g]) + fabs(u[g] * v[e]);
        most = size > most ? size : most;
    }
    f->doubt = 8 * 0x1p-53 * most;
}

// ---------------------------------------------------------------------------------------------
// Faces
// ---------------------------------------------------------------------------------------------

// A face with these corners, in a place of its own; UINT32_MAX when memory is short.
static uint32_t add_face(work *w, uint32_t a, uint32_t b, uint32_t c)
{
    sfi_face made = {.corner = {a, b, c}, .first = SFI_NO_POINT, .furthest = SFI_NO_POINT};
    uint32_t index;
    if (w->spare.count > 0) {
        index = w->spare.items[--w->spare.count];
    } else {
        void *faces = w->hull.faces;
        if (!sfi_grow_array(&w->allocator, &faces, &w->hull.capacity, w->hull.count + 1,
                            sizeof *w->hull.faces)) {
            return UINT32_MAX;
        }
        w->hull.faces = faces;
        index = (uint32_t)w->hull.count++;
    }
    set_plane(w, &made);
    w->hull.faces[index] = made;
    return index;
}

// Give a point to the first of these faces that it lies outside of, if any.
static void share_out(work *w, const uint32_t *faces, size_t count, uint32_t p)
{
    for (size_t i = 0; i < count; i++) {
        sfi_face *f = &w->hull.faces[faces[i]];
        double reach;
        if (side_of(w, f, p, &reach) > 0) {
            w->next[p] = f->first;
            f->first = p;
            if (f->furthest == SFI_NO_POINT || reach > f->reach) {
                f->furthest = p;
                f->reach = reach;
            }
            return;
        }
    }
}

static sf_status begin(work *w, const uint32_t simplex[4])
{
    // Faces of a tetrahedron whose fourth corner lies inside of the first face, and which face lies
    // across each edge.
    static const int corners[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    static const uint32_t beside[4][3] = {{1, 2, 3}, {3, 2, 0}, {1, 3, 0}, {2, 1, 0}};
    uint32_t s[4] = {simplex[0], simplex[1], simplex[2], simplex[3]};
    if (sfi_side(w->at, s[0], s[1], s[2], s[3]) > 0) {
        s[1] = simplex[2];
        s[2] = simplex[1];
    }
    uint32_t faces[4];
    for (int i = 0; i < 4; i++) {
        faces[i] = add_face(w, s[corners[i][0]], s[corners[i][1]], s[corners[i][2]]);
        if (faces[i] == UINT32_MAX || !push(w, &w->pending, faces[i])) {
            return SF_ERR_MEMORY;
        }
        for (int j = 0; j < 3; j++) {
            w->hull.faces[faces[i]].beside[j] = beside[i][j];
        }
    }
    for (uint32_t p = 0; p < w->count; p++) {
        share_out(w, faces, 4, p);
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// One point
// ---------------------------------------------------------------------------------------------

// All faces that a point sees, from one of them.
static sf_status look(work *w, uint32_t face, uint32_t p)
{
    w->seen.count = 0;
    w->hull.faces[face].is_seen = 1;
    if (!push(w, &w->seen, face)) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < w->seen.count; i++) {
        const uint32_t *beside = w->hull.faces[w->seen.items[i]].beside;
        for (int j = 0; j < 3; j++) {
            sfi_face *f = &w->hull.faces[beside[j]];
            double reach;
            if (!f->is_seen && side_of(w, f, p, &reach) > 0) {
                f->is_seen = 1;
                if (!push(w, &w->seen, beside[j])) {
                    return SF_ERR_MEMORY;
                }
            }
        }
    }
    return SF_OK;
}

// Let the face across an edge, which it runs from b to a, know of its new neighbour.
static void tell(work *w, uint32_t face, uint32_t a, uint32_t b, uint32_t made)
{
    sfi_face *f = &w->hull.faces[face];
    for (int i = 0; i < 3; i++) {
        if (f->corner[i] == b && f->corner[(i + 1) % 3] == a) {
            f->beside[i] = made;
        }
    }
}

// A face from each edge of the rim to the point.
static sf_status span(work *w, uint32_t p)
{
    w->made.count = 0;
    for (size_t i = 0; i < w->seen.count; i++) {
        for (int j = 0; j < 3; j++) {
            const sfi_face *f = &w->hull.faces[w->seen.items[i]];
            uint32_t a = f->corner[j], b = f->corner[(j + 1) % 3], across = f->beside[j];
            if (w->hull.faces[across].is_seen) {
                continue;
            }
            uint32_t made = add_face(w, a, b, p);
            if (made == UINT32_MAX || !push(w, &w->made, made) || !push(w, &w->pending, made)) {
                return SF_ERR_MEMORY;
            }
            w->hull.faces[made].beside[0] = across;
            tell(w, across, a, b, made);
            w->from[a] = made;
        }
    }
    for (size_t i = 0; i < w->made.count; i++) {
        uint32_t face = w->made.items[i], follower = w->from[w->hull.faces[face].corner[1]];
        w->hull.faces[face].beside[1] = follower;
        w->hull.faces[follower].beside[2] = face;
    }
    return SF_OK;
}

// Share out the points of the faces that are gone, and free their places.
static sf_status clear_away(work *w, uint32_t p)
{
    for (size_t i = 0; i < w->seen.count; i++) {
        sfi_face *f = &w->hull.faces[w->seen.items[i]];
        for (uint32_t q = f->first, next; q != SFI_NO_POINT; q = next) {
            next = w->next[q];
            if (q != p) {
                share_out(w, w->made.items, w->made.count, q);
            }
        }
        f->first = SFI_NO_POINT;
        f->is_gone = 1;
        if (!push(w, &w->spare, w->seen.items[i])) {
            return SF_ERR_MEMORY;
        }
    }
    return SF_OK;
}

static sf_status add_points(work *w)
{
    while (w->pending.count > 0) {
        uint32_t face = w->pending.items[--w->pending.count];
        const sfi_face *f = &w->hull.faces[face];
        if (f->is_gone || f->first == SFI_NO_POINT) {
            continue;
        }
        uint32_t p = f->furthest;
        SF_TRY(look(w, face, p));
        SF_TRY(span(w, p));
        SF_TRY(clear_away(w, p));
    }
    return SF_OK;
}

static void release(work *w)
{
    list *lists[] = {&w->pending, &w->seen, &w->made, &w->spare};
    for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
        sfi_free_array(&w->allocator, lists[i]->items, lists[i]->capacity, sizeof(uint32_t));
    }
    sfi_free_array(&w->allocator, w->next, w->count, sizeof *w->next);
    sfi_free_array(&w->allocator, w->from, w->count, sizeof *w->from);
}

sf_status sfi_quickhull(const double *at, size_t count, const uint32_t simplex[4],
                        const sf_allocator *allocator, sfi_faces *hull)
{
    work w = {.at = at, .count = count, .allocator = *allocator};
    w.next = sfi_alloc_array(allocator, count, sizeof *w.next);
    w.from = sfi_alloc_array(allocator, count, sizeof *w.from);
    sf_status status = w.next != NULL && w.from != NULL ? SF_OK : SF_ERR_MEMORY;
    if (status == SF_OK) {
        status = begin(&w, simplex);
    }
    if (status == SF_OK) {
        status = add_points(&w);
    }
    release(&w);
    if (status != SF_OK) {
        sfi_faces_destroy(&w.hull, allocator);
        return status;
    }
    *hull = w.hull;
    return SF_OK;
}

void sfi_faces_destroy(sfi_faces *hull, const sf_allocator *allocator)
{
    sfi_free_array(allocator, hull->faces, hull->capacity, sizeof *hull->faces);
}
