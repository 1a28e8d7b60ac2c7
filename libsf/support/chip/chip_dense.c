// SPDX-License-Identifier: MIT
// A layer as bits, checked in the place of the layer below.
//
// Row y of the new layer overwrites row y of the old one as soon as it has been judged. What later
// rows still ask of the old layer above that place, its last `reach` rows, is kept in a ring. So
// the memory is one slice and reach + 2 rows: the ring, the row being decoded, and a row of
// scratch.
//
// What is carried in row y is the union over dy of the rows y - dy and y + dy of the old layer,
// each widened by the element's half width. Half widths never grow with dy, so widening is nested:
//
//     acc = row(0);   for dy = 1, 2, ...: widen acc by w(dy - 1) - w(dy), then unite with rows +-dy
//
// and at the end widen by the last half width (Horner's scheme on sets). Widening by s unites a
// word with itself shifted, in place, in steps that leave no gap: what covers [0, r] beside the
// border may step by r + 1.
//
// Words have 32 bits, because that is what small processors have. Freestanding.

#include "base/bits.h"
#include "base/bytes.h"
#include "support/chip/chip.h"

void sfi_chip_dense_clear(sf_chip *chip)
{
    const sfi_chip_dense *d = &chip->form.dense;
    memset(d->slice, 0, (size_t)chip->height * d->words * sizeof *d->slice);
}

void sfi_chip_dense_begin_row(sf_chip *chip)
{
    memset(chip->form.dense.row, 0, chip->form.dense.words * sizeof(uint32_t));
}

void sfi_chip_dense_add(sf_chip *chip, uint32_t x0, uint32_t x1)
{
    uint32_t *row = chip->form.dense.row, first = x0 / 32, last = (x1 - 1) / 32;
    uint32_t head = ~UINT32_C(0) << (x0 % 32), tail = ~UINT32_C(0) >> (31 - (x1 - 1) % 32);
    if (first == last) {
        row[first] |= head & tail;
        return;
    }
    row[first] |= head;
    for (uint32_t i = first + 1; i < last; i++) {
        row[i] = ~UINT32_C(0);
    }
    row[last] |= tail;
}

// Row y of the old layer, for any y within reach of the row being judged, or NULL outside it.
static const uint32_t *old_row(const sf_chip *chip, int64_t y)
{
    const sfi_chip_dense *d = &chip->form.dense;
    if (y < 0 || y >= (int64_t)chip->height) {
        return NULL;
    }
    uint32_t at = (uint32_t)y;
    if (at >= chip->y) {
        return d->slice + (size_t)at * d->words;
    }
    return d->saved + (size_t)(at % chip->rule.reach) * d->words;
}

static void unite(uint32_t *acc, const uint32_t *row, uint32_t words)
{
    for (uint32_t i = 0; row != NULL && i < words; i++) {
        acc[i] |= row[i];
    }
}

// One step of widening, 1 <= s <= 31, in place.
static void widen_once(uint32_t *acc, uint32_t words, uint32_t s)
{
    uint32_t before = 0, here = acc[0];
    for (uint32_t i = 0; i < words; i++) {
        uint32_t after = i + 1 < words ? acc[i + 1] : 0;
        acc[i] = here | here << s | before >> (32 - s) | here >> s | after << (32 - s);
        before = here;
        here = after;
    }
}

static void widen(uint32_t *acc, uint32_t words, uint32_t s)
{
    uint32_t reached = 0;
    while (reached < s) {
        uint32_t step = s - reached < reached + 1 ? s - reached : reached + 1;
        step = step > 31 ? 31 : step;
        widen_once(acc, words, step);
        reached += step;
    }
}

// acc = what the old layer carries in the row being judged. Bits past the width may be set.
static void carry(const sf_chip *chip, uint32_t *acc)
{
    const uint8_t *e = chip->element;
    uint32_t words = chip->form.dense.words, y = chip->y, w = sfi_chip_half_width(e, 0);
    memcpy(acc, old_row(chip, y), words * sizeof *acc);
    for (uint32_t dy = 1; dy <= e[0]; dy++) {
        uint32_t narrower = sfi_chip_half_width(e, dy);
        widen(acc, words, w - narrower);
        w = narrower;
        unite(acc, old_row(chip, (int64_t)y - dy), words);
        unite(acc, old_row(chip, (int64_t)y + dy), words);
    }
    widen(acc, words, w);
}

// The first column >= from whose bit, exclusive-ored with flip (0 or all ones), is set; or the
// width.
static uint32_t find(const uint32_t *row, uint32_t width, uint32_t from, uint32_t flip)
{
    if (from >= width) {
        return width;
    }
    uint32_t words = sfi_chip_words(width), i = from / 32;
    uint32_t w = (row[i] ^ flip) & (~UINT32_C(0) << (from % 32));
    while (w == 0) {
        if (++i == words) {
            return width;
        }
        w = row[i] ^ flip;
    }
    uint32_t x = i * 32 + sfi_lowest_bit32(w);
    return x < width ? x : width;
}

// Count the runs of a row, or note them as findings. No function is handed over for it, so that how
// deep the stack gets can be read off the calls.
static void take_runs(sf_chip *chip, const uint32_t *row, int are_findings)
{
    uint32_t x0 = find(row, chip->width, 0, 0);
    while (x0 < chip->width) {
        uint32_t x1 = find(row, chip->width, x0, ~UINT32_C(0));
        if (are_findings) {
            sfi_chip_note(chip, x0, x1);
        } else {
            sfi_chip_count(chip, x0, x1);
        }
        x0 = find(row, chip->width, x1, 0);
    }
}

void sfi_chip_dense_judge(sf_chip *chip)
{
    const sfi_chip_dense *d = &chip->form.dense;
    uint32_t *old = d->slice + (size_t)chip->y * d->words;
    take_runs(chip, d->row, 0);
    if (!chip->is_on_bed) {
        if (chip->element != NULL) {
            carry(chip, d->rest);
        } else {
            memset(d->rest, 0, d->words * sizeof *d->rest);
        }
        for (uint32_t i = 0; i < d->words; i++) {
            d->rest[i] = d->row[i] & ~d->rest[i];
        }
        take_runs(chip, d->rest, 1);
    }
    if (chip->rule.reach > 0) {
        uint32_t *kept = d->saved + (size_t)(chip->y % chip->rule.reach) * d->words;
        memcpy(kept, old, d->words * sizeof *kept);
    }
    memcpy(old, d->row, d->words * sizeof *old);
}
