// SPDX-License-Identifier: MIT
// The closest supporting path (ALGORITHMS 2.1, 2.2, 10.2): what a finder gives for each voxel of a
// shape has the least cost there is, ends where the tie rule says, goes by legal steps of every
// layer through voxels that may be filled, and carries the voxel once it is filled (TRUST 74: a
// path is what its definition says, not what an implementation happened to walk).

#include "paths.h"

// That a path is one: legal steps, fillable voxels, an end that is what it says.
static void check_path(const path_case *c, sf_voxel from, const sf_voxel *path, const sf_path *p)
{
    sf_voxel at = from;
    for (size_t i = 0; i <= p->count; i++) {
        sf_voxel next = i < p->count ? path[i] : p->landing;
        if (i == p->count && p->end != SF_PATH_END_MATTER) {
            CHECK(next.x == at.x && next.y == at.y && next.z == at.z);
            break;
        }
        sf_element e = stack_step(&c->rule, (int)next.z);
        CHECK_EQ(next.z + 1, at.z);
        CHECK(element_has(&e, (int)next.x - (int)at.x, (int)next.y - (int)at.y));
        if (i < p->count) {
            CHECK(is_passable(c, (int)next.x, (int)next.y, (int)next.z));
            CHECK(!is_root(c, (int)next.x, (int)next.y, (int)next.z) ||
                  c->rule.kind == SF_RULE_SLACK);
        }
        at = next;
    }
}

// Under slack: what its end has to spare lasts up to the voxel.
static void check_slack(const path_case *c, sf_voxel from, const sf_voxel *path, const sf_path *p)
{
    int on_matter = p->end == SF_PATH_END_MATTER, cap = c->rule.slack_cap;
    size_t steps = p->count + (size_t)on_matter;
    int x = (int)p->landing.x, y = (int)p->landing.y, z = (int)p->landing.z;
    int i = (z * c->shape.ny + y) * c->shape.nx + x;
    int s = p->end == SF_PATH_END_BED ? cap : on_matter && c->alive.solid[i] ? c->slack[i] : 0;
    for (size_t k = steps; k-- > 0;) {
        sf_voxel at = k < p->count ? path[k] : p->landing, up = k > 0 ? path[k - 1] : from;
        sf_element e = stack_step(&c->rule, (int)at.z);
        int room = naive_room(&c->rule, &e, (int)up.x, (int)up.y, (int)up.z, (int)at.x, (int)at.y);
        s = naive_step(&c->rule, room, s);
        CHECK(s >= 0);
    }
}

// That it does what it is for: with it, and what it may land on held, the voxel is carried.
static void check_carried(const path_case *c, sf_voxel from, const sf_voxel *path, size_t count)
{
    static stack filled, held, trimmed;
    filled = c->shape;
    for (size_t i = 0; i < count; i++) {
        *stack_at(&filled, (int)path[i].x, (int)path[i].y, (int)path[i].z) = 1;
    }
    *stack_at(&filled, (int)from.x, (int)from.y, (int)from.z) = 1;
    stack_clear(&held, filled.nx, filled.ny, filled.nz);
    for (int i = 0; i < stack_count(&held); i++) {
        int z = i / (held.nx * held.ny);
        int lands = c->landing == SF_LANDING_ANY && c->shape.solid[i] && z >= c->bed;
        held.solid[i] = (uint8_t)((c->has_exempt && c->exempt.solid[i]) || lands);
    }
    // The voxel itself must not be held by being part of the shape.
    if (!is_exempt(c, (int)from.x, (int)from.y, (int)from.z)) {
        *stack_at(&held, (int)from.x, (int)from.y, (int)from.z) = 0;
    }
    sf_grid *grid = stack_grid(&filled), *exempt = stack_grid(&held);
    sf_terms terms = c->terms;
    terms.exempt = exempt;
    terms.forbid = terms.act = NULL;
    terms.bed_layer = (uint32_t)c->bed;
    CHECK_EQ(sf_grid_trim_on(grid, &terms, stack_allocator(), NULL, NULL, NULL), SF_OK);
    stack_read(&trimmed, grid);
    CHECK(stack_get(&trimmed, (int)from.x, (int)from.y, (int)from.z));
    for (size_t i = 0; i < count; i++) {
        CHECK(stack_get(&trimmed, (int)path[i].x, (int)path[i].y, (int)path[i].z));
    }
    sf_grid_destroy(grid);
    sf_grid_destroy(exempt);
}

static int questions; // of a case, where it counts them

static void check_voxel(const path_case *c, sf_path_finder *finder, int x, int y, int z)
{
    static const sf_path_end ends[3] = {SF_PATH_END_MATTER, SF_PATH_END_HELD, SF_PATH_END_BED};
    sf_voxel from = {(uint32_t)x, (uint32_t)y, (uint32_t)z}, path[64];
    path_rank best;
    int t;
    sf_path p;
    questions++;
    if (!naive_path(c, x, y, z, &best, &t)) {
        CHECK_EQ(sf_path_finder_find(finder, from, path, 64, &p), SF_ERR_INFEASIBLE);
        return;
    }
    CHECK_EQ(sf_path_finder_find(finder, from, path, 64, &p), SF_OK);
    CHECK_EQ(p.end, ends[best.end]);
    CHECK_EQ(p.count, t - (t > 0 && best.end == 0));
    if (t > 0) {
        CHECK_EQ(p.landing.x, best.x);
        CHECK_EQ(p.landing.y, best.y);
        CHECK_EQ(p.landing.z, z - t);
        int far = best.end == 2 ? naive_distance(c, best.x, best.y, z - t) - 1 : 0;
        CHECK_EQ(p.cost, (int)p.count + far);
        CHECK_EQ(p.bed_square, best.end == 2 && best.square > 0 ? best.square : 0);
    }
    check_path(c, from, path, &p);
    if (c->rule.kind == SF_RULE_SLACK) {
        check_slack(c, from, path, &p);
    }
    if (test_random_below(8) == 0) {
        check_carried(c, from, path, p.count);
    }
}

static void check_case(path_case *c, int share)
{
    sf_path_finder *finder = NULL;
    path_case_open(c);
    CHECK_EQ(
        sf_path_finder_create(c->grid, &c->terms, c->landing, stack_allocator(), NULL, &finder),
        SF_OK);
    for (int z = 0; z < c->shape.nz; z++) {
        for (int i = 0; i < c->shape.nx * c->shape.ny; i++) {
            if (share == 1 || test_random_below((uint32_t)share) == 0) {
                check_voxel(c, finder, i % c->shape.nx, i / c->shape.nx, z);
            }
        }
    }
    sf_path_finder_destroy(finder);
    path_case_close(c);
}

static sf_rule random_rule(int i)
{
    sf_rule rule = i % 9 == 7   ? rule_of_radius(2)
                   : i % 9 == 8 ? rule_of_radius(1)
                                : rule_by_number(i);
    if (i % 11 == 3) {
        rule.bridge.span_x = 3;
        rule.bridge.span_diagonal = 2;
    }
    return rule;
}

static void elements_on_small_grids(void)
{
    static path_case c;
    for (int i = 0; i < 900; i++) {
        path_random_case(&c, i, 1 + (int)test_random_below(9), 1 + (int)test_random_below(7),
                         1 + (int)test_random_below(9));
        c.rule = random_rule(i / 2);
        check_case(&c, 2);
    }
}

static void windows_across_words(void)
{
    static path_case c;
    for (int i = 0; i < 40; i++) {
        path_random_case(&c, i, 140, 3, 12);
        c.rule = i % 2 == 0 ? random_rule(i / 2) : rule_of_angle(SF_RULE_SLACK, 20.0 + i);
        check_case(&c, 150);
    }
}

static void layers_of_different_heights(void)
{
    static path_case c;
    double heights[8];
    uint64_t table[16];
    for (int i = 0; i < 60; i++) {
        for (int k = 0; k < 8; k++) {
            heights[k] = 0.1 * (1.0 + 2.0 * test_random_unit());
        }
        sf_lattice lattice = stack_lattice(9, 6, 8);
        lattice.heights_mm = heights;
        path_random_case(&c, i, 9, 6, 8);
        sf_rule_kind kinds[3] = {SF_RULE_OCTAGON, SF_RULE_DISK, SF_RULE_SLACK};
        CHECK_EQ(sf_rule_make(kinds[i % 3], 0.8 + 0.4 * test_random_unit(), &lattice, table,
                              &c.rule, NULL),
                 SF_OK);
        check_case(&c, i % 3 == 2 ? 12 : 2);
    }
}

// A slack rule of any angle on pixels of any shape, some of them with layers of different heights.
static sf_rule random_slack_rule(int i, int nz, double *heights, uint64_t *table)
{
    static const double pitches[6][2] = {{0.1, 0.1}, {0.1, 0.1}, {0.1, 0.13},
                                         {0.2, 0.1}, {0.1, 0.4}, {0.3, 0.07}};
    sf_rule rule = sf_rule_box3();
    sf_status status;
    do {
        double degrees = 8.0 + 70.0 * test_random_unit(), h = 0.03 + 0.2 * test_random_unit();
        const double *pitch = pitches[test_random_below(6)];
        sf_lattice lattice = {4, 4, (uint32_t)nz, pitch[0], pitch[1], h, NULL, {0.0, 0.0, 0.0}};
        for (int k = 0; k < nz; k++) {
            heights[k] = h * (i % 6 == 1 ? 1.0 : 0.2 + 1.3 * test_random_unit());
        }
        lattice.heights_mm = i % 3 == 1 ? heights : NULL;
        status = sf_rule_make(SF_RULE_SLACK, degrees * (3.14159265358979323846 / 180.0), &lattice,
                              table, &rule, NULL);
    } while (status == SF_ERR_UNSUPPORTED);
    CHECK_EQ(status, SF_OK);
    return rule;
}

// Some 15,000 questions: one height and many, square pixels and oblong ones, masks or none.
static void slack(void)
{
    static path_case c;
    double heights[16];
    uint64_t table[32];
    questions = 0;
    for (int i = 0; i < 700; i++) {
        int nx = 3 + (int)test_random_below(16), ny = 1 + (int)test_random_below(12);
        int nz = 4 + (int)test_random_below(10);
        path_random_case(&c, i, nx, ny, nz);
        c.rule = random_slack_rule(i, nz, heights, table);
        c.rule.bridge.span_x = (uint16_t)(i % 5 == 0 ? 3 : 0);
        check_case(&c, 1 + nx * ny * nz / 24);
    }
    CHECK(questions > 10000);
}

// 10.2: on layers of one height, where nothing is alive but what is landed on, t* is the least t
// with ch_t(w - u) <= s(w) + t rho.
static void the_closed_form_of_slack(void)
{
    static path_case c;
    sf_rule rule = rule_of_angle(SF_RULE_SLACK, 40.0);
    memset(&c, 0, sizeof c);
    stack_clear(&c.shape, 24, 1, 12);
    *stack_at(&c.shape, 0, 0, 0) = 1;
    c.rule = rule;
    path_case_open(&c);
    sf_path_finder *finder = NULL;
    CHECK_EQ(
        sf_path_finder_create(c.grid, &c.terms, SF_LANDING_ANY, stack_allocator(), NULL, &finder),
        SF_OK);
    for (int t = 1; t < 12; t++) {
        for (int x = 0; x < 24; x++) {
            // Along an axis steps of 0, 1 and 2 voxels cost what they are long.
            int gain = 0, reach = x <= 2 * t;
            for (int k = 0; k < t; k++) {
                gain += naive_gain(&rule, k);
            }
            int expected = reach && x * rule.slack_x <= rule.slack_cap + gain;
            sf_voxel from = {(uint32_t)x, 0, (uint32_t)t};
            sf_voxel path[16];
            sf_path p;
            CHECK_EQ(sf_path_finder_find(finder, from, path, 16, &p), SF_OK);
            CHECK_EQ(p.end == SF_PATH_END_MATTER, expected);
        }
    }
    sf_path_finder_destroy(finder);
    path_case_close(&c);
}

// As printed the map of the paper knows no matter: a path would go through it down to the bed.
static void the_papers_map_passes_through_matter(void)
{
    static path_case c;
    memset(&c, 0, sizeof c);
    stack_parse(&c.shape, "#......|#......|#......|####...|.......|.......|.......");
    c.rule = sf_rule_box3();
    path_case_open(&c);
    sf_path_finder *finder = NULL;
    sf_voxel from = {6, 0, 6}, path[8];
    sf_path p;
    CHECK_EQ(
        sf_path_finder_create(c.grid, &c.terms, SF_LANDING_ANY, stack_allocator(), NULL, &finder),
        SF_OK);
    CHECK_EQ(sf_path_finder_find(finder, from, path, 8, &p), SF_OK);
    CHECK_EQ(p.count, 2);
    CHECK_EQ(p.cost, 2);
    CHECK(6 + 0 > p.cost); // k + D at the bed, where the cone meets the matter of the bed
    sf_path_finder_destroy(finder);
    path_case_close(&c);
}

int main(void)
{
    TEST(elements_on_small_grids);
    TEST(windows_across_words);
    TEST(layers_of_different_heights);
    TEST(slack);
    TEST(the_closed_form_of_slack);
    TEST(the_papers_map_passes_through_matter);
    return test_finish();
}
