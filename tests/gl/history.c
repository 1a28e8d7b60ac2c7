// SPDX-License-Identifier: MIT
// The promise of undo on the graphics card (TRUST 82): as far as the history's memory reaches, each
// undo gives the exact bits of before and each redo those of after; what no longer fits is
// forgotten, oldest first; a step that does not fit at all is done and leaves no history. With
// memory for a few strokes only, so that the ring goes round many times, held against copies.

#include "random_strokes.h"
#include "twin.h"

#define COPIES 128

// States of the model after each of the last strokes; state i is in place i % COPIES.
typedef struct album {
    sf_grid *drawn[COPIES], *printable[COPIES];
    uint8_t *materials[COPIES];
} album;

static album album_new(const twin *t)
{
    album a;
    for (int i = 0; i < COPIES; i++) {
        CHECK(sf_grid_create(&t->options.lattice, NULL, &a.drawn[i]) == SF_OK);
        CHECK(sf_grid_create(&t->options.lattice, NULL, &a.printable[i]) == SF_OK);
        a.materials[i] = malloc(t->voxels);
    }
    return a;
}

static void album_free(album *a)
{
    for (int i = 0; i < COPIES; i++) {
        sf_grid_destroy(a->drawn[i]);
        sf_grid_destroy(a->printable[i]);
        free(a->materials[i]);
    }
}

static void take(const twin *t, album *a, uint32_t i)
{
    CHECK(gpu_sculpt_fetch(t->gpu, a->drawn[i % COPIES], a->printable[i % COPIES],
                           a->materials[i % COPIES]) == SF_OK);
}

static void compare(const twin *t, const album *a, uint32_t i)
{
    CHECK(gpu_sculpt_fetch(t->gpu, t->drawn, t->printable, t->materials) == SF_OK);
    CHECK(sf_grid_equal(t->drawn, a->drawn[i % COPIES]));
    CHECK(sf_grid_equal(t->printable, a->printable[i % COPIES]));
    CHECK(memcmp(t->materials, a->materials[i % COPIES], t->voxels) == 0);
}

static gpu_report report(const twin *t)
{
    gpu_report r = {0};
    CHECK(gpu_sculpt_report(t->gpu, &r) == SF_OK);
    return r;
}

// All the way back, and all the way forth; `steps` states lie behind.
static uint32_t go_through(const twin *t, const album *a, uint32_t steps)
{
    uint32_t depth = report(t).undo_count;
    CHECK(depth < COPIES);
    for (uint32_t i = 1; i <= depth; i++) {
        CHECK(gpu_sculpt_undo(t->gpu) == SF_OK);
        compare(t, a, steps - i);
    }
    CHECK(gpu_sculpt_undo(t->gpu) == SF_OK); // one more does nothing
    compare(t, a, steps - depth);
    CHECK_EQ(report(t).undo_count, 0);
    CHECK_EQ(report(t).redo_count, depth);
    for (uint32_t i = depth; i-- > 0;) {
        CHECK(gpu_sculpt_redo(t->gpu) == SF_OK);
        compare(t, a, steps - i);
    }
    CHECK(gpu_sculpt_redo(t->gpu) == SF_OK);
    compare(t, a, steps);
    return depth;
}

static void a_ring_for_a_few_strokes(void)
{
    sf_sculpt_options options = twin_options(64, 40, 48);
    options.history_size = 60000;
    twin t = twin_new(&options);
    album a = album_new(&t);
    uint32_t steps = 0, deepest = 0, forgotten = 0;
    take(&t, &a, 0);
    for (int i = 0; i < 400 && test_case_failures == 0; i++) {
        random_stroke s = random_stroke_new(&options.lattice, 8);
        gpu_report before = report(&t);
        CHECK(gpu_sculpt_stroke(t.gpu, &s.brush, s.dabs, s.count) == SF_OK);
        gpu_report after = report(&t);
        if (after.undo_count + after.forgotten_count !=
            before.undo_count + before.forgotten_count) { // it was a step
            take(&t, &a, ++steps);
        }
        compare(&t, &a, steps);
        if (i % 20 == 19) {
            uint32_t depth = go_through(&t, &a, steps);
            deepest = depth > deepest ? depth : deepest;
        }
        forgotten = report(&t).forgotten_count;
        random_stroke_free(&s);
    }
    printf("# %u steps, %u forgotten, at most %u to go back\n", steps, forgotten, deepest);
    CHECK(forgotten > 100);
    CHECK(deepest >= 8);
    CHECK_EQ(forgotten + report(&t).undo_count, steps);
    album_free(&a);
    twin_free(&t);
}

static void a_stroke_after_undo_drops_what_was_undone(void)
{
    sf_sculpt_options options = twin_options(64, 40, 48);
    twin t = twin_new(&options);
    for (int i = 0; i < 40; i++) {
        random_stroke s = random_stroke_new(&options.lattice, 6);
        CHECK(gpu_sculpt_stroke(t.gpu, &s.brush, s.dabs, s.count) == SF_OK);
        CHECK(sf_sculpt_stroke(t.cpu, &s.brush, s.dabs, s.count, NULL) == SF_OK);
        for (uint32_t n = test_random_below(4); n > 0; n--) {
            CHECK(gpu_sculpt_undo(t.gpu) == SF_OK);
            (void)!sf_sculpt_undo(t.cpu, NULL);
        }
        sf_sculpt_history h = sf_sculpt_history_of(t.cpu);
        CHECK_EQ(report(&t).undo_count, h.undo_count);
        CHECK_EQ(report(&t).redo_count, h.redo_count);
        CHECK_EQ(twin_differs(&t), 0);
        random_stroke_free(&s);
    }
    twin_free(&t);
}

static void what_does_not_fit_is_done(void)
{
    sf_sculpt_options options = twin_options(64, 40, 48);
    options.history_size = 1000; // some twenty words
    twin t = twin_new(&options);
    random_stroke s = random_stroke_new(&options.lattice, 3);
    const double radius[3] = {8, 8, 8};
    sf_tip_destroy(s.tip);
    CHECK(sf_tip_create(SF_TIP_BOX, radius, NULL, &s.tip) == SF_OK);
    s.brush.kind = SF_BRUSH_ADD_TRIM;
    s.brush.tip = s.tip;
    s.dabs[0] = (sf_dab){20, 20, 0};
    CHECK(gpu_sculpt_stroke(t.gpu, &s.brush, s.dabs, 1) == SF_OK);
    CHECK(sf_sculpt_stroke(t.cpu, &s.brush, s.dabs, 1, NULL) == SF_OK);
    CHECK_EQ(report(&t).undo_count, 0);
    CHECK_EQ(report(&t).forgotten_count, 1);
    CHECK(gpu_sculpt_undo(t.gpu) == SF_OK);
    CHECK_EQ(twin_differs(&t), 0);
    random_stroke_free(&s);
    twin_free(&t);
}

int main(void)
{
    gl_headless *context = NULL;
    if (!gl_begin(&context)) {
        return gl_status;
    }
    TEST(a_ring_for_a_few_strokes);
    TEST(a_stroke_after_undo_drops_what_was_undone);
    TEST(what_does_not_fit_is_done);
    gl_headless_destroy(context);
    return test_finish();
}
