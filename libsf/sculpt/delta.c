// SPDX-License-Identifier: MIT
// Delta: what one step of a history changed, as runs of a difference.
//
// A step is the exclusive or of two states, so one rule undoes it and does it again. Of each of the
// three parts, D, T and materials, it holds the box around what changed and in it, in (layer, y, x)
// order, runs: their length, the voxels between the last one and it, and for materials the value
// that all of its bytes change by. A run stays in its row; a length of 0 ends the part. Where D is
// T before and after, D is left out. A ball of 20 voxels takes some 12 bytes for each of its rows.

#include "sculpt/delta.h"

#include <string.h>

#include "base/bits.h"
#include "sculpt/rows.h"
#include "voxel/slice.h"

// What is left out of a step.
#define DRAWN_IS_PRINTABLE 1u

// ---------------------------------------------------------------------------------------------
// Writing
// ---------------------------------------------------------------------------------------------

// Runs of one part, on their way out.
typedef struct run_writer {
    sfi_step_writer *step;
    sf_box box;
    uint64_t last; // place after the last run
} run_writer;

static void put_box(sfi_step_writer *step, sf_box box)
{
    const uint32_t corners[6] = {box.x0, box.y0, box.z0, box.x1, box.y1, box.z1};
    for (int i = 0; i < 6; i++) {
        sfi_step_put(step, corners[i]);
    }
}

// Place of voxel (x, y, z) in the box, counted in order.
static uint64_t place_in(sf_box b, uint32_t x, uint32_t y, uint32_t z)
{
    uint64_t row = (uint64_t)(z - b.z0) * (b.y1 - b.y0) + (y - b.y0);
    return row * (b.x1 - b.x0) + (x - b.x0);
}

static void put_run(run_writer *w, uint64_t at, uint32_t length)
{
    sfi_step_put(w->step, length);
    sfi_step_put(w->step, at - w->last);
    w->last = at + length;
}

// Runs of bits may meet at a word's border; there they are two.
static void put_bits(sfi_step_writer *step, const sf_grid *a, const sf_grid *b,
                     const sfi_area *area, sf_box box)
{
    run_writer w = {step, box, 0};
    put_box(step, box);
    for (uint32_t z = box.z0; z < box.z1; z++) {
        sf_slice sa = sf_grid_slice(a, z), sb = sf_grid_slice(b, z);
        sf_rect r = area->rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            const uint64_t *ra = sfi_slice_row(sa, y), *rb = sfi_slice_row(sb, y);
            for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
                for (uint64_t bits = ra[i] ^ rb[i]; bits != 0;) {
                    uint32_t start, length = sfi_take_run(&bits, &start);
                    put_run(&w, place_in(box, (uint32_t)i * 64 + start, y, z), length);
                }
            }
        }
    }
    sfi_step_put(step, 0);
}

static uint32_t run_of_bytes(const uint8_t *a, const uint8_t *b, uint32_t x, uint32_t x1)
{
    uint32_t end = x + 1;
    while (end < x1 && (a[end] ^ b[end]) == (a[x] ^ b[x])) {
        end++;
    }
    return end - x;
}

static void put_materials(const sf_sculpt *m, sfi_step_writer *step, sf_box box)
{
    run_writer w = {step, box, 0};
    put_box(step, box);
    for (uint32_t z = box.z0; z < box.z1; z++) {
        sf_rect r = m->touched.material.rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            const uint8_t *a = sfi_material_row(m, &m->now, y, z);
            const uint8_t *b = sfi_material_row(m, &m->before, y, z);
            for (uint32_t x = r.x0; x < r.x1;) {
                uint32_t length = run_of_bytes(a, b, x, r.x1);
                if (a[x] != b[x]) {
                    put_run(&w, place_in(box, x, y, z), length);
                    sfi_step_put(step, (uint64_t)(a[x] ^ b[x]));
                }
                x += length;
            }
        }
    }
    sfi_step_put(step, 0);
}

// The box around the bits that differ, in an area.
static sf_box tighten_bits(const sf_grid *a, const sf_grid *b, const sfi_area *area)
{
    sf_box tight = {0, 0, 0, 0, 0, 0};
    for (uint32_t z = area->z0; z < area->z1; z++) {
        sf_slice sa = sf_grid_slice(a, z), sb = sf_grid_slice(b, z);
        sf_rect r = area->rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            const uint64_t *ra = sfi_slice_row(sa, y), *rb = sfi_slice_row(sb, y);
            for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
                sfi_box_note(&tight, i, ra[i] ^ rb[i], y, z);
            }
        }
    }
    return tight;
}

static sf_box tighten_materials(const sf_sculpt *m, const sfi_area *area)
{
    sf_box tight = {0, 0, 0, 0, 0, 0};
    for (uint32_t z = area->z0; z < area->z1; z++) {
        sf_rect r = area->rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            const uint8_t *a = sfi_material_row(m, &m->now, y, z);
            const uint8_t *b = sfi_material_row(m, &m->before, y, z);
            uint32_t x0 = r.x0, x1 = r.x1;
            while (x0 < x1 && a[x0] == b[x0]) {
                x0++;
            }
            while (x1 > x0 && a[x1 - 1] == b[x1 - 1]) {
                x1--;
            }
            sf_rect rect = {x0, y, x1, y + 1};
            tight = sfi_box_union(tight, rect, z);
        }
    }
    return tight;
}

int sfi_delta_write(sf_sculpt *m)
{
    const sfi_touch *t = &m->touched;
    sf_box printable = tighten_bits(m->now.printable, m->before.printable, &t->printable);
    sf_box drawn =
        m->options.keep_drawn ? tighten_bits(m->now.drawn, m->before.drawn, &t->drawn) : printable;
    sf_box material = tighten_materials(m, &t->material);
    if (sfi_box_is_empty(printable) && sfi_box_is_empty(drawn) && sfi_box_is_empty(material)) {
        return 0;
    }
    sfi_step_writer step = sfi_history_begin(&m->history);
    sfi_step_put(&step, m->options.keep_drawn ? 0 : DRAWN_IS_PRINTABLE);
    put_bits(&step, m->now.printable, m->before.printable, &t->printable, printable);
    if (m->options.keep_drawn) {
        put_bits(&step, m->now.drawn, m->before.drawn, &t->drawn, drawn);
    }
    put_materials(m, &step, material);
    sfi_history_end(&step);
    return 1;
}

// ---------------------------------------------------------------------------------------------
// Applying
// ---------------------------------------------------------------------------------------------

// Runs of one part, on their way in.
typedef struct run_reader {
    sfi_step_reader *step;
    sf_box box;
    uint64_t at; // place of the run, then after it
    uint32_t x, y, z, length;
} run_reader;

static sf_box get_box(sfi_step_reader *step)
{
    uint32_t corners[6];
    for (int i = 0; i < 6; i++) {
        corners[i] = (uint32_t)sfi_step_get(step);
    }
    sf_box box = {corners[0], corners[1], corners[2], corners[3], corners[4], corners[5]};
    return box;
}

// The next run; 0 where there is none.
static int next_run(run_reader *r)
{
    r->length = (uint32_t)sfi_step_get(r->step);
    if (r->length == 0) {
        return 0;
    }
    r->at += sfi_step_get(r->step);
    uint32_t nx = r->box.x1 - r->box.x0, ny = r->box.y1 - r->box.y0;
    r->x = r->box.x0 + (uint32_t)(r->at % nx);
    r->y = r->box.y0 + (uint32_t)(r->at / nx % ny);
    r->z = r->box.z0 + (uint32_t)(r->at / nx / ny);
    r->at += r->length;
    return 1;
}

static void note_run(sfi_area *touched, const run_reader *r)
{
    sf_rect rect = {r->x, r->y, r->x + r->length, r->y + 1};
    sfi_area_add(touched, rect, r->z);
}

static uint64_t count_bits(uint64_t w)
{
    w -= w >> 1 & UINT64_C(0x5555555555555555);
    w = (w & UINT64_C(0x3333333333333333)) + (w >> 2 & UINT64_C(0x3333333333333333));
    w = (w + (w >> 4)) & UINT64_C(0x0f0f0f0f0f0f0f0f);
    return w * UINT64_C(0x0101010101010101) >> 56;
}

// Turn the bits of one part; a run lies within one word. Counts what becomes solid and empty.
static sf_box apply_bits(sfi_step_reader *step, sf_grid *a, sf_grid *b, sfi_area *touched,
                         uint64_t *added, uint64_t *removed)
{
    run_reader r = {step, get_box(step), 0, 0, 0, 0, 0};
    while (next_run(&r)) {
        note_run(touched, &r);
        uint64_t ones = ~UINT64_C(0) >> (64 - r.length) << r.x % 64;
        uint64_t *word = sfi_slice_row(sf_grid_slice(a, r.z), r.y) + r.x / 64;
        *removed += count_bits(*word & ones);
        *word ^= ones;
        *added += count_bits(*word & ones);
        if (b != NULL) {
            sfi_slice_row(sf_grid_slice(b, r.z), r.y)[r.x / 64] ^= ones;
        }
    }
    return r.box;
}

static sf_box apply_materials(sf_sculpt *m, sfi_step_reader *step)
{
    run_reader r = {step, get_box(step), 0, 0, 0, 0, 0};
    while (next_run(&r)) {
        uint8_t value = (uint8_t)sfi_step_get(step);
        note_run(&m->touched.material, &r);
        uint8_t *row = sfi_material_row(m, &m->now, r.y, r.z) + r.x;
        for (uint32_t i = 0; i < r.length; i++) {
            row[i] ^= value;
        }
    }
    return r.box;
}

void sfi_delta_apply(sf_sculpt *m, sfi_step_reader *reader, sf_sculpt_change *change)
{
    sf_sculpt_change made = {0};
    uint64_t ignored[2] = {0, 0};
    int is_one = sfi_step_get(reader) == DRAWN_IS_PRINTABLE;
    made.printable = apply_bits(reader, m->now.printable, is_one ? m->now.drawn : NULL,
                                &m->touched.printable, &made.added_voxels, &made.removed_voxels);
    made.drawn = is_one ? made.printable
                        : apply_bits(reader, m->now.drawn, NULL, &m->touched.drawn, &ignored[0],
                                     &ignored[1]);
    if (is_one) {
        sfi_area_join(&m->touched.drawn, &m->touched.printable);
    }
    made.material = apply_materials(m, reader);
    *change = made;
}
