// SPDX-License-Identifier: MIT
// Painting values of a property.
//
// All new values are worked out beside the old ones and put in place at the end, so that smoothing
// does not depend on an order, and what fails has changed nothing.

#include "grade/paint/weights.h"

#include "base/memory.h"
#include "base/status.h"
#include "grade/refine/glue.h"

#include <math.h>
#include <string.h>

// Scratch of one call: of each value its weight, its new value, and sum and number of neighbours.
typedef struct board {
    size_t count;
    double *weights, *fresh, *sums;
    uint32_t *neighbours;
} board;

static void free_board(const sf_allocator *allocator, board *b)
{
    sfi_free_array(allocator, b->weights, b->count, sizeof *b->weights);
    sfi_free_array(allocator, b->fresh, b->count, sizeof *b->fresh);
    sfi_free_array(allocator, b->sums, b->count, sizeof *b->sums);
    sfi_free_array(allocator, b->neighbours, b->count, sizeof *b->neighbours);
}

static sf_status alloc_board(const sf_allocator *allocator, size_t count, board *b)
{
    b->count = count;
    b->weights = sfi_alloc_array(allocator, count, sizeof *b->weights);
    b->fresh = sfi_alloc_array(allocator, count, sizeof *b->fresh);
    b->sums = sfi_alloc_array(allocator, count, sizeof *b->sums);
    b->neighbours = sfi_alloc_array(allocator, count, sizeof *b->neighbours);
    if (b->weights == NULL || b->fresh == NULL || b->sums == NULL || b->neighbours == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        b->weights[i] = b->sums[i] = 0;
        b->neighbours[i] = 0;
    }
    return SF_OK;
}

// A value has the greatest weight of the points where it is named.
static void weigh_values(const sf_cage *cage, const sf_channel *channel, const double *weights,
                         board *b)
{
    if (channel->indices == NULL) {
        memcpy(b->weights, weights, b->count * sizeof *weights);
        return;
    }
    for (uint32_t i = 0; i < cage->starts[cage->cells]; i++) {
        double *to = &b->weights[channel->indices[i]];
        double weight = weights[cage->corners[i]];
        *to = weight > *to ? weight : *to;
    }
}

static void add_neighbours(const sfi_complex *complex, const uint32_t *sources,
                           const double *values, board *b)
{
    for (size_t e = 0; e < complex->edges; e++) {
        const uint32_t *ends = complex->edge_points + 2 * e;
        uint32_t x = sources != NULL ? sources[ends[0]] : ends[0];
        uint32_t y = sources != NULL ? sources[ends[1]] : ends[1];
        b->sums[x] += values[y];
        b->sums[y] += values[x];
        b->neighbours[x]++;
        b->neighbours[y]++;
    }
}

// Neighbours along the edges of what is glued: on its own side of a jump.
static sf_status find_neighbours(const sf_cage *cage, const sf_channel *channel,
                                 const sf_allocator *allocator, board *b)
{
    if (channel->indices == NULL) {
        add_neighbours(&cage->complex, NULL, channel->values, b);
        return SF_OK;
    }
    sfi_glue glue;
    sfi_complex glued;
    SF_TRY(sfi_glue_make(&cage->complex, channel->indices, allocator, &glue));
    sf_status status = sfi_glue_complex(&cage->complex, &glue, allocator, &glued);
    if (status == SF_OK) {
        add_neighbours(&glued, glue.sources, channel->values, b);
        sfi_complex_free(&glued);
    }
    sfi_glue_free(allocator, &glue);
    return status;
}

static double change(const board *b, size_t i, double value, sf_paint_operation operation,
                     double amount)
{
    double weight = b->weights[i];
    switch (operation) {
    case SF_PAINT_SET:
        return weight == 1 ? amount : value + weight * (amount - value);
    case SF_PAINT_ADD:
        return value + weight * amount;
    default:
        return b->neighbours[i] == 0
                   ? value
                   : value + weight * amount * (b->sums[i] / b->neighbours[i] - value);
    }
}

static void put_in_place(sf_channel *channel, const board *b, size_t *changed)
{
    size_t count = 0;
    for (size_t i = 0; i < b->count; i++) {
        count += b->fresh[i] != channel->values[i];
    }
    memcpy((double *)channel->values, b->fresh, b->count * sizeof *b->fresh);
    if (changed != NULL) {
        *changed = count;
    }
}

static sf_status work_out(const sf_cage *cage, const sf_channel *channel, const double *weights,
                          sf_paint_operation operation, double amount,
                          const sf_allocator *allocator, board *b)
{
    const sf_property *p = &channel->property;
    SF_TRY(alloc_board(allocator, channel->value_count, b));
    weigh_values(cage, channel, weights, b);
    if (operation == SF_PAINT_SMOOTH) {
        SF_TRY(find_neighbours(cage, channel, allocator, b));
    }
    for (size_t i = 0; i < b->count; i++) {
        double value = channel->values[i];
        double fresh = b->weights[i] > 0 ? change(b, i, value, operation, amount) : value;
        b->fresh[i] = fresh < p->low ? p->low : fresh > p->high ? p->high : fresh;
        if (!isfinite(b->fresh[i])) {
            return SF_ERR_ARGUMENT;
        }
    }
    return SF_OK;
}

sf_status sf_paint_values(sf_cage *cage, size_t channel, const double *weights,
                          sf_paint_operation operation, double amount,
                          const sf_allocator *allocator, size_t *changed)
{
    if (cage == NULL || weights == NULL || channel >= cage->channels.count || !isfinite(amount) ||
        !sfi_weights_are_good(weights, cage->points) ||
        (operation != SF_PAINT_SET && operation != SF_PAINT_ADD && operation != SF_PAINT_SMOOTH) ||
        (operation == SF_PAINT_SMOOTH && !(amount >= 0 && amount <= 1))) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_channel *painted = &cage->channels.at[channel];
    board b;
    memset(&b, 0, sizeof b);
    sf_status status = work_out(cage, painted, weights, operation, amount, &kept, &b);
    if (status == SF_OK) {
        put_in_place(painted, &b, changed);
    }
    free_board(&kept, &b);
    return status;
}
