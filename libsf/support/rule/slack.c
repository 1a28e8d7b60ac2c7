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
// between axis and diagonal. So N is the ellipse of the step, its radii rounded up, and all that
// lies within a knight's move of the longer pitch: on square pixels the 5x5 without its corners,
// which leaves 3 %. The cap is the longest distance in any N, for a step to be possible after
// however long a wall.
//
// Numbers: a unit is such that the cap is at most 254 and a voxel's code, 1 + s, fits a byte.
// Distances are rounded up to units; reaches are rounded as sums, floor(P_{k+1}) - floor(P_k), so
// that thousands of steps lose less than one unit. Both err to the safe side.
//
// A step is made in blocks of 64 voxels, nearest supporters first, and ends for a block as soon as
// nobody in it can gain any more; inside a shape that is after the voxel straight below.
//
// Freestanding: integers, no memory.
//
// Source: chamfer distances of this kind are G. Borgefors, "Distance Transformations in Digital
// Images", CVGIP 34, 1986; the field itself is the library's own.

#include "support/rule/carry.h"
#include "support/rule/codes.h"
#include "support/rule/rule.h"
#include "voxel/slice.h"

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

sf_rule sfi_rule_plain(const sf_rule *rule, uint32_t layer_count)
{
    static const sf_bridge none = {0, 0, 0, 0, 0, 0};
    sf_rule plain = *rule;
    plain.bridge = none;
    if (rule->kind != SF_RULE_SLACK) {
        return plain;
    }
    uint32_t least = layer_count > 1 ? UINT32_MAX : 0;
    for (uint32_t k = 0; k + 1 < layer_count; k++) {
        uint32_t gain = sfi_slack_gain(rule, k);
        least = gain < least ? gain : least;
    }
    sf_rule disk = {.kind = SF_RULE_DISK,
                    .reach_x_q24 = ((uint64_t)least << 24) / rule->slack_x,
                    .reach_y_q24 = ((uint64_t)least << 24) / rule->slack_y};
    return disk;
}

// ---------------------------------------------------------------------------------------------
// A step, by blocks of a word
// ---------------------------------------------------------------------------------------------

#define BLOCK 64

// One step, with all costs that it can ask for.
typedef struct step {
    sf_slice alive;       // below
    const uint8_t *below; // its codes
    size_t stride;
    uint32_t gain, top; // top: the code of the cap
    const sf_element *element;
    uint8_t costs[SFI_SLACK_REACH_MAX + 1][SFI_SLACK_REACH_MAX + 1]; // by dy and dx
} step;

// codes = max(codes, what `in` hands on where reaching costs more than the gain).
static void take_dear(uint8_t *restrict codes, const uint8_t *restrict in, uint8_t loss)
{
    for (uint32_t x = 0; x < BLOCK; x++) {
        uint8_t code = (uint8_t)(in[x] > loss ? in[x] - loss : 0);
        codes[x] = codes[x] > code ? codes[x] : code;
    }
}

// The same where it costs less: dead stays dead, and nobody has more than the cap.
static void take_cheap(uint8_t *restrict codes, const uint8_t *restrict in, uint8_t more,
                       uint8_t top)
{
    for (uint32_t x = 0; x < BLOCK; x++) {
        uint8_t code = (uint8_t)(in[x] < top - more ? in[x] + more : top);
        code = in[x] > 0 ? code : 0;
        codes[x] = codes[x] > code ? codes[x] : code;
    }
}

// BLOCK codes of row y from x on, x perhaps below 0 or beyond the row, where nothing is alive. The
// last word's codes past the width are zero; those of words past it are nobody's.
static const uint8_t *codes_at(const step *s, uint32_t y, int64_t x, uint8_t room[BLOCK])
{
    const uint8_t *row = s->below + y * s->stride;
    if (x >= 0 && x + BLOCK <= (int64_t)sfi_row_words(s->alive.width) * BLOCK) {
        return row + x;
    }
    for (int64_t i = 0; i < BLOCK; i++) {
        room[i] = x + i >= 0 && x + i < (int64_t)s->alive.width ? row[x + i] : 0;
    }
    return room;
}

static void take(const step *s, uint32_t y, int64_t x, uint32_t cost, uint8_t *codes)
{
    uint8_t room[BLOCK];
    const uint8_t *in = codes_at(s, y, x, room);
    if (cost >= s->gain) {
        take_dear(codes, in, (uint8_t)(cost - s->gain));
    } else {
        uint32_t more = s->gain - cost < s->top ? s->gain - cost : s->top;
        take_cheap(codes, in, (uint8_t)more, (uint8_t)s->top);
    }
}

// The least code among those that are wanted, of which there is one.
static uint32_t least_code(const uint8_t *codes, const uint8_t *wanted)
{
    uint8_t least = 255;
    for (uint32_t x = 0; x < BLOCK; x++) {
        uint8_t code = codes[x] | wanted[x];
        least = least < code ? least : code;
    }
    return least;
}

// Whether anything is alive in a row within a word of the block of word i: no voxel reaches
// farther.
static int is_near(const uint64_t *row, size_t words, size_t i)
{
    return (row[i] | (i > 0 ? row[i - 1] : 0) | (i + 1 < words ? row[i + 1] : 0)) != 0;
}

// What row `from` hands on to the block at x, dy rows away. As soon as none of the wanted could
// gain by what is left, which is never more than the cap less what it costs, it is done.
static void take_row(const step *s, uint32_t x, uint32_t from, uint32_t dy, const uint8_t *wanted,
                     uint8_t *codes)
{
    uint32_t cap = s->top - 1;
    for (uint32_t dx = 0; dx <= s->element->half_width[dy]; dx++) {
        uint32_t cost = s->costs[dy][dx], loss = cost > s->gain ? cost - s->gain : 0;
        if (loss > cap || least_code(codes, wanted) >= s->top - loss) {
            return; // and farther off it costs more
        }
        take(s, from, (int64_t)x + dx, cost, codes);
        if (dx > 0) {
            take(s, from, (int64_t)x - dx, cost, codes);
        }
    }
}

// Codes of the block of word i of row y. wanted is 0 where a code is asked for, else 255.
static void take_around(const step *s, size_t i, uint32_t y, const uint8_t *wanted, uint8_t *codes)
{
    uint32_t x = (uint32_t)i * BLOCK;
    size_t words = sfi_row_words(s->alive.width);
    for (uint32_t dy = 0; dy <= s->element->reach_y; dy++) {
        if (y >= dy && is_near(sfi_slice_row(s->alive, y - dy), words, i)) {
            take_row(s, x, y - dy, dy, wanted, codes);
        }
        if (dy > 0 && s->alive.height - y > dy &&
            is_near(sfi_slice_row(s->alive, y + dy), words, i)) {
            take_row(s, x, y + dy, dy, wanted, codes);
        }
    }
}

static void begin_step(step *s, const sf_rule *rule, uint32_t k, const sfi_front *below,
                       const sf_element *element)
{
    s->alive = below->alive;
    s->below = below->slack;
    s->stride = sfi_slack_stride(below->alive.width);
    s->gain = sfi_slack_gain(rule, k);
    s->top = rule->slack_cap + 1u;
    s->element = element;
    for (uint32_t dy = 0; dy <= element->reach_y && dy <= SFI_SLACK_REACH_MAX; dy++) {
        for (uint32_t dx = 0; dx <= element->half_width[dy] && dx <= SFI_SLACK_REACH_MAX; dx++) {
            uint32_t cost = sfi_slack_cost(rule, dx, dy);
            s->costs[dy][dx] = (uint8_t)(cost < 255 ? cost : 255);
        }
    }
}

// The word of living voxels of the block of word i of row y, and their codes. An exempt voxel has a
// code of 1 at least, and that of a voxel that is not wanted becomes 0.
static uint64_t block_front(const step *s, uint32_t y, size_t i, uint64_t solid, uint64_t exempt,
                            uint8_t *codes)
{
    uint8_t wanted[BLOCK];
    uint64_t alive = 0;
    if (solid == 0) {
        for (unsigned b = 0; b < BLOCK; b++) {
            codes[b] = 0;
        }
        return 0;
    }
    for (unsigned b = 0; b < BLOCK; b += 8) {
        sfi_store_bytes(wanted + b, ~sfi_spread_bits(solid >> b));
        sfi_store_bytes(codes + b, sfi_spread_bits(exempt >> b) & UINT64_C(0x0101010101010101));
    }
    take_around(s, i, y, wanted, codes);
    for (unsigned b = 0; b < BLOCK; b += 8) {
        uint64_t eight = sfi_load_bytes(codes + b) & ~sfi_load_bytes(wanted + b);
        sfi_store_bytes(codes + b, eight);
        alive |= sfi_gather_bytes(eight) << b;
    }
    return alive;
}

void sfi_slack_step(const sf_rule *rule, uint32_t k, const sf_element *element,
                    const sfi_front *below, sf_slice solid, sf_slice exempt, sfi_front front)
{
    size_t words = sfi_row_words(solid.width);
    uint64_t tail = sfi_tail_mask(solid.width);
    step s;
    begin_step(&s, rule, k, below, element);
    for (uint32_t y = 0; y < solid.height; y++) {
        const uint64_t *in = sfi_slice_row(solid, y);
        const uint64_t *free = exempt.words != NULL ? sfi_slice_row(exempt, y) : NULL;
        uint64_t *out = sfi_slice_row(front.alive, y);
        uint8_t *codes = front.slack + y * s.stride;
        for (size_t i = 0; i < words; i++) {
            uint64_t here = i + 1 < words ? in[i] : in[i] & tail;
            out[i] = block_front(&s, y, i, here, free != NULL ? free[i] : 0, codes + i * BLOCK);
        }
    }
}
