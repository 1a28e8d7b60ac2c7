// SPDX-License-Identifier: MIT
// Which corners of which triangles meet at a vertex: one counting sort of the corners.
//
// Sums over the triangles around a vertex are gathered through this list and not scattered, so that
// vertices can be shared out among threads and every sum still has one order.

#include "balance/bend/incidence.h"

#include "base/memory.h"

#include <string.h>

// start[v] = where the corners of vertex v go.
static void count(sf_mesh_view mesh, sfi_incidence *made)
{
    memset(made->start, 0, (made->vertex_count + 1) * sizeof *made->start);
    for (size_t c = 0; c < made->corner_count; c++) {
        made->start[mesh.triangles[c] + 1]++;
    }
    for (size_t v = 0; v < made->vertex_count; v++) {
        made->start[v + 1] += made->start[v];
    }
}

// Puts every corner in its place; start[v] runs to the end of v on the way, and is put back after.
static void place(sf_mesh_view mesh, sfi_incidence *made)
{
    for (size_t c = 0; c < made->corner_count; c++) {
        made->corner[made->start[mesh.triangles[c]]++] = (uint32_t)c;
    }
    for (size_t v = made->vertex_count; v > 0; v--) {
        made->start[v] = made->start[v - 1];
    }
    made->start[0] = 0;
}

sf_status sfi_incidence_make(sf_mesh_view mesh, const sf_allocator *allocator,
                             sfi_incidence *incidence)
{
    if (mesh.triangle_count > UINT32_MAX / 3) {
        return SF_ERR_OVERFLOW;
    }
    sfi_incidence made = {NULL, NULL, mesh.vertex_count, 3 * mesh.triangle_count};
    made.start = sfi_alloc_array(allocator, made.vertex_count + 1, sizeof *made.start);
    made.corner = sfi_alloc_array(allocator, made.corner_count, sizeof *made.corner);
    if (made.start == NULL || made.corner == NULL) {
        sfi_incidence_free(allocator, &made);
        return SF_ERR_MEMORY;
    }
    count(mesh, &made);
    place(mesh, &made);
    *incidence = made;
    return SF_OK;
}

void sfi_incidence_free(const sf_allocator *allocator, sfi_incidence *incidence)
{
    sfi_free_array(allocator, incidence->start, incidence->vertex_count + 1,
                   sizeof *incidence->start);
    sfi_free_array(allocator, incidence->corner, incidence->corner_count,
                   sizeof *incidence->corner);
    memset(incidence, 0, sizeof *incidence);
}
