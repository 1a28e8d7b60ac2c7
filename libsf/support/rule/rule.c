// SPDX-License-Identifier: MIT
// Rules: the element of each step, in integers.
//
// A rule answers one question: slice k + 1 must lie within slice k dilated by which element? Three
// answers are served.
//
// Box3 is the 3x3 square at every step.
//
// Octagon approximates the disk of a radius that is no whole number of voxels by a schedule. Step k
// is the Minkowski sum of m pluses and n squares, and the sum over many steps is an octagon. Let
// P_k be the reach from layer 0 to layer k. With
//
//     a_k = floor(cos(22.5) P_k + 1/2)        pluses and squares up to layer k
//     b_k = floor(a_k / (1 + sqrt 2) + 1/2)   squares among them
//
// steps k .. k + L - 1 sum up to the octagon with vertices (A, B), (B, A), ..., A = a_{k+L} - a_k
// and B = b_{k+L} - b_k: a regular one whose vertices lie at the asked reach P = P_{k+L} - P_k and
// whose sides lie inside it. Rounding adds less than a voxel to A and less than a voxel to B - A /
// (1 + sqrt 2), and both at once no more than
//
//     sup over n of sqrt(n^2 + ceil(n / (1 + sqrt 2))^2) - (n - 1) / cos(22.5) < 1.502 voxel,
//
// attained at n = 5: A >= n asks for P > (n - 1) / cos(22.5), and B <= ceil(A / (1 + sqrt 2)). No
// chain of any length in any direction exceeds the asked cone by more. Because P_k counts from
// layer 0, heights may differ from layer to layer and the bound stays; because it counts from layer
// 0, the element depends on k even where they do not.
//
// The sum of m pluses and n squares is { |dx|, |dy| <= m + n, |dx| + |dy| <= m + 2n }, so it is
// written down, not summed up; tests/unit/support/rule.c holds the two together.
//
// Disk is the lattice ellipse of the step's own reach, rounded down anew in each step.
//
// Slack has no element that decides; what it has holds all that can carry, and slack.c says how
// far.
//
// Freestanding: integers of 64 bits, no memory, no floating point (that is angle.c).
//
// Source: the schedule is Bresenham's line (IBM Systems Journal 4(1), 1965) in the (m, n) plane.

#include "support/rule/rule.h"

#include "base/status.h"

#define REACH_LARGEST ((uint64_t)SF_REACH_MAX * SFI_REACH_ONE)
// A step that is the difference of two sums, each rounded, can be this much more than the step
// itself.
#define STEP_SLACK 16u

sf_rule sf_rule_box3(void)
{
    sf_rule rule = {
        .kind = SF_RULE_BOX3, .reach_x_q24 = SFI_REACH_ONE, .reach_y_q24 = SFI_REACH_ONE};
    return rule;
}

// By kind. Whoever adds a kind adds its name, and everything that reads or writes rules knows it.
static const char *const kind_names[] = {"box3", "octagon", "disk", "slack"};
enum { KIND_COUNT = sizeof kind_names / sizeof kind_names[0] };

static int is_kind(sf_rule_kind kind)
{
    return (unsigned)kind < (unsigned)KIND_COUNT;
}

const char *sf_rule_kind_name(sf_rule_kind kind)
{
    return is_kind(kind) ? kind_names[kind] : "unknown";
}

static int is_same_text(const char *a, const char *b)
{
    while (*a != '\0' && *a == *b) {
        a++;
        b++;
    }
    return *a == *b;
}

sf_status sf_rule_kind_from_name(const char *name, sf_rule_kind *kind)
{
    for (int i = 0; name != NULL && kind != NULL && i < KIND_COUNT; i++) {
        if (is_same_text(name, kind_names[i])) {
            *kind = (sf_rule_kind)i;
            return SF_OK;
        }
    }
    return SF_ERR_ARGUMENT;
}

// floor(value * factor / 2^32) without 128-bit integers; value < 2^63.
static uint64_t scale_q32(uint64_t value, uint32_t factor)
{
    return (value >> 32) * factor + (((value & 0xffffffffu) * factor) >> 32);
}

// floor(value / 2^24 + 1/2).
static uint64_t round_q24(uint64_t value)
{
    return (value + SFI_REACH_ONE / 2) >> 24;
}

// a_k and b_k of the essay, from P_k.
static void schedule(uint64_t reach, uint64_t *a, uint64_t *b)
{
    *a = round_q24(scale_q32(reach, SFI_OCTAGON_AXIS_Q32));
    *b = round_q24(scale_q32(*a << 24, SFI_OCTAGON_SQUARE_Q32));
}

void sfi_rule_sums(const sf_rule *rule, uint32_t k, uint64_t *all, uint64_t *squares)
{
    *all = *squares = k;
    if (rule->kind == SF_RULE_OCTAGON) {
        schedule(rule->table != NULL ? rule->table[k] : k * rule->reach_x_q24, all, squares);
    }
}

static void octagon(const sf_rule *rule, uint32_t k, sf_element *element)
{
    uint64_t a0, b0, a1, b1;
    sfi_rule_sums(rule, k, &a0, &b0);
    sfi_rule_sums(rule, k + 1, &a1, &b1);
    uint32_t axis = (uint32_t)(a1 - a0), corner = axis + (uint32_t)(b1 - b0);
    element->reach_y = (uint16_t)axis;
    for (uint32_t dy = 0; dy <= axis; dy++) {
        element->half_width[dy] = (uint16_t)(corner - dy < axis ? corner - dy : axis);
    }
}

// A reach in whole voxels, rounded up but for what a difference of rounded sums may be too much.
static uint64_t whole_reach(uint64_t reach_q24)
{
    return (reach_q24 + SFI_REACH_ONE - 1 - STEP_SLACK) >> 24;
}

// The largest dx >= from with (dx * x)^2 + dy_units^2 <= limit.
static uint32_t widest_within(uint32_t from, uint64_t x, uint64_t dy_units, uint64_t limit)
{
    uint32_t dx = from;
    while ((dx + 1) * x * ((dx + 1) * x) + dy_units * dy_units <= limit) {
        dx++;
    }
    return dx;
}

// All that a step under slack can reach: the ellipse of its reach, rounded up, for a chain to keep
// up with the reach along each axis; and all within a knight's move of the longer pitch, which on
// square pixels is the 5x5 without its corners.
sf_status sfi_slack_element(const sf_rule *rule, uint64_t x_q24, uint64_t y_q24,
                            sf_element *element)
{
    uint64_t x = rule->slack_x, y = rule->slack_y, longer = x > y ? x : y;
    uint64_t limit = 5 * longer * longer, rx = whole_reach(x_q24), ry = whole_reach(y_q24);
    element->reach_y = element->half_width[0] = 0;
    if (rx * x * (rx * x) > limit || ry * y * (ry * y) > limit) { // else it lies within the move
        SF_TRY(sf_element_ellipse(rx << 16, ry << 16, element));
    }
    for (uint32_t dy = 0; dy * y * (dy * y) <= limit; dy++) {
        if (dy > element->reach_y) {
            element->half_width[dy] = 0;
            element->reach_y = (uint16_t)dy;
        }
        uint32_t dx = widest_within(element->half_width[dy], x, dy * y, limit);
        element->half_width[dy] = (uint16_t)dx;
    }
    return SF_OK;
}

// Whether the numbers that slack counts in are there. Units are short enough for no step within the
// cap to reach farther than SFI_SLACK_REACH_MAX, and long enough for the cap, with 1 more, to fit a
// byte.
static int is_slack_good(const sf_rule *rule)
{
    uint64_t x = rule->slack_x, y = rule->slack_y, shorter = x < y ? x : y, longer = x < y ? y : x;
    uint64_t most = (SFI_SLACK_REACH_MAX + 1) * shorter;
    return rule->kind != SF_RULE_SLACK ||
           (5 * longer * longer < most * most && rule->slack_x >= SFI_SLACK_UNITS_MIN &&
            rule->slack_y >= SFI_SLACK_UNITS_MIN && rule->slack_x <= SFI_SLACK_CAP_MAX &&
            rule->slack_y <= SFI_SLACK_CAP_MAX && rule->slack_cap > 0 &&
            rule->slack_cap <= SFI_SLACK_CAP_MAX);
}

static int is_slack_reach_good(const sf_rule *rule, uint64_t reach_q24)
{
    return rule->kind != SF_RULE_SLACK || whole_reach(reach_q24) <= SFI_SLACK_REACH_MAX;
}

static int is_bridge_good(const sf_bridge *b)
{
    return b->span_x <= SF_BRIDGE_SPAN_MAX && b->span_y <= SF_BRIDGE_SPAN_MAX &&
           b->span_diagonal <= SF_BRIDGE_SPAN_MAX && b->anchor_x <= SF_BRIDGE_SPAN_MAX &&
           b->anchor_y <= SF_BRIDGE_SPAN_MAX && b->anchor_diagonal <= SF_BRIDGE_SPAN_MAX;
}

static int is_uniform_rule_good(const sf_rule *rule)
{
    if (rule->reach_x_q24 > REACH_LARGEST || rule->reach_y_q24 > REACH_LARGEST ||
        !is_slack_reach_good(rule, rule->reach_x_q24) ||
        !is_slack_reach_good(rule, rule->reach_y_q24)) {
        return 0;
    }
    return rule->kind != SF_RULE_OCTAGON || rule->reach_x_q24 == rule->reach_y_q24;
}

// Whether two sums of reaches make a step.
static int is_sum_step_good(const sf_rule *rule, uint64_t below, uint64_t above)
{
    return above <= INT64_MAX && below <= above && above - below <= REACH_LARGEST + STEP_SLACK &&
           is_slack_reach_good(rule, above - below);
}

// Whether entries k and k + 1 of the table make a step.
static int is_table_step_good(const sf_rule *rule, uint32_t k)
{
    uint32_t count = rule->table_count;
    if (count < 2 || k > count - 2) {
        return 0;
    }
    const uint64_t *x = rule->table, *y = x + count;
    if (rule->kind == SF_RULE_DISK) {
        return x[k] <= REACH_LARGEST && y[k] <= REACH_LARGEST;
    }
    return is_sum_step_good(rule, x[k], x[k + 1]) &&
           (rule->kind == SF_RULE_OCTAGON || is_sum_step_good(rule, y[k], y[k + 1]));
}

static int is_step_good(const sf_rule *rule, uint32_t k)
{
    if (rule == NULL || k >= SF_LAYER_MAX || !is_kind(rule->kind) || !is_slack_good(rule) ||
        !is_bridge_good(&rule->bridge)) {
        return 0;
    }
    if (rule->kind == SF_RULE_BOX3) {
        return 1;
    }
    if ((rule->table == NULL) != (rule->table_count == 0)) {
        return 0;
    }
    return rule->table == NULL ? is_uniform_rule_good(rule) : is_table_step_good(rule, k);
}

sf_status sfi_rule_check(const sf_rule *rule, uint32_t first, uint32_t layer_count)
{
    // A single slice takes no step, but the rule must still be one.
    if (rule == NULL || !is_kind(rule->kind) || !is_slack_good(rule) ||
        !is_bridge_good(&rule->bridge) || first > SF_LAYER_MAX ||
        layer_count > SF_LAYER_MAX - first) {
        return SF_ERR_ARGUMENT;
    }
    uint32_t end = first + layer_count;
    // Without a table all steps are as good as the last one.
    uint32_t k = rule->table == NULL && layer_count > 1 ? end - 2 : first;
    for (; k + 1 < end; k++) {
        if (!is_step_good(rule, k)) {
            return SF_ERR_ARGUMENT;
        }
    }
    return SF_OK;
}

sf_status sf_rule_element(const sf_rule *rule, uint32_t k, sf_element *element)
{
    if (element == NULL || !is_step_good(rule, k)) {
        return SF_ERR_ARGUMENT;
    }
    const uint64_t *table = rule->table;
    if (rule->kind == SF_RULE_BOX3) {
        *element = sf_element_box3();
    } else if (rule->kind == SF_RULE_OCTAGON) {
        octagon(rule, k, element);
    } else if (rule->kind == SF_RULE_SLACK && table != NULL) {
        const uint64_t *y = table + rule->table_count;
        return sfi_slack_element(rule, table[k + 1] - table[k], y[k + 1] - y[k], element);
    } else if (rule->kind == SF_RULE_SLACK) {
        return sfi_slack_element(rule, rule->reach_x_q24, rule->reach_y_q24, element);
    } else {
        uint64_t x = table != NULL ? table[k] : rule->reach_x_q24;
        uint64_t y = table != NULL ? table[rule->table_count + k] : rule->reach_y_q24;
        return sf_element_ellipse(x >> 8, y >> 8, element);
    }
    return SF_OK;
}
