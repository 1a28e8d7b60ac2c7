// SPDX-License-Identifier: MIT
// Models: memory, life, and what a host may look at.
//
// A model lies in one block. It is an arena, from which everything else is taken: two states, the
// union of a stroke's tips, what add-grow adds, the history, and room for what the operators ask
// for while they work. That room is what they say they need for the largest box there is, so that
// under rules that are elements no brush can want for memory.

#include "sculpt/model.h"

#include <string.h>

#include "base/memory.h"
#include "base/status.h"
#include "sculpt/lean.h"
#include "support/rule/carry.h"
#include "support/rule/rule.h"
#include "support/rule/terms.h"

#define AREA_COUNT 11

sf_sculpt_options sf_sculpt_options_default(void)
{
    sf_sculpt_options options = {
        .struct_size = sizeof options,
        .lattice = {512, 512, 512, 0.25, 0.25, 0.25, NULL, {0, 0, 0}},
        .rule = sf_terms_default().rule,
        .history_size = (size_t)64 << 20,
    };
    return options;
}

// ---------------------------------------------------------------------------------------------
// Size
// ---------------------------------------------------------------------------------------------

// A sum of sizes that remembers whether it was too large.
typedef struct total {
    size_t bytes;
    int is_too_large;
} total;

// count pieces of a * b * c bytes each.
static void add(total *t, size_t count, size_t a, size_t b, size_t c)
{
    size_t piece, all;
    if (!sfi_size_mul(a, b, &piece) || !sfi_size_mul(piece, c, &piece)) {
        t->is_too_large = 1;
        return;
    }
    piece = sfi_arena_cost(piece);
    if (piece == 0 || !sfi_size_mul(count, piece, &all) ||
        !sfi_size_add(t->bytes, all, &t->bytes)) {
        t->is_too_large = 1;
    }
}

// Bytes of a model's block; 0 where they do not fit the machine.
static size_t size_of(const sf_sculpt_options *options)
{
    const sf_lattice *l = &options->lattice;
    size_t row = sf_slice_stride(l->nx) * sizeof(uint64_t), area = (size_t)l->nx * l->ny;
    total t = {0, 0};
    add(&t, options->keep_drawn ? 6 : 5, row, l->ny, l->nz); // grids of two states, tips, grown
    add(&t, 2, area, l->nz, 1);                              // materials
    add(&t, 1, l->nz, sizeof(sf_voxel), 1);
    add(&t, 7, l->nz, sizeof(double), 1); // heights of grids
    add(&t, 1, options->history_size, 1, 1);
    add(&t, AREA_COUNT, l->nz, sizeof(sf_rect), 1);
    // Operators: what preserve keeps and the slices it sweeps; braces; distances on the bed.
    add(&t, 1, row, l->ny, l->nz);
    add(&t, 32, row, l->ny, 1);
    add(&t, SFI_LEAN_PLANES, (size_t)l->nx / 64 + 2, (size_t)l->ny + 4, sizeof(uint64_t));
    add(&t, 1, area, 24, 1);
    add(&t, 1, (size_t)l->nx + l->nz, 64, 1);
    if (!sfi_rule_is_element(&options->rule)) {
        // Fields of codes, whose rows are as long as a grid's where these are short: a path finder
        // keeps less than 3 grids' worth, preserve asks for less than 10, and for slices of them.
        add(&t, 14, row, l->ny, l->nz);
        add(&t, 64, row, l->ny, 1);
        add(&t, 2, area, l->nz, 1);
        add(&t, 64, area, 1, 1);
    }
    add(&t, 64, 4096, 1, 1); // whatever is small
    return t.is_too_large ? 0 : t.bytes;
}

// ---------------------------------------------------------------------------------------------
// Life
// ---------------------------------------------------------------------------------------------

static sf_status check_options(const sf_sculpt_options *options)
{
    if (options == NULL || options->struct_size < sizeof *options) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_lattice_validate(&options->lattice));
    return options->bed_layer < options->lattice.nz
               ? sfi_rule_check(&options->rule, 0, options->lattice.nz)
               : SF_ERR_ARGUMENT;
}

// A state of one grid where all that is drawn is printable.
static sf_status create_state(sf_sculpt *m, sfi_state *state, int is_one)
{
    const sf_lattice *l = &m->options.lattice;
    SF_TRY(sf_grid_create(l, &m->scratch, &state->printable));
    state->drawn = state->printable;
    if (!is_one) {
        SF_TRY(sf_grid_create(l, &m->scratch, &state->drawn));
    }
    size_t voxels = (size_t)l->nx * l->ny * l->nz;
    state->materials = sfi_alloc_array(&m->scratch, voxels, 1);
    if (state->materials == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(state->materials, 0, voxels);
    return SF_OK;
}

// A path finder, which has asked once for the longest path, so that it has all it needs.
static sf_status create_finder(sf_sculpt *m)
{
    sf_path found;
    sf_voxel top = {0, 0, m->lattice.nz - 1};
    SF_TRY(sf_path_finder_create(m->before.printable, &m->terms, SF_LANDING_ANY, &m->scratch, NULL,
                                 &m->finder));
    m->path = sfi_alloc_array(&m->scratch, m->lattice.nz, sizeof *m->path);
    if (m->path == NULL) {
        return SF_ERR_MEMORY;
    }
    return sf_path_finder_find(m->finder, top, m->path, m->lattice.nz, &found);
}

// A rectangle for each layer of every area.
static sf_status create_areas(sf_sculpt *m)
{
    sfi_area *areas[AREA_COUNT] = {&m->in_tips,
                                   &m->in_grown,
                                   &m->braced,
                                   &m->fresh,
                                   &m->work,
                                   &m->touched.drawn,
                                   &m->touched.printable,
                                   &m->touched.material,
                                   &m->called.drawn,
                                   &m->called.printable,
                                   &m->called.material};
    for (int i = 0; i < AREA_COUNT; i++) {
        sfi_area_clear(areas[i]);
        areas[i]->rects = sfi_alloc_array(&m->scratch, m->lattice.nz, sizeof(sf_rect));
        if (areas[i]->rects == NULL) {
            return SF_ERR_MEMORY;
        }
    }
    return SF_OK;
}

// All that a model has. It lies in the arena, so nothing of it need be freed alone.
static sf_status fill(sf_sculpt *m)
{
    const sf_lattice *l = &m->options.lattice;
    m->history.capacity = m->options.history_size;
    if (m->history.capacity > 0) {
        m->history.bytes = sfi_alloc_array(&m->scratch, m->history.capacity, 1);
        if (m->history.bytes == NULL) {
            return SF_ERR_MEMORY;
        }
        memset(m->history.bytes, 0, m->history.capacity); // no stroke waits for fresh pages
    }
    SF_TRY(create_state(m, &m->now, 0));
    SF_TRY(create_state(m, &m->before, !m->options.keep_drawn));
    SF_TRY(sf_grid_create(l, &m->scratch, &m->tips));
    SF_TRY(sf_grid_create(l, &m->scratch, &m->grown));
    m->lattice = sf_grid_lattice(m->now.drawn);
    m->options.lattice = m->lattice;
    m->terms = sf_terms_default();
    m->terms.rule = m->options.rule;
    m->terms.bed_layer = m->options.bed_layer;
    SF_TRY(create_areas(m));
    return create_finder(m);
}

sf_status sf_sculpt_create(const sf_sculpt_options *options, const sf_allocator *allocator,
                           sf_sculpt **model)
{
    if (model == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(check_options(options));
    size_t rest = size_of(options), head = sfi_arena_cost(sizeof(sf_sculpt)), size;
    if (rest == 0 || !sfi_size_add(head, rest, &size)) {
        return SF_ERR_OVERFLOW;
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_sculpt *made = sfi_alloc_array(&from, size, 1);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_sculpt empty = {.allocator = from, .size = size, .options = *options};
    *made = empty;
    sfi_arena_place(&made->arena, (unsigned char *)made + head, rest);
    made->scratch = sfi_arena_allocator(&made->arena);
    sf_status status = fill(made);
    if (status != SF_OK) {
        sf_sculpt_destroy(made);
        return status;
    }
    *model = made;
    return SF_OK;
}

void sf_sculpt_destroy(sf_sculpt *model)
{
    if (model != NULL) {
        sf_allocator allocator = model->allocator;
        sfi_free_array(&allocator, model, model->size, 1);
    }
}

// ---------------------------------------------------------------------------------------------
// Looking
// ---------------------------------------------------------------------------------------------

sf_sculpt_options sf_sculpt_options_of(const sf_sculpt *model)
{
    return model->options;
}

const sf_grid *sf_sculpt_printable(const sf_sculpt *model)
{
    return model != NULL ? model->now.printable : NULL;
}

const sf_grid *sf_sculpt_drawn(const sf_sculpt *model)
{
    return model != NULL ? model->now.drawn : NULL;
}

const uint8_t *sf_sculpt_materials(const sf_sculpt *model)
{
    return model != NULL ? model->now.materials : NULL;
}

sf_sculpt_history sf_sculpt_history_of(const sf_sculpt *model)
{
    const sfi_ring *h = &model->history;
    sf_sculpt_history history = {h->undo_count, h->redo_count, (size_t)(h->end - h->first),
                                 h->forgotten_count};
    return history;
}
