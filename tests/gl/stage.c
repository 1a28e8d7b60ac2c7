// SPDX-License-Identifier: MIT
// What is put on a stage is where the camera's rays say it is: nearer before farther, glass over
// both, lines and points at their places, the picture pixel for pixel. Places are computed from the
// camera's frame, not by the shaders' way.

#include "twin.h"

#include <epoxy/gl.h>
#include <math.h>

#include "stage/stage_view.h"

enum { WIDTH = 200, HEIGHT = 160, SIZE = 3 * WIDTH * HEIGHT };

static const uint8_t red[4] = {200, 40, 40, 255}, blue[4] = {40, 60, 200, 255};

static view_camera from_above(void)
{
    const double low[3] = {-10, -10, -10}, high[3] = {10, 10, 10};
    return view_camera_fit(low, high, -1.0, 0.7, (double)WIDTH / HEIGHT);
}

// The pixel of a place: solve eye + t (forward + u right + v up) = at.
static const unsigned char *pixel_of(const unsigned char *pixels, const view_camera *camera,
                                     const double at[3])
{
    view_frame f = view_camera_frame(camera, (double)WIDTH / HEIGHT);
    double t = 0, u = 0, v = 0, r = 0, w = 0;
    for (int i = 0; i < 3; i++) {
        double d = at[i] - f.eye[i];
        t += d * f.forward[i];
        u += d * f.right[i];
        v += d * f.up[i];
        r += f.right[i] * f.right[i];
        w += f.up[i] * f.up[i];
    }
    int x = (int)((u / (t * r) + 1) / 2 * WIDTH), y = (int)((1 - v / (t * w)) / 2 * HEIGHT);
    CHECK(x >= 0 && x < WIDTH && y >= 0 && y < HEIGHT);
    return pixels + 3 * ((size_t)y * WIDTH + (size_t)x);
}

static void add_square(stage *s, stage_kind kind, double z, double half, const uint8_t rgba[4])
{
    static const float corners[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    stage_vertex v[6];
    float normals[18] = {0};
    for (int i = 0; i < 6; i++) {
        v[i].at_mm[0] = (float)(half * corners[i][0]);
        v[i].at_mm[1] = (float)(half * corners[i][1]);
        v[i].at_mm[2] = (float)z;
        memcpy(v[i].rgba, rgba, 4);
        normals[3 * i + 2] = 3;
    }
    CHECK(stage_add(s, kind, v, kind == STAGE_SMOOTH ? normals : NULL, 6));
}

static void shoot_from(const stage *s, const view_camera *camera, unsigned char *pixels)
{
    const char *why = NULL;
    stage_view *v = stage_view_create(&why);
    CHECK(v != NULL);
    CHECK(stage_view_shot(v, s, camera, WIDTH, HEIGHT, pixels));
    stage_view_destroy(v);
}

static void shoot(const stage *s, unsigned char *pixels)
{
    view_camera camera = from_above();
    shoot_from(s, &camera, pixels);
}

// Redder than blue, or bluer than red, by a number.
static int redness(const unsigned char *p)
{
    return (int)p[0] - (int)p[2];
}

static void nearer_before_farther(void)
{
    const double middle[3] = {0, 0, 5}, below[3] = {8, 0, 0};
    for (int kind = STAGE_SOLID; kind <= STAGE_BARE; kind++) {
        static unsigned char pixels[SIZE];
        view_camera camera = from_above();
        stage *s = stage_create();
        CHECK(s != NULL);
        add_square(s, (stage_kind)kind, 5, 4, red);
        add_square(s, STAGE_SOLID, 0, 10, blue); // later, and behind
        shoot(s, pixels);
        CHECK(redness(pixel_of(pixels, &camera, middle)) > 60);
        CHECK(redness(pixel_of(pixels, &camera, below)) < -60);
        if (kind == STAGE_BARE) {
            CHECK(memcmp(pixel_of(pixels, &camera, middle), red, 3) == 0);
        }
        stage_destroy(s);
    }
}

static void glass_is_seen_through(void)
{
    static unsigned char pixels[SIZE], without[SIZE];
    static const uint8_t glass[4] = {200, 40, 40, 90};
    const double middle[3] = {0, 0, 5}, hidden[3] = {0, 0, -4};
    view_camera camera = from_above();
    stage *s = stage_create();
    CHECK(s != NULL);
    add_square(s, STAGE_SOLID, 0, 10, blue);
    add_square(s, STAGE_GLASS, -4, 2, red); // behind what is solid
    shoot(s, without);
    add_square(s, STAGE_GLASS, 5, 4, glass);
    shoot(s, pixels);
    int before = redness(pixel_of(without, &camera, middle));
    int after = redness(pixel_of(pixels, &camera, middle));
    CHECK(after > before + 20 && after < 100);
    CHECK(redness(pixel_of(without, &camera, hidden)) < -60);
    stage_destroy(s);
}

static void lines_and_points(void)
{
    static unsigned char pixels[SIZE];
    const double on[3] = {0, 0, -3}, off[3] = {0, 4, 0}, at[3] = {-6, 6, -2};
    view_camera camera = from_above();
    stage *s = stage_create();
    CHECK(s != NULL);
    add_square(s, STAGE_SOLID, 0, 10, blue);
    const stage_vertex ends[2] = {{{-9, 0, -3}, {255, 230, 0, 255}},
                                  {{9, 0, -3}, {255, 230, 0, 255}}};
    CHECK(stage_add(s, STAGE_LINE, ends, NULL, 2)); // behind the square
    shoot(s, pixels);
    CHECK(redness(pixel_of(pixels, &camera, on)) < -60);
    CHECK(stage_add(s, STAGE_LINE_OVER, ends, NULL, 2));
    const stage_point point = {{-6, 6, -2}, 5, {0, 200, 0, 255}};
    CHECK(stage_add_point(s, &point));
    shoot(s, pixels);
    CHECK(redness(pixel_of(pixels, &camera, on)) > 60);
    CHECK(redness(pixel_of(pixels, &camera, off)) < -60);
    const unsigned char *p = pixel_of(pixels, &camera, at);
    CHECK(p[1] > 150 && p[0] < 80 && p[2] < 80);
    stage_destroy(s);
}

// Squares with normals of their own: the light falls by these, on either side, and gloss is where a
// mirror would be.
static void light_falls_by_normals(void)
{
    static unsigned char above[SIZE], below[SIZE];
    static const uint8_t black[4] = {0, 0, 0, 255};
    const double first[3] = {-6, 0, 0}, second[3] = {6, 0, 0}, third[3] = {0, 7, 0};
    const double sun[3] = {0.45, -0.55, 0.9};
    view_camera camera = from_above(), under = from_above();
    view_frame f = view_camera_frame(&camera, (double)WIDTH / HEIGHT);
    under.elevation = -0.7;
    stage *s = stage_create();
    CHECK(s != NULL);
    for (int k = 0; k < 3; k++) {
        static const float corners[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
        const double *middle = k == 0 ? first : k == 1 ? second : third;
        double way[3], away = 0, ray = 0;
        for (int i = 0; i < 3; i++) {
            way[i] = middle[i] - f.eye[i];
            ray += way[i] * way[i];
            away += sun[i] * sun[i];
        }
        stage_vertex v[6];
        float normals[18];
        for (int i = 0; i < 6; i++) {
            for (int d = 0; d < 3; d++) {
                double half = sun[d] / sqrt(away) - way[d] / sqrt(ray);
                double side = k == 0   ? (d == 2)
                              : k == 1 ? (d == 0) + 0.1 * (d == 1) - 0.4 * (d == 2)
                                       : half;
                v[i].at_mm[d] = (float)(middle[d] + (d < 2 ? 2 * corners[i][d] : 0));
                normals[3 * i + d] = (float)(3 * side);
            }
            memcpy(v[i].rgba, k == 2 ? black : red, 4);
        }
        CHECK(stage_add(s, STAGE_SMOOTH, v, normals, 6));
    }
    shoot(s, above);
    CHECK(pixel_of(above, &camera, first)[0] > pixel_of(above, &camera, second)[0] + 40);
    CHECK(memcmp(pixel_of(above, &camera, first), red, 3) != 0);
    CHECK(pixel_of(above, &camera, third)[1] > 18 && pixel_of(above, &camera, third)[1] < 40);
    shoot_from(s, &under, below);
    CHECK(pixel_of(below, &under, first)[0] + 40 < pixel_of(above, &camera, first)[0]);
    stage_destroy(s);
}

static int is_yellow(const unsigned char *p)
{
    return p[0] > 150 && p[1] > 130 && p[2] < 110;
}

// A line is some pixels wide, lies over the face that it lies on, and is seen up to the eye.
static void lines_have_a_width(void)
{
    static unsigned char pixels[SIZE];
    const stage_vertex flat[2] = {{{-9, -6, 0}, {255, 230, 0, 255}},
                                  {{9, -6, 0}, {255, 230, 0, 255}}};
    view_camera camera = from_above();
    view_frame f = view_camera_frame(&camera, (double)WIDTH / HEIGHT);
    stage *s = stage_create();
    CHECK(s != NULL);
    add_square(s, STAGE_SOLID, 0, 10, blue);
    CHECK(stage_add(s, STAGE_LINE, flat, NULL, 2));
    shoot(s, pixels);
    const double on[3] = {2, -6, 0};
    size_t at = (size_t)(pixel_of(pixels, &camera, on) - pixels), row = (size_t)3 * WIDTH;
    int wide = 0;
    for (size_t k = 0; k < 13; k++) {
        wide += is_yellow(pixels + at - 6 * row + k * row);
    }
    CHECK(wide >= 1 && wide <= 4);
    // From a place in the picture to far behind the eye.
    stage_clear(s);
    stage_vertex past[2] = {{{0, 0, 0}, {255, 230, 0, 255}}, {{0, 0, 0}, {255, 230, 0, 255}}};
    const double start[3] = {4, 4, 2};
    double middle[3];
    for (int i = 0; i < 3; i++) {
        double behind = f.eye[i] - 30 * f.forward[i] + 20 * f.up[i];
        past[0].at_mm[i] = (float)start[i];
        past[1].at_mm[i] = (float)behind;
        middle[i] = start[i] + 0.1 * (behind - start[i]);
    }
    for (int turned = 0; turned < 2; turned++) {
        const stage_vertex ends[2] = {past[turned], past[1 - turned]};
        stage_clear(s);
        CHECK(stage_add(s, STAGE_LINE_OVER, ends, NULL, 2));
        shoot(s, pixels);
        CHECK(is_yellow(pixel_of(pixels, &camera, middle)));
    }
    stage_destroy(s);
}

static void a_point_is_a_disc(void)
{
    static unsigned char pixels[SIZE];
    const stage_point point = {{0, 0, 0}, 20, {0, 200, 0, 255}};
    const double at[3] = {0, 0, 0};
    view_camera camera = from_above();
    stage *s = stage_create();
    CHECK(s != NULL && stage_add_point(s, &point));
    shoot(s, pixels);
    const unsigned char *p = pixel_of(pixels, &camera, at);
    const unsigned char *corner = p + 3 * 18 + (ptrdiff_t)3 * WIDTH * 18, *inside = p + 3 * 10;
    CHECK(corner[0] > 180 && corner[1] > 180 && corner[2] > 180);
    CHECK(inside[1] > 150 && inside[0] < 60);
    stage_destroy(s);
}

static void the_picture(void)
{
    static unsigned char pixels[SIZE];
    const unsigned char two[6] = {10, 20, 30, 200, 100, 50};
    stage *s = stage_create();
    CHECK(s != NULL);
    CHECK(stage_set_picture(s, two, 2, 1));
    shoot(s, pixels);
    // A third of the width allows 33 pixels each, half the height 80: so 33, at 15 from the corner.
    const unsigned char *row = pixels + (size_t)3 * WIDTH * (15 + 5);
    CHECK(memcmp(row + 3 * (WIDTH - 15 - 66 + 4), two, 3) == 0);
    CHECK(memcmp(row + 3 * (WIDTH - 15 - 4), two + 3, 3) == 0);
    CHECK(row[3 * (WIDTH - 4)] > 150);
    const unsigned char *right = row + 3 * (WIDTH - 15), *left = row + 3 * (WIDTH - 15 - 66 - 1);
    CHECK(right[0] > 25 && right[0] < 60 && left[0] > 25 && left[0] < 60); // its rim
    CHECK(stage_set_picture(s, NULL, 0, 0));
    shoot(s, pixels);
    CHECK(row[3 * (WIDTH - 15 - 4)] > 150 && row[3 * (WIDTH - 15 - 4) + 2] > 150);
    stage_clear(s);
    shoot(s, pixels);
    CHECK(pixels[0] > pixels[SIZE - 3] + 15); // lighter above
    stage_destroy(s);
}

int main(void)
{
    gl_headless *context = NULL;
    if (!gl_begin(&context)) {
        return gl_status;
    }
    TEST(nearer_before_farther);
    TEST(glass_is_seen_through);
    TEST(lines_and_points);
    TEST(light_falls_by_normals);
    TEST(lines_have_a_width);
    TEST(a_point_is_a_disc);
    TEST(the_picture);
    gl_headless_destroy(context);
    return test_finish();
}
