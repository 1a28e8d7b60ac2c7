// SPDX-License-Identifier: MIT
// The section: voxels in a plane across x, y or z, with what the property is there, and what a
// printer would put there.
//
// Slices of the limit volume are made along z alone (sf/sample.h); for the other axes the shape's
// coordinates change places, in a circle, so that it is not mirrored. Materials follow each other
// along the property's range: each fades into the next, and the built-in mask makes voxels of it.

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sf/halftone.h>
#include <sf/sample.h>

#include "grade.h"

static const char no_section[] = "No section: ";

double grade_cut_mm(const grade *g)
{
    const grade_state *s = &g->state;
    double low = s->low_mm[s->cut_axis], high = s->high_mm[s->cut_axis];
    return low + s->cut_share * (high - low);
}

void grade_section_free(grade_section *s)
{
    free(s->solid);
    free(s->values);
    free(s->material);
    memset(s, 0, sizeof *s);
}

// Axis k of the slicer is this axis of the shape.
static int axis_of(const grade_section *s, int k)
{
    return (s->axis + 1 + k) % 3;
}

// ---------------------------------------------------------------------------------------------
// The slice
// ---------------------------------------------------------------------------------------------

// The cage with its coordinates changed round, as a limit.
static sf_status make_limit(const grade *g, sf_limit **limit)
{
    sf_cage_view v = sf_cage_get_view(g->cage);
    sf_cage *turned = NULL;
    double *positions = malloc((3 * v.point_count + 1) * sizeof *positions);
    if (positions == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < 3 * v.point_count; i++) {
        positions[i] = v.positions[i / 3 * 3 + (size_t)axis_of(&g->section, (int)(i % 3))];
    }
    v.positions = positions;
    sf_status status = sf_cage_create(&v, NULL, &turned, NULL);
    if (status == SF_OK) {
        status = sf_limit_create(turned, SF_REFINE_STANDARD, NULL, NULL, limit);
    }
    sf_cage_destroy(turned);
    free(positions);
    return status;
}

// One layer, its middle where the cut is.
static sf_lattice lattice_of(const grade *g)
{
    const grade_state *s = &g->state;
    const grade_section *c = &g->section;
    sf_lattice l = {0, 0, 1, c->pitch_mm, c->pitch_mm, c->pitch_mm, NULL, {0, 0, 0}};
    uint32_t *counts[2] = {&l.nx, &l.ny};
    for (int k = 0; k < 2; k++) {
        int a = axis_of(c, k);
        double cells = ceil((s->high_mm[a] - s->low_mm[a]) / c->pitch_mm);
        *counts[k] = (uint32_t)cells + 2;
        l.origin_mm[k] = 0.5 * (s->low_mm[a] + s->high_mm[a]) - 0.5 * (cells + 2) * c->pitch_mm;
    }
    l.origin_mm[2] = c->at_mm - 0.5 * c->pitch_mm;
    return l;
}

static sf_status slice(const sf_limit *limit, const sf_lattice *l, size_t channel, grade_section *c,
                       sf_fault *fault)
{
    sf_sampler *sampler = NULL;
    sf_grid *grid = NULL;
    double *const planes[1] = {c->values};
    sf_status status = sf_sampler_create(limit, l, NULL, 1, &channel, NULL, NULL, &sampler, fault);
    if (status == SF_OK) {
        status = sf_grid_create(l, NULL, &grid);
    }
    if (status == SF_OK) {
        status = sf_sampler_slice(sampler, 0, sf_grid_slice(grid, 0), planes);
    }
    for (size_t i = 0; status == SF_OK && i < (size_t)l->nx * l->ny; i++) {
        c->solid[i] = (uint8_t)sf_slice_get(sf_grid_slice(grid, 0), (uint32_t)(i % l->nx),
                                            (uint32_t)(i / l->nx));
    }
    sf_grid_destroy(grid);
    sf_sampler_destroy(sampler);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Materials
// ---------------------------------------------------------------------------------------------

// How much of material m: a hat over the range, from one material to the next.
static float tone_of(const grade_state *s, double value, uint32_t m)
{
    double t = s->high > s->low ? (value - s->low) / (s->high - s->low) : 0;
    double away = fabs((t > 0 ? (t < 1 ? t : 1) : 0) * (s->materials - 1) - m);
    return (float)(away < 1 ? 1 - away : 0);
}

static sf_status halftone(grade *g)
{
    grade_state *s = &g->state;
    grade_section *c = &g->section;
    size_t voxels = (size_t)c->width * c->height;
    sf_halftone *made = NULL;
    sf_tone_plane planes[GRADE_MATERIALS_MAX];
    float *tones = malloc(GRADE_MATERIALS_MAX * (voxels + 1) * sizeof *tones);
    if (tones == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t m = 0; m < s->materials; m++) {
        for (size_t i = 0; i < voxels; i++) {
            tones[m * voxels + i] = c->solid[i] ? tone_of(s, c->values[i], m) : 0;
        }
        planes[m].values = tones + m * voxels;
        planes[m].stride = c->width;
    }
    double layer = floor((c->at_mm - s->low_mm[c->axis]) / c->pitch_mm);
    sf_tones asked = {.struct_size = sizeof asked,
                      .width = c->width,
                      .height = c->height,
                      .layer = (uint32_t)(layer > 0 ? layer : 0), // at most the resolution
                      .type = SF_TONE_F32,
                      .planes = planes};
    const sf_materials to = {.ids = c->material, .ids_stride = c->width};
    sf_status status = sf_halftone_create(sf_mask_builtin(), s->materials, NULL, &made);
    if (status == SF_OK) {
        status = sf_halftone_slice(made, &asked, &to, NULL);
    }
    for (size_t i = 0; status == SF_OK && i < voxels; i++) {
        c->material[i] = c->solid[i] ? c->material[i] : 0;
        if (c->material[i] > 0) {
            s->counts[c->material[i] - 1]++;
        }
    }
    sf_halftone_destroy(made);
    free(tones);
    return status;
}

// ---------------------------------------------------------------------------------------------
// The whole
// ---------------------------------------------------------------------------------------------

static sf_status make(grade *g, sf_fault *fault)
{
    grade_state *s = &g->state;
    grade_section *c = &g->section;
    sf_limit *limit = NULL;
    double size = 0;
    for (int i = 0; i < 3; i++) {
        size = fmax(size, s->high_mm[i] - s->low_mm[i]);
    }
    c->axis = s->cut_axis;
    c->at_mm = grade_cut_mm(g);
    c->pitch_mm = s->pitch_mm = size / s->resolution;
    sf_lattice l = lattice_of(g);
    size_t voxels = (size_t)l.nx * l.ny;
    c->width = l.nx;
    c->height = l.ny;
    memcpy(c->origin_mm, l.origin_mm, sizeof c->origin_mm);
    c->solid = calloc(voxels, 1);
    c->values = calloc(voxels, sizeof *c->values);
    c->material = calloc(voxels, 1);
    if (c->solid == NULL || c->values == NULL || c->material == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = make_limit(g, &limit);
    if (status == SF_OK) {
        status = slice(limit, &l, s->channel, c, fault);
    }
    sf_limit_destroy(limit);
    return status == SF_OK ? halftone(g) : status;
}

// Whether it is large enough, where it lies, for voxels to differ from each other.
static int has_size(const grade_state *s)
{
    double size = 0, away = 0;
    for (int i = 0; i < 3; i++) {
        size = fmax(size, s->high_mm[i] - s->low_mm[i]);
        away = fmax(away, fmax(fabs(s->low_mm[i]), fabs(s->high_mm[i])));
    }
    return size > 1e-9 * away;
}

static void say_none(grade *g, const char *why)
{
    snprintf(g->base.said, sizeof g->base.said, "%s%s", no_section, why);
}

void grade_section_make(grade *g)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    g->is_section_old = 0;
    g->base.is_stale = 1;
    grade_section_free(&g->section);
    memset(g->state.counts, 0, sizeof g->state.counts);
    if (strncmp(g->base.said, no_section, strlen(no_section)) == 0) {
        grade_say(g, ""); // of the one before
    }
    if (!g->state.is_cut || g->state.cage.dimension != 3) {
        return;
    }
    if (!has_size(&g->state)) {
        say_none(g, "the shape has no size.");
        return;
    }
    sf_status status = make(g, &fault);
    if (status != SF_OK) {
        grade_section_free(&g->section);
        say_none(g, fault.message[0] != '\0' ? fault.message : sf_status_message(status));
    }
}
