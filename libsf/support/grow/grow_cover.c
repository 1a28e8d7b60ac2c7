// SPDX-License-Identifier: MIT
// Cover: supporters below for all voxels of a layer that have none.
//
// The fewest supporters are a set cover, which is hard, so they are chosen greedily. Each needy
// voxel v looks only at its cheapest supporters, those from which the way to matter is shortest: it
// would take one of these if it were alone. Of these it favours one, the closest to where it is
// drawn (grow_blocks.c). Among all candidates the one that most needy voxels look at is taken next;
// of several the one that most favour, then the one of least y, then of least x. It serves every
// needy voxel in reach, whether that looked at it or not. At the end, from the last chosen to the
// first, a supporter goes if all that it serves have another. So none is left that could be dropped
// alone.
//
// That greedy cover among the cheapest beats a fixed choice for each voxel by far where overhangs
// are wide: in a flat one all are equally cheap, and nine voxels share one.
//
// Under slack a voxel may have a demand, what it must have to spare, and asks of a supporter
//
//     req(v, u) = max(0, d(v) - rho + |v - u|);
//
// a supporter is asked for the most that those ask who look at it when it is taken, and serves all
// who ask no more. Where v can be carried at all with its demand, one below has enough to spare
// (terms.c: what is possible is itself a trim), so the cover never fails.
//
// Bridges: of a row of needy voxels those in the middle may be left to a bridge, if enough of them
// on both ends are carried. Groups of anchors stand at the same columns in all rows, so that they
// share supporters.

#include "support/grow/grow_cover.h"

#include "base/bits.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

enum { NEEDY = 1, SERVED = 2, DROPPED = 4 };

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

void sfi_grow_cover_destroy(sfi_grow_cover *c)
{
    const sf_allocator *a = &c->allocator;
    sfi_free_array(a, c->reach, c->reach_capacity, sizeof *c->reach);
    sfi_free_array(a, c->needy, c->area, sizeof *c->needy);
    sfi_free_array(a, c->chosen, c->area, sizeof *c->chosen);
    sfi_free_array(a, c->asked, c->area, sizeof *c->asked);
    sfi_free_array(a, c->mark, c->area, sizeof *c->mark);
    sfi_free_array(a, c->least, c->area, sizeof *c->least);
    sfi_free_array(a, c->have, c->area, sizeof *c->have);
    sfi_free_array(a, c->count, c->area, sizeof *c->count);
    sfi_free_array(a, c->possible, c->words, sizeof *c->possible);
    sfi_blocks_destroy(&c->blocks, a);
}

sf_status sfi_grow_cover_create(sfi_grow_cover *c, const sfi_site *site)
{
    sfi_grow_cover empty = {.allocator = site->allocator,
                            .width = site->lattice.nx,
                            .height = site->lattice.ny,
                            .has_slack = site->plain.kind == SF_RULE_SLACK,
                            .cap = site->plain.slack_cap};
    *c = empty;
    if (!sfi_size_mul(c->width, c->height, &c->area) || !sfi_size_add(c->area, 63, &c->words)) {
        c->area = 0;
        return SF_ERR_OVERFLOW;
    }
    c->words /= 64;
    const sf_allocator *a = &c->allocator;
    c->needy = sfi_alloc_array(a, c->area, sizeof *c->needy);
    c->chosen = sfi_alloc_array(a, c->area, sizeof *c->chosen);
    c->asked = sfi_alloc_array(a, c->area, sizeof *c->asked);
    c->mark = sfi_alloc_array(a, c->area, sizeof *c->mark);
    c->least = sfi_alloc_array(a, c->area, sizeof *c->least);
    c->have = sfi_alloc_array(a, c->area, sizeof *c->have);
    c->count = sfi_alloc_array(a, c->area, sizeof *c->count);
    c->possible = sfi_alloc_array(a, c->words, sizeof *c->possible);
    if (c->needy == NULL || c->chosen == NULL || c->asked == NULL || c->mark == NULL ||
        c->least == NULL || c->have == NULL || c->count == NULL || c->possible == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < c->area; i++) {
        c->mark[i] = c->asked[i] = 0;
        c->have[i] = 0;
        c->count[i] = 0;
    }
    for (size_t i = 0; i < c->words; i++) {
        c->possible[i] = 0;
    }
    return sfi_blocks_create(&c->blocks, c->width, c->height, a);
}

sf_status sfi_grow_cover_set_step(sfi_grow_cover *c, const sf_rule *plain, uint32_t k)
{
    sf_element e;
    SF_TRY(sf_rule_element(plain, k, &e));
    size_t need = (2 * (size_t)e.reach_y + 1) * (2 * (size_t)e.half_width[0] + 1);
    void *reach = c->reach;
    if (!sfi_grow_array(&c->allocator, &reach, &c->reach_capacity, need, sizeof *c->reach)) {
        return SF_ERR_MEMORY;
    }
    c->reach = reach;
    c->reach_count = 0;
    c->gain = c->has_slack ? sfi_slack_gain(plain, k) : 0;
    for (int dy = -(int)e.reach_y; dy <= (int)e.reach_y; dy++) {
        int half = e.half_width[dy < 0 ? -dy : dy];
        for (int dx = -half; dx <= half; dx++) {
            uint32_t ax = (uint32_t)(dx < 0 ? -dx : dx), ay = (uint32_t)(dy < 0 ? -dy : dy);
            uint32_t cost = c->has_slack ? sfi_slack_cost(plain, ax, ay) : 0;
            sfi_reach r = {(int16_t)dx, (int16_t)dy, cost};
            if (cost <= c->gain + c->cap) {
                c->reach[c->reach_count++] = r;
            }
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Bridges
// ---------------------------------------------------------------------------------------------

static void mark_needy(sfi_grow_cover *c)
{
    for (size_t i = 0; i < c->needy_count; i++) {
        c->mark[c->needy[i]] |= NEEDY;
    }
}

// Number of needy voxels without a demand, one after the other in a line from v.
static uint32_t line_length(const sfi_grow_cover *c, uint32_t v, uint32_t step)
{
    uint32_t most = step == 1 ? c->width - v % c->width : c->height - v / c->width, n = 0;
    while (n < most && (c->mark[v + n * step] & NEEDY) != 0 &&
           (c->demand == NULL || c->demand[v + n * step] == 0)) {
        n++;
    }
    return n;
}

void sfi_grow_cover_thin(sfi_grow_cover *c, uint32_t step, uint32_t span, uint32_t anchor)
{
    uint32_t period = span + anchor;
    mark_needy(c);
    for (size_t i = 0; i < c->needy_count; i++) {
        uint32_t v = c->needy[i], place = step == 1 ? v % c->width : v / c->width;
        int is_start = place == 0 || (c->mark[v - step] & NEEDY) == 0 ||
                       (c->demand != NULL && c->demand[v - step] != 0);
        uint32_t n = is_start ? line_length(c, v, step) : 0;
        for (uint32_t p = anchor; n > 2 * anchor && p < n - anchor; p++) {
            if ((place + p) % period >= anchor) {
                c->mark[v + p * step] |= DROPPED;
            }
        }
    }
    size_t kept = 0;
    for (size_t i = 0; i < c->needy_count; i++) {
        uint32_t v = c->needy[i];
        c->needy[kept] = v;
        kept += (c->mark[v] & DROPPED) == 0;
        c->mark[v] = 0;
    }
    c->needy_count = kept;
}

// ---------------------------------------------------------------------------------------------
// Choosing
// ---------------------------------------------------------------------------------------------

// The voxel at a reach from v, towards below (sign 1) or back up (sign -1); 0 outside the slice.
static int at_reach(const sfi_grow_cover *c, uint32_t v, const sfi_reach *r, int sign, uint32_t *u)
{
    int64_t x = (int64_t)(v % c->width) + sign * r->dx, y = (int64_t)(v / c->width) + sign * r->dy;
    if (x < 0 || y < 0 || x >= c->width || y >= c->height) {
        return 0;
    }
    *u = (uint32_t)y * c->width + (uint32_t)x;
    return 1;
}

static uint32_t required(const sfi_grow_cover *c, uint32_t v, const sfi_reach *r)
{
    uint32_t wanted = (c->has_slack ? c->demand[v] : 0) + r->cost;
    return wanted > c->gain ? wanted - c->gain : 0;
}

// Whether u below may carry v at that reach.
static int is_able(const sfi_grow_cover *c, uint32_t v, uint32_t u, const sfi_reach *r)
{
    if (c->price[u] == SFI_PRICE_NONE) {
        return 0;
    }
    if (!c->has_slack) {
        return 1;
    }
    size_t at = (size_t)(u / c->width) * sfi_slack_stride(c->width) + u % c->width;
    uint32_t has = c->spare != NULL ? c->spare[at] - 1u : c->cap;
    return required(c, v, r) <= has;
}

// Find the price that v looks at; 0 where nothing can carry it.
static int find_least(sfi_grow_cover *c, uint32_t v)
{
    uint16_t least = SFI_PRICE_NONE;
    for (size_t i = 0; i < c->reach_count; i++) {
        uint32_t u;
        if (at_reach(c, v, &c->reach[i], 1, &u) && c->price[u] < least &&
            is_able(c, v, u, &c->reach[i])) {
            least = c->price[u];
        }
    }
    c->least[v] = least;
    return least != SFI_PRICE_NONE;
}

static uint64_t squared_distance(const sfi_grow_cover *c, uint32_t u, uint32_t v)
{
    int64_t dx = (int64_t)(u % c->width) - v % c->width;
    int64_t dy = (int64_t)(u / c->width) - v / c->width;
    return (uint64_t)(dx * dx + dy * dy);
}

// Add v to the counts of all candidates that it looks at, or take it out of them (sign -1).
static void count_looks(sfi_grow_cover *c, uint32_t v, int sign)
{
    uint64_t look = c->reach_count + 1, nearest = UINT64_MAX;
    uint32_t goal = sfi_blocks_goal(&c->blocks, v, c->least[v]), favourite = v;
    for (size_t i = 0; i < c->reach_count; i++) {
        uint32_t u;
        if (!at_reach(c, v, &c->reach[i], 1, &u) || c->price[u] != c->least[v] ||
            !is_able(c, v, u, &c->reach[i])) {
            continue;
        }
        c->count[u] += sign > 0 ? look : ~look + 1;
        c->possible[u / 64] |= UINT64_C(1) << (u % 64);
        uint64_t far = squared_distance(c, u, goal);
        favourite = far < nearest ? u : favourite;
        nearest = far < nearest ? far : nearest;
    }
    c->count[favourite] += sign > 0 ? 1 : UINT64_MAX;
}

// What those who look at u, and are not served, ask of it at most.
static uint32_t most_asked(const sfi_grow_cover *c, uint32_t u)
{
    uint32_t most = 0;
    for (size_t i = 0; c->has_slack && i < c->reach_count; i++) {
        uint32_t v;
        const sfi_reach *r = &c->reach[i];
        if (at_reach(c, u, r, -1, &v) && (c->mark[v] & (NEEDY | SERVED)) == NEEDY &&
            c->least[v] == c->price[u] && is_able(c, v, u, r) && required(c, v, r) > most) {
            most = required(c, v, r);
        }
    }
    return most;
}

// Whether a chosen u serves v.
static int serves(const sfi_grow_cover *c, uint32_t u, uint32_t v, const sfi_reach *r)
{
    return (c->mark[v] & NEEDY) != 0 && (!c->has_slack || required(c, v, r) <= c->asked[u]);
}

static void take(sfi_grow_cover *c, uint32_t u)
{
    c->asked[u] = (uint8_t)most_asked(c, u);
    c->chosen[c->chosen_count++] = u;
    for (size_t i = 0; i < c->reach_count; i++) {
        uint32_t v;
        if (!at_reach(c, u, &c->reach[i], -1, &v) || !serves(c, u, v, &c->reach[i])) {
            continue;
        }
        c->have[v]++;
        if ((c->mark[v] & SERVED) == 0) {
            c->mark[v] |= SERVED;
            count_looks(c, v, -1);
        }
    }
}

// Take candidates, those that most look at first.
static void take_all(sfi_grow_cover *c)
{
    uint64_t most = 0;
    for (size_t i = 0; i < c->words; i++) {
        for (uint64_t w = c->possible[i]; w != 0; w &= w - 1) {
            uint64_t n = c->count[64 * i + sfi_lowest_bit(w)];
            most = n > most ? n : most;
        }
    }
    while (most > 0) {
        uint64_t next = 0;
        for (size_t i = 0; i < c->words; i++) {
            for (uint64_t w = c->possible[i]; w != 0; w &= w - 1) {
                uint32_t u = (uint32_t)(64 * i) + sfi_lowest_bit(w);
                if (c->count[u] == most) {
                    take(c, u);
                }
                next = c->count[u] > next ? c->count[u] : next;
            }
        }
        most = next; // less than before: all that had so many are taken
    }
}

// Whether all that a chosen u serves have another supporter, too.
static int is_idle(const sfi_grow_cover *c, uint32_t u)
{
    for (size_t i = 0; i < c->reach_count; i++) {
        uint32_t v;
        if (at_reach(c, u, &c->reach[i], -1, &v) && serves(c, u, v, &c->reach[i]) &&
            c->have[v] < 2) {
            return 0;
        }
    }
    return 1;
}

static void drop(sfi_grow_cover *c, uint32_t u)
{
    c->mark[u] |= DROPPED;
    for (size_t i = 0; i < c->reach_count; i++) {
        uint32_t v;
        if (at_reach(c, u, &c->reach[i], -1, &v) && serves(c, u, v, &c->reach[i])) {
            c->have[v]--;
        }
    }
}

// Drop chosen ones that nobody depends on, the last one first.
static void drop_idle(sfi_grow_cover *c)
{
    size_t kept = 0;
    for (size_t i = c->chosen_count; i-- > 0;) {
        if (is_idle(c, c->chosen[i])) {
            drop(c, c->chosen[i]);
        }
    }
    for (size_t i = 0; i < c->chosen_count; i++) {
        uint32_t u = c->chosen[i];
        c->chosen[kept] = u;
        kept += (c->mark[u] & DROPPED) == 0;
        c->mark[u] &= (uint8_t)(NEEDY | SERVED);
    }
    c->chosen_count = kept;
}

sf_status sfi_grow_cover_choose(sfi_grow_cover *c)
{
    sf_status status = SF_OK;
    c->chosen_count = 0;
    mark_needy(c);
    for (size_t i = 0; i < c->needy_count; i++) {
        status = find_least(c, c->needy[i]) ? status : SF_ERR_INTERNAL;
        sfi_blocks_add(&c->blocks, c->needy[i], 1);
    }
    for (size_t i = 0; status == SF_OK && i < c->needy_count; i++) {
        count_looks(c, c->needy[i], 1);
    }
    take_all(c);
    drop_idle(c);
    for (size_t i = 0; i < c->needy_count; i++) {
        c->mark[c->needy[i]] = 0;
        c->have[c->needy[i]] = 0;
        sfi_blocks_add(&c->blocks, c->needy[i], UINT32_MAX);
    }
    for (size_t i = 0; i < c->words; i++) {
        c->possible[i] = 0; // all counts are zero: everybody is served
    }
    return status;
}
