// SPDX-License-Identifier: MIT
// One layer of a growth: who lacks a supporter, which bridges are needed, and the cover.
//
// Let S be the shape, R what is to stand (S and what was added so far), and M' what may be alive at
// most. A voxel v of R in layer k needs nothing where S alone keeps it alive with the slack it is
// asked for, where it is exempt and asked for none, or where a voxel of S below reaches it: that
// one will be alive in the end, because all of S will. The others are needy, and grow_cover.c
// chooses their supporters among M' in layer k - 1.
//
// With bridges and masks a voxel of M' may be one that only a bridge can hold. Then a gap of M'
// through it is taken whole into R, with as many voxels at each end as an anchor has: these are
// carried by their own supporters in M', and the bridge stands whatever else R is, because more
// matter only shortens gaps. Such closing does not cascade, since anchors are no bridged voxels.
//
// Without masks the bridges are a choice: voxels in the middle of a needy line may be dropped. A
// growth is made with and without, and the smaller one is kept (grow.c).

#include "base/bits.h"
#include "base/status.h"
#include "support/grow/growth.h"

static int has_bit(sf_slice slice, uint32_t x, uint32_t y)
{
    return (sfi_slice_row(slice, y)[x / 64] >> (x % 64) & 1) != 0;
}

static sf_slice raised_slice(const sfi_growth *g, uint32_t k)
{
    return sf_grid_slice(g->bits, SFI_GROW_RAISED + k % 2);
}

// ---------------------------------------------------------------------------------------------
// Needy voxels
// ---------------------------------------------------------------------------------------------

// What a voxel of S has to spare as it is; 0 where it is not alive, because it will be.
static uint32_t spare_of_shape(const sfi_growth *g, uint32_t k, uint32_t x, uint32_t y)
{
    size_t row = (size_t)y * sfi_slack_stride(g->cover.width);
    int is_alive = has_bit(sf_grid_slice(g->alive, k), x, y);
    return is_alive ? g->codes[k * g->site.code_bytes + row + x] - 1u : 0;
}

// Under slack: whether a voxel of S in the layer below gives v what it is asked for.
static int is_carried_by_shape(const sfi_growth *g, uint32_t k, uint32_t x, uint32_t y, uint32_t d)
{
    const sfi_grow_cover *c = &g->cover;
    sf_slice below = sf_grid_slice(g->site.grid, k - 1);
    for (size_t i = 0; i < c->reach_count; i++) {
        int64_t u = (int64_t)x + c->reach[i].dx, v = (int64_t)y + c->reach[i].dy;
        if (u < 0 || v < 0 || u >= c->width || v >= c->height ||
            !has_bit(below, (uint32_t)u, (uint32_t)v)) {
            continue;
        }
        uint32_t wanted = d + c->reach[i].cost;
        if (wanted <= c->gain ||
            wanted <= c->gain + spare_of_shape(g, k - 1, (uint32_t)u, (uint32_t)v)) {
            return 1;
        }
    }
    return 0;
}

// Under slack: whether the shape as it is, or what it will be, gives v what it is asked for. An
// anchor must be carried from below: a bridge does not do.
static int has_enough(const sfi_growth *g, uint32_t k, uint32_t x, uint32_t y)
{
    uint32_t d = g->demand[k % 2][(size_t)y * g->cover.width + x];
    if (has_bit(sf_grid_slice(g->alive, k), x, y) && spare_of_shape(g, k, x, y) >= d &&
        !has_bit(sf_grid_slice(g->bits, SFI_GROW_ANCHOR), x, y)) {
        return 1;
    }
    return is_carried_by_shape(g, k, x, y, d);
}

// What is looked at: bits of R that may lack a supporter, 64 voxels of a row.
static uint64_t suspect_word(const sfi_growth *g, uint32_t k, uint32_t y, size_t i)
{
    uint64_t w = sfi_slice_row(sf_grid_slice(g->result, k), y)[i];
    if (g->site.terms.exempt != NULL) {
        w &= ~sfi_slice_row(sf_grid_slice(g->site.terms.exempt, k), y)[i];
    }
    if (g->alive != NULL) {
        w &= ~sfi_slice_row(sf_grid_slice(g->alive, k), y)[i] |
             sfi_slice_row(sf_grid_slice(g->bits, SFI_GROW_ANCHOR), y)[i];
    }
    // What is both is an anchor of another gap.
    w &= ~sfi_slice_row(sf_grid_slice(g->bits, SFI_GROW_SPANNED), y)[i] |
         sfi_slice_row(sf_grid_slice(g->bits, SFI_GROW_ANCHOR), y)[i];
    if (g->cover.has_slack) {
        return w | sfi_slice_row(raised_slice(g, k), y)[i];
    }
    return w & ~sfi_slice_row(sf_grid_slice(g->bits, SFI_GROW_CARRIED), y)[i];
}

static void find_needy(sfi_growth *g, uint32_t k)
{
    sfi_grow_cover *c = &g->cover;
    size_t words = sfi_row_words(c->width);
    c->needy_count = 0;
    for (uint32_t y = 0; y < c->height; y++) {
        for (size_t i = 0; i < words; i++) {
            for (uint64_t w = suspect_word(g, k, y, i); w != 0; w &= w - 1) {
                uint32_t x = (uint32_t)i * 64 + sfi_lowest_bit(w);
                if (!c->has_slack || !has_enough(g, k, x, y)) {
                    c->needy[c->needy_count++] = y * c->width + x;
                }
            }
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Bridges that must be
// ---------------------------------------------------------------------------------------------

typedef struct line {
    int32_t dx, dy;
    uint32_t span, anchor;
} line;

static int step_along(const sfi_growth *g, const line *l, int sign, uint32_t *x, uint32_t *y)
{
    int64_t u = (int64_t)*x + sign * l->dx, v = (int64_t)*y + sign * l->dy;
    if (u < 0 || v < 0 || u >= g->cover.width || v >= g->cover.height) {
        return 0;
    }
    *x = (uint32_t)u;
    *y = (uint32_t)v;
    return 1;
}

// Voxels of `slice` in a line from (x, y), itself included, at most `most`.
static uint32_t count_along(const sfi_growth *g, sf_slice slice, const line *l, int sign,
                            uint32_t x, uint32_t y, uint32_t most)
{
    uint32_t n = 0;
    while (n < most && has_bit(slice, x, y)) {
        n++;
        if (!step_along(g, l, sign, &x, &y)) {
            break;
        }
    }
    return n;
}

// Voxels from (x, y) to the first anchor on one side, (x, y) not counted; UINT32_MAX: there is none
// within the span.
static uint32_t way_to_anchor(const sfi_growth *g, uint32_t k, const line *l, int sign, uint32_t x,
                              uint32_t y)
{
    sf_slice all = sf_grid_slice(g->possible, k), own = sf_grid_slice(g->own, k);
    for (uint32_t n = 0; n <= l->span && has_bit(all, x, y); n++) {
        if (has_bit(own, x, y)) {
            uint32_t back = count_along(g, own, l, -sign, x, y, l->anchor);
            uint32_t on = count_along(g, own, l, sign, x, y, l->anchor);
            if (back + on - 1 >= l->anchor) {
                return n;
            }
        }
        if (!step_along(g, l, sign, &x, &y)) {
            break;
        }
    }
    return UINT32_MAX;
}

// Whether a gap of what is possible goes through (x, y) along a line; its ends.
static int find_gap(const sfi_growth *g, uint32_t k, const line *l, uint32_t x, uint32_t y,
                    uint32_t *back, uint32_t *on)
{
    *back = l->span > 0 ? way_to_anchor(g, k, l, -1, x, y) : UINT32_MAX;
    *on = l->span > 0 ? way_to_anchor(g, k, l, 1, x, y) : UINT32_MAX;
    return *back != UINT32_MAX && *on != UINT32_MAX && *back + *on - 1 <= l->span;
}

// Take the gap and its anchors into R, or only count what of them is new.
static uint32_t take_gap(sfi_growth *g, uint32_t k, const line *l, uint32_t x, uint32_t y,
                         uint32_t back, uint32_t on, int is_counting)
{
    sf_slice r = sf_grid_slice(g->result, k), spanned = sf_grid_slice(g->bits, SFI_GROW_SPANNED);
    sf_slice anchors = sf_grid_slice(g->bits, SFI_GROW_ANCHOR);
    uint32_t fresh = 0, all = back + on + 2 * l->anchor - 1;
    for (uint32_t n = 0; n < back + l->anchor - 1; n++) {
        (void)step_along(g, l, -1, &x, &y);
    }
    for (uint32_t n = 0; n < all; n++) {
        fresh += !has_bit(r, x, y);
        if (!is_counting) {
            sfi_slice_row(r, y)[x / 64] |= UINT64_C(1) << (x % 64);
            int is_between = n >= l->anchor && n < all - l->anchor;
            sfi_slice_row(is_between ? spanned : anchors, y)[x / 64] |= UINT64_C(1) << (x % 64);
        }
        (void)step_along(g, l, 1, &x, &y);
    }
    return fresh;
}

static sf_status close_gap(sfi_growth *g, uint32_t k, uint32_t x, uint32_t y)
{
    const sf_bridge *b = &g->site.terms.rule.bridge;
    uint32_t ad = b->anchor_diagonal > 0 ? b->anchor_diagonal : 1;
    const line lines[4] = {{1, 0, b->span_x, b->anchor_x > 0 ? b->anchor_x : 1},
                           {0, 1, b->span_y, b->anchor_y > 0 ? b->anchor_y : 1},
                           {1, 1, b->span_diagonal, ad},
                           {1, -1, b->span_diagonal, ad}};
    uint32_t least = UINT32_MAX, back, on;
    int best = -1;
    for (int i = 0; i < 4; i++) {
        if (find_gap(g, k, &lines[i], x, y, &back, &on)) {
            uint32_t fresh = take_gap(g, k, &lines[i], x, y, back, on, 1);
            best = fresh < least ? i : best;
            least = fresh < least ? fresh : least;
        }
    }
    if (best < 0) {
        return SF_ERR_INTERNAL;
    }
    (void)find_gap(g, k, &lines[best], x, y, &back, &on);
    (void)take_gap(g, k, &lines[best], x, y, back, on, 0);
    return SF_OK;
}

// Close gaps until all needy voxels can have supporters of their own; *is_any says whether one was.
static sf_status close_gaps(sfi_growth *g, uint32_t k, int *is_any)
{
    size_t i = 0;
    *is_any = 0;
    while (g->own != NULL && i < g->cover.needy_count) {
        uint32_t v = g->cover.needy[i++];
        if (!has_bit(sf_grid_slice(g->own, k), v % g->cover.width, v / g->cover.width)) {
            SF_TRY(close_gap(g, k, v % g->cover.width, v / g->cover.width));
            find_needy(g, k);
            *is_any = 1;
            i = 0;
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The layer
// ---------------------------------------------------------------------------------------------

static sf_status begin_layer(sfi_growth *g, uint32_t k)
{
    sf_element e;
    SF_TRY(sfi_grow_cover_set_step(&g->cover, &g->site.plain, k - 1));
    SF_TRY(sf_rule_element(&g->site.plain, k - 1, &e));
    sfi_slice_clear(sf_grid_slice(g->bits, SFI_GROW_SPANNED));
    sfi_slice_clear(sf_grid_slice(g->bits, SFI_GROW_ANCHOR));
    if (!g->cover.has_slack) {
        SF_TRY(sf_slice_dilate(sf_grid_slice(g->bits, SFI_GROW_CARRIED),
                               sf_grid_slice(g->site.grid, k - 1), &e, SF_BORDER_EMPTY));
    }
    g->cover.demand = g->demand[k % 2];
    g->cover.price = g->price + (size_t)(k - 1 - g->site.bed) * g->area;
    g->cover.spare = g->spare != NULL ? g->spare + (size_t)(k - 1) * g->site.code_bytes : NULL;
    return SF_OK;
}

// What was chosen is there, and asked for what the cover says.
static sf_status apply(sfi_growth *g, uint32_t k)
{
    const sfi_grow_cover *c = &g->cover;
    sf_slice below = sf_grid_slice(g->result, k - 1), raised = raised_slice(g, k - 1);
    for (size_t i = 0; i < c->chosen_count; i++) {
        uint32_t u = c->chosen[i], x = u % c->width, y = u / c->width;
        sfi_slice_row(below, y)[x / 64] |= UINT64_C(1) << (x % 64);
        if (c->has_slack && c->asked[u] > 0) {
            g->demand[(k - 1) % 2][u] = c->asked[u];
            sfi_slice_row(raised, y)[x / 64] |= UINT64_C(1) << (x % 64);
        }
    }
    // This layer's demands are met: its places serve the layer after the next.
    sf_slice met = raised_slice(g, k);
    for (uint32_t y = 0; c->has_slack && y < c->height; y++) {
        for (size_t i = 0; i < sfi_row_words(c->width); i++) {
            for (uint64_t w = sfi_slice_row(met, y)[i]; w != 0; w &= w - 1) {
                g->demand[k % 2][(size_t)y * c->width + i * 64 + sfi_lowest_bit(w)] = 0;
            }
        }
    }
    sfi_slice_clear(met);
    return SF_OK;
}

sf_status sfi_growth_begin(sfi_growth *g)
{
    for (uint32_t i = 0; i < 2; i++) {
        sfi_slice_clear(raised_slice(g, i));
        for (size_t v = 0; g->cover.has_slack && v < g->area; v++) {
            g->demand[i][v] = 0;
        }
    }
    return SF_OK;
}

sf_status sfi_growth_layer(sfi_growth *g, uint32_t k, sfi_growth_kind kind)
{
    const sf_bridge *b = &g->site.terms.rule.bridge;
    SF_TRY(begin_layer(g, k));
    find_needy(g, k);
    int is_closed;
    SF_TRY(close_gaps(g, k, &is_closed));
    // The anchors of a bridge that must be are not to be dropped.
    if (kind == SFI_GROW_X && !is_closed) {
        sfi_grow_cover_thin(&g->cover, 1, b->span_x, b->anchor_x > 0 ? b->anchor_x : 1);
    } else if (kind == SFI_GROW_Y && !is_closed) {
        sfi_grow_cover_thin(&g->cover, g->cover.width, b->span_y,
                            b->anchor_y > 0 ? b->anchor_y : 1);
    }
    SF_TRY(sfi_grow_cover_choose(&g->cover));
    return apply(g, k);
}
