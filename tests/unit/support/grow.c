// SPDX-License-Identifier: MIT
// Why: whoever calls grow must be able to trust that a call that fails left everything as it was,
// at whatever request for memory and at whatever moment of a cancel (promise P2, TRUST 84-86), that
// what makes no sense is refused, and that progress never falls. That the answers are right is in
// tests/law.

#include "failing_allocator.h"
#include "law/stack.h"

#include <sf/grow.h>

typedef struct setting {
    stack shape;
    sf_grid *grid, *forbid;
    sf_terms terms;
} setting;

// A shape with much in the air, a mask, and a rule that asks for all that grow can keep.
static void open_setting(setting *s, int variant)
{
    stack_random_boxes(&s->shape, 40, 24, 20, 9);
    for (int i = 0; i < 40 * 24 * 6; i++) {
        s->shape.solid[i] = i % 97 == 0 && i < 40 * 24;
    }
    static stack mask;
    stack_random(&mask, 40, 24, 20, 0.02);
    s->grid = stack_grid(&s->shape);
    s->forbid = stack_grid(&mask);
    s->terms = sf_terms_default();
    s->terms.bed_layer = 0;
    s->terms.forbid = variant % 2 == 1 ? s->forbid : NULL;
    s->terms.rule = variant < 2 ? sf_rule_box3() : rule_of_angle(SF_RULE_SLACK, 50.0);
    if (variant == 3) {
        s->terms.rule.bridge.span_x = 5;
    }
}

static void close_setting(setting *s)
{
    sf_grid_destroy(s->grid);
    sf_grid_destroy(s->forbid);
}

static void check_unchanged(const setting *s)
{
    static stack now;
    stack_read(&now, s->grid);
    CHECK(stack_equal(&now, &s->shape));
}

// --- memory ------------------------------------------------------------------------------------

enum { CALL_FINDER, CALL_MAP, CALL_EMIT, CALL_GROW, CALLS };

static sf_status call_finder(setting *s, const sf_allocator *allocator, sf_task *task)
{
    sf_path_finder *finder = NULL;
    sf_voxel from = {20, 12, 19}, path[20];
    sf_path found = {99, SF_PATH_END_BED, {0, 0, 0}, 0, 0};
    sf_landing landing = s->terms.forbid != NULL ? SF_LANDING_ALIVE : SF_LANDING_ANY;
    sf_status status = sf_path_finder_create(s->grid, &s->terms, landing, allocator, task, &finder);
    if (status != SF_OK) {
        CHECK(finder == NULL);
        return status;
    }
    status = sf_path_finder_refresh(finder, task);
    if (status == SF_OK) {
        status = sf_path_finder_find(finder, from, path, 20, &found);
        CHECK(status == SF_OK || found.count == 99);
        status = status == SF_ERR_INFEASIBLE ? SF_OK : status;
    }
    sf_path_finder_destroy(finder);
    return status;
}

static sf_status call_map(setting *s, const sf_allocator *allocator, sf_task *task)
{
    sf_path_map_options options = sf_path_map_options_default();
    sf_path_map *map = NULL;
    sf_terms terms = s->terms;
    if (terms.rule.kind == SF_RULE_SLACK) {
        terms.rule = sf_rule_box3();
        options.cost = SF_PATH_COST_NEARNESS;
        options.landing = SF_LANDING_ALIVE;
    }
    sf_status status = sf_path_map_create(s->grid, &terms, &options, allocator, task, &map);
    CHECK((status == SF_OK) == (map != NULL));
    sf_path_map_destroy(map);
    return status;
}

static sf_status call_emit(setting *s, const sf_allocator *allocator)
{
    static stack box;
    sf_voxel path[3] = {{20, 12, 2}, {20, 12, 1}, {20, 12, 0}}, anchor = {1, 1, 1};
    sf_terms terms = s->terms;
    terms.forbid = NULL;
    stack_random(&box, 3, 3, 3, 1.0);
    sf_grid *brush = stack_grid(&box);
    sf_stroke stroke = {brush, anchor, path, 3};
    sf_emit_report report = {99, 99};
    sf_status status = sf_grid_emit(s->grid, &terms, &stroke, allocator, &report);
    CHECK((status == SF_OK) == (report.added_voxels != 99));
    sf_grid_destroy(brush);
    return status;
}

static sf_status call_grow(setting *s, const sf_allocator *allocator, sf_task *task)
{
    sf_grow_report report = {99, 99, 99};
    sf_status status = sf_grid_grow(s->grid, &s->terms, allocator, task, NULL, &report);
    CHECK((status == SF_OK) == (report.bed_layer != 99));
    return status;
}

static sf_status call(int which, setting *s, const sf_allocator *allocator, sf_task *task)
{
    return which == CALL_FINDER ? call_finder(s, allocator, task)
           : which == CALL_MAP  ? call_map(s, allocator, task)
           : which == CALL_EMIT ? call_emit(s, allocator)
                                : call_grow(s, allocator, task);
}

static void refused_memory_changes_nothing(void)
{
    static setting s;
    for (int variant = 0; variant < 4; variant++) {
        for (int which = 0; which < CALLS; which++) {
            sf_status status = SF_ERR_MEMORY;
            open_setting(&s, variant);
            for (long at = 0; status == SF_ERR_MEMORY && at < 400; at++) {
                failing_allocator memory;
                failing_begin(&memory, at);
                status = call(which, &s, &memory.allocator, NULL);
                CHECK_EQ(memory.live, 0);
                CHECK_EQ(memory.faults, 0);
                if (status != SF_OK) {
                    check_unchanged(&s);
                }
            }
            CHECK_EQ(status, SF_OK);
            close_setting(&s);
        }
    }
}

// --- cancel ------------------------------------------------------------------------------------

typedef struct watch {
    sf_task *task;
    int calls, cancel_at, backwards;
    double last;
} watch;

static void watching(void *user, double fraction)
{
    watch *w = user;
    w->backwards += fraction < w->last || fraction > 1.0;
    w->last = fraction;
    if (w->calls++ == w->cancel_at) {
        sf_task_cancel(w->task);
    }
}

static void a_cancel_changes_nothing(void)
{
    static setting s;
    for (int variant = 0; variant < 4; variant++) {
        for (int which = 0; which < CALLS; which++) {
            sf_status status = SF_ERR_CANCELLED;
            for (int at = -1; status == SF_ERR_CANCELLED && which != CALL_EMIT && at < 400; at++) {
                open_setting(&s, variant);
                sf_task task = sf_task_default();
                watch w = {&task, 0, at, 0, 0.0};
                task.progress = watching;
                task.user = &w;
                if (at < 0) {
                    sf_task_cancel(&task);
                }
                status = call(which, &s, NULL, &task);
                if (which != CALL_FINDER) {
                    CHECK_EQ(w.backwards, 0); // a finder is two calls
                }
                if (status != SF_OK) {
                    CHECK_EQ(status, SF_ERR_CANCELLED);
                    check_unchanged(&s);
                }
                close_setting(&s);
            }
            CHECK(which == CALL_EMIT || status == SF_OK);
        }
    }
}

// --- what makes no sense -----------------------------------------------------------------------

static void nonsense_is_refused(void)
{
    static setting s;
    open_setting(&s, 0);
    sf_path_finder *finder = NULL;
    sf_path_map *map = NULL;
    sf_path found;
    sf_voxel inside = {0, 0, 19}, outside = {40, 0, 0}, path[20];
    sf_path_map_options options = sf_path_map_options_default();
    sf_terms bad = s.terms;
    bad.bed_layer = 20;
    CHECK_EQ(sf_path_finder_create(NULL, &s.terms, SF_LANDING_ANY, NULL, NULL, &finder), 1);
    CHECK_EQ(sf_path_finder_create(s.grid, NULL, SF_LANDING_ANY, NULL, NULL, &finder), 1);
    CHECK_EQ(sf_path_finder_create(s.grid, &bad, SF_LANDING_ANY, NULL, NULL, &finder), 1);
    CHECK_EQ(sf_path_finder_create(s.grid, &s.terms, (sf_landing)2, NULL, NULL, &finder), 1);
    CHECK_EQ(sf_path_finder_create(s.grid, &s.terms, SF_LANDING_ANY, NULL, NULL, NULL), 1);
    CHECK_EQ(sf_path_finder_create(s.grid, &s.terms, SF_LANDING_ANY, NULL, NULL, &finder), SF_OK);
    CHECK_EQ(sf_path_finder_find(finder, outside, path, 20, &found), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_path_finder_find(finder, inside, NULL, 20, &found), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_path_finder_find(finder, inside, path, 20, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_path_finder_find(NULL, inside, path, 20, &found), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_path_finder_refresh(NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_path_map_create(s.grid, &s.terms, NULL, NULL, NULL, &map), SF_ERR_ARGUMENT);
    options.cost = (sf_path_cost)2;
    CHECK_EQ(sf_path_map_create(s.grid, &s.terms, &options, NULL, NULL, &map), SF_ERR_ARGUMENT);
    options = sf_path_map_options_default();
    bad = s.terms;
    bad.rule = rule_of_angle(SF_RULE_SLACK, 45.0);
    CHECK_EQ(sf_path_map_create(s.grid, &bad, &options, NULL, NULL, &map), SF_ERR_UNSUPPORTED);
    CHECK_EQ(sf_path_map_create(s.grid, &s.terms, &options, NULL, NULL, &map), SF_OK);
    CHECK_EQ(sf_path_map_walk(map, outside, path, 20, &found), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_path_map_walk(map, inside, path, 20, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_grow(NULL, &s.terms, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_grow(s.grid, NULL, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_grow(s.grid, &s.terms, NULL, NULL, s.grid, NULL), SF_ERR_ARGUMENT);
    bad = s.terms;
    bad.forbid = s.grid;
    CHECK_EQ(sf_grid_grow(s.grid, &bad, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    sf_lattice other = stack_lattice(4, 4, 4);
    sf_grid *small = NULL;
    CHECK_EQ(sf_grid_create(&other, NULL, &small), SF_OK);
    CHECK_EQ(sf_grid_grow(s.grid, &s.terms, NULL, NULL, small, NULL), SF_ERR_SHAPE);
    sf_grow_report report;
    sf_terms by_itself = sf_terms_default();
    CHECK_EQ(sf_grid_grow(small, &by_itself, NULL, NULL, NULL, &report), SF_OK);
    CHECK(report.added_voxels == 0 && report.bed_layer == SF_BED_AUTO);
    check_unchanged(&s);
    sf_grid_destroy(small);
    sf_path_finder_destroy(finder);
    sf_path_map_destroy(map);
    sf_path_finder_destroy(NULL);
    sf_path_map_destroy(NULL);
    close_setting(&s);
}

static void a_short_array_is_told_the_need(void)
{
    static stack s;
    stack_clear(&s, 5, 5, 9);
    sf_grid *grid = stack_grid(&s);
    sf_terms terms = sf_terms_default(); // the bed of an empty grid is layer 0
    sf_path_finder *finder = NULL;
    sf_path_map *map = NULL;
    sf_path_map_options options = sf_path_map_options_default();
    CHECK_EQ(sf_path_finder_create(grid, &terms, SF_LANDING_ANY, NULL, NULL, &finder), SF_OK);
    CHECK_EQ(sf_path_map_create(grid, &terms, &options, NULL, NULL, &map), SF_OK);
    sf_voxel from = {2, 2, 8}, path[8] = {{7, 7, 7}};
    sf_path found;
    CHECK_EQ(sf_path_finder_find(finder, from, path, 7, &found), SF_ERR_CAPACITY);
    CHECK(found.count == 8 && path[0].x == 7);
    CHECK_EQ(sf_path_map_walk(map, from, path, 7, &found), SF_ERR_CAPACITY);
    CHECK(found.count == 8 && path[0].x == 7);
    CHECK_EQ(sf_path_finder_find(finder, from, NULL, 0, &found), SF_ERR_CAPACITY);
    CHECK_EQ(sf_path_finder_find(finder, from, path, 8, &found), SF_OK);
    for (uint32_t i = 0; i < 8; i++) {
        CHECK(path[i].x == 2 && path[i].y == 2 && path[i].z == 7 - i); // straight down
    }
    // A finder of the plain kind sees what changed at once; one that keeps what is alive, after a
    // refresh.
    CHECK_EQ(sf_slice_set(sf_grid_slice(grid, 3), 1, 2, 1), SF_OK);
    CHECK_EQ(sf_path_finder_find(finder, from, path, 8, &found), SF_OK);
    CHECK(found.count == 4 && found.end == SF_PATH_END_MATTER && found.landing.x == 1);
    sf_path_finder_destroy(finder);
    terms.bed_layer = 0;
    CHECK_EQ(sf_path_finder_create(grid, &terms, SF_LANDING_ALIVE, NULL, NULL, &finder), SF_OK);
    for (uint32_t z = 0; z < 3; z++) {
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, z), 1, 2, 1), SF_OK);
    }
    CHECK_EQ(sf_path_finder_find(finder, from, path, 8, &found), SF_OK);
    CHECK(found.count == 8 && found.end == SF_PATH_END_BED);
    CHECK_EQ(sf_path_finder_refresh(finder, NULL), SF_OK);
    CHECK_EQ(sf_path_finder_find(finder, from, path, 8, &found), SF_OK);
    CHECK(found.count == 4 && found.end == SF_PATH_END_MATTER);
    sf_path_finder_destroy(finder);
    sf_path_map_destroy(map);
    sf_grid_destroy(grid);
}

// What is exempt needs nothing below it, so it has its path, an empty one, even where no path can
// be: below the bed. All else down there has none.
static void an_exempt_voxel_stands_below_the_bed_too(void)
{
    static stack s, mask;
    stack_clear(&s, 5, 4, 6);
    stack_clear(&mask, 5, 4, 6);
    *stack_at(&mask, 2, 2, 1) = 1;
    sf_grid *grid = stack_grid(&s), *exempt = stack_grid(&mask);
    sf_terms terms = sf_terms_default();
    terms.bed_layer = 3;
    terms.exempt = exempt;
    for (int i = 0; i < 2; i++) {
        sf_path_finder *finder = NULL;
        sf_path_map *map = NULL;
        sf_path_map_options options = sf_path_map_options_default();
        sf_voxel held = {2, 2, 1}, beside = {1, 2, 1}, above = {2, 2, 2}, on_bed = {2, 2, 3};
        sf_path found;
        CHECK_EQ(sf_path_map_create(grid, &terms, &options, NULL, NULL, &map), SF_OK);
        terms.rule = i == 0 ? sf_rule_box3() : rule_of_angle(SF_RULE_SLACK, 45.0);
        CHECK_EQ(sf_path_finder_create(grid, &terms, SF_LANDING_ANY, NULL, NULL, &finder), SF_OK);
        CHECK_EQ(sf_path_finder_find(finder, held, NULL, 0, &found), SF_OK);
        CHECK(found.count == 0 && found.end == SF_PATH_END_HELD && found.landing.z == 1);
        CHECK_EQ(sf_path_map_walk(map, held, NULL, 0, &found), SF_OK);
        CHECK(found.count == 0 && found.end == SF_PATH_END_HELD && found.landing.z == 1);
        CHECK_EQ(sf_path_finder_find(finder, beside, NULL, 0, &found), SF_ERR_INFEASIBLE);
        CHECK_EQ(sf_path_map_walk(map, beside, NULL, 0, &found), SF_ERR_INFEASIBLE);
        CHECK_EQ(sf_path_finder_find(finder, above, NULL, 0, &found), SF_ERR_INFEASIBLE);
        CHECK_EQ(sf_path_finder_find(finder, on_bed, NULL, 0, &found), SF_OK);
        CHECK(found.count == 0 && found.end == SF_PATH_END_BED);
        sf_path_finder_destroy(finder);
        sf_path_map_destroy(map);
        terms.rule = sf_rule_box3();
    }
    sf_grid_destroy(grid);
    sf_grid_destroy(exempt);
}

int main(void)
{
    TEST(refused_memory_changes_nothing);
    TEST(a_cancel_changes_nothing);
    TEST(nonsense_is_refused);
    TEST(a_short_array_is_told_the_need);
    TEST(an_exempt_voxel_stands_below_the_bed_too);
    return test_finish();
}
