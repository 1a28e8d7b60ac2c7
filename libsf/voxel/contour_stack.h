// SPDX-License-Identifier: MIT
// Inside a stack of contours, for those who add layers to it.

#ifndef SF_VOXEL_CONTOUR_STACK_H
#define SF_VOXEL_CONTOUR_STACK_H

#include <sf/contour.h>

typedef struct sfi_contour_layer {
    size_t point, start; // its first of each
    size_t contour_count;
    double top_mm;
} sfi_contour_layer;

struct sf_contour_stack {
    sf_allocator allocator;
    double bottom_mm;
    double *points; // x and y
    size_t *starts; // of each layer, contour_count + 1, from 0
    sfi_contour_layer *layers;
    size_t point_count, point_capacity, start_count, start_capacity, layer_capacity;
    uint32_t layer_count;
};

// The top so far.
double sfi_contour_stack_top(const sf_contour_stack *stack);

// Make room for a layer of so many points and contours. They are written behind point_count and
// start_count, and then the layer is closed.
sf_status sfi_contour_stack_room(sf_contour_stack *stack, size_t points, size_t contours);
void sfi_contour_stack_close(sf_contour_stack *stack, double top_mm, size_t points,
                             size_t contours);

#endif
