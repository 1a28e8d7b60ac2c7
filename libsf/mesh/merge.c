// SPDX-License-Identifier: MIT
// Which vertices are the same point.
//
// STL repeats each vertex for each facet, OBJ often for each normal; topology needs points. Points
// are the same when all three coordinates compare equal: exact, order-independent, no tolerance
// that could weld a thin wall. An open-addressing table of vertex numbers, at most half full, with
// the bits of the coordinates mixed thoroughly, so that regular grids of points do not pile up.

#include "mesh/mesh.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <string.h>

#define NOBODY UINT32_MAX

static uint64_t bits_of(double value)
{
    uint64_t bits;
    value += 0.0; // -0 becomes 0
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

// The finisher of splitmix64 over the three coordinates in turn.
static uint64_t hash_of(const double p[3])
{
    uint64_t h = 0;
    for (int axis = 0; axis < 3; axis++) {
        h += bits_of(p[axis]) + UINT64_C(0x9e3779b97f4a7c15);
        h = (h ^ (h >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
        h = (h ^ (h >> 27)) * UINT64_C(0x94d049bb133111eb);
        h ^= h >> 31;
    }
    return h;
}

static int same_point(const double *p, const double *q)
{
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
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
    size_t distinct = 0;
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        const double *p = mesh.vertices + 3 * v;
        size_t slot = (size_t)hash_of(p) & (slots - 1);
        while (table[slot] != NOBODY && !same_point(p, mesh.vertices + 3 * (size_t)table[slot])) {
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

// Fill an empty mesh with the distinct points and the renumbered triangles.
static sf_status fill_merged(sf_mesh_view mesh, const uint32_t *ids, sf_mesh *merged)
{
    uint32_t next = 0;
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        if (ids[v] == next) {
            SF_TRY(sf_mesh_add_vertices(merged, mesh.vertices + 3 * v, 1));
            next++;
        }
    }
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        const uint32_t *corner = mesh.triangles + 3 * t;
        uint32_t renumbered[3] = {ids[corner[0]], ids[corner[1]], ids[corner[2]]};
        SF_TRY(sf_mesh_add_triangles(merged, renumbered, 1));
    }
    return SF_OK;
}

sf_status sf_mesh_merge(sf_mesh_view mesh, const sf_allocator *allocator, sf_mesh **merged)
{
    if (merged == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_mesh_validate(mesh, NULL));
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_mesh *made;
    SF_TRY(sf_mesh_create(&from, &made));
    sf_status status = SF_OK;
    if (mesh.vertex_count > 0) {
        size_t count;
        uint32_t *ids = sfi_alloc_array(&from, mesh.vertex_count, sizeof *ids);
        status = ids == NULL ? SF_ERR_MEMORY : sfi_mesh_positions(mesh, &from, ids, &count);
        if (status == SF_OK) {
            status = fill_merged(mesh, ids, made);
        }
        sfi_free_array(&from, ids, mesh.vertex_count, sizeof *ids);
    }
    if (status != SF_OK) {
        sf_mesh_destroy(made);
        return status;
    }
    *merged = made;
    return SF_OK;
}
