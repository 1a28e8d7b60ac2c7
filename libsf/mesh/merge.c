// SPDX-License-Identifier: MIT
// Which vertices are the same point.
//
// STL repeats each vertex for each facet, OBJ often for each normal; topology needs points. Points
// are the same when their coordinates, rounded to a grain of 2^-40 of the largest, are equal. That
// is four thousand times finer than neighbouring 32-bit floats of that size, so no wall is welded
// however thin; but the sine that a program left as 6e-17 is the zero that it was meant to be.
// Rounding, unlike a distance, has no order in which points are merged. An open-addressing table of
// vertex numbers, at most half full, with the bits of the coordinates mixed thoroughly, so that
// regular grids of points do not pile up.

#include "mesh/mesh.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <math.h>
#include <string.h>

#define NOBODY UINT32_MAX

// A point in whole grains: numbers of at most 2^41, which doubles hold exactly.
typedef struct grains {
    double at[3];
} grains;

static grains round_point(const double *p, double grain)
{
    grains g;
    for (int axis = 0; axis < 3; axis++) {
        g.at[axis] = floor(p[axis] / grain + 0.5) + 0.0; // -0 becomes 0
    }
    return g;
}

double sfi_mesh_grain(sf_mesh_view mesh)
{
    double largest = 0, power = 1;
    for (size_t i = 0; i < 3 * mesh.vertex_count; i++) {
        double size = fabs(mesh.vertices[i]);
        largest = size > largest ? size : largest;
    }
    while (power < largest && power < 0x1p1000) {
        power *= 2;
    }
    while (power > largest && power > 0x1p-900) {
        power /= 2;
    }
    return power * 0x1p-40;
}

// The finisher of splitmix64 over the three coordinates in turn.
static uint64_t hash_of(grains p)
{
    uint64_t h = 0;
    for (int axis = 0; axis < 3; axis++) {
        uint64_t bits;
        memcpy(&bits, &p.at[axis], sizeof bits);
        h += bits + UINT64_C(0x9e3779b97f4a7c15);
        h = (h ^ (h >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
        h = (h ^ (h >> 27)) * UINT64_C(0x94d049bb133111eb);
        h ^= h >> 31;
    }
    return h;
}

static int same_point(grains p, grains q)
{
    return p.at[0] == q.at[0] && p.at[1] == q.at[1] && p.at[2] == q.at[2];
}

sf_status sfi_mesh_positions(sf_mesh_view mesh, const sf_allocator *allocator, uint32_t *ids,
                             size_t *count)
{
    size_t slots = 16, need;
    if (!sfi_size_mul(mesh.vertex_count, 2, &need)) {
        return SF_ERR_OVERFLOW;
    }
    while (slots < need) {
        if (!sfi_size_mul(slots, 2, &slots)) {
            return SF_ERR_OVERFLOW;
        }
    }
    uint32_t *table =
        sfi_alloc_array(allocator, slots, sizeof *table); // first vertex at a position
    if (table == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(table, 0xff, slots * sizeof *table);
    double grain = sfi_mesh_grain(mesh);
    size_t distinct = 0;
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        grains p = round_point(mesh.vertices + 3 * v, grain);
        size_t slot = (size_t)hash_of(p) & (slots - 1);
        while (table[slot] != NOBODY &&
               !same_point(p, round_point(mesh.vertices + 3 * (size_t)table[slot], grain))) {
            slot = (slot + 1) & (slots - 1);
        }
        if (table[slot] == NOBODY) {
            table[slot] = (uint32_t)v;
            ids[v] = (uint32_t)distinct++;
        } else {
            ids[v] = ids[table[slot]];
        }
    }
    sfi_free_array(allocator, table, slots, sizeof *table);
    *count = distinct;
    return SF_OK;
}

// Fill a mesh of the right size with the distinct points and the renumbered triangles.
static void fill_merged(sf_mesh_view mesh, const uint32_t *ids, double *vertices,
                        uint32_t *triangles)
{
    uint32_t next = 0;
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        if (ids[v] == next) {
            memcpy(vertices + 3 * (size_t)next, mesh.vertices + 3 * v, 3 * sizeof *vertices);
            next++;
        }
    }
    for (size_t i = 0; i < 3 * mesh.triangle_count; i++) {
        triangles[i] = ids[mesh.triangles[i]];
    }
}

sf_status sf_mesh_merge(sf_mesh_view mesh, const sf_allocator *allocator, sf_mesh **merged)
{
    if (merged == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_mesh_validate(mesh, NULL));
    if (mesh.vertex_count == 0) {
        return sf_mesh_create(allocator, merged);
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    uint32_t *ids = sfi_alloc_array(&from, mesh.vertex_count, sizeof *ids), *triangles;
    double *vertices;
    size_t count;
    sf_status status = ids == NULL ? SF_ERR_MEMORY : sfi_mesh_positions(mesh, &from, ids, &count);
    if (status == SF_OK) {
        status = sfi_mesh_make(&from, count, mesh.triangle_count, merged, &vertices, &triangles);
    }
    if (status == SF_OK) {
        fill_merged(mesh, ids, vertices, triangles);
    }
    sfi_free_array(&from, ids, mesh.vertex_count, sizeof *ids);
    return status;
}
