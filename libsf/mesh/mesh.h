// SPDX-License-Identifier: MIT
// What the rooms ask of meshes among themselves.

#ifndef SF_MESH_MESH_H
#define SF_MESH_MESH_H

#include <sf/mesh.h>

// Vertices that are nearer than this cannot be told apart: the power of two that is 2^-40 of the
// largest coordinate, or up to twice that.
double sfi_mesh_grain(sf_mesh_view mesh);

// Number the distinct positions of the vertices, rounded to 2^-40 of the largest coordinate, by
// first appearance. `ids` has room for vertex_count numbers; `count` gets how many there are.
// SF_ERR_MEMORY changes nothing.
sf_status sfi_mesh_positions(sf_mesh_view mesh, const sf_allocator *allocator, uint32_t *ids,
                             size_t *count);

// A mesh of known size, whose arrays the caller then fills: with finite coordinates and indices
// below vertex_count. Until it has, the mesh may only be destroyed.
sf_status sfi_mesh_make(const sf_allocator *allocator, size_t vertex_count, size_t triangle_count,
                        sf_mesh **mesh, double **vertices, uint32_t **triangles);

#endif
