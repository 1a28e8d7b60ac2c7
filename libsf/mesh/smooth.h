// SPDX-License-Identifier: MIT
// Smoothing the surface of voxels.

#ifndef SF_MESH_SMOOTH_H
#define SF_MESH_SMOOTH_H

#include <sf/mesh.h>

#include "base/task.h"

// How often, and on whose behalf: the task is heeded at every pass, and told how many of `total`
// pieces of work are done: `before` when smoothing begins, `piece` more after each pass.
typedef struct sfi_smoothing {
    int passes;
    sfi_progress *progress;
    uint64_t before, piece, total;
} sfi_smoothing;

// Take steps out of the surface without shrinking it; no vertex gets further than just under half a
// voxel from where it stood along any axis. SF_ERR_MEMORY changes nothing; SF_ERR_CANCELLED leaves
// what is half smoothed.
sf_status sfi_mesh_smooth(double *vertices, size_t vertex_count, const uint32_t *triangles,
                          size_t triangle_count, const sf_lattice *lattice,
                          const sfi_smoothing *how, const sf_allocator *allocator);

#endif
