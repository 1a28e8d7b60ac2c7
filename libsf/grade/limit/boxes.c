// SPDX-License-Identifier: MIT
// A tree of boxes without links: blocks of eight along a space-filling curve.

#include "grade/limit/boxes.h"

#include "base/memory.h"
#include "base/status.h"
#include "mesh/morton.h"

#include <string.h>

enum { BLOCK = 8, MOST_LEVELS = 12 };

void sfi_boxes_free(sfi_boxes *boxes)
{
    sfi_free_array(&boxes->allocator, boxes->order, boxes->count, sizeof *boxes->order);
    sfi_free_array(&boxes->allocator, boxes->boxes, boxes->box_count, sizeof *boxes->boxes);
    memset(boxes, 0, sizeof *boxes);
}

sfi_box sfi_box_around(const double *points, uint32_t count)
{
    sfi_box box = {{points[0], points[1], points[2]}, {points[0], points[1], points[2]}};
    for (uint32_t i = 1; i < count; i++) {
        for (uint32_t axis = 0; axis < 3; axis++) {
            double x = points[3 * (size_t)i + axis];
            box.low[axis] = x < box.low[axis] ? x : box.low[axis];
            box.high[axis] = x > box.high[axis] ? x : box.high[axis];
        }
    }
    return box;
}

double sfi_box_distance2(const sfi_box *box, const double point[3])
{
    double sum = 0;
    for (uint32_t axis = 0; axis < 3; axis++) {
        double under = box->low[axis] - point[axis], over = point[axis] - box->high[axis];
        double out = under > over ? under : over;
        sum += out > 0 ? out * out : 0;
    }
    return sum;
}

static void add_box(sfi_box *to, const sfi_box *box)
{
    for (uint32_t axis = 0; axis < 3; axis++) {
        to->low[axis] = box->low[axis] < to->low[axis] ? box->low[axis] : to->low[axis];
        to->high[axis] = box->high[axis] > to->high[axis] ? box->high[axis] : to->high[axis];
    }
}

static sf_status sort(const sfi_box *boxes, uint32_t count, const sf_allocator *allocator,
                      uint32_t *order)
{
    double *middles = sfi_alloc_array(allocator, count, 3 * sizeof *middles);
    if (middles == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < 3 * (size_t)count; i++) {
        middles[i] = (boxes[i / 3].low[i % 3] + boxes[i / 3].high[i % 3]) / 2;
    }
    sf_status status = sfi_morton_order(middles, count, allocator, order);
    sfi_free_array(allocator, middles, count, 3 * sizeof *middles);
    return status;
}

// Boxes of all levels of a tree over `count` things.
static size_t count_boxes(size_t count)
{
    size_t sum = count;
    while (count > 1) {
        count = (count + BLOCK - 1) / BLOCK;
        sum += count;
    }
    return sum;
}

sf_status sfi_boxes_make(const sfi_box *boxes, uint32_t count, const sf_allocator *allocator,
                         sfi_boxes *made)
{
    sfi_boxes b = {*allocator, count, NULL, count_boxes(count), NULL};
    b.order = sfi_alloc_array(allocator, count, sizeof *b.order);
    b.boxes = sfi_alloc_array(allocator, b.box_count, sizeof *b.boxes);
    sf_status status =
        b.order == NULL || b.boxes == NULL ? SF_ERR_MEMORY : sort(boxes, count, allocator, b.order);
    if (status != SF_OK) {
        sfi_boxes_free(&b);
        return status;
    }
    for (uint32_t i = 0; i < count; i++) {
        b.boxes[i] = boxes[b.order[i]];
    }
    sfi_box *below = b.boxes, *here = b.boxes + count;
    for (size_t level = count; level > 1; level = (level + BLOCK - 1) / BLOCK) {
        for (size_t i = 0; i < level; i += BLOCK) {
            *here = below[i];
            for (size_t j = i + 1; j < i + BLOCK && j < level; j++) {
                add_box(here, &below[j]);
            }
            here++;
        }
        below += level;
    }
    *made = b;
    return SF_OK;
}

// Where the walk is on one level.
typedef struct level {
    size_t first, count; // its boxes
    size_t at, end;      // those of the block that is being looked at
} level;

static uint32_t find_levels(const sfi_boxes *b, level *levels)
{
    uint32_t depth = 0;
    size_t first = 0;
    for (size_t count = b->count;; count = (count + BLOCK - 1) / BLOCK) {
        level l = {first, count, 0, 0};
        levels[depth++] = l;
        first += count;
        if (count == 1) {
            return depth;
        }
    }
}

void sfi_boxes_visit(const sfi_boxes *boxes, const double point[3], const double *reach2,
                     int (*visit)(void *context, uint32_t thing), void *context)
{
    level levels[MOST_LEVELS];
    uint32_t depth = find_levels(boxes, levels), at = depth - 1;
    levels[at].end = 1;
    while (at < depth) {
        level *l = &levels[at];
        if (l->at == l->end) {
            at++;
            continue;
        }
        size_t i = l->at++;
        if (sfi_box_distance2(&boxes->boxes[l->first + i], point) > *reach2) {
            continue;
        }
        if (at == 0) {
            if (visit(context, boxes->order[i]) != 0) {
                return;
            }
            continue;
        }
        level *below = &levels[--at];
        below->at = BLOCK * i;
        below->end = BLOCK * (i + 1) < below->count ? BLOCK * (i + 1) : below->count;
    }
}
