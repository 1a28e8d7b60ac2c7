// SPDX-License-Identifier: MIT
// How near the voxels of a grid come to a surface.
//
// A triangle that touches a voxel is at distance 0, and which voxels are touched is known from
// clipping (touched.c). Where none is, the nearest point of what is solid lies on its border, so
// that only voxels with an empty neighbour, across a face, are asked, each for no more than the
// least distance so far. Slabs of layers are asked side by side, in turns, so that all know what
// was found in the turn before; the least of all is the same in any order.

#include "balance/wall/levels.h"
#include "balance/wall/near.h"
#include "balance/wall/touched.h"
#include "base/bits.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "voxel/slice.h"

#include <sf/carve.h>

#include <float.h>
#include <math.h>
#include <string.h>

#define PIECES 16u // slabs at a time
#define SLAB 4u    // layers of a slab
#define FARTHEST 1e12

typedef struct search {
    const sf_grid *grid;
    sf_lattice lattice;
    double *levels;
    sfi_near near;
    double least;         // of the turns before
    double found[PIECES]; // of this turn
    uint32_t first_slab;
} search;

// Whether any voxel of the grid is one that the surface touches.
static int meets(const sf_grid *grid, const sfi_touched *touched)
{
    sf_lattice l = sf_grid_lattice(grid);
    size_t words = sfi_row_words(l.nx);
    for (uint32_t k = 0; k < l.nz; k++) {
        sf_slice a = sf_grid_slice(grid, k);
        sf_slice b = sf_grid_slice(touched->grid, k + touched->before[2]);
        for (uint32_t y = 0; y < l.ny; y++) {
            const uint64_t *p = sfi_slice_row(a, y);
            const uint64_t *q = sfi_slice_row(b, y + touched->before[1]) + touched->before[0] / 64;
            for (size_t i = 0; i < words; i++) {
                if ((sfi_row_word(p, i, l.nx) & q[i]) != 0) {
                    return 1;
                }
            }
        }
    }
    return 0;
}

// Of word i of a row, the voxels with an empty neighbour.
static uint64_t border(const search *s, uint32_t k, uint32_t y, size_t i)
{
    const sf_lattice *l = &s->lattice;
    sf_slice here = sf_grid_slice(s->grid, k);
    const uint64_t *row = sfi_slice_row(here, y);
    uint64_t solid = sfi_row_word(row, i, l->nx);
    if (solid == 0 || k == 0 || k + 1 == l->nz || y == 0 || y + 1 == l->ny) {
        return solid;
    }
    uint64_t before = i > 0 ? row[i - 1] >> 63 : 0, after = sfi_row_word(row, i + 1, l->nx) << 63;
    uint64_t inside = (solid << 1 | before) & (solid >> 1 | after);
    inside &= sfi_slice_row(here, y - 1)[i] & sfi_slice_row(here, y + 1)[i];
    inside &= sfi_slice_row(sf_grid_slice(s->grid, k - 1), y)[i];
    inside &= sfi_slice_row(sf_grid_slice(s->grid, k + 1), y)[i];
    return solid & ~inside;
}

static double ask_layer(const search *s, uint32_t k, double least)
{
    const sf_lattice *l = &s->lattice;
    double half[3] = {0.5 * l->pitch_x_mm, 0.5 * l->pitch_y_mm,
                      0.5 * (s->levels[k + 1] - s->levels[k])};
    for (uint32_t y = 0; y < l->ny; y++) {
        for (size_t i = 0; i < sfi_row_words(l->nx); i++) {
            for (uint64_t word = border(s, k, y, i); word != 0; word &= word - 1) {
                uint32_t x = (uint32_t)(64 * i) + sfi_lowest_bit(word);
                double middle[3] = {l->origin_mm[0] + (x + 0.5) * l->pitch_x_mm,
                                    l->origin_mm[1] + (y + 0.5) * l->pitch_y_mm,
                                    0.5 * (s->levels[k] + s->levels[k + 1])};
                least = sfi_near_least(&s->near, middle, half, least);
            }
        }
    }
    return least;
}

static void ask_slab(void *context, size_t index)
{
    search *s = context;
    uint32_t first = (s->first_slab + (uint32_t)index) * SLAB;
    double least = s->least;
    for (uint32_t k = first; k < s->lattice.nz && k < first + SLAB; k++) {
        least = ask_layer(s, k, least);
    }
    s->found[index] = least;
}

static sf_status ask_all(search *s, sf_task *task)
{
    sfi_progress progress = sfi_progress_begin(task);
    uint32_t slabs = (s->lattice.nz - 1) / SLAB + 1;
    while (s->first_slab < slabs) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        uint32_t left = slabs - s->first_slab, count = left < PIECES ? left : PIECES;
        sfi_task_for(task, count, ask_slab, s);
        for (uint32_t i = 0; i < count; i++) {
            s->least = s->found[i] < s->least ? s->found[i] : s->least;
        }
        s->first_slab += count;
        sfi_progress_report(&progress, s->first_slab, slabs);
    }
    return SF_OK;
}

static sf_status find_least(search *s, sf_mesh_view surface, const sf_allocator *allocator,
                            sf_task *task)
{
    sfi_touched touched;
    SF_TRY(sfi_touched_create(surface, &s->lattice, 0, allocator, task, &touched));
    int is_met = meets(s->grid, &touched);
    sfi_touched_destroy(&touched, allocator);
    if (is_met) {
        s->least = 0;
        return SF_OK;
    }
    SF_TRY(sfi_near_create(surface, allocator, &s->near));
    s->levels = sfi_levels_create(&s->lattice, allocator);
    sf_status status = s->levels != NULL ? ask_all(s, task) : SF_ERR_MEMORY;
    sfi_levels_destroy(s->levels, &s->lattice, allocator);
    sfi_near_destroy(&s->near, allocator);
    return status;
}

sf_status sf_grid_clearance(const sf_grid *grid, sf_mesh_view surface,
                            const sf_allocator *allocator, sf_task *task, double *least_mm)
{
    double low[3], high[3];
    if (grid == NULL || least_mm == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_mesh_bounds(surface, low, high));
    for (int i = 0; i < 3; i++) {
        if (low[i] < -FARTHEST || high[i] > FARTHEST) {
            return SF_ERR_OVERFLOW;
        }
    }
    sf_allocator memory = sfi_allocator_or_default(allocator);
    search s;
    memset(&s, 0, sizeof s);
    s.grid = grid;
    s.lattice = sf_grid_lattice(grid);
    s.least = 1e100; // farther than anything is
    SF_TRY(find_least(&s, surface, &memory, task));
    *least_mm = s.least < 1e100 ? s.least : INFINITY;
    return SF_OK;
}
