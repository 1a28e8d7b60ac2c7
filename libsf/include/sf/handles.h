// SPDX-License-Identifier: MIT
// Handles: a few places of a solid that are posed, and that the whole follows.
//
// A handle is a point, a ball or the base of a solid. It is put there by hand, behind the point of
// the surface that somebody points at, or finds its place by itself. A pose says what becomes of
// it: it turns and scales about its centre and is shifted. How far the rest follows is a matter of
// weights (<sf/weights.h>), and where it goes one of blending (<sf/blend.h>).
//
// Source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing Shapes
// for 3D Fabrication", SIGGRAPH 2013, section 5.

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
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_handle_base(const sf_grid *region, sf_handle *handle);

/**
 * The foot of a solid: its voxels that lie lowest, seen against a direction.
 *
 * @param solid      the voxels
 * @param up         the direction that points up, of any length from 1e-100 to 1e100; +z is not
 *                   special
 * @param height_mm  how far above the lowest centre of a voxel the centres of the foot may lie;
 *                   at least 0
 * @param allocator  for the new grid; NULL for the C library's
 * @param foot       receives a grid on the solid's lattice
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a direction without length or not finite, a
 * height that is no number or below 0, a solid without voxels; SF_ERR_MEMORY.
 * @cost two passes over the solid voxels.   @threads any; one at a time for each allocator.
 * @since 0.1
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
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_cover(const sf_grid *solid, sf_mesh_view surface,
                                          const sf_allocator *allocator, sf_task *task,
                                          sf_grid **covered);

/**
 * The middle of the solid behind a point, as one who points at a surface means it.
 *
 * The ray runs from the point, which may lie anywhere within 1e12 mm, and ends where it first
 * leaves the solid voxels that it has entered. The middle of that stretch is the place of the
 * handle.
 *
 * @param solid      the voxels
 * @param from_mm    where the ray begins: on the surface, before it, or in the solid
 * @param direction  where it runs, of any length but 0
 * @param center_mm  receives the middle; may be `from_mm`
 * @param fault      NULL, or receives a sentence on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a point beyond 1e12 mm, a direction that is not
 * finite or without length; SF_ERR_INFEASIBLE: the ray meets no solid voxel.
 * @cost the voxels that the ray passes.   @threads any.
 * @source the paper's section 5; J. Amanatides, A. Woo, "A Fast Voxel Traversal Algorithm for Ray
 * Tracing", Eurographics 1987.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_handle_center(const sf_grid *solid, const double from_mm[3],
                                             const double direction[3], double center_mm[3],
                                             sf_fault *fault);

/** Where a ray meets a surface. */
typedef struct sf_ray_hit {
    double along;      /**< how many times the direction's length from the ray's beginning */
    uint32_t triangle; /**< which triangle, or whatever the caster numbers */
    int leaves;        /**< 1: the ray comes from inside there; 0: it enters */
} sf_ray_hit;

/**
 * Somebody who finds where rays meet a closed surface, as <sf/link/embree.h> does.
 *
 * `next` leaves the nearest hit with `along` greater than `beyond`, and 1 in `found`; or 0 in
 * `found` where there is none. What it returns is passed on where it is not SF_OK.
 */
typedef struct sf_ray_caster {
    sf_status (*next)(void *user, const double from_mm[3], const double direction[3], double beyond,
                      sf_ray_hit *hit, int *found); /**< finds the next hit */
    void *user;                                     /**< handed to it; may be NULL */
} sf_ray_caster;

/**
 * The middle of the solid behind a point, by rays instead of voxels: sf_handle_center() of a
 * surface.
 *
 * Where the surface goes through itself, the ray leaves the solid when it has left as often as it
 * entered. A ray that leaves first begins inside.
 *
 * @param caster     who finds hits
 * @param from_mm    where the ray begins
 * @param direction  where it runs, of any length but 0
 * @param center_mm  receives the middle; may be `from_mm`
 * @param fault      NULL, or receives a sentence on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a point or direction that is not finite, a
 * direction without length; SF_ERR_INFEASIBLE: the ray does not enter and leave the surface, or
 * meets it more than 100,000 times; SF_ERR_INTERNAL: a caster that goes backwards; or what the
 * caster returned.
 * @cost one call of the caster for each hit.   @threads as the caster.
 * @source as sf_handle_center().
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_handle_center_by_rays(sf_ray_caster caster, const double from_mm[3],
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
 * @since 0.1
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
 * @since 0.1
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
 * @since 0.1
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
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_pose_move(sf_pose *pose, const sf_pose_change *change);

#ifdef __cplusplus
}
#endif

#endif
