// SPDX-License-Identifier: MIT
// Why: a rule is the same integers on every machine, whatever its C library's tangent says and
// however its compiler adds up. The numbers here were computed to sixty digits by another program,
// from the exact value of the double that the angle is; none of them lies within 10^-5 of the next
// integer, where doubles could not tell.

#include "test.h"

#include <sf/support.h>

static const struct {
    double degrees;
    uint64_t octagon; // layers of 0.1 mm on pixels of 0.05 mm
    uint64_t x, y;    // disk: layers of 0.5 mm on pixels of 0.03 by 0.04 mm
} golden[] = {
    {5, 2935632, 24463603, 18347702},        {10, 5916551, 49304597, 36978448},
    {20, 12212814, 101773453, 76330090},     {30, 19372660, 161438836, 121079127},
    {35.25, 23713927, 197616066, 148212049}, {45, 33554432, 279620266, 209715200},
    {50, 39988614, 333238457, 249928843},    {54.75, 47478423, 395653525, 296740144},
    {60, 58117981, 484316508, 363237381},    {70, 92190044, 768250368, 576187776},
    {80, 190296640, 1585805334, 1189354001}, {85, 383528912, 3196074272, 2397055704},
};

static void rules_are_the_same_integers_everywhere(void)
{
    const sf_lattice square = {9, 9, 9, 0.05, 0.05, 0.1, NULL, {0, 0, 0}};
    const sf_lattice oblong = {9, 9, 9, 0.03, 0.04, 0.5, NULL, {0, 0, 0}};
    for (size_t i = 0; i < sizeof golden / sizeof *golden; i++) {
        double angle_rad = golden[i].degrees * (3.14159265358979323846 / 180.0);
        sf_rule rule;
        CHECK_EQ(sf_rule_make(SF_RULE_OCTAGON, angle_rad, &square, NULL, &rule, NULL), SF_OK);
        CHECK_EQ(rule.reach_x_q24, golden[i].octagon);
        CHECK_EQ(rule.reach_y_q24, golden[i].octagon);
        CHECK_EQ(sf_rule_make(SF_RULE_DISK, angle_rad, &oblong, NULL, &rule, NULL), SF_OK);
        CHECK_EQ(rule.reach_x_q24, golden[i].x);
        CHECK_EQ(rule.reach_y_q24, golden[i].y);
    }
}

int main(void)
{
    TEST(rules_are_the_same_integers_everywhere);
    return test_finish();
}
