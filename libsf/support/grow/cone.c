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
// reached at layer k and at layer k - t. For the disk it is half widths by rows,
//
//     w_t(dy) = max over 0 <= b <= min(dy, reach) of w_{t-1}(dy - b) + e(b),
//
// which is all of the sum because half widths never grow with |dy|: a summand that leads away from
// the target in y may be replaced by one that does not. What lies beyond the slice is cut off.
//
// A chain to an offset d of W_t is built from the bottom: choose a last step s in e_{k-t} with d -
// s in W_{t-1}, then go on with d - s and t - 1. By the definition of the sum there is one.
// Moreover there is one between 0 and d in both coordinates: both sets are symmetric in x and in y,
// and with (dx, dy) they hold everything nearer to an axis in its row and nearer to the middle row;
// so where a coordinate of s and of d - s have opposite signs, both can be pulled towards 0, s to 0
// or to d, without leaving their sets. So each chain is legal in every layer, its coordinates are
// monotone, and it stays within the slice since both its ends do. Among such steps the one that
// stays closest to the straight line is taken; ties fall to the shorter step in y, then in x.

#include "support/grow/cone.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "support/rule/rule.h"

#define NO_ROW UINT16_MAX

static int is_closed_form(const sf_rule *rule)
{
    return rule->kind == SF_RULE_BOX3 || rule->kind == SF_RULE_OCTAGON;
}

sfi_cone sfi_cone_create(const sf_rule *plain, uint32_t width, uint32_t height,
                         const sf_allocator *allocator)
{
    sfi_cone cone = {.rule = *plain,
                     .width = width,
                     .height = height,
                     .allocator = sfi_allocator_or_default(allocator)};
    return cone;
}

void sfi_cone_destroy(sfi_cone *cone)
{
    sfi_free_array(&cone->allocator, cone->rows, cone->capacity, sizeof *cone->rows);
    cone->rows = NULL;
    cone->capacity = 0;
}

void sfi_cone_begin(sfi_cone *cone, uint32_t top)
{
    // Disks of one height have the same windows below every layer.
    if (cone->rule.table == NULL && cone->depth > cone->kept) {
        cone->kept = cone->depth;
    }
    cone->top = top;
    cone->depth = 0;
}

// Half widths of window t >= 1.
static uint16_t *rows_of(const sfi_cone *cone, uint32_t t)
{
    return cone->rows + (size_t)(t - 1) * cone->height;
}

static uint32_t last_row(const sfi_cone *cone, const uint16_t *rows)
{
    uint32_t y = cone->height - 1;
    while (y > 0 && rows[y] == NO_ROW) {
        y--;
    }
    return y;
}

// Rows of window t from those of the window before, or from the single voxel.
static void add_element(const sfi_cone *cone, uint32_t t, const sf_element *e)
{
    const uint16_t *before = t > 1 ? rows_of(cone, t - 1) : NULL;
    uint16_t *rows = rows_of(cone, t);
    uint32_t most = cone->width - 1;
    for (uint32_t dy = 0; dy < cone->height; dy++) {
        uint32_t widest = NO_ROW;
        for (uint32_t b = 0; b <= e->reach_y && b <= dy; b++) {
            uint32_t a = before != NULL ? before[dy - b] : dy == b ? 0 : NO_ROW;
            if (a != NO_ROW) {
                uint32_t sum = a + e->half_width[b] < most ? a + e->half_width[b] : most;
                widest = widest == NO_ROW || sum > widest ? sum : widest;
            }
        }
        rows[dy] = (uint16_t)widest;
    }
}

static sf_status deepen_rows(sfi_cone *cone, const sf_element *e)
{
    size_t need;
    void *rows = cone->rows;
    if (cone->depth <= cone->kept && cone->rule.table == NULL) {
        return SF_OK;
    }
    if (!sfi_size_mul(cone->depth, cone->height, &need)) {
        return SF_ERR_OVERFLOW;
    }
    if (need > cone->capacity &&
        !sfi_grow_array(&cone->allocator, &rows, &cone->capacity, need, sizeof *cone->rows)) {
        return SF_ERR_MEMORY;
    }
    cone->rows = rows;
    add_element(cone, cone->depth, e);
    return SF_OK;
}

// More than any slice is wide or high.
#define FAR ((uint64_t)1 << 20)

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
    sfi_window window = {cone, above - below, reach_y, axis, corner, NULL};
    return window;
}

static sfi_window window_at(const sfi_cone *cone, uint32_t depth)
{
    if (is_closed_form(&cone->rule)) {
        return sum_of_steps(cone, cone->top - depth, cone->top);
    }
    sfi_window window = {cone, depth, 0, 0, 0, NULL};
    if (depth > 0) {
        window.rows = rows_of(cone, depth);
        window.reach_y = last_row(cone, window.rows);
    }
    return window;
}

sf_status sfi_cone_deepen(sfi_cone *cone, sfi_window *window)
{
    cone->depth++;
    if (!is_closed_form(&cone->rule)) {
        sf_element e;
        sf_status status = sf_rule_element(&cone->rule, cone->top - cone->depth, &e);
        status = status == SF_OK ? deepen_rows(cone, &e) : status;
        if (status != SF_OK) {
            cone->depth--;
            return status;
        }
    }
    *window = window_at(cone, cone->depth);
    return SF_OK;
}

// The last step of a window, as the window of that step alone; `e` holds its rows where it has any.
static sfi_window last_step(const sfi_window *window, sf_element *e)
{
    const sfi_cone *cone = window->cone;
    uint32_t below = cone->top - window->depth;
    if (is_closed_form(&cone->rule)) {
        return sum_of_steps(cone, below, below + 1);
    }
    (void)!sf_rule_element(&cone->rule, below, e); // the rule has served this layer already
    uint32_t reach_y = e->reach_y < cone->height ? e->reach_y : cone->height - 1;
    sfi_window step = {cone, 1, reach_y, 0, 0, e->half_width};
    return step;
}

typedef struct offset {
    uint32_t x, y;
} offset;

static uint64_t square_of_difference(uint64_t a, uint64_t b)
{
    uint64_t d = a > b ? a - b : b - a;
    return d * d;
}

// The last of `depth` steps that make d: within `step`, and such that the rest lies within
// `before`.
static offset choose_step(const sfi_window *before, const sfi_window *step, offset d,
                          uint32_t depth)
{
    offset best = {0, 0};
    uint64_t least = UINT64_MAX;
    for (uint32_t sy = 0; sy <= step->reach_y && sy <= d.y; sy++) {
        uint32_t rest = sfi_window_half_width(before, d.y - sy);
        uint32_t half = sfi_window_half_width(step, sy), most = half < d.x ? half : d.x;
        uint32_t fewest = rest != SFI_WINDOW_NONE && rest < d.x ? d.x - rest : 0;
        if (rest == SFI_WINDOW_NONE || fewest > most) {
            continue;
        }
        uint32_t sx = (2 * d.x + depth - 1) / (2 * depth); // to the nearest, halves down
        sx = sx < fewest ? fewest : sx > most ? most : sx;
        uint64_t off = square_of_difference((uint64_t)sx * depth, d.x) +
                       square_of_difference((uint64_t)sy * depth, d.y);
        if (off < least) {
            least = off;
            best.x = sx;
            best.y = sy;
        }
    }
    return best;
}

void sfi_cone_chain(const sfi_window *window, sf_voxel from, sf_voxel to, sf_voxel *chain)
{
    offset d = {to.x > from.x ? to.x - from.x : from.x - to.x,
                to.y > from.y ? to.y - from.y : from.y - to.y};
    sfi_window here = *window;
    while (here.depth > 1) {
        sf_element e;
        sfi_window step = last_step(&here, &e), before = window_at(here.cone, here.depth - 1);
        offset s = choose_step(&before, &step, d, here.depth);
        d.x -= s.x;
        d.y -= s.y;
        here = before;
        sf_voxel v = {to.x > from.x ? from.x + d.x : from.x - d.x,
                      to.y > from.y ? from.y + d.y : from.y - d.y, from.z - here.depth};
        chain[here.depth - 1] = v;
    }
}
