// SPDX-License-Identifier: MIT
// Support: what may rest on what, does a shape print without supports, and the trim that makes it
// so.
//
// A shape S_0, S_1, ... is support-free under a rule when every slice lies within what the slice
// below can carry: for rules that are an element for each step, S_{k+1} is a subset of S_k dilated
// by that element; slack and bridges are told in <sf/rule.h>. One slice, the bed slice, rests on
// the bed and needs nothing below it; by default it is the first slice that holds matter. What lies
// outside a slice is empty: nothing is carried from there.
//
// Three things are built on that sentence. A rule says which element each step has. A check counts
// what is not carried, and names the places (findings), lowest first, each with the one that caused
// it. A trim removes everything that is not carried, and what then is not carried any more, from
// the bottom up: what is left is the largest support-free part of the shape.
//
// Rules and checkers compute with integers only and take no memory of their own.

#ifndef SF_SUPPORT_H
#define SF_SUPPORT_H

#include <sf/contour.h>
#include <sf/rule.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Bed
// ---------------------------------------------------------------------------------------------

/**
 * Bed layer chosen by the shape itself: the first slice that holds matter.
 *
 * Where a bed layer is given instead, its slice rests on the bed whole, whatever lies below. Matter
 * below it hangs in the air: a check counts it as unsupported where nothing below carries it and as
 * trimmed everywhere, and a trim removes it.
 */
#define SF_BED_AUTO UINT32_MAX

// ---------------------------------------------------------------------------------------------
// Terms
// ---------------------------------------------------------------------------------------------

/**
 * The terms that an operator works on: a rule, a bed, and masks. Fill with sf_terms_default().
 *
 * A mask is a grid of the same counts as the shape's, and its solid voxels are what it names; NULL
 * where there is none. Masks are only read, and must not be the grid that is changed.
 */
typedef struct sf_terms {
    size_t struct_size;    /**< sizeof(sf_terms), set by the default */
    sf_rule rule;          /**< box3 by default; its table must outlive every use of the terms */
    uint32_t bed_layer;    /**< layer that rests on the bed, or SF_BED_AUTO (default) */
    const sf_grid *exempt; /**< NULL, or what counts as carried already, with no reach to spare:
                              overhangs that are accepted, matter that something else holds */
    const sf_grid *keep;   /**< NULL, or what is never removed, where it is solid in the shape */
    const sf_grid *forbid; /**< NULL, or what is never added */
    const sf_grid *act;    /**< where an operator may act; NULL: everywhere */
} sf_terms;

/**
 * Terms without masks: rule box3, bed by the shape itself.
 *
 * @return the terms, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_terms sf_terms_default(void);

/**
 * Whether something that must stay can be carried within what may be there; and if not, what of it
 * cannot.
 *
 * A support-free shape R with needed within R within allowed exists just when needed lies within
 * the trim of `allowed`. Each voxel that does not is a culprit: it cannot be carried even alone,
 * and giving up or exempting just the culprits makes the rest possible. True for every rule.
 *
 * @param allowed    all voxels that may be solid
 * @param needed     voxels that must be; what of them is not allowed is a culprit
 * @param terms      rule, bed layer and exempt voxels; the other masks are not looked at. With
 *                   SF_BED_AUTO the bed is the first layer that holds matter in `allowed`
 * @param allocator  for working memory: a grid, and what a trim takes; NULL for the C library's
 * @param task       NULL, or progress per slice; a cancel is honoured at every slice
 * @param culprits   NULL, or a grid whose voxels are set to the culprits; neither of the others
 * @param count      number of culprits; may be NULL
 * @return SF_OK: feasible; SF_ERR_INFEASIBLE: it is not, and culprits and count were written;
 * SF_ERR_ARGUMENT: a NULL pointer, terms without their struct_size, a bed layer that the grid has
 * not, a rule that does not serve all its layers; SF_ERR_SHAPE: grids that differ in counts;
 * SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost a trim.   @threads any; the grids but culprits are only read.
 * @source the greatest support-free subset is unique because support-free sets are closed under
 * union.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_feasible(const sf_grid *allowed, const sf_grid *needed,
                                             const sf_terms *terms, const sf_allocator *allocator,
                                             sf_task *task, sf_grid *culprits, uint64_t *count);

// ---------------------------------------------------------------------------------------------
// Check
// ---------------------------------------------------------------------------------------------

/** What kind of fault a finding is. */
typedef enum sf_finding_kind {
    SF_FINDING_OVERHANG = 0, /**< matter that reaches too far out from what is carried */
    SF_FINDING_ISLAND = 1    /**< a whole component of a slice with nothing that carries it */
} sf_finding_kind;

/** cause of a finding that no other finding causes. */
#define SF_FINDING_ROOT UINT32_MAX

/**
 * One place where a shape is not supported: an 8-connected region (through edges and corners) of
 * the voxels of one layer that the layer below does not carry.
 *
 * Every voxel that trimming takes away is due to exactly one finding: to that of its own region
 * where nothing carries it; else to the one with the lowest index among those that the voxels which
 * carry it are due to, all of which are lost as well.
 *
 * Under slack, and with bridges, a voxel can be lost because of matter that lies farther off than
 * what carries it; no finding answers for such voxels (unlinked_voxels).
 *
 * An island touches nothing that is carried, and has no cause. An overhang has one when all carried
 * voxels that touch its region, corners included, are lost: the lowest index that these are due to.
 * It grows out of matter that hangs in the air already, so the cause is what to look at first.
 */
typedef struct sf_finding {
    sf_finding_kind kind; /**< island or overhang */
    uint32_t layer;       /**< layer where it starts, counted from the lattice's layer 0 */
    uint32_t cause;  /**< index of an earlier finding that this one follows, or SF_FINDING_ROOT */
    uint64_t area;   /**< voxels of the region */
    uint64_t volume; /**< voxels that trimming takes away because of it, the region included */
    sf_box box;      /**< smallest box around those voxels */
} sf_finding;

/**
 * Counts of a check.
 *
 * All counts are exact whatever fits where. The volumes of the findings and unlinked_voxels sum up
 * to trimmed_voxels. While runs_dropped is 0 a shorter array of findings holds just what a longer
 * one would hold in its first places.
 */
typedef struct sf_check_report {
    uint32_t layer_count;  /**< layers pushed */
    uint32_t bed_layer;    /**< the bed layer; SF_BED_AUTO while there was no matter */
    uint64_t solid_voxels; /**< |S| */
    uint64_t
        unsupported_voxels;    /**< sum over k of what of S_{k+1} is not carried by S_k as drawn */
    uint64_t trimmed_voxels;   /**< |S| - |trim S| */
    uint64_t island_count;     /**< findings of kind island */
    uint64_t overhang_count;   /**< findings of kind overhang */
    uint64_t findings_dropped; /**< findings that did not fit the caller's array */
    uint64_t runs_dropped;     /**< runs of lost matter that did not fit run_capacity */
    uint64_t unlinked_voxels;  /**< trimmed voxels that no finding in the array answers for */
    int support_free;          /**< 1 when unsupported_voxels is 0 */
} sf_check_report;

/** How a check runs. Fill with sf_check_options_default(). */
typedef struct sf_check_options {
    size_t struct_size;      /**< sizeof(sf_check_options), set by the default */
    sf_rule rule;            /**< box3 by default; its table must outlive the check */
    uint32_t width, height;  /**< size of the slices that will be pushed; a grid brings its own */
    uint32_t first_layer;    /**< lattice layer of the first slice pushed; a grid starts at 0 */
    uint32_t bed_layer;      /**< lattice layer that rests on the bed, or SF_BED_AUTO (default) */
    uint32_t run_capacity;   /**< runs of lost matter kept of each layer, to link the next one to
                                  its findings. 0: none, each finding answers for its own region
                                  only; but in sf_grid_check() as many as it takes */
    sf_finding *findings;    /**< the caller's array, or NULL for counts only (default) */
    size_t finding_capacity; /**< places in it */
    uint32_t layer_run_capacity; /**< a layer pushed as at most that many runs is not painted where
                                      all rests; 0 (default): all are */
} sf_check_options;

/**
 * Options of a check: rule box3, bed by the shape itself, no findings.
 *
 * @return the options; width and height are 0 and must be set for a streaming check.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_check_options sf_check_options_default(void);

/**
 * A streaming check that keeps two layers, and two more while a layer is pushed.
 *
 * A voxel that nothing carries counts once; what rests on it is then judged as if it were carried,
 * under slack with no reach to spare.
 *
 * Lives in memory of the caller's, takes none of its own, and computes with integers only, so that
 * a printer's controller can run it while it reads a job. It needs no end: the report may be asked
 * for after any layer, and the memory may be reused when it is no longer wanted.
 */
typedef struct sf_checker sf_checker;

/**
 * Bytes of memory that sf_checker_place() needs for these options.
 *
 * About four slices (under slack 36, with bridges four more), 42 bytes for each column, and with
 * findings 32 bytes for each run of run_capacity and 4 for each column; 16 for each run of
 * layer_run_capacity, and with that 4 for each row.
 *
 * @param options  the options that the checker will be placed with
 * @param size     the bytes
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, width or
 * height outside 1..SF_EXTENT_MAX, a first or a bed layer of SF_LAYER_MAX or more, a bed layer
 * below the first, a capacity without findings, a rule that sf_rule_make() did not make or that
 * does not serve the first layer; SF_ERR_OVERFLOW: a capacity of 2^31 - 1 or more, or a size that
 * does not fit the machine.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_checker_size(const sf_check_options *options, size_t *size);

/**
 * Set up a checker in the caller's memory.
 *
 * The findings array and the rule's table stay the caller's and must live as long as the checker is
 * used; the options are copied.
 *
 * @param options      the options
 * @param memory       64-byte aligned; apart from what the findings lie in
 * @param memory_size  its size in bytes, at least sf_checker_size()
 * @param checker      the checker, which lies in `memory`
 * @return SF_OK; what sf_checker_size() says; SF_ERR_ARGUMENT: a NULL pointer, memory that is not
 * aligned; SF_ERR_CAPACITY: too little memory.
 * @cost O(width * height / 64), under slack O(width * height).   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_checker_place(const sf_check_options *options, void *memory,
                                             size_t memory_size, sf_checker **checker);

/**
 * Push the next layer as bits.
 *
 * Findings of the layer are in the array when the call returns, in the order in which their
 * regions end: by last row, then from left to right in that row. Volumes and boxes of earlier
 * findings may have grown.
 *
 * @param checker  the checker
 * @param layer    a slice of the checker's width and height; read only; not in the checker's memory
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a slice that is none, a slice in the checker's
 * memory, a rule whose table does not reach to this layer; SF_ERR_SHAPE: another size;
 * SF_ERR_OVERFLOW: the layer would be number SF_LAYER_MAX.
 * @cost a step of the rule, two where matter was lost below (under slack, as long as it tells), and
 * in lost matter its voxels times the rows of the element; whatever the size, up to 9 KiB of
 * stack, 6 on a processor of 32 bits.
 * @threads one per checker.
 * @source T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
 * Eurographics 2016, section 3.2.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_checker_push(sf_checker *checker, sf_slice layer);

/**
 * Push the next layer as runs.
 *
 * @param checker  the checker
 * @param runs     row by row, left to right, not overlapping but free to touch; labels are ignored;
 *                 may be NULL where count is 0
 * @param count    number of runs
 * @return as sf_checker_push(); SF_ERR_ARGUMENT also: runs that are empty, leave the slice or are
 * out of order.
 * @cost O(count) where layer_run_capacity serves; else as sf_checker_push() too.
 * @threads one per checker.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_checker_push_runs(sf_checker *checker, const sf_run *runs,
                                                 size_t count);

/**
 * Push the next layer as 8-bit rows: solid where the value is at least `threshold`.
 *
 * @param checker    the checker
 * @param pixels     the pixel of voxel (0, 0), then those along x; row y starts at y * row_bytes
 * @param row_bytes  bytes from one row to the next, at least the width
 * @param threshold  1 to 255; 0 makes everything solid
 * @return as sf_checker_push(); SF_ERR_ARGUMENT also: rows that are too short or do not fit the
 * machine.
 * @cost as sf_checker_push(), and two passes over the pixels.   @threads one per checker.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_checker_push_grey(sf_checker *checker, const uint8_t *pixels,
                                                 size_t row_bytes, uint8_t threshold);

/**
 * Push the next layer as contours: closed polygons of <sf/contour.h>.
 *
 * @param checker    the checker
 * @param lattice    of the checker's width and height; pitch and origin are looked at
 * @param contours   the polygons
 * @param fill       what is inside
 * @param allocator  for drawing and for the layer's runs; NULL for the C library's
 * @param fault      NULL, or filled where a point is refused
 * @return as sf_slice_from_contours() and as sf_checker_push_runs().
 * @cost as both.   @threads one per checker.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_checker_push_contours(sf_checker *checker, const sf_lattice *lattice,
                                                     const sf_contours *contours,
                                                     sf_contour_fill fill,
                                                     const sf_allocator *allocator,
                                                     sf_fault *fault);

/**
 * Counts so far.
 *
 * @param checker        the checker
 * @param report         the counts
 * @param finding_count  findings in the caller's array; may be NULL
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer.
 * @cost constant.   @threads one per checker.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_checker_report(const sf_checker *checker, sf_check_report *report,
                                              size_t *finding_count);

/**
 * Check a whole grid: the streaming check, with every slice pushed from the bottom up.
 *
 * Width, height and first layer of the options are the grid's, whatever stands there. Where
 * run_capacity is 0 it is chosen so that all runs fit, so that volumes and causes are exact for all
 * findings in the array. After a failing call the findings array is as it was.
 *
 * @param grid           the shape
 * @param options        rule, bed layer, findings
 * @param allocator      for working memory: that of a checker, and as many findings as the array
 *                       has places; NULL for the C library's
 * @param task           NULL, or progress per slice; a cancel is honoured at every slice
 * @param report         the counts
 * @param finding_count  findings in the caller's array; may be NULL
 * @return SF_OK; what sf_checker_size() says; SF_ERR_ARGUMENT: a NULL pointer, a bed layer that the
 * grid has not, a rule that does not serve all its layers; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost that of the pushes; more passes where a layer loses more than 262144 runs.
 * @threads any; the grid is only read.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_check(const sf_grid *grid, const sf_check_options *options,
                                          const sf_allocator *allocator, sf_task *task,
                                          sf_check_report *report, size_t *finding_count);

/**
 * Which voxels of a shape nothing carries, as it is drawn: those that a check counts, and all of
 * what lies below the bed.
 *
 * What rests on one of them counts as carried, under slack with no reach to spare. With these
 * exempt, and what the terms exempt already, the shape is support-free.
 *
 * @param grid         the shape
 * @param terms        rule, bed layer and exempt voxels, which count as carried; the other masks
 *                     are not looked at
 * @param allocator    for working memory: a grid, two slices, under slack 34, with bridges three
 *                     more; NULL for the C library's
 * @param task         NULL, or progress per slice; a cancel is honoured at every slice
 * @param unsupported  of the same counts, and neither the shape nor a mask: set to these voxels
 * @param count        how many; may be NULL
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, terms without their struct_size, a bed layer that
 * the grid has not, a rule that does not serve all its layers, one grid given twice; SF_ERR_SHAPE:
 * grids that differ in counts; SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost a step of the rule for each layer.   @threads any that write distinct grids.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_unsupported(const sf_grid *grid, const sf_terms *terms,
                                                const sf_allocator *allocator, sf_task *task,
                                                sf_grid *unsupported, uint64_t *count);

/** How steep the overhangs of a shape are. */
typedef struct sf_steepest {
    double angle_rad; /**< from the vertical: the least angle that it is support-free for; or, where
                           is_bounded is 0, the largest that was tried */
    int is_bounded;   /**< 0: it is not support-free for any angle that was tried, up to the largest
                           that the lattice can be served for, at most 85 degrees: an island, or a
                           ledge longer than the last step reaches */
    uint32_t layer; /**< the lowest layer that a slightly smaller angle does not carry, or that none
                         does; SF_BED_AUTO when even 5 degrees carry everything */
    sf_box box;     /**< box of the finding there; all zero when there is none */
} sf_steepest;

/**
 * The steepest overhang that a shape has: the least angle for which the rule slack finds nothing.
 *
 * To a tenth of a degree, between 5 and 85. An overhang over a height H may be said flatter than it
 * is by the rule's cap over H in its tangent: about two voxels up to 63 degrees, and above that
 * what one step reaches, up to twelve on cubes. So a flat ledge of one layer is given the angle
 * whose step reaches over it.
 *
 * @param grid       the shape
 * @param bed_layer  layer that rests on the bed, or SF_BED_AUTO
 * @param allocator  for working memory: that of a check, and a rule's table; NULL for the C
 * library's
 * @param task       NULL, or progress; a cancel is honoured at every slice
 * @param steepest   the result
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a bed layer that the grid has not;
 * SF_ERR_UNSUPPORTED: not even at 5 degrees can the lattice be served; SF_ERR_MEMORY;
 * SF_ERR_CANCELLED.
 * @cost about eleven checks under slack.   @threads any; the grid is only read.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_steepest(const sf_grid *grid, uint32_t bed_layer,
                                             const sf_allocator *allocator, sf_task *task,
                                             sf_steepest *steepest);

// ---------------------------------------------------------------------------------------------
// Trim
// ---------------------------------------------------------------------------------------------

/** Counts of a trim. */
typedef struct sf_trim_report {
    uint64_t kept_voxels;    /**< solid voxels left */
    uint64_t removed_voxels; /**< solid voxels taken away */
    uint32_t bed_layer;      /**< the bed layer; SF_BED_AUTO when the grid holds no matter */
} sf_trim_report;

/**
 * Remove everything that is not supported, in place: what is left is the largest support-free part.
 *
 * From the bottom up: T_bed = S_bed, and T_{k+1} is what of S_{k+1} the rule lets rest on T_k;
 * matter below the bed layer is removed. The result contains every support-free part of the shape,
 * so no order of other removals keeps more, and trimming again changes nothing.
 *
 * @param grid       the shape, changed in place
 * @param rule       a rule for the grid's lattice
 * @param bed_layer  layer that rests on the bed, or SF_BED_AUTO: the first that holds matter
 * @param task       NULL, or progress per slice; a cancel is honoured only before the first write,
 *                   because there is no second grid to go back to
 * @param report     counts, or NULL, which saves counting
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a bed layer that the grid has not, a rule that
 * does not serve all its layers; SF_ERR_CANCELLED; under slack and with bridges also SF_ERR_MEMORY
 * and SF_ERR_OVERFLOW: working memory, taken from the grid's allocator before the first write, was
 * refused or does not fit the machine (under slack 18 slices, with bridges five, with both 21).
 * @cost one pass over the grid for box3 and octagon up to reach 1; about 4 * reach passes for
 * others; under slack some fifty passes at a surface and few inside; with bridges, in layers where
 * something hangs, some twenty passes over a window around it.
 * @threads one per grid.
 * @source T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
 * Eurographics 2016, sections 2.2 and 3.2.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_trim(sf_grid *grid, const sf_rule *rule, uint32_t bed_layer,
                                         sf_task *task, sf_trim_report *report);

/**
 * Trim on terms: with exempt voxels, and only if nothing that must stay is lost.
 *
 * The result is the largest part of the shape that is support-free apart from the exempt voxels. It
 * is refused where that part lacks a voxel that must stay: one of `keep`, or one outside `act`.
 *
 * @param grid       the shape, changed in place
 * @param terms      rule, bed layer and masks; `forbid` is not looked at, because nothing is added
 * @param allocator  for working memory: a grid, with keep or act two, and what a trim takes; NULL
 *                   for the C library's
 * @param task       NULL, or progress per slice; a cancel is honoured at every slice
 * @param culprits   NULL, or a grid that is set, on SF_ERR_INFEASIBLE, to the voxels that must stay
 *                   and cannot
 * @param report     counts, or NULL
 * @return SF_OK; SF_ERR_INFEASIBLE: a voxel that must stay cannot, and the shape is as it was; and
 * what sf_grid_feasible() says.
 * @cost a copy of the grid and a trim.   @threads one per grid.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_trim_on(sf_grid *grid, const sf_terms *terms,
                                            const sf_allocator *allocator, sf_task *task,
                                            sf_grid *culprits, sf_trim_report *report);

/**
 * Bring `printable` = trim(`drawn`) up to date after `drawn` changed within `box`.
 *
 * Before the change `printable` was the trim of `drawn`, by the same rule and bed layer; after this
 * call it is again, bit for bit what sf_grid_trim() of `drawn` gives. Under slack everything is
 * trimmed anew, because what a voxel has to spare is not kept. Else only what can have changed is
 * looked at: the box, and above it what rests on voxels that did change, up to the first layer
 * where none did. Matter may have been added and removed; parts that were trimmed earlier come back
 * where there is support for them now.
 *
 * `drawn` and `printable` may be one grid, if the change only removed matter and the grid was
 * support-free before it.
 *
 * Where bed_layer is SF_BED_AUTO and the change moved the first layer that holds matter, everything
 * is recomputed.
 *
 * @param drawn      the shape as drawn, after the change
 * @param printable  its support-free part, before the call that of the shape before the change
 * @param rule       a rule for the lattice of both
 * @param bed_layer  as in sf_grid_trim()
 * @param box        a box around the change, within the grid; an empty one changes nothing
 * @param changed    NULL, or where the box around the voxels of `printable` that this call changed
 *                   is left: empty (all zero) when there are none
 * @return SF_OK; SF_ERR_ARGUMENT: as sf_grid_trim(), or a box beyond the grid; SF_ERR_SHAPE: the
 * grids differ in counts; SF_ERR_MEMORY: working memory, taken from the allocator of `printable`,
 * was refused: a slice, with bridges four, under slack a grid and 18 slices; SF_ERR_OVERFLOW, under
 * slack: it does not fit the machine.
 * @cost the volume of the boxes around the change in each layer, grown by the rule's reach and with
 * bridges by their span and anchor; under slack a trim.
 * @threads one per pair of grids.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_trim_box(const sf_grid *drawn, sf_grid *printable,
                                             const sf_rule *rule, uint32_t bed_layer, sf_box box,
                                             sf_box *changed);

#ifdef __cplusplus
}
#endif

#endif
