// SPDX-License-Identifier: MIT
// Bodies: what a thing weighs and where its weight lies.
//
// A body is a mass and its first moments, and nothing else: whether a thing stands depends on no
// more. Bodies add up, so that a statue is the solid that its surface bounds, less its cavity, plus
// the magnet in its foot. Densities are relative: 1 is the material of the part, so that a mass is
// the volume in mm3 of so much of it.

#ifndef SF_BODY_H
#define SF_BODY_H

#include <sf/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A mass and its first moments about the origin. What is taken away counts negative. */
typedef struct sf_body {
    double mass;      /**< density times volume in mm3 */
    double moment[3]; /**< the sum of mass times position, in mm */
} sf_body;

/** A mass in one point: a magnet, a screw. */
typedef struct sf_ballast {
    double mass;     /**< density times volume in mm3 */
    double at_mm[3]; /**< where it sits */
} sf_ballast;

/** Where a centre of mass may lie: all c with normal . c >= offset_mm. */
typedef struct sf_halfspace {
    double normal[3]; /**< in the frame of the mesh */
    double offset_mm; /**< in mm where `normal` has length 1 */
} sf_halfspace;

/**
 * Body of the solid that a closed mesh bounds.
 *
 * @param mesh     closed and oriented; inside out it is a cavity, and its mass negative
 * @param density  what 1 mm3 weighs; finite
 * @param body     receives the body
 * @return SF_OK; what sf_mesh_measure() says; SF_ERR_ARGUMENT: a density that is not finite.
 * @cost two passes over the triangles.   @threads any.
 * @source sf_mesh_measure().
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_body(sf_mesh_view mesh, double density, sf_body *body);

/**
 * Body of the solid voxels of a grid, each as a box of its layer's height.
 *
 * @param grid     the voxels
 * @param density  NULL for 1 everywhere, or what 1 mm3 weighs in each voxel, solid or not, in
 *                 (layer, y, x) order: nx * ny * nz numbers. What is not solid is not looked at
 * @param task     NULL, or progress and cancel, which is heeded at every slice
 * @param body     receives the body, in the lattice's frame
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, the density of a solid voxel that is not finite;
 * SF_ERR_CANCELLED.
 * @cost one pass over the grid; with densities, one over the solid voxels too.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_body(const sf_grid *grid, const float *density, sf_task *task,
                                         sf_body *body);

/**
 * a + factor * b: with 1 both together, with -1 the one less the other.
 *
 * @param a       a body
 * @param factor  how often b is added
 * @param b       a body
 * @return the sum.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_body sf_body_add(sf_body a, double factor, sf_body b);

/**
 * Body of masses in points, summed in their order.
 *
 * @param ballast  the masses; may be NULL where count is 0
 * @param count    how many
 * @return the body.
 * @cost linear.   @threads any.
 * @since 0.1
 */
SF_API sf_body sf_ballast_body(const sf_ballast *ballast, size_t count);

/**
 * Centre of mass of a body.
 *
 * @param body    the body
 * @param com_mm  receives x, y, z
 * @return SF_OK; SF_ERR_ARGUMENT: `com_mm` is NULL, a body without mass, or with less than none.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_body_com(sf_body body, double com_mm[3]);

#ifdef __cplusplus
}
#endif

#endif
