// SPDX-License-Identifier: MIT
// Boxes around things in space, to find those that come near a point.

#ifndef SF_GRADE_LIMIT_BOXES_H
#define SF_GRADE_LIMIT_BOXES_H

#include <sf/base.h>

typedef struct sfi_box {
    double low[3], high[3];
} sfi_box;

// Boxes in the order of a space-filling curve; each eight in a row have a box one level up, and so
// on, up to one.
typedef struct sfi_boxes {
    sf_allocator allocator;
    uint32_t count;
    uint32_t *order; // which thing each box of the lowest level is around
    size_t box_count;
    sfi_box *boxes; // level after level, the lowest first
} sfi_boxes;

// Put `count` boxes, at least one, in order. SF_ERR_MEMORY.
sf_status sfi_boxes_make(const sfi_box *boxes, uint32_t count, const sf_allocator *allocator,
                         sfi_boxes *made);
void sfi_boxes_free(sfi_boxes *boxes);

// A box around points of `width` 3.
sfi_box sfi_box_around(const double *points, uint32_t count);

// The square of a point's distance from a box; 0 within.
double sfi_box_distance2(const sfi_box *box, const double point[3]);

// Call `visit` for things whose boxes are nearer to a point than *reach2, the square of a distance,
// which it may lower, until it returns other than 0.
void sfi_boxes_visit(const sfi_boxes *boxes, const double point[3], const double *reach2,
                     int (*visit)(void *context, uint32_t thing), void *context);

#endif
