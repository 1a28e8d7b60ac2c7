// SPDX-License-Identifier: MIT
// The faces of a hull out of its triangles.

#ifndef SF_MESH_FLATS_H
#define SF_MESH_FLATS_H

#include "mesh/hull.h"
#include "mesh/quickhull.h"

// Arrays of an empty hull, for so many corners, faces and ends of edges. What SF_ERR_MEMORY leaves,
// sfi_hull_destroy() frees.
sf_status sfi_hull_allocate(sfi_hull *hull, size_t corners, size_t faces, size_t edges,
                            const sf_allocator *allocator);

// Corners and faces of a hull of `count` points that is made of these triangles. SF_ERR_MEMORY, as
// above.
sf_status sfi_hull_merge(const double *at, size_t count, const sfi_faces *triangles,
                         const sf_allocator *allocator, sfi_hull *hull);

#endif
