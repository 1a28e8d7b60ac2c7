// SPDX-License-Identifier: MIT
// In turn: a grow, voxel after voxel, each finding what was grown before it.
//
// From the top down, a voxel that nothing carries gets the cheapest path to what stands, and what
// it brings counts as standing for the next one. So pillars that start apart run together where
// that is cheaper, over any number of layers; the forest sees only one layer at a time. It keeps
// all that can be kept, and leaves it to others to give something up.
//
// A path that would be longer than a search looks (path.c) follows the price map instead, to the
// cheapest voxel below, until it stands.
//
// Only for rules that are elements.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 3.3: their grow, applied to everything.

#include "support/repair/repair.h"

#include "base/status.h"
#include "support/check/row.h"
#include "support/repair/path.h"
#include "voxel/slice.h"

static void set(sf_grid *grid, uint32_t k, uint32_t x, uint32_t y)
{
    sfi_slice_row(sf_grid_slice(grid, k), y)[x / 64] |= UINT64_C(1) << (x % 64);
}

// The cheapest voxel that can carry (x, y) of layer k, the first in order. Every voxel of the room
// that is no root has one, and the map holds all that lie below its targets.
static sfi_path_cell cheapest_below(const sfi_path_finder *f, const sfi_price *price,
                                    sfi_path_cell at)
{
    const sf_element *e = &f->elements[at.k - 1];
    sf_rect r = price->rects[at.k - 1];
    sfi_path_cell best = {at.k - 1, at.x, at.y};
    int least = SFI_PRICE_NONE;
    for (uint32_t y = at.y > e->reach_y ? at.y - e->reach_y : 0; y < r.y1 && y <= at.y + e->reach_y;
         y++) {
        uint32_t w = e->half_width[y > at.y ? y - at.y : at.y - y];
        const int16_t *row = sfi_price_row(price, at.k - 1, y);
        for (uint32_t x = at.x > w ? at.x - w : 0; x < r.x1 && x <= at.x + w; x++) {
            if (row[x] < least) {
                least = row[x];
                best.x = x;
                best.y = y;
            }
        }
    }
    return best;
}

static int stands(const sfi_path_finder *f, sfi_path_cell at)
{
    const sfi_job *job = f->job;
    return at.k == job->bed ||
           (job->exempt != NULL && sf_slice_get(sf_grid_slice(job->exempt, at.k), at.x, at.y)) ||
           sfi_has_other(sf_grid_slice(f->grid, at.k - 1), &f->elements[at.k - 1], at.x, at.y,
                         UINT32_MAX, UINT32_MAX);
}

static sf_status carry_one(sfi_path_finder *f, const sfi_price *price, sfi_path_cell at,
                           sf_grid *result)
{
    if (stands(f, at)) {
        return SF_OK;
    }
    SF_TRY(sfi_path_find(f, at.k - 1, &at, 1, UINT64_MAX));
    for (uint32_t i = 0; i < f->count; i++) {
        set(result, f->cells[i].k, f->cells[i].x, f->cells[i].y);
    }
    while (!stands(f, at)) {
        at = cheapest_below(f, price, at);
        set(result, at.k, at.x, at.y);
    }
    return SF_OK;
}

static sf_status carry_layer(sfi_path_finder *f, const sfi_price *price, uint32_t k,
                             sf_grid *result, sfi_sweep *sweep)
{
    sf_slice slice = sf_grid_slice(result, k), roots = sf_grid_slice(f->job->roots, k);
    SF_TRY(sfi_sweep_layer(sweep));
    for (uint32_t y = 0; y < slice.height; y++) {
        SF_TRY(sfi_sweep_pause(sweep));
        const uint64_t *row = sfi_slice_row(slice, y), *rooted = sfi_slice_row(roots, y);
        for (size_t i = 0; i < sfi_row_words(slice.width); i++) {
            for (uint64_t w = row[i] & ~rooted[i]; w != 0; w &= w - 1) {
                sfi_path_cell at = {k, (uint32_t)i * 64 + sfi_lowest_bit(w), y};
                SF_TRY(carry_one(f, price, at, result));
            }
        }
    }
    return SF_OK;
}

sf_status sfi_grow_in_turn(const sfi_job *job, const sfi_price *price, sf_grid *result)
{
    sfi_path_finder finder;
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        SF_TRY(sf_slice_and(sf_grid_slice(result, k), sf_grid_slice(job->drawn, k),
                            sf_grid_slice(job->room, k)));
    }
    sf_status status = sfi_path_finder_create(job, &finder);
    finder.grid = result;
    sfi_sweep sweep = sfi_sweep_begin(job->pace, price->top);
    for (uint32_t k = price->top; status == SF_OK && k-- > job->bed + 1;) {
        status = carry_layer(&finder, price, k, result, &sweep);
    }
    sfi_path_finder_destroy(&finder);
    return status;
}
