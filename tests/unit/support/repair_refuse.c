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

// A task and an allocator that cancel at the n-th report, or at the n-th request for memory, and
// count what is still asked of them afterwards.
typedef struct watch {
    sf_task task;
    failing_allocator memory;
    sf_allocator allocator;
    long reports, at_report, at_request; // negative: never
    long late_reports, late_requests;
    int is_cancelled;
} watch;

static void cancel_when(watch *w, int is_time)
{
    if (is_time) {
        w->is_cancelled = 1;
        sf_task_cancel(&w->task);
    }
}

static void watch_report(void *user, double fraction)
{
    watch *w = user;
    (void)fraction;
    w->late_reports += w->is_cancelled;
    cancel_when(w, w->reports++ == w->at_report);
}

static void *watch_alloc(void *user, size_t size, size_t align)
{
    watch *w = user;
    w->late_requests += w->is_cancelled;
    cancel_when(w, w->memory.requests == w->at_request);
    return w->memory.allocator.alloc(&w->memory, size, align);
}

static void watch_free(void *user, void *memory, size_t size)
{
    watch *w = user;
    w->memory.allocator.free(&w->memory, memory, size);
}

static sf_status watched_repair(scene *s, watch *w, long at_report, long at_request)
{
    memset(w, 0, sizeof *w);
    failing_begin(&w->memory, -1);
    w->task = sf_task_default();
    w->task.progress = watch_report;
    w->task.user = w;
    w->allocator = (sf_allocator){watch_alloc, watch_free, w};
    w->at_report = at_report;
    w->at_request = at_request;
    return sf_grid_repair(s->grid, &s->options, &w->allocator, &w->task, s->culprits, NULL);
}

// After a cancel: no report but one of a layer that was at work, and no memory but for what was
// about to begin.
#define LATE_REQUESTS_MOST 40

static void stops_soon_after_a_cancel(void)
{
    long most = 0, runs = 0;
    for (int number = 0; number < 36 && test_case_failures == 0; number++) {
        for (int by_memory = 0; by_memory < 2; by_memory++) {
            sf_status status = SF_ERR_CANCELLED;
            for (long n = 0; status == SF_ERR_CANCELLED; n += 1 + n / 16) {
                static watch w;
                scene s;
                test_reseed((uint64_t)number + 1);
                scene_begin(&s, number, 1 + number % 2);
                status = watched_repair(&s, &w, by_memory ? -1 : n, by_memory ? n : -1);
                CHECK(w.late_reports <= 1);
                CHECK(w.late_requests <= LATE_REQUESTS_MOST);
                CHECK_EQ(w.memory.live, 0);
                most = w.late_requests > most ? w.late_requests : most;
                runs += status == SF_OK;
                if (status == SF_ERR_CANCELLED) {
                    nothing_changed(&s);
                }
                scene_end(&s);
            }
        }
    }
    printf("# at most %ld requests after a cancel, in %ld whole runs\n", most, runs);
}

// Each report is a place where a cancel is heard, and each layer of each sweep is one: of the trims
// too, of which a first result has three, and three other sweeps.
static void reports_every_layer_of_every_sweep(void)
{
    static const uint32_t rounds[3] = {SF_REPAIR_FIRST, 1, 0};
    static const long sweeps[3] = {6, 50, 95};
    static watch w;
    enum { LAYERS = 40 };
    scene s;
    scene_begin(&s, 1, 1);
    for (int i = 0; i < 3; i++) {
        sf_lattice lattice = {12, 12, LAYERS, 1, 1, 1, NULL, {0, 0, 0}};
        sf_rect all = {0, 0, 12, 12}, part = {2, 3, 9, 9};
        scene t = s;
        CHECK_EQ(sf_grid_create(&lattice, NULL, &t.grid), SF_OK);
        CHECK_EQ(sf_slice_fill(sf_grid_slice(t.grid, 0), all, 1), SF_OK);
        for (uint32_t k = LAYERS - 6; k < LAYERS; k++) {
            CHECK_EQ(sf_slice_fill(sf_grid_slice(t.grid, k), part, 1), SF_OK);
        }
        t.culprits = NULL;
        t.options = sf_repair_options_default();
        t.options.rounds = rounds[i];
        CHECK_EQ(watched_repair(&t, &w, -1, -1), SF_OK);
        CHECK(w.reports >= sweeps[i] * LAYERS);
        printf("# %ld reports\n", w.reports);
        sf_grid_destroy(t.grid);
    }
    scene_end(&s);
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
    TEST(stops_soon_after_a_cancel);
    TEST(reports_every_layer_of_every_sweep);
    TEST(knows_how_much_memory_it_took);
    return test_finish();
}
