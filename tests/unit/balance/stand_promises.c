// SPDX-License-Identifier: MIT
// Why: nothing is lost and nothing half done. What makes no sense is refused with a sentence; a
// cancelled run goes on to the same bytes; memory may fail anywhere (TRUST 85, 86).

#include "failing_allocator.h"
#include "standing.h"

static sf_status create(sf_mesh_view mesh, const sf_stance_options *stance, size_t stances,
                        const sf_handle *handles, size_t count, const sf_stand_options *o)
{
    sf_stand *stand = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status =
        sf_stand_create(mesh, stance, stances, handles, count, o, NULL, NULL, &stand, &fault);
    CHECK(status == SF_OK || (stand == NULL && fault.message[0] != '\0'));
    sf_stand_destroy(stand);
    return status;
}

static void nonsense_is_refused(void)
{
    sf_mesh *mesh = bottle(0.2);
    sf_mesh_view view = sf_mesh_get_view(mesh), open = view;
    sf_stance_options stance = sf_stance_options_default(), none = stance;
    sf_stand_options o = options_of(1, SF_CARVE_PLANE), bad;
    sf_handle handles[3], outside = {.at_mm = {99, 0, 0}}, base = {.kind = SF_HANDLE_BASE};
    handles_of(0.2, handles);
    open.triangle_count--;
    CHECK_EQ(create(open, &stance, 1, handles, 3, &o), SF_ERR_UNSUPPORTED);
    CHECK_EQ(create(view, NULL, 1, handles, 3, &o), SF_ERR_ARGUMENT);
    CHECK_EQ(create(view, &stance, 0, handles, 3, &o), SF_ERR_ARGUMENT);
    CHECK_EQ(create(view, &stance, 33, handles, 3, &o), SF_ERR_ARGUMENT);
    CHECK_EQ(create(view, &stance, 1, NULL, 3, &o), SF_ERR_ARGUMENT);
    CHECK_EQ(create(view, &stance, 1, handles, 64, &o), SF_ERR_ARGUMENT);
    CHECK_EQ(create(view, &stance, 1, &outside, 1, &o), SF_ERR_INFEASIBLE);
    CHECK_EQ(create(view, &stance, 1, &base, 1, &o), SF_ERR_ARGUMENT);
    none.region_low_mm[2] = 100; // no contact there
    CHECK_EQ(create(view, &none, 1, handles, 3, &o), SF_ERR_ARGUMENT);
    const double values[] = {-1, NAN, INFINITY};
    for (int i = 0; i < 3; i++) {
        bad = o, bad.pitch_mm = values[i];
        CHECK_EQ(create(view, &stance, 1, handles, 3, &bad), SF_ERR_ARGUMENT);
        bad = o, bad.wall_mm = values[i];
        CHECK_EQ(create(view, &stance, 1, handles, 3, &bad), SF_ERR_ARGUMENT);
        bad = o, bad.mu = values[i];
        CHECK_EQ(create(view, &stance, 1, handles, 3, &bad), SF_ERR_ARGUMENT);
        bad = o, bad.scale_low = values[i];
        CHECK_EQ(create(view, &stance, 1, handles, 3, &bad), SF_ERR_ARGUMENT);
        bad = o, bad.weight_details = values[i];
        CHECK_EQ(create(view, &stance, 1, handles, 3, &bad), SF_ERR_ARGUMENT);
        bad = o, bad.reserve_rad = values[i];
        CHECK_EQ(create(view, &stance, 1, handles, 3, &bad), SF_ERR_ARGUMENT);
    }
    bad = o, bad.struct_size = 0;
    CHECK_EQ(create(view, &stance, 1, handles, 3, &bad), SF_ERR_ARGUMENT);
    bad = o, bad.strut_width_vx = 0;
    CHECK_EQ(create(view, &stance, 1, handles, 3, &bad), SF_ERR_ARGUMENT);
    bad = o, bad.ballast_count = 1;
    CHECK_EQ(create(view, &stance, 1, handles, 3, &bad), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stand_round(NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stand_run(NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK(sf_stand_outer(NULL).vertex_count == 0 && sf_stand_grid(NULL) == NULL);
    CHECK(sf_stand_describe(NULL).rounds == 0 && sf_stand_stance(NULL, 0) == NULL);
    sf_stand_destroy(NULL);
    sf_mesh_destroy(mesh);
}

// A wall thicker than the part leaves nothing to carve: that is no error, and no cavity.
static void a_wall_thicker_than_the_part(void)
{
    sf_stand_options o = options_of(0, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    o.wall_mm = 100;
    sf_stand *stand = make(0.05, &o, 1, &stance);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    CHECK_EQ(sf_stand_cavity(stand).triangle_count, 0);
    sf_stand_destroy(stand);
}

typedef struct countdown {
    sf_task task;
    int left;
} countdown;

static void count_down(void *user, double fraction)
{
    countdown *c = user;
    CHECK(fraction >= 0 && fraction <= 1);
    if (c->left-- == 0) {
        sf_task_cancel(&c->task);
    }
}

// Cancelled at the k-th report of progress: it is as the last whole round left it, and goes on.
static void cancelled_it_goes_on(void)
{
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    sf_stand *whole = make(0.35, &o, 1, &stance);
    CHECK_EQ(sf_stand_run(whole, NULL, NULL), SF_OK);
    for (int k = 0; k < 60; k += 13) {
        sf_stand *stand = make(0.35, &o, 1, &stance);
        countdown c = {sf_task_default(), k};
        c.task.progress = count_down;
        c.task.user = &c;
        sf_status status = sf_stand_run(stand, &c.task, NULL);
        CHECK(status == SF_OK || status == SF_ERR_CANCELLED);
        CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
        CHECK(memcmp(sf_stand_outer(stand).vertices, sf_stand_outer(whole).vertices,
                     24 * sf_stand_outer(whole).vertex_count) == 0);
        sf_stand_destroy(stand);
    }
    sf_stand_destroy(whole);
}

static void never_falls(void *user, double fraction)
{
    double *last = user;
    CHECK(fraction >= *last && fraction <= 1);
    *last = fraction;
}

// A round moves handles, bends, carves and looks, each with a progress of its own; the last one
// does part of that again. To its caller it is one call.
static void progress_of_a_round_never_falls(void)
{
    sf_stand_options o = options_of(1, SF_CARVE_SUPPORT_FREE);
    sf_stance_options stance = sf_stance_options_default();
    o.rounds_max = 3;
    sf_stand *stand = make(0.35, &o, 1, &stance);
    for (int round = 0; round < 3; round++) {
        double last = 0;
        sf_task task = sf_task_default();
        task.progress = never_falls;
        task.user = &last;
        CHECK_EQ(sf_stand_round(stand, &task, NULL), SF_OK);
        CHECK(last > 0.5 || sf_stand_describe(stand).ended);
    }
    sf_stand_destroy(stand);
}

static double denser_above(void *user, const double p[3])
{
    (void)user;
    return p[2] > 20 ? 1.75 : 0.5;
}

// Every request for memory that can fail does, once, here and there among the first thousands; and
// those before the first round one by one, where there are densities.
static void memory_may_fail(int dense)
{
    sf_mesh *mesh = bottle(0.3);
    sf_handle handles[3];
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    o.pitch_mm = 3;
    o.wall_mm = 1;
    o.rounds_max = 2;
    o.density = dense ? denser_above : NULL;
    size_t count = handles_of(0.3, handles);
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status == SF_ERR_MEMORY && k < 100000; k += 1 + (dense ? k / 200 : k / 20)) {
        failing_allocator failing;
        sf_stand *stand = NULL;
        failing_begin(&failing, k);
        status = sf_stand_create(sf_mesh_get_view(mesh), &stance, 1, handles, count, &o,
                                 &failing.allocator, NULL, &stand, NULL);
        CHECK((status == SF_OK) == (stand != NULL));
        if (status == SF_OK) {
            status = sf_stand_run(stand, NULL, NULL);
        }
        sf_stand_destroy(stand);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
    sf_mesh_destroy(mesh);
}

static void memory_may_fail_anywhere(void)
{
    memory_may_fail(0);
    memory_may_fail(1);
}

int main(void)
{
    TEST(nonsense_is_refused);
    TEST(a_wall_thicker_than_the_part);
    TEST(cancelled_it_goes_on);
    TEST(progress_of_a_round_never_falls);
    TEST(memory_may_fail_anywhere);
    return test_finish();
}
