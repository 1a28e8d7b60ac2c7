// SPDX-License-Identifier: MIT
// Slack: an exact overhang angle, kept as the reach that each living voxel has to spare.
//
// Let rho_k be the reach of a step from layer k, h_k tan(angle), and |v - u| the distance of two
// voxels in the plane, both in mm. Then
//
//     s_{k+1}(v) = min(cap, max over u in N(v), alive:  s_k(u) + rho_k - |v - u|)
//
// and v is alive when that is not negative; on the bed s = cap. A chain of L steps from a voxel
// with slack c reaches at most c + rho_k + ... + rho_{k+L-1} <= cap + P_{k+L} - P_k: the asked
// cone, and the cap on top of it once. s is monotone in the shape, so trimming by it is exact in
// one sweep. The rule does not depend on where layer 0 lies but for the rounding of rho.
//
// N(v) must reach as far as a step does along each axis, and to the next whole voxel, or a steep
// angle could not be reached; and with 3x3 alone the steps make an octagon of the cone, 8 % short
// between axis and diagonal. So N is the ellipse of the step and the 5x5 without its corners, whose
// knight moves leave 3 % (on oblong pixels up to 8 %). The cap is the longest distance in any N,
// for a step to be possible after however long a wall.
//
// Numbers: a unit is such that the cap is at most 254 and a voxel's code, 1 + s, fits a byte.
// Distances are rounded up to units; reaches are rounded as sums, floor(P_{k+1}) - floor(P_k), so
// that thousands of steps lose less than one unit. Both err to the safe side.
//
// Freestanding: integers, no memory.
//
// Source: chamfer distances of this kind are G. Borgefors, "Distance Transformations in Digital
// Images", CVGIP 34, 1986; the field itself is the library's own.

#include "support/carry.h"
#include "support/rule.h"

// The least r with r * r >= n; n < 2^62.
static uint32_t root_up(uint64_t n)
{
    uint64_t low = 0, high = UINT64_C(1) << 31;
    while (low < high) {
        uint64_t middle = (low + high) / 2;
        if (middle * middle >= n) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return (uint32_t)low;
}

uint32_t sfi_slack_cost(const sf_rule *rule, uint32_t dx, uint32_t dy)
{
    uint64_t x = (uint64_t)dx * rule->slack_x, y = (uint64_t)dy * rule->slack_y;
    return root_up(x * x + y * y);
}

// Units in a reach of q24 / 2^24 voxels, rounded down.
static uint64_t to_units(uint64_t q24, uint32_t units)
{
    return (q24 >> 24) * units + (((q24 & (SFI_REACH_ONE - 1)) * units) >> 24);
}

uint32_t sfi_slack_gain(const sf_rule *rule, uint32_t k)
{
    // The shorter pitch is a whole number of units, the longer may have been rounded up.
    int by_x = rule->slack_x <= rule->slack_y;
    uint32_t units = by_x ? rule->slack_x : rule->slack_y;
    uint64_t step = by_x ? rule->reach_x_q24 : rule->reach_y_q24;
    const uint64_t *table = rule->table;
    if (table != NULL && !by_x) {
        table += rule->table_count;
    }
    uint64_t below = table != NULL ? table[k] : k * step;
    uint64_t above = table != NULL ? table[k + 1] : below + step;
    return (uint32_t)(to_units(above, units) - to_units(below, units));
}

// out[x] = max(out[x], the code that in[x] hands on at this cost, which is not below the gain).
static void spread_dear(uint8_t *restrict out, const uint8_t *restrict in, uint32_t count,
                        uint8_t loss)
{
    for (uint32_t x = 0; x < count; x++) {
        uint8_t code = (uint8_t)(in[x] > loss ? in[x] - loss : 0);
        out[x] = out[x] > code ? out[x] : code;
    }
}

// The same where the gain is more than the cost: dead stays dead, and nobody has more than the cap.
static void spread_cheap(uint8_t *restrict out, const uint8_t *restrict in, uint32_t count,
                         uint8_t more, uint8_t top)
{
    for (uint32_t x = 0; x < count; x++) {
        uint8_t code = (uint8_t)(in[x] < top - more ? in[x] + more : top);
        code = in[x] > 0 ? code : 0;
        out[x] = out[x] > code ? out[x] : code;
    }
}

static int is_dead(const uint8_t *codes, uint32_t count)
{
    uint8_t any = 0;
    for (uint32_t x = 0; x < count; x++) {
        any |= codes[x];
    }
    return any == 0;
}

// One row of codes below, dy rows away, into a row of codes.
static void spread_row(const sf_rule *rule, uint32_t gain, uint32_t dy, uint32_t reach,
                       const uint8_t *in, uint8_t *out, uint32_t width)
{
    uint32_t top = rule->slack_cap + 1u;
    for (uint32_t dx = 0; dx <= reach && dx < width; dx++) {
        uint32_t cost = sfi_slack_cost(rule, dx, dy), count = width - dx;
        if (cost >= gain && cost - gain > rule->slack_cap) {
            break;
        }
        for (int side = 0; side < (dx > 0 ? 2 : 1); side++) {
            uint8_t *to = side == 0 ? out : out + dx;
            const uint8_t *from = side == 0 ? in + dx : in;
            if (cost >= gain) {
                spread_dear(to, from, count, (uint8_t)(cost - gain));
            } else {
                uint32_t more = gain - cost < top ? gain - cost : top;
                spread_cheap(to, from, count, (uint8_t)more, (uint8_t)top);
            }
        }
    }
}

void sfi_slack_spread(const sf_rule *rule, uint32_t k, const sf_element *element,
                      const uint8_t *below, uint8_t *out, uint32_t width, uint32_t height)
{
    size_t stride = sfi_slack_stride(width);
    uint32_t gain = sfi_slack_gain(rule, k);
    for (size_t i = 0; i < stride * height; i++) {
        out[i] = 0;
    }
    for (uint32_t y = 0; y < height; y++) {
        const uint8_t *in = below + y * stride;
        if (is_dead(in, width)) {
            continue;
        }
        for (uint32_t dy = 0; dy <= element->reach_y; dy++) {
            uint32_t reach = element->half_width[dy];
            if (y >= dy) {
                spread_row(rule, gain, dy, reach, in, out + (y - dy) * stride, width);
            }
            if (dy > 0 && height - y > dy) {
                spread_row(rule, gain, dy, reach, in, out + (y + dy) * stride, width);
            }
        }
    }
}
