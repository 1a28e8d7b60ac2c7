// SPDX-License-Identifier: MIT
// Why: docs/balance.md shows what each term of standing is for; this draws it, and as a test sees
// that it can be drawn anew. Five shapes side by side and to one scale, below them cut open
// along the plane in which they lean: as given, and made to stand with all terms, without carving,
// without the Laplacian term, without both.
//
//     usage: truth-terms_picture FILE.png

#include "balls.h"
#include "legend.h"
#include "picture.h"
#include "terms.h"

enum { PANEL_WIDTH = 300, PANEL_HEIGHT = 290, CAPTION = 108, STRIP = 48, TITLE = 27, FIGURES = 21 };
enum { PANELS = TERMS_WAYS, LINES = 2, FINE = 240 };

static const double cut_colour[3] = {0.42, 0.72, 1.00};
static const colour ink = {40, 44, 50};

typedef struct scene {
    sf_grid *whole[PANELS], *carved[PANELS]; // without and with the cavity
    char lines[PANELS][LINES][64];
    sf_box framed;
} scene;

static void add(sf_mesh *to, sf_mesh_view mesh)
{
    uint32_t first = (uint32_t)sf_mesh_get_view(to).vertex_count;
    CHECK_EQ(sf_mesh_add_vertices(to, mesh.vertices, mesh.vertex_count), SF_OK);
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        const uint32_t *c = mesh.triangles + 3 * t;
        const uint32_t moved[3] = {first + c[0], first + c[1], first + c[2]};
        CHECK_EQ(sf_mesh_add_triangles(to, moved, 1), SF_OK);
    }
}

// Voxels of what a surface and its cavity bound, on a lattice that holds every result.
static sf_grid *voxels(const standing_model *m, sf_mesh_view outer, sf_mesh_view cavity)
{
    standing_model whole = *m;
    double room = 0.2 * m->size;
    sf_grid *made;
    CHECK_EQ(sf_mesh_create(NULL, &whole.mesh), SF_OK);
    add(whole.mesh, outer);
    add(whole.mesh, cavity);
    for (int d = 0; d < 3; d++) {
        whole.low[d] -= room;
        whole.high[d] += room;
    }
    made = standing_voxels(&whole, m->size / FINE);
    sf_mesh_destroy(whole.mesh);
    return made;
}

// Takes away what lies in front of the plane y = 0; in `rest` the face that then shows is away too.
static void cut(sf_grid *half, sf_grid *rest)
{
    sf_lattice l = sf_grid_lattice(half);
    uint32_t at = (uint32_t)floor(-l.origin_mm[1] / l.pitch_y_mm + 0.5);
    sf_rect front = {0, 0, l.nx, at}, more = {0, 0, l.nx, at + 1};
    for (uint32_t k = 0; k < l.nz; k++) {
        CHECK_EQ(sf_slice_fill(sf_grid_slice(half, k), front, 0), SF_OK);
        CHECK_EQ(sf_slice_fill(sf_grid_slice(rest, k), more, 0), SF_OK);
    }
}

static void take_in(scene *s, int panel)
{
    sf_box b = sf_grid_bounds(s->whole[panel]), *f = &s->framed;
    if (panel == 0) {
        *f = b;
    }
    f->x0 = b.x0 < f->x0 ? b.x0 : f->x0;
    f->y0 = b.y0 < f->y0 ? b.y0 : f->y0;
    f->z0 = b.z0 < f->z0 ? b.z0 : f->z0;
    f->x1 = b.x1 > f->x1 ? b.x1 : f->x1;
    f->y1 = b.y1 > f->y1 ? b.y1 : f->y1;
    f->z1 = b.z1 > f->z1 ? b.z1 : f->z1;
}

// The first panel is the shape as it was given, which falls.
static void make_panel(const standing_model *m, int panel, scene *s)
{
    static const terms_costs costs = {"", SF_STAND_PROGRAMS, 0.3, 0.05};
    sf_stance_options stance = balls_stance();
    const sf_mesh_view none = {NULL, 0, NULL, 0};
    sf_handle handles[BALLS];
    size_t count = balls_handles(handles);
    terms_result r = terms_run(m, &stance, handles, count, &costs, panel);
    s->whole[panel] = voxels(m, sf_stand_outer(r.stand), none);
    s->carved[panel] =
        voxels(m, sf_stand_outer(r.stand), panel == TERMS_ALONE ? none : sf_stand_cavity(r.stand));
    take_in(s, panel);
    if (panel == TERMS_ALONE) {
        snprintf(s->lines[panel][0], sizeof s->lines[panel][0], "solid, it falls:");
        snprintf(s->lines[panel][1], sizeof s->lines[panel][1], "margin \xe2\x88\x92%.1f\xc2\xb0",
                 -r.report.margin_before_rad / STANDING_DEGREE);
    } else {
        snprintf(s->lines[panel][0], sizeof s->lines[panel][0], "shape lost %.1f %%",
                 100 * r.all.shape);
        snprintf(s->lines[panel][1], sizeof s->lines[panel][1], "sizes changed %.1f %%",
                 100 * r.all.size);
    }
    sf_stand_destroy(r.stand);
}

static void write_caption(canvas *picture, const scene *s, int panel)
{
    static const colour pale = {214, 217, 222};
    int left = panel * PANEL_WIDTH, middle = left + PANEL_WIDTH / 2;
    canvas_text(picture, middle, 40, TITLE, TEXT_CENTRE, ink,
                panel == TERMS_ALONE ? "as given" : terms_names[panel]);
    for (int i = 0; i < LINES; i++) {
        canvas_text(picture, middle, 70 + 26 * i, FIGURES, TEXT_CENTRE, ink, s->lines[panel][i]);
    }
    if (panel > 0) {
        canvas_fill(picture, left, 20, left + 1, CAPTION + 2 * PANEL_HEIGHT, pale);
    }
}

static sf_status write_bytes(void *user, const void *data, size_t size)
{
    return fwrite(data, 1, size, user) == size ? SF_OK : SF_ERR_IO;
}

static void save(const canvas *picture, const char *path)
{
    FILE *file = fopen(path, "wb");
    CHECK(file != NULL);
    if (file != NULL) {
        sf_sink sink = {write_bytes, file};
        CHECK_EQ(sf_png_write_rgb(picture->pixels, picture->width, picture->height, sink), SF_OK);
        CHECK_EQ(fclose(file), 0);
    }
}

// Whole above, cut open below.
static void draw_panel(cli_job *job, const scene *s, int panel, canvas *picture, double *pixel_mm)
{
    frame where = {(uint32_t)panel * PANEL_WIDTH, CAPTION, PANEL_WIDTH, PANEL_HEIGHT, 3};
    subject whole = {s->whole[panel], s->whole[panel], cut_colour, s->framed};
    sf_grid *half = NULL, *rest = NULL;
    CHECK_EQ(picture_paint(job, &whole, picture, where, pixel_mm), EXIT_GOOD);
    CHECK_EQ(sf_grid_clone(s->carved[panel], NULL, &half), SF_OK);
    CHECK_EQ(sf_grid_clone(s->carved[panel], NULL, &rest), SF_OK);
    cut(half, rest);
    subject open = {half, rest, cut_colour, s->framed};
    where.y += PANEL_HEIGHT;
    CHECK_EQ(picture_paint(job, &open, picture, where, pixel_mm), EXIT_GOOD);
    sf_grid_destroy(half);
    sf_grid_destroy(rest);
}

static void draw(const scene *s, canvas *picture)
{
    const swatch colours[] = {{picture_matter, "surface"}, {cut_colour, "cut open"}};
    double pixel_mm = 1;
    cli_job job;
    memset(&job, 0, sizeof job);
    job.options.azimuth_deg = -90;
    job.options.elevation_deg = 8;
    for (int i = 0; i < PANELS; i++) {
        draw_panel(&job, s, i, picture, &pixel_mm);
        write_caption(picture, s, i);
    }
    legend_draw(picture, pixel_mm, 0.5 * PANEL_WIDTH, colours, 2);
}

static const char *path_to_write;

static void five_shapes_are_drawn(void)
{
    scene s;
    canvas picture;
    if (!sf_stack_has_png()) {
        SKIP("this build has no PNG");
    }
    memset(&s, 0, sizeof s);
    standing_model m = balls_make();
    CHECK(canvas_create(&picture, PANELS * PANEL_WIDTH, CAPTION + 2 * PANEL_HEIGHT + STRIP));
    for (int i = 0; i < PANELS; i++) {
        make_panel(&m, i, &s);
    }
    draw(&s, &picture);
    save(&picture, path_to_write);
    for (int i = 0; i < PANELS; i++) {
        sf_grid_destroy(s.whole[i]);
        sf_grid_destroy(s.carved[i]);
    }
    canvas_destroy(&picture);
    sf_mesh_destroy(m.mesh);
}

int main(int count, char **words)
{
    if (count != 2) {
        fprintf(stderr, "usage: %s FILE.png\n", words[0]);
        return 2;
    }
    path_to_write = words[1];
    TEST(five_shapes_are_drawn);
    return test_finish();
}
