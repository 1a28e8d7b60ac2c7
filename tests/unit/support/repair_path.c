// SPDX-License-Identifier: MIT
// Why: a repair trusts its path finder to find the cheapest way down, of which each step rests on
// the next and the last stands. Held against a table of costs filled voxel by voxel, for elements
// of every size (beyond 24 columns the finder looks another way), in rooms with gaps, at prices,
// with exempt voxels, on rows of one word and of several.

#include "base/memory.h"
#include "law/stack.h"
#include "support/repair/path.h"

#define FAR 1000000000

static stack room, drawn, standing, exempt;
static uint8_t prices[STACK_VOXELS];
static int table[STACK_VOXELS];

typedef struct query {
    sfi_job job;
    int has_exempt, has_prices, count;
    sfi_path_cell heads[4];
    uint32_t k; // layer that the heads rest on
} query;

static int price_of(const query *q, int at)
{
    return drawn.solid[at] ? 0 : q->has_prices ? prices[at] : 1;
}

static int stands(const query *q, int x, int y, int z)
{
    if (z == (int)q->job.bed || (q->has_exempt && stack_get(&exempt, x, y, z))) {
        return 1;
    }
    sf_element e = stack_step(&q->job.rule, z - 1);
    return stack_carried(&standing, x, y, z, &e);
}

static int can_begin(const query *q, int x, int y)
{
    sf_element e = stack_step(&q->job.rule, (int)q->k);
    for (int i = 0; i < q->count; i++) {
        if (!element_has(&e, x - (int)q->heads[i].x, y - (int)q->heads[i].y)) {
            return 0;
        }
    }
    return 1;
}

// The least that reaching (x, y, z) from above costs, itself not included.
static int least_above(const query *q, int x, int y, int z)
{
    if (z == (int)q->k) {
        return can_begin(q, x, y) ? 0 : FAR;
    }
    sf_element e = stack_step(&q->job.rule, z);
    int least = FAR, reach_x = e.half_width[0], reach_y = e.reach_y;
    for (int v = y - reach_y; v <= y + reach_y; v++) {
        for (int u = x - reach_x; u <= x + reach_x; u++) {
            if (u >= 0 && v >= 0 && u < room.nx && v < room.ny && element_has(&e, u - x, v - y)) {
                int cost = table[((z + 1) * room.ny + v) * room.nx + u];
                least = cost < least ? cost : least;
            }
        }
    }
    return least;
}

// The cost of the cheapest path; FAR where there is none.
static int least_of_all(const query *q)
{
    int layer = room.nx * room.ny, best = FAR;
    for (int z = (int)q->k; z >= (int)q->job.bed; z--) {
        for (int i = 0; i < layer; i++) {
            int x = i % room.nx, y = i / room.nx, at = z * layer + i;
            int least = room.solid[at] ? least_above(q, x, y, z) : FAR;
            table[at] = least < FAR ? least + price_of(q, at) : FAR;
            if (table[at] < best && stands(q, x, y, z)) {
                best = table[at];
            }
        }
    }
    return best;
}

// What a path costs, if it is one.
static int cost_of_path(const query *q, const sfi_path_finder *f)
{
    int cost = 0;
    for (uint32_t i = 0; i < f->count; i++) {
        const sfi_path_cell *c = &f->cells[i];
        int x = (int)c->x, y = (int)c->y, z = (int)c->k;
        CHECK(stack_get(&room, x, y, z));
        cost += price_of(q, (z * room.ny + y) * room.nx + x);
        if (i == 0) {
            CHECK(stands(q, x, y, z));
            continue;
        }
        sf_element e = stack_step(&q->job.rule, z - 1);
        CHECK_EQ(z, (int)f->cells[i - 1].k + 1);
        CHECK(element_has(&e, x - (int)f->cells[i - 1].x, y - (int)f->cells[i - 1].y));
    }
    CHECK_EQ(f->cells[f->count - 1].k, q->k);
    CHECK(can_begin(q, (int)f->cells[f->count - 1].x, (int)f->cells[f->count - 1].y));
    return cost;
}

static void random_query(query *q, int number)
{
    static const int radii[6] = {1, 2, 0, 5, 24, 40};
    int wide = number % 4 == 3, nx = 1 + (int)test_random_below(wide ? 130 : 20);
    int ny = 1 + (int)test_random_below(wide ? 6 : 12), nz = 2 + (int)test_random_below(7);
    *q = (query){.has_exempt = number % 3 == 1, .has_prices = number % 5 < 2};
    stack_random(&room, nx, ny, nz, number % 7 == 0 ? 1.0 : 0.8);
    stack_random(&drawn, nx, ny, nz, 0.1);
    stack_random(&standing, nx, ny, nz, 0.03);
    stack_random(&exempt, nx, ny, nz, 0.02);
    for (int i = 0; i < stack_count(&room); i++) {
        prices[i] = (uint8_t)(1 + test_random_below(255));
    }
    q->job.rule = number % 9 < 6   ? rule_of_radius((unsigned)radii[number % 9])
                  : number % 9 < 8 ? sf_rule_box3()
                                   : rule_of_angle(SF_RULE_OCTAGON, 60.0);
    q->job.bed = test_random_below((uint32_t)nz - 1);
    q->job.scale = 1;
    q->job.add = q->has_prices ? prices : NULL;
    q->k = q->job.bed + test_random_below((uint32_t)nz - 1 - q->job.bed);
    q->count = 1 + (int)test_random_below(4);
    for (int i = 0; i < q->count; i++) { // close together, or nothing carries them all
        int near_x = (int)test_random_below(3), near_y = (int)test_random_below(3);
        uint32_t x = i == 0 ? test_random_below((uint32_t)nx) : q->heads[0].x + (uint32_t)near_x;
        uint32_t y = i == 0 ? test_random_below((uint32_t)ny) : q->heads[0].y + (uint32_t)near_y;
        q->heads[i] = (sfi_path_cell){q->k + 1, x < (uint32_t)nx ? x : (uint32_t)nx - 1,
                                      y < (uint32_t)ny ? y : (uint32_t)ny - 1};
    }
}

static void ask(query *q, int number)
{
    sf_grid *grids[4] = {stack_grid(&room), stack_grid(&drawn), stack_grid(&standing),
                         stack_grid(&exempt)};
    sfi_path_finder f;
    q->job.lattice = sf_grid_lattice(grids[0]);
    for (uint32_t k = 0; k + 1 < q->job.lattice.nz; k++) {
        sf_element e = stack_step(&q->job.rule, (int)k);
        q->job.reach_x = e.half_width[0] > q->job.reach_x ? e.half_width[0] : q->job.reach_x;
        q->job.reach_y = e.reach_y > q->job.reach_y ? e.reach_y : q->job.reach_y;
    }
    sf_allocator memory = sfi_allocator_or_default(NULL);
    q->job.allocator = &memory;
    q->job.room = grids[0];
    q->job.drawn = grids[1];
    q->job.exempt = q->has_exempt ? grids[3] : NULL;
    CHECK_EQ(sfi_path_finder_create(&q->job, &f), SF_OK);
    f.grid = grids[2];
    int least = least_of_all(q);
    uint64_t bounds[3] = {UINT64_MAX, (uint64_t)least, (uint64_t)least + 1};
    for (int i = 0; i < 3; i++) {
        CHECK_EQ(sfi_path_find(&f, q->k, q->heads, (size_t)q->count, bounds[i]), SF_OK);
        CHECK_EQ(f.count > 0, least < FAR && (uint64_t)least < bounds[i]);
        if (f.count > 0) {
            CHECK_EQ(cost_of_path(q, &f), least);
        }
    }
    if (test_case_failures > 0) {
        printf("# query %d\n", number);
    }
    sfi_path_finder_destroy(&f);
    for (int i = 0; i < 4; i++) {
        sf_grid_destroy(grids[i]);
    }
}

static void finds_the_cheapest_way_down(void)
{
    for (int i = 0; i < 6000 && test_case_failures == 0; i++) {
        query q;
        random_query(&q, i);
        ask(&q, i);
    }
}

int main(void)
{
    TEST(finds_the_cheapest_way_down);
    return test_finish();
}
