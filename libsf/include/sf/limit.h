// SPDX-License-Identifier: MIT
// Limits: the smooth shape that a cage stands for, at any place of it.
//
// Refinement comes closer to a shape with every step; here is the shape itself. Its places are
// named by pieces: those that one step of refinement cuts the cells into, one for each corner, all
// of them hexahedra (in dimension 2 quadrilaterals), and parameters from 0 to 1 along the piece's
// axes. Most pieces are regular, and the shape over them is a tri-cubic spline; over the others it
// is as many splines as one likes, ever smaller ones towards what is irregular. Positions and
// properties are both functions of the place; where neighbours disagree on a property, each piece
// has its own side of the jump.

#ifndef SF_LIMIT_H
#define SF_LIMIT_H

#include <sf/base.h>
#include <sf/cage.h>
#include <sf/refine.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A place of the shape. */
typedef struct sf_place {
    uint32_t piece; /**< piece j of a cell: the cell's first corner's place in `corners`, plus j */
    double u[3];    /**< 0 to 1 along the piece's axes; in dimension 2 the third is not looked at */
} sf_place;

/** A cage with all that evaluation needs. */
typedef struct sf_limit sf_limit;

/**
 * Prepare a cage for evaluation.
 *
 * @param cage       the cage, not needed any more afterwards
 * @param rules      which rules inside
 * @param allocator  for the limit and for scratch; NULL for the C library's
 * @param task       progress, cancel; NULL for none
 * @param limit      receives the limit
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, rules that there are not; SF_ERR_OVERFLOW: more
 * points or corners than SF_CAGE_POINT_MAX after one step; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost some 10 microseconds for each piece, and a millisecond for each kind of irregular
 * neighbourhood; where n cells meet in a point or an edge time and memory grow with n^2: a thousand
 * take a tenth of a second, four thousand two seconds and 200 MB.   @threads any; one at a time for
 * each allocator.
 * @source as sf_refine(); the left eigenvectors after M. Halstead, M. Kass, T. DeRose, "Efficient,
 * fair interpolation using Catmull-Clark surfaces", 1993; what comes of irregular cells after
 * J. Stam, "Exact evaluation of Catmull-Clark subdivision surfaces at arbitrary parameter values",
 * 1998, without his eigenvalues: by going down.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_limit_create(const sf_cage *cage, sf_refine_rules rules,
                                            const sf_allocator *allocator, sf_task *task,
                                            sf_limit **limit);

/**
 * Free a limit.
 *
 * @param limit  the limit surface, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this limit.
 * @since 0.1
 */
SF_API void sf_limit_destroy(sf_limit *limit);

/**
 * Number of pieces: that of the corners of all cells; 0 for NULL.
 *
 * @param limit  the limit surface; NULL has none
 * @return the number.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API size_t sf_limit_piece_count(const sf_limit *limit);

/**
 * The place at parameters of a whole cell of the cage: a hexahedron, in dimension 2 a
 * quadrilateral.
 *
 * @param limit  the limit
 * @param cell   the cell
 * @param u      0 to 1 along the axes from its first corner to its second, fourth and fifth; in
 *               dimension 2 the third is not looked at
 * @param place  receives the place
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such cell, parameters outside of it;
 * SF_ERR_UNSUPPORTED: a cell of another kind, which has no axes: name its pieces.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_limit_place(const sf_limit *limit, size_t cell, const double u[3],
                                           sf_place *place);

/**
 * Where places lie.
 *
 * Parameters a little outside of 0 to 1, by 1e-9, are taken for those of the border. On an
 * irregular edge or point derivatives by parameters tend to 0 or grow without bound; there they are
 * those over a millionth of a piece next to it.
 *
 * @param limit        the limit
 * @param count        how many places; may be 0
 * @param places       the places
 * @param allocator    for scratch; NULL for the C library's
 * @param task         threads; NULL for none; once begun it is not cancelled
 * @param positions    receives 3 numbers of each, mm
 * @param derivatives  NULL, or receives 9 of each, in dimension 2 6: of x by each parameter, then
 * of y, then of z
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a place that there is not; SF_ERR_MEMORY;
 * SF_ERR_CANCELLED.
 * @cost a third of a microsecond in regular pieces; elsewhere some 5 for each level, of which
 * random places need one or two and the worst ones 48.   @threads any, while nobody updates; one at
 * a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_limit_positions(const sf_limit *limit, size_t count,
                                               const sf_place *places,
                                               const sf_allocator *allocator, sf_task *task,
                                               double *positions, double *derivatives);

/**
 * What a property is at places.
 *
 * @param limit        the limit
 * @param channel      which property
 * @param count        how many places; may be 0
 * @param places       the places
 * @param allocator    for scratch; NULL for the C library's
 * @param task         threads; NULL for none; once begun it is not cancelled
 * @param values       receives a number of each
 * @param derivatives  NULL, or receives 3 of each, in dimension 2 2: by each parameter
 * @return as sf_limit_positions(); SF_ERR_ARGUMENT also: no such property.
 * @cost, @threads as sf_limit_positions().
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_limit_values(const sf_limit *limit, size_t channel, size_t count,
                                            const sf_place *places, const sf_allocator *allocator,
                                            sf_task *task, double *values, double *derivatives);

/** What sf_limit_check() finds. */
typedef struct sf_limit_report {
    size_t positive;       /**< pieces that are proved to lie the right way out everywhere */
    size_t inverted;       /**< pieces of which a part lies inside out */
    size_t first_inverted; /**< the first of these; the number of pieces where there is none */
    size_t open; /**< the others: next to what is irregular nothing can be proved, and where
                      a piece is hardly bent the right way the proof may be too coarse */
} sf_limit_report;

/**
 * Look whether a shape of dimension 3 lies the right way out everywhere.
 *
 * @param limit      the limit
 * @param allocator  for scratch; NULL for the C library's
 * @param task       progress, cancel; NULL for none
 * @param report     receives what was found
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_UNSUPPORTED: a limit of dimension 2;
 * SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost 50 microseconds for a regular piece, up to some milliseconds for others.   @threads any,
 * while nobody updates; one at a time for each allocator.
 * @source A. Johnen, J.-F. Remacle, C. Geuzaine, "Geometrical validity of curvilinear finite
 * elements", 2013.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_limit_check(const sf_limit *limit, const sf_allocator *allocator,
                                           sf_task *task, sf_limit_report *report);

/**
 * Take new positions from the cage.
 *
 * @param limit      the limit
 * @param positions  3 for each of the cage's points, mm, finite and within 10^12
 * @param task       threads; NULL for none; is not cancelled
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a position that cannot be.
 * @cost one step of refinement.   @threads one for each limit.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_limit_update_positions(sf_limit *limit, const double *positions,
                                                      sf_task *task);

/**
 * Take new values of a property from the cage.
 *
 * @param limit    the limit
 * @param channel  which property
 * @param values   as many as the property has in the cage, finite and within its bounds
 * @param task     threads; NULL for none; is not cancelled
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such property, a value that it does not allow.
 * @cost one step of refinement.   @threads one for each limit.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_limit_update_values(sf_limit *limit, size_t channel,
                                                   const double *values, sf_task *task);

#ifdef __cplusplus
}
#endif

#endif
