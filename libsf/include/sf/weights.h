// SPDX-License-Identifier: MIT
// Weights: how far each point of a solid follows each of its handles.
//
// The weights are smooth, lie in [0, 1], sum to 1 everywhere, and are 1 at their own handle and 0
// at every other. They live on the solid's own voxels, or on blocks of them where these are many;
// no mesh of tetrahedra is made. Every solid voxel's box belongs to the domain, and a point outside
// has the weights of the closest point of the domain; so a surface should be handed in with the
// voxels that it touches: sf_grid_cover().
//
// Source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing Shapes
// for 3D Fabrication", SIGGRAPH 2013, section 5; A. Jacobson, I. Baran, J. Popovic, O. Sorkine,
// "Bounded Biharmonic Weights for Real-Time Deformation", SIGGRAPH 2011.

#ifndef SF_WEIGHTS_H
#define SF_WEIGHTS_H

#include <sf/handles.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How weights are found. */
typedef enum sf_weights_method {
    SF_WEIGHTS_CLAMPED = 0, /**< the smoothest of all, cut off at 0 and 1: fast */
    SF_WEIGHTS_BOUNDED = 1  /**< the smoothest of those within 0 and 1, each handle for itself */
} sf_weights_method;

/** How weights are found. Fill with sf_weights_options_default(). */
typedef struct sf_weights_options {
    size_t struct_size;       /**< sizeof(sf_weights_options), set by the default */
    sf_weights_method method; /**< SF_WEIGHTS_CLAMPED by default */
    uint32_t most_cells; /**< voxels are taken together in blocks until they are no more than this:
                              32768; at least 8 */
    double cell_mm;      /**< 0 (default), or how long the edges of a block should be, rounded to
                              whole voxels on each axis; most_cells is not looked at then */
    double tolerance;    /**< how far from what is looked for a weight may be, about: 1e-5;
                              1e-9..1e-2 */
} sf_weights_options;

/**
 * Options of weights, each at its default.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_weights_options sf_weights_options_default(void);

/** Weights of the points of a solid for its handles: the values at the corners of its cells. */
typedef struct sf_weights sf_weights;

/** What weights were made of. */
typedef struct sf_weights_facts {
    size_t handle_count; /**< handles */
    size_t cell_count;   /**< boxes of one block of voxels each, of which at least one is solid */
    size_t node_count;   /**< corners of cells, where values are kept */
    size_t loose_count;  /**< pieces of the solid that hold no handle */
    uint32_t block[3];   /**< voxels of a cell along x, y, z */
    double cell_mm[3];   /**< edges of a cell; along z the mean, where layers differ */
    uint32_t iterations; /**< steps of the solver, summed over groups of handles */
    double residual;     /**< what is left, as a change of weights: see sf_weights_create() */
} sf_weights_facts;

/**
 * Find the weights of a solid for its handles.
 *
 * Cells are blocks of voxels that hold a solid one; along each axis as many voxels as make them
 * nearly cubes. On their corners lives the Laplacian of seven points, made of finite volumes, with
 * no flow through the surface of the cells. CLAMPED weights have the least integral of the
 * squared Laplacian among all with 1 at their handle and 0 at the others; then they are cut off at
 * 0 and 1, and divided by their sum. BOUNDED weights have the least among those that lie within 0
 * and 1, each handle for itself, and are then divided by their sum. Either way they lie in [0, 1],
 * sum to 1 up to rounding, and are exactly 1 on their handle's corners and 0 on those of others.
 *
 * What the solver leaves is given as a residual. CLAMPED: the largest last correction, estimated
 * from the decay of the residual's norm, at most `tolerance`. BOUNDED: the largest |w - clamp(w - g
 * / d)| over handles and corners, g the gradient and d its own derivative; at most `tolerance`.
 *
 * A piece of the solid that touches no handle follows the closest point of a piece that does, as
 * one. Handles may not share corners: they must lie two cells apart.
 *
 * Each handle must touch the solid: the centre of a point or a ball lies in a cell, and a base has
 * solid voxels.
 *
 * @param solid      the voxels; not kept
 * @param handles    the handles; not kept
 * @param count      how many, 1..SF_HANDLE_MAX
 * @param options    NULL for the default
 * @param allocator  for the weights and for scratch: 8 bytes for each cell of the box around all,
 *                   and per corner 180, 8 a handle, and 310 for each four handles, 460 BOUNDED,
 *                   but for no more than 16 handles at once; where pieces touch no handle 24 bytes
 *                   for each cell of the box; NULL for the C library's
 * @param task       NULL, or progress, cancel, and threads, on which groups of four handles run
 * @param weights    receives the weights
 * @param fault      NULL, or receives a sentence on failure that names the handle
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a solid without voxels, a number of handles or
 * options out of range, a handle of no kind, one that is not finite, a ball without radius, a base
 * without region or with one without voxels; SF_ERR_SHAPE: a region of other counts than the
 * solid's; SF_ERR_INFEASIBLE: a handle outside the solid, two handles that touch; SF_ERR_OVERFLOW:
 * more than 2^31 corners; SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_INTERNAL: the solver stood still.
 * @cost some 30 steps for each four handles, each a few passes over the corners: about 0.15 s for
 * six handles and 20 000 cells on one core. BOUNDED: about twenty times as much.
 * @threads any; one at a time for each allocator.
 * @source A. Jacobson, I. Baran, J. Popovic, O. Sorkine, "Bounded Biharmonic Weights for Real-Time
 * Deformation", SIGGRAPH 2011.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_weights_create(const sf_grid *solid, const sf_handle *handles,
                                              size_t count, const sf_weights_options *options,
                                              const sf_allocator *allocator, sf_task *task,
                                              sf_weights **weights, sf_fault *fault);

/**
 * Free weights.
 *
 * @param weights  the weights, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with these weights.   @since 0.1
 */
SF_API void sf_weights_destroy(sf_weights *weights);

/**
 * What weights were made of.
 *
 * @param weights  the weights; NULL gives facts of zeros
 * @return the facts, by value; all zero for NULL.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API sf_weights_facts sf_weights_describe(const sf_weights *weights);

/**
 * The centres of all handles: x, y, z of each, in mm, as they were handed in.
 *
 * @param weights  the weights; NULL has none
 * @return an array that lives as long as the weights; NULL for NULL.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API const double *sf_weights_centers(const sf_weights *weights);

/**
 * Weights at a point, and how they change there.
 *
 * Between corners values are interpolated along each axis in turn, so that they are continuous and
 * their gradient jumps from cell to cell; on a face between two cells the gradient is that of the
 * upper one, if there is one. Outside the domain a point has the values of the closest point in it,
 * and the gradient there without the axes along which it lies outside that point's cell; more than
 * two cells away, of a point that is about as close.
 *
 * @param weights   the weights
 * @param p_mm      x, y, z; finite
 * @param w         receives a weight for each handle
 * @param gradient  NULL, or receives x, y, z for each handle, per mm
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a coordinate that is not finite.
 * @cost constant; a few times as much outside the domain.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_weights_at(const sf_weights *weights, const double p_mm[3],
                                          double *w, double *gradient);

/**
 * Weights at many points.
 *
 * @param weights  the weights
 * @param xyz_mm   x, y, z of each point
 * @param count    how many
 * @param task     NULL, or the host's threads; a cancel is heeded before the first write
 * @param w        receives a weight for each handle, point after point; not `xyz_mm`
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer where count is not 0, a coordinate that is not
 * finite; SF_ERR_CANCELLED.
 * @cost two passes over the points; about 0.1 us each for six handles.   @threads any that write to
 * distinct arrays.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_weights_sample(const sf_weights *weights, const double *xyz_mm,
                                              size_t count, sf_task *task, double *w);

#ifdef __cplusplus
}
#endif

#endif
