// SPDX-License-Identifier: MIT
// Support: what may rest on what, does a shape print without supports, and the trim that makes it
// so.
//
// A shape S_0, S_1, ... is support-free under a rule when every slice lies within what the slice
// below can carry: S_{k+1} is a subset of S_k dilated by the rule's element for that step. One
// slice, the bed slice, rests on the bed and needs nothing below it; by default it is the first
// slice that holds matter. What lies outside a slice is empty: nothing is carried from there.
//
// Three things are built on that sentence. A rule says which element each step has. A check counts
// what is not carried, and names the places (findings), lowest first, each with the one that caused
// it. A trim removes everything that is not carried, and what then is not carried any more, from
// the bottom up: what is left is the largest support-free part of the shape.
//
// Rules and checks compute with integers only and take no memory of their own.

#ifndef SF_SUPPORT_H
#define SF_SUPPORT_H

#include <sf/voxel.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Rule
// ---------------------------------------------------------------------------------------------

/** Which voxels below can carry a voxel. */
typedef enum sf_rule_kind {
    SF_RULE_BOX3 = 0,    /**< the nine voxels below: the papers' rule; takes no angle */
    SF_RULE_OCTAGON = 1, /**< a schedule of pluses and squares that stays within the asked angle */
    SF_RULE_DISK = 2 /**< an ellipse in voxels, a disk in mm, the same for layers of one height */
} sf_rule_kind;

/** Smallest overhang angle that a rule can be made for, in radians: 5 degrees. */
#define SF_RULE_ANGLE_MIN_RAD 0.08726646259971647
/** Largest overhang angle that a rule can be made for, in radians: 85 degrees. */
#define SF_RULE_ANGLE_MAX_RAD 1.4835298641951802

/**
 * A support rule for one lattice: make it with sf_rule_box3() or sf_rule_make(), and only read it.
 *
 * Holds integers only: reaches are in 1/2^24 voxel. The reach of a step is how far, measured in the
 * plane, matter may lie beyond the matter that carries it. `table` belongs to the caller of
 * sf_rule_make() and must outlive every use of the rule.
 */
typedef struct sf_rule {
    sf_rule_kind kind;
    uint32_t table_count;  /**< layers that the table serves; 0 when all layers have one height */
    uint64_t reach_x_q24;  /**< one height: reach of one step along x */
    uint64_t reach_y_q24;  /**< one height: reach of one step along y */
    const uint64_t *table; /**< table_count numbers for x, then as many for y; or NULL. Octagon:
                                reach from layer 0 to each layer. Disk: reach of each step. */
} sf_rule;

/**
 * What a rule allows on its lattice, for people: angles from the vertical, in radians.
 *
 * The first three hold in the long run, over many layers, in every layer of the lattice; the last
 * is exceeded nowhere but for rounding (octagon: less than 1.502 voxel in the plane, however long
 * the overhang).
 */
typedef struct sf_rule_angles {
    double axis_x_rad;   /**< an overhang along x is accepted up to this angle */
    double axis_y_rad;   /**< the same along y */
    double diagonal_rad; /**< the same along the diagonal of a pixel */
    double steepest_rad; /**< no overhang beyond this angle is accepted in any direction */
} sf_rule_angles;

/**
 * The papers' rule: a voxel is carried by any of the nine below it.
 *
 * It takes no angle. On cubic voxels it accepts 45 degrees along the axes and 54.7 degrees along
 * diagonals; sf_rule_measure() says what it accepts on another lattice.
 *
 * @return the rule; it serves every lattice.
 * @cost constant.   @threads any.
 * @source T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
 * Eurographics 2016, section 3.2.
 * @since 0.1
 */
SF_API sf_rule sf_rule_box3(void);

/**
 * Number of uint64_t that the table of sf_rule_make() needs for a lattice.
 *
 * @param lattice  any lattice; NULL counts as uniform
 * @return 0 where all layers have one height (heights_mm == NULL, or one layer), else 2 * nz.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API size_t sf_rule_table_count(const sf_lattice *lattice);

/**
 * Make a rule for an overhang angle on a lattice.
 *
 * The angle is measured from the vertical: 45 degrees is as far out as up, and larger is more
 * daring. The reach of a step from layer k is height_k * tan(angle) / pitch voxels, rounded down to
 * 1/2^24 voxel after one part in 2^40 has been forgiven, so that 45 degrees on cubes is exactly 1
 * whatever way the angle and the pitch were written.
 *
 * Octagon is the rule to take where an angle is given and pixels are square: it never reaches
 * beyond the asked angle but for less than 1.502 voxel, in any direction and over any number of
 * layers; along the axes and the diagonals it stays at atan(0.924 tan(angle)). Disk is good where
 * the reach is three voxels or more, because each step rounds down anew; it serves pixels that are
 * not square. Box3 ignores the angle.
 *
 * @param kind       which rule
 * @param angle_rad  SF_RULE_ANGLE_MIN_RAD to SF_RULE_ANGLE_MAX_RAD (5 to 85 degrees, each bound
 *                   with 1e-9 to spare); ignored by box3
 * @param lattice    the lattice that slices lie on
 * @param table      sf_rule_table_count() numbers, or NULL where that is 0 or for box3; written,
 *                   and kept by the rule
 * @param rule       the rule
 * @param fault      NULL, or where a refusal is explained
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such kind, an angle outside its range or not a
 * number; SF_ERR_UNSUPPORTED: octagon on pixels that are not square, disk where a step reaches less
 * than a voxel, a step that reaches more than SF_REACH_MAX voxels; what sf_lattice_validate() says.
 * @cost O(nz) where heights differ, else constant.   @threads any.
 * @source The octagon's schedule is a Bresenham line in the number of pluses and squares
 * (J. E. Bresenham, 1965).
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_rule_make(sf_rule_kind kind, double angle_rad,
                                         const sf_lattice *lattice, uint64_t *table, sf_rule *rule,
                                         sf_fault *fault);

/**
 * The element of one step: slice k + 1 must lie within slice k dilated by it.
 *
 * The octagon's elements differ from step to step even where all layers have one height, so k is
 * always the lattice's layer, never a count from the bed.
 *
 * @param rule     the rule
 * @param k        layer below the step, counted from the lattice's layer 0
 * @param element  the element
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a rule that sf_rule_make() did not make, or a
 * table that does not reach to layer k + 1.
 * @cost O(reach).   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_rule_element(const sf_rule *rule, uint32_t k, sf_element *element);

/**
 * Angles that a rule allows on a lattice.
 *
 * Box3 and disk: from the reach of single steps, the worst over the layers. Octagon: from its mean
 * reach; a window of L layers is within 1.502 voxel of that.
 *
 * @param rule     the rule
 * @param lattice  the lattice that it was made for; any for box3
 * @param angles   the angles
 * @return SF_OK; SF_ERR_ARGUMENT: as sf_rule_element(); SF_ERR_SHAPE: the rule was made for another
 * number of layers; what sf_lattice_validate() says.
 * @cost O(nz + d * reach^2) where d neighbouring layers differ in height.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_rule_measure(const sf_rule *rule, const sf_lattice *lattice,
                                            sf_rule_angles *angles);

/**
 * Name of a rule kind, as the command line and stack.json spell it.
 *
 * @param kind  any value
 * @return "box3", "octagon", "disk", or "unknown"; a static string, never NULL.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API const char *sf_rule_kind_name(sf_rule_kind kind);

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
 * An island touches nothing that is carried, and has no cause. An overhang has one when all carried
 * voxels that touch its region, corners included, are lost: the lowest index that these are due to.
 * It grows out of matter that hangs in the air already, so the cause is what to look at first.
 */
typedef struct sf_finding {
    sf_finding_kind kind;
    uint32_t layer;  /**< layer where it starts, counted from the lattice's layer 0 */
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
    uint32_t layer_count;        /**< layers pushed */
    uint32_t bed_layer;          /**< the bed layer; SF_BED_AUTO while there was no matter */
    uint64_t solid_voxels;       /**< |S| */
    uint64_t unsupported_voxels; /**< sum over k of |S_{k+1} \ dilate(S_k)| */
    uint64_t trimmed_voxels;     /**< |S| - |trim S| */
    uint64_t island_count;       /**< findings of kind island */
    uint64_t overhang_count;     /**< findings of kind overhang */
    uint64_t findings_dropped;   /**< findings that did not fit the caller's array */
    uint64_t runs_dropped;       /**< runs of lost matter that did not fit run_capacity */
    uint64_t unlinked_voxels;    /**< trimmed voxels that no finding in the array answers for */
    int support_free;            /**< 1 when unsupported_voxels is 0 */
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
 * Lives in memory of the caller's, takes none of its own, and computes with integers only, so that
 * a printer's controller can run it while it reads a job. It needs no end: the report may be asked
 * for after any layer, and the memory may be reused when it is no longer wanted.
 */
typedef struct sf_checker sf_checker;

/**
 * Bytes of memory that sf_checker_place() needs for these options.
 *
 * About four slices, 42 bytes for each column, and with findings 32 bytes for each run of
 * run_capacity and 4 for each column.
 *
 * @param options  the options that the checker will be placed with
 * @param size     the bytes
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, width or
 * height outside 1..SF_EXTENT_MAX, a first or a bed layer of SF_LAYER_MAX or more, a bed layer
 * below the first, a capacity without findings, a rule that sf_rule_make() did not make or that
 * does not serve the first layer; SF_ERR_OVERFLOW: a capacity of 2^31 - 1 or more, or a size that
 * does not fit the machine.
 * @cost constant.   @threads any.
 * @since 0.1
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
 * @cost O(width * height / 64).   @threads any.
 * @since 0.1
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
 * @cost a dilation of the layer below, two where matter was lost there, and in lost matter its
 * voxels times the rows of the element.
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
 * @cost as sf_checker_push(), and O(count).   @threads one per checker.
 * @since 0.1
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
 * Counts so far.
 *
 * @param checker        the checker
 * @param report         the counts
 * @param finding_count  findings in the caller's array; may be NULL
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer.
 * @cost constant.   @threads one per checker.
 * @since 0.1
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
 * From the bottom up: T_bed = S_bed and T_{k+1} = S_{k+1} and dilate(T_k); matter below the bed
 * layer is removed. The result contains every support-free part of the shape, so no order of other
 * removals keeps more, and trimming again changes nothing.
 *
 * @param grid       the shape, changed in place
 * @param rule       a rule for the grid's lattice
 * @param bed_layer  layer that rests on the bed, or SF_BED_AUTO: the first that holds matter
 * @param task       NULL, or progress per slice; a cancel is honoured only before the first write,
 *                   because there is no second grid to go back to
 * @param report     counts, or NULL, which saves counting
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a bed layer that the grid has not, a rule that
 * does not serve all its layers; SF_ERR_CANCELLED.
 * @cost one pass over the grid for box3 and octagon up to reach 1; about 4 * reach passes else.
 * @threads one per grid.
 * @source T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
 * Eurographics 2016, sections 2.2 and 3.2.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_trim(sf_grid *grid, const sf_rule *rule, uint32_t bed_layer,
                                         sf_task *task, sf_trim_report *report);

/**
 * Bring `printable` = trim(`drawn`) up to date after `drawn` changed within `box`.
 *
 * Before the change `printable` was the trim of `drawn`, by the same rule and bed layer; after this
 * call it is again, bit for bit what sf_grid_trim() of `drawn` gives. Only what can have changed is
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
 * grids differ in counts; SF_ERR_MEMORY: a slice of working memory, taken from the allocator of
 * `printable`, was refused.
 * @cost the volume of the boxes around the change in each layer, grown by the rule's reach.
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
