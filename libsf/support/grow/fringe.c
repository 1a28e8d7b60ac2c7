// SPDX-License-Identifier: MIT
// Fringe: what t layers below must have to spare to carry a voxel, through empty space.
//
// Under slack let d_t(D) be the least slack that matter at offset D, t layers below a voxel, must
// have for some chain from it up to the voxel to stand. With N the element of the step, c the cost
// of reaching over an offset and g_t the gain of the t-th step down,
//
//     d_0(0) = 0,   d_t(D) = min over s in N: max(0, d_{t-1}(D - s) + c(s) - g_t),
//
// and D is out of reach where that is more than the cap. Window t is what is within reach. Most of
// it, a disk that grows by a step's reach with each layer, has d = 0: all matter there will do.
// Around it lies a ring as wide as the cap where it depends. Only the ring is kept, a byte for each
// of its voxels.
//
// N and c are symmetric in x and in y, and with an offset N holds all that is nearer to an axis, at
// less cost. So a step of a chain that leads away from its end can be pulled towards 0, and the
// other step with it: d is the same in the four quadrants, never falls with |dx| or |dy|, and a
// chain stays between its ends. One quadrant is enough, and the slice's border is in nobody's way.
//
// Where all layers have one height, N is one set and the gains differ by at most a unit, by the
// rounding of their sums. Let every cost be at most the cap, ch_t(D) the least cost of t steps of N
// (steps of 0 among them) that lead to D, and G_t the sum of their gains. Then
//
//     d_t(D) = max(0, ch_t(D) - G_t)   where that is at most the cap, else D is out of reach.
//
// It is no less: a step adds c - g or more. It is no more: make a chain of t steps of least cost,
// from the top down in this order. Let P be the sum of c - g over the steps made so far, 0 at
// first. As next make any step that is left for which P + c - g lies in 0..cap; as long as there
// are such, P is the demand. Where there is none, one of three things holds. (a) One step that is
// left is too much and one too little: then their costs differ by more than the cap, which no two
// do. (b) All are too much, P + c - g > cap >= P: each costs more than this gain, hence, in whole
// units, no less than any other gain; so P cannot fall any more, and in the end ch_t - G_t > cap.
// (c) All are too little, P + c - g < 0 <= P: each costs less than this gain, hence no more than
// any other; so P cannot rise any more, the demand neither, and in the end P < 0. Then no last
// steps of the chain add up to more than 0, which is to say that the demand is 0.
//
// ch_t knows nothing of layers, and G_t is floor(P_k) - floor(P_{k-t}), P_k now being the reach up
// to layer k: one of floor(P_t) and floor(P_t) + 1. So all voxels share one family of windows, of
// the gains floor(P_t) - floor(P_{t-1}) and a cap greater by 1; below a voxel where G_t is greater
// by 1, its surplus, each demand is less by 1. With heights that differ there is no such form (the
// cap cuts off chains that later, in thicker layers, would have made good what they lack), and the
// recursion is run below each layer that is asked about, and kept until another is.
//
// The disk is the case of no costs, no gains, no cap: d = 0 in the sum of the elements.
//
// Source: the reach of chains of few kinds of steps is the chamfer distance of G. Borgefors,
// "Distance Transformations in Digital Images", CVGIP 34, 1986.

#include "support/grow/fringe.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "support/rule/carry.h"

#define NO_DEMAND INT16_MAX

// ---------------------------------------------------------------------------------------------
// Life
// ---------------------------------------------------------------------------------------------

static int has_slack(const sfi_fringe *f)
{
    return f->rule.kind == SF_RULE_SLACK;
}

uint32_t sfi_fringe_gain(const sfi_fringe *fringe, uint32_t k)
{
    return has_slack(fringe) ? sfi_slack_gain(&fringe->rule, k) : 0;
}

sf_status sfi_fringe_element(const sfi_fringe *fringe, uint32_t k, sf_element *element)
{
    if (!fringe->is_lasting) {
        return sf_rule_element(&fringe->rule, k, element);
    }
    element->reach_y = fringe->element.reach_y; // it is long, and mostly empty
    for (uint32_t dy = 0; dy <= element->reach_y; dy++) {
        element->half_width[dy] = fringe->element.half_width[dy];
    }
    return SF_OK;
}

// The costs of a step, as slack.c takes them.
static void fill_costs(sfi_fringe *f)
{
    for (uint32_t dy = 0; dy <= SFI_SLACK_REACH_MAX; dy++) {
        for (uint32_t dx = 0; dx <= SFI_SLACK_REACH_MAX; dx++) {
            uint32_t cost = sfi_slack_cost(&f->rule, dx, dy);
            f->costs[dy][dx] = (uint8_t)(cost < 255 ? cost : 255);
        }
    }
}

// Whether the closed form holds below every layer; then the element of all steps is noted.
static int find_alike(sfi_fringe *f)
{
    sf_element *e = &f->element;
    if (f->rule.table != NULL || sf_rule_element(&f->rule, 0, e) != SF_OK) {
        return 0;
    }
    for (uint32_t dy = 0; has_slack(f) && dy <= e->reach_y; dy++) {
        if (sfi_fringe_cost(f, e->half_width[dy], dy) > f->rule.slack_cap) {
            return 0;
        }
    }
    return 1;
}

void sfi_fringe_destroy(sfi_fringe *fringe)
{
    const sf_allocator *from = &fringe->allocator;
    sfi_free_array(from, fringe->windows, fringe->window_capacity, sizeof *fringe->windows);
    sfi_free_array(from, fringe->rows, fringe->row_capacity, sizeof *fringe->rows);
    sfi_free_array(from, fringe->demands, fringe->demand_capacity, sizeof *fringe->demands);
    sfi_free_array(from, fringe->scratch, fringe->width, sizeof *fringe->scratch);
    sfi_free_array(from, fringe->costs, SFI_SLACK_REACH_MAX + 1, sizeof *fringe->costs);
    fringe->windows = NULL;
    fringe->rows = NULL;
    fringe->demands = NULL;
    fringe->scratch = NULL;
    fringe->costs = NULL;
    fringe->window_capacity = fringe->row_capacity = fringe->demand_capacity = 0;
}

// Room for a number of windows, rows and demands more.
static sf_status make_room(sfi_fringe *f, size_t windows, size_t rows, size_t demands)
{
    if (f->window_capacity > f->depth && f->window_capacity - f->depth > windows &&
        f->row_capacity - f->row_count >= rows && f->demand_capacity - f->demand_count >= demands) {
        return SF_OK;
    }
    void *w = f->windows, *r = f->rows, *d = f->demands;
    if (!sfi_size_add(f->depth, windows + 1, &windows) ||
        !sfi_size_add(f->row_count, rows, &rows) ||
        !sfi_size_add(f->demand_count, demands, &demands)) {
        return SF_ERR_OVERFLOW;
    }
    int is_done =
        sfi_grow_array(&f->allocator, &w, &f->window_capacity, windows, sizeof *f->windows);
    f->windows = w;
    is_done = is_done && sfi_grow_array(&f->allocator, &r, &f->row_capacity, rows, sizeof *f->rows);
    f->rows = r;
    is_done = is_done &&
              sfi_grow_array(&f->allocator, &d, &f->demand_capacity, demands, sizeof *f->demands);
    f->demands = d;
    return is_done ? SF_OK : SF_ERR_MEMORY;
}

// Window 0: the voxel itself.
static void forget(sfi_fringe *f)
{
    sfi_fringe_window voxel = {0, 0, {1, 1}};
    sfi_fringe_row row = {0, 1, {1, 1}};
    f->windows[0] = voxel;
    f->rows[0] = row;
    f->row_count = 1;
    f->demand_count = 0;
    f->depth = 0;
    f->is_whole = f->width == 1 && f->height == 1;
}

sf_status sfi_fringe_create(const sf_rule *plain, uint32_t width, uint32_t height,
                            const sf_allocator *allocator, sfi_fringe *fringe)
{
    sfi_fringe f = {.rule = *plain, .width = width, .height = height};
    f.allocator = sfi_allocator_or_default(allocator);
    f.scratch = sfi_alloc_array(&f.allocator, width, sizeof *f.scratch);
    if (has_slack(&f)) {
        f.costs = sfi_alloc_array(&f.allocator, SFI_SLACK_REACH_MAX + 1, sizeof *f.costs);
    }
    if (f.scratch == NULL || (has_slack(&f) && f.costs == NULL) ||
        make_room(&f, 0, 1, 0) != SF_OK) {
        sfi_fringe_destroy(&f);
        return SF_ERR_MEMORY;
    }
    if (has_slack(&f)) {
        fill_costs(&f);
    }
    f.is_lasting = find_alike(&f);
    f.most = !has_slack(&f) ? 0 : f.is_lasting ? plain->slack_cap + 1u : plain->slack_cap;
    forget(&f);
    *fringe = f;
    return SF_OK;
}

void sfi_fringe_begin(sfi_fringe *fringe, uint32_t top)
{
    if (!fringe->is_lasting && fringe->top != top) {
        forget(fringe);
    }
    fringe->top = top;
}

// ---------------------------------------------------------------------------------------------
// One window from the one before
// ---------------------------------------------------------------------------------------------

// A step, and what window it starts from.
typedef struct step {
    sf_element element;
    uint32_t gain;
    uint16_t free[SF_REACH_MAX + 1]; // by dy: the farthest dx that costs no more than the gain,
                                     // plus 1; 0 where there is none
    sfi_fringe_window before;
} step;

static sf_status begin_step(const sfi_fringe *f, uint32_t depth, step *s)
{
    // Where steps are alike, those of layers 0, 1, ... give the windows that all share.
    uint32_t k = f->is_lasting ? depth - 1 : f->top - depth;
    SF_TRY(sfi_fringe_element(f, k, &s->element));
    s->gain = sfi_fringe_gain(f, k);
    s->before = f->windows[depth - 1];
    for (uint32_t dy = 0; dy <= s->element.reach_y; dy++) {
        uint32_t n = s->element.half_width[dy] + 1u;
        while (n > 0 && sfi_fringe_cost(f, n - 1, dy) > s->gain) {
            n--;
        }
        s->free[dy] = (uint16_t)n;
    }
    return SF_OK;
}

static uint32_t lesser(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static uint32_t greater(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

// scratch[i] = what it is or, if that is less, the demand plus `add`, 0 at least.
static void lower(int16_t *restrict scratch, const uint8_t *restrict demands, uint32_t count,
                  int16_t add)
{
    for (uint32_t i = 0; i < count; i++) {
        int16_t demand = (int16_t)(demands[i] + add);
        demand = demand > 0 ? demand : 0;
        scratch[i] = demand < scratch[i] ? demand : scratch[i];
    }
}

// What the steps over dy rows from one row of the window before hand on to lo <= x < hi of a row.
static void spread(sfi_fringe *f, const step *s, const sfi_fringe_row *from, uint32_t dy,
                   uint32_t lo, uint32_t hi)
{
    const uint8_t *demands = f->demands + s->before.first_demand + from->first;
    for (uint32_t dx = 0; dx <= s->element.half_width[dy]; dx++) {
        int32_t add = (int32_t)sfi_fringe_cost(f, dx, dy) - (int32_t)s->gain;
        if (add > (int32_t)f->most) {
            break; // and farther off it costs more
        }
        uint32_t middle = from->free + dx, x1 = lesser(hi, from->reach[1] + dx);
        for (uint32_t x = lo; add > 0 && from->free > 0 && x < middle && x < hi; x++) {
            f->scratch[x] = (int16_t)(add < f->scratch[x] ? add : f->scratch[x]);
        }
        uint32_t x0 = greater(lo, middle);
        if (x0 < x1) {
            // More than the cap is of no use to anyone.
            int16_t much = (int16_t)(add > -256 ? add : -256);
            lower(f->scratch + x0, demands + (x0 - middle), x1 - x0, much);
        }
    }
}

// Row dy of the next window; reach[1] == 0 where it has none.
static sfi_fringe_row make_row(sfi_fringe *f, const step *s, uint32_t dy, size_t first_demand)
{
    const sfi_fringe_row *before = f->rows + s->before.first_row;
    uint32_t lo = 0, hi = 0, below = dy < s->element.reach_y ? 0 : dy - s->element.reach_y;
    uint32_t end = lesser(dy + 1, s->before.rows[1]);
    for (uint32_t y = below; y < end; y++) {
        uint32_t n = s->free[dy - y];
        lo = before[y].free > 0 && n > 0 ? greater(lo, before[y].free + n - 1) : lo;
        hi = greater(hi, before[y].reach[1] + s->element.half_width[dy - y]);
    }
    lo = lesser(lo, f->width);
    hi = lesser(hi, f->width);
    for (uint32_t x = lo; x < hi; x++) {
        f->scratch[x] = NO_DEMAND;
    }
    for (uint32_t y = below; y < end && lo < hi; y++) {
        spread(f, s, &before[y], dy - y, lo, hi);
    }
    uint32_t n = lo, reach[2] = {0, 0};
    while (n < hi && f->scratch[n] == 0) {
        n++;
    }
    sfi_fringe_row row = {(uint32_t)(f->demand_count - first_demand), (uint16_t)n, {0, 0}};
    reach[0] = reach[1] = n;
    for (; n < hi && f->scratch[n] <= (int32_t)f->most; n++) {
        f->demands[f->demand_count++] = (uint8_t)f->scratch[n];
        reach[1] = n + 1;
        reach[0] = f->scratch[n] <= f->rule.slack_cap ? n + 1 : reach[0];
    }
    row.reach[0] = (uint16_t)reach[0];
    row.reach[1] = (uint16_t)reach[1];
    return row;
}

// Window `depth` from the one before, with room for it. What is half done does not count.
static sf_status make_window(sfi_fringe *f, uint32_t depth, sfi_fringe_window *made)
{
    step s;
    SF_TRY(begin_step(f, depth, &s));
    uint32_t rows = lesser(s.before.rows[1] + s.element.reach_y, f->height);
    sfi_fringe_window window = {f->row_count, f->demand_count, {0, 0}};
    SF_TRY(make_room(f, 1, rows, f->width));
    int is_whole = rows == f->height;
    for (uint32_t dy = 0; dy < rows; dy++) {
        SF_TRY(make_room(f, 1, 1, f->width));
        sfi_fringe_row row = make_row(f, &s, dy, window.first_demand);
        is_whole = is_whole && row.free == f->width;
        if (row.reach[1] == 0) {
            break;
        }
        window.rows[0] += row.reach[0] > 0;
        window.rows[1]++;
        f->rows[f->row_count++] = row;
    }
    f->is_whole = is_whole;
    *made = window;
    return SF_OK;
}

sf_status sfi_fringe_deepen(sfi_fringe *fringe, uint32_t depth)
{
    while (fringe->depth < depth) {
        size_t rows = fringe->row_count, demands = fringe->demand_count;
        uint32_t next = fringe->depth + 1;
        sfi_fringe_window window;
        sf_status status;
        if (fringe->is_whole) {
            // All of it can only become all of it.
            status = make_room(fringe, 1, 0, 0);
            window = fringe->windows[fringe->depth];
        } else {
            status = make_window(fringe, next, &window);
        }
        if (status != SF_OK) {
            fringe->row_count = rows;
            fringe->demand_count = demands;
            return status;
        }
        fringe->windows[next] = window;
        fringe->depth = next;
    }
    return SF_OK;
}
