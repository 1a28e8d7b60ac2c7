// SPDX-License-Identifier: MIT
// Complete: within a support-free shape, a support-free part that holds all that must stay.
//
// It adds to what must stay the supports that it needs, taken from the shape. With V the shape, F
// what must stay and V' the result:
//
//     F within V' within V,    V' is support-free,    V' = F just when F is support-free
//
// for every rule of <sf/rule.h>, with bridges and with exempt voxels. There is no least V', and the
// smallest is a set cover, which is hard.

#ifndef SF_PRESERVE_H
#define SF_PRESERVE_H

#include <sf/support.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * A support-free part of a shape that holds what must stay.
 *
 * From the top down, each layer asks the one below for what its voxels need: first of what must
 * stay there anyway, then of as few others as a greedy set cover finds. Of equals the lowest row
 * is taken, and in it the lowest x.
 *
 * @param shape      support-free, apart from exempt voxels
 * @param needed     what must stay, within the shape
 * @param terms      rule, bed layer and exempt voxels; the other masks are not looked at. With
 *                   SF_BED_AUTO the bed is the first layer that holds matter in `shape`
 * @param allocator  for working memory: a grid, a dozen slices, 4 bytes for each voxel of a slice,
 *                   and under slack 4 * sqrt(nz) + 4 slices with a byte for each; NULL for the C
 *                   library's
 * @param task       NULL, or progress per slice; a cancel is honoured at every slice
 * @param result     of the same counts, and neither of the other grids nor a mask
 * @return SF_OK; SF_ERR_INFEASIBLE: `needed` is not within `shape`, or `shape` is not support-free
 * (sf_grid_feasible(shape, shape, ...) names the voxels); SF_ERR_ARGUMENT, SF_ERR_SHAPE,
 * SF_ERR_MEMORY, SF_ERR_CANCELLED: as sf_grid_feasible().
 * @cost some twenty passes over the grid, under slack five trims, and for each voxel that may carry
 * what hangs the element and a few steps of a heap. 512^3 under box3: 60 ms.
 * @threads any that write distinct results.
 * @source P. Slavik, "A tight analysis of the greedy algorithm for set cover", 1996 (greedy); that
 * one sweep serves every monotone rule is the library's own.
 * @since 0.2
 */
SF_API SF_CHECKED sf_status sf_grid_complete(const sf_grid *shape, const sf_grid *needed,
                                             const sf_terms *terms, const sf_allocator *allocator,
                                             sf_task *task, sf_grid *result);

#ifdef __cplusplus
}
#endif

#endif
