// SPDX-License-Identifier: MIT
// Triangles that fill contours in a plane.

#ifndef SF_MESH_CAP_H
#define SF_MESH_CAP_H

#include "mesh/contour.h"

// Most triangles for each edge.
#define SFI_CAP_TRIANGLES_PER_EDGE (1 + 2 * 2)

// Fill what directed edges have on their left, with no corners but their ends: holes, islands in
// holes, contours that touch themselves in spots. `edges` are two spots each, that differ, and form
// a boundary: as many end in each spot as start there. `triangles` has room for
// SFI_CAP_TRIANGLES_PER_EDGE for each edge, three spots each, which turn to the left, and whose
// boundary is the edges. Where contours cross, triangles lie over each other, and some may turn to
// the right: the boundary stays exact, and so does how often any place is covered, those counted as
// less than none. Spots may come in any order; SF_ERR_MEMORY.
sf_status sfi_cap_fill(const sfi_spot *spots, size_t spot_count, const uint32_t *edges,
                       size_t edge_count, const sf_allocator *allocator, uint32_t *triangles,
                       size_t *triangle_count);

#endif
