// SPDX-License-Identifier: MIT
// Rays by Embree: what they hit, how thick a solid is, handles behind a pointer, and a second
// voxeliser.
//
// Embree finds where rays meet triangles faster than anything here could, in single precision: a
// mesh is moved so that its middle is the origin, and each coordinate is then off by 1e-7 of its
// size. So these are answers for eyes and hands, and a check of what the library computes exactly
// by other code.
//
// These functions are in libsf-embree, a library of its own beside libsf. It works with Embree 3
// and 4.

#ifndef SF_LINK_EMBREE_H
#define SF_LINK_EMBREE_H

#include <sf/grid.h>
#include <sf/handles.h>
#include <sf/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The triangle of a ray that hits none. */
#define SF_EMBREE_NONE 0xffffffffu

/** A mesh with what Embree needs to find hits. It never changes. */
typedef struct sf_embree sf_embree;

/**
 * Prepare a mesh.
 *
 * @param mesh       the mesh; what sf_mesh_validate() takes; not needed any more afterwards
 * @param allocator  for the object; NULL for the C library's. Embree takes some 100 bytes a
 * triangle from the C++ library
 * @param embree     receives the object, to be destroyed by the caller; untouched on failure
 * @param fault      NULL, or filled on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; what sf_mesh_validate() says; SF_ERR_UNSUPPORTED:
 * a mesh without triangles, a corner beyond 1e12 mm; SF_ERR_OVERFLOW: more than 2^32 - 2 triangles;
 * SF_ERR_MEMORY; SF_ERR_INTERNAL: Embree cannot be used on this machine.
 * @cost a microsecond for each triangle.   @threads any; one at a time for each allocator. Embree
 * is told to start no threads.
 * @source I. Wald and others, "Embree: A Kernel Framework for Efficient CPU Ray Tracing", 2014.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_embree_create(sf_mesh_view mesh, const sf_allocator *allocator,
                                             sf_embree **embree, sf_fault *fault);

/**
 * Free a prepared mesh.
 *
 * @param embree  the object, freed; NULL does nothing
 * @cost its size.   @threads one, and nobody else with this object.
 * @since 0.1
 */
SF_API void sf_embree_destroy(sf_embree *embree);

/**
 * The nearest hits of rays, whichever way a triangle faces.
 *
 * @param embree     the mesh
 * @param count      how many rays; may be 0
 * @param from       3 * count coordinates in mm: where each begins
 * @param direction  3 * count: where each runs, of any length but 0
 * @param along      receives of each how many times the direction's length away it hits; infinite
 *                   where it does not
 * @param triangle   NULL, or receives of each the triangle; SF_EMBREE_NONE where it hits none
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a ray that is not finite or has no direction.
 * @cost a microsecond for each ray.   @threads any; on distinct arrays.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_embree_nearest(const sf_embree *embree, size_t count,
                                              const double *from, const double *direction,
                                              double *along, uint32_t *triangle);

/**
 * A caster for sf_handle_center_by_rays(): handles behind what somebody points at.
 *
 * Hits nearer to `beyond` than 1e-6 of the mesh are the same hit.
 *
 * @param embree  the mesh; must outlive the caster; NULL gives one without `next`
 * @return the caster, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_ray_caster sf_embree_caster(const sf_embree *embree);

/** How thickness is measured. Fill with sf_embree_thickness_options_default(). */
typedef struct sf_embree_thickness_options {
    size_t struct_size; /**< sizeof(sf_embree_thickness_options), set by the default */
    uint32_t rays;      /**< for each triangle: 31; 1 to 1024 */
    double cone_rad; /**< half the opening of the cone that they fill: 1.0472, 60 degrees; above 0,
                        at most 1.4 */
} sf_embree_thickness_options;

/**
 * 31 rays in a cone of 60 degrees about the inward normal.
 *
 * @return the options, by value, with struct_size set.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_embree_thickness_options sf_embree_thickness_options_default(void);

/**
 * How thick the solid is behind each triangle: the shape diameter function.
 *
 * From the middle of a triangle rays run inward within a cone, and end where they leave the solid.
 * Of their lengths those within one standard deviation of the median are averaged, the middle ones
 * counting more. A plate gives somewhat more than its thickness, because rays run aslant; with one
 * ray it gives just that. A triangle without area, or behind which nothing is, has an infinite
 * thickness. The mesh is taken as facing outwards.
 *
 * @param embree     the mesh
 * @param options    NULL for sf_embree_thickness_options_default()
 * @param task       NULL, or progress, cancel and threads
 * @param thickness  receives a number for each triangle, mm; on a cancel some of it
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options out of range; SF_ERR_CANCELLED;
 * SF_ERR_MEMORY.
 * @cost a microsecond for each ray.   @threads any; the task's hook may run any number of pieces at
 * once.
 * @source L. Shapira, A. Shamir, D. Cohen-Or, "Consistent mesh partitioning and skeletonisation
 * using the shape diameter function", 2008.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_embree_thickness(const sf_embree *embree,
                                                const sf_embree_thickness_options *options,
                                                sf_task *task, double *thickness);

/**
 * Fill a grid by rays along z: the same question as sf_grid_voxelize() of a closed mesh, by other
 * code.
 *
 * A voxel is solid where the surface winds around its centre at least once, counted along a ray
 * through all centres of a column, which lies a thousandth of a voxel aside; a mesh that encloses a
 * negative volume is turned. On a mesh that is not closed columns may leak.
 *
 * @param embree  the mesh
 * @param grid    what it held is lost; on failure it is as it was but for SF_ERR_CANCELLED, when it
 * is part filled
 * @param task    NULL, or progress and a cancel between rows
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost a microsecond for each column and hit.   @threads any, on distinct grids.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_embree_voxelize(const sf_embree *embree, sf_grid *grid,
                                               sf_task *task);

#ifdef __cplusplus
}
#endif

#endif
