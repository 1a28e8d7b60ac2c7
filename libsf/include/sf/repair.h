// SPDX-License-Identifier: MIT
// Repair: the least change that makes a shape support-free, by adding matter and by giving some up.
//
// Trim only removes, and loses a ball for want of one pillar; grow only adds, and builds a forest
// under what nobody would miss. A repair weighs the two, voxel by voxel, at prices of the caller's.
// The least of all repairs is out of reach (a set cover hides in it); what is made here is never
// dearer than a trim or a grow, and close to the least where that can be known: docs/repair.md has
// the figures.

#ifndef SF_REPAIR_H
#define SF_REPAIR_H

#include <sf/support.h>

#ifdef __cplusplus
extern "C" {
#endif

/** rounds: stop at the first result, without improving it. */
#define SF_REPAIR_FIRST UINT32_MAX

/** A cost that there is none of: what it would be the cost of is not possible. */
#define SF_REPAIR_NO_COST UINT64_MAX

/** How a repair is made. Fill with sf_repair_options_default(). */
typedef struct sf_repair_options {
    size_t struct_size;         /**< sizeof(sf_repair_options), set by the default */
    sf_terms terms;             /**< rule, bed and masks: `keep` is never removed, `forbid` never
                                     added, and nothing is changed outside `act` */
    const uint8_t *add_cost;    /**< of adding each voxel, 1..255, nz * ny * nx of them in (layer,
                                     y, x) order; NULL (default): 1 each */
    const uint8_t *remove_cost; /**< the same of removing it; NULL (default): 1 each */
    uint32_t min_feature_vx;    /**< added matter is made of squares of at least this many voxels
                                     each way, where there is room for them; 1 (default) asks
                                     nothing; at most SF_REACH_MAX */
    uint32_t rounds;            /**< most rounds of improvement from each start that is tried; 0
                                     (default): until one fails to improve; SF_REPAIR_FIRST: none */
} sf_repair_options;

/** What a repair did and what it cost. */
typedef struct sf_repair_report {
    uint64_t added_voxels;   /**< voxels added */
    uint64_t removed_voxels; /**< voxels removed */
    uint64_t cost;           /**< what that costs; 1 a voxel where no costs were given */
    uint64_t first_cost;     /**< cost of the first result, before any improvement */
    uint64_t trim_cost;      /**< cost of a trim; SF_REPAIR_NO_COST where it would remove what must
                                  stay */
    uint64_t grow_cost;      /**< cost of keeping all that can be kept, along the first forest;
                                  SF_REPAIR_NO_COST where that forest does not carry it all */
    uint64_t culprit_count;  /**< voxels that must stay and cannot: 0 unless it is infeasible */
    uint64_t peak_memory;    /**< most bytes of working memory at one time */
    uint32_t rounds;         /**< rounds of improvement that were made, over all starts */
    uint32_t bed_layer;      /**< the bed layer; SF_BED_AUTO when the grid holds no matter */
} sf_repair_report;

/**
 * Options of a repair: terms by default, every change costs 1, no least width, as good as it gets.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_repair_options sf_repair_options_default(void);

/**
 * Make a shape support-free at a low cost, in place.
 *
 * What must stay are the solid voxels of `keep` and those outside `act`; what may be added lies in
 * `act`, not in `forbid`, and not below the bed. Where all that must stay can be carried within
 * that, the result is support-free under the whole rule (bridges included), holds what must stay,
 * and costs no more than a trim, where a trim may be done, nor than keeping everything that can be
 * kept along the same supporters. A support-free shape is left as it is. The result was checked
 * before it was written.
 *
 * Nor does it cost more than what sf_grid_grow() makes under the same terms, with two exceptions: a
 * least width or SF_REPAIR_FIRST; and more than 2^26 voxels from the bed up, unless the first
 * result costs more than a 64th of the number of voxels that a trim removes.
 *
 * Nor does it cost more than the same repair with `keep` the whole shape, where that is possible,
 * with two exceptions: SF_REPAIR_FIRST, or a least width under slack or with bridges; and more than
 * four million voxels in the air.
 *
 * With a least width, additions are squares of that width whose chains of squares stand on squares
 * of what is kept; single voxels only where neither fits. Under slack such chains then take only
 * steps that use up no reach.
 *
 * @param grid       the shape, changed in place
 * @param options    terms, costs, width
 * @param allocator  for working memory: NULL for the C library's
 * @param task       NULL, or progress; a cancel is honoured at every layer of every sweep, and
 * within layers where one takes long; no report comes after it but that of the layer that was at
 * work
 * @param culprits   NULL, or a grid that is set, on SF_ERR_INFEASIBLE, to the voxels that must stay
 *                   and cannot; giving up just these, or exempting them, makes the rest possible
 * @param report     NULL, or where counts are left; on SF_ERR_INFEASIBLE only the number of
 *                   culprits, the bed and the memory are
 * @return SF_OK; SF_ERR_INFEASIBLE: what must stay cannot, and the shape is as it was;
 * SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, a cost of 0, a width outside
 * 1..SF_REACH_MAX, terms as in sf_grid_feasible(), one grid given twice; SF_ERR_SHAPE: grids that
 * differ in counts; SF_ERR_MEMORY; SF_ERR_OVERFLOW: a slice of 2^32 voxels or more, its border
 * included; SF_ERR_CANCELLED; SF_ERR_INTERNAL: the result failed its check, and the shape is as it
 * was.
 * @cost a few sweeps over the grid, 2 bytes for each voxel of the rectangles that the unsupported
 * matter reaches downward (4 under slack), and time by what is unsupported, a reach's area for each
 * voxel of it and again for each round; where grow is asked, what that costs. What could take
 * longer is bounded (docs/repair.md).
 * @threads one per grid.
 * @source a library's own; T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for
 * Fabrication", Eurographics 2016, for its two ends, trim and grow.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_repair(sf_grid *grid, const sf_repair_options *options,
                                           const sf_allocator *allocator, sf_task *task,
                                           sf_grid *culprits, sf_repair_report *report);

#ifdef __cplusplus
}
#endif

#endif
