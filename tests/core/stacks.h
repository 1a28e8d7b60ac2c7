// SPDX-License-Identifier: MIT
// Stacks of layers as bytes, a decoder that hands them to a chip's checker in several ways, and a
// judgement of them voxel by voxel, which shares no thought with either checker.

#ifndef SF_TESTS_STACKS_H
#define SF_TESTS_STACKS_H

#include "test.h"

#include <sf/chip.h>

#define STACK_BYTES_MAX 40000
#define STACK_FINDINGS_MAX 4000

// How a row is handed over.
enum { AS_RUNS, AS_SINGLE_VOXELS, AS_GREY, FORM_COUNT };

typedef struct stack {
    uint32_t width, height, layers;
    int form;
    int fails_at; // row, counted over all calls, whose decoding fails; -1: none
    int rows_decoded;
    uint8_t solid[STACK_BYTES_MAX];
} stack;

static inline uint8_t *stack_row(stack *s, uint32_t z, uint32_t y)
{
    return s->solid + ((size_t)z * s->height + y) * s->width;
}

static inline int stack_get(stack *s, int64_t z, int64_t y, int64_t x)
{
    return z >= 0 && y >= 0 && x >= 0 && z < s->layers && y < s->height && x < s->width &&
           stack_row(s, (uint32_t)z, (uint32_t)y)[x];
}

// A random stack of blobs: each layer is the one below, moved, with holes and grains.
static inline void stack_random(stack *s, uint32_t width, uint32_t height, uint32_t layers)
{
    uint32_t grains = test_random_below(30), keep = 60 + test_random_below(41);
    int empty = (int)test_random_below(3);
    s->width = width;
    s->height = height;
    s->layers = layers;
    s->form = (int)test_random_below(FORM_COUNT);
    s->fails_at = -1;
    s->rows_decoded = 0;
    memset(s->solid, 0, sizeof s->solid);
    for (uint32_t z = (uint32_t)empty; z < layers; z++) {
        int dx = (int)test_random_below(5) - 2, dy = (int)test_random_below(3) - 1;
        for (uint32_t y = 0; y < height; y++) {
            for (uint32_t x = 0; x < width; x++) {
                int below = stack_get(s, (int64_t)z - 1, (int64_t)y + dy, (int64_t)x + dx);
                int fresh = test_random_below(100) < (z == (uint32_t)empty ? 50 : grains);
                stack_row(s, z, y)[x] = (uint8_t)(below ? test_random_below(100) < keep : fresh);
            }
        }
    }
}

static inline sf_status stack_decode_runs(const stack *s, sf_chip *chip, const uint8_t *row)
{
    for (uint32_t x = 0; x < s->width;) {
        uint32_t x0 = x;
        while (x < s->width && row[x]) {
            x++;
            if (s->form == AS_SINGLE_VOXELS) {
                break;
            }
        }
        if (x == x0) {
            x++;
            continue;
        }
        sf_status status = sf_chip_solid(chip, x0, x);
        if (status != SF_OK) {
            return status;
        }
    }
    return SF_OK;
}

// The decoder; user is a stack whose layer 0 has the lattice's number `first`, which is 0 here.
static inline sf_status stack_decode(void *user, sf_chip *chip, uint32_t layer, uint32_t y)
{
    stack *s = user;
    if (s->rows_decoded++ == s->fails_at) {
        return SF_ERR_IO;
    }
    const uint8_t *row = stack_row(s, layer % 1000, y);
    if (s->form != AS_GREY) {
        return stack_decode_runs(s, chip, row);
    }
    // In two pieces, the first of which may be empty.
    uint8_t grey[STACK_BYTES_MAX];
    uint32_t cut = s->width / 3;
    for (uint32_t x = 0; x < s->width; x++) {
        grey[x] = (uint8_t)(row[x] ? 128 + x % 128 : x % 128);
    }
    sf_status status = sf_chip_grey(chip, 0, grey, cut, 128);
    return status != SF_OK ? status : sf_chip_grey(chip, cut, grey + cut, s->width - cut, 128);
}

// ---------------------------------------------------------------------------------------------
// The judgement
// ---------------------------------------------------------------------------------------------

typedef struct judgement {
    sf_chip_counts counts;
    sf_chip_finding findings[STACK_FINDINGS_MAX];
} judgement;

static inline uint64_t judge_mix(uint64_t hash, uint64_t value)
{
    hash = (hash ^ value) * UINT64_C(0x9e3779b97f4a7c15);
    return hash ^ hash >> 32;
}

static inline int judge_carried(stack *s, const sf_element *e, uint32_t z, uint32_t y, uint32_t x)
{
    for (int dy = -(int)e->reach_y; dy <= (int)e->reach_y; dy++) {
        int w = e->half_width[dy < 0 ? -dy : dy];
        for (int dx = -w; dx <= w; dx++) {
            if (stack_get(s, (int64_t)z - 1, (int64_t)y + dy, (int64_t)x + dx)) {
                return 1;
            }
        }
    }
    return 0;
}

static inline void judge_run(judgement *j, uint32_t k, uint32_t y, uint32_t x0, uint32_t x1,
                             int is_finding)
{
    uint64_t number = (uint64_t)y << 32 | (uint64_t)x1 << 16 | x0;
    sf_chip_counts *c = &j->counts;
    if (!is_finding) {
        c->solid_voxels += x1 - x0;
        c->layers_hash = judge_mix(c->layers_hash, number);
        return;
    }
    if (c->unsupported_runs < STACK_FINDINGS_MAX) {
        sf_chip_finding finding = {k, y, x0, x1};
        j->findings[c->unsupported_runs] = finding;
    }
    c->unsupported_runs++;
    c->unsupported_voxels += x1 - x0;
    c->unsupported_hash = judge_mix(c->unsupported_hash, number);
}

static inline void judge_row(stack *s, const sf_element *e, uint32_t k, uint32_t z, uint32_t y,
                             int is_on_bed, judgement *j)
{
    uint8_t bad[STACK_BYTES_MAX];
    for (uint32_t x = 0; x < s->width; x++) {
        bad[x] = (uint8_t)(stack_get(s, z, y, x) && !is_on_bed && !judge_carried(s, e, z, y, x));
    }
    for (int pass = 0; pass < 2; pass++) {
        const uint8_t *row = pass == 0 ? stack_row(s, z, y) : bad;
        for (uint32_t x = 0; x < s->width; x++) {
            uint32_t x0 = x;
            while (x < s->width && row[x]) {
                x++;
            }
            if (x > x0) {
                judge_run(j, k, y, x0, x, pass);
            }
        }
    }
}

static inline void stack_judge(stack *s, const sf_rule *rule, uint32_t first, uint32_t bed,
                               judgement *j)
{
    memset(j, 0, sizeof *j);
    j->counts.bed_layer = bed;
    for (uint32_t z = 0; z < s->layers; z++) {
        uint32_t k = first + z;
        sf_element element = {0, {0}};
        uint64_t before = j->counts.unsupported_voxels;
        if (z > 0) {
            CHECK_EQ(sf_rule_element(rule, k - 1, &element), SF_OK);
        }
        int is_on_bed = j->counts.bed_layer == SF_BED_AUTO || j->counts.bed_layer == k;
        for (uint32_t y = 0; y < s->height; y++) {
            judge_row(s, &element, k, z, y, is_on_bed, j);
        }
        if (j->counts.bed_layer == SF_BED_AUTO && j->counts.solid_voxels > 0) {
            j->counts.bed_layer = k;
        }
        j->counts.unsupported_layers += j->counts.unsupported_voxels > before;
        j->counts.layers_hash = judge_mix(j->counts.layers_hash, (uint64_t)1 << 63 | k);
        j->counts.unsupported_hash = judge_mix(j->counts.unsupported_hash, (uint64_t)1 << 63 | k);
        j->counts.layer_count++;
    }
    j->counts.support_free = j->counts.unsupported_voxels == 0;
}

// Every count of a report, against those of another.
static inline void check_counts(const sf_chip_counts *a, const sf_chip_counts *b)
{
    CHECK_EQ(a->layer_count, b->layer_count);
    CHECK_EQ(a->bed_layer, b->bed_layer);
    CHECK_EQ(a->unsupported_layers, b->unsupported_layers);
    CHECK_EQ(a->finding_count, b->finding_count);
    CHECK_EQ(a->solid_voxels, b->solid_voxels);
    CHECK_EQ(a->unsupported_voxels, b->unsupported_voxels);
    CHECK_EQ(a->unsupported_runs, b->unsupported_runs);
    CHECK_EQ(a->layers_hash, b->layers_hash);
    CHECK_EQ(a->unsupported_hash, b->unsupported_hash);
    CHECK_EQ(a->support_free, b->support_free);
}

#endif
