// SPDX-License-Identifier: MIT
// Hanging nodes, found by where points are.
//
// Where a cell has been split and its neighbour has not, points of the small cells lie in the
// middle of edges of the large one, and the two sides of the face between them are boundary. Such a
// mesh is no cage, because that boundary meets itself; but whoever has one wants to hear why. MFEM
// says in its files that it has hanging nodes, the other formats do not. So when a cage has been
// refused for a boundary that meets itself, the middles of all edges are looked up among the points
// that cells have: those are sorted by the cells of a fine lattice, a millionth of the cage's size,
// and a middle is looked for in the two lattice cells that are nearest along each axis, because it
// may have been rounded over a border.

#include "io/cage_hanging.h"

#include "base/memory.h"
#include "mesh/heap.h"

#include <math.h>
#include <string.h>

#define LATTICE 1e6

typedef struct finder {
    const sf_cage_view *view;
    double low[3], step;
    size_t count;
    uint32_t *items; // points that cells have, sorted
    uint32_t *keys;  // 3 of each point: the cell of the lattice that it lies in
} finder;

static const double *position(const finder *f, uint32_t point)
{
    return f->view->positions + 3 * (size_t)point;
}

// By lattice cell, then by number.
static int compare(const uint32_t *a, const uint32_t *b)
{
    for (int i = 0; i < 3; i++) {
        if (a[i] != b[i]) {
            return a[i] < b[i] ? -1 : 1;
        }
    }
    return 0;
}

static int before(const void *user, uint32_t a, uint32_t b)
{
    const finder *f = user;
    int order = compare(f->keys + 3 * (size_t)a, f->keys + 3 * (size_t)b);
    return order != 0 ? order < 0 : a < b;
}

static void measure(finder *f)
{
    double high[3];
    memcpy(f->low, f->view->positions, sizeof f->low);
    memcpy(high, f->view->positions, sizeof high);
    for (size_t i = 0; i < 3 * f->view->point_count; i++) {
        double x = f->view->positions[i];
        f->low[i % 3] = x < f->low[i % 3] ? x : f->low[i % 3];
        high[i % 3] = x > high[i % 3] ? x : high[i % 3];
    }
    f->step = 0;
    for (int i = 0; i < 3; i++) {
        double size = (high[i] - f->low[i]) / LATTICE;
        f->step = size > f->step ? size : f->step;
    }
}

// Sort the points that cells have; `marks` has a byte for each point.
static void sort_points(finder *f, uint8_t *marks)
{
    const sf_cage_view *v = f->view;
    memset(marks, 0, v->point_count);
    for (uint32_t i = 0; i < v->starts[v->cell_count]; i++) {
        marks[v->corners[i]] = 1;
    }
    for (uint32_t i = 0; i < v->point_count; i++) {
        for (size_t axis = 0; axis < 3; axis++) {
            double place = (position(f, i)[axis] - f->low[axis]) / f->step;
            f->keys[3 * (size_t)i + axis] = (uint32_t)place;
        }
        if (marks[i]) {
            f->items[f->count++] = i;
        }
    }
    sfi_heap_sort(f->items, f->count, before, f);
}

// A point of one lattice cell that lies within half a step of `middle`, but for the two ends.
static int find_in(const finder *f, const uint32_t key[3], const double middle[3],
                   const uint32_t ends[2], uint32_t *point)
{
    size_t low = 0, high = f->count;
    while (low < high) {
        size_t half = low + (high - low) / 2;
        if (compare(f->keys + 3 * (size_t)f->items[half], key) < 0) {
            low = half + 1;
        } else {
            high = half;
        }
    }
    for (; low < f->count && compare(f->keys + 3 * (size_t)f->items[low], key) == 0; low++) {
        const double *p = position(f, f->items[low]);
        if (fabs(p[0] - middle[0]) <= f->step / 2 && fabs(p[1] - middle[1]) <= f->step / 2 &&
            fabs(p[2] - middle[2]) <= f->step / 2 && f->items[low] != ends[0] &&
            f->items[low] != ends[1]) {
            *point = f->items[low];
            return 1;
        }
    }
    return 0;
}

static int find_middle(const finder *f, uint32_t a, uint32_t b, sfi_hanging *found)
{
    double middle[3], length = 0;
    uint32_t keys[2][3];
    for (size_t i = 0; i < 3; i++) {
        double from = position(f, a)[i], to = position(f, b)[i];
        middle[i] = 0.5 * from + 0.5 * to;
        length += fabs(to - from);
        double place = (middle[i] - f->low[i]) / f->step;
        keys[0][i] = place > 0.5 ? (uint32_t)(place - 0.5) : 0;
        keys[1][i] = (uint32_t)(place + 0.5);
    }
    found->ends[0] = a;
    found->ends[1] = b;
    for (unsigned i = 0; i < 8 && length > 8 * f->step; i++) {
        uint32_t key[3] = {keys[i & 1][0], keys[i >> 1 & 1][1], keys[i >> 2][2]};
        if (find_in(f, key, middle, found->ends, &found->point)) {
            return 1;
        }
    }
    return 0;
}

// Around a polygon of `count` corners.
static int find_around(const finder *f, const uint32_t *corners, uint32_t count, sfi_hanging *found)
{
    for (uint32_t i = 0; i < count; i++) {
        if (find_middle(f, corners[i], corners[i + 1 < count ? i + 1 : 0], found)) {
            return 1;
        }
    }
    return 0;
}

static int find_in_cell(const finder *f, const uint32_t *corners, uint32_t count,
                        sfi_hanging *found)
{
    if (f->view->dimension == 2) {
        return find_around(f, corners, count, found);
    }
    uint32_t n = count == 4 ? 3 : count / 2;
    if (find_around(f, corners, n, found) || find_around(f, corners + n, count - n, found)) {
        return 1;
    }
    for (uint32_t i = 0; i < n; i++) {
        if (find_middle(f, corners[i], corners[count == 4 ? 3 : n + i], found)) {
            return 1;
        }
    }
    return 0;
}

int sfi_hanging_find(const sf_cage_view *view, const sf_allocator *allocator, sfi_hanging *found)
{
    finder f = {view, {0, 0, 0}, 0, 0, NULL, NULL};
    size_t points = view->point_count;
    uint8_t *marks = sfi_alloc_array(allocator, points, 1);
    int is_found = 0;
    measure(&f);
    f.items = sfi_alloc_array(allocator, points, sizeof *f.items);
    f.keys = sfi_alloc_array(allocator, 3 * points, sizeof *f.keys);
    if (marks != NULL && f.items != NULL && f.keys != NULL && f.step > 0) {
        sort_points(&f, marks);
        for (size_t i = 0; i < view->cell_count && !is_found; i++) {
            is_found = find_in_cell(&f, view->corners + view->starts[i],
                                    view->starts[i + 1] - view->starts[i], found);
        }
    }
    sfi_free_array(allocator, f.keys, 3 * points, sizeof *f.keys);
    sfi_free_array(allocator, f.items, points, sizeof *f.items);
    sfi_free_array(allocator, marks, points, 1);
    return is_found;
}
