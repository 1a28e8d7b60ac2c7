// SPDX-License-Identifier: MIT
// The path map (ALGORITHMS 2.1, 2.3): a walk from each voxel costs what the naive map of costs says
// and what a finder finds, by legal steps, in both forms of the map and with both costs.

#include "paths.h"

// E of every voxel by its definition, layer by layer.
static void naive_map(const path_case *c, sf_path_cost kind, int *cost)
{
    int area = c->shape.nx * c->shape.ny;
    for (int z = c->bed; z < c->shape.nz; z++) {
        sf_element e = {0, {0}};
        if (z > c->bed) {
            e = stack_step(&c->rule, z - 1);
        }
        for (int i = 0; i < area; i++) {
            int x = i % c->shape.nx, y = i / c->shape.nx, least = PATHS_NONE;
            int add = kind == SF_PATH_COST_COUNT && z > c->bed ? 1 : naive_distance(c, x, y, z);
            for (int j = 0; j < area && z > c->bed; j++) {
                int below = cost[(z - 1) * area + j];
                if (element_has(&e, x - j % c->shape.nx, y - j / c->shape.nx) && below < least) {
                    least = below;
                }
            }
            if (is_root(c, x, y, z)) {
                cost[z * area + i] = 0;
            } else if (!is_passable(c, x, y, z)) {
                cost[z * area + i] = PATHS_NONE;
            } else if (is_exempt(c, x, y, z)) {
                cost[z * area + i] = kind == SF_PATH_COST_COUNT ? 1 : add;
            } else if (z == c->bed) {
                cost[z * area + i] = add;
            } else {
                cost[z * area + i] = least < PATHS_NONE ? least + add : PATHS_NONE;
            }
        }
    }
}

static int least_supporter(const path_case *c, const int *cost, int x, int y, int z)
{
    int area = c->shape.nx * c->shape.ny, least = PATHS_NONE;
    sf_element e = stack_step(&c->rule, z - 1);
    for (int j = 0; j < area; j++) {
        int below = cost[(z - 1) * area + j];
        if (element_has(&e, x - j % c->shape.nx, y - j / c->shape.nx) && below < least) {
            least = below;
        }
    }
    return least;
}

static void check_walk(const path_case *c, sf_voxel from, const sf_voxel *path, const sf_path *p)
{
    sf_voxel at = from;
    for (size_t i = 0; i < p->count; i++) {
        sf_element e = stack_step(&c->rule, (int)path[i].z);
        CHECK_EQ(path[i].z + 1, at.z);
        CHECK(element_has(&e, (int)path[i].x - (int)at.x, (int)path[i].y - (int)at.y));
        CHECK(is_passable(c, (int)path[i].x, (int)path[i].y, (int)path[i].z));
        at = path[i];
    }
    if (p->end == SF_PATH_END_MATTER) {
        sf_element e = stack_step(&c->rule, (int)p->landing.z);
        CHECK(is_root(c, (int)p->landing.x, (int)p->landing.y, (int)p->landing.z));
        CHECK(element_has(&e, (int)p->landing.x - (int)at.x, (int)p->landing.y - (int)at.y));
    } else if (p->end == SF_PATH_END_HELD) {
        CHECK(is_exempt(c, (int)at.x, (int)at.y, (int)at.z));
    } else {
        CHECK_EQ(at.z, c->bed);
    }
}

static void check_voxel(const path_case *c, const sf_path_map *map, sf_path_cost kind,
                        sf_path_finder *finder, const int *cost, sf_voxel from)
{
    sf_voxel path[64];
    sf_path p, q;
    int z = (int)from.z, x = (int)from.x, y = (int)from.y;
    int is_trivial = z == c->bed || is_exempt(c, x, y, z);
    int least = is_trivial ? 0 : z < c->bed ? PATHS_NONE : least_supporter(c, cost, x, y, z);
    sf_status expected = least < PATHS_NONE ? SF_OK : SF_ERR_INFEASIBLE;
    CHECK_EQ(sf_path_map_walk(map, from, path, 64, &p), expected);
    if (expected != SF_OK) {
        return;
    }
    CHECK_EQ(p.cost, least);
    check_walk(c, from, path, &p);
    if (kind == SF_PATH_COST_COUNT) {
        CHECK_EQ(sf_path_finder_find(finder, from, path, 64, &q), SF_OK);
        CHECK_EQ(p.cost, q.cost);
        CHECK_EQ(p.count, q.count);
    }
}

static void check_case(path_case *c, sf_path_cost kind)
{
    static int cost[STACK_VOXELS];
    sf_path_map_options options = sf_path_map_options_default();
    sf_path_map *map = NULL;
    sf_path_finder *finder = NULL;
    path_case_open(c);
    options.landing = c->landing;
    options.cost = kind;
    CHECK_EQ(sf_path_map_create(c->grid, &c->terms, &options, NULL, NULL, &map), SF_OK);
    CHECK_EQ(
        sf_path_finder_create(c->grid, &c->terms, c->landing, stack_allocator(), NULL, &finder),
        SF_OK);
    naive_map(c, kind, cost);
    for (int i = 0; i < stack_count(&c->shape); i++) {
        int area = c->shape.nx * c->shape.ny;
        sf_voxel from = {(uint32_t)(i % c->shape.nx), (uint32_t)(i % area / c->shape.nx),
                         (uint32_t)(i / area)};
        check_voxel(c, map, kind, finder, cost, from);
    }
    sf_path_finder_destroy(finder);
    sf_path_map_destroy(map);
    path_case_close(c);
}

static void costs_of_all_voxels(void)
{
    static path_case c;
    for (int i = 0; i < 500; i++) {
        path_random_case(&c, i, 1 + (int)test_random_below(10), 1 + (int)test_random_below(8),
                         1 + (int)test_random_below(8));
        c.rule = i % 8 == 7 ? rule_of_radius(2) : rule_by_number(i / 3);
        c.rule.bridge.span_x = (uint16_t)(i % 11 == 3 ? 3 : 0);
        check_case(&c, i % 3 == 2 ? SF_PATH_COST_NEARNESS : SF_PATH_COST_COUNT);
    }
}

static void rows_of_several_words(void)
{
    static path_case c;
    for (int i = 0; i < 12; i++) {
        path_random_case(&c, i, 131, 3, 6);
        c.rule = rule_by_number(i);
        check_case(&c, SF_PATH_COST_COUNT);
    }
}

static void the_two_costs_differ(void)
{
    // Straight down it is three voxels, but far from the other tower; the way along that is longer.
    static path_case c;
    memset(&c, 0, sizeof c);
    stack_parse(&c.shape, ".#.....#|.......#|.......#|.......#|........");
    c.rule = sf_rule_box3();
    path_case_open(&c);
    sf_path_map_options options = sf_path_map_options_default();
    sf_path_map *by_count = NULL, *by_nearness = NULL;
    CHECK_EQ(sf_path_map_create(c.grid, &c.terms, &options, NULL, NULL, &by_count), SF_OK);
    options.cost = SF_PATH_COST_NEARNESS;
    CHECK_EQ(sf_path_map_create(c.grid, &c.terms, &options, NULL, NULL, &by_nearness), SF_OK);
    sf_voxel from = {4, 0, 4}, path[4];
    sf_path p, q;
    CHECK_EQ(sf_path_map_walk(by_count, from, path, 4, &p), SF_OK);
    CHECK_EQ(sf_path_map_walk(by_nearness, from, path, 4, &q), SF_OK);
    CHECK_EQ(p.cost, 2);
    CHECK_EQ(q.cost, 3); // 2 voxels away, then 1, then there
    sf_path_map_destroy(by_count);
    sf_path_map_destroy(by_nearness);
    path_case_close(&c);
}

int main(void)
{
    TEST(costs_of_all_voxels);
    TEST(rows_of_several_words);
    TEST(the_two_costs_differ);
    return test_finish();
}
