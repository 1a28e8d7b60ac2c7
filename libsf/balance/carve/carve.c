// SPDX-License-Identifier: MIT
// Carving: what all ways to carve have in common.
//
// What must stay is the wall and, on terms, what `keep` names and what lies outside `act`; from
// here on that is one grid, and a way to carve knows no other masks. It works on a copy of the
// solid. What it did is then looked at, not asked for: bodies, slacks, counts and floating pieces
// are those of the result, and a result that lost a needed voxel or won one is no result.

#include "balance/carve/carve.h"

#include "balance/carve/bases.h"
#include "balance/carve/plane.h"
#include "balance/forest/forest.h"
#include "base/bits.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/terms.h"
#include "voxel/grid.h"
#include "voxel/pieces.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

sf_carve_options sf_carve_options_default(void)
{
    sf_carve_options options;
    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    options.mode = SF_CARVE_SUPPORT_FREE;
    options.goal = SF_CARVE_ENOUGH;
    options.strut_width_vx = 2;
    options.rounds_max = 64;
    return options;
}

// ---------------------------------------------------------------------------------------------
// Arguments
// ---------------------------------------------------------------------------------------------

static int options_are_good(const sf_carve_options *o)
{
    int finite = isfinite(o->rest.mass);
    for (int i = 0; i < 3; i++) {
        finite = finite && isfinite(o->rest.moment[i]);
    }
    return o->struct_size >= sizeof *o && finite &&
           (o->mode == SF_CARVE_SUPPORT_FREE || o->mode == SF_CARVE_PLANE) &&
           (o->goal == SF_CARVE_ENOUGH || o->goal == SF_CARVE_NEAREST ||
            o->goal == SF_CARVE_DEEPEST ||
            (o->goal == SF_CARVE_LIGHTEST && o->mode == SF_CARVE_SUPPORT_FREE)) &&
           o->strut_width_vx >= 1 && o->strut_width_vx <= SF_REACH_MAX;
}

static int row_is_positive(const uint64_t *row, uint32_t width, const float *density)
{
    for (size_t i = 0; i < sfi_row_words(width); i++) {
        for (uint64_t word = sfi_row_word(row, i, width); word != 0; word &= word - 1) {
            if (!(density[64 * i + sfi_lowest_bit(word)] > 0)) {
                return 0;
            }
        }
    }
    return 1;
}

static int is_positive(const sf_grid *solid, const sf_lattice *l, const float *density)
{
    for (uint32_t k = 0; density != NULL && k < l->nz; k++) {
        for (uint32_t y = 0; y < l->ny; y++) {
            if (!row_is_positive(sfi_slice_row(sf_grid_slice(solid, k), y), l->nx,
                                 density + ((size_t)k * l->ny + y) * l->nx)) {
                return 0;
            }
        }
    }
    return 1;
}

static sf_status check_terms(const sf_grid *solid, const sf_terms *terms,
                             const sf_carve_options *options, const sf_grid *result)
{
    sfi_ground ground;
    if (terms == NULL) {
        return options->mode == SF_CARVE_PLANE ? SF_OK : SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_terms_check(terms, solid, &ground));
    return sfi_terms_mask(terms, result) ? SF_ERR_ARGUMENT : SF_OK;
}

static sf_status check(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                       const sf_carve_options *options, const sf_grid *result)
{
    if (solid == NULL || wall == NULL || result == NULL || solid == wall || solid == result ||
        wall == result || !options_are_good(options)) {
        return SF_ERR_ARGUMENT;
    }
    sf_lattice lattice = sf_grid_lattice(solid);
    SF_TRY(sfi_terms_match(&lattice, wall));
    SF_TRY(sfi_terms_match(&lattice, result));
    SF_TRY(check_terms(solid, terms, options, result));
    return is_positive(solid, &lattice, options->density) ? SF_OK : SF_ERR_ARGUMENT;
}

// ---------------------------------------------------------------------------------------------
// What must stay
// ---------------------------------------------------------------------------------------------

// needed |= solid AND (keep OR NOT act), where these are given.
static void add_masks(sf_slice needed, sf_slice solid, sf_slice keep, sf_slice act)
{
    for (uint32_t y = 0; y < solid.height; y++) {
        uint64_t *to = sfi_slice_row(needed, y);
        for (size_t i = 0; i < sfi_row_words(solid.width); i++) {
            uint64_t stays = keep.words != NULL ? sfi_slice_row(keep, y)[i] : 0;
            stays |= act.words != NULL ? ~sfi_slice_row(act, y)[i] : 0;
            to[i] |= stays & sfi_row_word(sfi_slice_row(solid, y), i, solid.width);
        }
    }
}

static sf_status find_needed(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                             const sf_allocator *allocator, sf_grid **needed)
{
    if (!sfi_grid_within(wall, solid)) {
        return SF_ERR_INFEASIBLE;
    }
    SF_TRY(sf_grid_clone(wall, allocator, needed));
    for (uint32_t k = 0; terms != NULL && k < sf_grid_lattice(solid).nz; k++) {
        add_masks(sf_grid_slice(*needed, k), sf_grid_slice(solid, k),
                  sfi_mask_slice(terms->keep, k), sfi_mask_slice(terms->act, k));
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// What was done
// ---------------------------------------------------------------------------------------------

static sf_status count_floating(const sfi_carving *c, const sf_grid *wall, const sf_grid *made,
                                sf_carve_report *r)
{
    sfi_pieces pieces;
    SF_TRY(sfi_pieces_create(made, SFI_PIECES_SOLID, &c->allocator, c->task, &pieces));
    size_t count = pieces.count;
    uint8_t *is_held = sfi_alloc_array(&c->allocator, count + 1, 1);
    if (is_held == NULL) {
        sfi_pieces_destroy(&pieces, &c->allocator);
        return SF_ERR_MEMORY;
    }
    memset(is_held, 0, count);
    for (uint32_t k = 0; k < c->lattice.nz; k++) {
        sf_slice held = sf_grid_slice(wall, k);
        for (size_t i = pieces.first[k]; i < pieces.first[k + 1]; i++) {
            const sf_run *run = &pieces.runs[i];
            for (uint32_t x = run->x0; x < run->x1 && !is_held[run->label]; x++) {
                is_held[run->label] = (uint8_t)sf_slice_get(held, x, run->y);
            }
        }
    }
    for (size_t i = 0; i < pieces.run_count; i++) {
        const sf_run *run = &pieces.runs[i];
        r->floating_voxels += is_held[run->label] ? 0 : run->x1 - run->x0;
    }
    for (size_t i = 0; i < count; i++) {
        r->floating_pieces += !is_held[i];
    }
    sfi_free_array(&c->allocator, is_held, count + 1, 1);
    sfi_pieces_destroy(&pieces, &c->allocator);
    return SF_OK;
}

static sf_status measure_balance(const sfi_carving *c, sf_carve_report *r)
{
    double com[2][3], distance[2] = {0, 0}, reach = 0;
    size_t most = 0;
    if (c->base_count == 0) {
        r->safe = 1;
        return SF_OK;
    }
    SF_TRY(sf_body_com(r->before, com[0]));
    SF_TRY(sf_body_com(r->after, com[1]));
    for (size_t i = 0; i < c->base_count; i++) {
        most = c->bases[i].count > most ? c->bases[i].count : most;
    }
    size_t scratch_count = sfi_base_scratch(most);
    double *scratch = sfi_alloc_array(&c->allocator, scratch_count, sizeof *scratch);
    if (scratch == NULL) {
        return SF_ERR_MEMORY;
    }
    reach = (c->lattice.nx * c->lattice.pitch_x_mm + c->lattice.ny * c->lattice.pitch_y_mm +
             sf_lattice_layer_bottom(&c->lattice, c->lattice.nz) - c->lattice.origin_mm[2]);
    for (size_t i = 0; i < 2 * c->base_count; i++) {
        sfi_offset to =
            sfi_base_target(&c->bases[i / 2], com[i % 2], SFI_TARGET_NEAREST, reach, scratch);
        distance[i % 2] += to.along[0] * to.along[0] + to.along[1] * to.along[1];
    }
    sfi_free_array(&c->allocator, scratch, scratch_count, sizeof *scratch);
    r->distance_before_mm = sqrt(distance[0]);
    r->distance_mm = sqrt(distance[1]);
    r->slack_before_mm = sfi_bases_slack(c->bases, c->base_count, com[0]);
    r->slack_mm = sfi_bases_slack(c->bases, c->base_count, com[1]);
    r->safe = r->slack_mm >= 0;
    return SF_OK;
}

static sf_status look(const sfi_carving *c, const sf_grid *wall, const sf_grid *made,
                      sf_carve_report *r)
{
    if (!sfi_grid_within(c->needed, made) || !sfi_grid_within(made, c->solid)) {
        return SF_ERR_INTERNAL;
    }
    sf_body solid, left;
    SF_TRY(sf_grid_body(c->solid, NULL, NULL, &solid));
    SF_TRY(sf_grid_body(made, NULL, NULL, &left));
    r->removed_mm3 = solid.mass - left.mass;
    r->solid_voxels = sf_grid_popcount(c->solid);
    r->wall_voxels = sf_grid_popcount(wall);
    r->removed_voxels = r->solid_voxels - sf_grid_popcount(made);
    r->kept_voxels = r->solid_voxels - r->wall_voxels - r->removed_voxels;
    r->before = c->body;
    SF_TRY(sf_grid_body(made, c->options->density, NULL, &r->after));
    r->after = sf_body_add(r->after, 1, c->options->rest);
    SF_TRY(measure_balance(c, r));
    return r->wall_voxels > 0 ? count_floating(c, wall, made, r) : SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Carving
// ---------------------------------------------------------------------------------------------

// The half-spaces of all bases, one after the other.
static sf_status collect_halfspaces(const sfi_carving *c, sf_halfspace **halfspaces, size_t *count)
{
    *halfspaces = NULL;
    *count = 0;
    for (size_t i = 0; i < c->base_count; i++) {
        if (!sfi_size_add(*count, c->bases[i].count, count)) {
            return SF_ERR_OVERFLOW;
        }
    }
    if (*count == 0) {
        return SF_OK;
    }
    *halfspaces = sfi_alloc_array(&c->allocator, *count, sizeof **halfspaces);
    if (*halfspaces == NULL) {
        return SF_ERR_MEMORY;
    }
    size_t at = 0;
    for (size_t i = 0; i < c->base_count; i++) {
        for (size_t e = 0; e < c->bases[i].count; e++) {
            (*halfspaces)[at++] = c->bases[i].halfspaces[e];
        }
    }
    return SF_OK;
}

static sf_status carve_support_free(const sfi_carving *c, const sf_terms *terms, sf_grid *made)
{
    const sf_carve_options *o = c->options;
    sf_halfspace *halfspaces;
    size_t count;
    SF_TRY(collect_halfspaces(c, &halfspaces, &count));
    sfi_forest_options options = {.goal = o->goal == SF_CARVE_DEEPEST    ? SFI_FOREST_DEEPEST
                                          : o->goal == SF_CARVE_LIGHTEST ? SFI_FOREST_LEAST
                                                                         : SFI_FOREST_MOST,
                                  .halfspaces = halfspaces,
                                  .count = count,
                                  .density = o->density,
                                  .rest = o->rest,
                                  .strut_width = o->strut_width_vx};
    sf_status status =
        sfi_carve_forest(c->solid, c->needed, terms, &options, &c->allocator, c->task, made, NULL);
    sfi_free_array(&c->allocator, halfspaces, count, sizeof *halfspaces);
    return status;
}

static sf_status carve(const sfi_carving *c, const sf_terms *terms, sf_grid *made,
                       sf_carve_report *r)
{
    return c->options->mode == SF_CARVE_PLANE ? sfi_carve_plane(c, made, &r->rounds)
                                              : carve_support_free(c, terms, made);
}

static sf_status carve_and_look(sfi_carving *c, const sf_grid *wall, const sf_terms *terms,
                                sf_grid *result, sf_carve_report *report)
{
    sf_grid *made = NULL;
    sf_carve_report found;
    double com[3];
    memset(&found, 0, sizeof found);
    SF_TRY(sf_grid_body(c->solid, c->options->density, NULL, &c->body));
    c->body = sf_body_add(c->body, 1, c->options->rest);
    if (c->base_count > 0) {
        SF_TRY(sf_body_com(c->body, com));
    }
    SF_TRY(sf_grid_clone(c->solid, &c->allocator, &made));
    sf_status status = carve(c, terms, made, &found);
    if (status == SF_OK) {
        status = look(c, wall, made, &found);
    }
    if (status == SF_OK) {
        status = sfi_grid_copy(result, made);
    }
    if (status == SF_OK && report != NULL) {
        *report = found;
    }
    sf_grid_destroy(made);
    return status;
}

sf_status sfi_carve(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                    const sf_carve_options *options, const sfi_base *bases, size_t base_count,
                    const sf_allocator *allocator, sf_task *task, sf_grid *result,
                    sf_carve_report *report)
{
    SF_TRY(check(solid, wall, terms, options, result));
    if (sf_task_is_cancelled(task)) {
        return SF_ERR_CANCELLED;
    }
    sf_grid *needed = NULL;
    sfi_carving c = {.solid = solid, .options = options, .bases = bases, .base_count = base_count};
    c.lattice = sf_grid_lattice(solid);
    c.allocator = sfi_allocator_or_default(allocator);
    sfi_progress progress = sfi_progress_begin(task);
    sfi_part part;
    sfi_part_begin(&part, &progress, 0, 1);
    c.task = &part.task;
    SF_TRY(find_needed(solid, wall, terms, &c.allocator, &needed));
    c.needed = needed;
    sf_status status = carve_and_look(&c, wall, terms, result, report);
    sf_grid_destroy(needed);
    if (status == SF_OK) {
        sfi_progress_report(&progress, 1, 1);
    }
    return status;
}

sf_status sf_grid_carve(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                        const sf_carve_options *options, const sf_allocator *allocator,
                        sf_task *task, sf_grid *result, sf_carve_report *report)
{
    sf_carve_options standard = sf_carve_options_default();
    sf_allocator memory = sfi_allocator_or_default(allocator);
    options = options != NULL ? options : &standard;
    if (options->struct_size < sizeof *options) {
        return SF_ERR_ARGUMENT;
    }
    sfi_bases bases;
    SF_TRY(sfi_bases_create(options->stances, options->stance_count, &memory, &bases));
    sf_status status = sfi_carve(solid, wall, terms, options, bases.bases, bases.count, &memory,
                                 task, result, report);
    sfi_bases_destroy(&bases, &memory);
    return status;
}
