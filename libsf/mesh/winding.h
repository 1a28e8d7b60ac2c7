// SPDX-License-Identifier: MIT
// How far the patches over a mesh's holes wind around a point.

#ifndef SF_MESH_WINDING_H
#define SF_MESH_WINDING_H

#include "mesh/loops.h"

// A stretch of one loop, closed by a chord, or several whole loops; and the patch over it.
typedef struct sfi_winding_node {
    double center[3], radius; // a ball around the patch
    double area[3];           // its vector area
    double area_sum;          // the sum of its triangles' areas
    double length;            // of its boundary edges
    uint32_t
        corner[3];  // its own triangle, or the edge; corner[2] is SFI_NOBODY where there is none
    uint32_t edges; // boundary edges below it; the subtree has 2 * edges - 1 nodes
} sfi_winding_node;

// In pre-order: a node's first child follows it, and its subtree is skipped by a jump.
typedef struct sfi_winding {
    sfi_winding_node *nodes;
    size_t node_count; // 0 where there are no holes
    size_t patch_count;
    double scale[3]; // millimetres of a unit along x, y, z, over those along x
} sfi_winding;

// Cover the loops. Points must outlive nothing: corners are numbers.
sf_status sfi_winding_create(const sfi_frame *frame, const sfi_point *points,
                             const sfi_loops *loops, const sf_allocator *allocator,
                             sfi_winding *winding);
void sfi_winding_destroy(sfi_winding *winding, const sf_allocator *allocator);

// Write the patches' triangles, patch_count of them: with the mesh they make a closed chain.
void sfi_winding_patches(const sfi_winding *winding, uint32_t *triangles);
// Turn the patches around.
void sfi_winding_flip(sfi_winding *winding);

// The patches' winding number around q, to within `error`; a node whose own error stays below
// `tolerance` is taken as a dipole. With tolerance 0 all triangles are added up.
double sfi_winding_estimate(const sfi_winding *winding, const sfi_point *points, sfi_point q,
                            double tolerance, double *error);
// The whole number nearest to the patches' winding number around q; a q on a patch counts as just
// beyond it in x (then y, then z), and a half is rounded down.
int64_t sfi_winding_round(const sfi_winding *winding, const sfi_point *points, sfi_point q);
// A bound on how fast the winding number of the mesh changes, for each unit of x, within `reach`
// units of q; infinite where it is too steep to be of use (more than a half over the reach).
double sfi_winding_slope(const sfi_winding *winding, const sfi_point *points, sfi_point q,
                         double reach);

#endif
