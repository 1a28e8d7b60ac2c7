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
// three bits a voxel hold them. Of carriers those straight below come first, then by rings
// (support/preserve/priority.c). Where all of this is worked out, lean.c says.
//
// Under rules with slack or bridges a layer's bits do not tell what carries: there every voxel of U
// that is not printable gets a column down to the bed, which carries under any rule.

#include "base/memory.h"
#include "base/status.h"
#include "sculpt/lean.h"
#include "sculpt/model.h"
#include "sculpt/rows.h"
#include "sculpt/tip.h"
#include "support/rule/carry.h"
#include "voxel/slice.h"

// ---------------------------------------------------------------------------------------------
// Layers
// ---------------------------------------------------------------------------------------------

// Bits of word i of row y of layer k into D, with their material; ghosts that were there stay what
// they are.
static void add_word(sf_sculpt *m, size_t i, uint64_t bits, uint32_t y, uint32_t k)
{
    uint64_t *d = sfi_slice_row(sf_grid_slice(m->now.drawn, k), y) + i;
    uint64_t fresh = bits & ~*d;
    *d |= fresh;
    sfi_bytes_set(sfi_material_row(m, &m->now, y, k), i, fresh, m->brush.material);
    sfi_area_note(&m->braced, i, fresh, y, k);
}

// X_k into D.
static void add(sf_sculpt *m, const sfi_lean *lean, uint32_t k)
{
    const sfi_patch *p = &lean->patch;
    sf_rect r = lean->added_in;
    for (uint32_t y = r.y0; y < r.y1; y++) {
        const uint64_t *row = lean->added + (y - p->rect.y0) * p->stride;
        for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
            uint64_t bits = sfi_moved_word(row, p->stride, i, -(int64_t)p->rect.x0);
            if (bits != 0) {
                add_word(m, i, bits, y, k);
            }
        }
    }
}

static sf_status sweep_down(sf_sculpt *m, sfi_lean *lean)
{
    sf_box tips = sfi_area_bounds(&m->in_tips);
    for (uint32_t k = tips.z1 - 1; k-- > m->terms.bed_layer;) {
        sfi_lean_layer layer = {sf_grid_slice(m->now.printable, k), sf_grid_slice(m->tips, k),
                                sf_grid_slice(m->tips, k + 1), sfi_area_rect(&m->in_tips, k),
                                sfi_area_rect(&m->in_tips, k + 1)};
        if (k + 1 < tips.z0 && sfi_rect_is_empty(lean->added_in)) {
            break;
        }
        sf_element e;
        SF_TRY(sf_rule_element(&m->terms.rule, k, &e));
        SF_TRY(sfi_lean_down(lean, &e, &layer));
        add(m, lean, k);
    }
    return SF_OK;
}

// What a step reaches at most, in the layers below the tips.
static sf_status find_reach(const sf_sculpt *m, uint32_t *rx, uint32_t *ry)
{
    *rx = *ry = 0;
    for (uint32_t k = m->terms.bed_layer; k + 1 < m->in_tips.z1; k++) {
        sf_element e;
        SF_TRY(sf_rule_element(&m->terms.rule, k, &e));
        *rx = e.half_width[0] > *rx ? e.half_width[0] : *rx;
        *ry = e.reach_y > *ry ? e.reach_y : *ry;
    }
    return SF_OK;
}

// The rectangle that F and X are looked for in.
static sf_rect find_within(const sf_sculpt *m)
{
    sf_box b = sfi_area_bounds(&m->in_tips);
    sf_lattice tip = sf_grid_lattice(m->brush.tip->masks[0]);
    sf_rect rect = {b.x0, b.y0, b.x1, b.y1};
    return sfi_rect_grow(rect, tip.nx, tip.ny, sf_grid_slice(m->tips, 0));
}

static sf_status lean_down(sf_sculpt *m)
{
    uint32_t rx, ry;
    SF_TRY(find_reach(m, &rx, &ry));
    sf_rect within = find_within(m);
    sf_rect part = sfi_rect_grow(within, rx, ry, sf_grid_slice(m->tips, 0));
    size_t room = sfi_patch_room(part.x1 - part.x0, part.y1 - part.y0);
    uint64_t *memory = sfi_alloc_array(&m->scratch, SFI_LEAN_PLANES, room * sizeof *memory);
    if (memory == NULL) {
        return SF_ERR_MEMORY;
    }
    sfi_lean lean = sfi_lean_begin(memory, room, within);
    sf_status status = sweep_down(m, &lean);
    sfi_free_array(&m->scratch, memory, SFI_LEAN_PLANES, room * sizeof *memory);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Columns
// ---------------------------------------------------------------------------------------------

// Below each voxel of U that is not printable, a column of words for each word of the tips' box.
static void columns_down(sf_sculpt *m)
{
    sf_box b = sfi_area_bounds(&m->in_tips);
    sf_rect rect = {b.x0, b.y0, b.x1, b.y1};
    for (uint32_t y = b.y0; y < b.y1; y++) {
        for (size_t i = sfi_rect_first_word(rect); i < sfi_rect_end_word(rect); i++) {
            uint64_t hangs = 0;
            for (uint32_t k = b.z1; k-- > m->terms.bed_layer;) {
                hangs |= sfi_slice_row(sf_grid_slice(m->tips, k), y)[i] &
                         ~sfi_slice_row(sf_grid_slice(m->now.printable, k), y)[i];
                add_word(m, i, hangs, y, k);
            }
        }
    }
}

// ---------------------------------------------------------------------------------------------
// The call
// ---------------------------------------------------------------------------------------------

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
    if (all_printable(m)) {
        return SF_OK;
    }
    if (sfi_rule_is_element(&m->terms.rule)) {
        return lean_down(m);
    }
    columns_down(m);
    return SF_OK;
}
