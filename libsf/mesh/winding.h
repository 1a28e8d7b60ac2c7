// SPDX-License-Identifier: MIT
// How far the patches over a mesh's holes wind around a point.

#ifndef SF_MESH_WINDING_H
#define SF_MESH_WINDING_H

#include "mesh/jet.h"
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

// Where a point lies, in lengths.
static inline void sfi_winding_place(const sfi_winding *w, const sfi_point *p, double out[3])
{
    out[0] = p->x * w->scale[0];
    out[1] = p->y * w->scale[1];
    out[2] = p->z * w->scale[2];
}

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

// Most triangles that a box keeps to itself.
#define SFI_NEAR_MAX 96

// The patches' winding number within a box of voxels: all of it but for whole turns, and what lies
// far apart from the triangles near by.
typedef struct sfi_winding_box {
    sfi_jet far, all; // about the middle, over the box and half a voxel beyond it along x
    sfi_point middle;
    double place[3], reach; // the middle in lengths, and a ball around it that holds all this
    int depth;              // of the parents around it
    int dense;  // whether more than SFI_NEAR_MAX triangles are near: then nothing below holds
    int smooth; // whether `all` holds
    int plain;  // whether no triangle comes into the ball: then there are no whole turns to count
    uint32_t near_count;
    uint32_t near[SFI_NEAR_MAX];
} sfi_winding_box;

// Survey the box between two voxel centres, low <= high along each axis. `parent` is a box around
// it that is surveyed, or NULL.
void sfi_winding_survey(const sfi_winding *winding, const sfi_point *points, sfi_point low,
                        sfi_point high, const sfi_winding_box *parent, sfi_winding_box *box);
// The winding number at a point of a box that is not dense, to within `error`.
double sfi_winding_in(const sfi_winding *winding, const sfi_point *points,
                      const sfi_winding_box *box, sfi_point q, double *error);

#endif
