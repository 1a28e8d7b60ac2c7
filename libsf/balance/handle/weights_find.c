// SPDX-License-Identifier: MIT
// The cell closest to a point.
//
// Nearly all points lie in a cell, and its indices tell which. For others the boxes around are
// searched in rings of growing distance, counted in cells, until no box further out can be closer
// than what was found: the half-spaces beyond the six sides of what was searched tell that. Far
// away that would take long; there a table answers, which knows a close cell for each place of the
// box. It is filled from the cells outwards, one step at a time, each place taking over the best of
// what its six neighbours know by then.

#include "balance/handle/weights_domain.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// How many boxes away the closest cell is found exactly.
enum { NEAR = 2 };
// In the queue, but not yet settled.
#define WAITS (SFI_NO_CELL - 1)

// The interval of an axis that holds a coordinate, the upper one of two; the first or last one
// outside.
static uint32_t locate(const sfi_domain *d, int axis, double x)
{
    const double *plane = d->planes[axis];
    uint32_t last = d->cells[axis] - 1;
    double guess = (x - plane[0]) / (plane[last + 1] - plane[0]) * (last + 1);
    uint32_t i = !(guess > 0) ? 0 : guess > last ? last : (uint32_t)guess;
    while (i > 0 && x < plane[i]) {
        i--;
    }
    while (i < last && x >= plane[i + 1]) {
        i++;
    }
    return i;
}

static double clamp(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

sfi_spot sfi_domain_spot(const sfi_domain *d, const double p[3], uint32_t cell)
{
    sfi_spot s = {cell, {0, 0, 0}, 0, {0, 0, 0}};
    for (int axis = 0; axis < 3; axis++) {
        const double *plane = d->planes[axis] + d->place[3 * (size_t)cell + (size_t)axis];
        s.at[axis] = clamp(p[axis], plane[0], plane[1]);
        s.moved[axis] = s.at[axis] != p[axis];
        s.square += (s.at[axis] - p[axis]) * (s.at[axis] - p[axis]);
    }
    return s;
}

// Take a cell if it is not further than what was found.
static void consider(const sfi_domain *d, const double p[3], uint32_t cell, sfi_spot *best)
{
    sfi_spot s = sfi_domain_spot(d, p, cell);
    // With nothing found and no limit any cell will do, though its square may be infinite.
    int ties = best->cell != SFI_NO_CELL ? cell > best->cell : best->square == INFINITY;
    if (s.square < best->square || (s.square == best->square && ties)) {
        *best = s;
    }
}

// Along one row of boxes of a ring: all of them, or only its two ends.
static void consider_row(const sfi_domain *d, const double p[3], const int64_t low[3],
                         const int64_t high[3], int64_t j, int64_t k, int ends, const uint8_t *skip,
                         sfi_spot *best)
{
    int64_t step = ends && high[0] > low[0] ? high[0] - low[0] : 1;
    if (j < 0 || j >= d->cells[1] || k < 0 || k >= d->cells[2]) {
        return;
    }
    for (int64_t i = low[0]; i <= high[0]; i += step) {
        if (i >= 0 && i < d->cells[0]) {
            uint32_t cell =
                d->cell_at[sfi_domain_box_index(d, (uint32_t)i, (uint32_t)j, (uint32_t)k)];
            if (cell != SFI_NO_CELL && (skip == NULL || !skip[cell])) {
                consider(d, p, cell, best);
            }
        }
    }
}

static void consider_ring(const sfi_domain *d, const double p[3], const int64_t low[3],
                          const int64_t high[3], const uint8_t *skip, sfi_spot *best)
{
    for (int64_t k = low[2]; k <= high[2]; k++) {
        int whole = k == low[2] || k == high[2];
        for (int64_t j = low[1]; j <= high[1]; j++) {
            int ends = !whole && j != low[1] && j != high[1];
            consider_row(d, p, low, high, j, k, ends, skip, best);
        }
    }
}

// Square of the distance below which nothing lies beyond a ring; infinite where it holds the box.
static double beyond(const sfi_domain *d, const double p[3], const int64_t low[3],
                     const int64_t high[3])
{
    double least = INFINITY;
    for (int axis = 0; axis < 3; axis++) {
        const double *plane = d->planes[axis];
        if (low[axis] > 0) {
            double gap = p[axis] - plane[low[axis]];
            least = gap < least ? gap : least;
        }
        if (high[axis] + 1 < d->cells[axis]) {
            double gap = plane[high[axis] + 1] - p[axis];
            least = gap < least ? gap : least;
        }
    }
    return least > 0 ? least * least : 0;
}

static sfi_spot search(const sfi_domain *d, const double p[3], const uint8_t *skip, sfi_spot best,
                       const uint32_t at[3])
{
    int64_t low[3], high[3];
    for (int axis = 0; axis < 3; axis++) {
        low[axis] = high[axis] = at[axis];
    }
    for (;;) {
        consider_ring(d, p, low, high, skip, &best);
        double further = beyond(d, p, low, high);
        if (best.square == 0 || further > best.square || further == INFINITY) {
            return best;
        }
        for (int axis = 0; axis < 3; axis++) {
            low[axis]--;
            high[axis]++;
        }
    }
}

sfi_spot sfi_domain_search(const sfi_domain *d, const double p[3], const uint8_t *skip,
                           double limit)
{
    sfi_spot none = {SFI_NO_CELL, {p[0], p[1], p[2]}, limit, {0, 0, 0}};
    uint32_t at[3];
    for (int axis = 0; axis < 3; axis++) {
        at[axis] = locate(d, axis, p[axis]);
    }
    return search(d, p, skip, none, at);
}

// ---------------------------------------------------------------------------------------------
// The table
// ---------------------------------------------------------------------------------------------

static double square_to(const sfi_domain *d, const uint32_t at[3], uint32_t cell)
{
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double *to = d->planes[axis] + d->place[3 * (size_t)cell + (size_t)axis];
        const double *from = d->planes[axis] + at[axis];
        double by = 0.5 * ((from[0] + from[1]) - (to[0] + to[1]));
        sum += by * by;
    }
    return sum;
}

// Visit the six neighbours of a place: take over the best that they know, or, without `best`, put
// those that know nothing into the queue. Returns the queue's new length.
static size_t visit(const sfi_domain *d, size_t place, uint32_t *best, uint32_t *queue,
                    size_t length)
{
    size_t row = d->cells[0], slab = row * d->cells[1], stride[3] = {1, row, slab};
    const uint32_t at[3] = {(uint32_t)(place % row), (uint32_t)(place / row % d->cells[1]),
                            (uint32_t)(place / slab)};
    for (int axis = 0; axis < 3; axis++) {
        for (int up = 0; up < 2; up++) {
            if (up ? at[axis] + 1 == d->cells[axis] : at[axis] == 0) {
                continue;
            }
            size_t other = up ? place + stride[axis] : place - stride[axis];
            uint32_t known = d->closest[other];
            if (best == NULL && known == SFI_NO_CELL) {
                d->closest[other] = WAITS;
                queue[length++] = (uint32_t)other;
            } else if (best != NULL && known < WAITS &&
                       (*best >= WAITS || square_to(d, at, known) < square_to(d, at, *best))) {
                *best = known;
            }
        }
    }
    return length;
}

sf_status sfi_domain_reach(sfi_domain *d)
{
    size_t length = 0;
    if (d->box_count >= WAITS) {
        return SF_ERR_OVERFLOW;
    }
    uint32_t *queue = sfi_alloc_array(&d->allocator, d->box_count, sizeof *queue);
    d->closest = sfi_alloc_array(&d->allocator, d->box_count, sizeof *d->closest);
    if (queue == NULL || d->closest == NULL) {
        sfi_free_array(&d->allocator, queue, d->box_count, sizeof *queue);
        return SF_ERR_MEMORY;
    }
    memcpy(d->closest, d->cell_at, d->box_count * sizeof *d->closest);
    for (size_t cell = 0; cell < d->cell_count; cell++) {
        const uint32_t *p = d->place + 3 * cell;
        length = visit(d, sfi_domain_box_index(d, p[0], p[1], p[2]), NULL, queue, length);
    }
    for (size_t i = 0; i < length; i++) {
        uint32_t best = WAITS;
        visit(d, queue[i], &best, NULL, 0);
        d->closest[queue[i]] = best;
        length = visit(d, queue[i], NULL, queue, length);
    }
    sfi_free_array(&d->allocator, queue, d->box_count, sizeof *queue);
    return SF_OK;
}

sfi_spot sfi_domain_find(const sfi_domain *d, const double p[3])
{
    sfi_spot best = {SFI_NO_CELL, {0, 0, 0}, INFINITY, {0, 0, 0}};
    uint32_t at[3], far = 0;
    for (int axis = 0; axis < 3; axis++) {
        at[axis] = locate(d, axis, p[axis]);
    }
    uint32_t cell = d->closest[sfi_domain_box_index(d, at[0], at[1], at[2])];
    consider(d, p, cell, &best);
    for (int axis = 0; axis < 3 && best.square > 0; axis++) {
        uint32_t to = d->place[3 * (size_t)cell + (size_t)axis];
        uint32_t steps = at[axis] > to ? at[axis] - to : to - at[axis];
        far = steps > far ? steps : far;
    }
    int is_cell =
        best.square == 0 && d->cell_at[sfi_domain_box_index(d, at[0], at[1], at[2])] == cell;
    return is_cell || far > NEAR ? best : search(d, p, NULL, best, at);
}
