// SPDX-License-Identifier: MIT
// How the objects of grading are made out of bytes: masks, halftones, curves, mixtures, samplers.

#include "recipes.h"

void *world_make_mask(world *w)
{
    uint32_t ranks[16];
    sf_mask *mask = NULL;
    uint32_t turn = draw_byte(&w->in);
    for (uint32_t i = 0; i < 16; i++) {
        ranks[i] = (i * 5 + turn) % 16;
    }
    (void)!sf_mask_from_ranks(4, 2, 2, ranks, &w->allocator, &mask);
    return mask;
}

void *world_make_tone_machine(world *w, int diffuses)
{
    const double pitch[3] = {1, 1, 1};
    sf_halftone *halftone = NULL;
    sf_diffuser *diffuser = NULL;
    uint32_t materials = 2 + draw_below(&w->in, 2);
    if (diffuses) {
        (void)!sf_diffuser_create(w->lattice.nx, w->lattice.ny, materials, pitch, &w->allocator,
                                  &diffuser);
        return diffuser;
    }
    const sf_mask *mask = world_need(w, "sf_mask");
    if (mask != NULL) {
        (void)!sf_halftone_create(mask, materials, &w->allocator, &halftone);
    }
    return halftone;
}

void *world_make_slicer(world *w, int shell)
{
    sf_shell *made = NULL;
    sf_voxelizer *voxelizer = NULL;
    const sf_mesh *mesh = world_own(w, "sf_mesh");
    if (mesh == NULL) {
        return NULL;
    }
    if (shell) {
        (void)!sf_shell_create(sf_mesh_get_view(mesh), &w->lattice, 0.5, &w->allocator, &made,
                               NULL);
        return made;
    }
    (void)!sf_voxelizer_create(sf_mesh_get_view(mesh), &w->lattice, NULL, &w->allocator, &voxelizer,
                               NULL);
    return voxelizer;
}

void *world_make_curve(world *w)
{
    sf_curve_sample samples[4];
    sf_curve *curve = NULL;
    for (int i = 0; i < 4; i++) {
        sf_curve_sample s = {i + draw_byte(&w->in) / 512.0, i + draw_byte(&w->in) / 64.0, 1};
        samples[i] = s;
    }
    (void)!sf_curve_create(samples, 4, SF_TREND_AUTO, &w->allocator, &curve);
    return curve;
}

void *world_make_mixture(world *w)
{
    static const double fractions[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3, 0.3, 0.4};
    double properties[8];
    sf_mixture_samples samples = {3, 2, 4, fractions, properties, NULL};
    sf_mixture *mixture = NULL;
    for (int i = 0; i < 8; i++) {
        properties[i] = draw_byte(&w->in) / 16.0 + i;
    }
    (void)!sf_mixture_create(&samples, &w->allocator, &mixture, NULL);
    return mixture;
}

void *world_make_sampler(world *w)
{
    const size_t channel = 0;
    sf_sampler *sampler = NULL;
    uint32_t of_tets = draw_below(&w->in, 2);
    if (of_tets) {
        const sf_tets *tets = world_own(w, "sf_tets");
        if (tets != NULL) {
            (void)!sf_sampler_of_tets(tets, &w->lattice, 1, &channel, &w->allocator, &sampler,
                                      NULL);
        }
        return sampler;
    }
    const sf_limit *limit = world_own(w, "sf_limit");
    if (limit != NULL) {
        (void)!sf_sampler_create(limit, &w->lattice, NULL, 1, &channel, &w->allocator, NULL,
                                 &sampler, NULL);
    }
    return sampler;
}

void *world_make_locator(world *w)
{
    sf_locator *locator = NULL;
    const sf_limit *limit = world_own(w, "sf_limit");
    if (limit != NULL) {
        (void)!sf_locator_create(limit, &w->allocator, &locator);
    }
    return locator;
}

void *world_make_history(world *w)
{
    sf_cage_history *history = NULL;
    const sf_cage *cage = world_need(w, "sf_cage");
    if (cage != NULL) {
        (void)!sf_cage_history_create(cage, 1000, &w->allocator, &history);
    }
    return history;
}
