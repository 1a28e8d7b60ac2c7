// SPDX-License-Identifier: MIT
// Applying deltas: a step of the history undone, or done again.
//
// With no stroke under way both states of a model are the same, so a step turns the bits of both in
// one go. It can lie in a hundred thousand lines of the cache, six for each row, and
// waiting for one after the other would take longer than all else. So some dozens of runs are read
// at a time; while the next ones are read, the memory of those before them is on its way.

#include <string.h>

#include "base/ahead.h"
#include "sculpt/delta.h"
#include "sculpt/rows.h"
#include "voxel/slice.h"

// Runs that are read at a time, and bytes of a line of the cache, or fewer.
#define BATCH 64u
#define LINE 64u

// A run, and where its row begins.
typedef struct placed_run {
    sfi_run run;
    size_t row; // of all rows of the grid
} placed_run;

// Runs on their way in. What they turn is summed up for all that do the same.
typedef struct run_reader {
    sfi_step_reader step;
    uint32_t ny;
    sfi_run at;
    uint32_t first_x, y, z;
    sf_box around; // runs of one deed
    sf_sculpt_change made;
} run_reader;

// What runs turn: words of grids and bytes, of both states.
typedef struct ground {
    uint64_t *drawn[2], *printable[2];
    uint8_t *materials[2];
    size_t stride, nx; // words and bytes of a row
} ground;

// ---------------------------------------------------------------------------------------------
// Reading
// ---------------------------------------------------------------------------------------------

// What was summed up belongs to the boxes of what such runs turn.
static void sum_up(run_reader *r)
{
    uint32_t deed = r->at.deed;
    sf_sculpt_change *made = &r->made;
    const sf_box none = {UINT32_MAX, UINT32_MAX, UINT32_MAX, 0, 0, 0};
    if (deed & SFI_TURNS_DRAWN) {
        made->drawn = sfi_box_join(made->drawn, r->around);
    }
    if (deed & SFI_TURNS_PRINTABLE) {
        made->printable = sfi_box_join(made->printable, r->around);
    }
    if (deed & 255) {
        made->material = sfi_box_join(made->material, r->around);
    }
    r->around = none;
}

static inline void note(run_reader *r)
{
    sf_box *b = &r->around;
    uint32_t x0 = r->at.x, x1 = x0 + r->at.length;
    b->x0 = x0 < b->x0 ? x0 : b->x0;
    b->x1 = x1 > b->x1 ? x1 : b->x1;
    b->y0 = r->y < b->y0 ? r->y : b->y0;
    b->y1 = r->y >= b->y1 ? r->y + 1 : b->y1;
    b->z0 = r->z < b->z0 ? r->z : b->z0;
    b->z1 = r->z + 1; // they only go up
}

static inline int64_t unfold(uint64_t a)
{
    return a & 1 ? -(int64_t)((a + 1) >> 1) : (int64_t)(a >> 1);
}

// Go on by some rows.
static inline void go_down(run_reader *r, uint64_t rows)
{
    uint64_t y = r->y + rows;
    if (y >= r->ny) {
        r->z += (uint32_t)(y / r->ny);
        y %= r->ny;
    }
    r->y = (uint32_t)y;
}

// The next run; 0 where there is none.
static inline int next_run(run_reader *r)
{
    uint64_t code = sfi_step_get(&r->step);
    if (code < 4) {
        return 0;
    }
    if ((code & 2) != 0) {
        go_down(r, sfi_step_get(&r->step));
        r->first_x = (uint32_t)(r->first_x + unfold(sfi_step_get(&r->step)));
        r->at.x = r->first_x;
    } else {
        r->at.x += r->at.length + (uint32_t)sfi_step_get(&r->step);
    }
    r->at.length = (uint32_t)(code >> 2);
    if ((code & 1) != 0) {
        sum_up(r);
        r->at.deed = (uint32_t)sfi_step_get(&r->step);
    }
    note(r);
    return 1;
}

// ---------------------------------------------------------------------------------------------
// Turning
// ---------------------------------------------------------------------------------------------

// The run at hand into a place of its own; its memory is asked for.
static inline void place(const run_reader *r, const ground *g, placed_run *to)
{
    placed_run p = {r->at, (size_t)r->z * r->ny + r->y};
    size_t word = p.row * g->stride + p.run.x / 64, byte = p.row * g->nx + p.run.x;
    sfi_ask_for(g->drawn[0] + word);
    sfi_ask_for(g->drawn[1] + word);
    sfi_ask_for(g->printable[0] + word);
    sfi_ask_for(g->printable[1] + word);
    for (int s = 0; s < 2; s++) {
        sfi_ask_for(g->materials[s] + byte + p.run.length - 1);
        for (uint32_t x = 0; x < p.run.length; x += LINE) {
            sfi_ask_for(g->materials[s] + byte + x);
        }
    }
    *to = p;
}

// Turn the bits of a run in its row; returns how many were set.
static inline uint64_t turn_bits(uint64_t *row, sfi_run r)
{
    uint32_t last_x = r.x + r.length - 1;
    size_t last = last_x / 64;
    uint64_t ones = ~UINT64_C(0) << r.x % 64, were = 0;
    for (size_t i = r.x / 64; i <= last; i++, ones = ~UINT64_C(0)) {
        ones = i < last ? ones : ones & ~UINT64_C(0) >> (63 - last_x % 64);
        were += sfi_count_bits(row[i] & ones);
        row[i] ^= ones;
    }
    return were;
}

static inline void put_eight(uint8_t *row, uint8_t *before, uint64_t word)
{
    memcpy(row, &word, sizeof word);
    memcpy(before, &word, sizeof word);
}

// Change bytes of both states. The last eight are read before any is written, so it does no harm
// that others overlap them.
static inline void change_bytes(uint8_t *row, uint8_t *before, uint32_t length, uint8_t by)
{
    uint64_t eight = by * UINT64_C(0x0101010101010101);
    if (length >= 8) {
        uint64_t end = sfi_load_eight(row + length - 8) ^ eight;
        for (uint32_t x = 0; x + 8 < length; x += 8) {
            put_eight(row + x, before + x, sfi_load_eight(row + x) ^ eight);
        }
        put_eight(row + length - 8, before + length - 8, end);
        return;
    }
    for (uint32_t x = 0; x < length; x++) {
        row[x] ^= by;
        before[x] = row[x];
    }
}

// One part after the other, so that what is done for a run is short, and that for many is under
// way at once.
static void turn_all(const ground *g, const placed_run *runs, size_t count, sf_sculpt_change *made)
{
    int is_shared = g->drawn[1] == g->printable[1]; // then what turned there has turned
    for (const placed_run *p = runs; p < runs + count; p++) {
        if (p->run.deed & SFI_TURNS_PRINTABLE) {
            size_t word = p->row * g->stride;
            uint64_t were = turn_bits(g->printable[0] + word, p->run);
            (void)turn_bits(g->printable[1] + word, p->run);
            made->removed_voxels += were;
            made->added_voxels += p->run.length - were;
        }
    }
    for (const placed_run *p = runs; p < runs + count; p++) {
        if (p->run.deed & SFI_TURNS_DRAWN) {
            size_t word = p->row * g->stride;
            (void)turn_bits(g->drawn[0] + word, p->run);
            if (!is_shared) {
                (void)turn_bits(g->drawn[1] + word, p->run);
            }
        }
    }
    for (const placed_run *p = runs; p < runs + count; p++) {
        if (p->run.deed & 255) {
            size_t byte = p->row * g->nx + p->run.x;
            change_bytes(g->materials[0] + byte, g->materials[1] + byte, p->run.length,
                         (uint8_t)p->run.deed);
        }
    }
}

static ground ground_of(const sf_sculpt *m)
{
    sf_slice slice = sf_grid_slice(m->now.drawn, 0);
    ground g = {
        {slice.words, sf_grid_slice(m->before.drawn, 0).words},
        {sf_grid_slice(m->now.printable, 0).words, sf_grid_slice(m->before.printable, 0).words},
        {m->now.materials, m->before.materials},
        slice.stride,
        m->lattice.nx};
    return g;
}

void sfi_delta_apply(const sf_sculpt *m, sfi_step_reader step, sf_sculpt_change *change)
{
    // Before the first row of the first layer.
    run_reader r = {.step = step, .ny = m->lattice.ny, .y = m->lattice.ny - 1, .z = UINT32_MAX};
    ground g = ground_of(m);
    placed_run runs[BATCH];
    size_t count;
    sum_up(&r);
    do {
        for (count = 0; count < BATCH && next_run(&r); count++) {
            place(&r, &g, &runs[count]);
        }
        turn_all(&g, runs, count, &r.made);
    } while (count == BATCH);
    sum_up(&r);
    *change = r.made;
}
