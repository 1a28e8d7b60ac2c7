// SPDX-License-Identifier: MIT
// Why: a call that fails must leave every object as it was (TRUST 84-86), and results may not
// depend on the host's threads or on what lies in the padding of a grid. Carving and its bound are
// refused memory at each of their requests, cancelled at each place where they ask, given nonsense
// of every kind, and run with threads in disorder.

#include "backwards.h"
#include "carving.h"

#include "failing_allocator.h"

// A scene that has everything: half-spaces that bind, and under rules with slack or bridges
// ceilings that only completion carries.
static void begin(carving_scene *c, int rule)
{
    carving_begin(c, rule, 9, 8, 7);
    sf_body body = naive_body(&c->s, c->options.density, c->options.rest);
    sf_halfspace h = {{1, 0, 0}, 0.02};
    h.offset_mm += body.moment[0] / body.mass;
    c->halfspaces[0] = h;
    c->options.count = c->options.count > 0 ? c->options.count : 1;
    stack_take(&c->result, c->out);
}

static sf_status carve(carving_scene *c, const sf_allocator *allocator, sf_task *task)
{
    sfi_forest_report report = {.kept_voxels = 77};
    sf_status status = sfi_carve_forest(c->solid, c->stays, &c->terms, &c->options, allocator, task,
                                        c->out, &report);
    CHECK(status == SF_OK || report.kept_voxels == 77);
    return status;
}

static sf_status bound(carving_scene *c, const sf_allocator *allocator, sf_task *task)
{
    double depth = 7, mass = 7;
    sf_status status =
        sfi_carve_bound(c->solid, c->stays, &c->terms, &c->options, allocator, task, &depth, &mass);
    CHECK(status == SF_OK || (depth == 7 && mass == 7));
    return status;
}

static int is_as_it_was(const carving_scene *c)
{
    static stack now;
    now = c->result;
    stack_take(&now, c->out);
    return stack_equal(&now, &c->result);
}

static void memory_is_refused(void)
{
    static carving_scene c;
    for (int rule = 0; rule < 16; rule += 3) {
        begin(&c, rule);
        for (int which = 0; which < 2; which++) {
            failing_allocator f;
            sf_status status = SF_ERR_MEMORY;
            for (long at = 0; status != SF_OK && at < 3000; at++) {
                failing_begin(&f, at);
                status = which == 0 ? carve(&c, &f.allocator, NULL) : bound(&c, &f.allocator, NULL);
                CHECK(status == SF_OK || status == SF_ERR_MEMORY);
                CHECK_EQ(f.live, 0);
                CHECK_EQ(f.faults, 0);
                CHECK(status == SF_OK || is_as_it_was(&c));
            }
            CHECK_EQ(status, SF_OK);
        }
        carving_end(&c);
    }
}

// An allocator that cancels a task at its k-th request: that is, at many places of the work.
typedef struct canceller {
    failing_allocator below;
    sf_task *task;
    long left;
    sf_allocator allocator;
} canceller;

static void *cancelling_alloc(void *user, size_t size, size_t align)
{
    canceller *c = user;
    if (c->left-- == 0) {
        sf_task_cancel(c->task);
    }
    return c->below.allocator.alloc(c->below.allocator.user, size, align);
}

static void cancelling_free(void *user, void *memory, size_t size)
{
    canceller *c = user;
    c->below.allocator.free(c->below.allocator.user, memory, size);
}

static void a_cancel_is_heeded(void)
{
    static carving_scene s;
    begin(&s, 0);
    int stopped = 0;
    for (long at = 0; at < 400; at++) {
        sf_task task = sf_task_default();
        canceller c = {.task = &task, .left = at};
        sf_allocator allocator = {cancelling_alloc, cancelling_free, &c};
        failing_begin(&c.below, -1);
        sf_status status = carve(&s, &allocator, &task);
        CHECK(status == SF_OK || status == SF_ERR_CANCELLED);
        CHECK_EQ(c.below.live, 0);
        stopped += status == SF_ERR_CANCELLED;
        if (status == SF_OK) {
            break;
        }
        CHECK(is_as_it_was(&s));
    }
    CHECK(stopped > 10);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(bound(&s, NULL, &task), SF_ERR_CANCELLED);
    carving_end(&s);
}

// ---------------------------------------------------------------------------------------------
// The same bytes
// ---------------------------------------------------------------------------------------------

static double last_fraction;

static void on_progress(void *user, double fraction)
{
    (void)user;
    CHECK(fraction >= last_fraction && fraction <= 1);
    last_fraction = fraction;
}

// What lies past the width of a row, in grids of the caller's, is nobody's.
static void soil_padding(sf_grid *grid)
{
    sf_lattice l = sf_grid_lattice(grid);
    for (uint32_t k = 0; k < l.nz; k++) {
        sf_slice s = sf_grid_slice(grid, k);
        for (uint32_t y = 0; y < l.ny; y++) {
            s.words[y * s.stride] |= l.nx < 64 ? ~UINT64_C(0) << l.nx : 0;
        }
    }
}

static void threads_and_padding_change_nothing(void)
{
    static carving_scene c;
    static stack first;
    for (int rule = 0; rule < 16; rule++) {
        begin(&c, rule);
        sf_task task = sf_task_default();
        task.parallel_for = backwards;
        task.progress = on_progress;
        CHECK_EQ(carve(&c, NULL, NULL), SF_OK);
        first = c.result;
        stack_take(&first, c.out);
        soil_padding(c.solid);
        soil_padding(c.stays);
        for (int i = 0; i < 3; i++) {
            soil_padding(c.masks[i]);
        }
        last_fraction = 0;
        CHECK_EQ(carve(&c, NULL, &task), SF_OK);
        CHECK_NEAR(last_fraction, 1, 0);
        stack_take(&c.result, c.out);
        CHECK(stack_equal(&first, &c.result));
        carving_end(&c);
    }
}

// ---------------------------------------------------------------------------------------------
// Nonsense
// ---------------------------------------------------------------------------------------------

#define CARVE(solid, wall, terms, options, out)                                                    \
    sfi_carve_forest(solid, wall, terms, options, NULL, NULL, out, NULL)

static void wrong_grids_are_refused(void)
{
    static carving_scene c;
    stack small;
    begin(&c, 0);
    stack_clear(&small, 9, 8, 6);
    sf_grid *other = stack_grid(&small);
    sf_terms bad = c.terms, named = c.terms;
    bad.struct_size = 1;
    named.keep = c.out;
    CHECK_EQ(CARVE(NULL, c.stays, &c.terms, &c.options, c.out), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, NULL, &c.terms, &c.options, c.out), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, c.stays, NULL, &c.options, c.out), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, c.stays, &c.terms, NULL, c.out), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, c.stays, &c.terms, &c.options, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, c.solid, &c.terms, &c.options, c.out), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, c.stays, &c.terms, &c.options, c.solid), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, c.stays, &c.terms, &c.options, c.stays), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, c.stays, &bad, &c.options, c.out), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, c.stays, &named, &c.options, c.out), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, other, &c.terms, &c.options, c.out), SF_ERR_SHAPE);
    CHECK_EQ(CARVE(c.solid, c.stays, &c.terms, &c.options, other), SF_ERR_SHAPE);
    stack_random(&c.wall, 9, 8, 7, 1);
    c.s.solid[5] = 0;
    stack_write(&c.s, c.solid);
    stack_write(&c.wall, c.stays);
    CHECK_EQ(CARVE(c.solid, c.stays, &c.terms, &c.options, c.out), SF_ERR_INFEASIBLE);
    CHECK(is_as_it_was(&c));
    sf_grid_destroy(other);
    carving_end(&c);
}

static void wrong_numbers_are_refused(void)
{
    static carving_scene c;
    static float density[9 * 8 * 7];
    begin(&c, 0);
    sfi_forest_options o = c.options;
    sf_halfspace flat = {{0, 0, 1}, 1e9}, none = {{NAN, 0, 0}, 0};
#define REFUSED() CHECK_EQ(CARVE(c.solid, c.stays, &c.terms, &o, c.out), SF_ERR_ARGUMENT)
    o.goal = (sfi_forest_goal)3;
    REFUSED();
    o = c.options;
    o.strut_width = SF_REACH_MAX + 1;
    REFUSED();
    o = c.options;
    o.halfspaces = NULL;
    REFUSED();
    o = c.options;
    o.rest.mass = INFINITY;
    REFUSED();
    o.rest.mass = -1e9; // less than nothing
    REFUSED();
    o = c.options;
    o.slopes = &flat; // below the ground
    o.count = 1;
    REFUSED();
    o.slopes = NULL;
    o.halfspaces = &none;
    REFUSED();
    for (int i = 0; i < 2; i++) {
        o = c.options;
        o.density = density;
        for (int j = 0; j < 9 * 8 * 7; j++) {
            density[j] = c.s.solid[j] ? (i == 0 ? -1 : NAN) : 1;
        }
        REFUSED();
    }
    CHECK(is_as_it_was(&c));
    carving_end(&c);
}

// Nothing at all, and solids without an inside, are carved to what they are.
static void nothing_to_carve(void)
{
    static carving_scene c;
    begin(&c, 0);
    sfi_forest_options none = {.goal = SFI_FOREST_MOST};
    sf_terms terms = sf_terms_default();
    stack_random(&c.s, 9, 8, 7, 1);
    stack_write(&c.s, c.solid);
    stack_write(&c.s, c.stays);
    CHECK_EQ(CARVE(c.solid, c.stays, &terms, &none, c.out), SF_OK);
    CHECK(sf_grid_equal(c.out, c.solid));
    stack_clear(&c.s, 9, 8, 7);
    stack_write(&c.s, c.solid);
    stack_write(&c.s, c.stays);
    CHECK_EQ(CARVE(c.solid, c.stays, &terms, &none, c.out), SF_OK);
    CHECK_EQ(sf_grid_popcount(c.out), 0);
    carving_end(&c);
}

int main(void)
{
    TEST(memory_is_refused);
    TEST(a_cancel_is_heeded);
    TEST(threads_and_padding_change_nothing);
    TEST(wrong_grids_are_refused);
    TEST(wrong_numbers_are_refused);
    TEST(nothing_to_carve);
    return test_finish();
}
