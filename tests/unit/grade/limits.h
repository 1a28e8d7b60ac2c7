// SPDX-License-Identifier: MIT
// Cages of all kinds and their limits.

#ifndef SF_TEST_LIMITS_H
#define SF_TEST_LIMITS_H

#include "cages.h"

#include <sf/limit.h>

static inline sf_limit *limit_of(const test_cage *c, sf_refine_rules rules)
{
    sf_cage *cage = test_cage_make(c);
    sf_limit *limit = NULL;
    CHECK_EQ(sf_limit_create(cage, rules, NULL, NULL, &limit), SF_OK);
    sf_cage_destroy(cage);
    return limit;
}

// Cages of all kinds: regular, around a line, of wedges, with creases of all strengths.
enum { KINDS = 9 };

static inline test_cage kind_of(int kind)
{
    test_cage c;
    if (kind == 0) {
        c = test_cage_block(3, 3, 3);
    } else if (kind < 5) {
        static const uint32_t around[4] = {3, 5, 6, 8};
        c = test_cage_wheel(around[kind - 1], 3, 0.2);
    } else if (kind == 5) { // wedges around a line
        c = test_cage_begin(3, 14, 6, 6);
        for (uint32_t i = 0; i < 14; i++) {
            uint32_t k = i % 7;
            test_cage_place(&c, i, k == 0 ? 0 : cos(k), k == 0 ? 0 : sin(k), i / 7);
        }
        for (uint32_t i = 0; i < 6; i++) {
            uint32_t wedge[6] = {0, 1 + i, 1 + (i + 1) % 6, 7, 8 + i, 8 + (i + 1) % 6};
            memcpy(c.corners + 6 * (size_t)i, wedge, sizeof wedge);
        }
    } else { // a cube with creases: for ever all around, for a while, and in part
        static const uint32_t ends[4][2] = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
        c = test_cage_block(1, 1, 1);
        for (int i = 0; i < 4; i++) {
            sf_crease crease = {{ends[i][0], ends[i][1]},
                                kind == 6   ? SF_SHARP
                                : kind == 7 ? 2
                                            : 1.4};
            c.crease[c.creases++] = crease;
        }
        if (kind == 8) {
            c.sharp[0].point = 7;
            c.sharp[0].sharpness = 0.7;
            c.sharps = 1;
        }
    }
    c.values = calloc(c.points, sizeof *c.values);
    for (size_t i = 0; i < c.points; i++) {
        c.values[i] = test_random_unit();
    }
    return c;
}

static inline sf_place random_place(const sf_limit *limit)
{
    sf_place place = {test_random_below((uint32_t)sf_limit_piece_count(limit)), {0, 0, 0}};
    for (int axis = 0; axis < 3; axis++) {
        uint32_t kind = test_random_below(4); // also on sides, and close to them
        double x = test_random_unit();
        place.u[axis] = kind == 0 ? x < 0.5 ? 0 : 1 : kind == 1 ? x * 0x1p-12 : x;
    }
    return place;
}

#endif
