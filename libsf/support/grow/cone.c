// SPDX-License-Identifier: MIT
// The downward cone: which voxels t layers below can carry a voxel, through empty space.
//
// Window t below a voxel of layer k is the Minkowski sum of the elements e of the steps from layers
// k-1, ..., k-t:
//
//     W_0 = { 0 },   W_t = W_{t-1} + e_{k-t}.
//
// The sum of m pluses and n squares is { |dx|, |dy| <= m + n, |dx| + |dy| <= m + 2n } (rule.c), so
// for box3 and octagon a window is two numbers, A = the sum of m + n and B = the sum of n:
// { |dx|, |dy| <= A, |dx| + |dy| <= A + B }, and both are differences of what the schedule has
// reached at layer k and at layer k - t. For the disk it is kept by rows, and under slack a window
// is what the steps reach within the cap (fringe.c). What lies beyond the slice is cut off.
//
// A chain to an offset d of W_t is built from the bottom: choose a last step s in e_{k-t} with d -
// s in W_{t-1}, then go on with d - s and t - 1. By the definition of the sum there is one.
// Moreover there is one between 0 and d in both coordinates: both sets are symmetric in x and in y,
// and with (dx, dy) they hold everything nearer to an axis in its row and nearer to the middle row;
// so where a coordinate of s and of d - s have opposite signs, both can be pulled towards 0, s to 0
// or to d, without leaving their sets. So each chain is legal in every layer, its coordinates are
// monotone, and it stays within the slice since both its ends do. Among such steps the one that
// stays closest to the straight line is taken; ties fall to the shorter step in y, then in x. Under
// slack, among those that ask for no more than the window says.

#include "support/grow/cone.h"

#include "base/status.h"

// More than any slice is wide or high.
#define FAR ((uint64_t)1 << 20)

static int is_closed_form(const sf_rule *rule)
{
    return rule->kind == SF_RULE_BOX3 || rule->kind == SF_RULE_OCTAGON;
}

sf_status sfi_cone_create(const sf_rule *plain, uint32_t width, uint32_t height,
                          const sf_allocator *allocator, sfi_cone *cone)
{
    sfi_cone made = {.rule = *plain, .width = width, .height = height};
    if (!is_closed_form(plain)) {
        SF_TRY(sfi_fringe_create(plain, width, height, allocator, &made.fringe));
    }
    *cone = made;
    return SF_OK;
}

void sfi_cone_destroy(sfi_cone *cone)
{
    sfi_fringe_destroy(&cone->fringe);
}

sf_status sfi_cone_prepare(sfi_cone *cone, uint32_t depth)
{
    return cone->fringe.is_lasting ? sfi_fringe_deepen(&cone->fringe, depth) : SF_OK;
}

void sfi_cone_begin(sfi_cone *cone, uint32_t top)
{
    cone->top = top;
    cone->depth = cone->surplus = 0;
    if (!is_closed_form(&cone->rule)) {
        sfi_fringe_begin(&cone->fringe, top);
    }
}

// ---------------------------------------------------------------------------------------------
// Windows
// ---------------------------------------------------------------------------------------------

// What the steps between two layers add up to, in closed form.
static sfi_window sum_of_steps(const sfi_cone *cone, uint32_t below, uint32_t above)
{
    uint64_t a0, b0, a1, b1;
    sfi_rule_sums(&cone->rule, below, &a0, &b0);
    sfi_rule_sums(&cone->rule, above, &a1, &b1);
    uint64_t axis = a1 - a0, corner = axis + (b1 - b0);
    axis = axis < FAR ? axis : FAR;
    corner = corner < 2 * FAR ? corner : 2 * FAR;
    uint32_t reach_y = axis < cone->height ? (uint32_t)axis : cone->height - 1;
    sfi_window window = {cone, above - below, reach_y, axis, corner, NULL, NULL, 0};
    return window;
}

static sfi_window window_of_rows(const sfi_cone *cone, uint32_t depth, uint32_t surplus)
{
    const sfi_fringe *f = &cone->fringe;
    const sfi_fringe_window *w = &f->windows[depth];
    sfi_window window = {cone, depth,  w->rows[surplus] - 1, 0, 0, f->rows + w->first_row,
                         NULL, surplus};
    window.demands = f->demands != NULL ? f->demands + w->first_demand : NULL;
    return window;
}

// By how much the gain of a voxel's step down is more than that of the windows that all voxels
// share, modulo 2^32; it may be less, but the sum over all steps is 0 or 1.
static uint32_t surplus_of_step(const sfi_cone *cone, uint32_t depth)
{
    const sfi_fringe *f = &cone->fringe;
    return f->is_lasting ? sfi_fringe_gain(f, cone->top - depth) - sfi_fringe_gain(f, depth - 1)
                         : 0;
}

sf_status sfi_cone_deepen(sfi_cone *cone, sfi_window *window)
{
    uint32_t depth = cone->depth + 1;
    if (is_closed_form(&cone->rule)) {
        *window = sum_of_steps(cone, cone->top - depth, cone->top);
    } else {
        SF_TRY(sfi_fringe_deepen(&cone->fringe, depth));
        cone->surplus += surplus_of_step(cone, depth);
        *window = window_of_rows(cone, depth, cone->surplus);
    }
    cone->depth = depth;
    return SF_OK;
}

static sfi_window shorten(const sfi_window *window)
{
    const sfi_cone *cone = window->cone;
    if (is_closed_form(&cone->rule)) {
        return sum_of_steps(cone, cone->top - window->depth + 1, cone->top);
    }
    uint32_t surplus = window->surplus - surplus_of_step(cone, window->depth);
    return window_of_rows(cone, window->depth - 1, surplus);
}

// ---------------------------------------------------------------------------------------------
// Chains
// ---------------------------------------------------------------------------------------------

typedef struct offset {
    uint32_t x, y;
} offset;

// The step of an element, whatever its rule.
typedef struct step {
    uint32_t reach_y;
    uint64_t axis, corner;      // closed form
    const uint16_t *half_width; // or by rows
    sf_element element;
    uint32_t gain;
} step;

static void last_step(const sfi_window *window, step *s)
{
    const sfi_cone *cone = window->cone;
    uint32_t below = cone->top - window->depth;
    s->half_width = NULL;
    if (is_closed_form(&cone->rule)) {
        sfi_window one = sum_of_steps(cone, below, below + 1);
        s->reach_y = one.reach_y;
        s->axis = one.axis;
        s->corner = one.corner;
        return;
    }
    (void)!sfi_fringe_element(&cone->fringe, below, &s->element); // has served this layer already
    s->half_width = s->element.half_width;
    s->reach_y = s->element.reach_y;
    s->gain = sfi_fringe_gain(&cone->fringe, below);
}

static uint32_t step_half_width(const step *s, uint32_t dy)
{
    if (s->half_width != NULL) {
        return s->half_width[dy];
    }
    return (uint32_t)(s->corner - dy < s->axis ? s->corner - dy : s->axis);
}

static uint64_t square_of_difference(uint64_t a, uint64_t b)
{
    uint64_t d = a > b ? a - b : b - a;
    return d * d;
}

// How far a step is from the straight line of `depth` steps to d.
static uint64_t stray(offset s, offset d, uint32_t depth)
{
    return square_of_difference((uint64_t)s.x * depth, d.x) +
           square_of_difference((uint64_t)s.y * depth, d.y);
}

// The last of the steps that make d: within its element, and such that the rest lies within
// `before`.
static offset choose_step(const sfi_window *before, const step *last, offset d)
{
    offset best = {0, 0};
    uint32_t depth = before->depth + 1;
    uint64_t least = UINT64_MAX;
    for (uint32_t sy = 0; sy <= last->reach_y && sy <= d.y; sy++) {
        uint32_t rest = sfi_window_half_width(before, d.y - sy);
        uint32_t half = step_half_width(last, sy), most = half < d.x ? half : d.x;
        uint32_t fewest = rest != SFI_WINDOW_NONE && rest < d.x ? d.x - rest : 0;
        if (rest == SFI_WINDOW_NONE || fewest > most) {
            continue;
        }
        uint32_t sx = (2 * d.x + depth - 1) / (2 * depth); // to the nearest, halves down
        offset s = {sx < fewest ? fewest : sx > most ? most : sx, sy};
        uint64_t off = stray(s, d, depth);
        if (off < least) {
            least = off;
            best = s;
        }
    }
    return best;
}

// The same under slack: and such that the chain asks no more of its end than `here` says.
static offset choose_carried_step(const sfi_window *here, const sfi_window *before,
                                  const step *last, offset d)
{
    offset best = {0, 0};
    uint32_t asked = sfi_window_demand(here, d.x, d.y);
    uint64_t least = UINT64_MAX;
    for (uint32_t sy = 0; sy <= last->reach_y && sy <= d.y; sy++) {
        uint32_t rest = sfi_window_half_width(before, d.y - sy);
        for (uint32_t sx = 0; sx <= step_half_width(last, sy) && sx <= d.x; sx++) {
            offset s = {sx, sy};
            uint64_t off = stray(s, d, here->depth);
            if (rest == SFI_WINDOW_NONE || d.x - sx > rest || off >= least ||
                sfi_window_demand(before, d.x - sx, d.y - sy) +
                        sfi_fringe_cost(&here->cone->fringe, sx, sy) >
                    asked + last->gain) {
                continue;
            }
            least = off;
            best = s;
        }
    }
    return best;
}

void sfi_cone_chain(const sfi_window *window, sf_voxel from, sf_voxel to, sf_voxel *chain)
{
    offset d = {to.x > from.x ? to.x - from.x : from.x - to.x,
                to.y > from.y ? to.y - from.y : from.y - to.y};
    int has_slack = window->cone->rule.kind == SF_RULE_SLACK;
    sfi_window here = *window;
    while (here.depth > 1) {
        step last;
        last_step(&here, &last);
        sfi_window before = shorten(&here);
        offset s = has_slack ? choose_carried_step(&here, &before, &last, d)
                             : choose_step(&before, &last, d);
        d.x -= s.x;
        d.y -= s.y;
        here = before;
        sf_voxel v = {to.x > from.x ? from.x + d.x : from.x - d.x,
                      to.y > from.y ? from.y + d.y : from.y - d.y, from.z - here.depth};
        chain[here.depth - 1] = v;
    }
}
