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
// Where little hangs this is quick, and where much does a search has far to go before it meets
// anything: a roof's first voxels look at a hundred thousand cells each. So it goes on only while
// what it has added costs less than what is known already, and while all searches together have
// looked at no more than LOOK_MOST cells; else it is given up, and nothing is lost but that.
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

#define LOOK_MOST (UINT64_C(1) << 25)

// A grow at work.
typedef struct growth {
    const sfi_job *job;
    const sfi_price *price;
    sf_grid *result;
    sfi_path_finder finder;
    uint64_t spent, bound;
    sfi_sweep sweep;
} growth;

static int is_given_up(const growth *g)
{
    return g->spent >= g->bound || g->finder.looked > LOOK_MOST;
}

static void set(growth *g, const sfi_path_cell *at)
{
    uint64_t *word = sfi_slice_row(sf_grid_slice(g->result, at->k), at->y) + at->x / 64;
    uint64_t bit = UINT64_C(1) << (at->x % 64);
    g->spent += (*word & bit) != 0 ? 0 : sfi_job_add(g->job, at->k, at->x, at->y);
    *word |= bit;
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

static sf_status carry_one(growth *g, sfi_path_cell at)
{
    sfi_path_finder *f = &g->finder;
    if (stands(f, at)) {
        return SF_OK;
    }
    SF_TRY(sfi_path_find(f, at.k - 1, &at, 1, UINT64_MAX));
    for (uint32_t i = 0; i < f->count; i++) {
        set(g, &f->cells[i]);
    }
    while (!stands(f, at)) {
        at = cheapest_below(f, g->price, at);
        set(g, &at);
    }
    return SF_OK;
}

static sf_status carry_layer(growth *g, uint32_t k)
{
    sf_slice slice = sf_grid_slice(g->result, k), roots = sf_grid_slice(g->job->roots, k);
    SF_TRY(sfi_sweep_layer(&g->sweep));
    for (uint32_t y = 0; y < slice.height && !is_given_up(g); y++) {
        SF_TRY(sfi_sweep_pause(&g->sweep));
        const uint64_t *row = sfi_slice_row(slice, y), *rooted = sfi_slice_row(roots, y);
        for (size_t i = 0; i < sfi_row_words(slice.width); i++) {
            for (uint64_t w = row[i] & ~rooted[i]; w != 0 && !is_given_up(g); w &= w - 1) {
                sfi_path_cell at = {k, (uint32_t)i * 64 + sfi_lowest_bit(w), y};
                SF_TRY(carry_one(g, at));
            }
        }
    }
    return SF_OK;
}

sf_status sfi_grow_in_turn(const sfi_job *job, const sfi_price *price, uint64_t bound,
                           sf_grid *result, int *is_done)
{
    growth g = {.job = job, .price = price, .result = result, .bound = bound};
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        SF_TRY(sf_slice_and(sf_grid_slice(result, k), sf_grid_slice(job->drawn, k),
                            sf_grid_slice(job->room, k)));
    }
    sf_status status = sfi_path_finder_create(job, &g.finder);
    g.finder.grid = result;
    g.sweep = sfi_sweep_begin(job->pace, price->top);
    for (uint32_t k = price->top; status == SF_OK && !is_given_up(&g) && k-- > job->bed + 1;) {
        status = carry_layer(&g, k);
    }
    *is_done = !is_given_up(&g);
    sfi_path_finder_destroy(&g.finder);
    return status;
}
