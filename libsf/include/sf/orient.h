// SPDX-License-Identifier: MIT
// Orientation: which way up a part prints best.
//
// The same part may need no supports or a forest of them, depending on the side that it stands on.
// sf_mesh_orient() looks at a thousand directions through the triangles' normals, makes voxels of
// the best of these to see what a trim really takes, and looks closely at the best of those. What
// counts is what cannot print, then how high the part is and how safely it stands.

#ifndef SF_ORIENT_H
#define SF_ORIENT_H

#include <sf/mesh.h>
#include <sf/support.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How orientations are looked for. Fill with sf_orient_options_default(). */
typedef struct sf_orient_options {
    size_t struct_size;       /**< sizeof(sf_orient_options), set by the default */
    sf_rule_kind rule;        /**< what may rest on what; octagon by default */
    double angle_rad;         /**< overhang from the vertical that still prints; 45 degrees */
    sf_fill fill;             /**< what is inside; SF_FILL_AUTO by default */
    uint32_t direction_count; /**< directions spread over the sphere, beside the six axes and the
                                   large flat faces: 1000; at most 100000 */
    uint32_t coarse_count; /**< how many of these become voxels at the coarse resolution, beside the
                                axes and the flat faces, 38 at most: 50; 1..10000 */
    uint32_t fine_count;   /**< how many at the fine one, which are the result: 5; 1..1000 */
    uint32_t coarse_resolution; /**< voxels on the longest side of the mesh as it is given: 64 */
    uint32_t resolution;        /**< the same, for the result: 256; both 1..16384 */
    double weight_height;       /**< what height counts in the score: 0.02; 0..1000 */
    double weight_margin;       /**< what leaning counts in the score: 0.02; 0..1000 */
} sf_orient_options;

/**
 * A way to put a part on the bed, and what came of it at the fine resolution.
 *
 * The score is trimmed_voxels / solid_voxels (1 where nothing is solid) + weight_height *
 * height_mm / (diagonal of the mesh's box, as it is given) + weight_margin * (1 - margin_rad / 90
 * degrees). Less is better.
 */
typedef struct sf_orientation {
    double up[3];            /**< the mesh's direction that points up, length 1 */
    sf_transform turn;       /**< turns `up` to +z and puts the lowest vertex on z = 0 */
    double unsupported_mm2;  /**< area of the faces that look down more steeply than the angle
                                  allows, as seen from below; faces on the bed are none */
    uint64_t solid_voxels;   /**< of the part */
    uint64_t trimmed_voxels; /**< of these, what a trim takes away */
    double trimmed_mm3;      /**< the same in mm3 */
    double height_mm;        /**< from the lowest vertex to the highest */
    double margin_rad;       /**< the least angle by which the part must be tipped to fall over an
                                  edge of what touches the bed; negative where it falls as it is */
    double score;            /**< what is ranked by */
} sf_orientation;

/**
 * Options of a search for orientations, each at its default.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_orient_options sf_orient_options_default(void);

/**
 * Find the ways up in which a part prints best, the best one first.
 *
 * Three rounds. Directions over the sphere are ranked by the area that hangs over and by height;
 * the best coarse_count of them, the axes and the large flat faces by their score at the coarse
 * resolution; the best fine_count of those, and the mesh as it is given, by their score at the fine
 * one. Of equal scores the one with less unsupported area is better, then the one that was thought
 * of earlier: the way it is given, the other axes, the large flat faces, the sphere. So the result
 * is one and the same everywhere, with any number of threads; and it is never worse than the mesh
 * as it is given.
 *
 * What touches the bed is the lowest layer of voxels; the centre of mass is that of the voxels.
 *
 * @param mesh          vertices in mm, with triangles
 * @param options       NULL for the default
 * @param allocator     for scratch: 24 bytes a vertex and 24 a triangle, 152 a direction, a grid
 *                      and what sf_grid_voxelize() takes; NULL for the C library's
 * @param task          NULL, or progress, cancel and threads
 * @param orientations  receives the best ones
 * @param capacity      places in it
 * @param count         receives how many: fine_count, or fewer where so many were not looked at; on
 *                      SF_ERR_CAPACITY, fine_count
 * @param given         NULL, or receives the same figures for the mesh as it is given
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options out of range or without their
 * struct_size, an angle that sf_rule_make() refuses, what sf_mesh_validate() refuses, a mesh
 * without triangles or without extent; SF_ERR_CAPACITY: less than fine_count places;
 * SF_ERR_UNSUPPORTED: a rule that does not serve cubes at this angle, a mesh that the voxeliser
 * refuses; SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost direction_count passes over the mesh; coarse_count + fine_count times voxels and a trim.
 * @threads any; the task's hook may run up to 64 pieces at once.
 * @source the spread of directions is R. Swinbank, R. J. Purser, "Fibonacci grids: A novel approach
 * to global modelling", 2006; the cheap score is that of C. Schranz, "Tweaker - Auto Rotation
 * Module for FDM 3D Printing", 2016, without its weights.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_orient(sf_mesh_view mesh, const sf_orient_options *options,
                                           const sf_allocator *allocator, sf_task *task,
                                           sf_orientation *orientations, size_t capacity,
                                           size_t *count, sf_orientation *given);

#ifdef __cplusplus
}
#endif

#endif
