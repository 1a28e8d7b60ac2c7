// SPDX-License-Identifier: MIT
// Locating points: boxes tell which pieces to search.
//
// Most points are found by Newton's method in the first or second piece whose box they are in.
// Those that are not are looked for once more, cutting what will not converge; and if they are in
// no piece at all, a third time in all pieces within reach, for the nearest place.

#include <sf/locate.h>

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "grade/limit/boxes.h"
#include "grade/limit/limit.h"
#include "grade/limit/search.h"

#include <math.h>
#include <string.h>

#define WITHIN 1e-10 // of the diagonal: a place that near is that of a point

enum { BLOCK_POINTS = 128, MOST_WORKERS = 64 };

struct sf_locator {
    sf_allocator allocator;
    const sf_limit *limit;
    sfi_boxes boxes;
    double within; // how near a place must be to be that of a point
};

void sf_locator_destroy(sf_locator *locator)
{
    if (locator != NULL) {
        sf_allocator allocator = locator->allocator;
        sfi_boxes_free(&locator->boxes);
        sfi_free_array(&allocator, locator, 1, sizeof *locator);
    }
}

// A box around a piece: that of its ring, within which the shape lies.
static sfi_box piece_box(const sfi_field *field, uint32_t piece)
{
    const sfi_lists *points = &field->chart->points;
    sfi_box box =
        sfi_box_around(field->values + 3 * (size_t)points->items[points->starts[piece]], 1);
    for (uint32_t i = points->starts[piece]; i < points->starts[piece + 1]; i++) {
        const double *p = field->values + 3 * (size_t)points->items[i];
        for (uint32_t axis = 0; axis < 3; axis++) {
            box.low[axis] = p[axis] < box.low[axis] ? p[axis] : box.low[axis];
            box.high[axis] = p[axis] > box.high[axis] ? p[axis] : box.high[axis];
        }
    }
    return box;
}

static sf_status fill(const sf_limit *limit, sf_locator *locator)
{
    sfi_field field = sfi_limit_field(limit, SF_PROPERTY_MAX);
    uint32_t pieces = field.chart->pieces;
    sfi_box *boxes = sfi_alloc_array(&locator->allocator, pieces, sizeof *boxes);
    if (boxes == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < pieces; i++) {
        boxes[i] = piece_box(&field, i);
    }
    sf_status status = sfi_boxes_make(boxes, pieces, &locator->allocator, &locator->boxes);
    sfi_free_array(&locator->allocator, boxes, pieces, sizeof *boxes);
    if (status == SF_OK) {
        const sfi_box *whole = &locator->boxes.boxes[locator->boxes.box_count - 1];
        double sum = 0;
        for (uint32_t axis = 0; axis < 3; axis++) {
            double side = whole->high[axis] - whole->low[axis];
            sum += side * side;
        }
        locator->within = WITHIN * sqrt(sum);
    }
    return status;
}

sf_status sf_locator_create(const sf_limit *limit, const sf_allocator *allocator,
                            sf_locator **locator)
{
    if (limit == NULL || locator == NULL) {
        return SF_ERR_ARGUMENT;
    }
    if (limit->refined->dimension != 3) {
        return SF_ERR_UNSUPPORTED;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_locator *made = sfi_alloc_array(&kept, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = kept;
    made->limit = limit;
    sf_status status = fill(limit, made);
    if (status != SF_OK) {
        sf_locator_destroy(made);
        return status;
    }
    *locator = made;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Searching
// ---------------------------------------------------------------------------------------------

// Many points, in blocks; worker w has the blocks w, w + workers, ...
typedef struct job {
    const sf_locator *locator;
    sfi_field field;
    size_t count, workers, scratch; // scratch of one worker
    double reach;
    const double *points;
    double *memory;
    sf_place *places;
    double *distances;
} job;

// One point's search among pieces.
typedef struct hunt {
    const job *j;
    sfi_search search;
    double *ring;
    uint32_t piece; // where the best place is
} hunt;

static int look_into(void *context, uint32_t piece)
{
    hunt *h = context;
    const sfi_chart *chart = h->j->field.chart;
    sfi_chart_gather(chart, piece, 3, h->j->field.values, h->ring);
    h->search.found = 0;
    int done = sfi_search_piece(&h->search, chart->kinds[piece], h->ring);
    if (h->search.found) {
        h->piece = piece;
    }
    return done;
}

// Returns 1 if a place is as near as one can ask.
static int hunt_within(hunt *h, double reach, int split)
{
    h->piece = SF_NO_PIECE;
    h->search.reach2 = reach * reach;
    h->search.split = split;
    h->search.left = SFI_SEARCH_PARTS;
    sfi_boxes_visit(&h->j->locator->boxes, h->search.point, &h->search.reach2, look_into, h);
    return h->piece != SF_NO_PIECE;
}

static void find(const job *j, size_t i, double *scratch)
{
    const sf_locator *l = j->locator;
    hunt h;
    memset(&h, 0, sizeof h);
    h.j = j;
    h.ring = scratch;
    h.search.atlas = &j->field.chart->atlas;
    h.search.scratch = scratch + 3 * (size_t)j->field.chart->atlas.most_points;
    h.search.close = l->within;
    memcpy(h.search.point, j->points + 3 * i, sizeof h.search.point);
    int found = hunt_within(&h, l->within, 0) || hunt_within(&h, l->within, 1) ||
                (j->reach > l->within && hunt_within(&h, j->reach, 0));
    sf_place place = {found ? h.piece : SF_NO_PIECE, {0, 0, 0}};
    for (uint32_t axis = 0; found && axis < 3; axis++) {
        place.u[axis] = h.search.u[axis];
    }
    j->places[i] = place;
    if (j->distances != NULL) {
        j->distances[i] = found ? sqrt(h.search.reach2) : INFINITY;
    }
}

static void work(void *context, size_t worker)
{
    const job *j = context;
    double *scratch = j->memory + j->scratch * worker;
    for (size_t block = worker; block * BLOCK_POINTS < j->count; block += j->workers) {
        size_t from = block * BLOCK_POINTS, to = from + BLOCK_POINTS;
        for (size_t i = from; i < (to < j->count ? to : j->count); i++) {
            find(j, i, scratch);
        }
    }
}

sf_status sf_locator_find(const sf_locator *locator, size_t count, const double *points,
                          double reach_mm, const sf_allocator *allocator, sf_task *task,
                          sf_place *places, double *distances)
{
    if (locator == NULL || !(reach_mm >= 0 && isfinite(reach_mm)) ||
        (count > 0 && (points == NULL || places == NULL))) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < count; i++) {
        for (size_t axis = 0; axis < 3; axis++) {
            if (!isfinite(points[3 * i + axis])) {
                return SF_ERR_ARGUMENT;
            }
        }
    }
    if (count == 0 || sf_task_is_cancelled(task)) {
        return count == 0 ? SF_OK : SF_ERR_CANCELLED;
    }
    size_t blocks = (count + BLOCK_POINTS - 1) / BLOCK_POINTS;
    job j = {locator, sfi_limit_field(locator->limit, SF_PROPERTY_MAX),
             count,   0,
             0,       reach_mm,
             points,  NULL,
             places,  distances};
    j.workers = blocks < MOST_WORKERS ? blocks : MOST_WORKERS;
    j.scratch =
        3 * (size_t)j.field.chart->atlas.most_points + sfi_search_scratch(&j.field.chart->atlas);
    sf_allocator kept = sfi_allocator_or_default(allocator);
    j.memory = sfi_alloc_array(&kept, j.workers * j.scratch, sizeof *j.memory);
    if (j.memory == NULL) {
        return SF_ERR_MEMORY;
    }
    sfi_task_for(task, j.workers, work, &j);
    sfi_free_array(&kept, j.memory, j.workers * j.scratch, sizeof *j.memory);
    return SF_OK;
}
