// SPDX-License-Identifier: MIT
// The chip's checker on bytes that may be anything: a job, handed over by its decoder, and a saved
// state that was damaged. Both forms must say the same of whatever is accepted, and what can be
// gone on from must be safe. (tests/core/chip_state.c forges checksums as well.)

#include "target.h"

#include <sf/chip.h>

#define W 45u
#define H 5u
#define RUNS 40u
#define PLACES 6u

typedef struct input {
    const uint8_t *data;
    size_t size, at;
} input;

static uint8_t next(input *in)
{
    return in->at < in->size ? in->data[in->at++] : 0;
}

// Rows in the input's own words: a count of runs, or grey pixels, or an end.
static sf_status decode(void *user, sf_chip *chip, uint32_t layer, uint32_t y)
{
    input *in = user;
    uint8_t what = next(in);
    uint32_t x = 0;
    (void)layer;
    (void)y;
    if (what == 255) {
        return SF_ERR_FORMAT;
    }
    if (what >= 240) {
        size_t left = in->size - in->at;
        uint32_t count = left < W ? (uint32_t)left : what == 254 ? W + 1 : W;
        count = count <= left ? count : (uint32_t)left;
        const uint8_t *pixels = in->data + in->at;
        in->at += count;
        (void)!sf_chip_grey(chip, what == 253, pixels, count, 128);
        return SF_OK;
    }
    for (uint32_t i = 0; i < what % 8u; i++) {
        // Now and then a run that lies where it must not.
        uint32_t x0 = x + next(in) % 16u, x1 = x0 + next(in) % 16u;
        x = x0 == 15 ? x0 : x1;
        (void)!sf_chip_solid(chip, x0, x1);
    }
    return SF_OK;
}

static sf_status keep(void *user, uint32_t offset, const void *bytes, size_t size)
{
    must(offset + size <= 4096, "a state stays in its store");
    memcpy((uint8_t *)user + offset, bytes, size);
    return SF_OK;
}

static sf_status give(void *user, uint32_t offset, void *bytes, size_t size)
{
    must(offset + size <= 4096, "only the store is read");
    memcpy(bytes, (uint8_t *)user + offset, size);
    return SF_OK;
}

static sf_chip *place(uint32_t run_capacity, void *memory, size_t size, sf_chip_finding *findings)
{
    sf_chip_options o = sf_chip_options_default();
    sf_chip *chip = NULL;
    o.width = W;
    o.height = H;
    o.run_capacity = run_capacity;
    o.findings = findings;
    o.finding_capacity = PLACES;
    must(sf_chip_place(&o, memory, size, &chip) == SF_OK, "a checker that can be placed");
    return chip;
}

// Push layers while there are bytes; returns the status of the last one.
static sf_status push_all(sf_chip *chip, input in)
{
    sf_status status = SF_OK;
    for (int k = 0; k < 20 && in.at < in.size && status == SF_OK; k++) {
        status = sf_chip_push(chip, decode, &in);
    }
    return status;
}

static sf_chip_counts counts_of(const sf_chip *chip)
{
    sf_chip_counts counts;
    must(sf_chip_report(chip, &counts) == SF_OK, "counts");
    must(counts.finding_count <= PLACES, "findings that there is room for");
    return counts;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static uint64_t memory[2][256];
    static uint8_t store_bytes[2][4096];
    sf_chip_finding findings[2][PLACES];
    input in = {data, size, 0};
    sf_chip *dense = place(0, memory[0], sizeof memory[0], findings[0]);
    sf_chip *runs = place(RUNS, memory[1], sizeof memory[1], findings[1]);
    sf_status a = push_all(dense, in), b = push_all(runs, in);
    if (b != SF_ERR_CAPACITY) {
        sf_chip_counts c = counts_of(dense), d = counts_of(runs);
        must(a == b && c.layers_hash == d.layers_hash && c.unsupported_hash == d.unsupported_hash &&
                 c.unsupported_voxels == d.unsupported_voxels,
             "both forms say the same");
    }
    for (int i = 0; i < 2; i++) {
        sf_chip *chip = i == 0 ? dense : runs;
        sf_chip_store store = {give, keep, store_bytes[i], 2048};
        // A state, spoilt by the input; what is taken from it must be safe to go on from.
        if (sf_chip_save(chip, &store) == SF_OK) {
            for (size_t at = 0; at + 2 < size && at < 30; at += 3) {
                store_bytes[i][(data[at] | data[at + 1] << 8) % 4096] ^= data[at + 2];
            }
        }
        sf_status status = sf_chip_resume(chip, &store);
        must(status == SF_OK || status == SF_ERR_FORMAT || status == SF_ERR_SHAPE,
             "a clear answer");
        (void)push_all(chip, in);
        (void)counts_of(chip);
    }
    return 0;
}
