// SPDX-License-Identifier: MIT
// Smoothing the surface of voxels.

#ifndef SF_MESH_SMOOTH_H
#define SF_MESH_SMOOTH_H

#include <sf/mesh.h>

// Take steps out of the surface without shrinking it; no vertex gets further than just under half a
// voxel from where it stood along any axis. SF_ERR_MEMORY changes nothing.
sf_status sfi_mesh_smooth(double *vertices, size_t vertex_count, const uint32_t *triangles,
                          size_t triangle_count, const sf_lattice *lattice, int passes,
                          const sf_allocator *allocator);

#endif
