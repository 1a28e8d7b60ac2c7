// SPDX-License-Identifier: MIT
// TRUST items 1, 2, 3, 4, 5, 15, 18, 23: what trimming is. It takes nothing it need not, ends in a
// support-free stack, is the largest of these, follows chains to the bed, grows with the shape and
// with the rule, and looks down only. Each over all stacks of some tiny sizes; 23 on random ones.
// Beyond the list: with a bed that the shape chooses itself item 5 fails, which is why laws are
// stated for a given bed.

#include "tiny.h"

static void for_all(void (*law)(const tiny *), int nx, int ny, int nz)
{
    sf_rule rules[] = {sf_rule_box3(), rule_of_radius(1), rule_of_radius(0),
                       rule_of_angle(SF_RULE_OCTAGON, 30.0)};
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        tiny t = tiny_new(nx, ny, nz, &rules[i]);
        law(&t);
        tiny_delete(&t);
    }
}

static uint32_t chains(const tiny *t, uint32_t s)
{
    uint32_t reached = s & t->layer, before;
    do {
        before = reached;
        for (int v = 0; v < t->voxels; v++) {
            if ((s >> v & 1) && (t->carriers[v] & reached)) {
                reached |= 1u << v;
            }
        }
    } while (reached != before);
    return reached;
}

static void kernel(const tiny *t)
{
    for (uint32_t a = 0; a < t->count; a++) {
        uint32_t kept = t->trim[a];
        CHECK((kept & ~a) == 0);                  // 1
        CHECK(tiny_is_free(t, kept));             // 1
        CHECK_EQ(t->trim[kept], kept);            // 2
        CHECK((kept == a) == tiny_is_free(t, a)); // 1 and 3
        CHECK_EQ(kept, chains(t, a));             // 4
        for (int k = 1; k < t->nz; k++) {         // 15
            uint32_t low = (1u << (k * t->nx * t->ny)) - 1;
            CHECK_EQ(kept & low, t->trim[a & low]);
        }
    }
}

static void kernel_of_every_stack(void)
{
    for_all(kernel, 3, 3, 2);
    for_all(kernel, 2, 2, 4);
    for_all(kernel, 5, 1, 3);
}

// Over all pairs part <= whole: 3^12 of them for twelve voxels.
static void order(const tiny *t)
{
    for (uint32_t whole = 0; whole < t->count; whole++) {
        uint32_t kept = t->trim[whole], part = whole;
        do {
            CHECK((t->trim[part] & ~kept) == 0); // 5
            if (tiny_is_free(t, part)) {
                CHECK((part & ~kept) == 0); // 3
            }
            part = (part - 1) & whole;
        } while (part != whole);
    }
}

static void largest_and_monotone(void)
{
    for_all(order, 4, 1, 3);
    for_all(order, 3, 1, 4);
    for_all(order, 2, 2, 3);
}

// 18: what one rule carries a wider one carries too, and the narrower has the last word.
static void wider_rules_keep_more(void)
{
    sf_rule rules[] = {rule_of_radius(0), rule_of_radius(1), sf_rule_box3(), rule_of_radius(2)};
    tiny t[4];
    for (int i = 0; i < 4; i++) {
        t[i] = tiny_new(3, 3, 2, &rules[i]);
    }
    for (int i = 0; i < 4; i++) {
        for (int j = i; j < 4; j++) {
            for (uint32_t a = 0; a < t[0].count; a++) {
                uint32_t narrow = t[i].trim[a], wide = t[j].trim[a];
                CHECK((narrow & ~wide) == 0);
                CHECK_EQ(t[i].trim[wide], narrow);
                CHECK_EQ(t[j].trim[narrow], narrow);
            }
        }
    }
    for (int i = 0; i < 4; i++) {
        tiny_delete(&t[i]);
    }
}

// 23: more reach never keeps less, and enough of it keeps all below the first empty layer.
static void reach_to_the_horizon(void)
{
    static stack s, kept;
    for (int i = 0; i < 60; i++) {
        stack_random(&s, 13, 9, 7, 0.02 + 0.2 * test_random_unit());
        uint64_t last = 0, below_gap = 0;
        for (unsigned r = 0; r < 17; r++) {
            sf_rule rule = rule_of_radius(r);
            library_trim(&kept, &s, &rule, 0);
            uint64_t volume = stack_volume(&kept);
            CHECK(volume >= last);
            last = volume;
        }
        for (int z = 0; z < s.nz; z++) {
            uint64_t layer = 0;
            for (int v = 0; v < s.nx * s.ny; v++) {
                layer += s.solid[z * s.nx * s.ny + v];
            }
            if (layer == 0) {
                break;
            }
            below_gap += layer;
        }
        CHECK_EQ(last, below_gap);
    }
}

// False: trim is monotone where the shape chooses its bed. A crumb below what stands already makes
// the crumb's layer the bed, and all that stood goes.
static void false_monotone_on_a_bed_of_its_own(void)
{
    static stack a, b, trim_a, trim_b;
    sf_rule rule = sf_rule_box3();
    stack_parse(&a, "....|#...|#...");
    stack_parse(&b, "...#|#...|#...");
    CHECK(stack_within(&a, &b));
    library_trim(&trim_a, &a, &rule, SF_BED_AUTO);
    library_trim(&trim_b, &b, &rule, SF_BED_AUTO);
    CHECK(!stack_within(&trim_a, &trim_b));
    library_trim(&trim_a, &a, &rule, 0);
    library_trim(&trim_b, &b, &rule, 0);
    CHECK(stack_within(&trim_a, &trim_b));
}

int main(void)
{
    TEST(kernel_of_every_stack);
    TEST(largest_and_monotone);
    TEST(wider_rules_keep_more);
    TEST(reach_to_the_horizon);
    TEST(false_monotone_on_a_bed_of_its_own);
    return test_finish();
}
