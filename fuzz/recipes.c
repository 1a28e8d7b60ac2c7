// SPDX-License-Identifier: MIT
// How grids, meshes, cages and what is made of them are made out of bytes: simple ones that most
// calls can work on. What is more contorted than that is made by the calls themselves, whose
// results the world keeps.

#include "recipes.h"

void *world_make_grid(world *w)
{
    sf_lattice l = world_sf_lattice(w);
    sf_grid *grid = NULL;
    if (sf_grid_create(&l, &w->allocator, &grid) != SF_OK) {
        return NULL;
    }
    uint32_t kind = draw_below(&w->in, 4);
    for (uint32_t k = 0; k < l.nz && k < 12; k++) {
        sf_slice s = sf_grid_slice(grid, k);
        uint32_t grow = kind == 1 ? k / 2 : kind == 2 ? (l.nz - k) / 2 : 0;
        sf_rect r = {grow, grow, s.width > grow ? s.width - grow : 0,
                     s.height > grow ? s.height - grow : 0};
        if (kind < 3 && r.x0 < r.x1 && r.y0 < r.y1) {
            (void)!sf_slice_fill(s, r, 1);
        }
        for (uint32_t i = draw_below(&w->in, 4) + (kind == 3 ? 4u : 0u); i > 0; i--) {
            uint32_t at = draw_byte(&w->in);
            (void)!sf_slice_set(s, at % s.width, at / 16 % s.height, kind == 3);
        }
    }
    return grid;
}

// Corners of a box, and its 12 triangles; now and then a corner lies elsewhere.
void *world_make_mesh(world *w)
{
    static const uint32_t box[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                     2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    double vertices[24];
    sf_mesh *mesh = NULL;
    const double high[3] = {w->lattice.nx * w->lattice.pitch_x_mm,
                            w->lattice.ny * w->lattice.pitch_y_mm,
                            w->lattice.nz * w->lattice.layer_mm};
    uint32_t kind = draw_byte(&w->in);
    for (int i = 0; i < 24; i++) {
        int axis = i % 3, top = i / 3 >> axis & 1;
        vertices[i] = w->lattice.origin_mm[axis] + high[axis] * (top ? 0.9 : 0.1);
    }
    if (kind % 3 == 1) {
        vertices[draw_below(&w->in, 24)] += draw_place(&w->in);
    }
    size_t triangles = kind % 16 == 15 ? draw_below(&w->in, 12) : 12;
    if (sf_mesh_create(&w->allocator, &mesh) == SF_OK &&
        (sf_mesh_add_vertices(mesh, vertices, 8) != SF_OK ||
         sf_mesh_add_triangles(mesh, box, triangles) != SF_OK)) {
        sf_mesh_destroy(mesh);
        mesh = NULL;
    }
    return mesh;
}

void *world_make_cage(world *w)
{
    const uint32_t counts[3] = {1 + draw_below(&w->in, 2), 1 + draw_below(&w->in, 2), 1};
    const double low[3] = {0.2, 0.2, 0.2};
    double high[3] = {4, 3, 2};
    sf_cage *cage = NULL;
    high[draw_below(&w->in, 3)] += draw_byte(&w->in) / 64.0;
    if (sf_cage_block(counts, low, high, &w->allocator, &cage) != SF_OK) {
        return NULL;
    }
    sf_cage_view v = sf_cage_get_view(cage);
    double *values = world_scratch(w, v.point_count * sizeof *values);
    for (size_t i = 0; i < v.point_count; i++) {
        values[i] = draw_byte(&w->in) / 600.0;
    }
    sf_channel channel = {sf_property_poisson(), v.point_count, values, NULL};
    if (sf_cage_add_property(cage, &channel, NULL) != SF_OK) {
        sf_cage_destroy(cage);
        return NULL;
    }
    return cage;
}

void *world_make_weights(world *w)
{
    const sf_grid *solid = world_need(w, "sf_grid");
    sf_weights *weights = NULL;
    sf_handle handles[3] = {world_sf_handle(w), world_sf_handle(w), world_sf_handle(w)};
    if (solid != NULL) {
        (void)!sf_weights_create(solid, handles, 1 + draw_below(&w->in, 2), NULL, &w->allocator,
                                 NULL, &weights, NULL);
    }
    return weights;
}

void *world_make_stance(world *w)
{
    sf_stance *stance = NULL;
    sf_stance_options options = sf_stance_options_default();
    options.kind = (sf_stance_kind)(draw_below(&w->in, 4) % 3);
    (void)!sf_stance_create(world_sf_mesh_view(w), &options, &w->allocator, &stance, NULL);
    return stance;
}

void *world_make_checker(world *w)
{
    sf_checker *checker = NULL;
    sf_check_options options = sf_check_options_default();
    size_t size = 0;
    options.rule = world_sf_rule(w);
    options.width = w->lattice.nx;
    options.height = w->lattice.ny;
    options.finding_capacity = draw_below(&w->in, 4);
    options.findings = options.finding_capacity > 0
                           ? world_scratch(w, options.finding_capacity * sizeof(sf_finding))
                           : NULL;
    options.run_capacity = options.finding_capacity > 0 ? draw_below(&w->in, 8) : 0;
    if (sf_checker_size(&options, &size) == SF_OK && size < 1u << 20) {
        unsigned char *memory = world_scratch(w, size + 64);
        memory += (64 - (uintptr_t)memory % 64) % 64;
        (void)!sf_checker_place(&options, memory, size, &checker);
    }
    return checker;
}

void *world_make_certificate(world *w)
{
    sf_certificate *certificate = NULL;
    sf_claim claim = sf_claim_default();
    const sf_grid *grid = world_need(w, "sf_grid");
    sf_terms terms = sf_terms_default();
    claim.terms = &terms;
    if (grid != NULL) {
        (void)!sf_certificate_make(grid, &claim, &w->allocator, NULL, &certificate, NULL);
    }
    return certificate;
}

void *world_make_tets(world *w)
{
    static const uint32_t corners[8] = {0, 1, 2, 3, 1, 4, 2, 3};
    double positions[15] = {0, 0, 0, 3, 0, 0, 0, 3, 0, 0, 0, 3, 3, 3, 3};
    double values[5] = {0.1, 0.2, 0.3, 0.4, 0.45};
    positions[draw_below(&w->in, 15)] += draw_byte(&w->in) / 256.0;
    sf_channel channel = {sf_property_poisson(), 5, values, NULL};
    sf_tets_view view = {5, positions, 1 + draw_below(&w->in, 2), corners, 1, &channel};
    sf_tets *tets = NULL;
    (void)!sf_tets_create(&view, &w->allocator, &tets, NULL);
    return tets;
}

void *world_make_refinement(world *w)
{
    sf_refinement *refinement = NULL;
    sf_refine_options options = sf_refine_options_default();
    const sf_cage *cage = world_need(w, "sf_cage");
    options.steps = draw_below(&w->in, 3);
    if (cage != NULL) {
        (void)!sf_refine(cage, &options, &w->allocator, NULL, &refinement);
    }
    return refinement;
}

void *world_make_limit(world *w)
{
    sf_limit *limit = NULL;
    const sf_cage *cage = world_need(w, "sf_cage");
    if (cage != NULL) {
        (void)!sf_limit_create(cage, SF_REFINE_STANDARD, &w->allocator, NULL, &limit);
    }
    return limit;
}

void *world_make_path(world *w, int map)
{
    sf_path_finder *finder = NULL;
    sf_path_map *paths = NULL;
    const sf_grid *grid = world_own(w, "sf_grid");
    if (grid != NULL && map) {
        sf_path_map_options options = sf_path_map_options_default();
        (void)!sf_path_map_create(grid, &w->terms, &options, &w->allocator, NULL, &paths);
        return paths;
    }
    if (grid != NULL) {
        (void)!sf_path_finder_create(grid, &w->terms, (sf_landing)draw_below(&w->in, 2),
                                     &w->allocator, NULL, &finder);
    }
    return finder;
}
