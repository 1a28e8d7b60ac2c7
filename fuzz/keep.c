// SPDX-License-Identifier: MIT
// Arguments that hang together with others of the same call, or that what is made keeps pointers
// to.

#include "world.h"

int world_sf_cage_place_function(void *user, const double at_mm[3], double moved_mm[3])
{
    world *w = user;
    moved_mm[0] = at_mm[0] + draw_byte(&w->in) / 64.0;
    return !draw_odd(&w->in, 32);
}

int world_sf_cage_value_function(void *user, const double at_mm[3], double *value)
{
    world *w = user;
    *value = at_mm[0] * 0 + draw_byte(&w->in) / 600.0;
    return !draw_odd(&w->in, 32);
}

void world_made(const world *w, sf_status status, int wanted, int made)
{
    if (wanted && (status == SF_OK) != made) {
        world_fail(w, "makes an object and fails, or makes none and does not");
    }
}

sf_mesh_view world_own_view(world *w)
{
    sf_mesh_view nothing = {NULL, 0, NULL, 0};
    const sf_mesh *mesh = world_own(w, "sf_mesh");
    return mesh != NULL ? sf_mesh_get_view(mesh) : nothing;
}

const sf_stance *const *world_stances(world *w)
{
    const sf_stance **stances = world_scratch(w, sizeof(void *));
    if (draw_below(&w->in, 2) == 0) {
        return NULL;
    }
    stances[0] = world_need(w, "sf_stance");
    return stances[0] != NULL ? stances : NULL;
}

sf_rule *world_rule_to_change(world *w)
{
    sf_rule rule = world_sf_rule(w);
    return world_inout(w, &rule, sizeof rule);
}

size_t world_checker_size(world *w, const sf_check_options *options)
{
    size_t size = 0;
    if (options == NULL || sf_checker_size(options, &size) != SF_OK || size > 1u << 20) {
        return 64;
    }
    return draw_odd(&w->in, 4) ? draw_byte(&w->in) * size / 256 : size;
}

const sf_finding *world_findings(world *w, const sf_grid *grid, const sf_terms *terms,
                                 size_t *count)
{
    enum { MOST = 8 };
    sf_finding *findings = world_scratch(w, MOST * sizeof *findings);
    sf_check_options options = sf_check_options_default();
    sf_check_report report;
    options.findings = findings;
    options.finding_capacity = MOST;
    if (terms != NULL) {
        options.rule = terms->rule;
        options.bed_layer = terms->bed_layer;
    }
    if (grid == NULL || sf_grid_check(grid, &options, NULL, NULL, &report, count) != SF_OK) {
        *count = 0;
    }
    if (draw_odd(&w->in, 8) && *count > 0) {
        findings[0].box.z1 = world_index(w);
        findings[0].cause = world_index(w);
        findings[0].layer = world_index(w);
    }
    return findings;
}

const sf_terms *world_terms_to_keep(world *w)
{
    sf_terms *terms = world_scratch(w, sizeof *terms);
    *terms = world_own_terms(w);
    return terms;
}

const double *world_shares(world *w, size_t count)
{
    double *values = world_scratch(w, count * sizeof *values);
    for (size_t i = 0; i < count; i++) {
        values[i] = i < 32 ? draw_byte(&w->in) / 600.0 : values[i % 32];
    }
    if (count > 0 && draw_odd(&w->in, 16)) {
        values[draw_byte(&w->in) % count] = draw_double(&w->in);
    }
    return values;
}

const double *world_pattern(world *w, size_t count)
{
    double *values = world_scratch(w, count * sizeof *values);
    for (size_t i = 0; i < count; i++) {
        values[i] = i < 32 ? draw_place(&w->in) * 4 : values[i % 32] + (double)(i / 32) / 8;
    }
    return values;
}

const sf_place *world_where(world *w, const sf_limit *limit, size_t count)
{
    sf_place *places = world_scratch(w, count * sizeof *places);
    size_t pieces = sf_limit_piece_count(limit);
    for (size_t i = 0; i < count; i++) {
        places[i].piece = pieces > 0 ? (uint32_t)(draw_byte(&w->in) % pieces) : 0;
        for (int j = 0; j < 3; j++) {
            places[i].u[j] = draw_odd(&w->in, 32) ? draw_double(&w->in) : draw_byte(&w->in) / 255.0;
        }
        if (draw_odd(&w->in, 32)) {
            places[i].piece = (uint32_t)draw_count(&w->in);
        }
    }
    return places;
}

const size_t *world_channels(world *w, size_t count)
{
    size_t *channels = world_scratch(w, count * sizeof *channels);
    for (size_t i = 0; i < count; i++) {
        channels[i] = draw_odd(&w->in, 8) ? (size_t)draw_count(&w->in) : 0;
    }
    return channels;
}

const uint32_t *world_ranks(world *w, size_t count)
{
    uint32_t *ranks = world_scratch(w, count * sizeof *ranks);
    uint32_t turn = draw_byte(&w->in);
    for (size_t i = 0; i < count; i++) {
        ranks[i] = (uint32_t)((i + turn) % count);
    }
    if (count > 0 && draw_odd(&w->in, 8)) {
        ranks[draw_byte(&w->in) % count] = draw_word(&w->in);
    }
    return ranks;
}

// Of the world, so it stays; it does not break by itself, because what is left to write is not the
// matter of the call that began it.
sf_folder world_folder_to_keep(world *w)
{
    return world_sf_folder(w);
}

uint32_t world_sectors(world *w)
{
    return draw_odd(&w->in, 16) ? (uint32_t)draw_count(&w->in) : draw_below(&w->in, 6);
}

size_t points_of_refinement(const sf_refinement *refinement)
{
    sf_cage_view v = {0};
    if (refinement == NULL || sf_refinement_get_view(refinement, 0, &v) != SF_OK) {
        return 0;
    }
    return v.point_count;
}

// A cage of dimension 2: one or two squares in the plane of x and z.
sf_cage *world_faces(world *w)
{
    static const uint32_t starts[3] = {0, 4, 8}, corners[8] = {0, 1, 2, 3, 1, 4, 5, 2};
    double positions[18] = {1, 0, 0, 2, 0, 0, 2, 0, 1, 1, 0, 1, 3, 0, 0, 3, 0, 1};
    sf_cage_view view = {2,    6, positions, 1 + draw_below(&w->in, 2), starts, corners, 0, NULL, 0,
                         NULL, 0, NULL};
    sf_cage *cage = NULL;
    view.point_count = view.cell_count == 1 ? 4 : 6;
    positions[9] += draw_byte(&w->in) / 512.0;
    if (sf_cage_create(&view, &w->allocator, &cage, NULL) == SF_OK) {
        world_keep(w, "sf_cage", cage);
    }
    return cage;
}

// Voxels of the solid that are to stay: none, or its lowest layer.
const sf_grid *world_wall(world *w, const sf_grid *solid)
{
    sf_grid *wall = NULL;
    if (solid == NULL || sf_grid_clone(solid, &w->allocator, &wall) != SF_OK) {
        return NULL;
    }
    for (uint32_t k = draw_below(&w->in, 2); k < sf_grid_lattice(solid).nz; k++) {
        sf_slice s = sf_grid_slice(wall, k);
        sf_rect all = {0, 0, s.width, s.height};
        (void)!sf_slice_fill(s, all, 0);
    }
    world_keep(w, "sf_grid", wall);
    return wall;
}

// Of sum 1: pure materials first, then mixtures of them.
const double *world_fractions(world *w, size_t materials, size_t count)
{
    double *values = world_scratch(w, materials * count * sizeof *values);
    for (size_t i = 0; i < count; i++) {
        double left = 1;
        for (size_t j = 0; j + 1 < materials; j++) {
            double share = i < materials ? i == j : left * draw_byte(&w->in) / 256;
            values[i * materials + j] = draw_odd(&w->in, 64) ? draw_double(&w->in) : share;
            left -= share;
        }
        values[i * materials + materials - 1] = left;
    }
    return values;
}

const uint8_t *world_ids(world *w, size_t count)
{
    uint8_t *ids = world_scratch(w, count);
    for (size_t i = 0; i < count && i < 64; i++) {
        ids[i] = (uint8_t)(draw_odd(&w->in, 64) ? draw_byte(&w->in) : draw_below(&w->in, 2));
    }
    return ids;
}

sf_material world_sf_material(world *w)
{
    sf_material m = {"", {draw_byte(&w->in), 0, 255}, 1};
    snprintf(m.name, sizeof m.name, "m%u", draw_below(&w->in, 200));
    if (draw_odd(&w->in, 32)) {
        memset(m.name, 'm', draw_byte(&w->in) % (sizeof m.name + 1));
        m.density_g_cm3 = draw_double(&w->in);
    }
    return m;
}

// Of the world's lattice, one for each property that a sampler can have.
double **world_planes(world *w)
{
    double **planes = world_scratch(w, SF_PROPERTY_MAX * sizeof *planes);
    for (size_t i = 0; i < SF_PROPERTY_MAX; i++) {
        planes[i] = world_scratch(w, (size_t)w->lattice.nx * w->lattice.ny * sizeof *planes[i]);
    }
    return planes;
}
