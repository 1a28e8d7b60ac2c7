// SPDX-License-Identifier: MIT
// A brush along a path (ALGORITHMS 2.4; TRUST 74): what was solid and the path survive, what is
// added is carried and is all of the brush that is, and the result is support-free if the shape
// was. A sweep along two paths joined is the union of the sweeps. That no brush needs trimming is
// false, as the paper has it: a ball on a small feature does.

#include "paths.h"

// A by its definition: all translates, where something may be added, and the path.
static void naive_brush(const path_case *c, const stack *brush, const sf_voxel *anchor,
                        const sf_voxel *path, size_t count, stack *added)
{
    stack_clear(added, c->shape.nx, c->shape.ny, c->shape.nz);
    for (size_t i = 0; i < count; i++) {
        for (int j = 0; j < stack_count(brush); j++) {
            int x = (int)path[i].x - (int)anchor->x + j % brush->nx;
            int y = (int)path[i].y - (int)anchor->y + j / brush->nx % brush->ny;
            int z = (int)path[i].z - (int)anchor->z + j / (brush->nx * brush->ny);
            if (brush->solid[j] && x >= 0 && y >= 0 && z >= 0 && x < c->shape.nx &&
                y < c->shape.ny && z < c->shape.nz) {
                *stack_at(added, x, y, z) = 1;
            }
        }
        *stack_at(added, (int)path[i].x, (int)path[i].y, (int)path[i].z) = 1;
    }
    for (int j = 0; j < stack_count(added); j++) {
        int x = j % c->shape.nx, y = j / c->shape.nx % c->shape.ny;
        int z = j / (c->shape.nx * c->shape.ny);
        added->solid[j] &= (uint8_t)(is_passable(c, x, y, z) && !c->shape.solid[j]);
    }
}

// What of it stands: the trim of shape and brush with the shape held, by the library's trim_on.
static void naive_result(const path_case *c, const stack *added, stack *result)
{
    static stack all, held;
    stack_combine(&all, &c->shape, added, STACK_OR);
    held = c->shape;
    for (int j = 0; j < stack_count(&held); j++) {
        held.solid[j] |= (uint8_t)(c->has_exempt && c->exempt.solid[j]);
    }
    sf_grid *grid = stack_grid(&all), *exempt = stack_grid(&held);
    static const sf_bridge none;
    sf_terms terms = c->terms;
    terms.exempt = exempt;
    terms.forbid = terms.act = NULL;
    terms.rule.bridge = none;
    terms.bed_layer = (uint32_t)c->bed;
    CHECK_EQ(sf_grid_trim_on(grid, &terms, stack_allocator(), NULL, NULL, NULL), SF_OK);
    stack_read(result, grid);
    sf_grid_destroy(grid);
    sf_grid_destroy(exempt);
}

static void random_brush(stack *brush, sf_voxel *anchor)
{
    int nx = 1 + (int)test_random_below(7), ny = 1 + (int)test_random_below(5);
    int nz = 1 + (int)test_random_below(4);
    stack_random(brush, nx, ny, nz, 0.3 + 0.7 * test_random_unit());
    anchor->x = test_random_below((uint32_t)nx);
    anchor->y = test_random_below((uint32_t)ny);
    anchor->z = test_random_below((uint32_t)nz);
}

// A path of a random voxel that has one; its number of voxels, or 0.
static size_t random_path(const path_case *c, sf_voxel *path)
{
    sf_path_finder *finder = NULL;
    sf_path p = {0};
    CHECK_EQ(
        sf_path_finder_create(c->grid, &c->terms, c->landing, stack_allocator(), NULL, &finder),
        SF_OK);
    for (int attempt = 0; attempt < 20 && p.count == 0; attempt++) {
        sf_voxel from = {test_random_below((uint32_t)c->shape.nx),
                         test_random_below((uint32_t)c->shape.ny),
                         test_random_below((uint32_t)c->shape.nz)};
        if (sf_path_finder_find(finder, from, path, 64, &p) != SF_OK) {
            p.count = 0;
        }
    }
    sf_path_finder_destroy(finder);
    return p.count;
}

static sf_rule random_rule(int i)
{
    sf_rule rule = i % 6 == 5 ? rule_of_angle(SF_RULE_SLACK, 45.0) : rule_by_number(i);
    rule.bridge.span_x = (uint16_t)(i % 7 == 3 ? 3 : 0);
    return rule;
}

static void check_emission(const path_case *c)
{
    static stack brush, added, expected, found, rest;
    sf_voxel anchor, path[64];
    size_t count = random_path(c, path);
    random_brush(&brush, &anchor);
    sf_grid *brush_grid = stack_grid(&brush);
    sf_stroke stroke = {brush_grid, anchor, path, count};
    sf_emit_report report;
    CHECK_EQ(sf_grid_emit(c->grid, &c->terms, &stroke, NULL, &report), SF_OK);
    stack_read(&found, c->grid);
    naive_brush(c, &brush, &anchor, path, count, &added);
    naive_result(c, &added, &expected);
    // The oracle trims what lies below the bed; the library leaves what was there.
    stack_combine(&expected, &expected, &c->shape, STACK_OR);
    CHECK(stack_equal(&found, &expected));
    CHECK(stack_within(&c->shape, &found));
    for (size_t i = 0; i < count; i++) {
        CHECK(stack_get(&found, (int)path[i].x, (int)path[i].y, (int)path[i].z));
    }
    CHECK_EQ(report.added_voxels, stack_volume(&found) - stack_volume(&c->shape));
    int below = c->bed * c->shape.nx * c->shape.ny;
    stack_combine(&rest, &added, &found, STACK_MINUS);
    for (int i = 0; i < below; i++) {
        rest.solid[i] = 0; // below the bed nothing is added, and none of it counts
    }
    CHECK_EQ(report.trimmed_voxels, stack_volume(&rest));
    sf_grid_destroy(brush_grid);
}

static void any_brush_on_any_shape(void)
{
    static path_case c;
    for (int i = 0; i < 400; i++) {
        path_random_case(&c, i, i % 9 == 0 ? 90 : 12, 6, 9);
        c.rule = random_rule(i);
        path_case_open(&c);
        check_emission(&c);
        path_case_close(&c);
    }
}

static void support_free_stays_support_free(void)
{
    static path_case c;
    static stack brush, found, trimmed;
    for (int i = 0; i < 200; i++) {
        sf_voxel anchor, path[64];
        path_random_case(&c, i, 12, 7, 9);
        c.rule = random_rule(i);
        c.has_forbid = c.has_act = 0;
        c.landing = SF_LANDING_ANY;
        c.bed_layer = 0;
        path_case_open(&c);
        stack_write(&c.alive, c.grid);
        random_brush(&brush, &anchor);
        sf_stroke stroke = {stack_grid(&brush), anchor, path, random_path(&c, path)};
        CHECK_EQ(sf_grid_emit(c.grid, &c.terms, &stroke, NULL, NULL), SF_OK);
        stack_read(&found, c.grid);
        CHECK_EQ(sf_grid_trim_on(c.grid, &c.terms, stack_allocator(), NULL, NULL, NULL), SF_OK);
        stack_read(&trimmed, c.grid);
        CHECK(stack_equal(&found, &trimmed));
        CHECK(stack_within(&c.alive, &found));
        sf_grid_destroy((sf_grid *)stroke.brush);
        path_case_close(&c);
    }
}

static void ball(stack *s, int radius)
{
    int n = 2 * radius + 1;
    stack_clear(s, n, n, n);
    for (int i = 0; i < stack_count(s); i++) {
        int x = i % n - radius, y = i / n % n - radius, z = i / (n * n) - radius;
        s->solid[i] = x * x + y * y + z * z <= radius * radius;
    }
}

// A path that stands on a single voxel, with a ball around it.
static uint64_t trimmed_of_a_ball(int radius)
{
    static stack shape, brush;
    stack_clear(&shape, 24, 24, 24);
    *stack_at(&shape, 12, 12, 0) = 1;
    for (int z = 1; z < 10; z++) {
        *stack_at(&shape, 12, 12, z) = 1;
    }
    ball(&brush, radius);
    sf_grid *grid = stack_grid(&shape), *brush_grid = stack_grid(&brush);
    sf_voxel path[6], middle = {(uint32_t)radius, (uint32_t)radius, (uint32_t)radius};
    for (uint32_t i = 0; i < 6; i++) {
        sf_voxel v = {12, 12, 15 - i};
        path[i] = v;
    }
    sf_terms terms = sf_terms_default();
    sf_stroke stroke = {brush_grid, middle, path, 6};
    sf_emit_report report = {0, 0};
    CHECK_EQ(sf_grid_emit(grid, &terms, &stroke, NULL, &report), SF_OK);
    sf_grid_destroy(grid);
    sf_grid_destroy(brush_grid);
    return report.trimmed_voxels;
}

static void large_balls_need_trimming(void)
{
    CHECK_EQ(trimmed_of_a_ball(1), 0);
    CHECK(trimmed_of_a_ball(4) > 0);
    CHECK(trimmed_of_a_ball(6) > trimmed_of_a_ball(4));
}

// TRUST 74 with trimming: sweep(Q), then sweep(P) above it, within sweep(P Q).
static void sweeps_in_parts(void)
{
    static path_case c;
    static stack brush, whole, parts;
    for (int i = 0; i < 200; i++) {
        sf_voxel anchor, path[64];
        path_random_case(&c, i, 12, 7, 9);
        c.rule = random_rule(i);
        path_case_open(&c);
        size_t count = random_path(&c, path), half = count / 2;
        random_brush(&brush, &anchor);
        anchor.z = 0; // what hangs below a path may stand on another part of it
        sf_grid *other = NULL, *brush_grid = stack_grid(&brush);
        CHECK_EQ(sf_grid_clone(c.grid, NULL, &other), SF_OK);
        sf_stroke all = {brush_grid, anchor, path, count};
        sf_stroke upper = {brush_grid, anchor, path, half};
        sf_stroke lower = {brush_grid, anchor, path + half, count - half};
        c.terms.bed_layer = (uint32_t)c.bed;
        CHECK_EQ(sf_grid_emit(c.grid, &c.terms, &all, NULL, NULL), SF_OK);
        CHECK_EQ(sf_grid_emit(other, &c.terms, &lower, NULL, NULL), SF_OK);
        CHECK_EQ(sf_grid_emit(other, &c.terms, &upper, NULL, NULL), SF_OK);
        stack_read(&whole, c.grid);
        stack_read(&parts, other);
        CHECK(stack_within(&parts, &whole));
        sf_grid_destroy(other);
        sf_grid_destroy(brush_grid);
        path_case_close(&c);
    }
}

static void what_may_not_be_is_refused(void)
{
    static path_case c;
    memset(&c, 0, sizeof c);
    stack_parse(&c.shape, "#....|.....|.....|.....");
    c.rule = sf_rule_box3();
    path_case_open(&c);
    static stack found;
    sf_voxel in_the_air = {3, 0, 2}, path[3] = {{2, 0, 2}, {2, 0, 1}, {2, 0, 0}};
    sf_lattice one = stack_lattice(1, 1, 1);
    sf_grid *brush = NULL;
    CHECK_EQ(sf_grid_create(&one, NULL, &brush), SF_OK);
    sf_voxel anchor = {0, 0, 0}, beyond = {1, 0, 0}, outside = {5, 0, 0};
    sf_stroke stroke = {brush, anchor, &in_the_air, 1};
    CHECK_EQ(sf_grid_emit(c.grid, &c.terms, &stroke, NULL, NULL), SF_ERR_INFEASIBLE);
    stroke.path = path;
    stroke.count = 3;
    sf_grid *forbid = NULL;
    CHECK_EQ(sf_grid_clone(c.grid, NULL, &forbid), SF_OK);
    CHECK_EQ(sf_slice_set(sf_grid_slice(forbid, 1), 2, 0, 1), SF_OK);
    c.terms.forbid = forbid;
    CHECK_EQ(sf_grid_emit(c.grid, &c.terms, &stroke, NULL, NULL), SF_ERR_INFEASIBLE);
    c.terms.forbid = NULL;
    stroke.anchor = beyond;
    CHECK_EQ(sf_grid_emit(c.grid, &c.terms, &stroke, NULL, NULL), SF_ERR_ARGUMENT);
    stroke.anchor = anchor;
    stroke.path = &outside;
    stroke.count = 1;
    CHECK_EQ(sf_grid_emit(c.grid, &c.terms, &stroke, NULL, NULL), SF_ERR_ARGUMENT);
    stroke.brush = c.grid;
    CHECK_EQ(sf_grid_emit(c.grid, &c.terms, &stroke, NULL, NULL), SF_ERR_ARGUMENT);
    stroke.brush = brush;
    c.terms.act = c.grid;
    CHECK_EQ(sf_grid_emit(c.grid, &c.terms, &stroke, NULL, NULL), SF_ERR_ARGUMENT);
    c.terms.act = NULL;
    stack_read(&found, c.grid);
    CHECK(stack_equal(&found, &c.shape));
    // An empty brush leaves the path.
    stroke.path = path;
    stroke.count = 3;
    CHECK_EQ(sf_grid_emit(c.grid, &c.terms, &stroke, NULL, NULL), SF_OK);
    CHECK_EQ(sf_grid_popcount(c.grid), 4);
    sf_grid_destroy(forbid);
    sf_grid_destroy(brush);
    path_case_close(&c);
}

int main(void)
{
    TEST(any_brush_on_any_shape);
    TEST(support_free_stays_support_free);
    TEST(large_balls_need_trimming);
    TEST(sweeps_in_parts);
    TEST(what_may_not_be_is_refused);
    return test_finish();
}
