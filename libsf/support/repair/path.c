// SPDX-License-Identifier: MIT
// Path: the cheapest way down from a voxel that hangs to what stands.
//
// From the cells that can carry the heads, layer by layer: the cost of a cell is what filling it
// costs and the least cost of those above that it can carry. The first cell that stands by itself
// (on the bed, exempt, or carried by what is there) ends a path; cells that cost as much as the
// best path yet are dropped, and as each step costs at least 1, a search ends by itself after as
// many layers as the best path costs. Deeper than SFI_PATH_DEPTH layers it does not look: paths as
// long as that are the forest's business, and what is asked here is mostly whether a neighbour is
// near.
//
// The way back is found from the costs alone: a cell above that explains the cost of the one below.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 3.3, for the closest supporting path; here at prices, inside a room.

#include "support/repair/path.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "support/check/row.h"
#include "voxel/slice.h"

#define FAR UINT32_MAX

sf_status sfi_path_finder_create(const sfi_job *job, sfi_path_finder *f)
{
    *f = (sfi_path_finder){.job = job};
    f->elements = sfi_alloc_array(job->allocator, job->lattice.nz, sizeof *f->elements);
    if (f->elements == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t k = 0; k + 1 < job->lattice.nz; k++) {
        SF_TRY(sf_rule_element(&job->rule, k, &f->elements[k]));
    }
    return SF_OK;
}

void sfi_path_finder_destroy(sfi_path_finder *f)
{
    if (f->job != NULL) {
        const sf_allocator *a = f->job->allocator;
        sfi_free_array(a, f->elements, f->job->lattice.nz, sizeof *f->elements);
        sfi_free_array(a, f->costs, f->capacity, sizeof *f->costs);
    }
    *f = (sfi_path_finder){0};
}

int sfi_has_other(sf_slice slice, const sf_element *e, uint32_t x, uint32_t y, uint32_t ux,
                  uint32_t uy)
{
    for (uint32_t row = y > e->reach_y ? y - e->reach_y : 0;
         row < slice.height && row <= y + e->reach_y; row++) {
        uint32_t w = e->half_width[row > y ? row - y : y - row];
        uint32_t x0 = x > w ? x - w : 0, x1 = x + w + 1;
        const uint64_t *words = sfi_slice_row(slice, row);
        if (row != uy || ux < x0 || ux >= x1) {
            if (sfi_row_any(words, slice.width, x0, x1)) {
                return 1;
            }
        } else if (sfi_row_any(words, slice.width, x0, ux) ||
                   sfi_row_any(words, slice.width, ux + 1, x1)) {
            return 1;
        }
    }
    return 0;
}

static uint32_t *cost_at(const sfi_path_finder *f, uint32_t depth, uint32_t x, uint32_t y)
{
    const sfi_path_window *w = &f->windows[depth];
    return f->costs + w->start + (size_t)(y - w->rect.y0) * (w->rect.x1 - w->rect.x0) + x -
           w->rect.x0;
}

static int element_has(const sf_element *e, int64_t dx, int64_t dy)
{
    int64_t ax = dx < 0 ? -dx : dx, ay = dy < 0 ? -dy : dy;
    return ay <= e->reach_y && ax <= e->half_width[ay];
}

// Whether a cell stands by itself, and so ends a path.
static int stands(const sfi_path_finder *f, uint32_t k, uint32_t x, uint32_t y)
{
    const sfi_job *job = f->job;
    return k == job->bed ||
           (job->exempt != NULL && sf_slice_get(sf_grid_slice(job->exempt, k), x, y)) ||
           sfi_has_other(sf_grid_slice(f->grid, k - 1), &f->elements[k - 1], x, y, UINT32_MAX,
                         UINT32_MAX);
}

// A window at some depth, all of it far.
static sf_status open_window(sfi_path_finder *f, uint32_t depth, sf_rect rect)
{
    sfi_path_window *w = &f->windows[depth];
    size_t area, need;
    void *memory = f->costs;
    w->rect = rect;
    w->start = 0;
    if (depth > 0) {
        const sfi_path_window *above = &f->windows[depth - 1];
        w->start = above->start +
                   (size_t)(above->rect.x1 - above->rect.x0) * (above->rect.y1 - above->rect.y0);
    }
    if (!sfi_size_mul(rect.x1 - rect.x0, rect.y1 - rect.y0, &area) ||
        !sfi_size_add(w->start, area, &need)) {
        return SF_ERR_OVERFLOW;
    }
    int good = sfi_grow_array(f->job->allocator, &memory, &f->capacity, need, sizeof *f->costs);
    f->costs = memory;
    if (!good) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = w->start; i < need; i++) {
        f->costs[i] = FAR;
    }
    return SF_OK;
}

static sf_rect around(const sfi_path_finder *f, sf_rect r, const sf_element *e)
{
    uint32_t dx = 0, dy = e->reach_y;
    for (uint32_t i = 0; i <= dy; i++) {
        dx = e->half_width[i] > dx ? e->half_width[i] : dx;
    }
    sf_rect wide = {r.x0 > dx ? r.x0 - dx : 0, r.y0 > dy ? r.y0 - dy : 0,
                    f->job->lattice.nx - r.x1 > dx ? r.x1 + dx : f->job->lattice.nx,
                    f->job->lattice.ny - r.y1 > dy ? r.y1 + dy : f->job->lattice.ny};
    return wide;
}

// The first window: cells that all heads can rest on.
static sf_status begin(sfi_path_finder *f, uint32_t k, const sfi_path_cell *heads, size_t count)
{
    const sf_element *e = &f->elements[k];
    sf_rect one = {heads[0].x, heads[0].y, heads[0].x + 1, heads[0].y + 1};
    sf_rect r = around(f, one, e);
    SF_TRY(open_window(f, 0, r));
    sf_slice room = sf_grid_slice(f->job->room, k);
    for (uint32_t y = r.y0; y < r.y1; y++) {
        for (uint32_t x = r.x0; x < r.x1; x++) {
            int good = sf_slice_get(room, x, y);
            for (size_t i = 0; good && i < count; i++) {
                good = element_has(e, (int64_t)x - heads[i].x, (int64_t)y - heads[i].y);
            }
            if (good) {
                int is_drawn = sf_slice_get(sf_grid_slice(f->job->drawn, k), x, y);
                *cost_at(f, 0, x, y) = is_drawn ? 0 : sfi_job_add(f->job, k, x, y);
            }
        }
    }
    return SF_OK;
}

// Hand the cost of a cell on to all that can carry it.
static void spread(sfi_path_finder *f, uint32_t depth, uint32_t k, uint32_t x, uint32_t y,
                   uint32_t cost)
{
    const sf_element *e = &f->elements[k - 1];
    sf_rect r = f->windows[depth + 1].rect;
    for (uint32_t v = y > e->reach_y ? y - e->reach_y : 0; v < r.y1 && v <= y + e->reach_y; v++) {
        uint32_t w = e->half_width[v > y ? v - y : y - v];
        uint32_t from = x > w ? x - w : 0, to = x + w + 1 < r.x1 ? x + w + 1 : r.x1;
        uint32_t *below = cost_at(f, depth + 1, from, v);
        for (uint32_t i = 0; i < to - from; i++) {
            below[i] = below[i] < cost ? below[i] : cost;
        }
    }
}

// Add what filling costs to the cells of a window that were reached.
static void add_costs(sfi_path_finder *f, uint32_t depth, uint32_t k)
{
    sf_rect r = f->windows[depth].rect;
    sf_slice room = sf_grid_slice(f->job->room, k), drawn = sf_grid_slice(f->job->drawn, k);
    for (uint32_t y = r.y0; y < r.y1; y++) {
        uint32_t *costs = cost_at(f, depth, r.x0, y);
        for (uint32_t x = r.x0; x < r.x1; x++, costs++) {
            if (*costs == FAR) {
                continue;
            }
            if (!sf_slice_get(room, x, y)) {
                *costs = FAR;
            } else if (!sf_slice_get(drawn, x, y)) {
                *costs += sfi_job_add(f->job, k, x, y);
            }
        }
    }
}

// Look at the cells of a window that cost less than the best path: does one end it here? Returns
// the rectangle around those that go on.
static sf_rect look(sfi_path_finder *f, uint32_t depth, uint32_t k, uint64_t *best,
                    sfi_path_cell *end)
{
    sf_rect r = f->windows[depth].rect, live = {UINT32_MAX, UINT32_MAX, 0, 0};
    for (uint32_t y = r.y0; y < r.y1; y++) {
        for (uint32_t x = r.x0; x < r.x1; x++) {
            uint32_t cost = *cost_at(f, depth, x, y);
            if (cost == FAR || cost >= *best) {
                continue;
            }
            if (stands(f, k, x, y)) {
                sfi_path_cell here = {k, x, y};
                *best = cost;
                *end = here;
                continue;
            }
            live.x0 = live.x0 < x ? live.x0 : x;
            live.y0 = live.y0 < y ? live.y0 : y;
            live.x1 = live.x1 > x + 1 ? live.x1 : x + 1;
            live.y1 = live.y1 > y + 1 ? live.y1 : y + 1;
        }
    }
    return live;
}

// Cells from the end up, by what their costs say.
static void trace(sfi_path_finder *f, uint32_t top, sfi_path_cell end)
{
    f->count = 0;
    f->cells[f->count++] = end;
    for (uint32_t k = end.k; k < top; k++) {
        sfi_path_cell low = f->cells[f->count - 1];
        uint32_t depth = top - k, cost = *cost_at(f, depth, low.x, low.y);
        int is_drawn = sf_slice_get(sf_grid_slice(f->job->drawn, k), low.x, low.y);
        cost -= is_drawn ? 0 : sfi_job_add(f->job, k, low.x, low.y);
        sf_rect r = f->windows[depth - 1].rect;
        for (uint32_t i = 0, found = 0; !found && i < (r.x1 - r.x0) * (r.y1 - r.y0); i++) {
            sfi_path_cell up = {k + 1, r.x0 + i % (r.x1 - r.x0), r.y0 + i / (r.x1 - r.x0)};
            if (*cost_at(f, depth - 1, up.x, up.y) == cost &&
                element_has(&f->elements[k], (int64_t)up.x - low.x, (int64_t)up.y - low.y)) {
                f->cells[f->count++] = up;
                found = 1;
            }
        }
    }
}

sf_status sfi_path_find(sfi_path_finder *f, uint32_t k, const sfi_path_cell *heads,
                        size_t head_count, uint64_t bound)
{
    uint64_t best = bound;
    sfi_path_cell end = {0, 0, 0};
    uint32_t top = k, bed = f->job->bed;
    f->count = 0;
    SF_TRY(begin(f, k, heads, head_count));
    for (uint32_t depth = 0;; depth++, k--) {
        sf_rect live = look(f, depth, k, &best, &end);
        if (live.x1 == 0 || k == bed || depth + 1 == SFI_PATH_DEPTH) {
            break;
        }
        SF_TRY(open_window(f, depth + 1, around(f, live, &f->elements[k - 1])));
        for (uint32_t y = live.y0; y < live.y1; y++) {
            for (uint32_t x = live.x0; x < live.x1; x++) {
                uint32_t cost = *cost_at(f, depth, x, y);
                if (cost != FAR && cost < best) {
                    spread(f, depth, k, x, y, cost);
                }
            }
        }
        add_costs(f, depth + 1, k - 1);
    }
    if (best < bound) {
        trace(f, top, end);
    }
    return SF_OK;
}
