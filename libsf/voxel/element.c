// SPDX-License-Identifier: MIT
// Structuring elements that are symmetric and convex along rows. Integers only; freestanding.

#include "voxel/element.h"

sf_element sf_element_box3(void)
{
    sf_element element = {1, {1, 1}};
    return element;
}

sf_element sf_element_plus3(void)
{
    sf_element element = {1, {1, 0}};
    return element;
}

int sfi_element_is_valid(const sf_element *element)
{
    if (element == NULL || element->reach_y > SF_REACH_MAX ||
        element->half_width[0] > SF_REACH_MAX) {
        return 0;
    }
    for (unsigned dy = 1; dy <= element->reach_y; dy++) {
        if (element->half_width[dy] > element->half_width[dy - 1]) {
            return 0;
        }
    }
    return 1;
}

// Largest w with (w / rx)^2 + (dy / ry)^2 <= 1, all in 1/65536 voxel: the comparison
//     (w ry)^2 + (dy rx)^2 <= (rx ry)^2
// needs 2 * 2 * 40 bits and more, so it is made on 32-bit limbs.
typedef struct limbs {
    uint32_t digit[6]; // least significant first; 192 bits
} limbs;

static limbs product(limbs a, uint64_t b)
{
    limbs result = {{0}};
    uint32_t factor[2] = {(uint32_t)b, (uint32_t)(b >> 32)};
    for (int i = 0; i < 6; i++) {
        uint64_t carry = 0;
        for (int j = 0; i + j < 6; j++) {
            uint64_t term = j < 2 ? (uint64_t)a.digit[i] * factor[j] : 0;
            uint64_t sum = result.digit[i + j] + (term & 0xffffffffu) + carry;
            result.digit[i + j] = (uint32_t)sum;
            carry = (sum >> 32) + (term >> 32);
        }
    }
    return result;
}

static limbs square_of_product(uint64_t a, uint64_t b)
{
    limbs one = {{1, 0, 0, 0, 0, 0}};
    return product(product(product(product(one, a), b), a), b);
}

static limbs sum_of(limbs a, limbs b)
{
    uint64_t carry = 0;
    for (int i = 0; i < 6; i++) {
        carry += (uint64_t)a.digit[i] + b.digit[i];
        a.digit[i] = (uint32_t)carry;
        carry >>= 32;
    }
    return a;
}

static int at_most(limbs a, limbs b)
{
    for (int i = 5; i >= 0; i--) {
        if (a.digit[i] != b.digit[i]) {
            return a.digit[i] < b.digit[i];
        }
    }
    return 1;
}

sf_status sf_element_ellipse(uint64_t rx_q16, uint64_t ry_q16, sf_element *element)
{
    const uint64_t limit = ((uint64_t)SF_REACH_MAX + 1) << 16;
    if (element == NULL) {
        return SF_ERR_ARGUMENT;
    }
    if (rx_q16 >= limit || ry_q16 >= limit) {
        return SF_ERR_OVERFLOW;
    }
    sf_element ellipse = {(uint16_t)(ry_q16 >> 16), {(uint16_t)(rx_q16 >> 16)}};
    limbs right = square_of_product(rx_q16, ry_q16);
    unsigned w = ellipse.half_width[0];
    for (unsigned dy = 1; dy <= ellipse.reach_y; dy++) {
        limbs vertical = square_of_product((uint64_t)dy << 16, rx_q16);
        while (w > 0 &&
               !at_most(sum_of(square_of_product((uint64_t)w << 16, ry_q16), vertical), right)) {
            w--;
        }
        ellipse.half_width[dy] = (uint16_t)w;
    }
    *element = ellipse;
    return SF_OK;
}

sf_status sf_element_sum(const sf_element *a, const sf_element *b, sf_element *sum)
{
    if (!sfi_element_is_valid(a) || !sfi_element_is_valid(b) || sum == NULL) {
        return SF_ERR_ARGUMENT;
    }
    if (a->reach_y + b->reach_y > (int)SF_REACH_MAX ||
        a->half_width[0] + b->half_width[0] > (int)SF_REACH_MAX) {
        return SF_ERR_OVERFLOW;
    }
    // Row dy of the sum is the widest pair of rows i of a and j of b with i + j = dy. By symmetry
    // and because half widths never grow, i and j of one sign are enough: |i| + |j| = |dy| at the
    // best.
    sf_element result = {(uint16_t)(a->reach_y + b->reach_y), {0}};
    for (unsigned i = 0; i <= a->reach_y; i++) {
        for (unsigned j = 0; j <= b->reach_y; j++) {
            uint16_t w = (uint16_t)(a->half_width[i] + b->half_width[j]);
            if (w > result.half_width[i + j]) {
                result.half_width[i + j] = w;
            }
        }
    }
    *sum = result;
    return SF_OK;
}
