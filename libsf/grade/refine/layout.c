// SPDX-License-Identifier: MIT
// A complex through some steps.
//
// Of each step what is kept is what values need: the matrix that leads there, and the corners of
// its cells. The complex in full is there only while the next step is made from it; of the last
// step, which is as large as eight of the one before, it is never made.

#include "grade/refine/layout.h"

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "grade/refine/rules.h"

#include <string.h>

void sfi_layout_free(sfi_layout *layout)
{
    const sf_allocator *allocator = &layout->allocator;
    for (uint32_t i = 0; i <= layout->steps; i++) {
        sfi_free_array(allocator, layout->corners[i], layout->corner_counts[i], sizeof(uint32_t));
        sfi_free_array(allocator, layout->creases[i], layout->crease_counts[i], sizeof(sf_crease));
        sfi_free_array(allocator, layout->sharps[i], layout->sharp_counts[i],
                       sizeof(sf_sharp_point));
    }
    for (uint32_t i = 0; i < layout->steps; i++) {
        sfi_matrix_free(&layout->matrices[i]);
    }
    memset(layout, 0, sizeof *layout);
}

// What stays sharp when a complex is cut: both halves of an edge, and the points themselves.
static sf_status keep_sharp(const sfi_complex *c, sfi_layout *layout, uint32_t step)
{
    size_t edges = 0, points = 0;
    for (uint32_t e = 0; e < c->edges; e++) {
        edges += sfi_less_sharp(c->edge_sharpness[e]) > 0;
    }
    for (uint32_t v = 0; v < c->points; v++) {
        points += sfi_less_sharp(c->point_sharpness[v]) > 0;
    }
    sf_crease *creases =
        edges == 0 ? NULL : sfi_alloc_array(&layout->allocator, 2 * edges, sizeof *creases);
    sf_sharp_point *sharps =
        points == 0 ? NULL : sfi_alloc_array(&layout->allocator, points, sizeof *sharps);
    layout->creases[step] = creases;
    layout->crease_counts[step] = 2 * edges;
    layout->sharps[step] = sharps;
    layout->sharp_counts[step] = points;
    if ((creases == NULL && edges > 0) || (sharps == NULL && points > 0)) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t e = 0; e < c->edges; e++) {
        double sharpness = sfi_less_sharp(c->edge_sharpness[e]);
        for (size_t end = 0; sharpness > 0 && end < 2; end++) {
            sf_crease half = {{c->edge_points[2 * (size_t)e + end], c->points + e}, sharpness};
            *creases++ = half;
        }
    }
    for (uint32_t v = 0; v < c->points; v++) {
        if (sfi_less_sharp(c->point_sharpness[v]) > 0) {
            sf_sharp_point point = {v, sfi_less_sharp(c->point_sharpness[v])};
            *sharps++ = point;
        }
    }
    return SF_OK;
}

// One step: its matrix, its corners and what is sharp after it.
static sf_status add_step(const sfi_complex *c, const sf_refine_options *options, sf_task *task,
                          sfi_layout *layout, uint32_t step)
{
    SF_TRY(
        sfi_rules_matrix(c, options->rules == SF_REFINE_SEPARABLE, task, &layout->matrices[step]));
    size_t pieces = layout->corner_counts[step], corners;
    if (!sfi_size_mul(pieces, c->dimension == 3 ? 8 : 4, &corners) || corners > SF_CAGE_POINT_MAX) {
        return SF_ERR_OVERFLOW;
    }
    layout->points[step + 1] = sfi_complex_split_points(c);
    layout->corner_counts[step + 1] = corners;
    layout->corners[step + 1] = sfi_alloc_array(&layout->allocator, corners, sizeof(uint32_t));
    if (layout->corners[step + 1] == NULL) {
        return SF_ERR_MEMORY;
    }
    sfi_complex_split_cells(c, layout->corners[step + 1]);
    return keep_sharp(c, layout, step + 1);
}

static sf_status add_steps(const sfi_complex *complex, const sf_refine_options *options,
                           sf_task *task, sfi_layout *layout)
{
    sfi_progress progress = sfi_progress_begin(task);
    uint64_t all = (uint64_t)1 << 3 * options->steps;
    const sfi_complex *coarse = complex;
    sfi_complex held = {0};
    sf_status status = SF_OK;
    for (uint32_t step = 0; status == SF_OK && step < options->steps; step++) {
        status = add_step(coarse, options, task, layout, step);
        if (status == SF_OK && step + 1 < options->steps) {
            sfi_complex fine;
            status = sfi_complex_split(coarse, &layout->allocator, &fine);
            if (status == SF_OK) {
                sfi_complex_free(&held);
                held = fine;
                coarse = &held;
            }
        }
        sfi_progress_report(&progress, (uint64_t)1 << 3 * (step + 1), all);
    }
    sfi_complex_free(&held);
    return status;
}

sf_status sfi_layout_make(const sfi_complex *complex, const sf_refine_options *options,
                          const sf_allocator *allocator, sf_task *task, sfi_layout *layout)
{
    const sfi_lists *cells =
        complex->dimension == 3 ? &complex->cell_points : &complex->face_points;
    uint32_t count = complex->dimension == 3 ? complex->cells : complex->faces;
    sfi_layout made;
    memset(&made, 0, sizeof made);
    made.allocator = *allocator;
    made.steps = options->steps;
    made.points[0] = complex->points;
    made.corner_counts[0] = cells->starts[count];
    made.corners[0] = sfi_alloc_array(allocator, made.corner_counts[0], sizeof(uint32_t));
    sf_status status = SF_ERR_MEMORY;
    if (made.corners[0] != NULL) {
        memcpy(made.corners[0], cells->items, made.corner_counts[0] * sizeof(uint32_t));
        status = add_steps(complex, options, task, &made);
    }
    if (status == SF_OK) {
        *layout = made;
    } else {
        sfi_layout_free(&made);
    }
    return status;
}
