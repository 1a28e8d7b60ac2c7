// SPDX-License-Identifier: MIT
// Polish: from what the multipliers chose to what the half-spaces ask, voxel by voxel.
//
// The best mixture of shapes is a few voxels away from each of them: those that the multipliers
// find neither good nor bad. So squares whose weight is close to 0 are tried first, then in ever
// wider bands. A square may be taken out where all that rests on its voxels has other supporters,
// and put in where each of its new voxels has one; voxels that other squares cover stay. That is
// asked of the shape itself, not of the forest, so ceilings that a kept block carries give up their
// struts here. Taking out goes from the top down, putting in from the bottom up, so that whole
// columns go in one pass.
//
// What is weighed is true: the body changes by the voxels that change. First, while a half-space
// does not hold, a change is taken that makes the sum of what is missing less. Then one that is
// better by the goal, as long as all hold: more mass, less, or a greater depth.
//
// That the shape stays supported: a voxel that is not `held` (interior.c) keeps a voxel of the
// shape in N below it.

#include "balance/forest/polish.h"

#include "base/bits.h"
#include "base/status.h"
#include "voxel/slice.h"

// Each band is four times as wide as the one before, from 2^-16 of the largest weight to all.
enum { BANDS = 9 };

// Half-spaces are asked to hold by this much, so that rounding does not break them; and what of a
// change is rounding.
#define GUARD 1e-11
#define TINY 1e-13

// ---------------------------------------------------------------------------------------------
// Support
// ---------------------------------------------------------------------------------------------

static int has(sf_slice s, uint32_t x, uint32_t y)
{
    return (sfi_slice_row(s, y)[x / 64] >> (x % 64) & 1) != 0;
}

static void put(sf_slice s, uint32_t x, uint32_t y, int value)
{
    uint64_t bit = UINT64_C(1) << (x % 64), *word = &sfi_slice_row(s, y)[x / 64];
    *word = value ? *word | bit : *word & ~bit;
}

static uint32_t less(uint32_t a, uint32_t by)
{
    return a > by ? a - by : 0;
}

static uint32_t more(uint32_t a, uint32_t by, uint32_t end)
{
    return end - a > by ? a + by + 1 : end;
}

// Whether a voxel of `below` lies in the element around (x, y).
static int is_carried(sf_slice below, const sf_element *e, uint32_t x, uint32_t y)
{
    for (uint32_t row = less(y, e->reach_y); row < more(y, e->reach_y, below.height); row++) {
        uint32_t w = e->half_width[row > y ? row - y : y - row];
        uint32_t x0 = less(x, w), x1 = more(x, w, below.width);
        const uint64_t *words = sfi_slice_row(below, row);
        for (size_t i = x0 / 64; i <= (x1 - 1) / 64; i++) {
            uint64_t mask = i == x0 / 64 ? ~UINT64_C(0) << (x0 % 64) : ~UINT64_C(0);
            mask &= i == (x1 - 1) / 64 ? sfi_tail_mask(x1) : ~UINT64_C(0);
            if ((words[i] & mask) != 0) {
                return 1;
            }
        }
    }
    return 0;
}

// Whether a corner of another kept square than (x, y) covers voxel (vx, vy).
static int is_covered(sf_slice kept, uint32_t width, uint32_t x, uint32_t y, uint32_t vx,
                      uint32_t vy)
{
    for (uint32_t cy = less(vy, width - 1); cy <= vy; cy++) {
        for (uint32_t cx = less(vx, width - 1); cx <= vx; cx++) {
            if ((cx != x || cy != y) && has(kept, cx, cy)) {
                return 1;
            }
        }
    }
    return 0;
}

// One change that is tried: a square, put in or taken out, and what that adds to the body.
typedef struct change {
    uint32_t k, x, y;
    int is_in;      // put in, else taken out
    uint32_t count; // of voxels that change
    sf_body body;
} change;

// Whether voxel (x, y) of the square would change.
static int changes(const sfi_polish *p, const change *c, uint32_t x, uint32_t y)
{
    const sfi_interior *in = p->places->in;
    if (c->is_in) {
        return !has(sf_grid_slice(p->shape, c->k), x, y);
    }
    return !has(sf_grid_slice(in->wall, c->k), x, y) &&
           !is_covered(sf_grid_slice(p->kept, c->k), in->width, c->x, c->y, x, y);
}

// What the change adds to the body; negative where it takes out.
static void weigh(const sfi_polish *p, change *c)
{
    const sfi_interior *in = p->places->in;
    const sf_lattice *l = &in->lattice;
    double one = l->pitch_x_mm * l->pitch_y_mm * sf_lattice_layer_height(l, c->k);
    double sum[3] = {0, 0, 0};
    for (uint32_t y = c->y; y < c->y + in->width; y++) {
        for (uint32_t x = c->x; x < c->x + in->width; x++) {
            if (changes(p, c, x, y)) {
                size_t at = ((size_t)c->k * l->ny + y) * l->nx + x;
                double m = p->density != NULL ? p->density[at] : 1;
                sum[0] += m;
                sum[1] += m * (l->origin_mm[0] + (x + 0.5) * l->pitch_x_mm);
                sum[2] += m * (l->origin_mm[1] + (y + 0.5) * l->pitch_y_mm);
                c->count++;
            }
        }
    }
    one = c->is_in ? one : -one;
    sf_body body = {one * sum[0],
                    {one * sum[1], one * sum[2], one * sum[0] * p->places->z_mm[c->k]}};
    c->body = body;
}

// Make the change's voxels, as far as they change, solid or empty.
static void apply(const sfi_polish *p, const change *c, int value)
{
    const sfi_interior *in = p->places->in;
    sf_slice shape = sf_grid_slice(p->shape, c->k);
    for (uint32_t y = c->y; y < c->y + in->width; y++) {
        for (uint32_t x = c->x; x < c->x + in->width; x++) {
            if (c->is_in ? value : changes(p, c, x, y)) {
                put(shape, x, y, value);
            }
        }
    }
}

static sf_element step_above(const sfi_interior *in, uint32_t k)
{
    sf_element e = {0, {0}};
    (void)!sf_rule_element(&in->plain, k, &e); // it served every step before
    return e;
}

// Whether each new voxel of a square has what it needs.
static int may_go_in(const sfi_polish *p, const change *c)
{
    const sfi_interior *in = p->places->in;
    sf_slice held = sf_grid_slice(in->held, c->k);
    sf_element e = c->k > 0 ? step_above(in, c->k - 1) : (sf_element){0, {0}};
    for (uint32_t y = c->y; y < c->y + in->width; y++) {
        for (uint32_t x = c->x; x < c->x + in->width; x++) {
            if (!has(held, x, y) && changes(p, c, x, y) &&
                !is_carried(sf_grid_slice(p->shape, c->k - 1), &e, x, y)) {
                return 0;
            }
        }
    }
    return 1;
}

// Whether all that rests on a square, whose voxels have been taken out, rests on others too.
static int is_spare(const sfi_polish *p, const change *c)
{
    const sfi_interior *in = p->places->in;
    if (c->k + 1 == in->lattice.nz) {
        return 1;
    }
    sf_element e = step_above(in, c->k);
    sf_slice above = sf_grid_slice(p->shape, c->k + 1), held = sf_grid_slice(in->held, c->k + 1);
    sf_slice here = sf_grid_slice(p->shape, c->k);
    uint32_t width = in->width - 1, end = more(c->y, e.reach_y + width, above.height);
    for (uint32_t y = less(c->y, e.reach_y); y < end; y++) {
        uint32_t x0 = less(c->x, e.half_width[0]);
        uint32_t x1 = more(c->x, e.half_width[0] + width, above.width);
        for (uint32_t x = x0; x < x1; x++) {
            if (has(above, x, y) && !has(held, x, y) && !is_carried(here, &e, x, y)) {
                return 0;
            }
        }
    }
    return 1;
}

// ---------------------------------------------------------------------------------------------
// What is better
// ---------------------------------------------------------------------------------------------

// What half-spaces miss at the goal's depth, in sum.
static double missing(const sfi_polish *p, const sf_body *body)
{
    double sum = 0;
    for (size_t e = 0; e < p->search->count; e++) {
        double here = sfi_lever_body(&p->search->levers[e], body) - GUARD;
        sum += here < 0 ? -here : 0;
    }
    return sum;
}

static void set_body(sfi_polish *p, sf_body body)
{
    p->body = body;
    p->missing = missing(p, &body);
    p->depth = sfi_depth_of(p->search, &body);
}

// Whether all half-spaces hold at a depth, and to spare by `guard`. The one that last did not is
// asked first: it mostly does not again.
static int all_hold(sfi_polish *p, const sf_body *body, double depth, double guard)
{
    const sfi_search *s = p->search;
    for (size_t i = 0; i < s->count; i++) {
        size_t e = i == 0 ? p->hint : i - (i <= p->hint);
        double here = sfi_lever_body(&s->levers[e], body);
        here -= depth != 0 ? depth * sfi_lever_body(&s->slopes[e], body) : 0;
        if (!(here >= guard)) {
            p->hint = e;
            return 0;
        }
    }
    return 1;
}

static int is_better(sfi_polish *p, const sf_body *after, int is_mending)
{
    sfi_forest_goal goal = p->search->goal;
    double gain = after->mass - p->body.mass;
    if (is_mending) {
        return missing(p, after) < p->missing - TINY;
    }
    if (goal == SFI_FOREST_DEEPEST) {
        return all_hold(p, after, p->depth, TINY);
    }
    return (goal == SFI_FOREST_MOST ? gain > 0 : gain < 0) && all_hold(p, after, 0, GUARD);
}

// Try a change; returns whether it was made.
static int try_change(sfi_polish *p, change *c, int is_mending)
{
    sf_slice kept = sf_grid_slice(p->kept, c->k);
    weigh(p, c);
    if (c->count == 0) {
        // Other squares cover all of it: it may go, so that those may be taken out by themselves.
        put(kept, c->x, c->y, 0);
        return 0;
    }
    sf_body after = sf_body_add(p->body, 1, c->body);
    if (!is_better(p, &after, is_mending) || (c->is_in && !may_go_in(p, c))) {
        return 0;
    }
    apply(p, c, c->is_in);
    if (!c->is_in && !is_spare(p, c)) {
        apply(p, c, 1);
        return 0;
    }
    put(kept, c->x, c->y, c->is_in);
    set_body(p, after);
    return 1;
}

// ---------------------------------------------------------------------------------------------
// Passes
// ---------------------------------------------------------------------------------------------

// Which places a pass tries.
typedef struct pass_kind {
    int is_in, is_mending;
    int32_t most; // weight, either way
    uint64_t made;
} pass_kind;

static void try_row(sfi_polish *p, pass_kind *pass, uint32_t k, uint32_t y)
{
    const sfi_places *places = p->places;
    sf_slice all = sf_grid_slice(places->in->places, k), kept = sf_grid_slice(p->kept, k);
    const uint64_t *row = sfi_slice_row(all, y);
    uint32_t i = places->first[(size_t)k * places->in->lattice.ny + y];
    for (size_t w = 0; w < sfi_row_words(all.width); w++) {
        for (uint64_t word = row[w]; word != 0; word &= word - 1) {
            int32_t weight = places->weight[i++];
            uint32_t x = (uint32_t)w * 64 + sfi_lowest_bit(word);
            if (weight > pass->most || weight < -pass->most || has(kept, x, y) == pass->is_in) {
                continue;
            }
            change c = {k, x, y, pass->is_in, 0, {0, {0, 0, 0}}};
            pass->made += (uint64_t)try_change(p, &c, pass->is_mending);
        }
    }
}

static sf_status make_pass(sfi_polish *p, pass_kind *pass)
{
    const sfi_interior *in = p->places->in;
    for (uint32_t j = 0; j < in->lattice.nz; j++) {
        uint32_t k = pass->is_in ? j : in->lattice.nz - 1 - j;
        if (sf_task_is_cancelled(in->task)) {
            return SF_ERR_CANCELLED;
        }
        for (uint32_t y = 0; y < in->lattice.ny; y++) {
            if (pass->is_mending && p->missing <= 0) {
                return SF_OK;
            }
            try_row(p, pass, k, y);
        }
    }
    return SF_OK;
}

// Passes from band to band: out and in, or one of them.
static sf_status make_passes(sfi_polish *p, int is_mending, int out, int in)
{
    for (int band = 0; band < BANDS; band++) {
        int32_t most = SFI_PLACE_WEIGHT >> 2 * (BANDS - 1 - band);
        pass_kind passes[2] = {{0, is_mending, most, 0}, {1, is_mending, most, 0}};
        if (is_mending && p->missing <= 0) {
            return SF_OK;
        }
        if (out) {
            SF_TRY(make_pass(p, &passes[0]));
        }
        if (in) {
            SF_TRY(make_pass(p, &passes[1]));
        }
    }
    return SF_OK;
}

sf_status sfi_polish_shape(sfi_polish *p)
{
    sfi_forest_goal goal = p->search->goal;
    set_body(p, p->body);
    if (goal != SFI_FOREST_DEEPEST) {
        SF_TRY(make_passes(p, 1, 1, 1));
    }
    return make_passes(p, 0, goal != SFI_FOREST_MOST, goal != SFI_FOREST_LEAST);
}
