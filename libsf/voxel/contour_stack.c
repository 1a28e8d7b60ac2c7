// SPDX-License-Identifier: MIT
// Stacks of contours: layers of closed polygons with their heights, in one object.
//
// Three arrays grow as layers come: the points of all layers, the starts of all contours, and a
// record for each layer. A layer's starts count from its own first point, so that a view of it is
// what a caller would have handed in; each layer has one start more than contours.
//
// Layers touch: each reaches from the top of the one below to its own. A layer is added whole or
// not at all, because room is made before anything is written, and the counts are set last.

#include "voxel/contour_stack.h"

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "voxel/contour.h"

#include <math.h>
#include <string.h>

#define FARTHEST_MM 1e12

sf_status sf_contour_stack_create(double bottom_mm, const sf_allocator *allocator,
                                  sf_contour_stack **stack)
{
    if (stack == NULL || !(fabs(bottom_mm) <= FARTHEST_MM)) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_contour_stack *made = sfi_alloc_array(&from, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = from;
    made->bottom_mm = bottom_mm;
    *stack = made;
    return SF_OK;
}

void sf_contour_stack_destroy(sf_contour_stack *stack)
{
    if (stack != NULL) {
        sf_allocator allocator = stack->allocator;
        sfi_free_array(&allocator, stack->points, stack->point_capacity, 2 * sizeof(double));
        sfi_free_array(&allocator, stack->starts, stack->start_capacity, sizeof *stack->starts);
        sfi_free_array(&allocator, stack->layers, stack->layer_capacity, sizeof *stack->layers);
        sfi_free_array(&allocator, stack, 1, sizeof *stack);
    }
}

double sfi_contour_stack_top(const sf_contour_stack *stack)
{
    return stack->layer_count > 0 ? stack->layers[stack->layer_count - 1].top_mm : stack->bottom_mm;
}

sf_status sfi_contour_stack_room(sf_contour_stack *stack, size_t points, size_t contours)
{
    const sf_allocator *allocator = &stack->allocator;
    size_t all_points, all_starts;
    if (stack->layer_count == SF_LAYER_MAX ||
        !sfi_size_add(stack->point_count, points, &all_points) ||
        !sfi_size_add(stack->start_count, contours, &all_starts) ||
        !sfi_size_add(all_starts, 1, &all_starts)) {
        return SF_ERR_OVERFLOW;
    }
    return sfi_grow_array(allocator, (void **)&stack->points, &stack->point_capacity, all_points,
                          2 * sizeof(double)) &&
                   sfi_grow_array(allocator, (void **)&stack->starts, &stack->start_capacity,
                                  all_starts, sizeof *stack->starts) &&
                   sfi_grow_array(allocator, (void **)&stack->layers, &stack->layer_capacity,
                                  (size_t)stack->layer_count + 1, sizeof *stack->layers)
               ? SF_OK
               : SF_ERR_MEMORY;
}

void sfi_contour_stack_close(sf_contour_stack *stack, double top_mm, size_t points, size_t contours)
{
    sfi_contour_layer layer = {stack->point_count, stack->start_count, contours, top_mm};
    stack->layers[stack->layer_count++] = layer;
    stack->point_count += points;
    stack->start_count += contours + 1;
}

static sf_status check_points(const sf_contours *contours, size_t points, sf_fault *fault)
{
    for (size_t i = 0; i < 2 * points; i++) {
        if (!(fabs(contours->points_mm[i]) <= FARTHEST_MM)) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "point %zu of the contours is not finite, or is beyond 1e12 mm",
                                 i / 2);
        }
    }
    return SF_OK;
}

sf_status sf_contour_stack_add(sf_contour_stack *stack, double top_mm, const sf_contours *contours,
                               sf_fault *fault)
{
    size_t points = 0;
    if (stack == NULL || sfi_contour_check(contours, &points) != SF_OK) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "no stack or no contours, or starts that fall");
    }
    if (!(top_mm > sfi_contour_stack_top(stack) && top_mm <= FARTHEST_MM)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "the top of layer %lu does not lie above the layer below; sort the "
                             "layers from the bottom up",
                             (unsigned long)stack->layer_count);
    }
    SF_TRY(check_points(contours, points, fault));
    SF_TRY(sfi_contour_stack_room(stack, points, contours->contour_count));
    if (points > 0) {
        memcpy(stack->points + 2 * stack->point_count, contours->points_mm,
               points * 2 * sizeof(double));
    }
    stack->starts[stack->start_count] = 0;
    for (size_t i = 1; i <= contours->contour_count; i++) {
        stack->starts[stack->start_count + i] = contours->starts[i];
    }
    sfi_contour_stack_close(stack, top_mm, points, contours->contour_count);
    return SF_OK;
}

uint32_t sf_contour_stack_count(const sf_contour_stack *stack)
{
    return stack != NULL ? stack->layer_count : 0;
}

sf_status sf_contour_stack_layer(const sf_contour_stack *stack, uint32_t k, sf_contours *contours,
                                 double *bottom_mm, double *top_mm)
{
    if (stack == NULL || k >= stack->layer_count) {
        return SF_ERR_ARGUMENT;
    }
    const sfi_contour_layer *layer = &stack->layers[k];
    if (contours != NULL) {
        const double *points = stack->points != NULL ? stack->points + 2 * layer->point : NULL;
        sf_contours view = {points, stack->starts + layer->start, layer->contour_count};
        *contours = view;
    }
    if (bottom_mm != NULL) {
        *bottom_mm = k > 0 ? layer[-1].top_mm : stack->bottom_mm;
    }
    if (top_mm != NULL) {
        *top_mm = layer->top_mm;
    }
    return SF_OK;
}

double sf_contours_area_mm2(const sf_contours *contours)
{
    size_t points = 0;
    double area = 0.0;
    if (contours == NULL) {
        return 0.0;
    }
    if (sfi_contour_check(contours, &points) != SF_OK) {
        return NAN;
    }
    for (size_t c = 0; c < contours->contour_count; c++) {
        size_t begin = contours->starts[c], end = contours->starts[c + 1];
        const double *from = contours->points_mm + 2 * begin;
        double twice = 0.0; // about the first point, so that far from the origin nothing is lost
        for (size_t i = begin + 1; i + 1 < end; i++) {
            const double *a = contours->points_mm + 2 * i, *b = a + 2;
            twice += (a[0] - from[0]) * (b[1] - from[1]) - (b[0] - from[0]) * (a[1] - from[1]);
        }
        area += twice / 2;
    }
    return area;
}

// ---------------------------------------------------------------------------------------------
// To a grid
// ---------------------------------------------------------------------------------------------

static sf_status count_voxels(double low, double high, double pitch, uint32_t *count)
{
    double voxels = floor((high - low) / pitch) + 1;
    if (!(voxels <= SF_EXTENT_MAX)) {
        return SF_ERR_OVERFLOW;
    }
    *count = (uint32_t)voxels;
    return SF_OK;
}

// Heights of whole nanometres, where that leaves any; returns whether all are the same.
static int write_heights(const sf_contour_stack *stack, double *heights_mm)
{
    double below = stack->bottom_mm;
    int is_even = 1;
    for (uint32_t k = 0; k < stack->layer_count; k++) {
        double exact = stack->layers[k].top_mm - below, whole = floor(exact * 1e6 + 0.5) / 1e6;
        heights_mm[k] = whole > 0 ? whole : exact;
        is_even = is_even && heights_mm[k] == heights_mm[0];
        below = stack->layers[k].top_mm;
    }
    return is_even;
}

sf_status sf_contour_stack_lattice(const sf_contour_stack *stack, double pitch_x_mm,
                                   double pitch_y_mm, double *heights_mm, size_t capacity,
                                   sf_lattice *lattice)
{
    if (stack == NULL || heights_mm == NULL || lattice == NULL || stack->layer_count == 0 ||
        stack->point_count == 0 || !(pitch_x_mm > 0) || !(pitch_y_mm > 0)) {
        return SF_ERR_ARGUMENT;
    }
    if (capacity < stack->layer_count) {
        return SF_ERR_CAPACITY;
    }
    double low[2] = {stack->points[0], stack->points[1]}, high[2] = {low[0], low[1]};
    for (size_t i = 0; i < 2 * stack->point_count; i++) {
        low[i % 2] = stack->points[i] < low[i % 2] ? stack->points[i] : low[i % 2];
        high[i % 2] = stack->points[i] > high[i % 2] ? stack->points[i] : high[i % 2];
    }
    sf_lattice made = {0,          0,   stack->layer_count, pitch_x_mm,
                       pitch_y_mm, 1.0, heights_mm,         {low[0], low[1], stack->bottom_mm}};
    SF_TRY(count_voxels(low[0], high[0], pitch_x_mm, &made.nx));
    SF_TRY(count_voxels(low[1], high[1], pitch_y_mm, &made.ny));
    if (write_heights(stack, heights_mm)) {
        made.layer_mm = heights_mm[0];
        made.heights_mm = NULL;
    }
    SF_TRY(sf_lattice_validate(&made));
    *lattice = made;
    return SF_OK;
}

static sf_status draw_layers(const sf_contour_stack *stack, sf_contour_fill fill,
                             const sf_allocator *allocator, sf_task *task, sf_grid *grid)
{
    sfi_progress progress = sfi_progress_begin(task);
    sf_lattice lattice = sf_grid_lattice(grid);
    for (uint32_t k = 0; k < lattice.nz; k++) {
        sf_contours contours;
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(sf_contour_stack_layer(stack, k, &contours, NULL, NULL));
        SF_TRY(sf_slice_from_contours(sf_grid_slice(grid, k), &lattice, &contours, fill, allocator,
                                      NULL));
        sfi_progress_report(&progress, k + 1, lattice.nz);
    }
    return SF_OK;
}

sf_status sf_grid_from_contours(const sf_contour_stack *stack, const sf_lattice *lattice,
                                sf_contour_fill fill, const sf_allocator *allocator, sf_task *task,
                                sf_grid **grid)
{
    sf_grid *made = NULL;
    if (stack == NULL || grid == NULL ||
        (fill != SF_CONTOUR_NONZERO && fill != SF_CONTOUR_EVEN_ODD)) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_lattice_validate(lattice));
    if (lattice->nz != stack->layer_count) {
        return SF_ERR_SHAPE;
    }
    SF_TRY(sf_grid_create(lattice, allocator, &made));
    sf_status status = draw_layers(stack, fill, allocator, task, made);
    if (status != SF_OK) {
        sf_grid_destroy(made);
        return status;
    }
    *grid = made;
    return SF_OK;
}
