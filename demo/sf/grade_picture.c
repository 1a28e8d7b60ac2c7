// SPDX-License-Identifier: MIT
// What a graded solid looks like.
//
// Above the surface from the front, shaded by how it bends, and the cut through the middle; both in
// the colours of the property. Below three layers, a quarter, half and three quarters of the way
// up, in the colours of the materials, each voxel as large as whole pixels allow, so that no
// pattern appears that is not there.

#include "grade_picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const colour ink = {40, 40, 40};

double grade_picture_bytes(const sf_lattice *lattice)
{
    const sf_lattice *l = lattice;
    return (double)l->nx * l->nz * (3 * sizeof(double) + 1) +
           (double)GRADE_PICTURE_LAYERS * l->nx * l->ny;
}

int grade_picture_begin(const sf_lattice *lattice, grade_picture *p)
{
    size_t view = (size_t)lattice->nx * lattice->nz, plane = (size_t)lattice->nx * lattice->ny;
    memset(p, 0, sizeof *p);
    p->lattice = *lattice;
    p->front = calloc(view, sizeof *p->front);
    p->depth = calloc(view, sizeof *p->depth);
    p->cut = calloc(view, sizeof *p->cut);
    p->has_cut = calloc(view, 1);
    int good = p->front != NULL && p->depth != NULL && p->cut != NULL && p->has_cut != NULL;
    for (uint32_t i = 0; i < GRADE_PICTURE_LAYERS; i++) {
        p->which[i] = lattice->nz * (i + 1) / (GRADE_PICTURE_LAYERS + 1);
        p->layers[i] = calloc(plane, 1);
        good = good && p->layers[i] != NULL;
    }
    return good;
}

void grade_picture_end(grade_picture *p)
{
    free(p->front);
    free(p->depth);
    free(p->cut);
    free(p->has_cut);
    for (int i = 0; i < GRADE_PICTURE_LAYERS; i++) {
        free(p->layers[i]);
    }
    memset(p, 0, sizeof *p);
}

static int is_solid(sf_slice s, uint32_t x, uint32_t y)
{
    return (int)(s.words[(size_t)y * s.stride + x / 64] >> x % 64 & 1);
}

void grade_picture_look(grade_picture *p, uint32_t k, sf_slice solid, const double *values,
                        const uint8_t *ids)
{
    uint32_t middle = solid.height / 2;
    for (uint32_t x = 0; x < solid.width; x++) {
        size_t at = (size_t)k * solid.width + x;
        p->depth[at] = -1;
        for (uint32_t y = 0; y < solid.height && p->depth[at] < 0; y++) {
            if (is_solid(solid, x, y)) {
                p->depth[at] = y * p->lattice.pitch_y_mm;
                p->front[at] = values[(size_t)y * solid.width + x];
            }
        }
        p->has_cut[at] = (uint8_t)is_solid(solid, x, middle);
        p->cut[at] = values[(size_t)middle * solid.width + x];
    }
    for (int i = 0; i < GRADE_PICTURE_LAYERS; i++) {
        if (p->which[i] == k) {
            memcpy(p->layers[i], ids, (size_t)solid.width * solid.height);
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Colours
// ---------------------------------------------------------------------------------------------

// From dark blue over green to yellow: evenly lighter, and told apart by the colour-blind.
static colour shade(double t, double light)
{
    static const double stops[5][3] = {
        {68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    int i = t >= 1 ? 3 : (int)(4 * t);
    double f = 4 * t - i, c[3];
    for (int j = 0; j < 3; j++) {
        c[j] = light * (stops[i][j] + f * (stops[i + 1][j] - stops[i][j]));
        c[j] = c[j] > 255 ? 255 : c[j];
    }
    colour made = {(uint8_t)c[0], (uint8_t)c[1], (uint8_t)c[2]};
    return made;
}

static void put(canvas *to, int x, int y, colour c)
{
    if (x >= 0 && y >= 0 && (uint32_t)x < to->width && (uint32_t)y < to->height) {
        uint8_t *pixel = to->pixels + 3 * ((size_t)y * to->width + (size_t)x);
        pixel[0] = c.red;
        pixel[1] = c.green;
        pixel[2] = c.blue;
    }
}

// ---------------------------------------------------------------------------------------------
// Panels
// ---------------------------------------------------------------------------------------------

typedef struct panel {
    int x, y, width, height;
} panel;

typedef struct range {
    double low, high;
} range;

static range find_range(const grade_picture *p)
{
    range r = {INFINITY, -INFINITY};
    for (size_t i = 0; i < (size_t)p->lattice.nx * p->lattice.nz; i++) {
        if (p->depth[i] >= 0) {
            r.low = fmin(r.low, p->front[i]);
            r.high = fmax(r.high, p->front[i]);
        }
        if (p->has_cut[i]) {
            r.low = fmin(r.low, p->cut[i]);
            r.high = fmax(r.high, p->cut[i]);
        }
    }
    return r;
}

static double place_in(range r, double value)
{
    return r.high > r.low ? (value - r.low) / (r.high - r.low) : 0.5;
}

// The slopes of the surface at a place, in mm per mm: of the plane that fits the depths around it
// best. Voxels make steps, and over a few of them these even out.
static void find_slopes(const grade_picture *p, uint32_t x, uint32_t k, double *dx, double *dz)
{
    enum { REACH = 5 };
    const sf_lattice *l = &p->lattice;
    double here = p->depth[(size_t)k * l->nx + x], sx = 0, sz = 0, xx = 0, zz = 0;
    for (int j = -REACH; j <= REACH; j++) {
        for (int i = -REACH; i <= REACH; i++) {
            int64_t u = (int64_t)x + i, v = (int64_t)k + j;
            if (u < 0 || v < 0 || u >= l->nx || v >= l->nz ||
                p->depth[(size_t)v * l->nx + (size_t)u] < 0) {
                continue;
            }
            double rise = p->depth[(size_t)v * l->nx + (size_t)u] - here;
            double a = i * l->pitch_x_mm, b = j * l->layer_mm;
            sx += a * rise;
            sz += b * rise;
            xx += a * a;
            zz += b * b;
        }
    }
    *dx = xx > 0 ? sx / xx : 0;
    *dz = zz > 0 ? sz / zz : 0;
}

// How much light falls on the surface at a place: from above left.
static double light_at(const grade_picture *p, uint32_t x, uint32_t k)
{
    double dx, dz;
    find_slopes(p, x, k, &dx, &dz);
    double light = (0.8 + 0.35 * dx + 0.45 * dz) / sqrt(1 + dx * dx + dz * dz) / 0.9;
    return 0.35 + 0.65 * (light < 0 ? 0 : light > 1.1 ? 1.1 : light);
}

// The surface, or the cut, as large as it fits.
static void draw_view(const grade_picture *p, range r, int is_cut, panel where, canvas *to)
{
    const sf_lattice *l = &p->lattice;
    double width = l->nx * l->pitch_x_mm, height = l->nz * l->layer_mm;
    double mm = fmax(width / where.width, height / where.height);
    int left = where.x + (int)((where.width - width / mm) / 2);
    int top = where.y + (int)((where.height - height / mm) / 2);
    for (int j = 0; j < (int)(height / mm); j++) {
        for (int i = 0; i < (int)(width / mm); i++) {
            uint32_t x = (uint32_t)((i + 0.5) * mm / l->pitch_x_mm);
            uint32_t k = l->nz - 1 - (uint32_t)((j + 0.5) * mm / l->layer_mm);
            size_t at = (size_t)k * l->nx + x;
            if (x >= l->nx || k >= l->nz) {
                continue;
            }
            if (is_cut && p->has_cut[at]) {
                put(to, left + i, top + j, shade(place_in(r, p->cut[at]), 1));
            } else if (!is_cut && p->depth[at] >= 0) {
                put(to, left + i, top + j, shade(place_in(r, p->front[at]), light_at(p, x, k)));
            }
        }
    }
}

// A layer, or the middle of it where it does not fit.
static void draw_layer(const grade_picture *p, int which, const materials *m, panel where,
                       canvas *to)
{
    const sf_lattice *l = &p->lattice;
    int across = where.width / (int)l->nx, down = where.height / (int)l->ny;
    int scale = across < down ? across : down;
    scale = scale < 1 ? 1 : scale;
    int left = where.x + (where.width - scale * (int)l->nx) / 2;
    int top = where.y + (where.height - scale * (int)l->ny) / 2;
    for (int j = 0; j < scale * (int)l->ny; j++) {
        for (int i = 0; i < scale * (int)l->nx; i++) {
            uint32_t x = (uint32_t)(i / scale), y = l->ny - 1 - (uint32_t)(j / scale);
            uint8_t id = p->layers[which][(size_t)y * l->nx + x];
            int inside = left + i >= where.x && left + i < where.x + where.width &&
                         top + j >= where.y && top + j < where.y + where.height;
            if (id > 0 && inside) {
                const uint8_t *c = m->table[id - 1].colour;
                colour made = {c[0], c[1], c[2]};
                put(to, left + i, top + j, made);
            }
        }
    }
}

static void draw_bar(range r, const char *name, panel where, int size, canvas *to)
{
    char words[96];
    for (int i = 0; i < where.width; i++) {
        colour c = shade((double)i / where.width, 1);
        canvas_fill(to, where.x + i, where.y, where.x + i + 1, where.y + where.height, c);
    }
    snprintf(words, sizeof words, "%.4g", r.low);
    canvas_text(to, where.x, where.y + where.height + size + 2, size, TEXT_LEFT, ink, words);
    snprintf(words, sizeof words, "%.4g", r.high);
    canvas_text(to, where.x + where.width, where.y + where.height + size + 2, size, TEXT_CENTRE,
                ink, words);
    canvas_text(to, where.x + where.width / 2, where.y + where.height + size + 2, size, TEXT_CENTRE,
                ink, name);
}

// In a row about x: a letter is about half as wide as high.
static void draw_swatches(const materials *m, int x, int y, int size, canvas *to)
{
    size_t letters = 0;
    for (uint32_t i = 0; i < m->count; i++) {
        letters += strlen(m->table[i].name);
    }
    x -= (int)((double)(letters + 4 * m->count) * 0.28 * size);
    for (uint32_t i = 0; i < m->count; i++) {
        const uint8_t *c = m->table[i].colour;
        colour made = {c[0], c[1], c[2]};
        canvas_fill(to, x, y - size + 2, x + size, y + 2, made);
        x += size + 6;
        x += canvas_text(to, x, y, size, TEXT_LEFT, ink, m->table[i].name) + size;
    }
}

exit_status grade_picture_draw(cli_job *job, const grade_picture *p, const materials *m, canvas *to)
{
    const int width = (int)job->options.pixels[0], height = (int)job->options.pixels[1];
    const int margin = width / 60, size = height / 50 < 11 ? 11 : height / 50;
    const int upper = (height - 10 * size) / 2, lower = height - upper - 10 * size;
    range r = find_range(p);
    if (!canvas_create(to, (uint32_t)width, (uint32_t)height)) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the picture.");
    }
    panel surface = {margin, margin, width / 2 - 2 * margin, upper - margin};
    panel cut = {width / 2 + margin, margin, width / 2 - 2 * margin, upper - margin};
    panel bar = {width / 4, upper + 2 * size, width / 2, size};
    draw_view(p, r, 0, surface, to);
    draw_view(p, r, 1, cut, to);
    canvas_text(to, width / 4, upper + size + 2, size, TEXT_CENTRE, ink, "surface, from the front");
    canvas_text(to, 3 * width / 4, upper + size + 2, size, TEXT_CENTRE, ink,
                "cut through the middle");
    draw_bar(r, m->properties[0], bar, size, to);
    for (int i = 0; i < GRADE_PICTURE_LAYERS; i++) {
        char words[48];
        panel where = {width * i / 3 + margin / 2, upper + 8 * size, width / 3 - margin, lower};
        draw_layer(p, i, m, where, to);
        snprintf(words, sizeof words, "layer %u", p->which[i]);
        canvas_text(to, width * i / 3 + width / 6, height - size - 4, size, TEXT_CENTRE, ink,
                    words);
    }
    draw_swatches(m, width / 2, upper + 6 * size + size / 2, size, to);
    return EXIT_GOOD;
}
