// SPDX-License-Identifier: MIT
// Why: a call that fails leaves every object as it was and gives back what it took, whether it was
// refused, ran out of memory or was cancelled; whoever holds the only copy of a shape relies on it.

#include "failing_allocator.h"
#include "unit/support/repair_oracle.h"

typedef struct scene {
    sf_grid *grid, *before, *culprits, *untouched, *masks[MASK_COUNT];
    sf_repair_options options;
} scene;

static job j;

static void scene_begin(scene *s, int number, int width)
{
    random_job(&j, number, 9);
    j.shape.nx = j.shape.nx; // as it came
    s->grid = stack_grid(&j.shape);
    s->before = stack_grid(&j.shape);
    s->culprits = stack_grid(&j.masks[MASK_ACT]);
    s->untouched = stack_grid(&j.masks[MASK_ACT]);
    for (int m = 0; m < MASK_COUNT; m++) {
        s->masks[m] = stack_grid(&j.masks[m]);
    }
    s->options = sf_repair_options_default();
    s->options.terms.rule = j.rule;
    s->options.terms.exempt = s->masks[MASK_EXEMPT];
    s->options.min_feature_vx = (uint32_t)width;
    if (number % 2 == 0) {
        s->options.terms.keep = s->masks[MASK_KEEP];
        s->options.terms.act = s->masks[MASK_ACT];
    }
}

static void scene_end(scene *s)
{
    sf_grid_destroy(s->grid);
    sf_grid_destroy(s->before);
    sf_grid_destroy(s->culprits);
    sf_grid_destroy(s->untouched);
    for (int m = 0; m < MASK_COUNT; m++) {
        sf_grid_destroy(s->masks[m]);
    }
}

static void nothing_changed(const scene *s)
{
    CHECK(sf_grid_equal(s->grid, s->before));
    CHECK(sf_grid_equal(s->culprits, s->untouched));
}

static void gives_everything_back_when_memory_is_short(void)
{
    for (int number = 0; number < 54 && test_case_failures == 0; number++) {
        scene s;
        scene_begin(&s, number, 1 + number % 3);
        for (long at = 0;; at++) {
            failing_allocator f;
            sf_repair_report r = {.cost = 12345};
            failing_begin(&f, at);
            sf_status status =
                sf_grid_repair(s.grid, &s.options, &f.allocator, NULL, s.culprits, &r);
            CHECK_EQ(f.live, 0);
            CHECK_EQ(f.faults, 0);
            if (status != SF_ERR_MEMORY) {
                CHECK(status == SF_OK || status == SF_ERR_INFEASIBLE);
                CHECK(f.requests <= at);
                break;
            }
            CHECK_EQ(r.cost, 12345);
            nothing_changed(&s);
        }
        scene_end(&s);
    }
}

// A task that cancels itself when it has been asked `left` times to report.
typedef struct patience {
    sf_task task;
    int left;
    double last;
} patience;

static void lose_patience(void *user, double fraction)
{
    patience *p = user;
    CHECK(fraction >= p->last && fraction <= 1);
    p->last = fraction;
    if (p->left-- == 0) {
        sf_task_cancel(&p->task);
    }
}

static void changes_nothing_when_cancelled(void)
{
    for (int number = 1; number < 40 && test_case_failures == 0; number++) {
        for (int left = 0;; left++) {
            scene s;
            scene_begin(&s, number, 1 + number % 2);
            test_reseed((uint64_t)number);
            patience p = {sf_task_default(), left, 0};
            p.task.progress = lose_patience;
            p.task.user = &p;
            sf_status status = sf_grid_repair(s.grid, &s.options, NULL, &p.task, s.culprits, NULL);
            if (status == SF_ERR_CANCELLED) {
                nothing_changed(&s);
            }
            scene_end(&s);
            if (status != SF_ERR_CANCELLED) {
                CHECK(status == SF_OK || status == SF_ERR_INFEASIBLE);
                break;
            }
        }
    }
}

static void changes_nothing_when_cancelled_before(void)
{
    scene s;
    sf_task task = sf_task_default();
    scene_begin(&s, 1, 1);
    sf_task_cancel(&task);
    CHECK_EQ(sf_grid_repair(s.grid, &s.options, NULL, &task, s.culprits, NULL), SF_ERR_CANCELLED);
    nothing_changed(&s);
    scene_end(&s);
}

#define REFUSED(code, change)                                                                      \
    do {                                                                                           \
        sf_repair_options o = s.options;                                                           \
        change;                                                                                    \
        CHECK_EQ(sf_grid_repair(s.grid, &o, NULL, NULL, s.culprits, NULL), code);                  \
        nothing_changed(&s);                                                                       \
    } while (0)

static void refuses_what_is_wrong(void)
{
    scene s;
    scene_begin(&s, 1, 1);
    sf_lattice other = sf_grid_lattice(s.grid);
    other.nz++;
    sf_grid *stranger = NULL;
    CHECK_EQ(sf_grid_create(&other, NULL, &stranger), SF_OK);
    REFUSED(SF_ERR_ARGUMENT, o.struct_size = 0);
    REFUSED(SF_ERR_ARGUMENT, o.terms.struct_size = 0);
    REFUSED(SF_ERR_ARGUMENT, o.min_feature_vx = 0);
    REFUSED(SF_ERR_ARGUMENT, o.min_feature_vx = SF_REACH_MAX + 1);
    REFUSED(SF_ERR_ARGUMENT, o.terms.bed_layer = 1000);
    REFUSED(SF_ERR_ARGUMENT, o.terms.keep = s.grid);
    REFUSED(SF_ERR_ARGUMENT, o.terms.act = s.culprits);
    REFUSED(SF_ERR_SHAPE, o.terms.forbid = stranger);
    memset(j.add, 1, sizeof j.add);
    j.add[stack_count(&j.shape) - 1] = 0;
    REFUSED(SF_ERR_ARGUMENT, o.add_cost = j.add);
    REFUSED(SF_ERR_ARGUMENT, o.remove_cost = j.add);
    CHECK_EQ(sf_grid_repair(NULL, &s.options, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_repair(s.grid, NULL, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_repair(s.grid, &s.options, NULL, NULL, s.grid, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_repair(s.grid, &s.options, NULL, NULL, stranger, NULL), SF_ERR_SHAPE);
    nothing_changed(&s);
    sf_grid_destroy(stranger);
    scene_end(&s);
}

static void knows_how_much_memory_it_took(void)
{
    scene s;
    sf_repair_report r;
    scene_begin(&s, 1, 1);
    CHECK_EQ(sf_grid_repair(s.grid, &s.options, NULL, NULL, NULL, &r), SF_OK);
    sf_slice slice = sf_grid_slice(s.grid, 0);
    CHECK(r.peak_memory >= 4 * slice.stride * slice.height * sizeof(uint64_t));
    scene_end(&s);
}

int main(void)
{
    TEST(refuses_what_is_wrong);
    TEST(gives_everything_back_when_memory_is_short);
    TEST(changes_nothing_when_cancelled);
    TEST(changes_nothing_when_cancelled_before);
    TEST(knows_how_much_memory_it_took);
    return test_finish();
}
