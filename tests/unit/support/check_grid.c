// SPDX-License-Identifier: MIT
// Why: the check of a whole grid must say what the stream says, bit for bit, whatever memory it
// starts with; leave report and findings alone when it fails (promise P2), for every allocation
// that can fail; and free what it took.

#include "failing_allocator.h"
#include "judge.h"

static void same_check(const pushed *a, const pushed *b)
{
    same_report(&a->report, &b->report);
    CHECK_EQ(a->finding_count, b->finding_count);
    for (size_t i = 0; i < a->finding_count && i < b->finding_count; i++) {
        same_finding(&a->findings[i], &b->findings[i]);
    }
}

static void whole_is_stream(void)
{
    static stack s;
    static pushed stream, whole;
    for (int i = 0; i < 120; i++) {
        int nx = stack_width(), ny = 1 + (int)test_random_below(12);
        stack_random_boxes(&s, nx, ny, 8, 9);
        sf_rule rule = rule_by_number(i);
        uint32_t bed = i % 3 == 0 ? test_random_below(8) : SF_BED_AUTO;
        sf_check_options o = pushed_options(&s, &rule, bed, &stream);
        o.finding_capacity = i % 4 == 0 ? 3 : o.finding_capacity;
        push_stack(&stream, &s, &o);
        o.findings = whole.findings;
        o.run_capacity = i % 2 == 0 ? 0 : o.run_capacity;
        o.width = 9999;
        o.first_layer = 7;
        sf_grid *grid = stack_grid(&s);
        CHECK_EQ(
            sf_grid_check(grid, &o, stack_allocator(), NULL, &whole.report, &whole.finding_count),
            SF_OK);
        same_check(&stream, &whole);
        sf_grid_destroy(grid);
    }
}

// More runs in a layer than the first guess has room for: a floating chequerboard.
static void many_runs(void)
{
    static sf_finding finding[2];
    sf_lattice lattice = stack_lattice(1024, 1024, 4);
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, stack_allocator(), &grid), SF_OK);
    CHECK_EQ(sf_slice_set(sf_grid_slice(grid, 0), 5, 5, 1), SF_OK);
    for (uint32_t k = 2; k < 4; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        for (size_t i = 0; i < slice.stride * slice.height; i++) {
            slice.words[i] = i / slice.stride % 2 ? 0xaaaaaaaaaaaaaaaau : 0x5555555555555555u;
        }
    }
    sf_check_options o = sf_check_options_default();
    o.findings = finding;
    o.finding_capacity = 2;
    sf_check_report report;
    size_t count;
    CHECK_EQ(sf_grid_check(grid, &o, stack_allocator(), NULL, &report, &count), SF_OK);
    CHECK_EQ(count, 1);
    CHECK_EQ(report.runs_dropped, 0);
    CHECK_EQ(report.island_count, 1);
    CHECK_EQ(finding[0].area, 1024 * 512);
    CHECK_EQ(finding[0].volume, 2 * 1024 * 512);
    sf_grid_destroy(grid);
}

static void failing_calls_change_nothing(void)
{
    static stack s;
    static pushed before, after;
    stack_random(&s, 30, 10, 6, 0.4);
    sf_grid *grid = stack_grid(&s);
    sf_rule rule = sf_rule_box3(), bad = {.kind = (sf_rule_kind)9};
    memset(&before, 0x5a, sizeof before);
    after = before;
    sf_check_options o = pushed_options(&s, &rule, SF_BED_AUTO, &after), p;
    CHECK_EQ(sf_grid_check(NULL, &o, stack_allocator(), NULL, &after.report, NULL),
             SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_check(grid, NULL, stack_allocator(), NULL, &after.report, NULL),
             SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_check(grid, &o, stack_allocator(), NULL, NULL, NULL), SF_ERR_ARGUMENT);
    p = o;
    p.rule = bad;
    CHECK_EQ(sf_grid_check(grid, &p, stack_allocator(), NULL, &after.report, NULL),
             SF_ERR_ARGUMENT);
    p = o;
    p.bed_layer = 6;
    CHECK_EQ(sf_grid_check(grid, &p, stack_allocator(), NULL, &after.report, NULL),
             SF_ERR_ARGUMENT);
    p = o;
    p.findings = NULL;
    CHECK_EQ(sf_grid_check(grid, &p, stack_allocator(), NULL, &after.report, NULL),
             SF_ERR_ARGUMENT);

    failing_allocator f;
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status == SF_ERR_MEMORY && k < 20; k++) {
        CHECK(memcmp(&before, &after, sizeof before) == 0);
        failing_begin(&f, k);
        status = sf_grid_check(grid, &o, &f.allocator, NULL, &after.report, &after.finding_count);
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
    CHECK_EQ(status, SF_OK);
    CHECK(f.requests >= 2);
    sf_grid_destroy(grid);
}

typedef struct watch {
    double last;
    int calls, backwards, cancel_at;
    sf_task *task;
} watch;

static void watching(void *user, double fraction)
{
    watch *w = user;
    w->backwards += fraction < w->last || fraction < 0.0 || fraction > 1.0;
    w->last = fraction;
    if (++w->calls == w->cancel_at) {
        sf_task_cancel(w->task);
    }
}

static void progress_and_cancel(void)
{
    static stack s;
    static pushed before, after;
    stack_random(&s, 30, 10, 6, 0.4);
    sf_grid *grid = stack_grid(&s);
    sf_rule rule = sf_rule_box3();
    memset(&before, 0x5a, sizeof before);
    for (int cancel_at = 1; cancel_at < 8; cancel_at++) {
        sf_task task = sf_task_default();
        watch w = {0.0, 0, 0, cancel_at, &task};
        task.progress = watching;
        task.user = &w;
        after = before;
        sf_check_options o = pushed_options(&s, &rule, SF_BED_AUTO, &after);
        sf_status status =
            sf_grid_check(grid, &o, stack_allocator(), &task, &after.report, &after.finding_count);
        // Six layers: once the last one is through there is nothing left to cancel.
        CHECK_EQ(status, cancel_at < 6 ? SF_ERR_CANCELLED : SF_OK);
        CHECK(status == SF_OK || memcmp(&before, &after, sizeof before) == 0);
        CHECK(status != SF_OK || w.last == 1.0);
        CHECK_EQ(w.backwards, 0);
    }
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(whole_is_stream);
    TEST(many_runs);
    TEST(failing_calls_change_nothing);
    TEST(progress_and_cancel);
    return test_finish();
}
