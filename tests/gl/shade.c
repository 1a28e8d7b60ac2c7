// SPDX-License-Identifier: MIT
// What is drawn says what it should: a face has its material's colour, what leans has another where
// that is asked for, ghosts tint what lies behind them, a shadow is darker than the ground beside
// it, the ground has a line each 10 mm, a cut shows hatched matter, and the brush's rim is where
// the brush is. Colours are compared with what is beside them, so that light may change.

#include "twin.h"

#include <epoxy/gl.h>

#include "view/upload.h"
#include "view/view.h"

enum { SIDE = 200 };

// A table: a leg in the middle, 10 mm high, and a top that leans out of it; 64 mm of space.
typedef struct stage {
    sf_sculpt *model;
    view_upload *upload;
    view *view;
    view_camera camera;
    view_overlays overlays;
    unsigned char pixels[3 * SIDE * SIDE];
} stage;

static void put_box(sf_sculpt *model, uint8_t material, double rx, double ry, double rz, sf_dab at)
{
    const double radius[3] = {rx, ry, rz};
    sf_brush brush = sf_brush_default();
    sf_tip *tip = NULL;
    CHECK(sf_tip_create(SF_TIP_BOX, radius, NULL, &tip) == SF_OK);
    brush.tip = tip;
    brush.material = material;
    CHECK(sf_sculpt_stroke(model, &brush, &at, 1, NULL) == SF_OK);
    sf_tip_destroy(tip);
}

static stage *make_stage(void)
{
    const char *why = NULL;
    sf_sculpt_options o = sf_sculpt_options_default();
    sf_lattice lattice = {64, 64, 64, 1, 1, 1, NULL, {0, 0, 0}};
    stage *s = calloc(1, sizeof *s);
    sf_dab left = {26, 32, 10}, right = {37, 32, 10}, high = {32, 32, 40};
    o.lattice = lattice;
    o.keep_drawn = 1;
    CHECK(sf_sculpt_create(&o, NULL, &s->model) == SF_OK);
    put_box(s->model, 2, 5, 10, 10, left);  // x 21 to 32, blue
    put_box(s->model, 3, 5, 10, 10, right); // x 32 to 43, rust
    put_box(s->model, 1, 3, 3, 1, high);    // in the air: a ghost
    s->upload = view_upload_create(&lattice, &why);
    s->view = view_create(&why);
    CHECK(s->upload != NULL && s->view != NULL);
    CHECK(view_upload_copy(s->upload, sf_sculpt_drawn(s->model), sf_sculpt_printable(s->model),
                           sf_sculpt_materials(s->model), NULL));
    gpu_view buffers = view_upload_view(s->upload);
    view_look_at(s->view, &buffers, &lattice, 0);
    s->overlays = view_overlays_default();
    s->overlays.ghosts = 0;
    return s;
}

static void free_stage(stage *s)
{
    view_destroy(s->view);
    view_upload_destroy(s->upload);
    sf_sculpt_destroy(s->model);
    free(s);
}

// Looks straight at a point, from so far that 200 pixels are about as many mm as `width`.
static void shoot(stage *s, double azimuth, double elevation, double width)
{
    const double low[3] = {32 - width / 2, 32 - width / 2, 0},
                 high[3] = {32 + width / 2, 32 + width / 2, 1};
    s->camera = view_camera_fit(low, high, azimuth, elevation, 1);
    CHECK(view_shot(s->view, &s->camera, &s->overlays, SIDE, SIDE, s->pixels));
}

// The pixel at which a place lies in the picture.
static const unsigned char *at(const stage *s, double x, double y, double z)
{
    view_frame f = view_camera_frame(&s->camera, 1);
    const double p[3] = {x, y, z};
    double along = 0, u = 0, v = 0, rr = 0, uu = 0;
    for (int i = 0; i < 3; i++) {
        along += (p[i] - f.eye[i]) * f.forward[i];
        u += (p[i] - f.eye[i]) * f.right[i];
        v += (p[i] - f.eye[i]) * f.up[i];
        rr += f.right[i] * f.right[i];
        uu += f.up[i] * f.up[i];
    }
    int px = (int)floor((u / rr / along + 1) / 2 * SIDE);
    int py = (int)floor((1 - v / uu / along) / 2 * SIDE);
    CHECK(px >= 0 && px < SIDE && py >= 0 && py < SIDE);
    return s->pixels + 3 * (py * SIDE + px);
}

static int light(const unsigned char *p)
{
    return p[0] + p[1] + p[2];
}

// How far a colour is from another of the same lightness.
static double hue_gap(const unsigned char *p, const unsigned char *q)
{
    double gap = 0;
    for (int i = 0; i < 3; i++) {
        gap += fabs((double)p[i] / light(p) - (double)q[i] / light(q));
    }
    return gap;
}

static void materials(void)
{
    stage *s = make_stage();
    shoot(s, -1.57, 1.5, 64);
    CHECK(hue_gap(at(s, 25, 32, 21), view_palette[1]) < 0.06);
    CHECK(hue_gap(at(s, 40, 32, 21), view_palette[2]) < 0.06);
    CHECK(hue_gap(at(s, 25, 32, 21), at(s, 40, 32, 21)) > 0.3);
    free_stage(s);
}

static void ground_and_shadow(void)
{
    stage *s = make_stage();
    shoot(s, -1.57, 1.5, 64);
    int open = light(at(s, 55, 15, 0)), line = light(at(s, 50.05, 15, 0));
    int shade = light(at(s, 17, 45, 0)); // the light comes from +x and -y
    CHECK(line < open - 60);
    CHECK(shade < open - 120);
    s->overlays.shadows = 0;
    shoot(s, -1.57, 1.5, 64);
    CHECK(light(at(s, 17, 45, 0)) > open - 30);
    s->overlays.ground = 0;
    shoot(s, -1.57, 1.5, 64);
    CHECK(abs(light(at(s, 50.05, 15, 0)) - light(at(s, 55, 15, 0))) < 12);
    free_stage(s);
}

static void overhangs(void)
{
    stage *s = make_stage();
    const double radius[3] = {20, 20, 20};
    sf_brush brush = sf_brush_default();
    sf_tip *tip = NULL;
    sf_dab top = {32, 32, 28};
    CHECK(sf_tip_create(SF_TIP_SPHERE, radius, NULL, &tip) == SF_OK);
    brush.tip = tip;
    CHECK(sf_sculpt_stroke(s->model, &brush, &top, 1, NULL) == SF_OK);
    CHECK(view_upload_copy(s->upload, sf_sculpt_drawn(s->model), sf_sculpt_printable(s->model),
                           sf_sculpt_materials(s->model), NULL));
    view_changed(s->view, NULL);
    shoot(s, -1.57, 0.02, 64);
    unsigned char plain[3], leaning[3];
    memcpy(plain, at(s, 32, 15, 23.5), 3);
    s->overlays.overhangs = 1;
    shoot(s, -1.57, 0.02, 64);
    memcpy(leaning, at(s, 32, 15, 23.5), 3);
    CHECK(leaning[0] > leaning[2] + 40 && hue_gap(plain, leaning) > 0.15);
    CHECK(hue_gap(at(s, 32, 14, 38), plain) < 0.1); // what leans back is as it was
    sf_tip_destroy(tip);
    free_stage(s);
}

static void ghosts(void)
{
    stage *s = make_stage();
    shoot(s, -1.57, 1.5, 64);
    unsigned char before[3];
    memcpy(before, at(s, 32, 32, 41), 3);
    s->overlays.ghosts = 1;
    shoot(s, -1.57, 1.5, 64);
    const unsigned char *after = at(s, 32, 32, 41);
    CHECK(hue_gap(before, after) > 0.04);
    CHECK(hue_gap(at(s, 25, 25, 21), view_palette[1]) < 0.06); // beside it nothing changed
    free_stage(s);
}

// Matter that is cut has two tones, hatched.
static void cut(void)
{
    stage *s = make_stage();
    s->overlays.is_cut = 1;
    s->overlays.cut_axis = 2;
    s->overlays.cut_mm = 12;
    shoot(s, -1.57, 1.5, 64);
    int low = 999, high = 0;
    for (int i = 0; i < 12; i++) {
        int here = light(at(s, 23 + 0.4 * i, 30, 12));
        low = here < low ? here : low;
        high = here > high ? here : high;
    }
    CHECK(high - low > 15);
    CHECK(hue_gap(at(s, 25, 32, 12), view_palette[1]) < 0.06);
    free_stage(s);
}

static void cursor(void)
{
    stage *s = make_stage();
    shoot(s, -1.57, 1.5, 64);
    unsigned char inside[3], beside[3];
    memcpy(inside, at(s, 25, 32, 21), 3);
    memcpy(beside, at(s, 40, 39, 21), 3);
    s->overlays.has_cursor = 1;
    const double place[3] = {25, 32, 21};
    for (int i = 0; i < 3; i++) {
        s->overlays.cursor[i] = place[i];
        s->overlays.reach[i] = 6;
    }
    shoot(s, -1.57, 1.5, 64);
    CHECK(hue_gap(inside, at(s, 25, 32, 21)) > 0.02);
    CHECK(memcmp(beside, at(s, 40, 39, 21), 3) == 0);
    const unsigned char *rim = at(s, 25, 37.9, 21);
    CHECK(rim[0] > 180 && rim[2] < 150); // yellow
    s->overlays.has_plane = 1;
    s->overlays.plane_axis = 2;
    shoot(s, -1.57, 1.5, 64);
    CHECK(memcmp(beside, at(s, 40, 39, 21), 3) != 0);
    free_stage(s);
}

int main(void)
{
    gl_headless *context = NULL;
    if (!gl_begin(&context)) {
        return gl_status;
    }
    TEST(materials);
    TEST(ground_and_shadow);
    TEST(overhangs);
    TEST(ghosts);
    TEST(cut);
    TEST(cursor);
    gl_headless_destroy(context);
    return test_finish();
}
