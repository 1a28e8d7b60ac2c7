// SPDX-License-Identifier: MIT
// Which corners of which triangles meet at a vertex.

#ifndef SF_BALANCE_INCIDENCE_H
#define SF_BALANCE_INCIDENCE_H

#include <sf/mesh.h>

// The corners at vertex v are corner[start[v]] to corner[start[v + 1] - 1], in ascending order.
// Corner i of triangle t is number 3 t + i.
typedef struct sfi_incidence {
    size_t *start;    // vertex_count + 1
    uint32_t *corner; // 3 * triangle_count
    size_t vertex_count, corner_count;
} sfi_incidence;

// For a mesh that is valid, with at least one vertex and one triangle, and at most UINT32_MAX / 3
// triangles, else SF_ERR_OVERFLOW.
sf_status sfi_incidence_make(sf_mesh_view mesh, const sf_allocator *allocator,
                             sfi_incidence *incidence);

// Free what was made; one that is all zero is none.
void sfi_incidence_free(const sf_allocator *allocator, sfi_incidence *incidence);

// The two vertices that follow corner c in its triangle.
static inline void sfi_incidence_others(const uint32_t *triangles, uint32_t c, uint32_t *next,
                                        uint32_t *last)
{
    uint32_t t = c - c % 3;
    *next = triangles[t + (c + 1 - t) % 3];
    *last = triangles[t + (c + 2 - t) % 3];
}

#endif
