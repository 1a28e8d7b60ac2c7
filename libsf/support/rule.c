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

#include "support/rule.h"

#include "base/status.h"

#define REACH_LARGEST ((uint64_t)SF_REACH_MAX * SFI_REACH_ONE)

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

static void octagon(uint64_t reach_below, uint64_t reach_above, sf_element *element)
{
    uint64_t a0, b0, a1, b1;
    schedule(reach_below, &a0, &b0);
    schedule(reach_above, &a1, &b1);
    uint32_t axis = (uint32_t)(a1 - a0);
    uint32_t corner = axis + (uint32_t)(b1 - b0);
    element->reach_y = (uint16_t)axis;
    for (uint32_t dy = 0; dy <= axis; dy++) {
        element->half_width[dy] = (uint16_t)(corner - dy < axis ? corner - dy : axis);
    }
}

// A reach in whole voxels, rounded up, as an ellipse takes its radius.
static uint64_t whole_q16(uint64_t reach_q24)
{
    return (reach_q24 + SFI_REACH_ONE - 1) >> 24 << 16;
}

// All that a step under slack can reach: the ellipse of its reach, rounded up, for a chain to keep
// up with the reach along each axis; and the 5x5 without corners.
static sf_status slack_element(uint64_t x_q24, uint64_t y_q24, sf_element *element)
{
    static const uint16_t around[3] = {2, 2, 1};
    SF_TRY(sf_element_ellipse(whole_q16(x_q24), whole_q16(y_q24), element));
    for (uint16_t dy = 0; dy < 3; dy++) {
        if (dy > element->reach_y) {
            element->half_width[dy] = 0;
        }
        if (element->half_width[dy] < around[dy]) {
            element->half_width[dy] = around[dy];
        }
    }
    element->reach_y = element->reach_y < 2 ? 2 : element->reach_y;
    return SF_OK;
}

// Whether the numbers that slack counts in are there. The last byte but one is for the cap: a code
// is 1 + slack.
static int is_slack_good(const sf_rule *rule)
{
    return rule->kind != SF_RULE_SLACK ||
           (rule->slack_x > 0 && rule->slack_y > 0 && rule->slack_cap > 0 && rule->slack_cap < 255);
}

static int is_bridge_good(const sf_bridge *b)
{
    return b->span_x <= SF_BRIDGE_SPAN_MAX && b->span_y <= SF_BRIDGE_SPAN_MAX &&
           b->span_diagonal <= SF_BRIDGE_SPAN_MAX && b->anchor_x <= SF_BRIDGE_SPAN_MAX &&
           b->anchor_y <= SF_BRIDGE_SPAN_MAX && b->anchor_diagonal <= SF_BRIDGE_SPAN_MAX;
}

static int is_uniform_rule_good(const sf_rule *rule)
{
    if (rule->reach_x_q24 > REACH_LARGEST || rule->reach_y_q24 > REACH_LARGEST) {
        return 0;
    }
    return rule->kind != SF_RULE_OCTAGON || rule->reach_x_q24 == rule->reach_y_q24;
}

// Whether entries k and k + 1 of the table make a step.
static int is_table_step_good(const sf_rule *rule, uint32_t k)
{
    uint32_t count = rule->table_count;
    if (count < 2 || k > count - 2) {
        return 0;
    }
    const uint64_t *x = rule->table, *y = x + count;
    if (rule->kind == SF_RULE_SLACK &&
        (y[k + 1] > INT64_MAX || y[k] > y[k + 1] || y[k + 1] - y[k] > REACH_LARGEST)) {
        return 0;
    }
    if (rule->kind == SF_RULE_OCTAGON || rule->kind == SF_RULE_SLACK) {
        return x[k + 1] <= INT64_MAX && x[k] <= x[k + 1] && x[k + 1] - x[k] <= REACH_LARGEST;
    }
    return x[k] <= REACH_LARGEST && y[k] <= REACH_LARGEST;
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
        uint64_t below = table != NULL ? table[k] : k * rule->reach_x_q24;
        uint64_t above = table != NULL ? table[k + 1] : below + rule->reach_x_q24;
        octagon(below, above, element);
    } else if (rule->kind == SF_RULE_SLACK && table != NULL) {
        const uint64_t *y = table + rule->table_count;
        return slack_element(table[k + 1] - table[k], y[k + 1] - y[k], element);
    } else if (rule->kind == SF_RULE_SLACK) {
        return slack_element(rule->reach_x_q24, rule->reach_y_q24, element);
    } else {
        uint64_t x = table != NULL ? table[k] : rule->reach_x_q24;
        uint64_t y = table != NULL ? table[rule->table_count + k] : rule->reach_y_q24;
        return sf_element_ellipse(x >> 8, y >> 8, element);
    }
    return SF_OK;
}
