// SPDX-License-Identifier: MIT
// Charts: the rings of all pieces of a mesh.

#include "grade/limit/chart.h"

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "grade/limit/corner.h"

#include <string.h>

void sfi_chart_free(sfi_chart *chart)
{
    const sf_allocator *allocator = &chart->atlas.allocator;
    sfi_free_array(allocator, chart->kinds, chart->pieces, sizeof *chart->kinds);
    sfi_free_array(allocator, chart->across, 2 * (size_t)chart->pieces * chart->atlas.dimension,
                   sizeof *chart->across);
    sfi_free_array(allocator, chart->points.starts, (size_t)chart->pieces + 1, sizeof(uint32_t));
    sfi_free_array(allocator, chart->points.items, chart->item_capacity, sizeof(uint32_t));
    sfi_atlas_free(&chart->atlas);
    memset(chart, 0, sizeof *chart);
}

static sf_status add_piece(sfi_chart *chart, sfi_ring_finder *finder, uint32_t piece)
{
    SF_TRY(sfi_ring_find(finder, piece));
    SF_TRY(sfi_atlas_add(&chart->atlas, &finder->ring, &chart->kinds[piece]));
    for (uint32_t side = 0; side < 2 * chart->atlas.dimension; side++) {
        chart->across[2 * (size_t)chart->atlas.dimension * piece + side] =
            sfi_ring_across(finder, piece, side / 2, side % 2);
    }
    uint32_t start = chart->points.starts[piece];
    size_t end = (size_t)start + finder->ring.points;
    if (end > UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    if (!sfi_grow_array(&chart->atlas.allocator, (void **)&chart->points.items,
                        &chart->item_capacity, end, sizeof(uint32_t))) {
        return SF_ERR_MEMORY;
    }
    memcpy(chart->points.items + start, finder->points_at,
           finder->ring.points * sizeof *finder->points_at);
    chart->points.starts[piece + 1] = (uint32_t)end;
    return SF_OK;
}

static sf_status add_pieces(sfi_chart *chart, sfi_ring_finder *finder, sf_task *task)
{
    sfi_progress progress = sfi_progress_begin(task);
    chart->points.starts[0] = 0;
    for (uint32_t piece = 0; piece < chart->pieces; piece++) {
        if (piece % 1024 == 0) {
            sfi_progress_report(&progress, piece, chart->pieces);
            if (sf_task_is_cancelled(task)) {
                return SF_ERR_CANCELLED;
            }
        }
        SF_TRY(add_piece(chart, finder, piece));
    }
    SF_TRY(sfi_atlas_close(&chart->atlas, task));
    return sfi_corners_find_all(&chart->atlas);
}

sf_status sfi_chart_make(const sfi_complex *complex, int separable, const sf_allocator *allocator,
                         sf_task *task, sfi_chart *chart)
{
    sfi_chart made;
    sfi_ring_finder finder;
    memset(&made, 0, sizeof made);
    memset(&finder, 0, sizeof finder);
    SF_TRY(sfi_atlas_begin(allocator, complex->dimension, separable, &made.atlas));
    made.pieces = complex->dimension == 3 ? complex->cells : complex->faces;
    made.kinds = sfi_alloc_array(allocator, made.pieces, sizeof *made.kinds);
    made.across = sfi_alloc_array(allocator, 2 * (size_t)made.pieces * complex->dimension,
                                  sizeof *made.across);
    made.points.starts = sfi_alloc_array(allocator, (size_t)made.pieces + 1, sizeof(uint32_t));
    sf_status status = made.kinds == NULL || made.across == NULL || made.points.starts == NULL
                           ? SF_ERR_MEMORY
                           : sfi_ring_finder_begin(complex, allocator, &finder);
    if (status == SF_OK) {
        status = add_pieces(&made, &finder, task);
    }
    sfi_ring_finder_free(&finder);
    if (status == SF_OK) {
        *chart = made;
    } else {
        sfi_chart_free(&made);
    }
    return status;
}

void sfi_chart_gather(const sfi_chart *chart, uint32_t piece, uint32_t width, const double *values,
                      double *ring)
{
    uint32_t start = chart->points.starts[piece], end = chart->points.starts[piece + 1];
    for (uint32_t i = start; i < end; i++) {
        memcpy(ring + (size_t)(i - start) * width, values + (size_t)chart->points.items[i] * width,
               width * sizeof *values);
    }
}
