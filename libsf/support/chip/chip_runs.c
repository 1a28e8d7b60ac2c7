// SPDX-License-Identifier: MIT
// A layer as runs, checked against the runs of the layer below.
//
// Row y of the new layer is carried by the rows y - r .. y + r of the old one, each run widened by
// the half width of its row. For a new run [x0, x1) a front p moves from x0 to x1: where some old
// run, widened, covers p, p jumps to the farthest end among those that do; where none does, nothing
// is carried up to where the next one begins. p only grows along a row, so each row within reach
// has one cursor that only moves on, and a row costs (its runs + the old runs within reach) times
// (2 r + 1), whatever the width. Nothing is stored but cursors.
//
// The runs of the two layers lie in two arrays that change places; the new one becomes the old one
// only when its last row has been judged, so a layer that fails leaves the old one whole.
//
// Freestanding.
//
// Source: the front is a sweep over the union of intervals (V. Klee, "Can the measure of the union
// of [a_i, b_i] be computed in less than O(n log n) steps?", American Mathematical Monthly 84,
// 1977), sorted beforehand, row by row.

#include "support/chip/chip.h"

#include "base/status.h"

// The first run of the old layer from `from` on that lies in row y or a later one.
static uint32_t first_of_row(const sfi_chip_runs *r, uint32_t from, uint32_t y)
{
    while (from < r->below_count && r->below[from].y < y) {
        from++;
    }
    return from;
}

void sfi_chip_runs_begin(sf_chip *chip)
{
    sfi_chip_runs *r = &chip->form.runs;
    uint32_t reach = chip->rule.reach;
    r->here_count = 0;
    // Before row 0, rows -reach - 1 .. reach: the first begin_row() moves on by one.
    for (uint32_t i = 0; i < 2 * reach + 2; i++) {
        uint32_t before = i > 0 ? r->starts[i - 1] : 0;
        r->starts[i] = i > reach ? first_of_row(r, before, i - reach - 1) : 0;
    }
}

void sfi_chip_runs_begin_row(sf_chip *chip)
{
    sfi_chip_runs *r = &chip->form.runs;
    uint32_t last = 2u * chip->rule.reach + 1;
    r->row_begin = r->here_count;
    for (uint32_t i = 0; i < last; i++) {
        r->starts[i] = r->starts[i + 1];
    }
    r->starts[last] = first_of_row(r, r->starts[last], chip->y + chip->rule.reach + 1);
}

sf_status sfi_chip_runs_add(sf_chip *chip, uint32_t x0, uint32_t x1)
{
    sfi_chip_runs *r = &chip->form.runs;
    if (r->here_count > r->row_begin && r->here[r->here_count - 1].x1 == x0) {
        r->here[r->here_count - 1].x1 = (uint16_t)x1;
        return SF_OK;
    }
    if (r->here_count == chip->run_capacity) {
        return SF_ERR_CAPACITY;
    }
    sfi_chip_run *run = &r->here[r->here_count++];
    run->y = (uint16_t)chip->y;
    run->x0 = (uint16_t)x0;
    run->x1 = (uint16_t)x1;
    return SF_OK;
}

// Whether anything covers column p; *end becomes where that ends, or, where nothing does, where the
// next begins, at most `most`.
static int is_covered(sf_chip *chip, uint32_t p, uint32_t most, uint32_t *end)
{
    const sfi_chip_runs *r = &chip->form.runs;
    uint32_t reach = chip->rule.reach, rows = chip->element[0], farthest = p, next = most;
    for (uint32_t i = reach - rows; i <= reach + rows; i++) {
        uint32_t w = sfi_chip_half_width(chip->element, i > reach ? i - reach : reach - i);
        uint32_t at = r->cursors[i];
        while (at < r->starts[i + 1] && r->below[at].x1 + w <= p) {
            at++;
        }
        r->cursors[i] = at;
        if (at == r->starts[i + 1]) {
            continue;
        }
        uint32_t x0 = r->below[at].x0, x1 = r->below[at].x1 + w;
        if (x0 <= p + w) {
            farthest = x1 > farthest ? x1 : farthest;
        } else {
            next = x0 - w < next ? x0 - w : next;
        }
    }
    *end = farthest > p ? farthest : next;
    return farthest > p;
}

void sfi_chip_runs_judge(sf_chip *chip)
{
    sfi_chip_runs *r = &chip->form.runs;
    for (uint32_t i = 0; i < 2u * chip->rule.reach + 1; i++) {
        r->cursors[i] = r->starts[i];
    }
    for (uint32_t i = r->row_begin; i < r->here_count; i++) {
        uint32_t p = r->here[i].x0, x1 = r->here[i].x1, end;
        sfi_chip_count(chip, p, x1);
        if (chip->is_on_bed) {
            continue;
        }
        if (chip->element == NULL) {
            sfi_chip_note(chip, p, x1);
            continue;
        }
        for (; p < x1; p = end) {
            if (!is_covered(chip, p, x1, &end)) {
                sfi_chip_note(chip, p, end);
            }
        }
    }
}
