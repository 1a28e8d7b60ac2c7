// SPDX-License-Identifier: MIT
// Chip: does a job print without supports, asked by the printer itself, while it reads the job.
//
// The checker of <sf/support.h> keeps four slices and names what it finds. This one is for a
// processor with kilobytes: it asks only whether each layer lies within what the layer below, as
// it was drawn, can carry, counts what does not, and notes the first places. One layer is all that
// it remembers, in one of two forms:
//
//   * dense: a slice of bits, which the next layer overwrites row by row while it is checked, and
//     reach + 2 rows beside it (three for elements that reach one row);
//   * run-length: at most so many runs of each of two layers, 6 bytes a run, whatever the pixels.
//     A layer of more runs is refused.
//
// Both read a job through one callback, which decodes a row, and both come to the same counts and
// the same hashes, on every machine. Work on a row is bounded by its words or by its runs. No
// memory but the caller's, no floating point, no recursion, and of the C library only memcpy and
// memset.
//
// What may rest on what comes as a table that is made where the job is made, sf_chip_rule_make(),
// and lies in the chip's read-only memory. After any layer the state can be saved, in two places in
// turn; after a power cut sf_chip_resume() goes on with the newer one that is whole.

#ifndef SF_CHIP_H
#define SF_CHIP_H

#include <sf/support.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Rule
// ---------------------------------------------------------------------------------------------

/** Most different elements that a table of a chip can hold. */
#define SF_CHIP_ELEMENT_MAX 255u

/**
 * A support rule as a table of bytes: the elements that its steps have, and which step has which.
 *
 * Element i begins at elements[i * (reach + 2)]: first its reach_y, at most `reach`, then its half
 * widths, reach_y + 1 of them, which never grow. The bytes belong to whoever made them.
 */
typedef struct sf_chip_rule {
    const uint8_t *elements; /**< element_count elements of reach + 2 bytes each */
    const uint8_t *steps;    /**< element of the step from layer first_layer + i to the next, for i
                                  below step_count; NULL: all steps have element 0 */
    uint32_t step_count;     /**< steps that `steps` has; 0 where it is NULL */
    uint32_t first_layer;    /**< lattice layer below the first of these steps */
    uint8_t element_count;   /**< elements, at least one */
    uint8_t reach;           /**< largest reach_y of an element */
} sf_chip_rule;

/**
 * Turn a rule into the table that a chip reads.
 *
 * The table is the same bytes on every machine. Where all steps have one element it has no steps
 * and serves any number of layers.
 *
 * @param rule         a rule that is an element for each step: box3, octagon or disk, no bridges
 * @param first_layer  lattice layer of the first slice that will be checked
 * @param layer_count  slices that the table must serve, at least 1
 * @param memory       for the table's bytes, kept by `table`; may be NULL where memory_size is 0
 * @param memory_size  bytes of it
 * @param size         bytes used; with SF_ERR_CAPACITY at least those needed, for another try
 * @param table        the table
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no layers, a rule that sf_rule_make() did not
 * make or that does not serve all the layers; SF_ERR_UNSUPPORTED: slack or bridges, which need more
 * than an element, or more than SF_CHIP_ELEMENT_MAX different elements; SF_ERR_CAPACITY: too little
 * memory.
 * @cost O(layers * elements * reach).   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_chip_rule_make(const sf_rule *rule, uint32_t first_layer,
                                              uint32_t layer_count, uint8_t *memory,
                                              size_t memory_size, size_t *size,
                                              sf_chip_rule *table);

// ---------------------------------------------------------------------------------------------
// Checker
// ---------------------------------------------------------------------------------------------

/** Voxels x0 <= x < x1 of one row that the layer below does not carry. */
typedef struct sf_chip_finding {
    uint32_t layer;  /**< lattice layer */
    uint32_t y;      /**< row */
    uint32_t x0, x1; /**< half-open, as long as it can be */
} sf_chip_finding;

/**
 * Counts of a check. All are exact, and the same for both forms and on every machine.
 *
 * The hashes tell two jobs apart by accident, not by intent: they are no seal. layers_hash is over
 * every maximal run of every layer in order, unsupported_hash over every maximal run that is not
 * carried; both are 0 before the first layer.
 */
typedef struct sf_chip_counts {
    uint32_t layer_count;        /**< layers checked */
    uint32_t bed_layer;          /**< the bed layer; SF_BED_AUTO while there was no matter */
    uint32_t unsupported_layers; /**< layers with a voxel that is not carried */
    uint32_t finding_count;      /**< findings in the caller's array: the first ones */
    uint64_t solid_voxels;       /**< |S| */
    uint64_t unsupported_voxels; /**< sum over k of what of S_{k+1} is not carried by S_k as drawn,
                                      as sf_check_report has it */
    uint64_t unsupported_runs;   /**< in how many runs of rows these lie */
    uint64_t layers_hash;        /**< of what was read */
    uint64_t unsupported_hash;   /**< of what is not carried */
    int support_free;            /**< 1 when unsupported_voxels is 0 */
} sf_chip_counts;

/** How a chip checks. Fill with sf_chip_options_default(). */
typedef struct sf_chip_options {
    size_t struct_size;     /**< sizeof(sf_chip_options), set by the default */
    sf_chip_rule rule;      /**< box3 by default; its bytes must outlive the checker */
    uint32_t width, height; /**< size of the layers, in voxels; must be set */
    uint32_t first_layer;   /**< lattice layer of the first one */
    uint32_t bed_layer;     /**< lattice layer that rests on the bed, or SF_BED_AUTO (default) */
    uint32_t run_capacity;  /**< 0: dense (default); else run-length, with so many runs a layer */
    sf_chip_finding *findings; /**< the caller's array, or NULL for counts only (default). Places
                                    past finding_count may be written too */
    uint32_t finding_capacity; /**< places in it */
    uint32_t job; /**< any number that tells jobs apart: a saved state of another one is
                       refused */
} sf_chip_options;

/** A check on a chip; lies in memory of the caller's. */
typedef struct sf_chip sf_chip;

/**
 * Decodes row `y` of layer `layer`: called once for each row, y rising from 0, while a layer is
 * pushed. It hands what is solid to sf_chip_solid() or sf_chip_grey(), and returns SF_OK; any other
 * status ends the push, which returns it. It must call nothing else of the checker that it is
 * given.
 */
typedef sf_status (*sf_chip_decode)(void *user, sf_chip *chip, uint32_t layer, uint32_t y);

/**
 * Options of a check on a chip: rule box3, dense, bed by the shape itself, no findings.
 *
 * @return the options; width and height are 0 and must be set.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_chip_options sf_chip_options_default(void);

/**
 * Bytes of memory that sf_chip_place() needs for these options; the same on every machine.
 *
 * Dense: 384 bytes, and 4 for every 32 voxels of a row, for height + reach + 2 rows. Run-length:
 * 400 bytes, 12 for each run of run_capacity, 16 for each row of reach.
 *
 * @param options  the options that the checker will be placed with
 * @param size     the bytes
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, width or
 * height outside 1..SF_EXTENT_MAX, a first or a bed layer of SF_LAYER_MAX or more, a bed layer
 * below the first, a capacity without findings, a table that is none; SF_ERR_OVERFLOW: a size that
 * does not fit the machine.
 * @cost O(bytes of the table).   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_chip_size(const sf_chip_options *options, size_t *size);

/**
 * Set up a check in the caller's memory, before its first layer.
 *
 * The findings array and the rule's bytes stay the caller's and must live as long as the checker is
 * used; the options are copied.
 *
 * @param options      the options
 * @param memory       8-byte aligned; apart from what the findings lie in
 * @param memory_size  its size in bytes, at least sf_chip_size()
 * @param chip         the checker, which lies in `memory`
 * @return SF_OK; what sf_chip_size() says; SF_ERR_ARGUMENT: a NULL pointer, memory that is not
 * aligned; SF_ERR_CAPACITY: too little memory.
 * @cost O(memory).   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_chip_place(const sf_chip_options *options, void *memory,
                                          size_t memory_size, sf_chip **chip);

/**
 * Check the next layer, which a callback decodes row by row.
 *
 * When it fails the counts are as before the call. A run-length checker may then be given the layer
 * again. A dense one has written over the layer below: it returns the same status from then on,
 * until sf_chip_resume() or sf_chip_place() makes it new.
 *
 * @param chip    the checker
 * @param decode  decodes one row
 * @param user    handed to decode; may be NULL
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a call from within decode, runs that are empty,
 * leave the row or are out of order, a table without a step to this layer; SF_ERR_CAPACITY: the
 * layer has more than run_capacity runs; SF_ERR_OVERFLOW: the layer would be number SF_LAYER_MAX;
 * what decode returned.
 * @cost a row: dense, its words times (2 reach + 4), and those of widening, fewer than the largest
 * half width; run-length, (its runs + the runs below within reach) * (2 reach + 1). At most 512
 * bytes of stack on a processor of 32 bits, beside what decode takes.
 * @threads one per checker.
 * @source T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
 * Eurographics 2016, section 3.2 (a slice is checked against the one below).
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_chip_push(sf_chip *chip, sf_chip_decode decode, void *user);

/**
 * Called by a decoder: voxels x0 <= x < x1 of its row are solid.
 *
 * Runs go from left to right; they may touch, and then count as one.
 *
 * @param chip  the checker that decode was given
 * @param x0    first column
 * @param x1    the column after the last
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no decoder at work, a run that is empty, leaves
 * the row or begins before the end of the last one; SF_ERR_CAPACITY: more than run_capacity runs in
 * the layer. The push fails with that status, whatever the decoder returns then.
 * @cost dense: O(length / 32); run-length: constant.   @threads one per checker.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_chip_solid(sf_chip *chip, uint32_t x0, uint32_t x1);

/**
 * Called by a decoder: pixels of its row from column x on, solid where they are at least
 * `threshold`.
 *
 * @param chip       the checker that decode was given
 * @param x          column of the first pixel
 * @param pixels     one byte each; may be NULL where count is 0
 * @param count      number of pixels
 * @param threshold  1 to 255; 0 makes all of them solid
 * @return as sf_chip_solid(); SF_ERR_ARGUMENT also: pixels that are NULL.
 * @cost O(count).   @threads one per checker.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_chip_grey(sf_chip *chip, uint32_t x, const uint8_t *pixels,
                                         uint32_t count, uint8_t threshold);

/**
 * Counts so far.
 *
 * @param chip    the checker
 * @param counts  the counts
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer.
 * @cost constant.   @threads one per checker.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_chip_report(const sf_chip *chip, sf_chip_counts *counts);

// ---------------------------------------------------------------------------------------------
// State
// ---------------------------------------------------------------------------------------------

/**
 * Memory that lasts when the power goes: two slots, one from 0, the other from slot_size on.
 *
 * `write` is called with offsets that rise within a slot, but for the last call, which writes its
 * first bytes; it may erase a slot at the first call of a save. Both return SF_OK or a status,
 * which is passed on.
 */
typedef struct sf_chip_store {
    sf_status (*read)(void *user, uint32_t offset, void *data,
                      size_t size); /**< gives back bytes; any, where none were written */
    sf_status (*write)(void *user, uint32_t offset, const void *data,
                       size_t size); /**< keeps bytes */
    void *user;                      /**< handed to both; may be NULL */
    uint32_t slot_size;              /**< bytes of one slot, at least sf_chip_slot_size() */
} sf_chip_store;

/**
 * Bytes of one slot of a store that every state of a checker fits.
 *
 * @param chip  the checker; NULL has none
 * @param size  the bytes
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_OVERFLOW: two slots of it do not fit 32
 * bits.
 * @cost constant.   @threads one per checker.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_chip_slot_size(const sf_chip *chip, uint32_t *size);

/**
 * Save the state after the last layer, into the slot that does not hold the last saved one.
 *
 * What is written first is the layer, what is written last, 84 bytes at the slot's beginning, says
 * that it is whole; so a cut at any moment leaves the other slot, which is not touched. The bytes
 * are the same on every machine.
 *
 * @param chip   the checker
 * @param store  where to
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a call from within decode, a slot that is too
 * small, a dense checker whose last push failed; SF_ERR_OVERFLOW: as sf_chip_slot_size(); what
 * write returned, after which the state may be saved again.
 * @cost O(bytes saved).   @threads one per checker.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_chip_save(sf_chip *chip, const sf_chip_store *store);

/**
 * Go on with the newest state in a store that is whole: counts, findings, the last layer.
 *
 * layer_count of the counts says which layer to push next. A store that was saved into by a checker
 * of other options is refused.
 *
 * @param chip   the checker, placed with the options that it had when the state was saved; as it
 *               was when the call fails
 * @param store  where from
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a call from within decode; SF_ERR_FORMAT: neither
 * slot holds a whole state; SF_ERR_SHAPE: the newest whole one is of other options; SF_ERR_IO: what
 * was whole a moment before is not so any more, and the checker waits for another try; what read
 * returned, where no slot could be read.
 * @cost two passes over the bytes saved.   @threads one per checker.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_chip_resume(sf_chip *chip, const sf_chip_store *store);

#ifdef __cplusplus
}
#endif

#endif
