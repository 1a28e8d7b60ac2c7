// SPDX-License-Identifier: MIT
// The checker on a chip: what both of its forms do alike.
//
// Of the layers pushed so far only the last one matters, and only as it is drawn (S). Layer k + 1
// is support-free when it lies within S_k dilated by the step's element; what does not is counted,
// and the next layer is judged as if it had been carried. So one layer is remembered, where the
// full checker (support/check) remembers what trimming leaves as well, and names causes.
//
// A layer comes row by row: the form begins the row, the decoder hands over its runs, the form
// judges it against the rows of the layer below that its element reaches. Both forms count the same
// maximal runs in the same order, so counts and hashes are the same.
//
// Counts of a layer are made in a copy, which becomes the truth as its last row has been judged.
// Findings are written at once, behind those that count, where nobody looks yet.
//
// Freestanding: integers, no memory but the caller's, no libc but memcpy and memset.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 3.2 (a slice is checked against the one below).

#include "support/chip/chip.h"

#include "base/bytes.h"
#include "base/size.h"
#include "base/status.h"

// The size that is told is that of the largest machine.
typedef char state_fits[sizeof(sf_chip) <= SFI_CHIP_STATE_SIZE ? 1 : -1];

// Box3 as a table: reach 1, three voxels in each row.
static const uint8_t box3[] = {1, 1, 1};

// ---------------------------------------------------------------------------------------------
// Placing
// ---------------------------------------------------------------------------------------------

static int is_element_good(const uint8_t *element, uint32_t reach)
{
    if (element[0] > reach) {
        return 0;
    }
    for (uint32_t dy = 1; dy <= element[0]; dy++) {
        if (sfi_chip_half_width(element, dy) > sfi_chip_half_width(element, dy - 1)) {
            return 0;
        }
    }
    return 1;
}

static int is_rule_good(const sf_chip_rule *rule)
{
    if (rule->elements == NULL || rule->element_count == 0 ||
        (rule->steps == NULL && rule->step_count > 0)) {
        return 0;
    }
    for (uint32_t i = 0; i < rule->element_count; i++) {
        if (!is_element_good(rule->elements + i * (rule->reach + 2u), rule->reach)) {
            return 0;
        }
    }
    for (uint32_t i = 0; i < rule->step_count; i++) {
        if (rule->steps[i] >= rule->element_count) {
            return 0;
        }
    }
    return 1;
}

static int are_options_good(const sf_chip_options *o)
{
    return o != NULL && o->struct_size >= sizeof *o && o->width > 0 && o->height > 0 &&
           o->width <= SF_EXTENT_MAX && o->height <= SF_EXTENT_MAX &&
           o->first_layer < SF_LAYER_MAX &&
           (o->bed_layer == SF_BED_AUTO ||
            (o->bed_layer >= o->first_layer && o->bed_layer < SF_LAYER_MAX)) &&
           (o->finding_capacity == 0 || o->findings != NULL) && is_rule_good(&o->rule);
}

sf_chip_options sf_chip_options_default(void)
{
    sf_chip_options o = {.struct_size = sizeof o, .bed_layer = SF_BED_AUTO};
    o.rule.elements = box3;
    o.rule.element_count = 1;
    o.rule.reach = 1;
    return o;
}

sf_status sf_chip_size(const sf_chip_options *options, size_t *size)
{
    if (!are_options_good(options) || size == NULL) {
        return SF_ERR_ARGUMENT;
    }
    uint32_t reach = options->rule.reach;
    size_t count, each;
    if (options->run_capacity == 0) {
        count = (size_t)options->height + reach + 2;
        each = (size_t)sfi_chip_words(options->width) * 4;
    } else {
        // Two layers of runs, and 2 * (2 * reach + 2) places for rows.
        count = options->run_capacity;
        each = 2 * sizeof(sfi_chip_run);
    }
    size_t bytes, rows = options->run_capacity == 0 ? 0 : 16 * (size_t)reach + 16;
    if (!sfi_size_mul(count, each, &bytes) ||
        !sfi_size_add(bytes, rows + SFI_CHIP_STATE_SIZE, size)) {
        return SF_ERR_OVERFLOW;
    }
    return SF_OK;
}

static void place_form(sf_chip *chip)
{
    unsigned char *at = (unsigned char *)chip + SFI_CHIP_STATE_SIZE;
    if (sfi_chip_is_dense(chip)) {
        sfi_chip_dense *d = &chip->form.dense;
        d->words = sfi_chip_words(chip->width);
        d->slice = (uint32_t *)(void *)at;
        d->saved = d->slice + (size_t)chip->height * d->words;
        d->row = d->saved + (size_t)chip->rule.reach * d->words;
        d->rest = d->row + d->words;
        sfi_chip_dense_clear(chip);
    } else {
        sfi_chip_runs *r = &chip->form.runs;
        r->starts = (uint32_t *)(void *)at;
        r->cursors = r->starts + 2 * chip->rule.reach + 2;
        r->below = (sfi_chip_run *)(void *)(r->cursors + 2 * chip->rule.reach + 2);
        r->here = r->below + chip->run_capacity;
        r->below_count = 0;
    }
}

sf_status sf_chip_place(const sf_chip_options *options, void *memory, size_t memory_size,
                        sf_chip **chip)
{
    size_t size;
    SF_TRY(sf_chip_size(options, &size));
    if (memory == NULL || chip == NULL || (uintptr_t)memory % 8 != 0) {
        return SF_ERR_ARGUMENT;
    }
    if (memory_size < size) {
        return SF_ERR_CAPACITY;
    }
    sf_chip *c = memory;
    memset(c, 0, sizeof *c);
    c->rule = options->rule;
    c->width = options->width;
    c->height = options->height;
    c->first_layer = options->first_layer;
    c->bed_layer = options->bed_layer;
    c->run_capacity = options->run_capacity;
    c->findings = options->findings;
    c->finding_capacity = options->finding_capacity;
    c->options_crc = sfi_chip_options_crc(options);
    c->counts.bed_layer = options->bed_layer;
    c->counts.support_free = 1;
    place_form(c);
    *chip = c;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Counting
// ---------------------------------------------------------------------------------------------

// One more number into a hash; every earlier one still tells (multiplication by an odd number and
// the shift can both be undone).
static uint64_t mix(uint64_t hash, uint64_t value)
{
    hash = (hash ^ value) * UINT64_C(0x9e3779b97f4a7c15);
    return hash ^ hash >> 32;
}

static uint64_t run_number(const sf_chip *chip, uint32_t x0, uint32_t x1)
{
    return (uint64_t)chip->y << 32 | x1 << 16 | x0;
}

void sfi_chip_count(sf_chip *chip, uint32_t x0, uint32_t x1)
{
    chip->now.solid_voxels += x1 - x0;
    chip->now.layers_hash = mix(chip->now.layers_hash, run_number(chip, x0, x1));
}

void sfi_chip_note(sf_chip *chip, uint32_t x0, uint32_t x1)
{
    sf_chip_counts *now = &chip->now;
    if (now->finding_count < chip->finding_capacity) {
        sf_chip_finding *finding = &chip->findings[now->finding_count++];
        finding->layer = chip->first_layer + now->layer_count;
        finding->y = chip->y;
        finding->x0 = x0;
        finding->x1 = x1;
    }
    now->unsupported_voxels += x1 - x0;
    now->unsupported_runs++;
    now->unsupported_hash = mix(now->unsupported_hash, run_number(chip, x0, x1));
}

// ---------------------------------------------------------------------------------------------
// Pushing
// ---------------------------------------------------------------------------------------------

// The element of the step to layer k, which is not the first.
static sf_status find_element(const sf_chip *chip, uint32_t k, const uint8_t **element)
{
    const sf_chip_rule *rule = &chip->rule;
    uint32_t index = 0;
    if (rule->steps != NULL) {
        if (k - 1 < rule->first_layer || k - 1 - rule->first_layer >= rule->step_count) {
            return SF_ERR_ARGUMENT;
        }
        index = rule->steps[k - 1 - rule->first_layer];
    }
    *element = rule->elements + index * (rule->reach + 2u);
    return SF_OK;
}

static sf_status push_row(sf_chip *chip, sf_chip_decode decode, void *user, uint32_t k)
{
    int is_dense = sfi_chip_is_dense(chip);
    chip->row_x = 0;
    if (is_dense) {
        sfi_chip_dense_begin_row(chip);
    } else {
        sfi_chip_runs_begin_row(chip);
    }
    chip->is_open = 1;
    sf_status status = decode(user, chip, k, chip->y);
    chip->is_open = 0;
    SF_TRY(chip->row_status);
    SF_TRY(status);
    if (is_dense) {
        sfi_chip_dense_judge(chip);
    } else {
        sfi_chip_runs_judge(chip);
    }
    return SF_OK;
}

static void end_layer(sf_chip *chip, uint32_t k)
{
    sf_chip_counts *now = &chip->now;
    if (now->bed_layer == SF_BED_AUTO && now->solid_voxels > 0) {
        now->bed_layer = k;
    }
    now->unsupported_layers += now->unsupported_voxels > chip->counts.unsupported_voxels;
    now->support_free = now->unsupported_voxels == 0;
    // Layers are told apart by a number that no run has.
    now->layers_hash = mix(now->layers_hash, (uint64_t)1 << 63 | k);
    now->unsupported_hash = mix(now->unsupported_hash, (uint64_t)1 << 63 | k);
    now->layer_count++;
    chip->counts = *now;
    if (!sfi_chip_is_dense(chip)) {
        sfi_chip_runs *r = &chip->form.runs;
        sfi_chip_run *swap = r->below;
        r->below = r->here;
        r->here = swap;
        r->below_count = r->here_count;
    }
}

sf_status sf_chip_push(sf_chip *chip, sf_chip_decode decode, void *user)
{
    if (chip == NULL || decode == NULL || chip->is_open) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(chip->failed);
    if (chip->counts.layer_count >= SF_LAYER_MAX - chip->first_layer) {
        return SF_ERR_OVERFLOW;
    }
    uint32_t k = chip->first_layer + chip->counts.layer_count, bed = chip->counts.bed_layer;
    chip->element = NULL;
    if (chip->counts.layer_count > 0) {
        SF_TRY(find_element(chip, k, &chip->element));
    }
    chip->now = chip->counts;
    chip->row_status = SF_OK;
    chip->is_on_bed = bed == SF_BED_AUTO || bed == k;
    if (!sfi_chip_is_dense(chip)) {
        sfi_chip_runs_begin(chip);
    }
    for (chip->y = 0; chip->y < chip->height; chip->y++) {
        sf_status status = push_row(chip, decode, user, k);
        if (status != SF_OK) {
            chip->failed = sfi_chip_is_dense(chip) ? status : SF_OK;
            return status;
        }
    }
    end_layer(chip, k);
    return SF_OK;
}

sf_status sf_chip_report(const sf_chip *chip, sf_chip_counts *counts)
{
    if (chip == NULL || counts == NULL) {
        return SF_ERR_ARGUMENT;
    }
    *counts = chip->counts;
    return SF_OK;
}
