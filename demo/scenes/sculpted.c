// SPDX-License-Identifier: MIT
// Scenes that brushes made.
//
// Each is written as a person would work: large forms first, then what goes on them, with symmetry
// switched on and off. None of them knows what the brushes will leave out or put in; that they come
// out as they do is the brushes' doing.

#include "sculpted.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "chisel.h"

enum { CREAM = 1, BLUE, RUST, MOSS, GOLD, PLUM, INK, WHITE };

const char *const sculpted_names[] = {"shaun", "pumpkin", "intertwined", NULL};

static double turn(double part)
{
    return 2 * CHISEL_PI * part;
}

// ---------------------------------------------------------------------------------------------
// Shaun
// ---------------------------------------------------------------------------------------------

// Little balls all over the back and the sides of the body, ring by ring.
static void add_wool(chisel *c)
{
    chisel_take_ball(c, SF_BRUSH_ADD_TRIM, WHITE, 3.6);
    for (int ring = 0; ring < 9; ring++) {
        double along = -22 + 44 * ring / 8.0; // of the body
        double bulge = sqrt(fmax(0.0, 1 - along * along / (27.0 * 27.0)));
        for (int i = 0; i < 15; i++) {
            double angle = turn((i + 0.5 * (ring % 2)) / 15.0 * 0.62 - 0.06);
            chisel_at(c, 15.5 * bulge * cos(angle), along, 33 + 15.5 * bulge * sin(angle));
            chisel_lift(c);
        }
    }
}

static void add_legs(chisel *c)
{
    static const double ends[2][2] = {{8, 15}, {8, -15}};
    chisel_mirror(c, 1, 0);
    for (int i = 0; i < 2; i++) {
        const double foot[3] = {ends[i][0], ends[i][1], 0}, hip[3] = {7, ends[i][1] * 0.95, 22};
        chisel_take(c, SF_BRUSH_ADD_TRIM, INK, SF_TIP_CYLINDER, 5.2, 5.2, 1.5);
        chisel_line(c, foot, foot);
        chisel_take_ball(c, SF_BRUSH_ADD_TRIM, INK, 4.2);
        chisel_line(c, foot, hip);
        chisel_lift(c);
    }
    chisel_mirror(c, 0, 0);
}

static void add_head(chisel *c)
{
    const double crown[3] = {0, -31, 50}, nose[3] = {0, -37, 42};
    chisel_take_ball(c, SF_BRUSH_ADD_GROW, INK, 6.5);
    chisel_line(c, nose, crown);
    chisel_take_ball(c, SF_BRUSH_ADD_TRIM, WHITE, 4.6); // the tuft between the ears
    for (int i = 0; i < 5; i++) {
        chisel_at(c, 4.0 * cos(turn(i / 5.0)), -28 + 3.0 * sin(turn(i / 5.0)), 55.5);
        chisel_lift(c);
    }
    chisel_mirror(c, 1, 0);
    chisel_take(c, SF_BRUSH_ADD_TRIM, INK, SF_TIP_SPHERE, 5.5, 2.2, 2.6); // ears
    chisel_at(c, 9, -30, 52.5);
    chisel_at(c, 12, -30, 54.0);
    chisel_take_ball(c, SF_BRUSH_ADD_TRIM, WHITE, 1.9); // eyes
    chisel_at(c, 2.8, -36.4, 51.5);
    chisel_take_ball(c, SF_BRUSH_PAINT, INK, 1.1);
    chisel_at(c, 2.6, -38.2, 51.6);
    chisel_mirror(c, 0, 0);
}

static void make_shaun(chisel *c)
{
    add_legs(c);
    chisel_take_ball(c, SF_BRUSH_ADD_TRIM, CREAM, 17); // the body: an arch between the legs
    chisel_at(c, 0, 10, 32);
    chisel_lift(c);
    chisel_at(c, 0, -10, 32);
    add_wool(c);
    add_head(c);
    chisel_take_ball(c, SF_BRUSH_ADD_GROW, WHITE, 3.2); // the tail
    chisel_at(c, 0, 27.5, 35);
    chisel_at(c, 0, 30, 37);
    chisel_lift(c);
}

// ---------------------------------------------------------------------------------------------
// Pumpkin
// ---------------------------------------------------------------------------------------------

static void add_ribs(chisel *c)
{
    chisel_take_ball(c, SF_BRUSH_ADD_TRIM, RUST, 9.5);
    for (int i = 0; i < 12; i++) {
        double a = turn(i / 12.0);
        for (int k = 0; k <= 6; k++) { // up along a meridian
            double b = -0.95 + 2.05 * k / 6.0, r = 22.5 * cos(b);
            const double at[3] = {r * cos(a), r * sin(a), 24 + 19.0 * sin(b)};
            chisel_line(c, at, at);
        }
        chisel_lift(c);
    }
}

static void carve_face(chisel *c)
{
    chisel_mirror(c, 1, 0);
    chisel_take(c, SF_BRUSH_REMOVE_TRIM, RUST, SF_TIP_CONE, 5.6, 60, 6.5); // eyes
    chisel_at(c, 10.5, -36, 31);
    chisel_mirror(c, 0, 0);
    chisel_take(c, SF_BRUSH_REMOVE_TRIM, RUST, SF_TIP_CONE, 3.4, 60, 4.2); // the nose
    chisel_at(c, 0, -36, 24.5);
    chisel_take(c, SF_BRUSH_REMOVE_PRESERVE, RUST, SF_TIP_BOX, 1.3, 22,
                2.8); // a grin, by gaps between teeth
    for (int i = -4; i <= 4; i++) {
        chisel_at(c, 3.6 * i, -33, 15.5 + 0.2 * i * i);
        chisel_lift(c);
    }
}

static void add_arms(chisel *c)
{
    static const double path[5][3] = {
        {29, -2, 24}, {34, -5, 30}, {37, -9, 37}, {36, -13, 44}, {33, -15, 50}};
    chisel_mirror(c, 1, 0);
    chisel_take_ball(c, SF_BRUSH_ADD_GROW, MOSS, 3.0);
    for (int i = 0; i < 4; i++) {
        chisel_line(c, path[i], path[i + 1]);
    }
    chisel_take_ball(c, SF_BRUSH_ADD_TRIM, GOLD, 4.2);
    chisel_at(c, 32, -16, 52);
    chisel_mirror(c, 0, 0);
}

static void make_pumpkin(chisel *c)
{
    add_ribs(c);
    chisel_take(c, SF_BRUSH_ADD_TRIM, RUST, SF_TIP_SPHERE, 25, 25, 21);
    chisel_at(c, 0, 0, 24);
    chisel_take(c, SF_BRUSH_REMOVE_TRIM, RUST, SF_TIP_CYLINDER, 20.5, 20.5, 12); // for the light
    chisel_at(c, 0, 0, 16);
    chisel_take(c, SF_BRUSH_REMOVE_TRIM, RUST, SF_TIP_CONE, 20.5, 20.5, 13); // and the flame
    chisel_at(c, 0, 0, 40.6);
    carve_face(c);
    chisel_take_ball(c, SF_BRUSH_SMOOTH_TRIM, RUST, 9);
    c->brush.passes = 3;
    for (int i = 0; i < 8; i++) { // the shoulders, so that ribs run out
        chisel_at(c, 17 * cos(turn(i / 8.0)), 17 * sin(turn(i / 8.0)), 43);
    }
    chisel_lift(c);
    c->brush.passes = 1;
    const double stalk[2][3] = {{0, 0, 45}, {4, 3, 55}};
    chisel_take_ball(c, SF_BRUSH_ADD_TRIM, MOSS, 3.6);
    chisel_line(c, stalk[0], stalk[1]);
    add_arms(c);
}

// ---------------------------------------------------------------------------------------------
// Intertwined
// ---------------------------------------------------------------------------------------------

static void strand_at(int strand, double part, double at[3])
{
    double a = turn(0.66 * part + strand / 3.0), r = 20 - 9 * part + 3 * sin(CHISEL_PI * part);
    at[0] = r * cos(a);
    at[1] = r * sin(a);
    at[2] = 96 * part;
}

static void make_intertwined(chisel *c)
{
    static const uint8_t materials[3] = {BLUE, GOLD, PLUM};
    chisel_take(c, SF_BRUSH_ADD_TRIM, CREAM, SF_TIP_CYLINDER, 31, 31, 2.5);
    chisel_at(c, 0, 0, 0);
    for (int s = 0; s < 3; s++) {
        chisel_take_ball(c, SF_BRUSH_ADD_GROW, materials[s], 5.2);
        for (int i = 0; i < 48; i++) {
            double from[3], to[3];
            strand_at(s, i / 48.0, from);
            strand_at(s, (i + 1) / 48.0, to);
            chisel_line(c, from, to);
        }
        chisel_lift(c);
    }
    chisel_take_ball(c, SF_BRUSH_ADD_GROW, CREAM, 9); // where they meet
    chisel_at(c, 0, 0, 103);
    chisel_take_ball(c, SF_BRUSH_REMOVE_PRESERVE, CREAM, 5);
    chisel_at(c, 0, 0, 103);
    chisel_take_ball(c, SF_BRUSH_ADD_TRIM, RUST, 2.6);
    for (int i = 0; i < 36; i++) { // beads up along the strands
        double at[3];
        strand_at(i % 3, (i + 2) / 40.0, at);
        double out = 1 + 5.4 / sqrt(at[0] * at[0] + at[1] * at[1]);
        chisel_at(c, at[0] * out, at[1] * out, at[2] + 1.5);
        chisel_lift(c);
    }
}

// ---------------------------------------------------------------------------------------------
// The table
// ---------------------------------------------------------------------------------------------

static void (*const makers[])(chisel *c) = {make_shaun, make_pumpkin, make_intertwined};

static sf_status draw(void (*make)(chisel *c), uint32_t resolution, sf_session *session)
{
    chisel *c = calloc(1, sizeof *c);
    if (c == NULL) {
        return SF_ERR_MEMORY;
    }
    c->session = session;
    c->resolution = resolution;
    c->pitch_mm = sf_session_options_of(session).lattice.pitch_x_mm;
    c->brush = sf_brush_default();
    make(c);
    chisel_lift(c);
    sf_status status = c->status;
    free(c);
    return status;
}

sf_status sculpted_session(const char *name, uint32_t resolution, const sf_allocator *allocator,
                           sf_session **session)
{
    size_t which = 0;
    while (sculpted_names[which] != NULL && strcmp(sculpted_names[which], name) != 0) {
        which++;
    }
    if (sculpted_names[which] == NULL || resolution < 64 || resolution > 512) {
        return SF_ERR_ARGUMENT;
    }
    sf_session *made = NULL;
    sf_session_options options = sf_session_options_default();
    double pitch = 0.25 * 512 / resolution;
    sf_lattice lattice = {resolution, resolution, resolution, pitch,
                          pitch,      pitch,      NULL,       {-64, -64, 0}};
    options.lattice = lattice;
    sf_status status = sf_session_create(&options, allocator, &made);
    if (status == SF_OK) {
        status = draw(makers[which], resolution, made);
    }
    if (status != SF_OK) {
        sf_session_destroy(made);
        return status;
    }
    *session = made;
    return SF_OK;
}
