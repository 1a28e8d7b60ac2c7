// SPDX-License-Identifier: MIT
// What the Grade desk shows: the shape in the colours of the property, cut open where it is asked
// for, the cage over it, and the printed slice beside.

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "grade.h"
#include "shade.h"
#include "view/view.h"

// Points of a larger cage are shown where they are selected or pointed at.
#define POINTS_MOST 3000u

enum { BATCH = 3072, FACE_MOST = 12 }; // vertices, at once and of a face that is cut

static const uint8_t edge_ink[4] = {70, 74, 84, 150}, bad_ink[4] = {208, 50, 40, 255};
static const uint8_t brush_ink[4] = {255, 200, 50, 255}, hovered_ink[4] = {255, 255, 255, 255};

typedef struct filling {
    const grade *g;
    stage *stage;
    int good;
} filling;

static void colour_of(const grade *g, double value, uint8_t rgba[4])
{
    const grade_state *s = &g->state;
    shade_of((value - s->low) / (s->high - s->low), 1, rgba);
    rgba[3] = 255;
}

static void add_line(filling *f, stage_kind kind, const double a[3], const double b[3],
                     const uint8_t ink[4])
{
    stage_vertex ends[2] = {{{(float)a[0], (float)a[1], (float)a[2]}, {0, 0, 0, 0}},
                            {{(float)b[0], (float)b[1], (float)b[2]}, {0, 0, 0, 0}}};
    memcpy(ends[0].rgba, ink, 4);
    memcpy(ends[1].rgba, ink, 4);
    f->good = f->good && stage_add(f->stage, kind, ends, NULL, 2);
}

// ---------------------------------------------------------------------------------------------
// The surface
// ---------------------------------------------------------------------------------------------

typedef struct corner {
    double at[3], normal[3], value;
} corner;

static corner mix(const corner *a, const corner *b, double t)
{
    corner c;
    for (int i = 0; i < 3; i++) {
        c.at[i] = a->at[i] + t * (b->at[i] - a->at[i]);
        c.normal[i] = a->normal[i] + t * (b->normal[i] - a->normal[i]);
    }
    c.value = a->value + t * (b->value - a->value);
    return c;
}

// What of a triangle stays beside the cut: at most four corners.
static int clip(const grade *g, const corner from[3], corner to[4])
{
    int made = 0, axis = g->state.cut_axis;
    double cut = grade_cut_mm(g), side = g->state.keeps_beyond ? -1 : 1;
    for (int i = 0; i < 3; i++) {
        const corner *a = &from[i], *b = &from[(i + 1) % 3];
        double p = side * (cut - a->at[axis]), q = side * (cut - b->at[axis]);
        if (p >= 0) {
            to[made++] = *a;
        }
        if ((p < 0) != (q < 0)) {
            to[made++] = mix(a, b, p / (p - q));
        }
    }
    return made;
}

// Vertices and normals that are collected before they go to the stage.
typedef struct batch {
    stage_vertex vertices[BATCH];
    float normals[3 * BATCH];
    size_t count;
} batch;

static void flush(filling *f, batch *b)
{
    f->good = f->good && stage_add(f->stage, STAGE_SMOOTH, b->vertices, b->normals, b->count);
    b->count = 0;
}

static void put(const grade *g, batch *b, const corner *c)
{
    stage_vertex *v = &b->vertices[b->count];
    for (int i = 0; i < 3; i++) {
        v->at_mm[i] = (float)c->at[i];
        b->normals[3 * b->count + (size_t)i] = (float)c->normal[i];
    }
    colour_of(g, c->value, v->rgba);
    b->count++;
}

// A face is two triangles, as the pointer meets it: cut as one, a saddle would fall into pieces.
static void put_face(const grade *g, batch *b, size_t face)
{
    static const size_t halves[2][3] = {{0, 1, 2}, {0, 2, 3}};
    const grade_surface *s = &g->surface;
    for (int h = 0; h < 2; h++) {
        corner three[3], cut[4];
        for (size_t i = 0; i < 3; i++) {
            size_t place = 4 * face + halves[h][i], at = 3 * (size_t)s->corners[place];
            memcpy(three[i].at, s->points + at, sizeof three[i].at);
            memcpy(three[i].normal, s->normals + at, sizeof three[i].normal);
            three[i].value = s->values[place];
        }
        int count = g->state.is_cut ? clip(g, three, cut) : 3;
        const corner *all = g->state.is_cut ? cut : three;
        for (int i = 2; i < count; i++) {
            put(g, b, &all[0]);
            put(g, b, &all[i - 1]);
            put(g, b, &all[i]);
        }
    }
}

static void add_surface(filling *f)
{
    batch *b = malloc(sizeof *b);
    f->good = f->good && b != NULL;
    if (b != NULL) {
        b->count = 0;
    }
    for (size_t k = 0; f->good && k < f->g->surface.face_count; k++) {
        put_face(f->g, b, k);
        if (b->count + FACE_MOST > BATCH || k + 1 == f->g->surface.face_count) {
            flush(f, b);
        }
    }
    free(b);
}

// ---------------------------------------------------------------------------------------------
// The section
// ---------------------------------------------------------------------------------------------

static stage_vertex section_corner(const grade_section *c, double u, double v)
{
    double at[3];
    at[(c->axis + 1) % 3] = c->origin_mm[0] + u * c->pitch_mm;
    at[(c->axis + 2) % 3] = c->origin_mm[1] + v * c->pitch_mm;
    at[c->axis] = c->at_mm;
    const stage_vertex made = {{(float)at[0], (float)at[1], (float)at[2]}, {0, 0, 0, 255}};
    return made;
}

// Each solid voxel a square.
static void add_section(filling *f)
{
    const grade_section *c = &f->g->section;
    for (uint32_t y = 0; y < c->height && f->good; y++) {
        for (uint32_t x = 0; x < c->width && f->good; x++) {
            size_t i = (size_t)y * c->width + x;
            if (!c->solid[i]) {
                continue;
            }
            static const int order[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
            stage_vertex six[6];
            for (int k = 0; k < 6; k++) {
                six[k] = section_corner(c, (double)x + order[k][0], (double)y + order[k][1]);
                colour_of(f->g, c->values[i], six[k].rgba);
            }
            f->good = stage_add(f->stage, STAGE_BARE, six, NULL, 6);
        }
    }
}

// The slice as a printer has it, upright: of a cut across y x goes to the right and z up.
static void add_print(filling *f)
{
    static const unsigned char nothing[3] = {236, 237, 239};
    static const int order[GRADE_MATERIALS_MAX] = {6, 4, 2, 7}; // dark, light, and between
    const grade_section *c = &f->g->section;
    int is_turned = c->axis == 1;
    size_t voxels = (size_t)c->width * c->height;
    uint32_t width = is_turned ? c->height : c->width, height = is_turned ? c->width : c->height;
    unsigned char *rgb = malloc(3 * voxels + 1);
    f->good = f->good && rgb != NULL;
    for (size_t i = 0; rgb != NULL && i < voxels; i++) {
        size_t x = i % width, up = height - 1 - i / width;
        uint8_t m = c->material[is_turned ? x * c->width + up : up * c->width + x];
        memcpy(rgb + 3 * i, m == 0 ? nothing : view_palette[order[m - 1]], 3);
    }
    if (rgb != NULL && voxels > 0) {
        f->good = f->good && stage_set_picture(f->stage, rgb, width, height);
    }
    free(rgb);
}

// ---------------------------------------------------------------------------------------------
// The cage
// ---------------------------------------------------------------------------------------------

static void add_edge(filling *f, uint32_t a, uint32_t b, const uint8_t ink[4], stage_kind kind)
{
    const double *p = f->g->state.cage.positions;
    add_line(f, kind, p + 3 * (size_t)a, p + 3 * (size_t)b, ink);
}

// The edges of a cell: around its lower polygon, its upper one, and between; of a face around it.
static void add_cell(filling *f, size_t cell, const uint8_t ink[4], stage_kind kind)
{
    const sf_cage_view *v = &f->g->state.cage;
    const uint32_t *c = v->corners + v->starts[cell];
    uint32_t count = v->starts[cell + 1] - v->starts[cell];
    uint32_t n = v->dimension == 2 ? count : count == 4 ? 3 : count / 2;
    for (uint32_t i = 0; i < n; i++) {
        add_edge(f, c[i], c[(i + 1) % n], ink, kind);
        if (v->dimension == 3 && count == 4) {
            add_edge(f, c[i], c[3], ink, kind);
        } else if (v->dimension == 3) {
            add_edge(f, c[n + i], c[n + (i + 1) % n], ink, kind);
            add_edge(f, c[i], c[n + i], ink, kind);
        }
    }
}

static double value_of(const grade *g, size_t point)
{
    const sf_channel *c = &g->state.cage.channels[g->state.channel];
    return c->indices == NULL && point < c->value_count ? c->values[point] : g->state.low;
}

static void add_points(filling *f)
{
    const grade_state *s = &f->g->state;
    int few = s->cage.point_count <= POINTS_MOST;
    for (size_t i = 0; i < s->cage.point_count; i++) {
        int is_selected = s->selected[i] > 0, is_hovered = (int)i == s->hovered;
        const double *at = s->cage.positions + 3 * i;
        stage_point p = {{(float)at[0], (float)at[1], (float)at[2]}, 4, {0, 0, 0, 255}};
        if (!few && !is_selected && !is_hovered) {
            continue;
        }
        p.radius_px = is_selected ? 7.5f : is_hovered ? 6 : 4;
        colour_of(f->g, value_of(f->g, i), p.rgba);
        if (is_hovered) {
            memcpy(p.rgba, hovered_ink, 4);
        }
        f->good = f->good && stage_add_point(f->stage, &p);
    }
}

static void add_brush(filling *f)
{
    const grade_state *s = &f->g->state;
    for (int axis = 0; axis < 3 && s->has_place; axis++) {
        double was[3] = {0, 0, 0};
        for (int i = 0; i <= 48; i++) {
            double angle = i * 6.28318530717958647692 / 48, at[3];
            memcpy(at, s->place_mm, sizeof at);
            at[(axis + 1) % 3] += s->brush.radius_mm * cos(angle);
            at[(axis + 2) % 3] += s->brush.radius_mm * sin(angle);
            if (i > 0) {
                add_line(f, STAGE_LINE, was, at, brush_ink);
            }
            memcpy(was, at, sizeof was);
        }
    }
}

int grade_show(desk *d, stage *s)
{
    filling f = {(const grade *)d, s, 1};
    const grade_state *now = &f.g->state;
    add_surface(&f);
    if (now->is_cut) {
        add_section(&f);
        add_print(&f);
    }
    for (size_t i = 0; i < now->cage.cell_count && now->shows_cage; i++) {
        add_cell(&f, i, edge_ink, STAGE_LINE);
    }
    if (now->inverted_cells > 0) {
        add_cell(&f, now->first_inverted, bad_ink, STAGE_LINE_OVER);
    }
    if (now->shows_cage) {
        add_points(&f);
    }
    if (now->tool == GRADE_BRUSH) {
        add_brush(&f);
    }
    return f.good;
}
