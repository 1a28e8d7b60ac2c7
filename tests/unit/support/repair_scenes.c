// SPDX-License-Identifier: MIT
// Why: on shapes of some size a repair must be worth its name: five balls in the air over a plate,
// at a small part of what a trim loses and of what a grow of paths adds. A slab high above the bed
// is the other end: all of it hangs, and there is much to share. And where a least width is asked
// for and there is room, everything that is added has it.

#include "law/stack.h"

#include <sf/grow.h>
#include <sf/repair.h>

#define NX 96
#define NZ 80
#define VOXELS (NX * NX * NZ)

// Grids as arrays of bytes, layers first, because a stack is too small for them.
typedef struct volume {
    uint8_t solid[VOXELS];
} volume;

static volume scene, grown, result;

static uint8_t *at(volume *v, int x, int y, int z)
{
    return &v->solid[(z * NX + y) * NX + x];
}

static void add_ball(volume *v, double cx, double cy, double cz, double radius)
{
    for (int z = 0; z < NZ; z++) {
        for (int y = 0; y < NX; y++) {
            for (int x = 0; x < NX; x++) {
                double dx = x - cx, dy = y - cy, dz = z - cz;
                if (dx * dx + dy * dy + dz * dz <= radius * radius) {
                    *at(v, x, y, z) = 1;
                }
            }
        }
    }
}

static void five_balls(void)
{
    memset(&scene, 0, sizeof scene);
    for (int y = 8; y < NX - 8; y++) {
        for (int x = 8; x < NX - 8; x++) {
            *at(&scene, x, y, 0) = 1;
        }
    }
    add_ball(&scene, 24, 25, 20, 14);
    add_ball(&scene, 70, 22, 33, 12);
    add_ball(&scene, 27, 68, 44, 11);
    add_ball(&scene, 72, 70, 58, 13);
    add_ball(&scene, 48, 47, 66, 6);
}

static sf_grid *volume_grid(const volume *v)
{
    sf_lattice lattice = stack_lattice(NX, NX, NZ);
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    for (int i = 0; i < VOXELS; i++) {
        if (v->solid[i]) {
            CHECK_EQ(sf_slice_set(sf_grid_slice(grid, (uint32_t)(i / (NX * NX))),
                                  (uint32_t)(i % NX), (uint32_t)(i / NX % NX), 1),
                     SF_OK);
        }
    }
    return grid;
}

static void slab(int z)
{
    memset(&scene, 0, sizeof scene);
    for (int i = 0; i < 4 * NX * NX; i++) {
        int x = i % NX, y = i / NX % NX;
        *at(&scene, x, y, z + i / (NX * NX)) = x >= 2 && y >= 2 && x < NX - 2 && y < NX - 2;
    }
}

static void repair(sf_repair_options *o, sf_repair_report *r)
{
    sf_grid *grid = volume_grid(&scene);
    CHECK_EQ(sf_grid_repair(grid, o, NULL, NULL, NULL, r), SF_OK);
    for (int i = 0; i < VOXELS; i++) {
        result.solid[i] = (uint8_t)sf_slice_get(sf_grid_slice(grid, (uint32_t)(i / (NX * NX))),
                                                (uint32_t)(i % NX), (uint32_t)(i / NX % NX));
    }
    sf_grid_destroy(grid);
}

static int is_carried(volume *v, int x, int y, int z)
{
    for (int i = 0; z > 0 && i < 9; i++) {
        int u = x + i % 3 - 1, w = y + i / 3 - 1;
        if (u >= 0 && w >= 0 && u < NX && w < NX && *at(v, u, w, z - 1)) {
            return 1;
        }
    }
    return z == 0;
}

static int is_support_free(volume *v)
{
    for (int i = 0; i < VOXELS; i++) {
        if (v->solid[i] && !is_carried(v, i % NX, i / NX % NX, i / (NX * NX))) {
            return 0;
        }
    }
    return 1;
}

// The nearest matter of a layer below within t voxels of (x, y); by the closest, or none.
static int find_near(volume *v, int x, int y, int z, int t, int *fx, int *fy)
{
    int least = 1 << 20;
    for (int w = y - t; w <= y + t; w++) {
        for (int u = x - t; u <= x + t; u++) {
            int d = (u - x) * (u - x) + (w - y) * (w - y);
            if (u >= 0 && w >= 0 && u < NX && w < NX && *at(v, u, w, z) && d < least) {
                least = d;
                *fx = u;
                *fy = w;
            }
        }
    }
    return least < 1 << 20;
}

static int toward(int from, int to)
{
    return from + (to > from) - (to < from);
}

// The paper's grow: each voxel that nothing carries gets a path to the closest matter below it, by
// layers and then by distance, or straight down to the bed. In turn: what has been grown counts as
// matter for the next; else each by itself, and what they share counts once.
static uint64_t grow_by_paths(int in_turn)
{
    uint64_t added = 0;
    grown = scene;
    for (int i = VOXELS - 1; i >= NX * NX; i--) {
        int x = i % NX, y = i / NX % NX, z = i / (NX * NX), fx = x, fy = y;
        volume *matter = in_turn ? &grown : &scene;
        if (!scene.solid[i] || is_carried(matter, x, y, z)) {
            continue;
        }
        for (int t = 1; t <= z && !find_near(matter, x, y, z - t, t, &fx, &fy); t++) {
        }
        while (!is_carried(matter, x, y, z)) {
            x = toward(x, fx);
            y = toward(y, fy);
            z--;
            added += !*at(&grown, x, y, z);
            *at(&grown, x, y, z) = 1;
        }
    }
    CHECK(is_support_free(&grown));
    return added;
}

static uint64_t grow_by_library(void)
{
    sf_terms terms = sf_terms_default();
    terms.bed_layer = 0;
    sf_grow_report report = {0, 0, 0};
    sf_grid *grid = volume_grid(&scene);
    CHECK_EQ(sf_grid_grow(grid, &terms, NULL, NULL, NULL, &report), SF_OK);
    sf_grid_destroy(grid);
    return report.added_voxels;
}

static void repairs_five_balls_at_a_small_part_of_either_cost(void)
{
    sf_repair_options o = sf_repair_options_default();
    sf_repair_report r;
    five_balls();
    repair(&o, &r);
    CHECK(is_support_free(&result));
    uint64_t alone = grow_by_paths(0), in_turn = grow_by_paths(1), library = grow_by_library();
    printf(
        "# trim %llu, grow alone %llu, in turn %llu, sf_grid_grow() %llu, first %llu, repair %llu "
        "in %u rounds\n",
        (unsigned long long)r.trim_cost, (unsigned long long)alone, (unsigned long long)in_turn,
        (unsigned long long)library, (unsigned long long)r.first_cost, (unsigned long long)r.cost,
        r.rounds);
    CHECK_EQ(r.trim_cost, 34337); // so tests/optimum/five_balls.py knows that its scene is this one
    CHECK(r.cost * 100 <= r.trim_cost * 4);
    CHECK(r.cost * 100 <= alone * 30);
    CHECK(r.cost * 100 <= in_turn * 60);
    CHECK(r.cost * 100 <= library * 60);
}

static void repairs_a_slab_at_no_more_than_either_cost(void)
{
    static const int heights[3] = {4, 24, NZ - 4};
    for (int i = 0; i < 3; i++) {
        sf_repair_options o = sf_repair_options_default();
        sf_repair_report r;
        o.terms.bed_layer = 0;
        slab(heights[i]);
        repair(&o, &r);
        CHECK(is_support_free(&result));
        uint64_t library = grow_by_library();
        printf("# slab at %d: trim %llu, sf_grid_grow() %llu, first %llu, repair %llu\n",
               heights[i], (unsigned long long)r.trim_cost, (unsigned long long)library,
               (unsigned long long)r.first_cost, (unsigned long long)r.cost);
        CHECK_EQ(r.trim_cost, 4 * (NX - 4) * (NX - 4));
        CHECK(r.cost <= library);
        CHECK(r.cost * 6 <= r.trim_cost);
    }
}

// Whether (x, y) lies in a square of w voxels of a layer that is solid.
static int is_wide(volume *v, int x, int y, int z, int w)
{
    for (int cy = y - w + 1; cy <= y; cy++) {
        for (int cx = x - w + 1; cx <= x; cx++) {
            int solid = cx >= 0 && cy >= 0 && cx + w <= NX && cy + w <= NX;
            for (int i = 0; solid && i < w * w; i++) {
                solid = *at(v, cx + i % w, cy + i / w, z);
            }
            if (solid) {
                return 1;
            }
        }
    }
    return 0;
}

static void makes_struts_as_wide_as_asked(void)
{
    five_balls();
    for (uint32_t w = 2; w <= 4; w++) {
        sf_repair_options o = sf_repair_options_default();
        sf_repair_report r;
        uint64_t thin = 0;
        o.min_feature_vx = w;
        repair(&o, &r);
        CHECK(is_support_free(&result));
        for (int i = 0; i < VOXELS; i++) {
            thin += result.solid[i] && !scene.solid[i] &&
                    !is_wide(&result, i % NX, i / NX % NX, i / (NX * NX), (int)w);
        }
        CHECK_EQ(thin, 0);
        CHECK(r.cost < r.trim_cost);
        printf("# width %u: %llu, trim %llu\n", w, (unsigned long long)r.cost,
               (unsigned long long)r.trim_cost);
    }
}

static void gives_the_same_bytes_for_every_instruction_set(void)
{
    sf_repair_options o = sf_repair_options_default();
    sf_repair_report r;
    five_balls();
    repair(&o, &r);
    grown = result;
    sf_isa_limit(SF_ISA_WORD);
    repair(&o, &r);
    sf_isa_limit(SF_ISA_AVX512);
    CHECK(memcmp(&grown, &result, sizeof result) == 0);
}

int main(void)
{
    TEST(repairs_five_balls_at_a_small_part_of_either_cost);
    TEST(repairs_a_slab_at_no_more_than_either_cost);
    TEST(makes_struts_as_wide_as_asked);
    TEST(gives_the_same_bytes_for_every_instruction_set);
    return test_finish();
}
