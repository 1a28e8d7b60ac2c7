// SPDX-License-Identifier: MIT
// The holes of a mesh: its boundary, taken apart into simple loops.
//
// Edges that triangles run as often one way as the other cancel. What is left has as many edges
// into every point as out of it, because it is the boundary of something, so it can be walked in
// closed tours. A tour is cut wherever it meets itself, which leaves simple loops: mostly one for a
// hole, three edges for a loose triangle.
//
// The loops are put in the order of a space-filling curve (G. M. Morton, 1966), so that halving
// their list halves space: the winding number's tree is built that way. Which edge starts a loop
// and in which order they come never depends on anything but the mesh.

#include "mesh/loops.h"

#include "base/memory.h"
#include "base/size.h"

#include <string.h>

// What the walk needs; all arrays but `to` and `path` have one entry a point.
typedef struct tour {
    size_t point_count, edge_count;
    uint32_t *to;     // ends of the boundary edges, sorted by where they start
    uint32_t *ends;   // of each point's edges in `to`
    uint32_t *next;   // first of each point's edges that is not walked yet
    uint32_t *places; // where a point stands on the path, or SFI_NOBODY
    uint32_t *path;
} tour;

static void count_edges(const uint32_t *triangles, const uint32_t *order, size_t count, tour *t)
{
    for (size_t first = 0, end; first < count; first = end) {
        int64_t net;
        end = sfi_chain_group(triangles, order, count, first, &net);
        t->edge_count += (size_t)(net < 0 ? -net : net);
    }
}

// The start and the end of a group's edges, run against the boundary.
static void edge_ends(const uint32_t *triangles, uint32_t h, int64_t net, uint32_t *from,
                      uint32_t *to)
{
    uint32_t a = sfi_edge_from(triangles, h), b = sfi_edge_to(triangles, h);
    int rising = a < b;
    *from = rising == (net < 0) ? a : b;
    *to = rising == (net < 0) ? b : a;
}

static void sort_edges(const uint32_t *triangles, const uint32_t *order, size_t count, tour *t)
{
    memset(t->next, 0, t->point_count * sizeof *t->next);
    for (int pass = 0; pass < 2; pass++) {
        for (size_t first = 0, end; first < count; first = end) {
            int64_t net;
            end = sfi_chain_group(triangles, order, count, first, &net);
            uint32_t from, to;
            edge_ends(triangles, order[first], net, &from, &to);
            for (int64_t n = net < 0 ? -net : net; n > 0; n--) {
                if (pass == 0) {
                    t->next[from]++;
                } else {
                    t->to[t->ends[from]++] = to;
                }
            }
        }
        uint32_t start = 0;
        for (size_t p = 0; p < t->point_count && pass == 0; p++) {
            uint32_t degree = t->next[p];
            t->next[p] = t->ends[p] = start;
            start += degree;
        }
    }
}

static void emit(sfi_loops *loops, tour *t, uint32_t first, uint32_t end)
{
    for (uint32_t i = first; i < end; i++) {
        loops->points[loops->edge_count++] = t->path[i];
        if (i > first) {
            t->places[t->path[i]] = SFI_NOBODY;
        }
    }
    loops->starts[++loops->loop_count] = loops->edge_count;
}

static void walk_from(sfi_loops *loops, tour *t, uint32_t start)
{
    uint32_t length = 1;
    t->path[0] = start;
    t->places[start] = 0;
    while (t->next[t->path[length - 1]] < t->ends[t->path[length - 1]]) {
        uint32_t to = t->to[t->next[t->path[length - 1]]++];
        if (t->places[to] == SFI_NOBODY) {
            t->places[to] = length;
            t->path[length++] = to;
        } else {
            emit(loops, t, t->places[to], length);
            length = t->places[to] + 1;
        }
    }
    t->places[start] = SFI_NOBODY;
}

static void walk(sfi_loops *loops, tour *t)
{
    memset(t->places, 0xff, t->point_count * sizeof *t->places);
    loops->starts[0] = 0;
    for (size_t p = 0; p < t->point_count; p++) {
        if (t->next[p] < t->ends[p]) {
            walk_from(loops, t, (uint32_t)p);
        }
    }
}

// Every third bit, from 21 bits.
static uint64_t spread(uint32_t v)
{
    uint64_t out = 0;
    for (unsigned i = 0; i < 21; i++) {
        out |= (uint64_t)(v >> i & 1) << 3 * i;
    }
    return out;
}

static uint64_t morton(const sfi_point *p)
{
    uint32_t v[3] = {(uint32_t)(p->x + SFI_UNITS_MAX) >> 9, (uint32_t)(p->y + SFI_UNITS_MAX) >> 9,
                     (uint32_t)(p->z + SFI_UNITS_MAX) >> 9};
    return spread(v[0]) | spread(v[1]) << 1 | spread(v[2]) << 2;
}

typedef struct ranked {
    uint64_t key;
    size_t start, end;
} ranked;

static int ranks_below(const ranked *a, const ranked *b)
{
    return a->key != b->key ? a->key < b->key : a->start < b->start;
}

static void sift(ranked *items, size_t root, size_t count)
{
    for (size_t child; (child = 2 * root + 1) < count; root = child) {
        child += child + 1 < count && ranks_below(items + child, items + child + 1);
        if (!ranks_below(items + root, items + child)) {
            return;
        }
        ranked swap = items[root];
        items[root] = items[child];
        items[child] = swap;
    }
}

static void heap_sort(ranked *items, size_t count)
{
    for (size_t root = count / 2; root > 0; root--) {
        sift(items, root - 1, count);
    }
    for (size_t end = count; end > 1; end--) {
        ranked swap = items[0];
        items[0] = items[end - 1];
        items[end - 1] = swap;
        sift(items, 0, end - 1);
    }
}

// Put the loops in the curve's order, by way of a copy of their points.
static sf_status arrange(sfi_loops *loops, const sfi_point *points, const sf_allocator *allocator,
                         uint32_t *copy)
{
    ranked *items = sfi_alloc_array(allocator, loops->loop_count, sizeof *items);
    if (items == NULL) {
        return SF_ERR_MEMORY;
    }
    memcpy(copy, loops->points, loops->edge_count * sizeof *copy);
    for (size_t i = 0; i < loops->loop_count; i++) {
        size_t start = loops->starts[i];
        items[i] = (ranked){morton(points + copy[start]), start, loops->starts[i + 1]};
    }
    heap_sort(items, loops->loop_count);
    size_t at = 0;
    for (size_t i = 0; i < loops->loop_count; i++) {
        size_t length = items[i].end - items[i].start;
        memcpy(loops->points + at, copy + items[i].start, length * sizeof *copy);
        loops->starts[i] = at;
        at += length;
    }
    sfi_free_array(allocator, items, loops->loop_count, sizeof *items);
    return SF_OK;
}

static int tour_allocate(tour *t, const sf_allocator *allocator)
{
    t->to = sfi_alloc_array(allocator, t->edge_count, sizeof *t->to);
    t->path = sfi_alloc_array(allocator, t->edge_count, sizeof *t->path);
    t->ends = sfi_alloc_array(allocator, t->point_count, sizeof *t->ends);
    t->next = sfi_alloc_array(allocator, t->point_count, sizeof *t->next);
    t->places = sfi_alloc_array(allocator, t->point_count, sizeof *t->places);
    return t->to != NULL && t->path != NULL && t->ends != NULL && t->next != NULL &&
           t->places != NULL;
}

static void tour_free(tour *t, const sf_allocator *allocator)
{
    sfi_free_array(allocator, t->to, t->edge_count, sizeof *t->to);
    sfi_free_array(allocator, t->path, t->edge_count, sizeof *t->path);
    sfi_free_array(allocator, t->ends, t->point_count, sizeof *t->ends);
    sfi_free_array(allocator, t->next, t->point_count, sizeof *t->next);
    sfi_free_array(allocator, t->places, t->point_count, sizeof *t->places);
}

// The loops of a boundary whose edges are counted; `capacity` remembers what was taken.
static sf_status walk_and_arrange(const sfi_point *points, const uint32_t *triangles,
                                  const uint32_t *order, size_t count, tour *t,
                                  const sf_allocator *allocator, sfi_loops *loops)
{
    loops->start_capacity = t->edge_count / 3 + 1;
    loops->points = sfi_alloc_array(allocator, t->edge_count, sizeof *loops->points);
    loops->starts = sfi_alloc_array(allocator, loops->start_capacity, sizeof *loops->starts);
    sf_status status = SF_ERR_MEMORY;
    size_t edge_count = t->edge_count;
    if (loops->points != NULL && loops->starts != NULL && tour_allocate(t, allocator)) {
        sort_edges(triangles, order, count, t);
        walk(loops, t);
        status = arrange(loops, points, allocator, t->path);
    }
    loops->edge_count = edge_count;
    tour_free(t, allocator);
    if (status != SF_OK) {
        sfi_loops_destroy(loops, allocator);
    }
    return status;
}

sf_status sfi_loops_create(const sfi_point *points, size_t point_count, const uint32_t *triangles,
                           size_t triangle_count, const sf_allocator *allocator, sfi_loops *loops)
{
    memset(loops, 0, sizeof *loops);
    size_t count = 3 * triangle_count;
    tour t = {point_count, 0, NULL, NULL, NULL, NULL, NULL};
    uint32_t *order = sfi_alloc_array(allocator, count, sizeof *order);
    if (order == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = sfi_chain_sort(triangles, triangle_count, point_count, allocator, order);
    if (status == SF_OK) {
        count_edges(triangles, order, count, &t);
        if (t.edge_count > 0) {
            status = walk_and_arrange(points, triangles, order, count, &t, allocator, loops);
        }
    }
    sfi_free_array(allocator, order, count, sizeof *order);
    return status;
}

void sfi_loops_destroy(sfi_loops *loops, const sf_allocator *allocator)
{
    sfi_free_array(allocator, loops->points, loops->edge_count, sizeof *loops->points);
    sfi_free_array(allocator, loops->starts, loops->start_capacity, sizeof *loops->starts);
    memset(loops, 0, sizeof *loops);
}
