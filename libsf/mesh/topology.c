// SPDX-License-Identifier: MIT
// How the triangles of a mesh hang together.
//
// Vertices of equal position are one point. Each triangle with three distinct points contributes
// three directed edges; triangles with fewer are counted as degenerate and left out. Sorting the
// edges by their pair of points brings the triangles at one edge together: one is a boundary, more
// than two a non-manifold edge, two that run it the same way a misoriented one. Shells are joined
// over edges by union-find with path halving. Everything is exact, and linear but for union-find:
// points are numbers, so two counting passes sort the edges, and stability leaves those of one pair
// in the order of their triangles. (The C library's qsort would take memory behind the caller's
// back, and time that depends on whose library it is.)

#include "mesh/mesh.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <string.h>

// An edge as sorting sees it: the lower point, the upper point, and which way which triangle runs
// it.
typedef struct edge {
    uint32_t low, high;
    uint32_t triangle; // index, below 2^31
    uint32_t upward;   // 1 when the triangle runs from low to high
} edge;

// The work of one analysis: everything that has to be freed.
typedef struct work {
    sf_allocator allocator;
    sf_mesh_view mesh;
    uint32_t *ids;    // point of each vertex
    uint32_t *parent; // of each triangle, for union-find
    edge *edges, *sorted;
    size_t *places; // one a point: where its edges go, then whether it is used
    size_t edge_count;
    double *volume; // of the shell with this root
    uint8_t *flags; // of the shell with this root
} work;

enum { SHELL_OPEN = 1, SHELL_MISORIENTED = 2 };

static uint32_t root_of(uint32_t *parent, uint32_t t)
{
    while (parent[t] != t) {
        parent[t] = parent[parent[t]];
        t = parent[t];
    }
    return t;
}

static void join(uint32_t *parent, uint32_t a, uint32_t b)
{
    a = root_of(parent, a);
    b = root_of(parent, b);
    if (a < b) {
        parent[b] = a;
    } else {
        parent[a] = b;
    }
}

static int is_degenerate(const work *w, size_t t)
{
    const uint32_t *corner = w->mesh.triangles + 3 * t;
    uint32_t a = w->ids[corner[0]], b = w->ids[corner[1]], c = w->ids[corner[2]];
    return a == b || b == c || c == a;
}

static void collect_edges(work *w, sf_topology *found)
{
    for (size_t t = 0; t < w->mesh.triangle_count; t++) {
        w->parent[t] = (uint32_t)t;
        if (is_degenerate(w, t)) {
            found->degenerate_triangles++;
            continue;
        }
        for (int i = 0; i < 3; i++) {
            uint32_t from = w->ids[w->mesh.triangles[3 * t + (size_t)i]];
            uint32_t to = w->ids[w->mesh.triangles[3 * t + (size_t)(i + 1) % 3]];
            edge e = {from < to ? from : to, from < to ? to : from, (uint32_t)t, from < to};
            w->edges[w->edge_count++] = e;
        }
    }
}

// sorted = edges by their higher or their lower point, those of one point in the order they had.
static void sort_by(work *w, size_t points, int by_high)
{
    memset(w->places, 0, points * sizeof *w->places);
    for (size_t i = 0; i < w->edge_count; i++) {
        w->places[by_high ? w->edges[i].high : w->edges[i].low]++;
    }
    size_t sum = 0;
    for (size_t p = 0; p < points; p++) {
        size_t count = w->places[p];
        w->places[p] = sum;
        sum += count;
    }
    for (size_t i = 0; i < w->edge_count; i++) {
        w->sorted[w->places[by_high ? w->edges[i].high : w->edges[i].low]++] = w->edges[i];
    }
    edge *swap = w->edges;
    w->edges = w->sorted;
    w->sorted = swap;
}

// The triangles at one edge are edges[first..end).
static void judge_edge(work *w, size_t first, size_t end, sf_topology *found)
{
    size_t upward = 0;
    for (size_t i = first; i < end; i++) {
        upward += w->edges[i].upward;
        join(w->parent, w->edges[first].triangle, w->edges[i].triangle);
    }
    size_t count = end - first;
    found->boundary_edges += count == 1;
    found->nonmanifold_edges += count > 2;
    found->misoriented_edges += count == 2 && upward != 1;
    found->closed = found->closed && count % 2 == 0;
    found->oriented = found->oriented && (count == 1 || 2 * upward == count);
}

// Mark the shells that are open or misoriented; runs after all joins.
static void judge_shells_at(work *w, size_t first, size_t end)
{
    size_t upward = 0;
    for (size_t i = first; i < end; i++) {
        upward += w->edges[i].upward;
    }
    uint8_t *flags = &w->flags[root_of(w->parent, w->edges[first].triangle)];
    *flags = (uint8_t)(*flags | ((end - first) % 2 != 0 ? SHELL_OPEN : 0) |
                       (2 * upward != end - first ? SHELL_MISORIENTED : 0));
}

static size_t edge_end(const work *w, size_t first)
{
    size_t end = first + 1;
    while (end < w->edge_count && w->edges[end].low == w->edges[first].low &&
           w->edges[end].high == w->edges[first].high) {
        end++;
    }
    return end;
}

// Six times the signed volume of the tetrahedron with the mesh's first vertex.
static double volume_of(const work *w, size_t t)
{
    const double *o = w->mesh.vertices;
    double p[3][3];
    for (int i = 0; i < 3; i++) {
        const double *v = w->mesh.vertices + 3 * (size_t)w->mesh.triangles[3 * t + (size_t)i];
        for (int axis = 0; axis < 3; axis++) {
            p[i][axis] = v[axis] - o[axis];
        }
    }
    return p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
           p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
           p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
}

static void count_shells(work *w, sf_topology *found)
{
    for (size_t t = 0; t < w->mesh.triangle_count; t++) {
        if (!is_degenerate(w, t)) {
            w->volume[root_of(w->parent, (uint32_t)t)] += volume_of(w, t);
        }
    }
    double volume = 0.0;
    for (size_t t = 0; t < w->mesh.triangle_count; t++) {
        if (w->parent[t] == t && !is_degenerate(w, t)) {
            found->shells++;
            found->flipped_shells += w->flags[t] == 0 && w->volume[t] < 0.0;
            volume += w->volume[t];
        }
    }
    found->flipped = found->closed && found->oriented && volume < 0.0;
}

static void count_vertices(work *w, size_t points, sf_topology *found)
{
    memset(w->places, 0, points * sizeof *w->places);
    for (size_t i = 0; i < 3 * w->mesh.triangle_count; i++) {
        size_t *is_used = &w->places[w->ids[w->mesh.triangles[i]]];
        found->vertex_count += *is_used == 0;
        *is_used = 1;
    }
}

static int take_memory(work *w)
{
    size_t triangles = w->mesh.triangle_count, vertices = w->mesh.vertex_count, edges;
    if (!sfi_size_mul(triangles, 3, &edges)) {
        return 0;
    }
    w->ids = sfi_alloc_array(&w->allocator, vertices, sizeof *w->ids);
    w->parent = sfi_alloc_array(&w->allocator, triangles, sizeof *w->parent);
    w->edges = sfi_alloc_array(&w->allocator, edges, sizeof *w->edges);
    w->sorted = sfi_alloc_array(&w->allocator, edges, sizeof *w->sorted);
    w->places = sfi_alloc_array(&w->allocator, vertices, sizeof *w->places);
    w->volume = sfi_alloc_array(&w->allocator, triangles, sizeof *w->volume);
    w->flags = sfi_alloc_array(&w->allocator, triangles, 1);
    return w->ids != NULL && w->parent != NULL && w->edges != NULL && w->sorted != NULL &&
           w->places != NULL && w->volume != NULL && w->flags != NULL;
}

static void free_memory(work *w)
{
    size_t triangles = w->mesh.triangle_count, vertices = w->mesh.vertex_count;
    sfi_free_array(&w->allocator, w->ids, vertices, sizeof *w->ids);
    sfi_free_array(&w->allocator, w->parent, triangles, sizeof *w->parent);
    sfi_free_array(&w->allocator, w->edges, 3 * triangles, sizeof *w->edges);
    sfi_free_array(&w->allocator, w->sorted, 3 * triangles, sizeof *w->sorted);
    sfi_free_array(&w->allocator, w->places, vertices, sizeof *w->places);
    sfi_free_array(&w->allocator, w->volume, triangles, sizeof *w->volume);
    sfi_free_array(&w->allocator, w->flags, triangles, 1);
}

static sf_status analyze(work *w, sf_topology *found)
{
    size_t points;
    SF_TRY(sfi_mesh_positions(w->mesh, &w->allocator, w->ids, &points));
    memset(w->volume, 0, w->mesh.triangle_count * sizeof *w->volume);
    memset(w->flags, 0, w->mesh.triangle_count);
    collect_edges(w, found);
    sort_by(w, points, 1);
    sort_by(w, points, 0);
    for (size_t first = 0, end; first < w->edge_count; first = end) {
        end = edge_end(w, first);
        judge_edge(w, first, end, found);
    }
    for (size_t first = 0, end; first < w->edge_count; first = end) {
        end = edge_end(w, first);
        judge_shells_at(w, first, end);
    }
    count_shells(w, found);
    count_vertices(w, points, found);
    return SF_OK;
}

sf_status sf_mesh_analyze(sf_mesh_view mesh, const sf_allocator *allocator, sf_topology *topology)
{
    if (topology == NULL || mesh.triangle_count == 0) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_mesh_validate(mesh, NULL));
    if (mesh.triangle_count > INT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    work w = {.allocator = sfi_allocator_or_default(allocator), .mesh = mesh};
    sf_topology found = {.closed = 1, .oriented = 1};
    sf_status status = take_memory(&w) ? analyze(&w, &found) : SF_ERR_MEMORY;
    free_memory(&w);
    if (status == SF_OK) {
        *topology = found;
    }
    return status;
}
