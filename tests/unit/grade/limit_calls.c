// SPDX-License-Identifier: MIT
// Why: who paints changes values and asks again, from a window that must not die. Updates are held
// against limits made anew, many places at once against one by one; what cannot be asked is refused
// and writes nothing; without memory there is no limit, and nothing is left behind. Progress never
// falls, and whoever cancels gets nothing.

#include "failing_allocator.h"
#include "limits.h"

#include <sf/sample.h>

enum { COUNT = 1500 };

static void updates_are_those_of_a_limit_made_anew(void)
{
    static sf_place places[COUNT];
    static double a[3 * COUNT], b[3 * COUNT];
    test_cage c = kind_of(2);
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
    for (size_t i = 0; i < 3 * c.points; i++) {
        c.positions[i] += 0.1 * test_random_unit();
        c.values[i / 3] = test_random_unit();
    }
    CHECK_EQ(sf_limit_update_positions(limit, c.positions, NULL), SF_OK);
    CHECK_EQ(sf_limit_update_values(limit, 0, c.values, NULL), SF_OK);
    CHECK_EQ(sf_limit_update_values(limit, 1, c.values, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_limit_update_positions(NULL, c.positions, NULL), SF_ERR_ARGUMENT);
    sf_limit *anew = limit_of(&c, SF_REFINE_STANDARD);
    for (int i = 0; i < COUNT; i++) {
        places[i] = random_place(limit);
    }
    CHECK_EQ(sf_limit_positions(limit, COUNT, places, NULL, NULL, a, NULL), SF_OK);
    CHECK_EQ(sf_limit_positions(anew, COUNT, places, NULL, NULL, b, NULL), SF_OK);
    CHECK(memcmp(a, b, sizeof a) == 0);
    CHECK_EQ(sf_limit_values(limit, 0, COUNT, places, NULL, NULL, a, NULL), SF_OK);
    for (int i = 0; i < COUNT; i += 100) { // one by one is the same
        CHECK_EQ(sf_limit_values(anew, 0, 1, &places[i], NULL, NULL, b, NULL), SF_OK);
        CHECK(a[i] == b[0]);
    }
    sf_limit_destroy(anew);
    sf_limit_destroy(limit);
    test_cage_free(&c);
}

static void what_cannot_be_asked_is_refused(void)
{
    test_cage c = kind_of(5); // wedges
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD), *none = NULL;
    CHECK_EQ(sf_limit_piece_count(limit), 36);
    CHECK_EQ(sf_limit_piece_count(NULL), 0);
    sf_place place = {36, {0, 0, 0}};
    double p[3] = {7, 7, 7}, u[3] = {0, 0, 0};
    CHECK_EQ(sf_limit_positions(limit, 1, &place, NULL, NULL, p, NULL), SF_ERR_ARGUMENT);
    place.piece = 0;
    place.u[1] = 1.001;
    CHECK_EQ(sf_limit_positions(limit, 1, &place, NULL, NULL, p, NULL), SF_ERR_ARGUMENT);
    place.u[1] = NAN;
    CHECK_EQ(sf_limit_positions(limit, 1, &place, NULL, NULL, p, NULL), SF_ERR_ARGUMENT);
    place.u[1] = 0;
    CHECK_EQ(sf_limit_values(limit, 1, 1, &place, NULL, NULL, p, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_limit_positions(limit, 1, NULL, NULL, NULL, p, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_limit_positions(limit, 0, NULL, NULL, NULL, NULL, NULL), SF_OK);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_limit_positions(limit, 1, &place, NULL, &task, p, NULL), SF_ERR_CANCELLED);
    CHECK(p[0] == 7 && p[2] == 7);
    CHECK_EQ(sf_limit_place(limit, 0, u, &place), SF_ERR_UNSUPPORTED);
    CHECK_EQ(sf_limit_place(limit, 6, u, &place), SF_ERR_ARGUMENT);
    sf_cage *cage = test_cage_make(&c);
    CHECK_EQ(sf_limit_create(cage, SF_REFINE_STANDARD, NULL, &task, &none), SF_ERR_CANCELLED);
    CHECK(none == NULL);
    sf_cage_destroy(cage);
    sf_limit_destroy(limit);
    sf_limit_destroy(NULL);
    test_cage_free(&c);
}

static void without_memory_there_is_no_limit(void)
{
    test_cage c = kind_of(1);
    c.indices = calloc(8 * c.cells, sizeof *c.indices);
    c.indices[5] = 1;
    c.value_count = 2;
    sf_cage *cage = test_cage_make(&c);
    failing_allocator memory;
    sf_status status = SF_ERR_MEMORY;
    // Thousands: all of the first kind of neighbourhood, some of the others.
    for (long k = 0; status != SF_OK; k += k < 400 ? 1 : 37) {
        failing_begin(&memory, k);
        sf_limit *limit = NULL;
        status = sf_limit_create(cage, SF_REFINE_STANDARD, &memory.allocator, NULL, &limit);
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && limit == NULL));
        sf_limit_destroy(limit);
        CHECK(memory.live == 0 && memory.faults == 0);
    }
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
    sf_place place = {0, {0.5, 0.5, 0.5}};
    double p[3];
    failing_begin(&memory, 0);
    CHECK_EQ(sf_limit_positions(limit, 1, &place, &memory.allocator, NULL, p, NULL), SF_ERR_MEMORY);
    sf_limit_destroy(limit);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

typedef struct watch {
    sf_task task;
    double last;
    int falls, calls, cancel_at;
} watch;

static void look(void *user, double fraction)
{
    watch *w = user;
    w->falls += fraction < w->last || fraction > 1;
    w->last = fraction;
    if (++w->calls == w->cancel_at) {
        sf_task_cancel(&w->task);
    }
}

static sf_status run(int call, const sf_cage *cage, const sf_limit *limit, watch *w)
{
    double low[3], high[3];
    sf_limit *made = NULL;
    sf_sampler *sampler = NULL;
    sf_refinement *refined = NULL;
    sf_lattice l = {20, 20, 20, 0.4, 0.4, 0.4, NULL, {0, 0, 0}};
    sf_refine_options steps = sf_refine_options_default();
    steps.steps = 3;
    w->task = sf_task_default();
    w->task.progress = look;
    w->task.user = w;
    w->last = 0;
    w->falls = w->calls = 0;
    sf_status status =
        call == 0   ? sf_limit_create(cage, SF_REFINE_STANDARD, NULL, &w->task, &made)
        : call == 1 ? sf_refine(cage, &steps, NULL, &w->task, &refined)
        : call == 2 ? sf_limit_bounds(limit, NULL, &w->task, low, high)
                    : sf_sampler_create(limit, &l, NULL, 0, NULL, NULL, &w->task, &sampler, NULL);
    CHECK(status == SF_OK || (made == NULL && refined == NULL && sampler == NULL));
    sf_limit_destroy(made);
    sf_refinement_destroy(refined);
    sf_sampler_destroy(sampler);
    return status;
}

static void progress_never_falls_and_cancelling_leaves_nothing(void)
{
    test_cage c = test_cage_block(8, 8, 8);
    sf_cage *cage = test_cage_make(&c);
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
    for (int call = 0; call < 4; call++) {
        watch w;
        w.cancel_at = 0;
        CHECK_EQ(run(call, cage, limit, &w), SF_OK);
        CHECK(w.falls == 0 && w.calls > 1);
        w.cancel_at = 1;
        CHECK_EQ(run(call, cage, limit, &w), SF_ERR_CANCELLED);
        CHECK_EQ(w.falls, 0);
    }
    sf_limit_destroy(limit);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

int main(void)
{
    TEST(updates_are_those_of_a_limit_made_anew);
    TEST(what_cannot_be_asked_is_refused);
    TEST(without_memory_there_is_no_limit);
    TEST(progress_never_falls_and_cancelling_leaves_nothing);
    return test_finish();
}
