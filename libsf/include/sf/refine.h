// SPDX-License-Identifier: MIT
// Refinement: a cage cut finer, step by step, towards the smooth shape that it stands for.
//
// Each step cuts every cell into one piece for each of its corners and moves all points by fixed
// weights: positions and properties alike. The weights depend on how cells hang together and on
// what is sharp, not on where points are. So they are worked out once, as sparse matrices; when
// positions or values change, the matrices are applied again.

#ifndef SF_REFINE_H
#define SF_REFINE_H

#include <sf/base.h>
#include <sf/cage.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Largest number of steps. */
#define SF_REFINE_STEP_MAX 12u

/** Which weights points inside of a solid get. */
typedef enum sf_refine_rules {
    SF_REFINE_STANDARD = 0, /**< Joy and MacCracken's everywhere */
    SF_REFINE_SEPARABLE = 1 /**< where the cage is extruded along a line that other than four cells
                                 go around, the cross section is as the surface of that outline */
} sf_refine_rules;

/** How to refine. Make one with sf_refine_options_default(). */
typedef struct sf_refine_options {
    size_t struct_size;    /**< sizeof(sf_refine_options), set by sf_refine_options_default() */
    uint32_t steps;        /**< 1 to SF_REFINE_STEP_MAX; 1 */
    sf_refine_rules rules; /**< SF_REFINE_STANDARD */
} sf_refine_options;

/**
 * One step, by the standard rules.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_refine_options sf_refine_options_default(void);

/** A cage and what it is after each of some steps. */
typedef struct sf_refinement sf_refinement;

/**
 * Refine a cage.
 *
 * After a step the points are those of the points before, of the edges, of the faces and of the
 * cells, in that order. Pieces of one cell follow each other; piece j holds the cell's corner j,
 * as its own corner j where the cell is a hexahedron (in dimension 2 a quadrilateral), so that axes
 * are kept, and as its first corner else. Where neighbours name different values of a property at
 * their corners, each side is refined by itself, as if it ended there: the property jumps there,
 * exactly.
 *
 * @param cage       the cage, not needed any more afterwards
 * @param options    NULL for the defaults
 * @param allocator  for the refinement and for scratch; NULL for the C library's
 * @param task       progress, cancel, threads; NULL for none
 * @param refinement receives the refinement
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, steps or rules that there are not;
 * SF_ERR_OVERFLOW: more points or corners than SF_CAGE_POINT_MAX; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost a step eight times as much as the one before; memory likewise.   @threads any; one at a
 * time for each allocator.
 * @source K. I. Joy, R. MacCracken, "The refinement rules for Catmull-Clark solids", 1999;
 * E. Catmull, J. Clark, "Recursively generated B-spline surfaces on arbitrary topological meshes",
 * 1978; T. DeRose, M. Kass, T. Truong, "Subdivision surfaces in character animation", 1998; C.
 * Altenhofen and others, "Continuous property gradation for multi-material 3D-printed objects",
 * 2018.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_refine(const sf_cage *cage, const sf_refine_options *options,
                                      const sf_allocator *allocator, sf_task *task,
                                      sf_refinement **refinement);

/**
 * Free a refinement.
 *
 * @param refinement  the refinement, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this refinement.
 * @since 0.1
 */
SF_API void sf_refinement_destroy(sf_refinement *refinement);

/**
 * The cage after some steps.
 *
 * Its channels have indices where neighbours' values differ somewhere, also where the cage's own
 * indices make no difference.
 *
 * @param refinement  the refinement
 * @param step        0, the cage itself, to the number of steps
 * @param view        receives the view, valid until the refinement is destroyed; its values change
 *                    with updates
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a step that there is not.
 * @cost constant.   @threads any, while nobody updates.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_refinement_get_view(const sf_refinement *refinement, uint32_t step,
                                                   sf_cage_view *view);

/**
 * Take new positions from the cage through all steps.
 *
 * @param refinement  the refinement
 * @param positions   3 for each of the cage's points, mm, finite and within 10^12; not the
 *                    refinement's own
 * @param task        threads; NULL for none; is not cancelled
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a position that cannot be.
 * @cost some 15 products for each new point and coordinate.   @threads one for each refinement.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_refinement_update_positions(sf_refinement *refinement,
                                                           const double *positions, sf_task *task);

/**
 * Take new values of a property from the cage through all steps.
 *
 * @param refinement  the refinement
 * @param channel     which property
 * @param values      as many as the property has in the cage, finite and within its bounds; not the
 *                    refinement's own
 * @param task        threads; NULL for none; is not cancelled
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such property, a value that it does not allow.
 * @cost some 15 products for each new value.   @threads one for each refinement.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_refinement_update_values(sf_refinement *refinement, size_t channel,
                                                        const double *values, sf_task *task);

/**
 * How a point's position depends on the cage: as weights of the cage's points, above 0, that sum
 * to 1.
 *
 * @param refinement  the refinement
 * @param step        0 to the number of steps
 * @param point       a point after that step
 * @param allocator   for scratch; NULL for the C library's
 * @param capacity    places in points and weights
 * @param points      receives the cage's points
 * @param weights     receives their weights
 * @param count       receives their number, also with SF_ERR_CAPACITY
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer (points and weights may be NULL with a capacity of
 * 0), a step or point that there is not; SF_ERR_CAPACITY; SF_ERR_MEMORY.
 * @cost the points that it depends on, at each step; scratch of a number for each point of the
 * step.
 * @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_refinement_stencil(const sf_refinement *refinement, uint32_t step,
                                                  size_t point, const sf_allocator *allocator,
                                                  size_t capacity, uint32_t *points,
                                                  double *weights, size_t *count);

#ifdef __cplusplus
}
#endif

#endif
