// SPDX-License-Identifier: MIT
// Blends: where points go when handles are posed, and where they came from.
//
// A point p of the solid follows all handles, each by its weight:
//
//     v = sum over j of w_j(p) (s_j R_j (p - c_j) + c_j + t_j).
//
// Forwards, through its derivative in both directions, backwards, and whether it folds the solid.
//
// Source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing Shapes
// for 3D Fabrication", SIGGRAPH 2013, section 5, equation 9.

#ifndef SF_BLEND_H
#define SF_BLEND_H

#include <sf/weights.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Points with their weights: what a pose of all handles bends. */
typedef struct sf_blend {
    const double *rest_mm;    /**< x, y, z of each point as it was */
    const double *weights;    /**< handle_count for each point, as sf_weights_sample() gives them */
    size_t point_count;       /**< points */
    const double *centers_mm; /**< x, y, z of each handle, as sf_weights_centers() gives them */
    size_t handle_count;      /**< 1..SF_HANDLE_MAX */
} sf_blend;

/**
 * Bend points: v = sum of w_j (s_j R_j (p - c_j) + c_j + t_j).
 *
 * @param blend   the points and their weights; numbers that are not finite give such
 * @param poses   one for each handle
 * @param task    NULL, or the host's threads; a cancel is heeded before the first write
 * @param xyz_mm  receives x, y, z of each point; may be `rest_mm`, and nothing else of the blend
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no or too many handles, a pose that is not
 * finite; SF_ERR_CANCELLED.
 * @cost one pass; 86 000 points and six handles take about 1 ms on one core.   @threads any that
 * write to distinct arrays.
 * @source the paper's equation 9.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_blend_apply(sf_blend blend, const sf_pose *poses, sf_task *task,
                                           double *xyz_mm);

/**
 * How points move when poses change: the matrix M of the paper's equation 10 times a vector.
 *
 * The move is w_j (ds_j R_j (p - c_j) + dt_j + s_j spin_j x R_j (p - c_j)), summed over handles:
 * exact for scales and shifts, in which a blend is linear, and the derivative for spins.
 *
 * @param blend    the points and their weights
 * @param poses    one for each handle
 * @param changes  one for each handle
 * @param task     NULL, or the host's threads; a cancel is heeded before the first write
 * @param moves    receives x, y, z for each point, in mm; may be `rest_mm`
 * @return as sf_blend_apply().
 * @cost as sf_blend_apply().   @threads any that write to distinct arrays.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_blend_push(sf_blend blend, const sf_pose *poses,
                                          const sf_pose_change *changes, sf_task *task,
                                          double *moves);

/**
 * How a function of the points changes when poses change: the transpose of M times a gradient.
 *
 * @param blend      the points and their weights
 * @param poses      one for each handle
 * @param gradient   the function's derivatives by x, y, z of each point
 * @param allocator  for scratch: 96 bytes for each handle and 4096 points; NULL for the C library's
 * @param task       NULL, or the host's threads and cancel; the result is the same bytes with any
 * @param changes    receives the derivatives by scale, shift and spin of each handle
 * @return SF_OK; SF_ERR_ARGUMENT: as sf_blend_apply(); SF_ERR_OVERFLOW; SF_ERR_MEMORY;
 * SF_ERR_CANCELLED.
 * @cost one pass.   @threads any that write to distinct arrays; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_blend_pull(sf_blend blend, const sf_pose *poses,
                                          const double *gradient, const sf_allocator *allocator,
                                          sf_task *task, sf_pose_change *changes);

/**
 * Where points lie before bending: the inverse of a blend.
 *
 * Newton's method with the gradients of the weights, each point from the guess handed in or from
 * what the point before it leads to, whichever is closer; so points should come row by row. What
 * fails, or leads out of the domain, is tried from the cells that are bent to where it lies. A rest
 * point in the domain is worth more than one outside; where the bent solid folds over itself more
 * than one is right, and one of them is found.
 *
 * A point outside the bent solid may have a rest point outside the domain, where the weights reach
 * on as sf_weights_at() says, or none.
 *
 * @param weights      the weights
 * @param poses        one for each handle
 * @param bent_mm      x, y, z of each bent point; finite
 * @param count        how many
 * @param tolerance_mm how near to its bent point the blend of a rest point must come, > 0
 * @param allocator    for scratch: 24 bytes a corner, 56 a cell and 450 kB, and without residual_mm
 *                     8 a point; NULL for the C library's
 * @param task         NULL, or the host's threads and cancel; the result is the same bytes with any
 * @param rest_mm      holds a guess for each point: the bent point itself, or what was found for a
 *                     pose close to this one; receives the rest points; not `bent_mm`
 * @param residual_mm  NULL, or receives how far the blend of each rest point is from the bent one:
 *                     at most tolerance_mm where it was found
 * @param missed       NULL, or receives how many were not found
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a coordinate, guess or pose that is not finite, a
 * tolerance out of range; SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost some three evaluations a point: about 1 us each for six handles, and half of that where
 * guesses are good.
 * @threads any that write to distinct arrays; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_weights_unbend(const sf_weights *weights, const sf_pose *poses,
                                              const double *bent_mm, size_t count,
                                              double tolerance_mm, const sf_allocator *allocator,
                                              sf_task *task, double *rest_mm, double *residual_mm,
                                              size_t *missed);

/** How a blend stretches the solid, at the corners of all its cells. */
typedef struct sf_fold {
    double least_det; /**< least determinant of the blend's derivative: the factor by which volume
                           grows there; where it is not above 0 the solid is folded over */
    double at_mm[3];  /**< where that is, before bending */
    uint64_t folded;  /**< how many of the places looked at have none above 0 */
    uint64_t places;  /**< how many were looked at: eight a cell */
} sf_fold;

/**
 * Whether a blend folds the solid over itself: its derivative in the eight corners of each cell.
 *
 * A cell's own gradients are used, so that each corner is looked at once for every cell around it.
 *
 * @param weights  the weights
 * @param poses    one for each handle
 * @param task     NULL, or progress, cancel and threads; the result is the same with any
 * @param fold     receives what was found; of equal determinants the first cell's
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a pose that is not finite; SF_ERR_CANCELLED.
 * @cost one pass over the cells, some 2 us each for six handles.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_weights_fold(const sf_weights *weights, const sf_pose *poses,
                                            sf_task *task, sf_fold *fold);

#ifdef __cplusplus
}
#endif

#endif
