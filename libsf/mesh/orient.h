// SPDX-License-Identifier: MIT
// Neighbouring triangles made to look the same way.

#ifndef SF_MESH_ORIENT_H
#define SF_MESH_ORIENT_H

#include "mesh/chain.h"

// Turn triangles of a welded chain, in place, so that two triangles that alone share an edge run it
// in opposite directions. In each patch of triangles joined by such edges as few as possible are
// turned. Returns their number in `turned`. Where that cannot be (a Moebius strip), the edge that
// comes last stays as it is.
sf_status sfi_orient(uint32_t *triangles, size_t triangle_count, size_t point_count,
                     const sf_allocator *allocator, size_t *turned);

#endif
