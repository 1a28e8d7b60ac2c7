// SPDX-License-Identifier: MIT
// The Balance workspace without a window: what falls is made to stand, a handle that a person moved
// stays where it was put, undo gives back what was asked for, the same calls give the same bits,
// and no file that cannot be taken changes anything.

#include "test.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "app/event.h"
#include "balance/balance_desk.h"

static desk *make(void)
{
    desk *d = balance_desk_create();
    CHECK(d != NULL);
    return d;
}

static void go_on(desk *d, int most)
{
    for (int i = 0; i < most && d->is->is_busy(d); i++) {
        d->is->act(d, DO_STEP);
    }
}

static void run(desk *d)
{
    d->is->act(d, BALANCE_RUN);
    go_on(d, 60);
}

// A pointer whose ray goes from an eye through a place.
static desk_pointer through(const double eye[3], const double at[3], unsigned mods)
{
    desk_pointer p = {.spread = 0.001, .mods = mods};
    double length = 0, flat = 0;
    for (int i = 0; i < 3; i++) {
        p.eye_mm[i] = eye[i];
        p.along[i] = at[i] - eye[i];
        length += p.along[i] * p.along[i];
    }
    for (int i = 0; i < 3; i++) {
        p.forward[i] = p.along[i] /= sqrt(length);
    }
    flat = hypot(p.forward[0], p.forward[1]);
    p.right[0] = p.forward[1] / flat;
    p.right[1] = -p.forward[0] / flat;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        p.up[i] = p.right[j] * p.forward[k] - p.right[k] * p.forward[j];
    }
    return p;
}

static void click(desk *d, const double eye[3], const double at[3], unsigned mods)
{
    desk_pointer p = through(eye, at, mods);
    d->is->hover(d, &p);
    d->is->press(d, &p);
    d->is->release(d);
}

static void what_falls_is_made_to_stand(void)
{
    desk *a = make(), *b = make();
    const balance_state *s = balance_desk_state(a);
    CHECK(!s->stands && s->margin_rad < 0 && !s->has_report);
    CHECK(!a->is->is_busy(a));
    uint64_t before = a->is->hash(a);
    run(a);
    CHECK(s->has_report && s->report.ended && s->safe && s->report.succeeded);
    CHECK(s->margin_rad >= s->plan.gamma_deg * 0.017453 && s->report.carved_mm3 > 100);
    CHECK(!a->is->is_busy(a));
    run(b);
    CHECK(a->is->hash(a) == b->is->hash(b) && a->is->hash(a) != before);
    a->is->act(a, BALANCE_RUN); // nothing is left to do, which is said
    CHECK(!s->is_running && strstr(a->said, "ended") != NULL);
    a->is->act(a, DO_CLEAR);
    CHECK(a->is->hash(a) != b->is->hash(b) && !s->has_report && !s->stands);
    a->is->destroy(a);
    b->is->destroy(b);
}

static void a_moved_handle_stays(void)
{
    desk *d = make();
    const balance_state *s = balance_desk_state(d);
    const double eye[3] = {40, -300, 120};
    d->is->act(d, BALANCE_PLACE);
    CHECK_EQ(s->plan.handle_count, 5);
    const balance_handle *h = &s->plan.handles[0];
    const double aim[3] = {h->at_mm[0], h->at_mm[1], h->at_mm[2]};
    desk_pointer p = through(eye, aim, 0);
    d->is->press(d, &p);
    CHECK_EQ(s->selected, 0);
    const double up[3] = {aim[0] - 2, aim[1], aim[2] + 3};
    p = through(eye, up, 0);
    // The same frame of the picture, another ray.
    desk_pointer first = through(eye, aim, 0);
    memcpy(p.forward, first.forward, sizeof p.forward);
    memcpy(p.right, first.right, sizeof p.right);
    memcpy(p.up, first.up, sizeof p.up);
    d->is->drag(d, &p);
    d->is->release(d);
    CHECK(h->locked && fabs(h->pose.shift_mm[0] + 2) < 0.3 && fabs(h->pose.shift_mm[2] - 3) < 0.3);
    CHECK(d->is->is_busy(d)); // a round is owed
    const sf_pose put = h->pose;
    go_on(d, 10);
    CHECK(s->has_report && !d->is->is_busy(d));
    run(d);
    CHECK(memcmp(&put, &h->pose, sizeof put) == 0 && s->report.displacement_mm > 1);
    d->is->act(d, BALANCE_LOCK);
    CHECK(!h->locked);
    d->is->act(d, DO_UNDO);
    CHECK(h->locked && memcmp(&put, &h->pose, sizeof put) == 0);
    d->is->act(d, DO_UNDO);
    CHECK(!h->locked && !(fabs(h->pose.shift_mm[0]) > 0));
    d->is->act(d, DO_REDO);
    CHECK(h->locked && memcmp(&put, &h->pose, sizeof put) == 0);
    d->is->set(d, BALANCE_SELECTED, 0);
    d->is->set(d, BALANCE_SCALE, 1.2);
    d->is->set(d, BALANCE_SCALE, 1.3);
    CHECK(fabs(h->pose.scale - 1.3) < 1e-12);
    d->is->act(d, DO_UNDO); // both are one change
    CHECK(fabs(h->pose.scale - 1) < 1e-12);
    d->is->set(d, BALANCE_SELECTED, 0);
    d->is->act(d, BALANCE_REMOVE);
    CHECK(s->plan.handle_count == 4 && s->selected == -1);
    d->is->destroy(d);
}

// A slab of 40 x 20 x 10 mm, in a file.
static void write_slab(const char *name, int is_whole)
{
    static const int faces[12][3] = {{1, 3, 2}, {1, 4, 3}, {5, 6, 7}, {5, 7, 8},
                                     {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6},
                                     {3, 4, 8}, {3, 8, 7}, {4, 1, 5}, {4, 5, 8}};
    static const int corners[4][2] = {{0, 0}, {40, 0}, {40, 20}, {0, 20}};
    FILE *f = fopen(name, "w");
    CHECK(f != NULL);
    for (int i = 0; i < 8; i++) {
        fprintf(f, "v %d %d %d\n", corners[i % 4][0], corners[i % 4][1], i / 4 * 10);
    }
    for (int i = 0; i < (is_whole ? 12 : 11); i++) {
        fprintf(f, "f %d %d %d\n", faces[i][0], faces[i][1], faces[i][2]);
    }
    CHECK(fclose(f) == 0);
}

static void stances_are_pointed_at(void)
{
    char why[DESK_WHY_SIZE] = "";
    double low[3], high[3];
    desk *d = make();
    const balance_state *s = balance_desk_state(d);
    const double eye[3] = {200, -90, 60}, side[3] = {20, 2, 5}, top[3] = {3, 4, 10};
    write_slab("balance_slab.obj", 1);
    CHECK(d->is->open(d, "balance_slab.obj", why));
    CHECK(s->safe && s->triangle_count == 12 && fabs(s->size_mm - 40) < 1e-9);
    double flat = s->margin_rad;
    d->is->set(d, BALANCE_TOOL, BALANCE_STAND);
    click(d, eye, side, 0); // on its end, 20 x 10
    CHECK(d->is->bounds(d, low, high) && fabs(high[2] - 40) < 1e-9 && fabs(low[2]) < 1e-9);
    CHECK(fabs(s->margin_rad - atan2(5, 20)) < 1e-9 && s->margin_rad < flat);
    click(d, eye, side, MOD_SHIFT); // and on the face that is where its top was
    CHECK(s->plan.stance_count == 2);
    d->is->act(d, BALANCE_ONE_STANCE);
    CHECK(s->plan.stance_count == 1);
    d->is->act(d, DO_UNDO);
    d->is->act(d, DO_UNDO);
    d->is->act(d, DO_UNDO);
    CHECK(s->plan.stance_count == 1 && fabs(s->margin_rad - flat) < 1e-12);
    d->is->set(d, BALANCE_TOOL, BALANCE_HANG);
    click(d, eye, top, 0);
    CHECK(s->plan.stances[0].kind == SF_STANCE_HANG && !s->stands);
    CHECK(fabs(s->plan.stances[0].point_mm[2] - 10) < 1e-9);
    d->is->destroy(d);
    unlink("balance_slab.obj");
}

static void a_handle_goes_into_the_middle(void)
{
    char why[DESK_WHY_SIZE] = "";
    desk *d = make();
    const balance_state *s = balance_desk_state(d);
    const double eye[3] = {5, -300, 5}, at[3] = {5, 0, 5};
    write_slab("balance_put.obj", 1);
    CHECK(d->is->open(d, "balance_put.obj", why));
    d->is->set(d, BALANCE_TOOL, BALANCE_PUT);
    click(d, eye, at, 0);
    CHECK(s->plan.handle_count == 1 && s->selected == 0);
    CHECK(fabs(s->plan.handles[0].at_mm[1]) < 1 && fabs(s->plan.handles[0].at_mm[0] - 5) < 1);
    const double beside[3] = {300, 0, 5};
    click(d, eye, beside, 0);
    CHECK(s->plan.handle_count == 1 && d->said[0] != '\0');
    d->is->act(d, DO_UNDO);
    CHECK_EQ(s->plan.handle_count, 0);
    d->is->destroy(d);
    unlink("balance_put.obj");
}

// Two handles in one place cannot both be held: the last goes, is told, and is selected no more.
static void a_handle_too_many_is_left_out(void)
{
    char why[DESK_WHY_SIZE] = "";
    desk *d = make();
    const balance_state *s = balance_desk_state(d);
    const double eye[3] = {5, -300, 5}, at[3] = {5, 0, 5}, near[3] = {5.2, 0, 5.2};
    write_slab("balance_two.obj", 1);
    CHECK(d->is->open(d, "balance_two.obj", why));
    d->is->set(d, BALANCE_TOOL, BALANCE_PUT);
    click(d, eye, at, 0);
    desk_pointer p = through(eye, near, 0);
    p.spread = 1e-9; // a picture so large that the first is not below the pointer
    d->is->press(d, &p);
    d->is->release(d);
    CHECK_EQ(s->plan.handle_count, 2);
    d->is->set(d, BALANCE_SELECTED, 1);
    d->is->act(d, BALANCE_ROUND);
    go_on(d, 4);
    CHECK(s->plan.handle_count == 1 && s->selected == -1);
    CHECK(strstr(d->said, "left out") != NULL);
    d->is->act(d, BALANCE_REMOVE); // nothing is selected
    CHECK_EQ(s->plan.handle_count, 1);
    d->is->destroy(d);
    unlink("balance_two.obj");
}

// Whatever is set while a handle is dragged, it is that one which moves.
static void the_handle_in_hand_stays_in_it(void)
{
    desk *d = make();
    const balance_state *s = balance_desk_state(d);
    const double eye[3] = {40, -300, 120};
    d->is->act(d, BALANCE_PLACE);
    CHECK(s->plan.handle_count > 1);
    const balance_handle *h = s->plan.handles;
    const double aim[3] = {h[0].at_mm[0], h[0].at_mm[1], h[0].at_mm[2] + 2};
    desk_pointer p = through(eye, h[0].at_mm, 0), q = through(eye, aim, 0);
    d->is->press(d, &p);
    CHECK_EQ(s->selected, 0);
    d->is->set(d, BALANCE_SELECTED, 1);
    d->is->drag(d, &q);
    d->is->release(d);
    CHECK(h[0].locked && !h[1].locked);
    d->is->act(d, DO_UNDO);
    CHECK(!h[0].locked);
    // A move that is given up was none.
    d->is->press(d, &p);
    d->is->drag(d, &q);
    CHECK(h[0].locked && s->undo_count == 2);
    d->is->act(d, DO_GIVE_UP);
    d->is->drag(d, &p);
    d->is->release(d);
    CHECK(!h[0].locked && s->undo_count == 1 && s->redo_count == 0 && !d->is->is_busy(d));
    d->is->set(d, BALANCE_SELECTED, 1);
    CHECK_EQ(s->selected, 1);
    d->is->destroy(d);
}

// A shape that takes the place of one which was carved is judged by how it rests itself.
static void another_shape_is_judged_by_itself(void)
{
    char why[DESK_WHY_SIZE] = "";
    desk *d = make(), *fresh = make();
    const balance_state *s = balance_desk_state(d), *f = balance_desk_state(fresh);
    write_slab("balance_next.obj", 1);
    d->is->act(d, BALANCE_ROUND);
    go_on(d, 4);
    CHECK(s->has_report);
    CHECK(d->is->open(d, "balance_next.obj", why));
    CHECK(fresh->is->open(fresh, "balance_next.obj", why));
    CHECK(!s->has_report && f->safe && s->safe && s->stands);
    CHECK_NEAR(s->margin_rad, f->margin_rad, 1e-12);
    CHECK_NEAR(s->before_rad, f->before_rad, 1e-12);
    CHECK(d->is->hash(d) == fresh->is->hash(fresh));
    d->is->destroy(d);
    fresh->is->destroy(fresh);
    unlink("balance_next.obj");
}

static void files(void)
{
    char why[DESK_WHY_SIZE] = "";
    desk *d = make(), *again = make();
    run(d);
    uint64_t hash = d->is->hash(d);
    CHECK(!d->is->open(d, "there_is_none.stl", why) && why[0] != '\0');
    write_slab("balance_open.obj", 0);
    why[0] = '\0';
    CHECK(!d->is->open(d, "balance_open.obj", why) && strstr(why, "not closed") != NULL);
    CHECK(d->is->hash(d) == hash);
    CHECK(!d->is->save(d, "balance_out.txt", why) && strstr(why, ".stl") != NULL);
    CHECK(d->is->save(d, "balance_out.obj", why));
    CHECK(access("balance_out_inner.obj", F_OK) == 0);
    CHECK(again->is->open(again, "balance_out.obj", why));
    CHECK(d->is->hash(d) == hash);
    d->is->destroy(d);
    again->is->destroy(again);
    unlink("balance_open.obj");
    unlink("balance_out.obj");
    unlink("balance_out_inner.obj");
}

static void a_sculpted_shape(void)
{
    char why[DESK_WHY_SIZE] = "";
    const sf_lattice l = {20, 20, 30, 0.5, 0.5, 0.5, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    desk *d = make();
    CHECK(sf_grid_create(&l, NULL, &grid) == SF_OK);
    CHECK(!d->is->adopt(d, grid, why)); // nothing is there
    for (uint32_t k = 0; k < 20; k++) {
        for (uint32_t i = 0; i < 100; i++) {
            CHECK(sf_slice_set(sf_grid_slice(grid, k), 5 + i % 10, 5 + i / 10, 1) == SF_OK);
        }
    }
    CHECK(d->is->adopt(d, grid, why));
    CHECK(balance_desk_state(d)->safe && fabs(balance_desk_state(d)->size_mm - 10) < 1);
    sf_grid_destroy(grid);
    d->is->destroy(d);
}

// All that is shown, in every state, has a place.
static void it_shows(void)
{
    desk *d = make();
    stage *s = stage_create();
    size_t glass, solid, lines, points;
    CHECK(s != NULL);
    CHECK(d->is->show(d, s));
    (void)stage_vertices(s, STAGE_GLASS, &glass);
    (void)stage_vertices(s, STAGE_SOLID, &solid);
    CHECK(glass == 3 * balance_desk_state(d)->triangle_count && solid == 0);
    run(d);
    d->is->set(d, BALANCE_GLASS, 0);
    stage_clear(s);
    CHECK(d->is->show(d, s));
    (void)stage_vertices(s, STAGE_GLASS, &glass);
    const stage_vertex *v = stage_vertices(s, STAGE_SOLID, &solid);
    CHECK(glass == 0 && solid > 3 * balance_desk_state(d)->triangle_count);
    for (size_t i = 0; i < solid; i++) {
        CHECK(isfinite(v[i].at_mm[0] + v[i].at_mm[1] + v[i].at_mm[2]));
    }
    (void)stage_vertices(s, STAGE_LINE_OVER, &lines);
    (void)stage_points(s, &points);
    CHECK(lines > 20 && points > balance_desk_state(d)->plan.handle_count);
    stage_destroy(s);
    d->is->destroy(d);
}

int main(void)
{
    TEST(what_falls_is_made_to_stand);
    TEST(a_moved_handle_stays);
    TEST(stances_are_pointed_at);
    TEST(a_handle_goes_into_the_middle);
    TEST(a_handle_too_many_is_left_out);
    TEST(the_handle_in_hand_stays_in_it);
    TEST(another_shape_is_judged_by_itself);
    TEST(files);
    TEST(a_sculpted_shape);
    TEST(it_shows);
    return test_finish();
}
