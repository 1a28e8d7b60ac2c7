// SPDX-License-Identifier: MIT
// Handles: a few places of a solid, and how the whole follows them.
//
// A handle is a point, a ball or the base of a solid, and a pose says what becomes of it: it turns
// and scales about its centre and is shifted. A point p of the solid follows all handles, each with
// a weight that fades away from it:
//
//     v = sum over j of w_j(p) (s_j R_j (p - c_j) + c_j + t_j).
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

#ifndef SF_HANDLES_H
#define SF_HANDLES_H

#include <sf/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Handles
// ---------------------------------------------------------------------------------------------

/** Most handles of one solid. */
#define SF_HANDLE_MAX 64u

/** What a handle holds. */
typedef enum sf_handle_kind {
    SF_HANDLE_POINT = 0, /**< the cell that its centre lies in */
    SF_HANDLE_BALL = 1,  /**< that cell, and the corners of cells within a radius */
    SF_HANDLE_BASE = 2   /**< the cells that hold a voxel of a region */
} sf_handle_kind;

/** A place of a solid that is posed. Cells are those of sf_weights_facts. */
typedef struct sf_handle {
    sf_handle_kind kind;   /**< point, ball or base */
    double at_mm[3];       /**< its centre: what it turns and scales about */
    double radius_mm;      /**< of a ball, > 0; not looked at otherwise */
    const sf_grid *region; /**< of a base: its voxels, on the solid's lattice; else not looked at */
    int locked;            /**< 1: whoever looks for poses leaves this handle's alone */
} sf_handle;

/**
 * A base that is held: a locked handle of a region, its centre the centre of the region's voxels.
 *
 * @param region  the voxels; must outlive the use of the handle
 * @param handle  receives the handle
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a region without voxels.
 * @cost one pass over the grid.   @threads any.
 * @since 0.2
 */
SF_API SF_CHECKED sf_status sf_handle_base(const sf_grid *region, sf_handle *handle);

/**
 * The foot of a solid: its voxels that lie lowest, seen against a direction.
 *
 * @param solid      the voxels
 * @param up         the direction that points up, of any length but 0; +z is not special
 * @param height_mm  how far above the lowest centre of a voxel the centres of the foot may lie;
 *                   at least 0
 * @param allocator  for the new grid; NULL for the C library's
 * @param foot       receives a grid on the solid's lattice
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a direction without length or not finite, a
 * height that is no number or below 0, a solid without voxels; SF_ERR_MEMORY.
 * @cost two passes over the solid voxels.   @threads any; one at a time for each allocator.
 * @since 0.2
 */
SF_API SF_CHECKED sf_status sf_grid_foot(const sf_grid *solid, const double up[3], double height_mm,
                                         const sf_allocator *allocator, sf_grid **foot);

/**
 * A solid together with the voxels that a surface touches: a domain that holds all of the surface.
 *
 * What of the surface leaves the lattice is not covered.
 *
 * @param solid      the voxels
 * @param surface    the triangles that bound them, in the lattice's frame
 * @param allocator  for the new grid and for scratch; NULL for the C library's
 * @param task       NULL, or progress, cancel and threads
 * @param covered    receives a grid on the solid's lattice
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; what sf_grid_voxelize() says; SF_ERR_MEMORY;
 * SF_ERR_CANCELLED.
 * @cost as sf_grid_voxelize() with SF_FILL_SURFACE.   @threads any; one at a time for each
 * allocator.
 * @since 0.2
 */
SF_API SF_CHECKED sf_status sf_grid_cover(const sf_grid *solid, sf_mesh_view surface,
                                          const sf_allocator *allocator, sf_task *task,
                                          sf_grid **covered);

/**
 * The middle of the solid behind a point, as one who points at a surface means it.
 *
 * The ray runs from the point, which may lie anywhere, and ends where it first leaves the solid
 * voxels that it has entered. The middle of that stretch is the place of the handle.
 *
 * @param solid      the voxels
 * @param from_mm    where the ray begins: on the surface, before it, or in the solid
 * @param direction  where it runs, of any length but 0
 * @param center_mm  receives the middle; may be `from_mm`
 * @param fault      NULL, or receives a sentence on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a number that is not finite, a direction without
 * length; SF_ERR_INFEASIBLE: the ray meets no solid voxel.
 * @cost the voxels that the ray passes.   @threads any.
 * @source the paper's section 5; J. Amanatides, A. Woo, "A Fast Voxel Traversal Algorithm for Ray
 * Tracing", Eurographics 1987.
 * @since 0.2
 */
SF_API SF_CHECKED sf_status sf_handle_center(const sf_grid *solid, const double from_mm[3],
                                             const double direction[3], double center_mm[3],
                                             sf_fault *fault);

/** How handles are placed. Fill with sf_place_options_default(). */
typedef struct sf_place_options {
    size_t struct_size;  /**< sizeof(sf_place_options), set by the default */
    uint32_t count;      /**< how many handles are wanted: 5; 1..SF_HANDLE_MAX */
    const sf_grid *base; /**< NULL, or voxels to keep away from, on the solid's lattice */
    double ball;         /**< 0: points; else balls of this part of the largest that fits; 0..1 */
    uint32_t most_cells; /**< the solid is looked at in blocks, at most this many: 32768; at least
                              64 */
} sf_place_options;

/**
 * Options of a placement, each at its default.
 *
 * @return the options, by value: five points, no base.
 * @cost constant.   @threads any.
 * @since 0.2
 */
SF_API sf_place_options sf_place_options_default(void);

/**
 * Place handles by themselves: deep in the solid, far from the base and from each other.
 *
 * Places are cells that lie at least as deep as their neighbours; when these are used up, cells at
 * least half as deep as the deepest. Without a base the first handle takes the deepest of all. Each
 * of the others takes the place that is furthest from what is taken, on the way through the solid,
 * with the depth of the place added. No two handles lie within three cells of each other or of the
 * base. The result is the same everywhere.
 *
 * @param solid      the voxels; their boxes bound the solid
 * @param options    NULL for the default
 * @param allocator  for scratch, some 40 bytes a cell and 4 for each cell of the box around them;
 *                   NULL for the C library's
 * @param task       NULL, or progress and cancel
 * @param handles    receives them, in the order in which they were placed, none locked
 * @param capacity   places in `handles`, at least the number wanted
 * @param count      receives how many were placed: fewer than wanted where there is no room
 * @param fault      NULL, or receives a sentence on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options out of range or without their
 * struct_size, a solid without voxels; SF_ERR_SHAPE: a base on another lattice; SF_ERR_CAPACITY:
 * too few places, with the number wanted in `count`; SF_ERR_INFEASIBLE: no place for even one;
 * SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost n log n of the cells for each handle.   @threads any; one at a time for each allocator.
 * @source T. F. Gonzalez, "Clustering to Minimize the Maximum Intercluster Distance", 1985.
 * @since 0.2
 */
SF_API SF_CHECKED sf_status sf_handles_place(const sf_grid *solid, const sf_place_options *options,
                                             const sf_allocator *allocator, sf_task *task,
                                             sf_handle *handles, size_t capacity, size_t *count,
                                             sf_fault *fault);

// ---------------------------------------------------------------------------------------------
// Poses
// ---------------------------------------------------------------------------------------------

/** What becomes of a handle: p -> scale * turn (p - centre) + centre + shift. */
typedef struct sf_pose {
    double scale;       /**< 1 leaves the size */
    double turn[9];     /**< a rotation, row after row; not checked to be one */
    double shift_mm[3]; /**< added last */
} sf_pose;

/**
 * The pose that changes nothing.
 *
 * @return the pose, by value.
 * @cost constant.   @threads any.
 * @since 0.2
 */
SF_API sf_pose sf_pose_identity(void);

/** A direction in which a pose changes, and what a sum changes by it. */
typedef struct sf_pose_change {
    double scale;       /**< of the scale */
    double shift_mm[3]; /**< of the shift */
    double spin_rad[3]; /**< a small turn after the pose's own, about this axis by its length */
} sf_pose_change;

/**
 * Change a pose: scale and shift are added, the spin turns after what is there.
 *
 * @param pose    the pose, changed in place
 * @param change  the change; its spin shorter than 3 radians
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a number that is not finite, a spin of 3 radians
 * or more.
 * @cost constant.   @threads one per pose.
 * @source O. Rodrigues, 1840: the axis scaled by the tangent of half the angle.
 * @since 0.2
 */
SF_API SF_CHECKED sf_status sf_pose_move(sf_pose *pose, const sf_pose_change *change);

// ---------------------------------------------------------------------------------------------
// Weights
// ---------------------------------------------------------------------------------------------

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
 * @since 0.2
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
 *                   but for no more than 16 handles at once; NULL for the C library's
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
 * @since 0.2
 */
SF_API SF_CHECKED sf_status sf_weights_create(const sf_grid *solid, const sf_handle *handles,
                                              size_t count, const sf_weights_options *options,
                                              const sf_allocator *allocator, sf_task *task,
                                              sf_weights **weights, sf_fault *fault);

/**
 * Free weights; NULL does nothing.
 *
 * @cost constant.   @threads one, and nobody else with these weights.   @since 0.2
 */
SF_API void sf_weights_destroy(sf_weights *weights);

/**
 * What weights were made of.
 *
 * @return the facts, by value; all zero for NULL.
 * @cost constant.   @threads any.   @since 0.2
 */
SF_API sf_weights_facts sf_weights_describe(const sf_weights *weights);

/**
 * The centres of all handles: x, y, z of each, in mm, as they were handed in.
 *
 * @return an array that lives as long as the weights; NULL for NULL.
 * @cost constant.   @threads any.   @since 0.2
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
 * @since 0.2
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
 * @since 0.2
 */
SF_API SF_CHECKED sf_status sf_weights_sample(const sf_weights *weights, const double *xyz_mm,
                                              size_t count, sf_task *task, double *w);

// ---------------------------------------------------------------------------------------------
// Blending
// ---------------------------------------------------------------------------------------------

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
 * @since 0.2
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
 * @since 0.2
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
 * @since 0.2
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
 * @since 0.2
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
 * @since 0.2
 */
SF_API SF_CHECKED sf_status sf_weights_fold(const sf_weights *weights, const sf_pose *poses,
                                            sf_task *task, sf_fold *fold);

#ifdef __cplusplus
}
#endif

#endif
