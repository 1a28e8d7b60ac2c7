// SPDX-License-Identifier: MIT
// Limits of corners.
//
// Cut over and over at the same corner, a ring soon turns into a kind whose piece at that corner is
// of the same kind: subdivision is then one matrix, whose powers tend to a matrix of equal rows.
// The row is its left eigenvector of eigenvalue 1, and holds the weights of the limit. At a regular
// kind they are those of the cubic spline, 1 4 1 over 6 along each axis; at others the powers are
// taken, which converge as 1/4 to the n. Kinds before the last are one multiplication more each.

#include "grade/limit/corner.h"

#include "base/memory.h"
#include "base/status.h"
#include "grade/limit/spline.h"

#include <math.h>
#include <string.h>

enum { MOST_POWERS = 4000, MOST_CHAIN = 256 };

// weights of a ring times the matrix that made that ring's values.
static void multiply(const sfi_matrix *m, const double *weights, double *product)
{
    for (uint32_t i = 0; i < m->columns; i++) {
        product[i] = 0;
    }
    for (uint32_t row = 0; row < m->rows; row++) {
        const double *pool = m->pool + m->weights[row];
        for (uint32_t i = m->starts[row]; i < m->starts[row + 1]; i++) {
            product[m->items[i]] += weights[row] * pool[i - m->starts[row]];
        }
    }
}

// What layers that are missing add to those that are there: 2 to the next, -1 to the one behind.
static void fold(const sfi_net *net, uint32_t dimension, double *grid)
{
    for (uint32_t side = 0; side < 2 * dimension; side++) {
        uint32_t axis = side / 2, step = 1u << 2 * axis;
        for (uint32_t i = 0; (net->outside >> side & 1) && i < (dimension == 3 ? 64u : 16u); i++) {
            if ((i >> 2 * axis & 3) == (side % 2 ? 3u : 0u)) {
                uint32_t near = side % 2 ? i - step : i + step;
                uint32_t far = side % 2 ? near - step : near + step;
                grid[near] += 2 * grid[i];
                grid[far] -= grid[i];
                grid[i] = 0;
            }
        }
    }
}

static void regular_corner(const sfi_kind *kind, uint32_t place, double *weights)
{
    static const double ends[2][4] = {{1.0 / 6, 4.0 / 6, 1.0 / 6, 0},
                                      {0, 1.0 / 6, 4.0 / 6, 1.0 / 6}};
    uint32_t dimension = kind->ring.dimension, count = dimension == 3 ? 64 : 16;
    double grid[64];
    for (uint32_t i = 0; i < count; i++) {
        grid[i] = 1;
        for (uint32_t axis = 0; axis < dimension; axis++) {
            grid[i] *= ends[place >> axis & 1][i >> 2 * axis & 3];
        }
    }
    fold(&kind->net, dimension, grid);
    memset(weights, 0, kind->ring.points * sizeof *weights);
    for (uint32_t i = 0; i < count; i++) {
        if (kind->net.at[i] != SFI_NONE) {
            weights[kind->net.at[i]] += grid[i];
        }
    }
}

// Powers of the matrix of a kind whose piece is of its own kind. Needs as much again for scratch.
static void power_corner(const sfi_kind *kind, uint32_t place, double *weights, double *scratch)
{
    uint32_t points = kind->ring.points;
    memset(weights, 0, points * sizeof *weights);
    weights[place] = 1;
    double change = 1;
    for (int i = 0; change > 1e-17 && i < MOST_POWERS; i++) {
        multiply(&kind->steps[place], weights, scratch);
        change = 0;
        for (uint32_t j = 0; j < points; j++) {
            double moved = fabs(scratch[j] - weights[j]);
            change = moved > change ? moved : change;
            weights[j] = scratch[j];
        }
    }
}

static sf_status find_corner(const sfi_atlas *atlas, uint32_t first, uint32_t place, double *a,
                             double *b)
{
    uint32_t chain[MOST_CHAIN], length = 0, at = first;
    while (!atlas->kinds[at].is_regular && atlas->kinds[at].children[place] != at) {
        if (length == MOST_CHAIN) {
            return SF_ERR_INTERNAL;
        }
        chain[length++] = at;
        at = atlas->kinds[at].children[place];
    }
    const sfi_kind *last = &atlas->kinds[at];
    if (last->is_regular) {
        regular_corner(last, place, a);
    } else {
        power_corner(last, place, a, b);
    }
    while (length > 0) {
        const sfi_matrix *m = &atlas->kinds[chain[--length]].steps[place];
        multiply(m, a, b);
        memcpy(a, b, m->columns * sizeof *a);
    }
    return SF_OK;
}

sf_status sfi_corners_find_all(sfi_atlas *atlas)
{
    const sf_allocator *allocator = &atlas->allocator;
    uint32_t corners = 1u << atlas->dimension;
    double *scratch = sfi_alloc_array(allocator, 2 * (size_t)atlas->most_points, sizeof *scratch);
    sf_status status = scratch == NULL ? SF_ERR_MEMORY : SF_OK;
    for (uint32_t i = 0; status == SF_OK && i < atlas->count; i++) {
        sfi_kind *kind = &atlas->kinds[i];
        size_t points = kind->ring.points;
        kind->corners = sfi_alloc_array(allocator, corners * points, sizeof *kind->corners);
        status = kind->corners == NULL ? SF_ERR_MEMORY : SF_OK;
        for (uint32_t place = 0; status == SF_OK && place < corners; place++) {
            status = find_corner(atlas, i, place, scratch, scratch + atlas->most_points);
            memcpy(kind->corners + points * place, scratch, points * sizeof *scratch);
        }
    }
    sfi_free_array(allocator, scratch, 2 * (size_t)atlas->most_points, sizeof *scratch);
    return status;
}
