// SPDX-License-Identifier: MIT
// TRUST items 16, 17: how far a change reaches. Flipping a voxel changes nothing outside its upward
// cone, so an edit may be trimmed within its cone; and a shape may be trimmed in tiles whose halo
// is as wide as the cone at the top, but in none much narrower.

#include "tiny.h"

// The voxels that a chain from v can reach upwards, v included.
static uint32_t cone(const tiny *t, int v)
{
    uint32_t reached = 1u << v;
    for (int u = v + 1; u < t->voxels; u++) {
        reached |= (t->carriers[u] & reached) != 0 ? 1u << u : 0;
    }
    return reached;
}

static void flips(int nx, int ny, int nz, const sf_rule *rule)
{
    tiny t = tiny_new(nx, ny, nz, rule);
    for (int v = 0; v < t.voxels; v++) {
        uint32_t within = cone(&t, v);
        for (uint32_t a = 0; a < t.count; a++) {
            CHECK(((t.trim[a] ^ t.trim[a ^ (1u << v)]) & ~within) == 0);
        }
    }
    tiny_delete(&t);
}

static void every_flip_of_every_stack(void)
{
    sf_rule rules[] = {sf_rule_box3(), rule_of_radius(1), rule_of_angle(SF_RULE_OCTAGON, 30.0)};
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        flips(3, 3, 2, &rules[i]);
        flips(4, 1, 4, &rules[i]);
        flips(2, 2, 4, &rules[i]);
    }
}

// The library's own incremental trim, after every flip of every stack of ten voxels.
static void every_flip_trimmed_in_its_box(void)
{
    sf_rule rule = sf_rule_box3();
    tiny t = tiny_new(5, 1, 2, &rule);
    sf_lattice lattice = stack_lattice(5, 1, 2);
    sf_grid *drawn = NULL, *printable = NULL;
    CHECK_EQ(sf_grid_create(&lattice, stack_allocator(), &drawn), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, stack_allocator(), &printable), SF_OK);
    for (uint32_t a = 0; a < t.count; a++) {
        for (uint32_t v = 0; v < 10; v++) {
            tiny_write(&t, drawn, a ^ (1u << v));
            tiny_write(&t, printable, t.trim[a]);
            sf_box box = {v % 5, 0, v / 5, v % 5 + 1, 1, v / 5 + 1};
            CHECK_EQ(sf_grid_trim_box(drawn, printable, &rule, 0, box, NULL), SF_OK);
            CHECK_EQ(tiny_read(&t, printable), t.trim[a ^ (1u << v)]);
        }
    }
    sf_grid_destroy(drawn);
    sf_grid_destroy(printable);
    tiny_delete(&t);
}

// Columns x0 <= x < x1 of a trim made from these and `halo` more on either side.
static void trim_tile(stack *tiles, const stack *s, const sf_rule *rule, int x0, int x1, int halo)
{
    static stack part, kept;
    int from = x0 > halo ? x0 - halo : 0, to = x1 + halo < s->nx ? x1 + halo : s->nx;
    stack_clear(&part, to - from, s->ny, s->nz);
    for (int i = 0; i < stack_count(&part); i++) {
        int x = i % part.nx, y = i / part.nx % part.ny, z = i / (part.nx * part.ny);
        part.solid[i] = (uint8_t)stack_get(s, x + from, y, z);
    }
    library_trim(&kept, &part, rule, 0);
    for (int z = 0; z < s->nz; z++) {
        for (int y = 0; y < s->ny; y++) {
            for (int x = x0; x < x1; x++) {
                *stack_at(tiles, x, y, z) = (uint8_t)stack_get(&kept, x - from, y, z);
            }
        }
    }
}

static int tiles_equal_the_whole(const stack *s, const sf_rule *rule, int tile, int halo)
{
    static stack whole, tiles;
    library_trim(&whole, s, rule, 0);
    stack_clear(&tiles, s->nx, s->ny, s->nz);
    for (int x = 0; x < s->nx; x += tile) {
        trim_tile(&tiles, s, rule, x, x + tile < s->nx ? x + tile : s->nx, halo);
    }
    return stack_equal(&whole, &tiles);
}

static void tiles_with_a_full_halo(void)
{
    static stack s;
    for (int i = 0; i < 80; i++) {
        unsigned reach = 1 + test_random_below(2);
        sf_rule rule = rule_of_radius(reach);
        stack_random(&s, 30, 4, 5, 0.1 + 0.3 * test_random_unit());
        CHECK(tiles_equal_the_whole(&s, &rule, 7, (int)reach * 4));
    }
}

// False: a halo of about one layer's reach is enough. A stair that goes two columns a layer.
static void false_a_halo_of_one_layer(void)
{
    static stack s;
    sf_rule rule = rule_of_radius(2);
    stack_parse(&s, "#........|..#......|....#....|......#..|........#");
    CHECK(tiles_equal_the_whole(&s, &rule, 8, 8));
    CHECK(!tiles_equal_the_whole(&s, &rule, 8, 1));
    CHECK(!tiles_equal_the_whole(&s, &rule, 8, 2));
    CHECK(!tiles_equal_the_whole(&s, &rule, 8, 7));
}

int main(void)
{
    TEST(every_flip_of_every_stack);
    TEST(every_flip_trimmed_in_its_box);
    TEST(tiles_with_a_full_halo);
    TEST(false_a_halo_of_one_layer);
    return test_finish();
}
