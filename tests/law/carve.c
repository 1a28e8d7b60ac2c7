// SPDX-License-Identifier: MIT
// Why: the laws of cavities (TRUST 64 to 68), the true ones and those that are not. A cavity made
// by completing the wall keeps the wall's thickness and hangs nowhere; one that is merely cut out
// and trimmed loses the wall, one that is merely cut out hangs. Cavities that are valid stay so
// where both are, but not where either is: there is no largest one.

#include "law/alive.h"

#include <sf/carve.h>

enum { NX = 16, NY = 12, NZ = 10 };

typedef struct carved {
    stack solid, wall, result;
    uint64_t removed;
} carved;

static sf_grid *empty_grid(void)
{
    sf_lattice l = stack_lattice(NX, NY, NZ);
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
    return grid;
}

// A random part that prints, hollowed with a wall of so many voxels.
static void hollow(carved *c, const alive_rule *alive, int wall_vx)
{
    static stack drawn;
    sf_terms terms = sf_terms_default();
    sf_carve_report r;
    terms.rule = alive->rule;
    stack_random_boxes(&drawn, NX, NY, NZ, 6);
    alive_trim(alive, &drawn, NULL, stack_bed(&drawn, SF_BED_AUTO), &c->solid);
    sf_grid *solid = stack_grid(&c->solid), *wall = empty_grid(), *result = empty_grid();
    CHECK_EQ(sf_grid_wall_inside(solid, 0.1 * wall_vx, NULL, NULL, wall), SF_OK);
    CHECK_EQ(sf_grid_carve(solid, wall, &terms, NULL, NULL, NULL, result, &r), SF_OK);
    stack_read(&c->wall, wall);
    stack_read(&c->result, result);
    c->removed = r.removed_voxels;
    CHECK_EQ(r.floating_pieces, 0);
    CHECK_EQ(r.safe, 1);
    sf_grid_destroy(solid);
    sf_grid_destroy(wall);
    sf_grid_destroy(result);
}

// Squared gap in voxels between two voxels, as boxes.
static int gap_squared(int dx, int dy, int dz)
{
    int g[3] = {abs(dx) - 1, abs(dy) - 1, abs(dz) - 1}, sum = 0;
    for (int i = 0; i < 3; i++) {
        sum += g[i] > 0 ? g[i] * g[i] : 0;
    }
    return sum;
}

// Law 64 and 68: around a carved voxel nothing within the wall's thickness is outside.
static void cavities_keep_the_wall(void)
{
    uint64_t removed = 0;
    for (int i = 0; i < 64; i++) {
        static carved c;
        static alive_rule alive;
        sf_rule rule = alive_rule_by_number(i);
        int w = 1 + i % 3;
        alive_prepare(&alive, &rule, NZ);
        hollow(&c, &alive, w);
        CHECK(stack_within(&c.result, &c.solid) && stack_within(&c.wall, &c.result));
        CHECK(alive_is_free(&alive, &c.result, NULL, stack_bed(&c.solid, SF_BED_AUTO)));
        removed += c.removed;
        for (int j = 0; j < stack_count(&c.solid); j++) {
            int x = j % NX, y = j / NX % NY, z = j / NX / NY;
            if (!c.solid.solid[j] || c.result.solid[j]) {
                continue;
            }
            for (int d = 0; d < 7 * 7 * 7; d++) {
                int dx = d % 7 - 3, dy = d / 7 % 7 - 3, dz = d / 49 - 3;
                CHECK(stack_get(&c.solid, x + dx, y + dy, z + dz) ||
                      gap_squared(dx, dy, dz) >= w * w);
            }
        }
    }
    printf("# %llu voxels were carved\n", (unsigned long long)removed);
    CHECK(removed > 100);
}

// A cut-out inside, as it is (law 66) and trimmed (law 65).
static void what_is_merely_cut_out(void)
{
    int hangs = 0, loses = 0, count = 0;
    for (int i = 0; i < 200; i++) {
        static carved c;
        static alive_rule alive;
        static stack trimmed;
        sf_rule rule = sf_rule_box3();
        alive_prepare(&alive, &rule, NZ);
        hollow(&c, &alive, 1);
        int bed = stack_bed(&c.wall, SF_BED_AUTO);
        count++;
        hangs += !alive_is_free(&alive, &c.wall, NULL, bed);
        alive_trim(&alive, &c.wall, NULL, bed, &trimmed);
        loses += !stack_within(&c.wall, &trimmed);
    }
    CHECK(hangs > 0 && hangs < count);
    CHECK_EQ(hangs, loses); // what hangs is just what a trim takes
    // The smallest: three layers of six, of which the middle is cut out.
    static stack s, t;
    sf_rule rule = sf_rule_box3();
    stack_parse(&s, "######|#....#|######");
    stack_trim(&t, &s, &rule, 0);
    CHECK(!stack_is_support_free(&s, &rule, 0) && !stack_within(&s, &t));
}

// Law 67: where both cavities are is a cavity; where either is need not be one.
static void both_but_not_either(void)
{
    static stack a, b, both, either;
    sf_rule rule = sf_rule_box3();
    int fails = 0;
    for (int i = 0; i < 300; i++) {
        static alive_rule alive;
        static stack drawn, noise;
        alive_prepare(&alive, &rule, 6);
        stack_random(&drawn, 7, 5, 6, 0.7);
        alive_trim(&alive, &drawn, NULL, 0, &a);
        stack_random(&noise, 7, 5, 6, 0.7);
        stack_combine(&noise, &a, &noise, STACK_AND);
        alive_trim(&alive, &noise, NULL, 0, &b); // a and b: one solid, less two cavities
        stack_random(&noise, 7, 5, 6, 0.7);
        stack_combine(&noise, &a, &noise, STACK_AND);
        alive_trim(&alive, &noise, NULL, 0, &drawn);
        stack_combine(&both, &b, &drawn, STACK_OR);
        stack_combine(&either, &b, &drawn, STACK_AND);
        CHECK(stack_is_support_free(&both, &rule, 0));
        fails += !stack_is_support_free(&either, &rule, 0);
    }
    CHECK(fails > 0);
    stack_parse(&a, "#.|#.");
    stack_parse(&b, ".#|#.");
    stack_combine(&either, &a, &b, STACK_AND);
    CHECK(stack_is_support_free(&a, &rule, 0) && stack_is_support_free(&b, &rule, 0));
    CHECK(!stack_is_support_free(&either, &rule, 0));
}

int main(void)
{
    TEST(cavities_keep_the_wall);
    TEST(what_is_merely_cut_out);
    TEST(both_but_not_either);
    return test_finish();
}
