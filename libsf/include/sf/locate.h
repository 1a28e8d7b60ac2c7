// SPDX-License-Identifier: MIT
// Locating: from a point in space to the place of a shape that lies there.
//
// The inverse of <sf/limit.h>: whoever has a point in millimetres, of a voxel or under a pen, finds
// the piece and the parameters, and by these every property.

#ifndef SF_LOCATE_H
#define SF_LOCATE_H

#include <sf/base.h>
#include <sf/limit.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The piece of a place that there is not. */
#define SF_NO_PIECE UINT32_MAX

/** What it takes to find places: boxes around all pieces. */
typedef struct sf_locator sf_locator;

/**
 * Prepare a limit of dimension 3 for searches.
 *
 * @param limit      the limit; it must stay, and its positions as they are, while the locator is
 * used
 * @param allocator  for the locator and for scratch; NULL for the C library's
 * @param locator    receives the locator
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_UNSUPPORTED: a limit of dimension 2;
 * SF_ERR_MEMORY.
 * @cost a microsecond for each piece.   @threads any, while nobody updates the limit; one at a time
 * for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_locator_create(const sf_limit *limit, const sf_allocator *allocator,
                                              sf_locator **locator);

/**
 * Free a locator.
 *
 * @param locator  the locator, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this locator.
 * @since 0.1
 */
SF_API void sf_locator_destroy(sf_locator *locator);

/**
 * Find the places of points.
 *
 * Of a point within the shape the place found lies within 1e-10 of the cage's diagonal of it. Where
 * the shape overlaps itself it is any of them. Of a point outside the place found is near to the
 * nearest one, if that is within reach. Where cells are folded flat, so that endlessly many places
 * are equally near, the search ends after a hundred thousand tries: with the nearest seen, or none.
 *
 * @param locator    the locator
 * @param count      how many points; may be 0
 * @param points     3 numbers of each, mm, finite
 * @param reach_mm   how far outside of the shape a point may be, 0 and more
 * @param allocator  for scratch; NULL for the C library's
 * @param task       threads; NULL for none; once begun it is not cancelled
 * @param places     receives the places; their piece is SF_NO_PIECE where none is within reach
 * @param distances  NULL, or receives how far from the points they lie, mm; infinite where there is
 *                   none
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a reach that is no number of 0 or more, a point
 * that is not finite; SF_ERR_MEMORY; SF_ERR_CANCELLED: the task was cancelled before.
 * @cost some ten microseconds for each point; hundreds close to what is irregular, or outside
 * within reach; some hundreds of milliseconds at worst, where cells are folded flat.
 * @threads any, while nobody updates the limit; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_locator_find(const sf_locator *locator, size_t count,
                                            const double *points, double reach_mm,
                                            const sf_allocator *allocator, sf_task *task,
                                            sf_place *places, double *distances);

#ifdef __cplusplus
}
#endif

#endif
