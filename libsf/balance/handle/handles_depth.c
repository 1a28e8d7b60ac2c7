// SPDX-License-Identifier: MIT
// How deep cells lie in the solid, and how far they are from each other through it.
//
// Depth is exact: the square of the distance from the middle of a cell to the closest box outside
// is a sum over the axes, and so its least value is found one axis after the other, as in
//
//     least over k' of gap_z(k, k')^2 + least over j' of gap_y(j, j')^2 + least over i' of ...
//
// where the gap of an interval from a middle is 0 for its own and else the distance of its nearer
// face. Each line looks outwards only as far as gaps alone are no larger than what was found, which
// is the depth itself.
//
// Distances through the solid are those of paths over the middles of neighbours, by E. W. Dijkstra,
// "A Note on Two Problems in Connexion with Graphs", 1959. Of equal distances the lower cell leaves
// the heap first; the result does not depend on it.

#include "balance/handle/handles_depth.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <math.h>

// ---------------------------------------------------------------------------------------------
// Depth
// ---------------------------------------------------------------------------------------------

static double square(double x)
{
    return x * x;
}

// Square of the gap between the middle of interval i and interval k, either of which may lie one
// beyond the ends.
static double gap(const double *plane, int64_t i, int64_t k)
{
    double middle = 0.5 * (plane[i] + plane[i + 1]);
    return i == k ? 0 : k > i ? square(plane[k] - middle) : square(middle - plane[k + 1]);
}

// One line of one axis: least[i] = least over k of gap(i, k) + old[k], where beyond the ends old is
// 0. `old` is a copy of the line.
static void relax_line(const double *plane, int64_t count, const double *old, double *line,
                       size_t stride)
{
    for (int64_t i = 0; i < count; i++) {
        double best = old[i];
        for (int64_t k = i + 1; k <= count && gap(plane, i, k) < best; k++) {
            double found = gap(plane, i, k) + (k < count ? old[k] : 0);
            best = found < best ? found : best;
        }
        for (int64_t k = i - 1; k >= -1 && gap(plane, i, k) < best; k--) {
            double found = gap(plane, i, k) + (k >= 0 ? old[k] : 0);
            best = found < best ? found : best;
        }
        line[(size_t)i * stride] = best;
    }
}

// All lines of an axis.
static void relax_axis(const sfi_domain *d, int axis, double *field, double *old)
{
    size_t stride = axis == 0 ? 1 : axis == 1 ? d->cells[0] : (size_t)d->cells[0] * d->cells[1];
    size_t count = d->cells[axis], lines = d->box_count / count;
    for (size_t l = 0; l < lines; l++) {
        double *line = field + l / stride * stride * count + l % stride;
        for (size_t i = 0; i < count; i++) {
            old[i] = line[i * stride];
        }
        relax_line(d->planes[axis], (int64_t)count, old, line, stride);
    }
}

sf_status sfi_domain_depth(const sfi_domain *d, const sf_allocator *allocator, double *depth)
{
    size_t longest = d->cells[0] > d->cells[1] ? d->cells[0] : d->cells[1];
    longest = longest > d->cells[2] ? longest : d->cells[2];
    double *field = sfi_alloc_array(allocator, d->box_count, sizeof *field);
    double *old = sfi_alloc_array(allocator, longest, sizeof *old);
    if (field != NULL && old != NULL) {
        for (size_t i = 0; i < d->box_count; i++) {
            field[i] = d->cell_at[i] == SFI_NO_CELL ? 0 : INFINITY;
        }
        for (int axis = 0; axis < 3; axis++) {
            relax_axis(d, axis, field, old);
        }
        for (size_t i = 0; i < d->box_count; i++) {
            if (d->cell_at[i] != SFI_NO_CELL) {
                depth[d->cell_at[i]] = sqrt(field[i]);
            }
        }
    }
    int done = field != NULL && old != NULL;
    sfi_free_array(allocator, field, d->box_count, sizeof *field);
    sfi_free_array(allocator, old, longest, sizeof *old);
    return done ? SF_OK : SF_ERR_MEMORY;
}

// ---------------------------------------------------------------------------------------------
// Distance
// ---------------------------------------------------------------------------------------------

static int is_before(const double *distance, uint32_t a, uint32_t b)
{
    return distance[a] < distance[b] || (distance[a] == distance[b] && a < b);
}

static void put(sfi_spread *s, size_t at, uint32_t cell)
{
    s->heap[at] = cell;
    s->where[cell] = (uint32_t)at;
}

static void rise(sfi_spread *s, const double *distance, size_t at)
{
    uint32_t cell = s->heap[at];
    for (; at > 0 && is_before(distance, cell, s->heap[(at - 1) / 2]); at = (at - 1) / 2) {
        put(s, at, s->heap[(at - 1) / 2]);
    }
    put(s, at, cell);
}

static void sink(sfi_spread *s, const double *distance)
{
    uint32_t cell = s->heap[0];
    size_t at = 0;
    for (;;) {
        size_t next = 2 * at + 1;
        if (next >= s->count) {
            break;
        }
        if (next + 1 < s->count && is_before(distance, s->heap[next + 1], s->heap[next])) {
            next++;
        }
        if (!is_before(distance, s->heap[next], cell)) {
            break;
        }
        put(s, at, s->heap[next]);
        at = next;
    }
    put(s, at, cell);
}

// A cell has become closer: into the heap, or up in it.
static void offer(sfi_spread *s, const double *distance, uint32_t cell)
{
    if (s->where[cell] == UINT32_MAX) {
        put(s, s->count++, cell);
    }
    rise(s, distance, s->where[cell]);
}

static uint32_t take(sfi_spread *s, const double *distance)
{
    uint32_t cell = s->heap[0];
    s->where[cell] = UINT32_MAX;
    s->count--;
    if (s->count > 0) {
        put(s, 0, s->heap[s->count]);
        sink(s, distance);
    }
    return cell;
}

static void step_to(const sfi_domain *d, uint32_t from, uint32_t to, sfi_spread *s,
                    double *distance)
{
    double a[3], b[3];
    sfi_domain_middle(d, from, a);
    sfi_domain_middle(d, to, b);
    double step = sqrt((square(a[0] - b[0]) + square(a[1] - b[1])) + square(a[2] - b[2]));
    if (distance[from] + step < distance[to]) {
        distance[to] = distance[from] + step;
        offer(s, distance, to);
    }
}

static void step_around(const sfi_domain *d, uint32_t cell, sfi_spread *s, double *distance)
{
    const uint32_t *p = d->place + 3 * (size_t)cell;
    for (int n = 0; n < 27; n++) {
        int64_t i = (int64_t)p[0] + n % 3 - 1, j = (int64_t)p[1] + n / 3 % 3 - 1,
                k = (int64_t)p[2] + n / 9 - 1;
        if (i >= 0 && j >= 0 && k >= 0 && i < d->cells[0] && j < d->cells[1] && k < d->cells[2]) {
            uint32_t to =
                d->cell_at[sfi_domain_box_index(d, (uint32_t)i, (uint32_t)j, (uint32_t)k)];
            if (to != SFI_NO_CELL && to != cell) {
                step_to(d, cell, to, s, distance);
            }
        }
    }
}

void sfi_domain_spread(const sfi_domain *domain, const uint32_t *from, size_t from_count,
                       sfi_spread *spread, double *distance)
{
    spread->count = 0;
    for (size_t i = 0; i < domain->cell_count; i++) {
        spread->where[i] = UINT32_MAX;
    }
    for (size_t i = 0; i < from_count; i++) {
        distance[from[i]] = 0;
        offer(spread, distance, from[i]);
    }
    while (spread->count > 0) {
        step_around(domain, take(spread, distance), spread, distance);
    }
}
