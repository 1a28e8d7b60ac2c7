// SPDX-License-Identifier: MIT
// What the files of the chip's checker share: the checker itself, and how a row is judged.

#ifndef SF_SUPPORT_CHIP_CHIP_H
#define SF_SUPPORT_CHIP_CHIP_H

#include <sf/chip.h>

// Bytes that a checker takes before its layers, on every machine.
#define SFI_CHIP_STATE_SIZE 384u

// Voxels x0 <= x < x1 of row y. Coordinates fit 16 bits: SF_EXTENT_MAX.
typedef struct sfi_chip_run {
    uint16_t y, x0, x1;
} sfi_chip_run;

// A slice of bits: voxel x is bit x % 32 of word x / 32 of its row. Bits past the width are zero.
typedef struct sfi_chip_dense {
    uint32_t *slice; // rows below y are of the layer being pushed, the others of the one below
    uint32_t *saved; // the last `reach` rows of the layer below: row y in place y % reach
    uint32_t *row;   // the row being decoded
    uint32_t *rest;  // scratch
    uint32_t words;  // of a row
} sfi_chip_dense;

// Two layers of runs, in row order. Rows of the layer below that lie within reach begin at
// starts[0 .. 2 reach + 1]: row y - reach + i at starts[i], and the last is where the next begins.
typedef struct sfi_chip_runs {
    sfi_chip_run *below, *here;
    uint32_t below_count, here_count;
    uint32_t row_begin; // first run of the row being decoded
    uint32_t *starts;
    uint32_t *cursors;
} sfi_chip_runs;

struct sf_chip {
    sf_chip_rule rule;
    uint32_t width, height, first_layer, bed_layer, run_capacity, finding_capacity;
    uint32_t options_crc;
    sf_chip_finding *findings;
    sf_chip_counts counts;  // after the last layer
    sf_chip_counts now;     // with what the layer being pushed has added so far
    uint32_t sequence;      // of the last state saved or resumed; 0: none yet
    sf_status failed;       // dense: why the layer below is lost
    uint32_t y, row_x;      // the row being decoded, and how far it is
    sf_status row_status;   // what was wrong with what was handed over
    uint8_t is_open;        // whether a decoder is at work
    uint8_t is_on_bed;      // whether all of this layer is carried
    const uint8_t *element; // of the step to this layer, or NULL: nothing is carried
    union {
        sfi_chip_dense dense;
        sfi_chip_runs runs;
    } form;
};

static inline int sfi_chip_is_dense(const sf_chip *chip)
{
    return chip->run_capacity == 0;
}

// Words of a row of bits.
static inline uint32_t sfi_chip_words(uint32_t width)
{
    return (width + 31) / 32;
}

// Half width of an element of a table dy rows away.
static inline uint32_t sfi_chip_half_width(const uint8_t *element, uint32_t dy)
{
    return element[1 + dy];
}

// chip.c: count a maximal run of the row being judged; note one that is not carried.
void sfi_chip_count(sf_chip *chip, uint32_t x0, uint32_t x1);
void sfi_chip_note(sf_chip *chip, uint32_t x0, uint32_t x1);

// chip_dense.c, chip_runs.c: make the layer below empty; begin a layer; take in a run that has been
// checked, or SF_ERR_CAPACITY; judge the row that has been decoded, and go on.
void sfi_chip_dense_clear(sf_chip *chip);
void sfi_chip_dense_begin_row(sf_chip *chip);
void sfi_chip_dense_add(sf_chip *chip, uint32_t x0, uint32_t x1);
void sfi_chip_dense_judge(sf_chip *chip);
void sfi_chip_runs_begin(sf_chip *chip);
void sfi_chip_runs_begin_row(sf_chip *chip);
sf_status sfi_chip_runs_add(sf_chip *chip, uint32_t x0, uint32_t x1);
void sfi_chip_runs_judge(sf_chip *chip);

// chip_state.c: what a saved state says of the options that it was made with.
uint32_t sfi_chip_options_crc(const sf_chip_options *options);

#endif
