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
                     const sfi_area *area)
{
    sf_box box = sfi_area_bounds(area);
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

static uint64_t load_eight(const uint8_t *bytes)
{
    uint64_t word;
    memcpy(&word, bytes, sizeof word);
    return word;
}

// How many bytes from x on differ as the one at x does: eight at a time while they can be.
static uint32_t run_of_bytes(const uint8_t *a, const uint8_t *b, uint32_t x, uint32_t x1)
{
    uint32_t end = x + 1;
    uint64_t same = (uint64_t)(a[x] ^ b[x]) * UINT64_C(0x0101010101010101);
    while (end + 8 <= x1 && (load_eight(a + end) ^ load_eight(b + end)) == same) {
        end += 8;
    }
    while (end < x1 && (a[end] ^ b[end]) == (a[x] ^ b[x])) {
        end++;
    }
    return end - x;
}

static void put_materials(const sf_sculpt *m, sfi_step_writer *step, const sfi_area *area)
{
    sf_box box = sfi_area_bounds(area);
    run_writer w = {step, box, 0};
    put_box(step, box);
    for (uint32_t z = box.z0; z < box.z1; z++) {
        sf_rect r = area->rects[z];
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

static int bits_differ(const sf_grid *a, const sf_grid *b, const sfi_area *area)
{
    for (uint32_t z = area->z0; z < area->z1; z++) {
        sf_slice sa = sf_grid_slice(a, z), sb = sf_grid_slice(b, z);
        sf_rect r = area->rects[z];
        size_t first = sfi_rect_first_word(r), words = sfi_rect_end_word(r) - first;
        for (uint32_t y = r.y0; y < r.y1; y++) {
            if (memcmp(sfi_slice_row(sa, y) + first, sfi_slice_row(sb, y) + first,
                       words * sizeof(uint64_t)) != 0) {
                return 1;
            }
        }
    }
    return 0;
}

static int materials_differ(const sf_sculpt *m, const sfi_area *area)
{
    for (uint32_t z = area->z0; z < area->z1; z++) {
        sf_rect r = area->rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            if (memcmp(sfi_material_row(m, &m->now, y, z) + r.x0,
                       sfi_material_row(m, &m->before, y, z) + r.x0, r.x1 - r.x0) != 0) {
                return 1;
            }
        }
    }
    return 0;
}

int sfi_delta_write(sf_sculpt *m)
{
    const sfi_touch *t = &m->touched;
    if (!bits_differ(m->now.printable, m->before.printable, &t->printable) &&
        !bits_differ(m->now.drawn, m->before.drawn, &t->drawn) &&
        !materials_differ(m, &t->material)) {
        return 0;
    }
    sfi_step_writer step = sfi_ring_begin(&m->history);
    sfi_step_put(&step, m->options.keep_drawn ? 0 : DRAWN_IS_PRINTABLE);
    put_bits(&step, m->now.printable, m->before.printable, &t->printable);
    if (m->options.keep_drawn) {
        put_bits(&step, m->now.drawn, m->before.drawn, &t->drawn);
    }
    put_materials(m, &step, &t->material);
    sfi_ring_end(&step);
    return 1;
}

// ---------------------------------------------------------------------------------------------
// Applying
// ---------------------------------------------------------------------------------------------

// Runs of one part, on their way in.
typedef struct run_reader {
    sfi_step_reader *step;
    sf_box box;
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

// The next run; 0 where there is none. Most begin in the row after that of the last one.
static int next_run(run_reader *r)
{
    uint32_t nx = r->box.x1 - r->box.x0, ny = r->box.y1 - r->box.y0;
    uint64_t x = (uint64_t)(r->x - r->box.x0) + r->length, rows = 0;
    r->length = (uint32_t)sfi_step_get(r->step);
    if (r->length == 0) {
        return 0;
    }
    x += sfi_step_get(r->step);
    rows = x < nx ? 0 : x < 2 * (uint64_t)nx ? 1 : x / nx;
    uint64_t y = r->y - r->box.y0 + rows;
    r->x = r->box.x0 + (uint32_t)(x - rows * nx);
    r->z += y < ny ? 0 : (uint32_t)(y / ny);
    r->y = r->box.y0 + (uint32_t)(y < ny ? y : y % ny);
    return 1;
}

static run_reader begin_runs(sfi_step_reader *step)
{
    sf_box box = get_box(step);
    run_reader r = {step, box, box.x0, box.y0, box.z0, 0};
    return r;
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
static void apply_bits(sfi_step_reader *step, sf_grid *a, sf_grid *b, sfi_area *touched,
                       uint64_t *added, uint64_t *removed)
{
    run_reader r = begin_runs(step);
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
}

static void apply_materials(sf_sculpt *m, sfi_step_reader *step)
{
    run_reader r = begin_runs(step);
    while (next_run(&r)) {
        uint8_t value = (uint8_t)sfi_step_get(step);
        note_run(&m->touched.material, &r);
        uint8_t *row = sfi_material_row(m, &m->now, r.y, r.z) + r.x;
        for (uint32_t i = 0; i < r.length; i++) {
            row[i] ^= value;
        }
    }
}

void sfi_delta_apply(sf_sculpt *m, sfi_step_reader *reader, sf_sculpt_change *change)
{
    sf_sculpt_change made = {0};
    uint64_t ignored[2] = {0, 0};
    int is_one = sfi_step_get(reader) == DRAWN_IS_PRINTABLE;
    apply_bits(reader, m->now.printable, is_one ? m->now.drawn : NULL, &m->touched.printable,
               &made.added_voxels, &made.removed_voxels);
    if (is_one) {
        sfi_area_join(&m->touched.drawn, &m->touched.printable);
    } else {
        apply_bits(reader, m->now.drawn, NULL, &m->touched.drawn, &ignored[0], &ignored[1]);
    }
    apply_materials(m, reader);
    sfi_sculpt_boxes(&m->touched, &made);
    *change = made;
}
