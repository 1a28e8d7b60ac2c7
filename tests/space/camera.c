// SPDX-License-Identifier: MIT
// The cap of a SpaceMouse is the shape in the hand. One sign that is wrong, and it goes the other
// way. Here the cap is pushed and turned, what that does goes through the editor as events, and
// points of the shape are looked for in the picture before and after: they have to go where the cap
// went, by as much across as upwards, and not at all where the cap rests.

#include "test.h"

#include "app/editor.h"
#include "app/fly.h"

enum { WIDTH = 800, HEIGHT = 400 };

static editor *make(void)
{
    sf_sculpt_options o = sf_sculpt_options_default();
    sf_sculpt *model = NULL;
    o.lattice.nx = o.lattice.ny = o.lattice.nz = 32;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_OK);
    editor *e = editor_create(model, NULL, WIDTH, HEIGHT);
    CHECK(e != NULL);
    return e;
}

static space_state hold(int axis, int number)
{
    space_state state = {{0, 0, 0, 0, 0, 0}, 0};
    state.axes[axis] = number;
    return state;
}

static int push(editor *e, const space_state *state, double seconds)
{
    space_motion motion = {0, 0, 0, 0, 0, 0};
    app_event events[FLY_EVENTS_MOST];
    space_motion_add(&motion, state, seconds);
    int count = app_fly(&motion, (double)WIDTH / HEIGHT, events);
    for (int i = 0; i < count; i++) {
        editor_take(e, &events[i]);
    }
    return count;
}

// Where a point is in the picture: u and v from -1 to 1, and how far in front of the eye.
static void find(const view_camera *camera, const double point[3], double out[3])
{
    view_frame f = view_camera_frame(camera, (double)WIDTH / HEIGHT);
    double along = 0, u = 0, v = 0, uu = 0, vv = 0;
    for (int i = 0; i < 3; i++) {
        double p = point[i] - f.eye[i];
        along += p * f.forward[i];
        u += p * f.right[i];
        v += p * f.up[i];
        uu += f.right[i] * f.right[i];
        vv += f.up[i] * f.up[i];
    }
    out[0] = u / uu / along;
    out[1] = v / vv / along;
    out[2] = along;
}

// What a cap that is held so for a moment does to a point of the shape. `near_share`: 0, the point
// in the middle of the picture; more, one nearer to the eye, on the same level.
static void moved(int axis, int number, double near_share, double by[3])
{
    editor *e = make();
    view_camera before = e->camera;
    space_state state = hold(axis, number);
    double point[3], from[3], to[3];
    memcpy(point, before.target, sizeof point);
    point[0] += near_share * before.distance * cos(before.azimuth);
    point[1] += near_share * before.distance * sin(before.azimuth);
    push(e, &state, 0.05);
    find(&before, point, from);
    find(&e->camera, point, to);
    for (int i = 0; i < 3; i++) {
        by[i] = to[i] - from[i];
    }
    editor_destroy(e);
}

static void pushes(void)
{
    double by[3];
    moved(SPACE_X, 350, 0, by); // to the right
    CHECK(by[0] > 0.01 && fabs(by[1]) < 1e-9 && fabs(by[2]) < 1e-9);
    double across = by[0] * WIDTH;
    moved(SPACE_X, -350, 0, by);
    CHECK(by[0] < -0.01);
    moved(SPACE_Z, 350, 0, by); // down
    CHECK(by[1] < -0.01 && fabs(by[0]) < 1e-9 && fabs(by[2]) < 1e-9);
    CHECK_NEAR(-by[1] * HEIGHT, across, 1e-6 * across);
    moved(SPACE_Y, 350, 0, by); // towards the person
    CHECK(by[2] < -0.01 && fabs(by[0]) < 1e-9 && fabs(by[1]) < 1e-9);
    moved(SPACE_Y, -350, 0, by);
    CHECK(by[2] > 0.01);
}

static void turns(void)
{
    double by[3];
    // Clockwise from above: what is near goes to the left.
    moved(SPACE_RZ, 350, 0.2, by);
    CHECK(by[0] < -0.005);
    moved(SPACE_RZ, -350, 0.2, by);
    CHECK(by[0] > 0.005);
    // Its top towards the person: what is near goes down.
    moved(SPACE_RX, 350, 0.2, by);
    CHECK(by[1] < -0.005 && fabs(by[0]) < 1e-9);
    moved(SPACE_RX, -350, 0.2, by);
    CHECK(by[1] > 0.005);
    // What is turned about does not move; there is no roll.
    moved(SPACE_RZ, 350, 0, by);
    CHECK(fabs(by[0]) < 1e-9 && fabs(by[1]) < 1e-9 && fabs(by[2]) < 1e-9);
    moved(SPACE_RY, 350, 0.2, by);
    CHECK(fabs(by[0]) < 1e-12 && fabs(by[1]) < 1e-12 && fabs(by[2]) < 1e-12);
}

static void speeds(void)
{
    editor *e = make();
    double last = 0;
    for (int number = 0; number <= 500; number++) {
        space_motion there = {0, 0, 0, 0, 0, 0}, back = there, twice = there;
        space_state a = hold(SPACE_RZ, number), b = hold(SPACE_RZ, -number);
        space_motion_add(&there, &a, 0.02);
        space_motion_add(&back, &b, 0.02);
        space_motion_add(&twice, &a, 0.01);
        space_motion_add(&twice, &a, 0.01);
        CHECK_NEAR(there.turn, -back.turn, 0);
        CHECK_NEAR(there.turn, twice.turn, 1e-15);
        CHECK(there.turn >= last);
        CHECK(number > 4 || !push(e, &a, 0.02));
        CHECK(number < 6 || there.turn > 0);
        CHECK(number < 6 || number >= 350 || there.turn > last);
        CHECK(number <= 350 || there.turn <= last);
        last = there.turn;
    }
    editor_destroy(e);
}

static void buttons(void)
{
    const space_model *navigator = space_model_of(SPACE_VENDOR_OLD, 0xc626);
    const space_model *pro = space_model_of(SPACE_VENDOR, 0xc632);
    space_motion m = {0, 0, 0, 0, 0, 0};
    app_event events[FLY_EVENTS_MOST];
    space_motion_press(&m, navigator, 0, 1);
    CHECK_EQ(m.pressed, SPACE_UNDO);
    space_motion_press(&m, navigator, 1, 3);
    CHECK_EQ(m.pressed, SPACE_UNDO | SPACE_FIT);
    m.pressed = 0;
    space_motion_press(&m, navigator, 3, 3); // held
    space_motion_press(&m, navigator, 3, 0); // let go
    space_motion_press(&m, navigator, 0, 0xfffffffcu);
    CHECK_EQ(m.pressed, 0);
    space_motion_press(&m, pro, 0, (uint32_t)1 << 22);
    CHECK_EQ(m.pressed, SPACE_ESCAPE);
    m.pressed = SPACE_UNDO | SPACE_FIT | SPACE_ESCAPE;
    m.tilt = 0.1;
    CHECK_EQ(app_fly(&m, 2, events), 4);
    CHECK(events[0].kind == EVENT_DO && events[0].code == DO_GIVE_UP);
    CHECK(events[1].kind == EVENT_DO && events[1].code == DO_UNDO);
    CHECK(events[2].kind == EVENT_DO && events[2].code == DO_FRAME);
    CHECK(events[3].kind == EVENT_FLY);
    m.pressed = 0;
    m.tilt = 0;
    CHECK_EQ(app_fly(&m, 2, events), 0);
}

// A picture of no height, and a camera that is pushed for a long time, stay numbers.
static void ends(void)
{
    editor *e = make();
    const app_event none = {EVENT_SIZE, 0, 0, 0, 0, 0, 0, 0};
    space_state state = {{350, -350, 350, 350, -350, 350}, 0};
    editor_take(e, &none);
    for (int i = 0; i < 10000; i++) {
        space_motion motion = {0, 0, 0, 0, 0, 0};
        app_event events[FLY_EVENTS_MOST];
        space_motion_add(&motion, &state, 0.1);
        CHECK_EQ(app_fly(&motion, i % 2 == 0 ? 0.0 : 2.0, events), 1);
        editor_take(e, &events[0]);
    }
    CHECK(isfinite(e->camera.distance) && e->camera.distance > 0);
    CHECK(isfinite(e->camera.azimuth) && fabs(e->camera.elevation) < 1.6);
    CHECK(isfinite(e->camera.target[0]) && isfinite(e->camera.target[1]) &&
          isfinite(e->camera.target[2]));
    editor_destroy(e);
}

int main(void)
{
    TEST(pushes);
    TEST(turns);
    TEST(speeds);
    TEST(buttons);
    TEST(ends);
    return test_finish();
}
