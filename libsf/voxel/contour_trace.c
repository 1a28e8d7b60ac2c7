// SPDX-License-Identifier: MIT
// Voxels to contours: walk along the sides of solid voxels with matter on the left.
//
// Every closed walk along sides has one that goes right along the underside of a solid voxel with
// nothing below it; such undersides are marked as they are walked, and each that is left unmarked
// begins a new walk. At a corner the two voxels ahead decide: with the left one empty the walk
// turns left, with the right one solid it turns right, else it goes straight on. Left is asked
// first, so voxels that meet in a corner only belong to walks that pass each other there: pieces
// are those that hang together through sides. Points are kept where the walk turns.
//
// A layer is traced twice: once to count its points, so that room is made before anything is
// written, and once to write them.

#include "base/bits.h"
#include "base/memory.h"
#include "base/status.h"
#include "voxel/contour_stack.h"
#include "voxel/slice.h"

#include <string.h>

typedef struct tracing {
    sf_slice slice;
    const sf_lattice *lattice;
    uint64_t *walked; // of each voxel, whether its underside was; rows as in a slice without gaps
    size_t row_words, word_count;
    double *points; // where they go, or NULL while they are counted
    size_t *starts; // of each contour, or NULL
    size_t point_count, contour_count;
} tracing;

// Directions: right, up, left, down.
static const int step_x[4] = {1, 0, -1, 0}, step_y[4] = {0, 1, 0, -1};
// The voxel left of the way ahead of a corner, seen from the voxel above and right of the corner.
static const int left_x[4] = {0, -1, -1, 0}, left_y[4] = {0, 0, -1, -1};

static int is_solid(const tracing *t, int64_t x, int64_t y)
{
    return x >= 0 && y >= 0 && x < t->slice.width && y < t->slice.height &&
           sf_slice_get(t->slice, (uint32_t)x, (uint32_t)y);
}

static void add_point(tracing *t, int64_t x, int64_t y)
{
    if (t->points != NULL) {
        double *at = t->points + 2 * t->point_count;
        at[0] = t->lattice->origin_mm[0] + (double)x * t->lattice->pitch_x_mm;
        at[1] = t->lattice->origin_mm[1] + (double)y * t->lattice->pitch_y_mm;
    }
    t->point_count++;
}

// Walk from the lower left corner of a voxel, to the right, until there again.
static void walk(tracing *t, uint32_t x0, uint32_t y0)
{
    int64_t x = x0, y = y0;
    int way = 0;
    do {
        if (way == 0) {
            t->walked[(size_t)y * t->row_words + (size_t)x / 64] |= UINT64_C(1) << (x % 64);
        }
        x += step_x[way];
        y += step_y[way];
        int right = (way + 3) % 4;
        int turn = !is_solid(t, x + left_x[way], y + left_y[way])      ? 1
                   : is_solid(t, x + left_x[right], y + left_y[right]) ? 3
                                                                       : 0;
        if (turn != 0) {
            add_point(t, x, y);
            way = (way + turn) % 4;
        }
    } while (x != x0 || y != y0 || way != 0);
}

static void trace(tracing *t)
{
    t->point_count = t->contour_count = 0;
    memset(t->walked, 0, t->word_count * sizeof *t->walked);
    for (uint32_t y = 0; y < t->slice.height; y++) {
        const uint64_t *row = sfi_slice_row(t->slice, y);
        const uint64_t *below = y > 0 ? sfi_slice_row(t->slice, y - 1) : NULL;
        for (size_t i = 0; i < t->row_words; i++) {
            uint64_t under = sfi_row_word(row, i, t->slice.width) &
                             ~(below != NULL ? sfi_row_word(below, i, t->slice.width) : 0);
            uint64_t *walked = &t->walked[(size_t)y * t->row_words + i];
            for (uint64_t left; (left = under & ~*walked) != 0;) {
                if (t->starts != NULL) {
                    t->starts[t->contour_count] = t->point_count;
                }
                t->contour_count++;
                walk(t, (uint32_t)(64 * i) + sfi_lowest_bit(left), y);
            }
        }
    }
    if (t->starts != NULL) {
        t->starts[t->contour_count] = t->point_count;
    }
}

static sf_status add_layer(sf_contour_stack *stack, double top_mm, tracing *t)
{
    trace(t);
    SF_TRY(sfi_contour_stack_room(stack, t->point_count, t->contour_count));
    if (t->contour_count > 0) {
        t->points = stack->points + 2 * stack->point_count;
        t->starts = stack->starts + stack->start_count;
        trace(t);
    } else {
        stack->starts[stack->start_count] = 0;
    }
    sfi_contour_stack_close(stack, top_mm, t->point_count, t->contour_count);
    return SF_OK;
}

sf_status sf_contour_stack_trace(sf_contour_stack *stack, double top_mm, sf_slice slice,
                                 const sf_lattice *lattice)
{
    if (stack == NULL || !(top_mm > sfi_contour_stack_top(stack) && top_mm <= 1e12)) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_slice_validate(slice));
    SF_TRY(sf_lattice_validate(lattice));
    if (slice.width != lattice->nx || slice.height != lattice->ny) {
        return SF_ERR_SHAPE;
    }
    tracing t = {.slice = slice, .lattice = lattice, .row_words = sfi_row_words(slice.width)};
    if (!sfi_size_mul(t.row_words, slice.height, &t.word_count)) {
        return SF_ERR_OVERFLOW;
    }
    t.walked = sfi_alloc_array(&stack->allocator, t.word_count, sizeof *t.walked);
    if (t.walked == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = add_layer(stack, top_mm, &t);
    sfi_free_array(&stack->allocator, t.walked, t.word_count, sizeof *t.walked);
    return status;
}
