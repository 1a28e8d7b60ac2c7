// SPDX-License-Identifier: MIT
// What is drawn is what is there: the silhouette of a scene in the picture is that of rays walked
// on the processor, pixel by pixel; a model that was copied in pieces is drawn as one that was
// copied whole; any size can be drawn, and nothing is said by OpenGL's debugging while it is.

#include "twin.h"

#include <epoxy/gl.h>

#include "sculpted.h"
#include "view/pick.h"
#include "view/upload.h"
#include "view/view.h"

enum { WIDTH = 160, HEIGHT = 120, SIZE = 3 * WIDTH * HEIGHT };

static long messages;

static void GLAPIENTRY listen(GLenum source, GLenum type, GLuint id, GLenum severity,
                              GLsizei length, const GLchar *text, const void *user)
{
    (void)source, (void)id, (void)length, (void)user;
    if (severity != GL_DEBUG_SEVERITY_NOTIFICATION && type != GL_DEBUG_TYPE_PERFORMANCE) {
        messages++;
        printf("# %s\n", text);
    }
}

static sf_sculpt *make_model(void)
{
    sf_session *session = NULL;
    sf_sculpt *model = NULL;
    CHECK(sculpted_session("shaun", 96, NULL, &session) == SF_OK);
    CHECK(sf_session_replay(session, NULL, NULL, &model) == SF_OK);
    sf_session_destroy(session);
    return model;
}

static view_camera camera_of(const sf_sculpt *model, double azimuth, double elevation)
{
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    const double low[3] = {l.origin_mm[0] + 20, l.origin_mm[1] + 10, 0};
    const double high[3] = {l.origin_mm[0] + 108, l.origin_mm[1] + 108, 62};
    return view_camera_fit(low, high, azimuth, elevation, (double)WIDTH / HEIGHT);
}

static view *look(view_upload *upload, const sf_sculpt *model)
{
    const char *why = NULL;
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    view *v = view_create(&why);
    CHECK(v != NULL);
    gpu_view buffers = view_upload_view(upload);
    view_look_at(v, &buffers, &l, 0);
    return v;
}

static view_upload *copy(const sf_sculpt *model)
{
    const char *why = NULL;
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    view_upload *u = view_upload_create(&l, &why);
    CHECK(u != NULL);
    CHECK(view_upload_copy(u, sf_sculpt_drawn(model), sf_sculpt_printable(model),
                           sf_sculpt_materials(model), NULL));
    return u;
}

// Pixels where the picture differs from that of an empty model are those that the shape covers.
static void draw(view *v, const view_camera *camera, int cut, unsigned char *pixels)
{
    view_overlays o = view_overlays_default();
    o.ground = o.shadows = 0;
    o.is_cut = cut;
    o.cut_axis = 2;
    o.cut_mm = 30;
    CHECK(view_shot(v, camera, &o, WIDTH, HEIGHT, pixels));
}

// How many of a pixel's four rays meet the grid.
static int rays_that_meet(const sf_grid *grid, const view_camera *camera, int x, int y)
{
    view_frame f = view_camera_frame(camera, (double)WIDTH / HEIGHT);
    int meet = 0;
    for (int i = 0; i < 4; i++) {
        double u = (2 * x + i % 2 + 0.5) / WIDTH - 1, v = 1 - (2 * y + i / 2 + 0.5) / HEIGHT;
        double way[3];
        view_hit hit;
        for (int d = 0; d < 3; d++) {
            way[d] = f.forward[d] + u * f.right[d] + v * f.up[d];
        }
        meet += view_pick(grid, f.eye, way, &hit);
    }
    return meet;
}

static void silhouette(void)
{
    static unsigned char pixels[SIZE], nothing[SIZE];
    sf_sculpt *model = make_model();
    view_upload *upload = copy(model);
    view *v = look(upload, model);
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    sf_grid *empty = NULL;
    CHECK(sf_grid_create(&l, NULL, &empty) == SF_OK);
    static const double views[4][2] = {{0.3, 0.4}, {-1.9, 0.05}, {2.4, 1.2}, {0, -0.6}};
    long wrong = 0, covered = 0, rims = 0;
    for (int k = 0; k < 4; k++) {
        view_camera camera = camera_of(model, views[k][0], views[k][1]);
        CHECK(view_upload_copy(upload, empty, empty, NULL, NULL));
        view_changed(v, NULL);
        draw(v, &camera, 0, nothing);
        CHECK(view_upload_copy(upload, sf_sculpt_drawn(model), sf_sculpt_printable(model),
                               sf_sculpt_materials(model), NULL));
        view_changed(v, NULL);
        draw(v, &camera, 0, pixels);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            int meet = rays_that_meet(sf_sculpt_printable(model), &camera, i % WIDTH, i / WIDTH);
            int differs = memcmp(pixels + 3 * i, nothing + 3 * i, 3) != 0;
            covered += meet == 4;
            rims += meet > 0 && meet < 4;
            // Single precision may put a ray on the other side of a rim.
            wrong += (meet == 4 && !differs) || (meet == 0 && differs);
        }
    }
    printf("# %ld pixels covered, %ld on the rim, %ld wrong\n", covered, rims, wrong);
    CHECK(covered > 6000);
    CHECK(wrong <= 8);
    sf_grid_destroy(empty);
    view_destroy(v);
    view_upload_destroy(upload);
    sf_sculpt_destroy(model);
}

// Strokes one after the other, of which only the changed boxes are copied.
static void in_pieces(void)
{
    static unsigned char pieces[SIZE], whole[SIZE];
    sf_session *session = NULL;
    sf_sculpt *model = NULL;
    CHECK(sculpted_session("shaun", 96, NULL, &session) == SF_OK);
    CHECK(sf_session_begin(session, NULL, &model) == SF_OK);
    view_upload *upload = copy(model);
    view *v = look(upload, model);
    for (size_t i = 0; i < sf_session_count(session).steps; i++) {
        sf_sculpt_change c;
        CHECK(sf_session_play(session, i, NULL, model, &c) == SF_OK);
        const sf_box *boxes[3] = {&c.drawn, &c.printable, &c.material};
        for (int b = 0; b < 3; b++) {
            CHECK(view_upload_copy(upload, sf_sculpt_drawn(model), sf_sculpt_printable(model),
                                   sf_sculpt_materials(model), boxes[b]));
            view_changed(v, boxes[b]);
        }
    }
    view_camera camera = camera_of(model, -1, 0.3);
    draw(v, &camera, 0, pieces);
    view_upload *other = copy(model);
    view *fresh = look(other, model);
    draw(fresh, &camera, 0, whole);
    CHECK(memcmp(pieces, whole, SIZE) == 0);
    draw(fresh, &camera, 1, whole); // cut, it is another
    CHECK(memcmp(pieces, whole, SIZE) != 0);
    view_destroy(v);
    view_destroy(fresh);
    view_upload_destroy(upload);
    view_upload_destroy(other);
    sf_sculpt_destroy(model);
    sf_session_destroy(session);
}

static void sizes(void)
{
    static const uint32_t sides[5][2] = {{1, 1}, {0, 50}, {3, 700}, {640, 1}, {64, 64}};
    sf_sculpt *model = make_model();
    view_upload *upload = copy(model);
    view *v = look(upload, model);
    view_overlays o = view_overlays_default();
    view_camera camera = camera_of(model, 1, 0.2);
    unsigned char *pixels = malloc(640 * 700 * 3);
    o.has_cursor = o.has_plane = o.overhangs = 1;
    o.reach[0] = o.reach[1] = o.reach[2] = 4;
    for (int i = 0; i < 5; i++) {
        for (int box = 0; box < 2; box++) {
            o.is_box = box;
            CHECK(sides[i][0] == 0 ? view_draw(v, &camera, &o, 0, 0, sides[i][1])
                                   : view_shot(v, &camera, &o, sides[i][0], sides[i][1], pixels));
        }
    }
    free(pixels);
    view_destroy(v);
    view_upload_destroy(upload);
    sf_sculpt_destroy(model);
}

// A ray and the voxel that it meets, by hand.
static void picking(void)
{
    sf_lattice l = {10, 8, 6, 0.5, 0.5, 0.25, NULL, {-1, 2, 0}};
    sf_grid *grid = NULL;
    view_hit hit;
    const double from[3] = {1.2, 3.1, 9}, down[3] = {0, 0, -2}, up[3] = {0, 0, 1};
    const double side[3] = {-9, 3.1, 0.6}, along[3] = {1, 0, 0};
    CHECK(sf_grid_create(&l, NULL, &grid) == SF_OK);
    CHECK(!view_pick(grid, from, down, &hit));
    CHECK(sf_slice_set(sf_grid_slice(grid, 2), 4, 2, 1) == SF_OK);
    CHECK(view_pick(grid, from, down, &hit));
    CHECK_EQ(hit.x, 4);
    CHECK_EQ(hit.y, 2);
    CHECK_EQ(hit.z, 2);
    CHECK(hit.axis == 2 && hit.is_high);
    CHECK_NEAR(hit.at_mm[2], 0.75, 1e-12);
    CHECK_NEAR(hit.distance, (9 - 0.75) / 2, 1e-12);
    CHECK(!view_pick(grid, from, up, &hit));
    CHECK(view_pick(grid, side, along, &hit));
    CHECK(hit.axis == 0 && !hit.is_high);
    CHECK_NEAR(hit.at_mm[0], 1, 1e-12);
    sf_grid_destroy(grid);
}

static void camera_moves(void)
{
    const double low[3] = {0, 0, 0}, high[3] = {10, 20, 30};
    view_camera c = view_camera_fit(low, high, 0.5, 9, 1.5); // the elevation stops at the pole
    CHECK(c.elevation < 1.5708);
    view_camera_orbit(&c, 0.25, -0.5);
    CHECK_NEAR(c.azimuth, 0.75, 1e-12);
    double before = c.distance;
    view_camera_zoom(&c, 0.5);
    CHECK_NEAR(c.distance, 0.5 * before, 1e-12);
    view_frame f = view_camera_frame(&c, 1.5);
    double target[3] = {c.target[0], c.target[1], c.target[2]};
    view_camera_pan(&c, 1, 0, 1.5); // what lay in the middle lies on the right rim
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(target[i] - c.target[i], c.distance * f.right[i], 1e-9);
    }
}

static void quiet(void)
{
    CHECK_EQ(messages, 0);
}

int main(void)
{
    gl_headless *context = NULL;
    if (!gl_begin(&context)) {
        return gl_status;
    }
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(listen, NULL);
    TEST(silhouette);
    TEST(in_pieces);
    TEST(sizes);
    TEST(picking);
    TEST(camera_moves);
    TEST(quiet);
    gl_headless_destroy(context);
    return test_finish();
}
