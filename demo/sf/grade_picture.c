// SPDX-License-Identifier: MIT
// What a graded solid looks like.
//
// Above the surface from one side, shaded by how it bends, and a cut across that view; both in the
// colours of the property, with rulers in mm. Below three layers, a quarter, half and three
// quarters of the way up, in the colours of the materials, each voxel as large as whole pixels
// allow, so that no pattern appears that is not there.

#include "grade_picture.h"

#include "ruler.h"
#include "shade.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const colour ink = {40, 40, 40};

// ---------------------------------------------------------------------------------------------
// Colours
// ---------------------------------------------------------------------------------------------

static colour shade(double t, double light)
{
    uint8_t c[3];
    shade_of(t, light, c);
    const colour made = {c[0], c[1], c[2]};
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
    for (size_t i = 0; i < (size_t)p->across * p->up; i++) {
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
static void find_slopes(const grade_picture *p, uint32_t x, uint32_t z, double *dx, double *dz)
{
    enum { REACH = 5 };
    double here = p->depth[(size_t)z * p->across + x], sx = 0, sz = 0, xx = 0, zz = 0;
    for (int j = -REACH; j <= REACH; j++) {
        for (int i = -REACH; i <= REACH; i++) {
            int64_t u = (int64_t)x + i, v = (int64_t)z + j;
            if (u < 0 || v < 0 || u >= p->across || v >= p->up ||
                p->depth[(size_t)v * p->across + (size_t)u] < 0) {
                continue;
            }
            double rise = p->depth[(size_t)v * p->across + (size_t)u] - here;
            double a = i * p->pitch_mm[0], b = j * p->pitch_mm[1];
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

// The surface, or the cut; `mm` is the size of a pixel.
static void draw_view(const grade_picture *p, range r, int is_cut, panel where, double mm,
                      canvas *to)
{
    for (int j = 0; j < where.height; j++) {
        for (int i = 0; i < where.width; i++) {
            uint32_t x = (uint32_t)((i + 0.5) * mm / p->pitch_mm[0]);
            uint32_t z = (uint32_t)((where.height - j - 0.5) * mm / p->pitch_mm[1]);
            size_t at = (size_t)z * p->across + x;
            if (x >= p->across || z >= p->up) {
                continue;
            }
            if (is_cut && p->has_cut[at]) {
                put(to, where.x + i, where.y + j, shade(place_in(r, p->cut[at]), 1));
            } else if (!is_cut && p->depth[at] >= 0) {
                put(to, where.x + i, where.y + j,
                    shade(place_in(r, p->front[at]), light_at(p, x, z)));
            }
        }
    }
}

// How many pixels a voxel of a layer is wide and high.
typedef struct magnified {
    int x, y;
} magnified;

// The largest whole numbers that fit and are as the pitches, or 1 where a layer does not fit.
static magnified magnify(const sf_lattice *l, int width, int height)
{
    double least = fmin(l->pitch_x_mm, l->pitch_y_mm);
    magnified best = {(int)(l->pitch_x_mm / least + 0.5), (int)(l->pitch_y_mm / least + 0.5)};
    for (int n = 2; (double)n * l->nx <= width; n++) {
        magnified next = {(int)(n * l->pitch_x_mm / least + 0.5),
                          (int)(n * l->pitch_y_mm / least + 0.5)};
        if (next.x * (double)l->nx <= width && next.y * (double)l->ny <= height) {
            best = next;
        }
    }
    return best;
}

// A layer, or the middle of it where it does not fit.
static void draw_layer(const grade_picture *p, int which, const materials *m, magnified scale,
                       panel where, canvas *to)
{
    const sf_lattice *l = &p->lattice;
    int left = where.x + (where.width - scale.x * (int)l->nx) / 2;
    int top = where.y + (where.height - scale.y * (int)l->ny) / 2;
    for (int j = 0; j < where.height; j++) {
        for (int i = 0; i < where.width; i++) {
            int x = where.x + i - left, y = where.y + j - top;
            if (x < 0 || y < 0 || x / scale.x >= (int)l->nx || y / scale.y >= (int)l->ny) {
                continue;
            }
            size_t row = l->ny - 1 - (uint32_t)(y / scale.y);
            uint8_t id = p->layers[which][row * l->nx + (uint32_t)(x / scale.x)];
            if (id > 0) {
                const uint8_t *c = m->table[id - 1].colour;
                colour made = {c[0], c[1], c[2]};
                put(to, where.x + i, where.y + j, made);
            }
        }
    }
}

// The colours of the property with numbers below, and its name and unit above.
static void draw_bar(range r, const sf_property *property, int x, int y, int width, int size,
                     canvas *to)
{
    char unit[RULER_UNIT_SIZE], words[SF_PROPERTY_NAME_SIZE + RULER_UNIT_SIZE + 4];
    const char *name = ruler_unit(property, unit);
    snprintf(words, sizeof words, "%s%s%s", property->name, name[0] != '\0' ? ", " : "", name);
    canvas_text(to, x + width / 2, y + size, size, TEXT_CENTRE, ink, words);
    y += size * 3 / 2;
    for (int i = 0; i < width; i++) {
        canvas_fill(to, x + i, y, x + i + 1, y + size, shade((double)i / width, 1));
    }
    ruler numbers = {r.low, r.high, x, width};
    ruler_draw(&numbers, y + size, size, NULL, to);
    if (!(r.high > r.low)) {
        snprintf(words, sizeof words, "%.6g everywhere", r.low);
        canvas_text(to, x + width / 2, y + 5 * size / 2, size, TEXT_CENTRE, ink, words);
    }
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

// ---------------------------------------------------------------------------------------------
// The whole
// ---------------------------------------------------------------------------------------------

// Where things are, in pixels from the top; each block with its words.
typedef struct layout {
    int size, margin; // of text, and around things
    double mm;        // of a pixel of the views
    int view_width, view_height;
    magnified scale; // of layers
    int layer_width, layer_height;
    int views, bar, swatches, layers; // where the blocks begin
} layout;

// Views get no more than a bit over half of what words leave; what is left over goes between.
static layout lay_out(const grade_picture *p, int width, int height)
{
    layout l;
    const double across = p->across * p->pitch_mm[0], up = p->up * p->pitch_mm[1];
    l.size = height / 50 < 11 ? 11 : height / 50;
    l.margin = width / 50;
    int words = 18 * l.size + 2 * l.margin, room = height - words > 40 ? height - words : 40;
    int most = 9 * room / 16;
    l.mm = fmax(across / (width / 2.0 - 2 * l.margin), up / most);
    l.view_width = (int)fmax(1, across / l.mm);
    l.view_height = (int)fmax(1, up / l.mm);
    l.layer_width = width / 3 - 2 * l.margin;
    l.layer_height = room - l.view_height;
    l.scale = magnify(&p->lattice, l.layer_width, l.layer_height);
    l.layer_width = (int)fmin(l.layer_width, l.scale.x * (double)p->lattice.nx);
    l.layer_height = (int)fmin(l.layer_height, l.scale.y * (double)p->lattice.ny);
    int spare = (room - l.view_height - l.layer_height) / 4;
    spare = spare > 0 ? spare : 0;
    l.views = l.margin + spare / 2;
    l.bar = l.views + 2 * l.size + l.view_height + 4 * l.size + spare;
    l.swatches = l.bar + 5 * l.size + spare;
    l.layers = l.swatches + 2 * l.size + spare / 2;
    return l;
}

static void draw_views(const grade_picture *p, const layout *l, range r, int width, canvas *to)
{
    static const char *const names[] = {"front", "side", "top"};
    static const char axes[] = {'y', 'x', 'z'};
    const sf_lattice *at = &p->lattice;
    int way = p->view == GRADE_FRONT ? 1 : p->view == GRADE_SIDE ? 0 : 2;
    double pitch = way == 1 ? at->pitch_y_mm : way == 0 ? at->pitch_x_mm : at->layer_mm;
    for (int is_cut = 0; is_cut < 2; is_cut++) {
        char words[96];
        int middle = width / 4 + is_cut * width / 2;
        panel where = {middle - l->view_width / 2, l->views + 2 * l->size, l->view_width,
                       l->view_height};
        if (is_cut) {
            snprintf(words, sizeof words, "cut at %c = %.4g mm, slice %u", axes[p->view],
                     at->origin_mm[way] + (p->slice + 0.5) * pitch, p->slice);
        } else {
            snprintf(words, sizeof words, "surface, from the %s", names[p->view]);
        }
        canvas_text(to, middle, l->views + l->size, l->size, TEXT_CENTRE, ink, words);
        draw_view(p, r, is_cut, where, l->mm, to);
        ruler mm = {0, l->view_width * l->mm, where.x, where.width};
        ruler_draw(&mm, where.y + where.height + l->size / 2, l->size, "mm", to);
    }
}

static void draw_layers(const grade_picture *p, const layout *l, const materials *m, int width,
                        canvas *to)
{
    for (int i = 0; i < GRADE_PICTURE_LAYERS; i++) {
        char words[64];
        int middle = width * i / 3 + width / 6;
        panel where = {middle - l->layer_width / 2, l->layers + 2 * l->size, l->layer_width,
                       l->layer_height};
        snprintf(words, sizeof words, "layer %u, z = %.4g mm", p->which[i],
                 p->lattice.origin_mm[2] + (p->which[i] + 0.5) * p->lattice.layer_mm);
        canvas_text(to, middle, l->layers + l->size, l->size, TEXT_CENTRE, ink, words);
        draw_layer(p, i, m, l->scale, where, to);
        ruler mm = {0, where.width * p->lattice.pitch_x_mm / l->scale.x, where.x, where.width};
        ruler_draw(&mm, where.y + where.height + l->size / 2, l->size, "mm", to);
    }
}

exit_status grade_picture_draw(cli_job *job, const grade_picture *p, const materials *m,
                               const sf_property *property, canvas *to)
{
    const int width = (int)job->options.pixels[0], height = (int)job->options.pixels[1];
    layout l = lay_out(p, width, height);
    range r = find_range(p);
    if (!canvas_create(to, (uint32_t)width, (uint32_t)height)) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the picture.");
    }
    draw_views(p, &l, r, width, to);
    draw_bar(r, property, width / 4, l.bar, width / 2, l.size, to);
    draw_swatches(m, width / 2, l.swatches + l.size, l.size, to);
    draw_layers(p, &l, m, width, to);
    return EXIT_GOOD;
}
