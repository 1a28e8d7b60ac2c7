// SPDX-License-Identifier: MIT
// Delta: what one step of a history changed, as runs of a difference.
//
// A step is the exclusive or of two states, so one rule undoes it and does it again. It holds, in
// (layer, y, x) order, runs of voxels in a row that change alike. What a run does is one number,
// its deed: by what its bytes of material change, whether its bits of D turn, and whether those of
// T do. It is put down
//
//     4 * length + 2 * (is in another row than the last one) + (does something else than that)
//     in another row: how many rows farther on, and x less that of the last row's first run;
//     else the voxels between the last run and it
//     what it does, if that is something else
//
// and a length of 0 ends the step. A ball of 20 voxels takes some 4 bytes for each of its rows.
//
// Writing a step brings `before` up to date on the way, so that what did not change is looked at
// once, and never copied. How a step is read, delta_apply.c says.

#include "sculpt/delta.h"

#include <string.h>

#include "base/ahead.h"
#include "base/bits.h"
#include "sculpt/rows.h"
#include "voxel/slice.h"

// Rows between one that is written and the one whose memory is asked for.
#define AHEAD 6u

// ---------------------------------------------------------------------------------------------
// Writing
// ---------------------------------------------------------------------------------------------

// Runs on their way out, of which the last is held back until it is known to end.
typedef struct run_writer {
    sf_sculpt *model;
    sfi_step_writer step; // begun with the first run
    int is_begun;
    sfi_run held;                  // of length 0: there is none
    uint64_t row;                  // of it, counted from 1
    uint64_t last;                 // row of the last run that was written
    uint32_t first_x, end_x, deed; // of that row's first run; of that run
} run_writer;

// A signed number as one that is small where it is near 0.
static uint64_t fold(int64_t a)
{
    return a < 0 ? ((uint64_t)-a << 1) - 1 : (uint64_t)a << 1;
}

static void begin(run_writer *w)
{
    w->step = sfi_ring_begin(&w->model->history);
    w->is_begun = 1;
}

// Write the run that is held back.
static void flush(run_writer *w)
{
    sfi_run r = w->held;
    if (r.length == 0) {
        return;
    }
    if (!w->is_begun) {
        begin(w);
    }
    unsigned is_below = w->row != w->last, is_other = r.deed != w->deed;
    sfi_step_put(&w->step, (uint64_t)r.length * 4 + 2 * is_below + is_other);
    if (is_below) {
        sfi_step_put(&w->step, w->row - w->last);
        sfi_step_put(&w->step, fold((int64_t)r.x - w->first_x));
        w->first_x = r.x;
    } else {
        sfi_step_put(&w->step, r.x - w->end_x);
    }
    if (is_other) {
        sfi_step_put(&w->step, r.deed);
    }
    w->last = w->row;
    w->end_x = r.x + r.length;
    w->deed = r.deed;
    w->held.length = 0;
}

static void put_run(run_writer *w, uint64_t row, sfi_run r)
{
    sfi_run *held = &w->held;
    if (held->length > 0 && w->row == row && held->x + held->length == r.x &&
        held->deed == r.deed) {
        held->length += r.length;
        return;
    }
    flush(w);
    w->held = r;
    w->row = row;
}

// ---------------------------------------------------------------------------------------------
// Comparing
// ---------------------------------------------------------------------------------------------

// A row of both states.
typedef struct row_pair {
    uint64_t *drawn, *printable, *drawn_before, *printable_before;
    uint8_t *materials, *materials_before;
} row_pair;

// Rows of one layer.
typedef struct layer_pair {
    sf_slice drawn, printable, drawn_before, printable_before;
    uint8_t *materials, *materials_before;
    uint32_t nx;
} layer_pair;

static layer_pair layer_of(const sf_sculpt *m, uint32_t z)
{
    layer_pair l = {sf_grid_slice(m->now.drawn, z),
                    sf_grid_slice(m->now.printable, z),
                    sf_grid_slice(m->before.drawn, z),
                    sf_grid_slice(m->before.printable, z),
                    sfi_material_row(m, &m->now, 0, z),
                    sfi_material_row(m, &m->before, 0, z),
                    m->lattice.nx};
    return l;
}

static row_pair row_of(const layer_pair *l, uint32_t y)
{
    size_t at = (size_t)y * l->nx;
    row_pair r = {sfi_slice_row(l->drawn, y),
                  sfi_slice_row(l->printable, y),
                  sfi_slice_row(l->drawn_before, y),
                  sfi_slice_row(l->printable_before, y),
                  l->materials + at,
                  l->materials_before + at};
    return r;
}

// How many of `length` bytes from x on differ as the one at x does: eight at a time while they can
// be.
static uint32_t run_of_bytes(const uint8_t *a, const uint8_t *b, uint32_t x, uint32_t length)
{
    uint32_t end = x + 1, x1 = x + length;
    uint64_t same = (uint64_t)(a[x] ^ b[x]) * UINT64_C(0x0101010101010101);
    while (end + 8 <= x1 && (sfi_load_eight(a + end) ^ sfi_load_eight(b + end)) == same) {
        end += 8;
    }
    while (end < x1 && (a[end] ^ b[end]) == (a[x] ^ b[x])) {
        end++;
    }
    return end - x;
}

// How many bits of a word from `start` on are like that one, up to `length`.
static uint32_t run_of_bits(uint64_t bits, uint32_t start, uint32_t length)
{
    uint64_t rest = bits >> start, other = rest & 1 ? ~rest : rest;
    uint32_t same = other != 0 ? sfi_lowest_bit(other) : 64;
    return same < length ? same : length;
}

// The first `*length` voxels from bit `start` on that change alike; less where not all do.
static sfi_run next_alike(const row_pair *r, size_t i, uint32_t start, uint32_t length,
                          uint64_t drawn, uint64_t printable)
{
    sfi_run found = {(uint32_t)i * 64 + start, length, 0};
    found.length = run_of_bits(drawn, start, found.length);
    found.length = run_of_bits(printable, start, found.length);
    found.length = run_of_bytes(r->materials, r->materials_before, found.x, found.length);
    found.deed = (uint32_t)(r->materials[found.x] ^ r->materials_before[found.x]) |
                 (drawn >> start & 1 ? SFI_TURNS_DRAWN : 0) |
                 (printable >> start & 1 ? SFI_TURNS_PRINTABLE : 0);
    return found;
}

// Whether materials of layer z may have changed where voxels stayed drawn, or empty: of all brushes
// only one does that, and without a stroke under way another shape took the place of all. Where;
// else nowhere.
static sf_rect maybe_painted(const sf_sculpt *m, uint32_t z)
{
    sf_rect nowhere = {0, 0, 0, 0};
    return m->is_under_way && m->brush.kind != SF_BRUSH_PAINT
               ? nowhere
               : sfi_area_rect(&m->touched.material, z);
}

// Word i of a row: write what changed of `painted` and of whatever was turned, and bring what was
// before up to date.
static void settle_word(run_writer *w, const row_pair *r, uint64_t row, size_t i, uint64_t painted)
{
    uint64_t drawn = r->drawn[i] ^ r->drawn_before[i];
    uint64_t printable = r->printable[i] ^ r->printable_before[i];
    for (uint64_t any = drawn | printable | painted; any != 0;) {
        uint32_t start, length = sfi_take_run(&any, &start);
        for (uint32_t end = start + length; start < end;) {
            sfi_run one = next_alike(r, i, start, end - start, drawn, printable);
            if (one.deed != 0) {
                put_run(w, row, one);
            }
            if ((one.deed & 255) != 0) {
                memcpy(r->materials_before + one.x, r->materials + one.x, one.length);
            }
            start += one.length;
        }
    }
    r->drawn_before[i] = r->drawn[i];
    r->printable_before[i] = r->printable[i];
}

// Row y of layer z, within r. Shapes go on from row to row: where the last run was, some rows below
// there will be another one, whose memory is asked for.
static void settle_row(run_writer *w, const layer_pair *layer, sf_rect r, uint32_t y, uint32_t z)
{
    const sf_sculpt *m = w->model;
    row_pair rows = row_of(layer, y);
    uint64_t number = (uint64_t)z * m->lattice.ny + y + 1;
    sf_rect paint = maybe_painted(m, z);
    const uint64_t *tips = sfi_slice_row(sf_grid_slice(m->tips, z), y);
    size_t first = sfi_rect_first_word(paint);
    size_t end = y >= paint.y0 && y < paint.y1 ? sfi_rect_end_word(paint) : first;
    if (w->held.length > 0 && y + AHEAD < m->lattice.ny) {
        size_t word = AHEAD * layer->drawn.stride + w->held.x / 64;
        size_t byte = (size_t)AHEAD * m->lattice.nx + w->held.x, last = byte + w->held.length - 1;
        sfi_ask_for(rows.drawn_before + word);
        sfi_ask_for(rows.printable_before + word);
        sfi_ask_for(rows.materials + byte);
        sfi_ask_for(rows.materials + last);
        sfi_ask_for(rows.materials_before + byte);
        sfi_ask_for(rows.materials_before + last);
    }
    for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
        uint64_t all =
            i + 1 < sfi_row_words(m->lattice.nx) ? ~UINT64_C(0) : sfi_tail_mask(m->lattice.nx);
        uint64_t painted = i < first || i >= end ? 0 : m->is_under_way ? tips[i] : all;
        settle_word(w, &rows, number, i, painted);
    }
}

int sfi_delta_write(sf_sculpt *m)
{
    run_writer w = {.model = m};
    sfi_area *area = &m->work;
    sfi_area_clear(area);
    sfi_area_join(area, &m->touched.drawn);
    sfi_area_join(area, &m->touched.printable);
    sfi_area_join(area, &m->touched.material);
    for (uint32_t z = area->z0; z < area->z1; z++) {
        layer_pair layer = layer_of(m, z);
        for (uint32_t y = area->rects[z].y0; y < area->rects[z].y1; y++) {
            settle_row(&w, &layer, area->rects[z], y, z);
        }
    }
    flush(&w);
    if (w.is_begun) {
        sfi_step_put(&w.step, 0);
        sfi_ring_end(&w.step);
    }
    return w.is_begun;
}
