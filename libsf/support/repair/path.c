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
// Windows are gone over by rows: what stands in a row is a word of bits out of the rows below it,
// and what a row of costs hands on is that row widened as the element's rows are, a minimum of
// whole rows at a time.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 3.3, for the closest supporting path; here at prices, inside a room.

#include "support/repair/path.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "support/check/row.h"
#include "voxel/slice.h"

#define FAR INT32_MAX

// Widest element whose rows are looked at in words of 64 columns, both sides included.
#define WORD_REACH 24u

sf_status sfi_path_finder_create(const sfi_job *job, sfi_path_finder *f)
{
    *f = (sfi_path_finder){.job = job};
    f->elements = sfi_alloc_array(job->allocator, job->lattice.nz, sizeof *f->elements);
    f->row_count = (size_t)job->lattice.nx + 2 * (size_t)job->reach_x;
    f->rows[0] = sfi_alloc_array(job->allocator, f->row_count, sizeof *f->rows[0]);
    f->rows[1] = sfi_alloc_array(job->allocator, f->row_count, sizeof *f->rows[1]);
    if (f->elements == NULL || f->rows[0] == NULL || f->rows[1] == NULL) {
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
        sfi_free_array(a, f->rows[0], f->row_count, sizeof *f->rows[0]);
        sfi_free_array(a, f->rows[1], f->row_count, sizeof *f->rows[1]);
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

static int32_t *cost_at(const sfi_path_finder *f, uint32_t depth, uint32_t x, uint32_t y)
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

// ---------------------------------------------------------------------------------------------
// Bits
// ---------------------------------------------------------------------------------------------

// Bit i is voxel (x + i, y) of layer k; outside is empty.
static uint64_t bits_at(const sf_grid *grid, uint32_t k, int64_t x, uint32_t y)
{
    sf_slice slice = sf_grid_slice(grid, k);
    return sfi_moved_word(sfi_slice_row(slice, y), sfi_row_words(slice.width), 0, x);
}

// Bit i is the union of bits i .. i + count - 1.
static uint64_t smear(uint64_t bits, uint32_t count)
{
    for (uint32_t have = 1; have < count;) {
        uint32_t step = count - have < have ? count - have : have;
        bits |= bits >> step;
        have += step;
    }
    return bits;
}

// Bit i of the result: whether (x + i, y) of layer k rests on something, for 64 - 2 * reach of
// them.
static uint64_t carried_bits(const sfi_path_finder *f, uint32_t k, uint32_t x, uint32_t y)
{
    const sf_element *e = &f->elements[k - 1];
    uint32_t reach = e->half_width[0], ny = f->job->lattice.ny;
    uint64_t carried = 0, rows = 0;
    for (uint32_t dy = 0; dy <= e->reach_y; dy++) {
        uint32_t w = e->half_width[dy];
        if (y >= dy) {
            rows |= bits_at(f->grid, k - 1, (int64_t)x - reach, y - dy);
        }
        if (dy > 0 && dy < ny - y) {
            rows |= bits_at(f->grid, k - 1, (int64_t)x - reach, y + dy);
        }
        if (dy == e->reach_y || e->half_width[dy + 1] != w) {
            carried |= smear(rows, 2 * w + 1) >> (reach - w);
            rows = 0;
        }
    }
    return carried;
}

// Bit i: whether cell (x + i, y) stands by itself, and so ends a path. *count cells are told, of
// those that are asked.
static uint64_t standing_bits(const sfi_path_finder *f, uint32_t k, uint32_t x, uint32_t y,
                              uint32_t *count)
{
    const sfi_job *job = f->job;
    uint32_t reach = k > job->bed ? f->elements[k - 1].half_width[0] : 0;
    uint32_t most = reach <= WORD_REACH ? 64 - 2 * reach : 1;
    *count = *count < most ? *count : most;
    if (k == job->bed) {
        return ~UINT64_C(0);
    }
    uint64_t bits = job->exempt != NULL ? bits_at(job->exempt, k, x, y) : 0;
    if (reach <= WORD_REACH) {
        return bits | carried_bits(f, k, x, y);
    }
    return bits | (uint64_t)sfi_has_other(sf_grid_slice(f->grid, k - 1), &f->elements[k - 1], x, y,
                                          UINT32_MAX, UINT32_MAX);
}

// ---------------------------------------------------------------------------------------------
// Windows
// ---------------------------------------------------------------------------------------------

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
    f->looked += area;
    return SF_OK;
}

static sf_rect around(const sfi_path_finder *f, sf_rect r, const sf_element *e)
{
    uint32_t dx = e->half_width[0], dy = e->reach_y;
    sf_rect wide = {r.x0 > dx ? r.x0 - dx : 0, r.y0 > dy ? r.y0 - dy : 0,
                    f->job->lattice.nx - r.x1 > dx ? r.x1 + dx : f->job->lattice.nx,
                    f->job->lattice.ny - r.y1 > dy ? r.y1 + dy : f->job->lattice.ny};
    return wide;
}

// The first window: cells that all heads can rest on cost nothing, so far.
static sf_status begin(sfi_path_finder *f, uint32_t k, const sfi_path_cell *heads, size_t count)
{
    const sf_element *e = &f->elements[k];
    sf_rect one = {heads[0].x, heads[0].y, heads[0].x + 1, heads[0].y + 1};
    sf_rect r = around(f, one, e);
    SF_TRY(open_window(f, 0, r));
    for (uint32_t y = r.y0; y < r.y1; y++) {
        int32_t *costs = cost_at(f, 0, r.x0, y);
        for (uint32_t x = r.x0; x < r.x1; x++) {
            int good = 1;
            for (size_t i = 0; good && i < count; i++) {
                good = element_has(e, (int64_t)x - heads[i].x, (int64_t)y - heads[i].y);
            }
            costs[x - r.x0] = good ? 0 : FAR;
        }
    }
    return SF_OK;
}

// Add what filling costs to the cells of a window that were reached.
static void add_costs(sfi_path_finder *f, uint32_t depth, uint32_t k)
{
    const sfi_job *job = f->job;
    sf_rect r = f->windows[depth].rect;
    for (uint32_t y = r.y0; y < r.y1; y++) {
        int32_t *costs = cost_at(f, depth, r.x0, y);
        uint64_t room = 0, drawn = 0;
        for (uint32_t x = r.x0; x < r.x1; x++, costs++, room >>= 1, drawn >>= 1) {
            if ((x - r.x0) % 64 == 0) {
                room = bits_at(job->room, k, x, y);
                drawn = bits_at(job->drawn, k, x, y);
            }
            if (*costs != FAR && (drawn & room & 1) == 0) {
                *costs = (room & 1) != 0 ? *costs + (int32_t)sfi_job_add(job, k, x, y) : FAR;
            }
        }
    }
}

// Look at cells x0 <= x < x1 of a row that cost less than the best path: does one end it here?
// Widens `live` by those that go on.
static void look_at_row(sfi_path_finder *f, sfi_path_cell at, const int32_t *costs, uint32_t x1,
                        sf_rect *live, int32_t *best, sfi_path_cell *end)
{
    uint32_t x0 = at.x, count = 0;
    uint64_t standing = 0;
    for (uint32_t x = x0, from = x0; x < x1; x++) {
        int32_t cost = costs[x - x0];
        if (cost >= *best) {
            continue;
        }
        if (x >= from + count) {
            from = x;
            count = x1 - x;
            standing = standing_bits(f, at.k, x, at.y, &count);
        }
        if ((standing >> (x - from) & 1) != 0) {
            *best = cost;
            *end = (sfi_path_cell){at.k, x, at.y};
            continue;
        }
        live->x0 = live->x0 < x ? live->x0 : x;
        live->y0 = live->y0 < at.y ? live->y0 : at.y;
        live->x1 = live->x1 > x + 1 ? live->x1 : x + 1;
        live->y1 = at.y + 1;
    }
}

// Returns the rectangle around the cells of a window that go on.
static sf_rect look(sfi_path_finder *f, uint32_t depth, uint32_t k, int32_t *best,
                    sfi_path_cell *end)
{
    sf_rect r = f->windows[depth].rect, live = {UINT32_MAX, UINT32_MAX, 0, 0};
    for (uint32_t y = r.y0; y < r.y1; y++) {
        sfi_path_cell at = {k, r.x0, y};
        look_at_row(f, at, cost_at(f, depth, r.x0, y), r.x1, &live, best, end);
    }
    return live;
}

// ---------------------------------------------------------------------------------------------
// From layer to layer
// ---------------------------------------------------------------------------------------------

static inline int32_t least_of(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

// Element i of to = the least of from[i - step], from[i] and from[i + step]; outside all are far.
// There are more than 2 * step.
static void widen_row(int32_t *restrict to, const int32_t *restrict from, size_t step, size_t count)
{
    size_t last = count - step;
    for (size_t i = 0; i < step; i++) {
        to[i] = least_of(from[i], from[i + step]);
        to[last + i] = least_of(from[last + i], from[last + i - step]);
    }
    for (size_t i = step; i < last; i++) {
        int32_t least = least_of(from[i - step], from[i]);
        to[i] = least_of(least, from[i + step]);
    }
}

static void take_least(int32_t *restrict to, const int32_t *restrict from, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        to[i] = least_of(to[i], from[i]);
    }
}

// Hand the costs of a row on to row v below. Row `from` holds them from voxel r.x0 - pad on.
static void hand_on(sfi_path_finder *f, uint32_t depth, sf_rect r, uint32_t pad, uint32_t v,
                    const int32_t *from)
{
    sf_rect low = f->windows[depth + 1].rect;
    if (v >= low.y0 && v < low.y1) {
        // The window below is as wide as the row that was widened, but for the grid's border.
        take_least(cost_at(f, depth + 1, low.x0, v), from + (low.x0 + pad - r.x0), low.x1 - low.x0);
    }
}

// Hand on what row y of the live part `r` of a window costs.
static void spread_row(sfi_path_finder *f, uint32_t depth, uint32_t k, sf_rect r, uint32_t y,
                       int32_t best)
{
    const sf_element *e = &f->elements[k - 1];
    uint32_t pad = e->half_width[0], at = 0, have = 0;
    size_t count = (size_t)(r.x1 - r.x0) + 2 * (size_t)pad;
    const int32_t *costs = cost_at(f, depth, r.x0, y);
    for (size_t i = 0; i < pad; i++) {
        f->rows[0][i] = f->rows[0][count - 1 - i] = FAR;
    }
    for (size_t i = 0; i < r.x1 - r.x0; i++) {
        f->rows[0][pad + i] = costs[i] < best ? costs[i] : FAR;
    }
    for (uint32_t dy = e->reach_y + 1u; dy-- > 0;) {
        for (uint32_t reached = 0; have < e->half_width[dy]; at = 1 - at) {
            uint32_t more = e->half_width[dy] - have;
            uint32_t step = more < 2 * reached + 1 ? more : 2 * reached + 1;
            widen_row(f->rows[1 - at], f->rows[at], step, count);
            reached += step;
            have += step;
        }
        hand_on(f, depth, r, pad, y + dy, f->rows[at]);
        if (dy > 0 && y >= dy) {
            hand_on(f, depth, r, pad, y - dy, f->rows[at]);
        }
    }
}

// ---------------------------------------------------------------------------------------------
// The search
// ---------------------------------------------------------------------------------------------

// The first cell above, in order, that explains what `low` costs.
static sfi_path_cell explain(const sfi_path_finder *f, uint32_t depth, sfi_path_cell low,
                             int32_t cost)
{
    const sf_element *e = &f->elements[low.k];
    sf_rect r = f->windows[depth].rect;
    for (uint32_t y = low.y > r.y0 + e->reach_y ? low.y - e->reach_y : r.y0;
         y < r.y1 && y <= low.y + e->reach_y; y++) {
        uint32_t w = e->half_width[y > low.y ? y - low.y : low.y - y];
        for (uint32_t x = low.x > r.x0 + w ? low.x - w : r.x0; x < r.x1 && x <= low.x + w; x++) {
            if (*cost_at(f, depth, x, y) == cost) {
                return (sfi_path_cell){low.k + 1, x, y};
            }
        }
    }
    return low; // not reached: the cost came from somewhere
}

// Cells from the end up, by what their costs say.
static void trace(sfi_path_finder *f, uint32_t top, sfi_path_cell end)
{
    f->count = 0;
    f->cells[f->count++] = end;
    for (uint32_t k = end.k; k < top; k++) {
        sfi_path_cell low = f->cells[f->count - 1];
        int32_t cost = *cost_at(f, top - k, low.x, low.y);
        int is_drawn = sf_slice_get(sf_grid_slice(f->job->drawn, k), low.x, low.y);
        cost -= is_drawn ? 0 : (int32_t)sfi_job_add(f->job, k, low.x, low.y);
        f->cells[f->count++] = explain(f, top - k - 1, low, cost);
    }
}

sf_status sfi_path_find(sfi_path_finder *f, uint32_t k, const sfi_path_cell *heads,
                        size_t head_count, uint64_t bound)
{
    int32_t most = bound < FAR ? (int32_t)bound : FAR, best = most;
    sfi_path_cell end = {0, 0, 0};
    uint32_t top = k, bed = f->job->bed;
    f->count = 0;
    SF_TRY(begin(f, k, heads, head_count));
    for (uint32_t depth = 0;; depth++, k--) {
        add_costs(f, depth, k);
        sf_rect live = look(f, depth, k, &best, &end);
        if (live.x1 == 0 || k == bed || depth + 1 == SFI_PATH_DEPTH) {
            break;
        }
        SF_TRY(open_window(f, depth + 1, around(f, live, &f->elements[k - 1])));
        for (uint32_t y = live.y0; y < live.y1; y++) {
            spread_row(f, depth, k, live, y, best);
        }
    }
    if (best < most) {
        trace(f, top, end);
    }
    return SF_OK;
}
