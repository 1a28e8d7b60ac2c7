// SPDX-License-Identifier: MIT
// Every voxel that a surface touches.

#ifndef SF_MESH_SHELL_H
#define SF_MESH_SHELL_H

#include "mesh/skin.h"

// Layers that a triangle touches: the reach for the buckets.
void sfi_shell_reach(const sfi_frame *frame, const sfi_skin *skin, size_t triangle, uint32_t *k0,
                     uint32_t *k1);

// Set the voxels of layer k that some triangles touch.
void sfi_shell_add(const sfi_frame *frame, const sfi_skin *skin, const uint32_t *list, size_t count,
                   uint32_t k, sf_slice slice);

#endif
