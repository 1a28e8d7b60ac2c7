// SPDX-License-Identifier: MIT
// Whether a shape lies the right way out everywhere: piece by piece.
//
// A regular piece is right where the coefficients of its determinant are positive, and wrong where
// they are negative; in between it is cut, a few times. An irregular piece is what it falls into.
// At the end there remain parts around what is irregular, so small that they are left open: at a
// block's smooth edge the determinant tends to 0, and no bound could tell.

#include "grade/limit/jacobian.h"
#include "grade/limit/limit.h"

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"

#include <string.h>

enum { RING_CUTS = 3, SPLINE_CUTS = 2 };

// What is known of a part, the worst first.
typedef enum verdict { WRONG, OPEN, RIGHT } verdict;

// Scratch for one piece.
typedef struct judge {
    const sfi_atlas *atlas;
    double *rings;       // RING_CUTS + 1 of them
    sfi_spline *splines; // three for each cut
} judge;

static verdict worse(verdict a, verdict b)
{
    return a < b ? a : b;
}

static verdict judge_spline(const judge *j, const sfi_spline *spline, uint32_t cuts);

static verdict judge_halves(const judge *j, const sfi_spline *spline, uint32_t axis, uint32_t cuts)
{
    if (axis == 3) {
        return judge_spline(j, spline, cuts + 1);
    }
    verdict all = RIGHT;
    for (uint32_t high = 0; all != WRONG && high < 2; high++) {
        sfi_spline *half = &j->splines[3 * cuts + axis];
        sfi_spline_halve(spline, axis, high, half);
        all = worse(all, judge_halves(j, half, axis + 1, cuts));
    }
    return all;
}

static verdict judge_spline(const judge *j, const sfi_spline *spline, uint32_t cuts)
{
    double least, greatest;
    sfi_jacobian_bounds(spline, &least, &greatest);
    if (least > 0) {
        return RIGHT;
    }
    if (greatest < 0) {
        return WRONG;
    }
    return cuts < SPLINE_CUTS ? judge_halves(j, spline, 0, cuts) : OPEN;
}

static verdict judge_ring(const judge *j, uint32_t kind, const double *values, uint32_t cuts)
{
    const sfi_kind *k = &j->atlas->kinds[kind];
    if (k->is_regular) {
        sfi_spline spline;
        sfi_spline_gather(&k->net, 3, 3, values, &spline);
        return judge_spline(j, &spline, 0);
    }
    if (cuts == RING_CUTS) {
        return OPEN;
    }
    verdict all = RIGHT;
    double *ring = j->rings + 3 * (size_t)j->atlas->most_points * (cuts + 1);
    for (uint32_t place = 0; all != WRONG && place < 8; place++) {
        sfi_matrix_apply(&k->steps[place], 3, values, ring, NULL);
        all = worse(all, judge_ring(j, k->children[place], ring, cuts + 1));
    }
    return all;
}

static sf_status judge_all(const sf_limit *limit, const judge *j, sf_task *task,
                           sf_limit_report *report)
{
    sfi_field field = sfi_limit_field(limit, SF_PROPERTY_MAX);
    sfi_progress progress = sfi_progress_begin(task);
    report->first_inverted = field.chart->pieces;
    for (uint32_t i = 0; i < field.chart->pieces; i++) {
        if (i % 256 == 0) {
            sfi_progress_report(&progress, i, field.chart->pieces);
            if (sf_task_is_cancelled(task)) {
                return SF_ERR_CANCELLED;
            }
        }
        sfi_chart_gather(field.chart, i, 3, field.values, j->rings);
        verdict found = judge_ring(j, field.chart->kinds[i], j->rings, 0);
        report->positive += found == RIGHT;
        report->open += found == OPEN;
        if (found == WRONG && report->inverted++ == 0) {
            report->first_inverted = i;
        }
    }
    return SF_OK;
}

sf_status sf_limit_check(const sf_limit *limit, const sf_allocator *allocator, sf_task *task,
                         sf_limit_report *report)
{
    if (limit == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    if (limit->refined->dimension != 3) {
        return SF_ERR_UNSUPPORTED;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    judge j = {&limit->charts[0].atlas, NULL, NULL};
    size_t numbers = 3 * (size_t)j.atlas->most_points * (RING_CUTS + 1);
    j.rings = sfi_alloc_array(&kept, numbers, sizeof *j.rings);
    j.splines = sfi_alloc_array(&kept, 3 * SPLINE_CUTS, sizeof *j.splines);
    sf_limit_report found;
    memset(&found, 0, sizeof found);
    sf_status status =
        j.rings == NULL || j.splines == NULL ? SF_ERR_MEMORY : judge_all(limit, &j, task, &found);
    sfi_free_array(&kept, j.splines, 3 * SPLINE_CUTS, sizeof *j.splines);
    sfi_free_array(&kept, j.rings, numbers, sizeof *j.rings);
    if (status == SF_OK) {
        *report = found;
    }
    return status;
}
