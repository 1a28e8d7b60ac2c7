// SPDX-License-Identifier: MIT
// A SpaceMouse comes and goes while the window is open: it is plugged in late, pulled out with its
// cap held, out of reach, on a cable beside its own receiver, or not ours to read. None of that may
// stop the window, make the camera run away, or leave a device open. A stand-in for hidapi plays
// the devices.

#include "test.h"

#include "space/space.h"
#include "stand_in.h"

static char path_a[] = "a", path_b[] = "b";
static const unsigned char push_right[] = {1, 0x2c, 1, 0, 0, 0, 0}; // x 300
static const unsigned char let_loose[] = {1, 0, 0, 0, 0, 0, 0};

static place *plug_navigator(int at, char *path)
{
    return plug(at, 0x046d, 0xc626, 1, 8, path);
}

// Poll every 10 ms until a time; what was moved to the right.
static double poll_until(space *s, double *now_s, double end_s, unsigned *pressed)
{
    double right = 0;
    for (; *now_s < end_s - 1e-9; *now_s += 0.01) {
        space_motion m;
        int did = space_poll(s, *now_s, &m);
        CHECK_EQ(did, !space_motion_is_none(&m));
        right += m.right;
        if (pressed != NULL) {
            *pressed |= m.pressed;
        }
    }
    return right;
}

// Every device that was opened is closed, and every list is freed.
static void finish(space *s)
{
    space_destroy(s);
    CHECK_EQ(opens, closes);
    CHECK_EQ(nodes, 0);
    CHECK_EQ(exits, inits - init_fails);
}

static void none(void)
{
    reset();
    space *s = space_create();
    double now = 0;
    CHECK(poll_until(s, &now, 10, NULL) == 0);
    CHECK(looks >= 2 * 9 && looks <= 2 * 11); // two makers, once a second
    CHECK(space_patience(s) >= 0.5 && space_trouble(s) == NULL);
    finish(s);
    space_destroy(NULL);
}

static void no_hidapi(void)
{
    reset();
    init_fails = 1;
    plug_navigator(0, path_a);
    space *s = space_create();
    double now = 0;
    CHECK(poll_until(s, &now, 3, NULL) == 0);
    CHECK(looks == 0 && opens == 0 && space_trouble(s) == NULL);
    finish(s);
}

static void comes_late(void)
{
    reset();
    space *s = space_create();
    double now = 0;
    poll_until(s, &now, 2.5, NULL);
    place *p = plug_navigator(0, path_a);
    poll_until(s, &now, 4, NULL);
    CHECK_EQ(opens, 1);
    CHECK(space_patience(s) < 0.05);
    CHECK(poll_until(s, &now, 5, NULL) == 0);
    say(p, push_right, sizeof push_right);
    double at_once = poll_until(s, &now, 5.1, NULL), later = poll_until(s, &now, 5.2, NULL);
    CHECK(at_once < 0);
    CHECK_NEAR(later, at_once, 1e-9);
    say(p, let_loose, sizeof let_loose);
    CHECK(poll_until(s, &now, 6, NULL) == 0);
    CHECK_EQ(opens, 1);
    finish(s);
}

static void pulled_out(void)
{
    reset();
    place *p = plug_navigator(0, path_a);
    space *s = space_create();
    double now = 0;
    say(p, push_right, sizeof push_right);
    CHECK(poll_until(s, &now, 0.2, NULL) < 0);
    p->is_there = 0;
    CHECK(poll_until(s, &now, 3, NULL) == 0);
    CHECK(closes == 1 && p->is_open == 0);
    CHECK(space_patience(s) >= 0.5);
    p = plug_navigator(0, path_a);
    CHECK(poll_until(s, &now, 5, NULL) == 0); // the cap is free
    CHECK_EQ(opens, 2);
    say(p, push_right, sizeof push_right);
    CHECK(poll_until(s, &now, 5.2, NULL) < 0);
    // An error of the device is as if it were pulled out.
    p->is_broken = 1;
    CHECK(poll_until(s, &now, 5.6, NULL) == 0);
    CHECK(closes >= 2 && closes == opens);
    finish(s);
}

static void out_of_reach(void)
{
    reset();
    place *p = plug_navigator(0, path_a);
    space *s = space_create();
    double now = 0;
    poll_until(s, &now, 0.1, NULL);
    say(p, push_right, sizeof push_right);
    CHECK(poll_until(s, &now, 0.3, NULL) < 0);
    poll_until(s, &now, 0.8, NULL);
    CHECK(poll_until(s, &now, 5, NULL) == 0);
    // One that goes on speaking is not taken to be gone, and is not looked past.
    int before = looks;
    for (int n = 0; n < 30; n++) {
        p->first = p->last = 0;
        say(p, push_right, sizeof push_right);
        CHECK(poll_until(s, &now, now + 0.1, NULL) < 0);
    }
    CHECK_EQ(looks, before);
    finish(s);
}

static void forbidden(void)
{
    reset();
    place *p = plug_navigator(0, path_a);
    p->is_forbidden = 1;
    space *s = space_create();
    double now = 0;
    poll_until(s, &now, 2, NULL);
    CHECK(space_trouble(s) != NULL);
    p->is_forbidden = 0;
    poll_until(s, &now, 4, NULL);
    CHECK(space_trouble(s) == NULL && opens == 1);
    finish(s);
}

static void presses(void)
{
    static const unsigned char down[] = {3, 1, 0}, both[] = {3, 3, 0}, up[] = {3, 0, 0};
    reset();
    place *p = plug_navigator(0, path_a);
    space *s = space_create();
    double now = 0;
    unsigned pressed = 0;
    say(p, down, sizeof down); // and up between two frames
    say(p, up, sizeof up);
    poll_until(s, &now, 0.1, &pressed);
    CHECK_EQ(pressed, SPACE_UNDO);
    pressed = 0;
    say(p, down, sizeof down);
    poll_until(s, &now, 0.2, NULL);
    say(p, both, sizeof both);
    poll_until(s, &now, 0.3, &pressed);
    CHECK_EQ(pressed, SPACE_FIT);
    pressed = 0;
    poll_until(s, &now, 2, &pressed); // held
    CHECK_EQ(pressed, 0);
    finish(s);
}

static void endless(void)
{
    reset();
    plug_navigator(0, path_a)->is_endless = 1;
    space *s = space_create();
    space_motion m;
    CHECK_EQ(space_poll(s, 0, &m), 0);
    CHECK_EQ(space_poll(s, 0.01, &m), 1);
    CHECK(reads <= 200);
    finish(s);
}

static void beside_its_receiver(void)
{
    reset();
    plug(0, 0x256f, 0xc632, 1, 8, path_a);
    place *p = plug(1, 0x256f, 0xc631, 1, 8, path_b);
    static const unsigned char all[] = {1, 0x2c, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0x2c, 1};
    space *s = space_create();
    space_motion m;
    space_poll(s, 0, &m);
    say(p, all, sizeof all);
    CHECK_EQ(space_poll(s, 0.01, &m), 1);
    CHECK(m.right < 0 && m.turn > 0);
    CHECK_EQ(opens, 2);
    finish(s);
}

static void others(void)
{
    static char long_path[2000];
    reset();
    memset(long_path, 'x', sizeof long_path - 1);
    plug(0, 0x256f, 0xc657, 1, 2, path_a);    // a mouse of the same maker
    plug(1, 0x046d, 0xc077, 1, 8, path_b);    // a device that only looks like one
    plug(2, 0x256f, 0xc657, 0, 0, path_a);    // nobody knows what it is
    plug(3, 0x256f, 0xc635, 1, 8, NULL);      // no path
    plug(4, 0x256f, 0xc635, 1, 8, long_path); // one that is too long
    plug(5, 0x256f, 0xc652, 1, 0x80, path_b); // another part of the receiver
    plug(6, 0x256f, 0xc635, 1, 0, path_a);
    space *s = space_create();
    double now = 0;
    poll_until(s, &now, 3, NULL);
    CHECK(opens == 0 && space_trouble(s) == NULL);
    plug(6, 0x256f, 0xc635, 0, 0, path_a); // known by its number
    poll_until(s, &now, 5, NULL);
    CHECK_EQ(opens, 1);
    plug(7, 0x256f, 0xffff, 1, 8, path_b); // new, but of the right kind
    places[5].is_there = 0;
    poll_until(s, &now, 7, NULL);
    CHECK_EQ(opens, 2);
    finish(s);
}

static void many(void)
{
    static char paths[PLACES][2];
    reset();
    for (int i = 0; i < PLACES; i++) {
        paths[i][0] = (char)('a' + i);
        plug_navigator(i, paths[i]);
    }
    space *s = space_create();
    double now = 0;
    poll_until(s, &now, 3, NULL);
    CHECK(opens >= 4 && opens < PLACES);
    for (int i = 0; i < PLACES; i++) {
        CHECK(places[i].is_open <= 1);
    }
    finish(s);
}

static void clocks(void)
{
    reset();
    place *p = plug_navigator(0, path_a);
    space *s = space_create();
    space_motion m;
    space_poll(s, 100, &m);
    say(p, push_right, sizeof push_right);
    space_poll(s, 100.1, &m);
    double most = m.right;
    say(p, push_right, sizeof push_right);
    space_poll(s, 200, &m); // the window was away
    CHECK_NEAR(m.right, most, 1e-9);
    say(p, push_right, sizeof push_right);
    CHECK_EQ(space_poll(s, 150, &m), 0); // a clock that goes back
    finish(s);
}

int main(void)
{
    TEST(none);
    TEST(no_hidapi);
    TEST(comes_late);
    TEST(pulled_out);
    TEST(out_of_reach);
    TEST(forbidden);
    TEST(presses);
    TEST(endless);
    TEST(beside_its_receiver);
    TEST(others);
    TEST(many);
    TEST(clocks);
    return test_finish();
}
