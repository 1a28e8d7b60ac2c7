// SPDX-License-Identifier: MIT
// Cells by where they are bent to: to find a rest point for which nothing is known.
//
// A cell is put into the bin of the middle of its bent corners' bounds. Bins are as wide as half
// the largest of these bounds, or wider where there would be too many; so the cells whose bounds
// hold a point are in the bins around it. Bounds of corners do not hold all of what a cell is bent
// to, but nearly all: the rest is left to the closest cell.

#include "balance/blend/blend_bins.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <math.h>
#include <string.h>

#define BINS ((size_t)SFI_BINS_MAX * SFI_BINS_MAX * SFI_BINS_MAX)

sf_status sfi_bins_create(const sf_weights *weights, const sf_allocator *allocator, sfi_bins *bins)
{
    const sfi_domain *d = &weights->domain;
    size_t numbers;
    memset(bins, 0, sizeof *bins);
    bins->weights = weights;
    if (!sfi_size_mul(d->node_count, 3, &numbers)) {
        return SF_ERR_OVERFLOW;
    }
    bins->bent = sfi_alloc_array(allocator, numbers, sizeof *bins->bent);
    bins->entries = sfi_alloc_array(allocator, d->cell_count, sizeof *bins->entries);
    bins->begin = sfi_alloc_array(allocator, BINS + 1, sizeof *bins->begin);
    if (bins->bent == NULL || bins->entries == NULL || bins->begin == NULL) {
        sfi_bins_destroy(bins, allocator);
        return SF_ERR_MEMORY;
    }
    return SF_OK;
}

void sfi_bins_destroy(sfi_bins *bins, const sf_allocator *allocator)
{
    const sfi_domain *d = &bins->weights->domain;
    sfi_free_array(allocator, bins->bent, 3 * d->node_count, sizeof *bins->bent);
    sfi_free_array(allocator, bins->entries, d->cell_count, sizeof *bins->entries);
    sfi_free_array(allocator, bins->begin, BINS + 1, sizeof *bins->begin);
}

static void bend_nodes(sfi_bins *b, const sfi_map *maps)
{
    const sf_weights *w = b->weights;
    for (size_t i = 0; i < w->domain.node_count; i++) {
        double at[3];
        sfi_map mix;
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = w->domain.planes[axis][w->domain.node_place[3 * i + (size_t)axis]];
        }
        sfi_maps_mix(maps, w->values + w->count * i, w->count, &mix);
        sfi_map_turn(mix.matrix, at, b->bent + 3 * i);
        for (size_t n = 0; n < 3; n++) {
            b->bent[3 * i + n] += mix.shift[n];
        }
    }
}

static void cell_bounds(const sfi_bins *b, size_t cell, double low[3], double high[3])
{
    const uint32_t *corners = b->weights->domain.corners + 8 * cell;
    for (size_t n = 0; n < 3; n++) {
        low[n] = high[n] = b->bent[3 * (size_t)corners[0] + n];
        for (size_t c = 1; c < 8; c++) {
            double x = b->bent[3 * (size_t)corners[c] + n];
            low[n] = x < low[n] ? x : low[n];
            high[n] = x > high[n] ? x : high[n];
        }
    }
}

static uint32_t bin_along(const sfi_bins *b, int axis, double x)
{
    double i = floor((x - b->low[axis]) / b->edge);
    return !(i > 0) ? 0 : i >= b->count[axis] ? b->count[axis] - 1 : (uint32_t)i;
}

static size_t bin_of(const sfi_bins *b, const sfi_bin_entry *entry)
{
    uint32_t at[3];
    for (int n = 0; n < 3; n++) {
        at[n] = bin_along(b, n, 0.5 * (entry->low[n] + entry->high[n]));
    }
    return ((size_t)at[2] * b->count[1] + at[1]) * b->count[0] + at[0];
}

static void choose_bins(sfi_bins *b)
{
    double top[3] = {-INFINITY, -INFINITY, -INFINITY}, widest = 0, longest = 0;
    for (int n = 0; n < 3; n++) {
        b->low[n] = INFINITY;
    }
    for (size_t cell = 0; cell < b->weights->domain.cell_count; cell++) {
        double low[3], high[3];
        cell_bounds(b, cell, low, high);
        for (int n = 0; n < 3; n++) {
            b->low[n] = low[n] < b->low[n] ? low[n] : b->low[n];
            top[n] = high[n] > top[n] ? high[n] : top[n];
            widest = high[n] - low[n] > widest ? high[n] - low[n] : widest;
        }
    }
    for (int n = 0; n < 3; n++) {
        longest = top[n] - b->low[n] > longest ? top[n] - b->low[n] : longest;
    }
    b->edge = 0.5 * widest > longest / SFI_BINS_MAX ? 0.5 * widest : longest / SFI_BINS_MAX;
    b->edge = b->edge > 0 ? b->edge : 1;
    for (int n = 0; n < 3; n++) {
        double bins = floor((top[n] - b->low[n]) / b->edge) + 1;
        b->count[n] = bins < SFI_BINS_MAX ? (uint32_t)bins : SFI_BINS_MAX;
    }
}

void sfi_bins_fill(sfi_bins *b, const sfi_map *maps)
{
    size_t cells = b->weights->domain.cell_count;
    bend_nodes(b, maps);
    choose_bins(b);
    size_t bins = (size_t)b->count[0] * b->count[1] * b->count[2];
    memset(b->begin, 0, (bins + 1) * sizeof *b->begin);
    for (size_t cell = 0; cell < cells; cell++) {
        sfi_bin_entry entry = {{0}, {0}, (uint32_t)cell};
        cell_bounds(b, cell, entry.low, entry.high);
        b->begin[bin_of(b, &entry) + 1]++;
    }
    for (size_t i = 0; i < bins; i++) {
        b->begin[i + 1] += b->begin[i];
    }
    // Each bin from its end, the last cell first; then its begin stands where it should.
    for (size_t cell = cells; cell-- > 0;) {
        sfi_bin_entry entry = {{0}, {0}, (uint32_t)cell};
        cell_bounds(b, cell, entry.low, entry.high);
        b->entries[--b->begin[bin_of(b, &entry) + 1]] = entry;
    }
    memmove(b->begin, b->begin + 1, bins * sizeof *b->begin);
    b->begin[bins] = (uint32_t)cells;
}

// What is known of the search for the closest cell.
typedef struct nearest {
    uint32_t cell;
    double square;
} nearest;

// Visit a bin's cells whose bounds hold the point. Returns 0 where the visitor has had enough.
static int visit_bin(const sfi_bins *b, size_t bin, const double p[3], nearest *best,
                     int (*visit)(void *user, uint32_t cell), void *user)
{
    for (uint32_t i = b->begin[bin]; i < b->begin[bin + 1]; i++) {
        const sfi_bin_entry *e = &b->entries[i];
        double square = 0;
        int holds = 1;
        for (int n = 0; n < 3; n++) {
            double by = 0.5 * (e->low[n] + e->high[n]) - p[n];
            holds &= p[n] >= e->low[n] && p[n] <= e->high[n];
            square += by * by;
        }
        if (square < best->square) {
            best->square = square;
            best->cell = e->cell;
        }
        if (holds && !visit(user, e->cell)) {
            return 0;
        }
    }
    return 1;
}

uint32_t sfi_bins_visit(const sfi_bins *b, const double p[3],
                        int (*visit)(void *user, uint32_t cell), void *user)
{
    nearest best = {SFI_NO_CELL, INFINITY};
    int64_t at[3];
    int go_on = 1;
    for (int n = 0; n < 3; n++) {
        at[n] = bin_along(b, n, p[n]);
    }
    for (int n = 0; n < 27 && go_on; n++) {
        int64_t i = at[0] + n % 3 - 1, j = at[1] + n / 3 % 3 - 1, k = at[2] + n / 9 - 1;
        if (i >= 0 && j >= 0 && k >= 0 && i < b->count[0] && j < b->count[1] && k < b->count[2]) {
            size_t bin = ((size_t)k * b->count[1] + (size_t)j) * b->count[0] + (size_t)i;
            go_on = visit_bin(b, bin, p, &best, visit, user);
        }
    }
    return best.cell;
}
