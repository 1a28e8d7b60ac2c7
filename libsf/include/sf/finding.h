// SPDX-License-Identifier: MIT
// More about what is wrong with a shape: what each finding of a check costs to fix, which ones to
// look at first, and the voids that hold what they should not.
//
// A check names the places that are not supported (sf_finding, in <sf/support.h>). Each can be
// fixed in two ways: by taking away all that is lost there, which is its volume, or by growing
// something below it to stand on. sf_findings_cost() says what either takes in voxels, and
// sf_findings_rank() puts the dearest first. The costs are an array beside the findings, because
// the cause of a finding is an index.
//
// A shape may print without supports and be wrong all the same: resin or powder that is shut in
// cannot leave, and a hollow that closes against the film of a resin printer is a suction cup.
// sf_grid_voids() names both.

#ifndef SF_FINDING_H
#define SF_FINDING_H

#include <sf/support.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Cost of a finding
// ---------------------------------------------------------------------------------------------

/** grow_voxels of a finding that no growth can fix. */
#define SF_COST_NONE UINT64_MAX

/** What fixing a finding takes, in voxels. */
typedef struct sf_finding_cost {
    uint64_t trim_voxels; /**< taken away by a trim: the volume of the finding */
    uint64_t grow_voxels; /**< added below the finding's region so that all of it is carried */
} sf_finding_cost;

/**
 * What fixing each finding of a check costs: voxels that a trim takes, voxels that growing adds.
 *
 * grow_voxels is the size of a set of voxels that fixes the finding: once it is added every voxel
 * of the finding's region is carried, and every voxel of the set by another or by the shape as
 * drawn, down to the bed. So with the sets of all findings added the whole shape is support-free,
 * and the sum of the costs bounds what repair by growth alone adds. The set is found greedily, so
 * the figure is an upper bound; it is least where a region is one voxel and the rule is box3,
 * octagon or disk. Matter below counts as a place to stand on even where it is lost itself: what it
 * needs is the cost of its own finding.
 *
 * Under slack the chains count on no reach but that of the step itself, and no rule's chains make
 * use of bridges; both make the figure larger, never wrong.
 *
 * @param grid           the shape
 * @param terms          rule and bed layer that the check had; voxels of `forbid`, and those
 *                       outside `act`, are not added; `exempt` and `keep` are not looked at
 * @param findings       what sf_grid_check() found in this shape, from its first finding on
 * @param finding_count  how many; may be fewer than the check found
 * @param allocator      for working memory: two bytes for each voxel below the last finding, a few
 *                       slices, and what the largest region needs; NULL for the C library's
 * @param task           NULL, or progress per slice; a cancel is honoured at every slice
 * @param costs          finding_count places
 * @param added          NULL, or a grid that is set to all voxels that the sets hold together;
 *                       neither the shape nor a mask
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, terms without their struct_size, a bed layer that
 * the grid has not, a rule that does not serve all its layers, findings that are not those of a
 * check of this shape on these terms; SF_ERR_SHAPE: grids that differ in counts; SF_ERR_OVERFLOW;
 * SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost 4 * reach passes over two bytes a voxel, and for each finding its region and what stands
 * below it, not the rectangles around them, times the element and the logarithm of their sizes.
 * @threads any; the grids but `added` are only read.
 * @source the costs are the closest supporting paths of T. Reiner, S. Lefebvre, "Interactive
 * Modeling of Support-free Shapes for Fabrication", Eurographics 2016, section 2.2, without the
 * distance to the ground; V. Chvatal, "A Greedy Heuristic for the Set-Covering Problem", 1979.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_findings_cost(const sf_grid *grid, const sf_terms *terms,
                                             const sf_finding *findings, size_t finding_count,
                                             const sf_allocator *allocator, sf_task *task,
                                             sf_finding_cost *costs, sf_grid *added);

/**
 * Order of findings by what they cost to fix: the dearest first.
 *
 * The cost to fix a finding is the lesser of its two; of equal costs those come first that no other
 * finding causes, then those with the lower index.
 *
 * @param findings       the findings; may be NULL where there are none, as may the two others
 * @param costs          their costs, or NULL
 * @param finding_count  how many, at most UINT32_MAX
 * @param order          finding_count places, or NULL: order[0] is the index of the dearest finding
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer where there are findings; SF_ERR_OVERFLOW: too
 * many findings.
 * @cost n log n; no memory.   @threads any that write to distinct arrays.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_findings_rank(const sf_finding *findings,
                                             const sf_finding_cost *costs, size_t finding_count,
                                             uint32_t *order);

// ---------------------------------------------------------------------------------------------
// Voids
// ---------------------------------------------------------------------------------------------

/** What is wrong with a void. */
typedef enum sf_void_kind {
    SF_VOID_TRAP = 0, /**< closed for good: what is in it cannot leave */
    SF_VOID_CUP = 1   /**< closed against the film while its layers print, and open later */
} sf_void_kind;

/**
 * A void that has no way out but, if any, upwards.
 *
 * Voids are connected through faces (6 neighbours): what flows passes no edge and no corner, and so
 * the walls that hold it may be connected by edges and corners (26 neighbours).
 *
 * Let E_k be the empty voxels of the layers from the bed to k. A component of E_k is sealed when it
 * touches neither a side of the grid nor, where that is open, the bed: its only way out is the
 * plane of layer k, which in a resin printer lies at the film, so that pulling the part off works
 * against a vacuum. The voids are the largest of these sets, over all k: those that lie in no other
 * one. A void is a trap where all above its last layer is solid, so that it stays shut, and a cup
 * where the next layer joins it to the outside, or where there is none.
 */
typedef struct sf_void {
    sf_void_kind kind;   /**< trap or cup */
    uint32_t vent_layer; /**< layer that joins it to the outside; the number of layers where only
                              the end of the print does; UINT32_MAX for a trap */
    uint64_t volume;     /**< voxels */
    uint64_t area; /**< most voxels of one layer that were sealed in one: what the film pulls at */
    sf_box box;    /**< smallest box around it; where z0 is the bed layer, it also opens once the
                        part is off the bed */
} sf_void;

/** Counts of voids; exact whatever fits where. */
typedef struct sf_voids_report {
    uint64_t trap_count, trap_voxels; /**< of all traps */
    uint64_t cup_count, cup_voxels;   /**< of those that are not small */
    uint64_t small_cup_count;         /**< cups below cup_area_min or cup_layers_min */
    uint64_t voids_dropped;           /**< traps, and cups that are not small, without a place */
    uint32_t bed_layer;               /**< the bed layer; SF_BED_AUTO when there is no matter */
} sf_voids_report;

/** How voids are looked for. Fill with sf_voids_options_default(). */
typedef struct sf_voids_options {
    size_t struct_size;      /**< sizeof(sf_voids_options), set by the default */
    uint32_t bed_layer;      /**< layer that rests on the bed, or SF_BED_AUTO (default); what lies
                                  below is not looked at */
    int bed_is_open;         /**< 0 (default): the bed closes what is open towards it; 1: it does
                                  not, as in a box of powder, or once the part is off the bed */
    uint64_t cup_area_min;   /**< cups of a smaller area are small; 0 by default */
    uint32_t cup_layers_min; /**< cups of fewer layers are small; 0 by default */
    sf_void *voids;          /**< the caller's array, or NULL for counts only (default) */
    size_t void_capacity;    /**< places in it */
} sf_voids_options;

/**
 * Options of a search for voids: a closed bed, chosen by the shape itself, and counts only.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_voids_options sf_voids_options_default(void);

/**
 * Find the traps of a shape, and the cups that it makes while it prints.
 *
 * Outside the grid, at its sides and above it, all is empty and open. Voids are listed by the last
 * layer that they have voxels in, and within it by the first of these in row order; a shorter array
 * holds the first of them. After a failing call the array is as it was.
 *
 * @param grid        the shape
 * @param options     bed, thresholds, array
 * @param allocator   for working memory: a slice, the runs of empty voxels of two layers, one
 *                    record for each component that the latest layer has, and as many voids as are
 *                    listed; NULL for the C library's
 * @param task        NULL, or progress per slice; a cancel is honoured at every slice
 * @param report      the counts
 * @param void_count  voids in the caller's array; may be NULL
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, a bed layer
 * that the grid has not, a capacity without an array; SF_ERR_OVERFLOW; SF_ERR_MEMORY;
 * SF_ERR_CANCELLED.
 * @cost one pass over the grid, and nearly linear in the runs of empty voxels.
 * @threads any; the grid is only read.
 * @source R. E. Tarjan, "Efficiency of a Good But Not Linear Set Union Algorithm", 1975.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_voids(const sf_grid *grid, const sf_voids_options *options,
                                          const sf_allocator *allocator, sf_task *task,
                                          sf_voids_report *report, size_t *void_count);

/** A search for voids in layers as they come, from the bottom up. It owns its memory. */
typedef struct sf_void_search sf_void_search;

/**
 * Begin a search for voids in layers that are pushed one at a time.
 *
 * @param options    bed, thresholds, array; copied, and the array must stay
 * @param width      of the layers, 1..SF_EXTENT_MAX
 * @param height     of the layers, 1..SF_EXTENT_MAX
 * @param allocator  for the search, as sf_grid_voids() takes it; NULL for the C library's
 * @param search     receives the search
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, a capacity
 * without an array, an extent outside its range; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
 * @cost a layer of new memory.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_void_search_create(const sf_voids_options *options, uint32_t width,
                                                  uint32_t height, const sf_allocator *allocator,
                                                  sf_void_search **search);

/**
 * Push the next layer.
 *
 * @param search  the search; after SF_ERR_MEMORY or SF_ERR_OVERFLOW it may only be destroyed
 * @param layer   a slice of its width and height; read only
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a slice that is none, a search that is finished;
 * SF_ERR_SHAPE: another size; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
 * @cost one pass over the layer, and nearly linear in the runs of empty voxels.   @threads one per
 * search.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_void_search_push(sf_void_search *search, sf_slice layer);

/**
 * Say what was found: what sf_grid_voids() says of a grid of these layers.
 *
 * @param search      the search, which takes no more layers
 * @param report      the counts
 * @param void_count  voids in the caller's array; may be NULL
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, or a search that is finished; SF_ERR_MEMORY, or
 * what a push returned before.
 * @cost the voids.   @threads one per search.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_void_search_finish(sf_void_search *search, sf_voids_report *report,
                                                  size_t *void_count);

/**
 * Free a search.
 *
 * @param search  the search, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this search.
 * @since 0.1
 */
SF_API void sf_void_search_destroy(sf_void_search *search);

#ifdef __cplusplus
}
#endif

#endif
