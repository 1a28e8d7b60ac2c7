// SPDX-License-Identifier: MIT
// Limits: a refinement by one step, and charts of its pieces.
//
// The step makes hexahedra of all cells, and leaves each piece with at most one point that was
// irregular in the cage. What is refined once anyway is also what updates go through.

#include "grade/limit/limit.h"

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "grade/cage/sharp.h"
#include "grade/limit/descend.h"
#include "grade/limit/spline.h"

#include <string.h>

enum { BLOCK_PLACES = 512, MOST_WORKERS = 64 };

void sf_limit_destroy(sf_limit *limit)
{
    if (limit == NULL) {
        return;
    }
    sf_allocator allocator = limit->allocator;
    for (size_t i = 0; i < 1 + SF_PROPERTY_MAX; i++) {
        sfi_chart_free(&limit->charts[i]);
    }
    sf_refinement_destroy(limit->refined);
    sfi_free_array(&allocator, limit, 1, sizeof *limit);
}

// The complex of a layout after its step, and its chart.
static sf_status chart_layout(const sf_refinement *r, uint32_t index, int separable, sf_task *task,
                              sfi_chart *chart)
{
    const sfi_layout *layout = &r->layouts[index];
    sfi_corners corners = {r->dimension, layout->points[1], (uint32_t)r->cells[1], r->starts[1],
                           layout->corners[1]};
    sf_cage_view sharp;
    memset(&sharp, 0, sizeof sharp);
    sharp.crease_count = layout->crease_counts[1];
    sharp.creases = layout->creases[1];
    sharp.sharp_count = layout->sharp_counts[1];
    sharp.sharps = layout->sharps[1];
    sfi_complex complex;
    SF_TRY(sfi_complex_build(&corners, &r->allocator, &complex, NULL));
    sf_status status = sfi_sharp_set(&sharp, &complex, NULL);
    if (status == SF_OK) {
        status = sfi_chart_make(&complex, separable, &r->allocator, task, chart);
    }
    sfi_complex_free(&complex);
    return status;
}

static sf_status fill(const sf_cage *cage, sf_refine_rules rules, sf_task *task, sf_limit *limit)
{
    sf_refine_options options = sf_refine_options_default();
    sfi_progress progress = sfi_progress_begin(task);
    sfi_part part;
    options.rules = rules;
    sfi_part_begin(&part, &progress, 0, 0.2);
    SF_TRY(sf_refine(cage, &options, &limit->allocator, &part.task, &limit->refined));
    double layouts = limit->refined->layout_count;
    for (uint32_t i = 0; i < limit->refined->layout_count; i++) {
        sfi_part_begin(&part, &progress, 0.2 + 0.8 * i / layouts, 0.2 + 0.8 * (i + 1) / layouts);
        SF_TRY(chart_layout(limit->refined, i, rules == SF_REFINE_SEPARABLE, &part.task,
                            &limit->charts[i]));
    }
    return SF_OK;
}

sf_status sf_limit_create(const sf_cage *cage, sf_refine_rules rules, const sf_allocator *allocator,
                          sf_task *task, sf_limit **limit)
{
    if (cage == NULL || limit == NULL ||
        (rules != SF_REFINE_STANDARD && rules != SF_REFINE_SEPARABLE)) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_limit *made = sfi_alloc_array(&kept, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = kept;
    sf_status status = fill(cage, rules, task, made);
    if (status != SF_OK) {
        sf_limit_destroy(made);
        return status;
    }
    *limit = made;
    return SF_OK;
}

size_t sf_limit_piece_count(const sf_limit *limit)
{
    return limit == NULL ? 0 : limit->refined->cells[1];
}

// A hexahedron's own axes, and a quadrilateral's, are its pieces' axes too.
sf_status sf_limit_place(const sf_limit *limit, size_t cell, const double u[3], sf_place *place)
{
    if (limit == NULL || u == NULL || place == NULL || cell >= limit->refined->cells[0]) {
        return SF_ERR_ARGUMENT;
    }
    const uint32_t *starts = limit->refined->starts[0];
    uint32_t dimension = limit->refined->dimension, bits = 0;
    sf_place found = {0, {0, 0, 0}};
    if (starts[cell + 1] - starts[cell] != 1u << dimension) {
        return SF_ERR_UNSUPPORTED;
    }
    for (uint32_t axis = 0; axis < dimension; axis++) {
        if (!(u[axis] >= 0 && u[axis] <= 1)) {
            return SF_ERR_ARGUMENT;
        }
        uint32_t high = u[axis] >= 0.5;
        bits |= high << axis;
        found.u[axis] = 2 * u[axis] - high;
    }
    found.piece = starts[cell] + sfi_hex_bits(bits);
    *place = found;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Evaluation
// ---------------------------------------------------------------------------------------------

sfi_field sfi_limit_field(const sf_limit *limit, size_t channel)
{
    const sf_refinement *r = limit->refined;
    if (channel == SF_PROPERTY_MAX) {
        sfi_field positions = {&limit->charts[0], 3, r->positions[1]};
        return positions;
    }
    const sfi_refined_channel *c = &r->channels[channel];
    sfi_field values = {&limit->charts[c->layout], 1, c->values[1]};
    return values;
}

// Many places, in blocks; worker w has the blocks w, w + workers, ...
typedef struct job {
    sfi_field field;
    uint32_t dimension;
    size_t count, workers, scratch; // scratch of one worker
    const sf_place *places;
    double *memory, *values, *derivatives;
} job;

static void evaluate(const job *j, size_t i, double *scratch)
{
    const sfi_chart *chart = j->field.chart;
    const sf_place *place = &j->places[i];
    uint32_t width = j->field.width;
    double *rest = scratch + (size_t)chart->atlas.most_points * width, u[3] = {0, 0, 0};
    for (uint32_t axis = 0; axis < j->dimension; axis++) {
        double here = place->u[axis];
        u[axis] = here < 0 ? 0 : here > 1 ? 1 : here;
    }
    sfi_chart_gather(chart, place->piece, width, j->field.values, scratch);
    sfi_limit_at(&chart->atlas, chart->kinds[place->piece], width, scratch, u, rest,
                 j->values + width * i,
                 j->derivatives == NULL ? NULL : j->derivatives + (size_t)j->dimension * width * i);
}

static void work(void *context, size_t worker)
{
    const job *j = context;
    double *scratch = j->memory + j->scratch * worker;
    for (size_t block = worker; block * BLOCK_PLACES < j->count; block += j->workers) {
        size_t from = block * BLOCK_PLACES, to = from + BLOCK_PLACES;
        for (size_t i = from; i < (to < j->count ? to : j->count); i++) {
            evaluate(j, i, scratch);
        }
    }
}

static int is_place(const sf_limit *limit, const sf_place *place)
{
    for (uint32_t axis = 0; axis < limit->refined->dimension; axis++) {
        if (!(place->u[axis] >= -1e-9 && place->u[axis] <= 1 + 1e-9)) {
            return 0;
        }
    }
    return place->piece < limit->refined->cells[1];
}

static sf_status evaluate_all(const sf_limit *limit, size_t channel, size_t count,
                              const sf_place *places, const sf_allocator *allocator, sf_task *task,
                              double *values, double *derivatives)
{
    for (size_t i = 0; i < count; i++) {
        if (!is_place(limit, &places[i])) {
            return SF_ERR_ARGUMENT;
        }
    }
    job j = {sfi_limit_field(limit, channel),
             limit->refined->dimension,
             count,
             0,
             0,
             places,
             NULL,
             values,
             derivatives};
    size_t blocks = (count + BLOCK_PLACES - 1) / BLOCK_PLACES;
    j.workers = blocks < MOST_WORKERS ? blocks : MOST_WORKERS;
    j.scratch = (size_t)j.field.chart->atlas.most_points * j.field.width +
                sfi_limit_scratch(&j.field.chart->atlas, j.field.width);
    if (count == 0 || sf_task_is_cancelled(task)) {
        return count == 0 ? SF_OK : SF_ERR_CANCELLED;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    j.memory = sfi_alloc_array(&kept, j.workers * j.scratch, sizeof *j.memory);
    if (j.memory == NULL) {
        return SF_ERR_MEMORY;
    }
    sfi_task_for(task, j.workers, work, &j);
    sfi_free_array(&kept, j.memory, j.workers * j.scratch, sizeof *j.memory);
    return SF_OK;
}

sf_status sf_limit_positions(const sf_limit *limit, size_t count, const sf_place *places,
                             const sf_allocator *allocator, sf_task *task, double *positions,
                             double *derivatives)
{
    if (limit == NULL || (count > 0 && (places == NULL || positions == NULL))) {
        return SF_ERR_ARGUMENT;
    }
    return evaluate_all(limit, SF_PROPERTY_MAX, count, places, allocator, task, positions,
                        derivatives);
}

sf_status sf_limit_values(const sf_limit *limit, size_t channel, size_t count,
                          const sf_place *places, const sf_allocator *allocator, sf_task *task,
                          double *values, double *derivatives)
{
    if (limit == NULL || channel >= limit->refined->channel_count ||
        (count > 0 && (places == NULL || values == NULL))) {
        return SF_ERR_ARGUMENT;
    }
    return evaluate_all(limit, channel, count, places, allocator, task, values, derivatives);
}

sf_status sf_limit_update_positions(sf_limit *limit, const double *positions, sf_task *task)
{
    return limit == NULL ? SF_ERR_ARGUMENT
                         : sf_refinement_update_positions(limit->refined, positions, task);
}

sf_status sf_limit_update_values(sf_limit *limit, size_t channel, const double *values,
                                 sf_task *task)
{
    return limit == NULL ? SF_ERR_ARGUMENT
                         : sf_refinement_update_values(limit->refined, channel, values, task);
}
