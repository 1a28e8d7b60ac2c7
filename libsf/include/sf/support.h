// SPDX-License-Identifier: MIT
// Support: what may rest on what, does a shape print without supports, and the trim that makes it
// so.
//
// A shape S_0, S_1, ... is support-free under a rule when every slice lies within what the slice
// below can carry: S_{k+1} is a subset of S_k dilated by the rule's element for that step. Slice 0
// here is the bed slice: the one that rests on the bed and needs nothing below it.

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
    SF_RULE_DISK = 2     /**< an ellipse in voxels, a disk in mm, per layer */
} sf_rule_kind;

/**
 * A support rule for one lattice, made by sf_rule_make(). Holds integers only: reaches are in
 * 1/2^24 voxel, so that the checker needs no floating point.
 */
typedef struct sf_rule {
    sf_rule_kind kind;
    uint32_t table_count; /**< entries of each table: layers of the lattice, or 0 when uniform */
    uint64_t reach_x_q24; /**< uniform layers: reach of one step along x */
    uint64_t reach_y_q24; /**< uniform layers: reach of one step along y */
    const uint64_t
        *table; /**< NULL, or cumulative reach at each layer: x entries, then y entries */
} sf_rule;

/** What a rule allows on its lattice, for people. */
typedef struct sf_rule_angles {
    double axis_rad;   /**< steepest overhang along x that is always accepted, from the vertical */
    double axis_y_rad; /**< the same along y */
    double diagonal_rad; /**< the same along the diagonal of a voxel */
} sf_rule_angles;

/** The bare default: box3. */
SF_API sf_rule sf_rule_box3(void);

/** Number of uint64_t that sf_rule_make() needs in its table for this lattice: 0 when uniform. */
SF_API size_t sf_rule_table_count(const sf_lattice *lattice);

/**
 * Make a rule for an overhang angle (from the vertical) on a lattice.
 *
 * A lattice that the rule cannot serve is refused with SF_ERR_UNSUPPORTED and a sentence.
 */
SF_API SF_CHECKED sf_status sf_rule_make(sf_rule_kind kind, double angle_rad,
                                         const sf_lattice *lattice, uint64_t *table, sf_rule *rule,
                                         sf_fault *fault);

/** The element of the step from slice k to slice k + 1 (k counts from the lattice's layer 0). */
SF_API SF_CHECKED sf_status sf_rule_element(const sf_rule *rule, uint32_t k, sf_element *element);

/** Angles that a rule allows on a lattice. */
SF_API SF_CHECKED sf_status sf_rule_measure(const sf_rule *rule, const sf_lattice *lattice,
                                            sf_rule_angles *angles);

/** Name of a rule kind as the command line and stack.json spell it: "box3", "octagon", "disk". */
SF_API const char *sf_rule_kind_name(sf_rule_kind kind);

// ---------------------------------------------------------------------------------------------
// Check
// ---------------------------------------------------------------------------------------------

/** What kind of fault a finding is. */
typedef enum sf_finding_kind {
    SF_FINDING_OVERHANG = 0, /**< matter that reaches too far out from what is supported */
    SF_FINDING_ISLAND = 1    /**< a whole component of a slice with nothing that carries it */
} sf_finding_kind;

/** cause of a finding that no other finding causes. */
#define SF_FINDING_ROOT UINT32_MAX

/** One place where a shape is not supported. */
typedef struct sf_finding {
    sf_finding_kind kind;
    uint32_t layer; /**< layer where it starts */
    uint32_t
        cause; /**< index of the finding below whose loss this one follows, or SF_FINDING_ROOT */
    uint64_t area;   /**< unsupported voxels in that layer */
    uint64_t volume; /**< voxels that trimming takes away because of it */
    sf_box box;      /**< smallest box around those voxels */
} sf_finding;

/** Counts of a check. */
typedef struct sf_check_report {
    uint32_t layer_count;        /**< layers pushed */
    uint64_t solid_voxels;       /**< |S| */
    uint64_t unsupported_voxels; /**< sum over k of |S_{k+1} \ dilate(S_k)| */
    uint64_t trimmed_voxels;     /**< |S| - |trim S| */
    uint64_t island_count;       /**< findings of kind island */
    uint64_t overhang_count;     /**< findings of kind overhang */
    uint64_t findings_dropped;   /**< findings that did not fit the caller's array */
    int support_free;            /**< 1 when unsupported_voxels is 0 */
} sf_check_report;

/** How a check runs. Fill with sf_check_options_default(). */
typedef struct sf_check_options {
    size_t struct_size;
    sf_rule rule;           /**< box3 by default */
    uint32_t width, height; /**< size of the slices that will be pushed */
    uint32_t first_layer;   /**< lattice layer of the first slice pushed */
    uint32_t run_capacity;  /**< runs of lost matter kept to link findings; 0 links none */
    sf_finding *findings;   /**< the caller's array, or NULL */
    size_t finding_capacity;
} sf_check_options;

SF_API sf_check_options sf_check_options_default(void);

/** A streaming check that keeps two slices. Lives in memory of the caller's. */
typedef struct sf_checker sf_checker;

/** Bytes of memory that sf_checker_place() needs for these options. */
SF_API SF_CHECKED sf_status sf_checker_size(const sf_check_options *options, size_t *size);

/** Set up a checker in the caller's memory (64-byte aligned, at least sf_checker_size() bytes). */
SF_API SF_CHECKED sf_status sf_checker_place(const sf_check_options *options, void *memory,
                                             size_t memory_size, sf_checker **checker);

/** Push the next layer as bits. The first layer that holds matter rests on the bed. */
SF_API SF_CHECKED sf_status sf_checker_push(sf_checker *checker, sf_slice layer);

/** Push the next layer as runs in row order. */
SF_API SF_CHECKED sf_status sf_checker_push_runs(sf_checker *checker, const sf_run *runs,
                                                 size_t count);

/** Push the next layer as 8-bit rows: solid where the value is at least `threshold`. */
SF_API SF_CHECKED sf_status sf_checker_push_grey(sf_checker *checker, const uint8_t *pixels,
                                                 size_t row_bytes, uint8_t threshold);

/** Counts so far. */
SF_API SF_CHECKED sf_status sf_checker_report(const sf_checker *checker, sf_check_report *report,
                                              size_t *finding_count);

// ---------------------------------------------------------------------------------------------
// Trim
// ---------------------------------------------------------------------------------------------

/** Bed layer chosen by the shape itself: the first slice that holds matter. */
#define SF_BED_AUTO UINT32_MAX

/** Counts of a trim. */
typedef struct sf_trim_report {
    uint64_t kept_voxels, removed_voxels;
} sf_trim_report;

/**
 * Remove everything that is not supported, from the bottom up: the largest support-free part.
 *
 * Matter below the bed layer is removed.
 */
SF_API SF_CHECKED sf_status sf_grid_trim(sf_grid *grid, const sf_rule *rule, uint32_t bed_layer,
                                         sf_task *task, sf_trim_report *report);

/**
 * Bring `printable` = trim(`drawn`) up to date after `drawn` changed within `box`: recomputes only
 * what can have changed and stops where nothing does. `drawn` may be `printable`, if the change
 * only removed matter.
 */
SF_API SF_CHECKED sf_status sf_grid_trim_box(const sf_grid *drawn, sf_grid *printable,
                                             const sf_rule *rule, uint32_t bed_layer, sf_box box,
                                             sf_box *changed);

#ifdef __cplusplus
}
#endif

#endif
