// SPDX-License-Identifier: MIT
// Random calls at the workspaces, as no person makes them: buttons that go down twice, settings in
// the middle of a drag, undo without end. Whatever comes, what is selected is there, all that is
// shown has a place, and the same calls give the same bits, which is what a recording is played on.

#include "test.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "app/event.h"
#include "balance/balance_desk.h"
#include "grade/grade_desk.h"

enum { CALLS = 1200 };

static void to_unit(double v[3])
{
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

// A pointer somewhere around, most often over what is there.
static desk_pointer somewhere(const desk *d)
{
    desk_pointer p = {.spread = 0.001, .mods = test_random_below(8)};
    double low[3], high[3], around = 6.283 * test_random_unit();
    CHECK(d->is->bounds(d, low, high));
    double size = fmax(high[0] - low[0], fmax(high[1] - low[1], high[2] - low[2]));
    const double off[3] = {3 * size * cos(around), 3 * size * sin(around),
                           size * (4 * test_random_unit() - 2)};
    for (int i = 0; i < 3; i++) {
        double middle = 0.5 * (low[i] + high[i]);
        p.eye_mm[i] = middle + off[i];
        p.forward[i] = -off[i];
        p.along[i] = low[i] + (high[i] - low[i]) * (1.1 * test_random_unit() - 0.05) - p.eye_mm[i];
    }
    to_unit(p.forward);
    to_unit(p.along);
    p.right[0] = p.forward[1];
    p.right[1] = -p.forward[0];
    to_unit(p.right);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        p.up[i] = p.right[j] * p.forward[k] - p.right[k] * p.forward[j];
    }
    return p;
}

static double some_number(void)
{
    static const double odd[] = {-1e9, -1, 0, 1e-9, 0.5, 1, 2, 3, 5, 100, 1e9};
    return test_random_below(3) == 0 ? 4 * test_random_unit()
                                     : odd[test_random_below(sizeof odd / sizeof *odd)];
}

static void call(desk *d, int first, int settings, int actions)
{
    static const int editors[] = {DO_UNDO, DO_REDO, DO_CLEAR, DO_GIVE_UP, DO_STEP};
    static const char keys[] = " ASNLXHCVB[]1234Q\x1b";
    desk_pointer p = somewhere(d);
    if (test_random_below(40) == 0) { // a file of either kind, or one that there is not
        static const char *const files[] = {"random.obj", "random.vtk", "random.none"};
        char why[DESK_WHY_SIZE] = "";
        int is_open = d->is->open(d, files[test_random_below(3)], why);
        CHECK(is_open || why[0] != '\0');
        return;
    }
    switch (test_random_below(9)) {
    case 0:
        d->is->hover(d, &p);
        break;
    case 1:
    case 2:
        d->is->press(d, &p);
        break;
    case 3:
    case 4:
        d->is->drag(d, &p);
        break;
    case 5:
        d->is->release(d);
        break;
    case 6:
        d->is->key(d, keys[test_random_below(sizeof keys - 1)], p.mods);
        break;
    case 7:
        d->is->set(d, first + (int)test_random_below((uint32_t)settings + 1), some_number());
        break;
    default:
        d->is->act(d, test_random_below(2) == 0
                          ? editors[test_random_below(5)]
                          : first + (int)test_random_below((uint32_t)actions + 1));
    }
}

static void look(desk *d, stage *s)
{
    size_t count, points;
    stage_clear(s);
    CHECK(d->is->show(d, s));
    for (int kind = 0; kind < STAGE_KIND_COUNT; kind++) {
        const stage_vertex *v = stage_vertices(s, (stage_kind)kind, &count);
        size_t lost = 0;
        for (size_t i = 0; i < count; i++) {
            lost += isfinite(v[i].at_mm[0] + v[i].at_mm[1] + v[i].at_mm[2]) ? 0 : 1;
        }
        CHECK_EQ(lost, 0);
    }
    const stage_point *p = stage_points(s, &points);
    for (size_t i = 0; i < points; i++) {
        CHECK(isfinite(p[i].at_mm[0] + p[i].at_mm[1] + p[i].at_mm[2]));
    }
}

static int calls(void)
{
    const char *more = getenv("TEST_CALLS");
    return more != NULL ? atoi(more) : CALLS;
}

// What a balance desk says of itself is so.
static void check_balance(const desk *d)
{
    const balance_state *s = balance_desk_state(d);
    int count = (int)s->plan.handle_count;
    CHECK(s->selected >= -1 && s->selected < count && s->hovered >= -1 && s->hovered < count);
    CHECK(s->plan.stance_count >= 1 && s->plan.stance_count <= BALANCE_STANCES_MAX);
    CHECK(count <= BALANCE_HANDLES_MAX && isfinite(s->margin_rad));
}

static void check_grade(const desk *d)
{
    const grade_state *s = grade_desk_state(d);
    size_t selected = 0;
    for (size_t i = 0; i < s->cage.point_count; i++) {
        selected += s->selected[i] > 0 ? 1 : 0;
    }
    CHECK(selected == s->selected_count && s->hovered < (int)s->cage.point_count);
    CHECK(s->high > s->low && s->channel < s->cage.channel_count);
    CHECK(s->high_mm[0] >= s->low_mm[0] && isfinite(s->high_mm[0] - s->low_mm[0]));
}

// Two desks, one after the other, with the same random numbers; the hash on the way and at the end.
static uint64_t play(desk *d, uint64_t seed, int first, int settings, int actions,
                     void (*check)(const desk *d))
{
    stage *s = stage_create();
    uint64_t all = 0;
    CHECK(d != NULL && s != NULL);
    test_reseed(seed);
    for (int i = 0; i < calls() && test_case_failures == 0; i++) {
        call(d, first, settings, actions);
        check(d);
        CHECK(memchr(d->said, '\0', sizeof d->said) != NULL);
        if (i % 16 == 0) {
            look(d, s);
            all = all * 31 + d->is->hash(d);
        }
    }
    stage_destroy(s);
    d->is->destroy(d);
    return all;
}

static desk *small_balance(void)
{
    desk *d = balance_desk_create();
    CHECK(d != NULL);
    d->is->set(d, BALANCE_RESOLUTION, 20);
    return d;
}

static void write_file(const char *name, const char *text)
{
    FILE *f = fopen(name, "w");
    CHECK(f != NULL && fputs(text, f) >= 0);
    CHECK(f != NULL && fclose(f) == 0);
}

// A leaning prism, and a wedge whose property goes up to that of steel.
static void write_files(void)
{
    write_file("random.obj", "v 0 0 0\nv 20 0 0\nv 10 20 0\nv 15 5 30\nv 35 5 30\nv 25 25 30\n"
                             "f 1 3 2\nf 4 5 6\nf 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\nf 3 1 4\n"
                             "f 3 4 6\n");
    write_file("random.vtk",
               "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n"
               "0 0 0 1 0 0 0 1 0 0 0 1 1 0 1 0 1 1\nCELLS 1 7\n6 0 1 2 3 4 5\nCELL_TYPES 1\n13\n"
               "POINT_DATA 6\nSCALARS stiffness double 1\nLOOKUP_TABLE default\n"
               "2.1e11 2e9 3e9 4e9 1 0\n");
}

static void at_balance(void)
{
    const int settings = BALANCE_COUNT - BALANCE_TOOL, actions = BALANCE_ONE_STANCE - BALANCE_RUN;
    uint64_t seed = test_seed;
    uint64_t one =
        play(small_balance(), seed, DESK_BALANCE_FIRST, settings, actions, check_balance);
    CHECK(one == play(small_balance(), seed, DESK_BALANCE_FIRST, settings, actions, check_balance));
}

static void at_grade(void)
{
    const int settings = GRADE_RESOLUTION - GRADE_TOOL, actions = GRADE_SMOOTH_PLACES - GRADE_ALL;
    uint64_t seed = test_seed;
    uint64_t one =
        play(grade_desk_create(), seed, DESK_GRADE_FIRST, settings, actions, check_grade);
    CHECK(one == play(grade_desk_create(), seed, DESK_GRADE_FIRST, settings, actions, check_grade));
}

int main(void)
{
    write_files();
    TEST(at_balance);
    TEST(at_grade);
    unlink("random.obj");
    unlink("random.vtk");
    return test_finish();
}
