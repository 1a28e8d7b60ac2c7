// SPDX-License-Identifier: MIT
// The site of a search: what of the terms it needs to know, and what it must keep.
//
// A path goes by the rule without its bridges: a chain of voxels is carried voxel by voxel. It
// lands on any matter, or on matter that is alive under the whole rule, bridges included; both are
// right, because more matter never kills (carry.c). Only two questions ask for more than the grid
// itself: what is alive, and under slack how much reach it has to spare. That is a sweep of the
// whole grid, kept here; without it a site costs nothing and is never out of date.

#include "support/grow/site.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "voxel/distance.h"

// ---------------------------------------------------------------------------------------------
// What is alive, and its slack
// ---------------------------------------------------------------------------------------------

// The codes of layer k: in the field, or of two layers by turns on their way into a reserve.
static uint8_t *codes_of(const sfi_field *field, uint8_t *turns, size_t bytes, uint32_t k)
{
    return field->codes != NULL ? field->codes + k * bytes
           : turns != NULL      ? turns + k % 2 * bytes
                                : NULL;
}

static sf_status fill_layers(const sfi_field *field, const sf_grid *solid, const sf_terms *terms,
                             uint32_t bed, const sfi_carrier *carrier, uint8_t *turns,
                             const sfi_stage *stage)
{
    sf_lattice lattice = sf_grid_lattice(solid);
    size_t bytes = sfi_slack_stride(lattice.nx) * lattice.ny;
    sfi_front below = {SFI_NO_SLICE, NULL};
    for (uint32_t k = 0; k < lattice.nz; k++) {
        if (sf_task_is_cancelled(stage->task)) {
            return SF_ERR_CANCELLED;
        }
        sfi_front front = {sf_grid_slice(field->alive, k), codes_of(field, turns, bytes, k)};
        SF_TRY(sfi_carry_layer(carrier, k, bed, &below, sf_grid_slice(solid, k),
                               sfi_mask_slice(terms->exempt, k), front,
                               sfi_mask_slice(field->own, k)));
        if (turns != NULL) {
            SF_TRY(sfi_reserve_add(field->reserve, k, &front));
        }
        below = front;
        sfi_progress_report(stage->progress, stage->done + k + 1, stage->total);
    }
    return SF_OK;
}

sf_status sfi_field_fill(const sfi_field *field, const sf_grid *solid, const sf_terms *terms,
                         uint32_t bed, const sf_allocator *allocator, const sfi_stage *stage)
{
    sf_lattice lattice = sf_grid_lattice(solid);
    sf_allocator from = sfi_allocator_or_default(allocator);
    size_t bytes = 0;
    uint8_t *turns = NULL;
    sfi_carrier carrier;
    if (field->reserve != NULL && !sfi_size_mul(sfi_slack_stride(lattice.nx), lattice.ny, &bytes)) {
        return SF_ERR_OVERFLOW;
    }
    SF_TRY(sfi_carrier_create(&terms->rule, lattice.nx, lattice.ny, allocator, &carrier));
    if (field->reserve != NULL) {
        turns = sfi_alloc_array(&from, bytes, 2);
    }
    sf_status status = field->reserve != NULL && turns == NULL
                           ? SF_ERR_MEMORY
                           : fill_layers(field, solid, terms, bed, &carrier, turns, stage);
    sfi_free_array(&from, turns, bytes, 2);
    sfi_carrier_destroy(&carrier, allocator);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Site
// ---------------------------------------------------------------------------------------------

void sfi_site_close(sfi_site *site)
{
    static const sfi_reserve none;
    sf_grid_destroy(site->alive);
    sfi_reserve_destroy(&site->reserve);
    site->alive = NULL;
    site->reserve = none;
}

// Memory for what the site has to keep, if anything, and fill it.
static sf_status make_field(const sfi_site *site, uint32_t bed, const sfi_stage *stage,
                            sf_grid **alive, sfi_reserve *reserve)
{
    int has_slack = site->plain.kind == SF_RULE_SLACK;
    if (!has_slack && site->landing == SF_LANDING_ANY) {
        return SF_OK;
    }
    SF_TRY(sf_grid_create(&site->lattice, &site->allocator, alive));
    if (has_slack) {
        SF_TRY(sfi_reserve_create(&site->plain, &site->lattice, &site->allocator, reserve));
    }
    sfi_field field = {*alive, NULL, NULL, has_slack ? reserve : NULL};
    return sfi_field_fill(&field, site->grid, &site->terms, bed, &site->allocator, stage);
}

sf_status sfi_site_refresh(sfi_site *site, const sfi_stage *stage)
{
    sfi_ground ground;
    if (sf_task_is_cancelled(stage->task)) {
        return SF_ERR_CANCELLED;
    }
    SF_TRY(sfi_terms_check(&site->terms, site->grid, &ground));
    uint32_t bed = ground.bed < ground.lattice.nz ? ground.bed : 0;
    sfi_site fresh = *site;
    static const sfi_reserve none;
    fresh.alive = NULL;
    fresh.reserve = none;
    sf_status status = make_field(site, bed, stage, &fresh.alive, &fresh.reserve);
    if (status != SF_OK) {
        sfi_site_close(&fresh);
        return status;
    }
    sfi_site_close(site);
    *site = fresh;
    site->bed = bed;
    site->roots = site->landing == SF_LANDING_ALIVE ? site->alive : site->grid;
    return SF_OK;
}

void sfi_site_place(sfi_site *site, const sf_grid *grid, const sf_terms *terms,
                    const sfi_ground *ground, const sf_allocator *allocator)
{
    static const sf_bridge none;
    *site = (sfi_site){.terms = *terms,
                       .plain = terms->rule,
                       .lattice = ground->lattice,
                       .bed = ground->bed < ground->lattice.nz ? ground->bed : 0,
                       .landing = SF_LANDING_ANY,
                       .grid = grid,
                       .roots = grid,
                       .allocator = sfi_allocator_or_default(allocator)};
    site->plain.bridge = none;
    if (!sfi_size_mul(sfi_slack_stride(site->lattice.nx), site->lattice.ny, &site->code_bytes)) {
        site->code_bytes = 0; // whoever wants codes will see
    }
}

sf_status sfi_codes_create(const sfi_site *site, uint8_t **codes)
{
    size_t all;
    *codes = NULL;
    if (site->plain.kind != SF_RULE_SLACK) {
        return SF_OK;
    }
    if (site->code_bytes == 0 || !sfi_size_mul(site->code_bytes, site->lattice.nz, &all)) {
        return SF_ERR_OVERFLOW;
    }
    *codes = sfi_alloc_array(&site->allocator, site->lattice.nz, site->code_bytes);
    return *codes != NULL ? SF_OK : SF_ERR_MEMORY;
}

void sfi_codes_destroy(const sfi_site *site, uint8_t *codes)
{
    sfi_free_array(&site->allocator, codes, site->lattice.nz, site->code_bytes);
}

sf_status sfi_site_open(sfi_site *site, const sf_grid *grid, const sf_terms *terms,
                        sf_landing landing, const sf_allocator *allocator, const sfi_stage *stage)
{
    sfi_ground ground;
    if (landing != SF_LANDING_ANY && landing != SF_LANDING_ALIVE) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_terms_check(terms, grid, &ground));
    sfi_site_place(site, grid, terms, &ground, allocator);
    site->landing = landing;
    return sfi_site_refresh(site, stage);
}

uint64_t sfi_site_free_word(const sfi_site *site, uint32_t z, uint32_t y, size_t i)
{
    uint64_t free = ~sfi_slice_row(sf_grid_slice(site->grid, z), y)[i];
    if (site->terms.forbid != NULL) {
        free &= ~sfi_slice_row(sf_grid_slice(site->terms.forbid, z), y)[i];
    }
    if (site->terms.act != NULL) {
        free &= sfi_slice_row(sf_grid_slice(site->terms.act, z), y)[i];
    }
    return i + 1 == sfi_row_words(site->lattice.nx) ? free & sfi_tail_mask(site->lattice.nx) : free;
}

uint32_t sfi_site_slack(const sfi_site *site, sf_voxel v)
{
    if (!sf_slice_get(sf_grid_slice(site->alive, v.z), v.x, v.y)) {
        return 0;
    }
    return sfi_reserve_slack(&site->reserve, v);
}

// ---------------------------------------------------------------------------------------------
// Paths
// ---------------------------------------------------------------------------------------------

sf_path sfi_path_make(size_t count, sf_path_end end, sf_voxel landing, uint32_t bed_square)
{
    sf_path path = {count, end, landing, count, 0};
    if (end == SF_PATH_END_BED && count > 0) {
        path.cost = count - 1 + sfi_distance_steps(bed_square);
        path.bed_square = bed_square != SFI_DISTANCE_NONE ? bed_square : 0;
    }
    return path;
}

int sfi_path_is_trivial(const sfi_site *site, sf_voxel from, sf_path *found)
{
    int is_held = site->terms.exempt != NULL &&
                  sf_slice_get(sf_grid_slice(site->terms.exempt, from.z), from.x, from.y);
    if (from.z == site->bed || is_held) {
        *found =
            sfi_path_make(0, from.z == site->bed ? SF_PATH_END_BED : SF_PATH_END_HELD, from, 0);
        return 1;
    }
    return 0;
}
