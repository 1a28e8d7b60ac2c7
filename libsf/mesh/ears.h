// SPDX-License-Identifier: MIT
// Contours that cross, filled ear by ear.

#ifndef SF_MESH_EARS_H
#define SF_MESH_EARS_H

#include "mesh/contour.h"

// Most triangles for each edge.
#define SFI_EARS_PER_EDGE 3

// Fill contours that may cross each other and themselves. The boundary of the triangles is exact;
// they turn to the left wherever that is possible nearby, and those of a hole that nothing could be
// joined to turn to the right. `triangles` has room for SFI_EARS_PER_EDGE for each edge.
sf_status sfi_ears_fill(const sfi_contour *contour, const sf_allocator *allocator,
                        uint32_t *triangles, size_t *triangle_count);

#endif
