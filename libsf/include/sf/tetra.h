// SPDX-License-Identifier: MIT
// Tetrahedra with properties: what simulations and exchange files are made of.
//
// Either somebody's, read from a file; or implicit in a refined cage: one step of refinement has a
// point for each point, edge, face and cell of the step before, and wherever a point, an edge, a
// face and a cell lie in each other, their four points are a tetrahedron. Nothing is meshed for
// that, the tetrahedra conform by themselves, and they follow when the cage changes.

#ifndef SF_TETRA_H
#define SF_TETRA_H

#include <sf/base.h>
#include <sf/grid.h>
#include <sf/property.h>
#include <sf/refine.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Tetrahedra in somebody's arrays. */
typedef struct sf_tets_view {
    size_t point_count;         /**< at most 2^31 - 1 */
    const double *positions;    /**< x, y, z of each point, mm */
    size_t tet_count;           /**< at most 2^29 - 1 */
    const uint32_t *corners;    /**< four points each; the second, third and fourth are
                                     counter-clockwise seen from the first's other side, so that
                                     (b - a) x (c - a) . (d - a) is above 0 */
    size_t channel_count;       /**< properties */
    const sf_channel *channels; /**< their indices are of tetrahedra's corners, in this order */
} sf_tets_view;

/** Tetrahedra that own their arrays, or follow a refinement. */
typedef struct sf_tets sf_tets;

/**
 * Make tetrahedra of somebody's arrays, which are copied.
 *
 * Those that are inverted or flat are taken all the same: sf_tets_check() counts them.
 *
 * @param view       the arrays
 * @param allocator  for the tetrahedra; NULL for the C library's
 * @param tets       receives the tetrahedra
 * @param fault      NULL, or receives a sentence that names the first tetrahedron, point or
 * property at fault
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no points or tetrahedra, an index out of range, a
 * point twice in one tetrahedron, a coordinate that is not finite or beyond 10^12 mm, a property
 * that cannot be (as sf_cage_create()); SF_ERR_OVERFLOW: too many; SF_ERR_MEMORY.
 * @cost linear.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_tets_create(const sf_tets_view *view, const sf_allocator *allocator,
                                           sf_tets **tets, sf_fault *fault);

/**
 * The tetrahedra of a refined cage of dimension 3: six for each cell of a step.
 *
 * Their positions and values are those of the refinement, and change with it. Tetrahedron t lies in
 * cell t / 6 of the step.
 *
 * @param refinement  the refinement; it must stay while the tetrahedra are used
 * @param step        1 to the number of steps
 * @param allocator   for the tetrahedra; NULL for the C library's
 * @param tets        receives the tetrahedra
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a step that there is not; SF_ERR_UNSUPPORTED: a
 * refinement of dimension 2; SF_ERR_OVERFLOW: too many; SF_ERR_MEMORY.
 * @cost linear; 96 bytes for each cell, as much again for each property that jumps.   @threads any;
 * one at a time for each allocator.
 * @source C. Altenhofen and others, "Continuous property gradation for multi-material 3D-printed
 * objects", 2018, "Implicit tetrahedrization".
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_tets_of_refinement(const sf_refinement *refinement, uint32_t step,
                                                  const sf_allocator *allocator, sf_tets **tets);

/**
 * Free tetrahedra.
 *
 * @param tets  the tetrahedra, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with these tetrahedra.
 * @since 0.1
 */
SF_API void sf_tets_destroy(sf_tets *tets);

/**
 * View of tetrahedra.
 *
 * @param tets  the tetrahedra; NULL gives a view of nothing
 * @return a view, valid until they are destroyed, and the refinement, if they follow one; of
 * nothing for NULL.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_tets_view sf_tets_get_view(const sf_tets *tets);

/**
 * Change values of a property of tetrahedra that own theirs.
 *
 * @param tets     the tetrahedra
 * @param channel  which property
 * @param first    the first value
 * @param count    how many; may be 0
 * @param values   the values; not in their own arrays
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, values that there are not, one that is not finite
 * or lies outside the property's bounds; SF_ERR_UNSUPPORTED: they follow a refinement, which is to
 * be changed instead.
 * @cost O(count).   @threads one for these tetrahedra.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_tets_set_values(sf_tets *tets, size_t channel, size_t first,
                                               size_t count, const double *values);

/**
 * The tetrahedra of a grid's solid voxels: six for each, around the diagonal from its low corner.
 *
 * They conform, and fill the voxels exactly. They have one property, which is 0 everywhere, or what
 * of its bounds is nearest to 0: sf_tets_spread() gives it values.
 *
 * @param grid       the voxels
 * @param property   the property
 * @param allocator  for the tetrahedra and for scratch; NULL for the C library's
 * @param tets       receives the tetrahedra, which own their arrays
 * @param fault      NULL, or receives a sentence on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a grid without solid voxels; SF_ERR_OVERFLOW:
 * more than there are numbers for; SF_ERR_MEMORY; what sf_tets_create() says.
 * @cost two passes over the grid; 96 bytes for each voxel and 24 for each point, twice for a while.
 * @threads any; one at a time for each allocator.
 * @source H. W. Kuhn, "Some combinatorial lemmas in topology", 1960.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_tets_of_grid(const sf_grid *grid, const sf_property *property,
                                            const sf_allocator *allocator, sf_tets **tets,
                                            sf_fault *fault);

/** What sf_tets_spread() did. */
typedef struct sf_spread_report {
    size_t fixed;        /**< points that kept their values */
    uint32_t iterations; /**< of the solver */
    double residual;     /**< what is left of the largest force on a free point, as a part of the
                              largest at the start */
} sf_spread_report;

/**
 * Spread a property from some points over all others, harmonically: as heat would settle.
 *
 * Each free point gets the value at which the flow of Laplace's equation, by linear elements, is
 * even; so a property that is linear where it is fixed is linear everywhere, and none lies outside
 * of what is fixed (flat tetrahedra could overshoot, and are held to it). A part that hangs
 * together with no fixed point becomes one value, about what it had in the mean. Values of points
 * are meant: a property that jumps is refused.
 *
 * @param tets       tetrahedra that own their arrays
 * @param channel    which property
 * @param fixed      for each point: not 0 where its value stays
 * @param allocator  for scratch, 48 bytes a tetrahedron and 32 a point; NULL for the C library's
 * @param task       NULL, or cancel; nothing has changed then
 * @param report     NULL, or receives what was done
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such property, no fixed point;
 * SF_ERR_UNSUPPORTED: tetrahedra of a refinement, a property that jumps; SF_ERR_INFEASIBLE: it did
 * not settle, because tetrahedra are too flat; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost some hundred passes over the tetrahedra: the more the finer they are.   @threads one for
 * these tetrahedra; one at a time for each allocator.
 * @source R. Courant, "Variational methods for the solution of problems of equilibrium and
 * vibrations", 1943; M. Hestenes, E. Stiefel, "Methods of conjugate gradients for solving linear
 * systems", 1952.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_tets_spread(sf_tets *tets, size_t channel, const uint8_t *fixed,
                                           const sf_allocator *allocator, sf_task *task,
                                           sf_spread_report *report);

/** What sf_tets_check() finds. */
typedef struct sf_tets_report {
    double volume_mm3;     /**< of all, those of inverted ones subtracted */
    size_t inverted;       /**< tetrahedra whose volume is not above 0 */
    size_t first_inverted; /**< the first of them; the number of tetrahedra where there is none */
    size_t boundary_faces; /**< faces of one tetrahedron */
    size_t crowded_faces;  /**< faces of more than two, or of two on the same side */
} sf_tets_report;

/**
 * Look at tetrahedra: their volumes, and whether they conform.
 *
 * @param tets       the tetrahedra
 * @param allocator  for scratch; NULL for the C library's
 * @param report     receives what was found
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_MEMORY.
 * @cost sorting the faces.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_tets_check(const sf_tets *tets, const sf_allocator *allocator,
                                          sf_tets_report *report);

#ifdef __cplusplus
}
#endif

#endif
