// SPDX-License-Identifier: MIT
// Whether any triangle of a mesh comes near a box.

#ifndef SF_BALANCE_NEAR_H
#define SF_BALANCE_NEAR_H

#include <sf/mesh.h>

// Squared distance of a triangle to the box |x_i| <= half[i], as long as it is below that of
// `limit`; else any number that is not. Who has enough with less than the square of `enough` gets
// the first such number. The corners are given from the middle of the box. What is below is proved
// by a point of the triangle; what is not is wrong by rounding at most.
double sfi_triangle_gap(const double corners[3][3], const double half[3], double limit,
                        double enough);

#define SFI_NEAR_LEVELS 12 // more than 2^32 triangles have
#define SFI_NEAR_SPAN 8u   // boxes in a block

// The boxes of a block, side by side, so that all are looked at at once: middles, and half sizes
// that hold what rounding the middles cost. Boxes that there are not have a size far below 0.
typedef struct sfi_near_block {
    double middle[3][SFI_NEAR_SPAN], half[3][SFI_NEAR_SPAN];
} sfi_near_block;

// Boxes around the triangles of a mesh: those of level 0 are of one triangle each, and box i of
// level n + 1 holds block i of level n. The uppermost level is one block.
typedef struct sfi_near {
    sf_mesh_view mesh;
    uint32_t *order; // triangles, close ones close together
    sfi_near_block *blocks;
    size_t first[SFI_NEAR_LEVELS + 1]; // block of each level
    size_t levels;                     // 0: no triangles
} sfi_near;

// SF_OK; SF_ERR_OVERFLOW: 2^32 triangles or more; SF_ERR_MEMORY. The mesh is valid, and must
// outlive the tree.
sf_status sfi_near_create(sf_mesh_view mesh, const sf_allocator *allocator, sfi_near *near);
void sfi_near_destroy(sfi_near *near, const sf_allocator *allocator);

// Whether any triangle has a point nearer than `limit` to the box around `middle`.
int sfi_near_any(const sfi_near *near, const double middle[3], const double half[3], double limit);

// Distance of the nearest triangle where that is below `limit`, else `limit`.
double sfi_near_least(const sfi_near *near, const double middle[3], const double half[3],
                      double limit);

#endif
