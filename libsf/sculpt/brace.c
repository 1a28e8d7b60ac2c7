// SPDX-License-Identifier: MIT
// Brace: what add-grow puts below tips that would not be carried.
//
// Let U be the union of the tips on or above the bed, T what is printable of the shape with U and
// the paths below it, and F = T + U, within the rectangle around the boxes of the tips, as far as
// they lie in the grid, and a tip's width more on every side. From the top layer of U down to the
// bed, with X_k what is added in layer k:
//
//     A = U_{k+1} + X_{k+1}              what must stand in the layer above
//     R = A \ dilate(F_k)                what of it nothing carries
//     X_k = carriers of R, each a step nearer to F_k than what it carries; and straight below what
//           has no F_k to come nearer to
//
// A voxel of U or X is carried by F or X below it, one of T by T; so T + U + X is support-free, and
// all of U is printable. As each layer is nearer by a whole step, what hangs leans towards what
// stands as steeply as the rule lets it, and meets it as a capital does its column.
//
// How near, in steps, is told by dilating F_k again and again. A carrier of v lies within a step of
// it, so its distance is one less, the same or one more; hence distances modulo 3 are enough, and
// three bits a voxel hold them: near[d % 3]. Of carriers those straight below come first, then by
// rings (support/preserve/priority.c).
//
// Under rules with slack or bridges a layer's bits do not tell what carries: there every voxel of U
// that is not printable gets a column down to the bed, which carries under any rule.

#include "base/memory.h"
#include "base/status.h"
#include "sculpt/model.h"
#include "sculpt/near.h"
#include "sculpt/rows.h"
#include "sculpt/tip.h"
#include "support/preserve/cover.h"
#include "support/rule/carry.h"
#include "voxel/slice.h"

enum {
    ABOVE,
    FIXED,
    REST,
    ADDED,
    SPREAD,
    NEAR,
    REACHED = NEAR + 3,
    WITHIN,
    HERE,
    PICKED,
    FRESH,
    SLICE_COUNT
};

// The sweep, in one window of all layers.
typedef struct sweep {
    sf_sculpt *model;
    sf_rect part;
    sf_slice s[SLICE_COUNT];
} sweep;

static sf_slice window(const sweep *w, const sf_grid *grid, uint32_t k)
{
    return sfi_slice_window(sf_grid_slice(grid, k), w->part);
}

// ---------------------------------------------------------------------------------------------
// A layer
// ---------------------------------------------------------------------------------------------

// added = X_k; uses up R.
static sf_status choose(const sweep *w, const sf_element *e)
{
    sf_slice rest = w->s[REST], here = w->s[HERE], picked = w->s[PICKED], spread = w->s[SPREAD];
    SF_TRY(sfi_find_near(e, w->s[FIXED], w->s[WITHIN], rest, &w->s[NEAR], w->s[REACHED], here));
    for (int i = 0; i < 3; i++) {
        SF_TRY(sf_slice_and(here, rest, w->s[NEAR + i]));
        SF_TRY(sfi_cover_priority(e, here, w->s[NEAR + (i + 2) % 3], picked, w->s[FRESH], spread));
        SF_TRY(sf_slice_or(w->s[ADDED], w->s[ADDED], picked));
        SF_TRY(sf_slice_dilate(spread, picked, e, SF_BORDER_EMPTY));
        SF_TRY(sf_slice_subtract(rest, rest, spread));
    }
    return sf_slice_or(w->s[ADDED], w->s[ADDED], rest);
}

// X_k into D, with its material; ghosts that were there stay what they are.
static void add(sweep *w, uint32_t k)
{
    sf_sculpt *m = w->model;
    sf_slice added = w->s[ADDED], drawn = window(w, m->now.drawn, k);
    size_t first = w->part.x0 / 64;
    for (uint32_t y = 0; y < added.height; y++) {
        const uint64_t *x = sfi_slice_row(added, y);
        uint64_t *d = sfi_slice_row(drawn, y);
        uint8_t *materials = sfi_material_row(m, &m->now, w->part.y0 + y, k);
        for (size_t i = 0; i < sfi_row_words(added.width); i++) {
            uint64_t fresh = x[i] & ~d[i];
            d[i] |= fresh;
            sfi_bytes_set(materials, first + i, fresh, m->brush.material);
            sfi_area_note(&m->braced, first + i, fresh, w->part.y0 + y, k);
        }
    }
}

// Layer k, below A; leaves in `above` what must stand in layer k.
static sf_status brace_layer(sweep *w, uint32_t k)
{
    sf_sculpt *m = w->model;
    sf_element e;
    sf_rect all = {0, 0, w->s[0].width, w->s[0].height};
    sf_slice tips = window(w, m->tips, k), rest = w->s[REST], fixed = w->s[FIXED];
    SF_TRY(sf_rule_element(&m->terms.rule, k, &e));
    SF_TRY(sf_slice_or(fixed, tips, window(w, m->now.printable, k)));
    SF_TRY(sf_slice_dilate(w->s[SPREAD], fixed, &e, SF_BORDER_EMPTY));
    SF_TRY(sf_slice_subtract(rest, w->s[ABOVE], w->s[SPREAD]));
    SF_TRY(sf_slice_fill(w->s[ADDED], all, 0));
    if (sfi_slice_any(rest)) {
        SF_TRY(choose(w, &e));
        add(w, k);
    }
    return sf_slice_or(w->s[ABOVE], tips, w->s[ADDED]);
}

static sf_status sweep_down(sweep *w)
{
    sf_sculpt *m = w->model;
    sf_box tips = sfi_area_bounds(&m->in_tips);
    uint32_t bed = m->terms.bed_layer;
    SF_TRY(sf_slice_copy(w->s[ABOVE], window(w, m->tips, tips.z1 - 1)));
    for (uint32_t k = tips.z1 - 1; k-- > bed;) {
        if (k + 1 < tips.z0 && !sfi_slice_any(w->s[ABOVE])) {
            break;
        }
        SF_TRY(brace_layer(w, k));
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Columns
// ---------------------------------------------------------------------------------------------

static sf_status columns_down(sweep *w)
{
    sf_sculpt *m = w->model;
    sf_slice added = w->s[ADDED];
    sf_rect all = {0, 0, added.width, added.height};
    SF_TRY(sf_slice_fill(added, all, 0));
    for (uint32_t k = m->in_tips.z1; k-- > m->terms.bed_layer;) {
        SF_TRY(
            sf_slice_subtract(w->s[REST], window(w, m->tips, k), window(w, m->now.printable, k)));
        SF_TRY(sf_slice_or(added, added, w->s[REST]));
        add(w, k);
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The call
// ---------------------------------------------------------------------------------------------

// The rectangle that F and X are looked for in; and the part of the slices, which is that grown by
// as far as a step reaches, and to whole words.
static sf_status find_part(sweep *w, sf_rect *within)
{
    sf_sculpt *m = w->model;
    sf_box b = sfi_area_bounds(&m->in_tips);
    sf_slice slice = sf_grid_slice(m->tips, 0);
    sf_lattice tip = sf_grid_lattice(m->brush.tip->masks[0]);
    sf_rect rect = {b.x0, b.y0, b.x1, b.y1};
    uint32_t rx = 0, ry = 0;
    for (uint32_t k = m->terms.bed_layer; k + 1 < b.z1; k++) {
        sf_element e;
        SF_TRY(sf_rule_element(&m->terms.rule, k, &e));
        rx = e.half_width[0] > rx ? e.half_width[0] : rx;
        ry = e.reach_y > ry ? e.reach_y : ry;
    }
    *within = sfi_rect_grow(rect, tip.nx, tip.ny, slice);
    w->part = sfi_rect_align(sfi_rect_grow(*within, rx, ry, slice), slice);
    within->x0 -= w->part.x0;
    within->x1 -= w->part.x0;
    within->y0 -= w->part.y0;
    within->y1 -= w->part.y0;
    return SF_OK;
}

static int all_printable(const sf_sculpt *m)
{
    const sfi_area *a = &m->in_tips;
    for (uint32_t z = a->z0 > m->terms.bed_layer ? a->z0 : m->terms.bed_layer; z < a->z1; z++) {
        sf_slice tips = sf_grid_slice(m->tips, z), alive = sf_grid_slice(m->now.printable, z);
        sf_rect r = a->rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            const uint64_t *u = sfi_slice_row(tips, y), *t = sfi_slice_row(alive, y);
            for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
                if ((u[i] & ~t[i]) != 0) {
                    return 0;
                }
            }
        }
    }
    return 1;
}

sf_status sfi_brace(sf_sculpt *m)
{
    sweep w = {.model = m};
    sf_rect within;
    if (all_printable(m)) {
        return SF_OK;
    }
    SF_TRY(find_part(&w, &within));
    uint32_t width = w.part.x1 - w.part.x0, height = w.part.y1 - w.part.y0;
    size_t words = sfi_row_words(width) * height; // less than a slice has
    uint64_t *memory = sfi_alloc_array(&m->scratch, SLICE_COUNT, words * sizeof *memory);
    if (memory == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < SLICE_COUNT; i++) {
        sf_slice slice = {memory + i * words, width, height, sfi_row_words(width)};
        w.s[i] = slice;
    }
    sf_rect all = {0, 0, width, height};
    (void)!sf_slice_fill(w.s[WITHIN], all, 0);
    (void)!sf_slice_fill(w.s[WITHIN], within, 1);
    sf_status status = sfi_rule_is_element(&m->terms.rule) ? sweep_down(&w) : columns_down(&w);
    sfi_free_array(&m->scratch, memory, SLICE_COUNT, words * sizeof *memory);
    return status;
}
