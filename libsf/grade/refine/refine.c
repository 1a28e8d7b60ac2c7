// SPDX-License-Identifier: MIT
// Refinements: layouts, and the values that go through them.
//
// Everything that can fail is done when a refinement is made. An update multiplies matrices into
// arrays that are there.

#include "grade/refine/refinement.h"

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "grade/cage/cage.h"

#include <math.h>
#include <string.h>

sf_refine_options sf_refine_options_default(void)
{
    sf_refine_options options = {sizeof options, 1, SF_REFINE_STANDARD};
    return options;
}

static const sfi_layout *layout_of(const sf_refinement *r, const sfi_refined_channel *channel)
{
    return &r->layouts[channel->layout];
}

void sf_refinement_destroy(sf_refinement *refinement)
{
    if (refinement == NULL) {
        return;
    }
    sf_refinement *r = refinement;
    sf_allocator allocator = r->allocator;
    for (size_t i = 0; i < r->channel_count; i++) {
        sfi_refined_channel *c = &r->channels[i];
        const sfi_layout *layout = layout_of(r, c);
        for (uint32_t step = 0; step <= r->steps; step++) {
            sfi_free_array(&allocator, c->values[step], layout->points[step], sizeof(double));
        }
        sfi_free_array(&allocator, c->sources, layout->points[0], sizeof(uint32_t));
    }
    for (uint32_t step = 0; step <= r->steps; step++) {
        sfi_free_array(&allocator, r->starts[step], r->cells[step] + 1, sizeof(uint32_t));
        sfi_free_array(&allocator, r->positions[step], 3 * (size_t)r->layouts[0].points[step],
                       sizeof(double));
    }
    for (uint32_t i = 0; i < r->layout_count; i++) {
        sfi_layout_free(&r->layouts[i]);
    }
    sfi_free_array(&allocator, r, 1, sizeof *r);
}

// ---------------------------------------------------------------------------------------------
// Making
// ---------------------------------------------------------------------------------------------

// The layout that has these corners at first, if there is one already.
static int find_layout(const sf_refinement *r, const sfi_glue *glue, uint32_t *index)
{
    for (*index = 1; *index < r->layout_count; (*index)++) {
        const sfi_layout *l = &r->layouts[*index];
        if (l->points[0] == glue->points &&
            memcmp(l->corners[0], glue->items, glue->corners * sizeof *glue->items) == 0) {
            return 1;
        }
    }
    return 0;
}

static sf_status add_layout(const sfi_complex *complex, const sf_refine_options *options,
                            sf_task *task, sf_refinement *r)
{
    SF_TRY(sfi_layout_make(complex, options, &r->allocator, task, &r->layouts[r->layout_count]));
    r->layout_count++;
    return SF_OK;
}

// A copy of where the points of a glue come from, of just their number.
static sf_status copy_sources(const sfi_glue *glue, const sf_allocator *allocator,
                              uint32_t **sources)
{
    *sources = sfi_alloc_array(allocator, glue->points, sizeof **sources);
    if (*sources == NULL) {
        return SF_ERR_MEMORY;
    }
    memcpy(*sources, glue->sources, glue->points * sizeof **sources);
    return SF_OK;
}

// Find or make the layout of glued corners.
static sf_status use_glue(const sf_cage *cage, const sfi_glue *glue,
                          const sf_refine_options *options, sf_task *task, sf_refinement *r,
                          sfi_refined_channel *channel)
{
    if (!find_layout(r, glue, &channel->layout)) {
        sfi_complex glued;
        SF_TRY(sfi_glue_complex(&cage->complex, glue, &r->allocator, &glued));
        sf_status status = add_layout(&glued, options, task, r);
        sfi_complex_free(&glued);
        SF_TRY(status);
    }
    return copy_sources(glue, &r->allocator, &channel->sources);
}

// How a channel with indices hangs together.
static sf_status lay_out(const sf_cage *cage, const uint32_t *indices,
                         const sf_refine_options *options, sf_task *task, sf_refinement *r,
                         sfi_refined_channel *channel)
{
    sfi_glue glue;
    SF_TRY(sfi_glue_make(&cage->complex, indices, &r->allocator, &glue));
    uint32_t *sources = sfi_alloc_array(&r->allocator, cage->points, sizeof *sources);
    sf_status status = SF_ERR_MEMORY;
    if (sources != NULL && sfi_glue_is_whole(&cage->complex, &glue, sources)) {
        channel->sources = sources;
        sources = NULL;
        status = SF_OK;
    } else if (sources != NULL) {
        status = use_glue(cage, &glue, options, task, r, channel);
    }
    sfi_free_array(&r->allocator, sources, cage->points, sizeof *sources);
    sfi_glue_free(&r->allocator, &glue);
    return status;
}

static sf_status alloc_values(sf_refinement *r, sfi_refined_channel *channel)
{
    for (uint32_t step = 0; step <= r->steps; step++) {
        channel->values[step] =
            sfi_alloc_array(&r->allocator, layout_of(r, channel)->points[step], sizeof(double));
        if (channel->values[step] == NULL) {
            return SF_ERR_MEMORY;
        }
    }
    return SF_OK;
}

static sf_status add_channel(const sf_cage *cage, size_t index, const sf_refine_options *options,
                             sf_task *task, sf_refinement *r)
{
    const sf_channel *from = &cage->channels.at[index];
    sfi_refined_channel *channel = &r->channels[r->channel_count++];
    channel->property = from->property;
    channel->value_count = from->value_count;
    if (from->indices != NULL) {
        SF_TRY(lay_out(cage, from->indices, options, task, r, channel));
    }
    SF_TRY(alloc_values(r, channel));
    for (uint32_t step = 0; step <= r->steps; step++) {
        const sfi_layout *layout = layout_of(r, channel);
        sf_channel view = {channel->property, layout->points[step], channel->values[step],
                           channel->layout == 0 ? NULL : layout->corners[step]};
        r->views[step][index] = view;
    }
    return SF_OK;
}

// Where the corners of each cell begin: as in the cage, and then one after the other.
static sf_status alloc_steps(const sf_cage *cage, sf_refinement *r)
{
    uint32_t pieces = r->dimension == 3 ? 8 : 4;
    for (uint32_t step = 0; step <= r->steps; step++) {
        const sfi_layout *layout = &r->layouts[0];
        r->cells[step] = step == 0 ? cage->cells : layout->corner_counts[step] / pieces;
        r->starts[step] = sfi_alloc_array(&r->allocator, r->cells[step] + 1, sizeof(uint32_t));
        r->positions[step] =
            sfi_alloc_array(&r->allocator, 3 * (size_t)layout->points[step], sizeof(double));
        if (r->starts[step] == NULL || r->positions[step] == NULL) {
            return SF_ERR_MEMORY;
        }
        for (size_t i = 0; i <= r->cells[step]; i++) {
            r->starts[step][i] = step == 0 ? cage->starts[i] : (uint32_t)(pieces * i);
        }
    }
    return SF_OK;
}

static void pass_positions(sf_refinement *r, const double *positions, sf_task *task)
{
    memcpy(r->positions[0], positions, 3 * (size_t)r->layouts[0].points[0] * sizeof *positions);
    for (uint32_t step = 0; step < r->steps; step++) {
        sfi_matrix_apply(&r->layouts[0].matrices[step], 3, r->positions[step],
                         r->positions[step + 1], task);
    }
}

static void pass_values(sf_refinement *r, sfi_refined_channel *channel, const double *values,
                        sf_task *task)
{
    const sfi_layout *layout = layout_of(r, channel);
    for (uint32_t i = 0; i < layout->points[0]; i++) {
        channel->values[0][i] = values[channel->sources != NULL ? channel->sources[i] : i];
    }
    for (uint32_t step = 0; step < r->steps; step++) {
        sfi_matrix_apply(&layout->matrices[step], 1, channel->values[step],
                         channel->values[step + 1], task);
    }
}

static sf_status fill(const sf_cage *cage, const sf_refine_options *options, sf_task *task,
                      sf_refinement *r)
{
    sfi_progress progress = sfi_progress_begin(task);
    sfi_part part;
    double parts = (double)cage->channels.count + 1;
    sfi_part_begin(&part, &progress, 0, 1 / parts);
    SF_TRY(add_layout(&cage->complex, options, &part.task, r));
    SF_TRY(alloc_steps(cage, r));
    for (size_t i = 0; i < cage->channels.count; i++) {
        sfi_part_begin(&part, &progress, (double)(i + 1) / parts, (double)(i + 2) / parts);
        SF_TRY(add_channel(cage, i, options, &part.task, r));
    }
    pass_positions(r, cage->positions, task);
    for (size_t i = 0; i < cage->channels.count; i++) {
        pass_values(r, &r->channels[i], cage->channels.at[i].values, task);
    }
    return sf_task_is_cancelled(task) ? SF_ERR_CANCELLED : SF_OK;
}

sf_status sf_refine(const sf_cage *cage, const sf_refine_options *options,
                    const sf_allocator *allocator, sf_task *task, sf_refinement **refinement)
{
    sf_refine_options given = options != NULL ? *options : sf_refine_options_default();
    if (cage == NULL || refinement == NULL || given.struct_size != sizeof given ||
        given.steps < 1 || given.steps > SF_REFINE_STEP_MAX ||
        (given.rules != SF_REFINE_STANDARD && given.rules != SF_REFINE_SEPARABLE)) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_refinement *made = sfi_alloc_array(&kept, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = kept;
    made->dimension = cage->complex.dimension;
    made->steps = given.steps;
    sf_status status = fill(cage, &given, task, made);
    if (status != SF_OK) {
        sf_refinement_destroy(made);
        return status;
    }
    *refinement = made;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Asking and changing
// ---------------------------------------------------------------------------------------------

sf_status sf_refinement_get_view(const sf_refinement *refinement, uint32_t step, sf_cage_view *view)
{
    if (refinement == NULL || view == NULL || step > refinement->steps) {
        return SF_ERR_ARGUMENT;
    }
    const sfi_layout *layout = &refinement->layouts[0];
    sf_cage_view v = {
        refinement->dimension,       layout->points[step],      refinement->positions[step],
        refinement->cells[step],     refinement->starts[step],  layout->corners[step],
        layout->crease_counts[step], layout->creases[step],     layout->sharp_counts[step],
        layout->sharps[step],        refinement->channel_count, refinement->views[step]};
    *view = v;
    return SF_OK;
}

sf_status sf_refinement_update_positions(sf_refinement *refinement, const double *positions,
                                         sf_task *task)
{
    if (refinement == NULL || positions == NULL) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < 3 * (size_t)refinement->layouts[0].points[0]; i++) {
        if (!(fabs(positions[i]) <= SFI_CAGE_REACH)) {
            return SF_ERR_ARGUMENT;
        }
    }
    pass_positions(refinement, positions, task);
    return SF_OK;
}

sf_status sf_refinement_update_values(sf_refinement *refinement, size_t channel,
                                      const double *values, sf_task *task)
{
    if (refinement == NULL || values == NULL || channel >= refinement->channel_count) {
        return SF_ERR_ARGUMENT;
    }
    sfi_refined_channel *changed = &refinement->channels[channel];
    for (size_t i = 0; i < changed->value_count; i++) {
        if (!sfi_property_allows(&changed->property, values[i])) {
            return SF_ERR_ARGUMENT;
        }
    }
    pass_values(refinement, changed, values, task);
    return SF_OK;
}
