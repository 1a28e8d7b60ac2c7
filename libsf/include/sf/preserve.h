// SPDX-License-Identifier: MIT
// Preserve: take matter away and keep what the rest needs to be printed.
//
// Two functions. Complete finds, within a support-free shape, a support-free part that holds all
// that must stay: it adds to what must stay the supports that it needs, taken from the shape.
// Preserve removes a brush: what must stay is all that lies outside the brush, so nothing outside
// it is ever lost, and in the brush stays only what carries something.
//
// With V the shape, F what must stay and V' the result:
//
//     F within V' within V,    V' is support-free,    V' = F just when F is support-free
//
// for every rule of <sf/rule.h>, with bridges, with exempt voxels, in every mode but the two that
// repeat the paper for comparison. There is no least V', and the smallest is a set cover, which is
// hard; so what is promised beyond that is irredundance, in the mode that has it in its name.
//
// The order of strokes matters: removing two brushes one after the other is not removing both at
// once. A tool that paints a stroke should collect it into one brush.

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
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_complete(const sf_grid *shape, const sf_grid *needed,
                                             const sf_terms *terms, const sf_allocator *allocator,
                                             sf_task *task, sf_grid *result);

/** What is kept of the brush, where something must be. */
typedef enum sf_preserve_mode {
    SF_PRESERVE_FAST = 0, /**< word by word: straight below what hangs, else the nearest. Keeps
                               more than is needed. Rules with slack or bridges have no words to do
                               it by: there it is sf_grid_complete() */
    SF_PRESERVE_IRREDUNDANT = 1, /**< no kept voxel of the brush could be removed as well without
                                      losing something outside the brush; greedy, then pruned */
    SF_PRESERVE_CORE = 2,       /**< thick: the core of what hangs, then struts of strut_width, then
                                     single voxels where nothing thicker fits */
    SF_PRESERVE_PAPER_TEXT = 3, /**< the paper's text: remove all, then from the slice above the
                                     brush to the one below it unite each with the erosion of the
                                     one above. May leave unsupported matter, and add some */
    SF_PRESERVE_PAPER_SHADER = 4 /**< the paper's shader: from the top down a voxel of the brush
                                      stays where all above it are solid. May leave unsupported
                                      matter */
} sf_preserve_mode;

/** How to preserve. Fill with sf_preserve_options_default(). */
typedef struct sf_preserve_options {
    size_t struct_size;     /**< sizeof(sf_preserve_options), set by the default */
    sf_preserve_mode mode;  /**< SF_PRESERVE_FAST by default */
    const sf_grid *must_go; /**< voxels that must not stay, or NULL */
    sf_box brush_box;       /**< only the brush's voxels in here count; all zero: all. Saves looking
                                 for them */
    uint32_t strut_width;   /**< of SF_PRESERVE_CORE, in voxels: odd, 1 to 255; 3 by default */
    int accept_unsupported; /**< 1: what the terms do not carry before the edit counts as exempt.
                                 0 (default): such a shape is refused */
    int known_support_free; /**< 1: the caller knows that the shape is support-free, as after a
                                 trim, so that fast need not look at all of it. Where it is not,
                                 what nothing carried stays as it was, and no more is left so */
    int trim_after; /**< 1: the paper's modes end with a trim; by default they do not. A trim
                         minds no masks: it takes what hangs wherever it is */
} sf_preserve_options;

/**
 * Options of preserve: fast, nothing that must go, unsupported shapes refused.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_preserve_options sf_preserve_options_default(void);

/** What became of a brush. */
typedef struct sf_preserve_report {
    uint64_t removed_voxels; /**< solid voxels of the brush that are gone */
    uint64_t kept_voxels;    /**< solid voxels of the brush that are still there */
    uint64_t lost_outside;   /**< solid voxels outside the brush that are gone: 0 but for a paper's
                                  mode with a trim after it */
    uint64_t added_voxels;   /**< voxels that were not solid and are: 0 but for the paper's text */
} sf_preserve_report;

/**
 * Remove a brush, and keep of it what carries the rest: nothing outside the brush changes.
 *
 * What counts as the brush is solid in `brush`, lies where the terms let an operator act, and is
 * not to be kept. The shape must be support-free apart from exempt voxels, and then is after it;
 * matter that was accepted as unsupported before the edit stays accepted, be it by the terms or by
 * accept_unsupported. Voxels that must go are feasible just when what is outside the brush lies
 * within trim(shape without them).
 *
 * @param grid       the shape, changed in place
 * @param brush      a grid of the same counts, only read; not `grid`
 * @param terms      rule, bed layer and masks: `act` and `keep` bound the brush; `forbid` bounds
 *                   what the paper's text adds. With SF_BED_AUTO the bed is the first layer that
 *                   holds matter before the edit
 * @param options    NULL for the default
 * @param allocator  for working memory: in mode fast some bits for each voxel of the brush's box,
 *                   else as sf_grid_complete() and two grids, under slack a byte for each voxel in
 *                   mode irredundant; NULL for the C library's
 * @param task       NULL, or progress; a cancel is honoured at every slice, and nothing is written
 *                   before all is known
 * @param report     counts, or NULL
 * @return SF_OK; SF_ERR_INFEASIBLE: the shape is not support-free, or something outside the brush
 * cannot stay without what must go (sf_grid_feasible() names the voxels), and the shape is as it
 * was; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size or with values outside
 * their range, a grid that is given twice; and what sf_grid_feasible() says.
 * @cost fast: the volume of the brush's box times the element, and a pass over the grid unless
 * known_support_free and brush_box spare it; else as sf_grid_complete(). Irredundant under slack
 * and with bridges: also, for each voxel that was kept first, what its loss changes above it, up to
 * where something dies: under slack the element for each voxel that falls, with bridges a window of
 * their reach as well. A ball in 256^3 hollowed under slack, 10^5 voxels tried: 0.35 s; with
 * bridges over 3 voxels 2 s.
 * @threads one per grid.
 * @source T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
 * Eurographics 2016, sections 2.2 and 3.2 (the operator and both paper modes; as printed it deletes
 * what it should keep).
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_preserve(sf_grid *grid, const sf_grid *brush,
                                             const sf_terms *terms,
                                             const sf_preserve_options *options,
                                             const sf_allocator *allocator, sf_task *task,
                                             sf_preserve_report *report);

#ifdef __cplusplus
}
#endif

#endif
