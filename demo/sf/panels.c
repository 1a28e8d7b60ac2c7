// SPDX-License-Identifier: MIT
// Pictures of several shapes side by side, seen alike, with a caption each.
//
// One frame holds them all, so that a length or a place in one panel is the same in the others, and
// one legend serves them. What was taken away is not drawn: it is what is missing beside the next
// panel, and red in the picture before.

#include "panels.h"

#include "legend.h"
#include "picture.h"

#include <math.h>
#include <string.h>

static const colour ink = {60, 64, 70}, pale = {214, 217, 222};

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static uint32_t most(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

// The smallest box around both; an empty one (all zero) counts for nothing.
static sf_box join(sf_box a, sf_box b)
{
    if (a.z1 == a.z0 || b.z1 == b.z0) {
        return a.z1 == a.z0 ? b : a;
    }
    sf_box both = {least(a.x0, b.x0), least(a.y0, b.y0), least(a.z0, b.z0),
                   most(a.x1, b.x1),  most(a.y1, b.y1),  most(a.z1, b.z1)};
    return both;
}

// Where things stand, in pixels.
typedef struct layout {
    uint32_t panel_width, panel_height; // of the shape alone
    uint32_t caption_height;
    int title, figures; // sizes of text
} layout;

static layout lay_out(const cli_job *job, const sf_lattice *lattice, sf_box framed)
{
    layout l;
    l.panel_width = job->options.pixels[0] / 2;
    double aspect = fmin(1.5, fmax(0.4, picture_aspect(job, lattice, framed)));
    l.panel_height = (uint32_t)(aspect * l.panel_width);
    l.title = (int)l.panel_width / 18;
    l.figures = (int)l.panel_width / 22;
    l.caption_height = (uint32_t)(3 * l.title + 2 * l.figures);
    return l;
}

static void draw_caption(canvas *picture, const layout *l, const panel *p, uint32_t index)
{
    int middle = (int)(index * l->panel_width + l->panel_width / 2), line = 2 * l->title;
    canvas_text(picture, middle, line, l->title, TEXT_CENTRE, ink, p->title);
    canvas_text(picture, middle, line + l->title / 2 + l->figures, l->figures, TEXT_CENTRE, ink,
                p->figures);
    if (index > 0) {
        int edge = (int)(index * l->panel_width);
        canvas_fill(picture, edge, l->title, edge + 1, (int)(l->caption_height + l->panel_height),
                    pale);
    }
}

exit_status panels_draw(cli_job *job, const sf_grid *before, const panel *panels, uint32_t count,
                        canvas *picture)
{
    const swatch colours[] = {{picture_matter, "as drawn"}, {picture_added, "added"}};
    sf_lattice lattice = sf_grid_lattice(before);
    subject what = {NULL, before, picture_added, sf_grid_bounds(before)};
    double pixel_mm = 1;
    for (uint32_t i = 0; i < count; i++) {
        what.framed = join(what.framed, sf_grid_bounds(panels[i].shape));
    }
    layout l = lay_out(job, &lattice, what.framed);
    uint32_t above = l.caption_height + l.panel_height;
    if (!canvas_create(picture, count * l.panel_width, above + above / 12)) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the picture.");
    }
    exit_status status = EXIT_GOOD;
    for (uint32_t i = 0; i < count && status == EXIT_GOOD; i++) {
        frame where = {i * l.panel_width, l.caption_height, l.panel_width, l.panel_height, 2};
        what.shape = panels[i].shape;
        status = picture_paint(job, &what, picture, where, &pixel_mm);
        draw_caption(picture, &l, &panels[i], i);
    }
    if (status == EXIT_GOOD) {
        legend_draw(picture, pixel_mm, 0.4 * l.panel_width, colours, 2);
    }
    return status;
}
