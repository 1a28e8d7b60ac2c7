// SPDX-License-Identifier: MIT
// Undo gives back the exact bits and redo does the exact stroke again (TRUST 42, 83), through any
// number of steps and in any order, as far as the history's memory reaches; where it does not, the
// oldest steps are forgotten and all others stay exact. What a step needs in memory is small.

#include <sf/sf.h>

#include "random_strokes.h"
#include "test.h"

typedef struct snapshot {
    sf_grid *drawn, *printable;
    uint8_t *materials;
} snapshot;

static size_t voxels_of(const sf_sculpt *model)
{
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    return (size_t)l.nx * l.ny * l.nz;
}

static snapshot take(const sf_sculpt *model)
{
    snapshot s = {NULL, NULL, malloc(voxels_of(model))};
    CHECK(sf_grid_clone(sf_sculpt_drawn(model), NULL, &s.drawn) == SF_OK);
    CHECK(sf_grid_clone(sf_sculpt_printable(model), NULL, &s.printable) == SF_OK);
    memcpy(s.materials, sf_sculpt_materials(model), voxels_of(model));
    return s;
}

static int is_now(const snapshot *s, const sf_sculpt *model)
{
    return sf_grid_equal(s->drawn, sf_sculpt_drawn(model)) &&
           sf_grid_equal(s->printable, sf_sculpt_printable(model)) &&
           memcmp(s->materials, sf_sculpt_materials(model), voxels_of(model)) == 0;
}

static void drop(snapshot *s)
{
    sf_grid_destroy(s->drawn);
    sf_grid_destroy(s->printable);
    free(s->materials);
}

static sf_sculpt *make_wide(uint32_t nx, size_t history_size, int keep_drawn)
{
    sf_sculpt *model = NULL;
    sf_sculpt_options options = sf_sculpt_options_default();
    sf_lattice lattice = {nx, 40, 40, 1, 1, 1, NULL, {0, 0, 0}};
    options.lattice = lattice;
    options.history_size = history_size;
    options.keep_drawn = keep_drawn;
    CHECK(sf_sculpt_create(&options, NULL, &model) == SF_OK);
    return model;
}

static sf_sculpt *make(size_t history_size, int keep_drawn)
{
    return make_wide(50, history_size, keep_drawn);
}

// Whether the stroke became a step. In a wide grid its rows lie in several words.
static int stroke(sf_sculpt *model)
{
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    sf_sculpt_history before = sf_sculpt_history_of(model);
    random_stroke s = random_stroke_new(&l, l.nx / 7);
    CHECK(sf_sculpt_stroke(model, &s.brush, s.dabs, s.count, NULL) == SF_OK);
    random_stroke_free(&s);
    sf_sculpt_history after = sf_sculpt_history_of(model);
    return after.undo_count + after.forgotten_count != before.undo_count + before.forgotten_count;
}

#define STEPS 60

static void walk(uint32_t nx, int keep_drawn)
{
    snapshot at[STEPS + 1];
    sf_sculpt *model = make_wide(nx, 1 << 22, keep_drawn);
    int here = 0, top;
    at[0] = take(model);
    while (here < STEPS) {
        if (stroke(model)) {
            at[++here] = take(model);
        } else {
            CHECK(is_now(&at[here], model)); // a stroke that changes nothing is no step
        }
    }
    top = here;
    for (int i = 0; i < 400; i++) {
        int is_undo = test_random_below(2) == 0;
        sf_status status = is_undo ? sf_sculpt_undo(model, NULL) : sf_sculpt_redo(model, NULL);
        CHECK_EQ(status, is_undo ? (here > 0 ? SF_OK : SF_ERR_INFEASIBLE)
                                 : (here < top ? SF_OK : SF_ERR_INFEASIBLE));
        here += status != SF_OK ? 0 : is_undo ? -1 : 1;
        CHECK(is_now(&at[here], model));
        CHECK_EQ(sf_sculpt_history_of(model).undo_count, here);
        CHECK_EQ(sf_sculpt_history_of(model).redo_count, top - here);
    }
    for (int i = 0; i <= STEPS; i++) {
        drop(&at[i]);
    }
    sf_sculpt_destroy(model);
}

static void back_and_forth(void)
{
    walk(50, 0);
    walk(50, 1);
    walk(400, 0);
    walk(400, 1);
}

// Something new takes the place of what could be done again.
static void new_branch(void)
{
    sf_sculpt *model = make(1 << 22, 0);
    while (sf_sculpt_history_of(model).undo_count < 5) {
        stroke(model);
    }
    CHECK(sf_sculpt_undo(model, NULL) == SF_OK);
    CHECK(sf_sculpt_undo(model, NULL) == SF_OK);
    CHECK_EQ(sf_sculpt_history_of(model).redo_count, 2);
    while (!stroke(model)) {
    }
    CHECK_EQ(sf_sculpt_history_of(model).redo_count, 0);
    CHECK_EQ(sf_sculpt_history_of(model).undo_count, 4);
    CHECK(sf_sculpt_redo(model, NULL) == SF_ERR_INFEASIBLE);
    sf_sculpt_destroy(model);
}

// A ring of 20 kB: it wraps around many times, and what is in it stays exact.
static void forgets(void)
{
    enum { KEPT = 128 };
    snapshot at[KEPT];
    sf_sculpt *model = make(20000, 0);
    long steps = 0;
    at[0] = take(model);
    for (int i = 0; i < 500; i++) {
        if (!stroke(model)) {
            continue;
        }
        steps++;
        if (steps >= KEPT) {
            drop(&at[steps % KEPT]);
        }
        at[steps % KEPT] = take(model);
        CHECK(sf_sculpt_history_of(model).size <= 20000);
    }
    sf_sculpt_history h = sf_sculpt_history_of(model);
    printf("# %ld steps, %zu kept in %zu bytes, %zu forgotten\n", steps, h.undo_count, h.size,
           h.forgotten_count);
    CHECK_EQ((long)(h.undo_count + h.forgotten_count), steps);
    CHECK(h.forgotten_count > 100 && h.undo_count > 3 && h.undo_count < KEPT);
    for (long back = 0; back <= (long)h.undo_count; back++) {
        CHECK(is_now(&at[(steps - back) % KEPT], model));
        CHECK_EQ(sf_sculpt_undo(model, NULL),
                 back < (long)h.undo_count ? SF_OK : SF_ERR_INFEASIBLE);
    }
    for (long i = 0; i < KEPT; i++) {
        drop(&at[i]);
    }
    sf_sculpt_destroy(model);
}

// A step that does not fit is done all the same, and the history is empty after it.
static void too_large(void)
{
    const size_t sizes[3] = {0, 1, 40};
    for (int i = 0; i < 3; i++) {
        sf_sculpt *model = make(sizes[i], 0);
        while (!stroke(model)) {
        }
        CHECK(sf_grid_popcount(sf_sculpt_printable(model)) > 0);
        CHECK_EQ(sf_sculpt_history_of(model).undo_count, 0);
        CHECK_EQ(sf_sculpt_history_of(model).size, 0);
        CHECK(sf_sculpt_undo(model, NULL) == SF_ERR_INFEASIBLE);
        sf_sculpt_destroy(model);
    }
}

// The default model keeps hundreds of strokes: a ball of radius 20 takes under 32 kB.
static void is_small(void)
{
    sf_sculpt_options options = sf_sculpt_options_default();
    sf_lattice lattice = {128, 128, 128, 0.25, 0.25, 0.25, NULL, {0, 0, 0}};
    const double r[3] = {20, 20, 20};
    sf_sculpt *model = NULL;
    sf_brush brush = sf_brush_default();
    sf_tip *tip = NULL;
    sf_dab at = {64, 64, 0};
    options.lattice = lattice;
    CHECK(sf_tip_create(SF_TIP_SPHERE, r, NULL, &tip) == SF_OK);
    CHECK(sf_sculpt_create(&options, NULL, &model) == SF_OK);
    brush.tip = tip;
    CHECK(sf_sculpt_stroke(model, &brush, &at, 1, NULL) == SF_OK);
    size_t half = sf_sculpt_history_of(model).size; // half a ball, on the bed
    printf("# half a ball of radius 20 takes %zu bytes of history\n", half);
    CHECK(half > 1000 && half < 16384);
    sf_sculpt_destroy(model);
    sf_tip_destroy(tip);
}

int main(void)
{
    TEST(back_and_forth);
    TEST(new_branch);
    TEST(forgets);
    TEST(too_large);
    TEST(is_small);
    return test_finish();
}
