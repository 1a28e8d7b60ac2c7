// SPDX-License-Identifier: MIT
// The Grade workspace without a window: its surface is the limit surface, its section and its print
// hold what the property is, what is painted or moved can be undone to the bit, the same calls give
// the same bits, and no file that cannot be read changes anything.

#include "test.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "app/event.h"
#include <sf/locate.h>

#include "grade/grade.h"

static desk *make(void)
{
    desk *d = grade_desk_create();
    CHECK(d != NULL);
    return d;
}

static void go_on(desk *d)
{
    for (int i = 0; i < 10 && d->is->is_busy(d); i++) {
        d->is->act(d, DO_STEP);
    }
    CHECK(!d->is->is_busy(d));
}

// A pointer that looks along +y, the picture's x to the right and z up.
static desk_pointer from_front(double x, double z, unsigned mods)
{
    const desk_pointer p = {.eye_mm = {x, -500, z},
                            .along = {0, 1, 0},
                            .forward = {0, 1, 0},
                            .right = {1, 0, 0},
                            .up = {0, 0, 1},
                            .spread = 0.0005,
                            .mods = mods};
    return p;
}

static void the_surface_is_the_limit(void)
{
    desk *d = make();
    grade *g = (grade *)d;
    sf_limit *limit = NULL;
    sf_locator *locator = NULL;
    CHECK(sf_limit_create(g->cage, SF_REFINE_STANDARD, NULL, NULL, &limit) == SF_OK);
    CHECK(sf_locator_create(limit, NULL, &locator) == SF_OK);
    CHECK(g->surface.face_count > 1000);
    double worst = 0, off = 0;
    for (size_t f = 0; f < g->surface.face_count; f += 7) {
        const double *p = g->surface.points + 3 * (size_t)g->surface.corners[4 * f];
        sf_place place;
        double distance, value, at[3];
        CHECK(sf_locator_find(locator, 1, p, 1, NULL, NULL, &place, &distance) == SF_OK);
        CHECK(sf_limit_positions(limit, 1, &place, NULL, NULL, at, NULL) == SF_OK);
        CHECK(sf_limit_values(limit, 0, 1, &place, NULL, NULL, &value, NULL) == SF_OK);
        worst = fmax(worst, fmax(distance, hypot(at[0] - p[0], at[1] - p[1])));
        off = fmax(off, fabs(value - g->surface.values[4 * f]));
        // And it is on the boundary: a place is at an end of its parameters, as nearly as can be
        // told along edges, where places hardly depend on them.
        double least = 1;
        for (int i = 0; i < 3; i++) {
            least = fmin(least, fmin(place.u[i], 1 - place.u[i]));
        }
        CHECK(least < 1e-2);
    }
    printf("# %zu faces, off by %.2g mm, values by %.2g\n", g->surface.face_count, worst, off);
    CHECK(worst < 1e-7 && off < 1e-6);
    sf_locator_destroy(locator);
    sf_limit_destroy(limit);
    d->is->destroy(d);
}

static void the_section_holds_the_property(void)
{
    desk *d = make();
    grade *g = (grade *)d;
    const grade_state *s = grade_desk_state(d);
    for (int axis = 0; axis < 3; axis++) {
        sf_limit *limit = NULL;
        sf_locator *locator = NULL;
        d->is->set(d, GRADE_CUT_AXIS, axis);
        d->is->set(d, GRADE_CUT_SHARE, 0.4);
        go_on(d);
        CHECK(d->said[0] == '\0' && g->section.solid != NULL && g->section.axis == axis);
        CHECK(sf_limit_create(g->cage, SF_REFINE_STANDARD, NULL, NULL, &limit) == SF_OK);
        CHECK(sf_locator_create(limit, NULL, &locator) == SF_OK);
        size_t solid = 0, tried = 0, missed = 0;
        for (size_t i = 0; i < (size_t)g->section.width * g->section.height; i++) {
            double p[3], distance, value;
            sf_place place;
            solid += g->section.solid[i];
            CHECK((g->section.material[i] > 0) == (g->section.solid[i] != 0));
            if (i % 31 != 0 || !g->section.solid[i]) {
                continue;
            }
            p[axis] = g->section.at_mm;
            p[(axis + 1) % 3] = g->section.origin_mm[0] +
                                ((double)(i % g->section.width) + 0.5) * g->section.pitch_mm;
            p[(axis + 2) % 3] = g->section.origin_mm[1] +
                                ((double)(i / g->section.width) + 0.5) * g->section.pitch_mm;
            CHECK(sf_locator_find(locator, 1, p, g->section.pitch_mm, NULL, NULL, &place,
                                  &distance) == SF_OK);
            CHECK(sf_limit_values(limit, 0, 1, &place, NULL, NULL, &value, NULL) == SF_OK);
            tried++;
            missed += fabs(value - g->section.values[i]) > 1e-3;
        }
        CHECK(tried > 20 && missed * 50 <= tried); // at the rim a voxel takes its neighbour's
        CHECK(s->counts[0] + s->counts[1] == solid && s->counts[0] > 0 && s->counts[1] > 0);
        sf_locator_destroy(locator);
        sf_limit_destroy(limit);
    }
    d->is->destroy(d);
}

// As many voxels of the second material as the property says: it is 0 to 1, and both are its ends.
static void the_print_has_the_tone(void)
{
    desk *d = make();
    grade *g = (grade *)d;
    const grade_state *s = grade_desk_state(d);
    d->is->set(d, GRADE_RESOLUTION, 300);
    go_on(d);
    double sum = 0;
    for (size_t i = 0; i < (size_t)g->section.width * g->section.height; i++) {
        sum += g->section.solid[i] ? (g->section.values[i] - s->low) / (s->high - s->low) : 0;
    }
    double all = (double)(s->counts[0] + s->counts[1]);
    CHECK(fabs((double)s->counts[1] / all - sum / all) < 0.005);
    d->is->set(d, GRADE_MATERIALS, 3);
    go_on(d);
    CHECK(s->counts[2] > 0 && s->counts[0] + s->counts[1] + s->counts[2] > 1000);
    d->is->destroy(d);
}

static void points_are_selected_and_painted(void)
{
    desk *a = make(), *b = make();
    const grade_state *s = grade_desk_state(a);
    uint64_t first = a->is->hash(a);
    const double *p = s->cage.positions; // the first point: front, below
    for (int i = 0; i < 2; i++) {
        desk *d = i == 0 ? a : b;
        desk_pointer at = from_front(p[0], p[2], 0);
        d->is->press(d, &at);
        d->is->release(d);
        d->is->set(d, GRADE_AMOUNT, 0);
        d->is->act(d, GRADE_APPLY);
        go_on(d);
    }
    CHECK(s->selected_count == 1 && s->history.undo_count == 1);
    CHECK(a->is->hash(a) == b->is->hash(b) && a->is->hash(a) != first);
    a->is->act(a, DO_UNDO);
    a->is->act(a, GRADE_NONE);
    CHECK(s->history.redo_count == 1);
    go_on(a);
    desk *fresh = make();
    go_on(fresh);
    CHECK(a->is->hash(a) == fresh->is->hash(fresh));
    a->is->act(a, DO_REDO);
    CHECK(a->is->hash(a) != fresh->is->hash(fresh));
    // Shift adds one, and takes it away.
    const double *q = s->cage.positions + 3 * 6;
    desk_pointer more = from_front(q[0], q[2], MOD_SHIFT);
    a->is->act(a, GRADE_ALL);
    CHECK(s->selected_count == s->cage.point_count);
    a->is->press(a, &more);
    a->is->release(a);
    CHECK(s->selected_count == s->cage.point_count - 1);
    a->is->destroy(a);
    b->is->destroy(b);
    fresh->is->destroy(fresh);
}

static void a_brush_paints_what_is_seen(void)
{
    desk *d = make();
    const grade_state *s = grade_desk_state(d);
    d->is->set(d, GRADE_TOOL, GRADE_BRUSH);
    d->is->set(d, GRADE_RADIUS, 14);
    d->is->set(d, GRADE_AMOUNT, 0);
    go_on(d);
    double z = 0.25 * s->low_mm[2] + 0.75 * s->high_mm[2] - 8;
    desk_pointer p = from_front(0, z, 0), q = from_front(20, z, 0), beside = from_front(400, 0, 0);
    d->is->hover(d, &beside);
    CHECK(!s->has_place);
    d->is->hover(d, &p);
    CHECK(s->has_place && fabs(s->place_mm[1]) < 1); // on the cut
    d->is->set(d, GRADE_CUT, 0);
    d->is->hover(d, &p);
    CHECK(s->has_place && s->place_mm[1] < -5); // on the front
    d->is->set(d, GRADE_CUT, 1);
    go_on(d);
    uint64_t before = d->is->hash(d);
    d->is->press(d, &p);
    CHECK(!d->is->is_busy(d)); // the section waits for the end of the stroke
    d->is->drag(d, &q);
    d->is->release(d);
    CHECK(s->history.undo_count == 1 && d->is->is_busy(d));
    go_on(d);
    CHECK(d->is->hash(d) != before);
    d->is->act(d, DO_UNDO);
    go_on(d);
    CHECK(d->is->hash(d) == before);
    d->is->press(d, &p);
    d->is->act(d, DO_GIVE_UP);
    go_on(d);
    CHECK(d->is->hash(d) == before);
    d->is->destroy(d);
}

static void points_are_moved(void)
{
    desk *d = make();
    const grade_state *s = grade_desk_state(d);
    d->is->set(d, GRADE_TOOL, GRADE_MOVE);
    double x = s->cage.positions[0], y = s->cage.positions[1], z = s->cage.positions[2];
    double high = s->high_mm[0];
    desk_pointer p = from_front(x, z, 0), q = from_front(x - 6, z + 2, 0);
    d->is->press(d, &p);
    d->is->drag(d, &q);
    d->is->release(d);
    CHECK(fabs(s->cage.positions[0] - x + 6) < 1e-9 && fabs(s->cage.positions[2] - z - 2) < 1e-9);
    CHECK(fabs(s->cage.positions[1] - y) < 1e-12 && s->low_mm[0] < -high);
    CHECK(s->inverted_cells == 0 && d->said[0] == '\0');
    q = from_front(x + 60, z, 0); // through the others
    p = from_front(x - 6, z + 2, 0);
    d->is->press(d, &p);
    d->is->drag(d, &q);
    d->is->release(d);
    CHECK(s->inverted_cells > 0 && strstr(d->said, "inside out") != NULL);
    d->is->act(d, DO_UNDO);
    CHECK(s->inverted_cells == 0 && d->said[0] == '\0');
    d->is->act(d, DO_UNDO);
    CHECK(s->cage.positions[0] == x && s->cage.positions[2] == z);
    d->is->destroy(d);
}

static void files(void)
{
    char why[DESK_WHY_SIZE] = "";
    desk *d = make(), *again = make();
    const grade_state *s = grade_desk_state(again);
    d->is->act(d, GRADE_ALL);
    d->is->set(d, GRADE_AMOUNT, 0.25);
    d->is->act(d, GRADE_APPLY);
    d->is->act(d, GRADE_NONE);
    CHECK(!d->is->open(d, "there_is_none.vtk", why) && why[0] != '\0');
    FILE *f = fopen("grade_broken.vtk", "w");
    CHECK(f != NULL && fputs("# vtk DataFile Version 3.0\nx\nASCII\nDATASET", f) >= 0);
    CHECK(fclose(f) == 0);
    uint64_t before = d->is->hash(d);
    CHECK(!d->is->open(d, "grade_broken.vtk", why) && d->is->hash(d) == before);
    CHECK(!d->is->save(d, "grade_out.stl", why) && strstr(why, ".vtk") != NULL);
    CHECK(d->is->save(d, "grade_out.vtk", why));
    CHECK(again->is->open(again, "grade_out.vtk", why));
    CHECK_EQ(s->cage.point_count, grade_desk_state(d)->cage.point_count);
    CHECK(s->cage.channels[0].values[3] == 0.25 && s->high > s->low);
    CHECK(again->is->adopt == NULL);
    // Faces alone have no inside, and are shown.
    f = fopen("grade_faces.vtk", "w");
    CHECK(f != NULL);
    fputs("# vtk DataFile Version 3.0\nfaces\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
          "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"
          "CELL_TYPES 4\n5\n5\n5\n5\n",
          f);
    CHECK(fclose(f) == 0);
    CHECK(again->is->open(again, "grade_faces.vtk", why));
    CHECK(s->cage.dimension == 2 && s->triangles > 20);
    go_on(again);
    stage *st = stage_create();
    CHECK(st != NULL && again->is->show(again, st));
    stage_destroy(st);
    d->is->destroy(d);
    again->is->destroy(again);
    unlink("grade_broken.vtk");
    unlink("grade_out.vtk");
    unlink("grade_faces.vtk");
}

static void it_shows(void)
{
    desk *d = make();
    stage *s = stage_create();
    size_t whole, cut, section, points;
    CHECK(s != NULL);
    go_on(d);
    CHECK(d->is->show(d, s));
    (void)stage_vertices(s, STAGE_SMOOTH, &cut);
    (void)stage_vertices(s, STAGE_BARE, &section);
    CHECK(cut > 1000 && section > 6000 && stage_get_picture(s).width > 100);
    d->is->set(d, GRADE_CUT, 0);
    d->is->set(d, GRADE_CAGE, 0);
    stage_clear(s);
    CHECK(d->is->show(d, s));
    (void)stage_vertices(s, STAGE_SMOOTH, &whole);
    (void)stage_vertices(s, STAGE_BARE, &section);
    (void)stage_points(s, &points);
    CHECK(whole == 3 * grade_desk_state(d)->triangles && whole > cut && section == 0);
    CHECK(points == 0 && stage_get_picture(s).width == 0);
    stage_destroy(s);
    d->is->destroy(d);
}

// To smooth goes by a share of 0 to 1, whatever the property's values are.
static void the_amount_is_one_that_can_be(void)
{
    char why[DESK_WHY_SIZE];
    desk *d = make();
    const grade_state *s = grade_desk_state(d);
    FILE *f = fopen("grade_amount.vtk", "w");
    CHECK(f != NULL);
    fputs("# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
          "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"
          "POINT_DATA 4\nSCALARS heat double 1\nLOOKUP_TABLE default\n100 200 300 400\n",
          f);
    CHECK(fclose(f) == 0);
    d->is->set(d, GRADE_OPERATION, SF_PAINT_SMOOTH);
    CHECK(d->is->open(d, "grade_amount.vtk", why));
    CHECK(s->operation == SF_PAINT_SMOOTH && s->high > 399);
    for (int i = 0; i < 2; i++) {
        CHECK(s->amount >= 0 && s->amount <= 1);
        d->is->act(d, GRADE_ALL);
        d->is->act(d, GRADE_APPLY);
        CHECK(s->history.undo_count == (size_t)i + 1 && d->said[0] == '\0');
        d->is->set(d, GRADE_CHANNEL, 0);
    }
    d->is->destroy(d);
    unlink("grade_amount.vtk");
}

// A key that is hit in the middle of a move does not make a stroke of it, from wherever the brush
// was last.
static void a_stroke_has_one_tool(void)
{
    desk *d = make();
    const grade_state *s = grade_desk_state(d);
    const double *at = s->cage.positions, x = at[0], z = at[2];
    const sf_channel *c = &s->cage.channels[0];
    double sum = 0;
    for (size_t i = 0; i < c->value_count; i++) {
        sum += c->values[i];
    }
    desk_pointer p = from_front(x, z, 0), q = from_front(0, 12, 0), r = from_front(x - 2, z, 0);
    d->is->set(d, GRADE_AMOUNT, 0);
    d->is->set(d, GRADE_TOOL, GRADE_MOVE);
    d->is->press(d, &p);
    d->is->key(d, '2', 0);
    CHECK(s->tool == GRADE_MOVE);
    d->is->drag(d, &q);
    d->is->drag(d, &r);
    d->is->release(d);
    CHECK_NEAR(s->cage.positions[0], x - 2, 1e-9);
    for (size_t i = 0; i < c->value_count; i++) {
        sum -= s->cage.channels[0].values[i];
    }
    CHECK_NEAR(sum, 0, 1e-12);
    d->is->key(d, '2', 0);
    CHECK(s->tool == GRADE_BRUSH);
    d->is->destroy(d);
}

// What a person should read stays as long as it is so, and no longer.
static void sentences(void)
{
    desk *d = make();
    const grade_state *s = grade_desk_state(d);
    double x = s->cage.positions[0], z = s->cage.positions[2];
    d->is->key(d, ' ', 0);
    CHECK(strstr(d->said, "selected") != NULL);
    d->is->act(d, GRADE_ALL);
    d->is->key(d, ' ', 0);
    CHECK_STR(d->said, "");
    d->is->act(d, GRADE_NONE);
    desk_pointer p = from_front(x, z, 0), q = from_front(x + 60, z, 0), mid = from_front(20, 14, 0);
    d->is->set(d, GRADE_TOOL, GRADE_MOVE);
    d->is->press(d, &p);
    d->is->drag(d, &q);
    d->is->release(d);
    CHECK(s->inverted_cells > 0);
    d->is->set(d, GRADE_TOOL, GRADE_BRUSH);
    go_on(d);              // to the section, which the pointer meets
    d->is->press(d, &mid); // painting mends no cell
    CHECK(s->has_place);
    d->is->release(d);
    CHECK(s->inverted_cells > 0 && strstr(d->said, "inside out") != NULL);
    d->is->set(d, GRADE_RADIUS, 1e-3);
    d->is->press(d, &mid);
    d->is->release(d);
    CHECK(strstr(d->said, "larger") != NULL);
    d->is->act(d, DO_UNDO);
    d->is->act(d, DO_UNDO);
    d->is->act(d, DO_UNDO);
    CHECK(s->inverted_cells == 0);
    CHECK_STR(d->said, "");
    d->is->destroy(d);
}

int main(void)
{
    TEST(the_surface_is_the_limit);
    TEST(the_section_holds_the_property);
    TEST(the_print_has_the_tone);
    TEST(points_are_selected_and_painted);
    TEST(a_brush_paints_what_is_seen);
    TEST(points_are_moved);
    TEST(files);
    TEST(it_shows);
    TEST(the_amount_is_one_that_can_be);
    TEST(a_stroke_has_one_tool);
    TEST(sentences);
    return test_finish();
}
