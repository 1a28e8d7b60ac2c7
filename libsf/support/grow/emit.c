// SPDX-License-Identifier: MIT
// Emit: a brush on every voxel of a path, without what of it would hang in the air.
//
// Let p_0 be the lowest voxel of a path and B the brush around its anchor. A voxel p_i + b of a
// translate lies within one step of p_{i-1} + b, which is in the translate below: so only the
// lowest translate can have voxels that nothing carries, and what rests on these. From a radius of
// about four on a ball that stands on a small feature has such voxels. So what is added is trimmed:
//
//     T_k = A_k and (what S_{k-1} with T_{k-1} carries, or exempt),   S' = S with T,
//
// A being all that the brush would add. S counts as held whatever carries it, so nothing of it
// goes, and a path that lands on matter in the air stands as well as that does. If S is
// support-free, so is S': each voxel of T is carried by one of S' below, and what was alive stays
// so, because no rule kills with more matter. The path survives because it is a chain of its own. T
// goes by the rule without its bridges: from a voxel of S that is bridged no other bridge may
// start, and whether it is, being held does not tell.
//
// For rules that are an element for each step what is held in the layer below the brush is all that
// counts, so the trim begins there; under slack it begins at the bed, for the reach to spare.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// 2016, section 2.2, where the brush is emitted and not trimmed.

#include "base/status.h"
#include "support/grow/site.h"
#include "voxel/stamp.h"

typedef struct emission {
    sfi_site site;
    const sf_stroke *stroke;
    uint32_t z0, z1;  // layers that the brush meets
    sf_grid *added;   // these layers: A, later T
    sf_grid *scratch; // two layers: what is solid, and what of it is held
    sfi_front fronts[2];
    sfi_carrier carrier;
    uint64_t trimmed_voxels, added_voxels;
} emission;

static sf_status make_layers(const sfi_site *site, uint32_t count, sf_grid **grid)
{
    sf_lattice lattice = site->lattice;
    lattice.nz = count;
    lattice.heights_mm = NULL;
    return sf_grid_create(&lattice, &site->allocator, grid);
}

// ---------------------------------------------------------------------------------------------
// Stamping
// ---------------------------------------------------------------------------------------------

// A = the brush all along the path, and the path, where the terms let something be added.
static sf_status stamp(emission *e)
{
    const sf_stroke *s = e->stroke;
    for (size_t i = 0; i < s->count; i++) {
        sf_voxel p = s->path[i];
        int64_t by[3] = {(int64_t)p.x - s->anchor.x, (int64_t)p.y - s->anchor.y,
                         (int64_t)p.z - s->anchor.z - e->z0};
        (void)sfi_grid_stamp(e->added, s->brush, by);
        SF_TRY(sf_slice_set(sf_grid_slice(e->added, p.z - e->z0), p.x, p.y, 1));
    }
    for (uint32_t z = e->z0; z < e->z1; z++) {
        sf_slice slice = sf_grid_slice(e->added, z - e->z0);
        for (uint32_t y = 0; y < slice.height; y++) {
            uint64_t *row = sfi_slice_row(slice, y);
            for (size_t i = 0; i < sfi_row_words(slice.width); i++) {
                row[i] = row[i] != 0 ? row[i] & sfi_site_free_word(&e->site, z, y, i) : 0;
            }
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Trimming
// ---------------------------------------------------------------------------------------------

// Layer z of the trim, over the front of the layer below.
static sf_status trim_layer(emission *e, uint32_t z, const sfi_front *below, sfi_front front)
{
    sf_slice here = sf_grid_slice(e->site.grid, z);
    sf_slice solid = sf_grid_slice(e->scratch, 0), held = sf_grid_slice(e->scratch, 1);
    int is_brushed = z >= e->z0;
    sf_slice added = is_brushed ? sf_grid_slice(e->added, z - e->z0) : SFI_NO_SLICE;
    SF_TRY(is_brushed ? sf_slice_or(solid, here, added) : sf_slice_copy(solid, here));
    SF_TRY(e->site.terms.exempt != NULL
               ? sf_slice_or(held, here, sf_grid_slice(e->site.terms.exempt, z))
               : sf_slice_copy(held, here));
    SF_TRY(sfi_carry_layer(&e->carrier, z, e->site.bed, below, solid, held, front, SFI_NO_SLICE));
    if (is_brushed) {
        uint64_t before = sf_slice_popcount(added);
        SF_TRY(sf_slice_subtract(added, front.alive, here));
        uint64_t after = sf_slice_popcount(added);
        e->added_voxels += after;
        e->trimmed_voxels += before - after;
    }
    return SF_OK;
}

static sf_status trim(emission *e)
{
    int has_slack = e->site.plain.kind == SF_RULE_SLACK;
    uint32_t first = has_slack ? e->site.bed : e->z0;
    sfi_front below = {first > e->site.bed ? sf_grid_slice(e->site.grid, first - 1) : SFI_NO_SLICE,
                       NULL};
    for (uint32_t z = first; z < e->z1; z++) {
        sfi_front front = e->fronts[z % 2];
        SF_TRY(trim_layer(e, z, &below, front));
        below = front;
    }
    return SF_OK;
}

static int is_path_there(const emission *e)
{
    for (size_t i = 0; i < e->stroke->count; i++) {
        sf_voxel v = e->stroke->path[i];
        if (!sf_slice_get(sf_grid_slice(e->site.grid, v.z), v.x, v.y) &&
            !sf_slice_get(sf_grid_slice(e->added, v.z - e->z0), v.x, v.y)) {
            return 0;
        }
    }
    return 1;
}

// ---------------------------------------------------------------------------------------------
// The call
// ---------------------------------------------------------------------------------------------

static sf_status check_stroke(const sf_grid *grid, const sf_terms *terms, const sf_stroke *s)
{
    if (s == NULL || s->brush == NULL || s->brush == grid || (s->path == NULL && s->count > 0) ||
        grid == terms->exempt || grid == terms->forbid || grid == terms->act) {
        return SF_ERR_ARGUMENT;
    }
    sf_lattice brush = sf_grid_lattice(s->brush), lattice = sf_grid_lattice(grid);
    if (s->anchor.x >= brush.nx || s->anchor.y >= brush.ny || s->anchor.z >= brush.nz) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < s->count; i++) {
        if (s->path[i].x >= lattice.nx || s->path[i].y >= lattice.ny ||
            s->path[i].z >= lattice.nz) {
            return SF_ERR_ARGUMENT;
        }
    }
    return SF_OK;
}

// Layers that the brush meets, from the bed up; SF_ERR_INFEASIBLE for a path below the bed.
static sf_status find_layers(emission *e)
{
    const sf_stroke *s = e->stroke;
    uint32_t below = s->anchor.z, above = sf_grid_lattice(s->brush).nz - 1 - below;
    uint32_t lowest = UINT32_MAX, highest = 0;
    for (size_t i = 0; i < s->count; i++) {
        lowest = s->path[i].z < lowest ? s->path[i].z : lowest;
        highest = s->path[i].z > highest ? s->path[i].z : highest;
    }
    if (lowest < e->site.bed) {
        return SF_ERR_INFEASIBLE;
    }
    e->z0 = lowest - e->site.bed > below ? lowest - below : e->site.bed;
    e->z1 = above < e->site.lattice.nz - highest ? highest + above + 1 : e->site.lattice.nz;
    return SF_OK;
}

static sf_status run_emission(emission *e)
{
    const sf_rule *rule = &e->site.plain;
    const sf_lattice *lattice = &e->site.lattice;
    SF_TRY(find_layers(e));
    e->carrier = sfi_carrier_place(rule, lattice->nx, lattice->ny, NULL);
    SF_TRY(make_layers(&e->site, e->z1 - e->z0, &e->added));
    SF_TRY(make_layers(&e->site, 2, &e->scratch));
    for (int i = 0; i < 2; i++) {
        SF_TRY(sfi_front_create(rule, lattice->nx, lattice->ny, &e->site.allocator, &e->fronts[i]));
    }
    SF_TRY(stamp(e));
    SF_TRY(trim(e));
    return is_path_there(e) ? SF_OK : SF_ERR_INFEASIBLE;
}

static void emission_clear(emission *e)
{
    for (int i = 0; i < 2; i++) {
        sfi_front_destroy(&e->fronts[i], &e->site.plain, &e->site.allocator);
    }
    sf_grid_destroy(e->added);
    sf_grid_destroy(e->scratch);
    sfi_site_close(&e->site);
}

sf_status sf_grid_emit(sf_grid *grid, const sf_terms *terms, const sf_stroke *stroke,
                       const sf_allocator *allocator, sf_emit_report *report)
{
    sfi_ground ground;
    emission e = {.stroke = stroke};
    SF_TRY(sfi_terms_check(terms, grid, &ground));
    SF_TRY(check_stroke(grid, terms, stroke));
    sf_emit_report counts = {0, 0};
    if (stroke->count > 0) {
        sfi_site_place(&e.site, grid, terms, &ground, allocator);
        sf_status status = run_emission(&e);
        for (uint32_t z = e.z0; status == SF_OK && z < e.z1; z++) {
            sf_slice slice = sf_grid_slice(grid, z);
            (void)!sf_slice_or(slice, slice, sf_grid_slice(e.added, z - e.z0));
        }
        counts.added_voxels = e.added_voxels;
        counts.trimmed_voxels = e.trimmed_voxels;
        emission_clear(&e);
        SF_TRY(status);
    }
    if (report != NULL) {
        *report = counts;
    }
    return SF_OK;
}
