// SPDX-License-Identifier: MIT
// Sampling: slices of a graded solid, straight from its smooth shape.
//
// No mesh of tetrahedra in between: a voxel is solid where its centre lies within the limit
// surface, cut finely enough, and its properties are those of the place that the centre is. Slices
// come in any order, one at a time, with the memory of one.

#ifndef SF_SAMPLE_H
#define SF_SAMPLE_H

#include <sf/base.h>
#include <sf/limit.h>
#include <sf/mesh.h>
#include <sf/tetra.h>
#include <sf/voxel.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Largest number of voxels of a lattice that is sampled: 2^40. */
#define SF_SAMPLE_VOXEL_MAX ((uint64_t)1 << 40)

/**
 * A box that holds the shape of a limit of dimension 3, and is hardly larger.
 *
 * @param limit      the limit
 * @param allocator  for scratch; NULL for the C library's
 * @param task       progress, cancel; NULL for none
 * @param low_mm     receives the lower corner
 * @param high_mm    receives the upper one: no side is farther from the shape than a thousandth of
 * the box's diagonal, unless the shape is very coarsely bent
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_UNSUPPORTED: a limit of dimension 2, or
 * one without a boundary; SF_ERR_OVERFLOW: a surface of too many triangles; SF_ERR_MEMORY;
 * SF_ERR_CANCELLED.
 * @cost a microsecond or two for each vertex of the surface.   @threads any, while nobody updates
 * the limit; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_limit_bounds(const sf_limit *limit, const sf_allocator *allocator,
                                            sf_task *task, double low_mm[3], double high_mm[3]);

/** How to sample. Make one with sf_sample_options_default(). */
typedef struct sf_sample_options {
    size_t struct_size; /**< sizeof(sf_sample_options), set by sf_sample_options_default() */
    double tolerance;   /**< how far the surface may be from the limit, as a share of the smallest
                             pitch, above 0 and at most 1; 0.05 */
} sf_sample_options;

/**
 * A twentieth of a voxel.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_sample_options sf_sample_options_default(void);

/** A solid on a lattice, ready to be sliced. */
typedef struct sf_sampler sf_sampler;

/**
 * Prepare a limit of dimension 3 to be sliced.
 *
 * @param limit          the limit; it must stay, and be as it is, while the sampler is used
 * @param lattice        where voxels lie, in the cage's frame; copied
 * @param options        NULL for the defaults
 * @param channel_count  how many properties are wanted; may be 0, at most SF_PROPERTY_MAX
 * @param channels       which ones
 * @param allocator      for the sampler and for scratch; NULL for the C library's
 * @param task           progress, cancel; NULL for none
 * @param sampler        receives the sampler
 * @param fault          NULL, or receives a sentence on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a lattice or option out of range, no such
 * property; SF_ERR_UNSUPPORTED: a limit of dimension 2 or without a boundary, a shape that lies
 * too far from the lattice's origin; SF_ERR_OVERFLOW: more than SF_SAMPLE_VOXEL_MAX voxels, or a
 * surface of too many triangles; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost a microsecond or two for each vertex of the surface; 40 MB for splines that are kept, and
 * as much for each further property that jumps.   @threads any, while nobody updates the limit; one
 * at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sampler_create(const sf_limit *limit, const sf_lattice *lattice,
                                              const sf_sample_options *options,
                                              size_t channel_count, const size_t *channels,
                                              const sf_allocator *allocator, sf_task *task,
                                              sf_sampler **sampler, sf_fault *fault);

/**
 * Prepare tetrahedra to be sliced: the way by which a file comes that holds no cage.
 *
 * A voxel is solid where the winding number of the tetrahedra's boundary about its centre is at
 * least one half, and has what is interpolated between the corners of the first tetrahedron that
 * holds its centre; where rounding leaves it in none, what the next voxel in its row has, or the
 * nearest tetrahedron. Slices are made as from a limit, by sf_sampler_slice().
 *
 * @param tets           the tetrahedra; they must stay, and be as they are, while the sampler is
 * used
 * @param lattice        where voxels lie, in their frame; copied
 * @param channel_count  how many properties are wanted; may be 0, at most SF_PROPERTY_MAX
 * @param channels       which ones
 * @param allocator      for the sampler and for scratch; NULL for the C library's
 * @param sampler        receives the sampler
 * @param fault          NULL, or receives a sentence on failure
 * @return as sf_sampler_create(), but never SF_ERR_CANCELLED.
 * @cost linear in tetrahedra and layers.   @threads any; one at a time for each allocator.
 * @source C. Altenhofen and others, "Continuous property gradation for multi-material 3D-printed
 * objects", 2018, "Volumetric slicing", with properties interpolated within tetrahedra.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sampler_of_tets(const sf_tets *tets, const sf_lattice *lattice,
                                               size_t channel_count, const size_t *channels,
                                               const sf_allocator *allocator, sf_sampler **sampler,
                                               sf_fault *fault);

/**
 * Free a sampler.
 *
 * @param sampler  the sampler, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this sampler.
 * @since 0.1
 */
SF_API void sf_sampler_destroy(sf_sampler *sampler);

/**
 * The surface by which voxels are solid: closed triangles, outwards.
 *
 * @param sampler   the sampler; NULL gives a view of nothing
 * @param error_mm  NULL, or receives how far it may be from the limit surface, mm
 * @return a view, valid until the sampler is destroyed.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_mesh_view sf_sampler_surface(const sf_sampler *sampler, double *error_mm);

/** What became of the voxels of all slices so far. */
typedef struct sf_sample_report {
    uint64_t solid;   /**< solid voxels */
    uint64_t located; /**< of these, searched for instead of found from their neighbours */
    uint64_t filled;  /**< of these, that have a neighbour's properties: they lie within the surface
                           and not within the shape */
} sf_sample_report;

/**
 * A slice.
 *
 * The same bytes whichever slices were asked for before.
 *
 * @param sampler  the sampler
 * @param k        which layer
 * @param solid    of the lattice's nx and ny: receives what is solid
 * @param values   channel_count planes of nx * ny numbers, rows one after the other: receive the
 *                 properties of solid voxels, and 0 elsewhere; may be NULL where there are none
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such layer; SF_ERR_SHAPE: a slice of another
 * size; SF_ERR_MEMORY.
 * @cost a third of a microsecond for each solid voxel; of tetrahedra a tenth for each of those that
 * the slice meets.   @threads one for each sampler.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sampler_slice(sf_sampler *sampler, uint32_t k, sf_slice solid,
                                             double *const *values);

/**
 * What became of the voxels so far.
 *
 * @param sampler  the sampler
 * @param report   receives the report
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer.
 * @cost constant.   @threads any, while nobody slices.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sampler_report(const sf_sampler *sampler, sf_sample_report *report);

#ifdef __cplusplus
}
#endif

#endif
