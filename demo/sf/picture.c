// SPDX-License-Identifier: MIT
// A picture of a shape: what prints, what does not, and how large it is.
//
// Four or nine rays a pixel, each marched to the first voxel, shaded by its smoothed normal,
// darkened in cracks, and marched once more for a shadow, each towards another point of a round
// lamp, which makes the rims of shadows soft. Seen from above, the shape stands on a bed with lines
// at round distances; seen from below there is no bed, because it would hide what one wants to see.
// Bands of rows are drawn side by side, each from left to right, so that the rays that meet a voxel
// come close after each other and its surroundings are looked at once; no pixel depends on another.

#include "picture.h"

#include "camera.h"
#include "legend.h"
#include "place.h"
#include "progress.h"
#include "volume.h"

#include <math.h>
#include <string.h>

enum { RAYS_MAX = 9, BAND = 4, BANDS = 8, SEEN = 64 };
#define LAMP 0.045      // radius of the lamp over its distance
#define BED_MARGIN 0.08 // of the longer side, all around

const double picture_matter[3] = {0.80, 0.84, 0.88};
const double picture_lost[3] = {0.93, 0.33, 0.16};
const double picture_added[3] = {0.16, 0.56, 1.00};
static const double bed_colour[3] = {0.95, 0.955, 0.96};
static const double line_colour[3] = {0.84, 0.85, 0.87};

typedef struct view {
    volume volume;
    const subject *what;
    camera camera;
    double light[3];          // unit vector towards the middle of the lamp
    double lamp[RAYS_MAX][3]; // and towards one of its points for each ray
    double bed_mm;            // height of the bed; drawn where has_bed
    double bed_low[2], bed_high[2];
    double line_mm; // distance of the lines on the bed
    int has_bed;
    canvas *picture;
    frame where;
    uint32_t first_row; // of `where`
} view;

// ---------------------------------------------------------------------------------------------
// Light
// ---------------------------------------------------------------------------------------------

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static int in_shadow(const view *w, const double at[3], int ray)
{
    hit blocked;
    return volume_march(&w->volume, at, w->lamp[ray], &blocked);
}

// Rays that are close to each other meet the same voxels; `seen` remembers some of those met last,
// each in a place that goes by where it is.
static void look_around(const view *w, hit *h, hit *seen)
{
    hit *known = &seen[(h->x + 3 * h->y + 23 * h->z) % SEEN];
    if (known->openness < 0 || h->x != known->x || h->y != known->y || h->z != known->z) {
        *known = *h;
        volume_look_around(&w->volume, known);
    }
    memcpy(h->normal, known->normal, sizeof h->normal);
    h->openness = known->openness;
}

static void shade_matter(const view *w, const double start[3], int ray, const hit *h, double rgb[3])
{
    double at[3], step = 2.5 * w->volume.lattice.pitch_x_mm;
    for (int i = 0; i < 3; i++) {
        at[i] = start[i] + h->t * w->camera.forward[i] + step * h->normal[i];
    }
    int plain = sf_slice_get(sf_grid_slice(w->what->plain, h->z), h->x, h->y);
    double facing = dot(h->normal, w->light);
    double direct = facing > 0 && !in_shadow(w, at, ray) ? facing : 0;
    // Who looks from below wants to see undersides.
    double ambient = 0.48 + (w->has_bed ? 0.1 : -0.08) * h->normal[2];
    double open = fmin(1, 0.35 + 1.3 * h->openness);
    for (int i = 0; i < 3; i++) {
        rgb[i] = (plain ? picture_matter : w->what->other)[i] * (ambient * open + 0.52 * direct);
    }
}

static int near_line(double along, double line_mm, double half_mm)
{
    return fabs(along - floor(along / line_mm + 0.5) * line_mm) < half_mm;
}

// The bed, where the ray meets it before it meets nothing.
static int shade_bed(const view *w, const double start[3], int ray, double rgb[3])
{
    double t = (w->bed_mm - start[2]) / w->camera.forward[2], at[3];
    for (int i = 0; i < 3; i++) {
        at[i] = start[i] + t * w->camera.forward[i];
    }
    if (at[0] < w->bed_low[0] || at[0] > w->bed_high[0] || at[1] < w->bed_low[1] ||
        at[1] > w->bed_high[1]) {
        return 0;
    }
    double half = 0.7 * w->camera.pixel_mm;
    int line = near_line(at[0], w->line_mm, half) || near_line(at[1], w->line_mm, half);
    double shadow = in_shadow(w, at, ray) ? 0.8 : 1;
    for (int i = 0; i < 3; i++) {
        rgb[i] = shadow * (line ? line_colour : bed_colour)[i];
    }
    return 1;
}

static void shade(const view *w, double x, double y, int ray, hit *seen, double rgb[3])
{
    double start[3];
    hit h;
    camera_start(&w->camera, x, y, start);
    if (volume_march(&w->volume, start, w->camera.forward, &h)) {
        look_around(w, &h, seen);
        shade_matter(w, start, ray, &h, rgb);
    } else if (!w->has_bed || !shade_bed(w, start, ray, rgb)) {
        rgb[0] = rgb[1] = rgb[2] = 1;
    }
}

// ---------------------------------------------------------------------------------------------
// Pixels
// ---------------------------------------------------------------------------------------------

static void draw_pixel(const view *w, uint32_t column, uint32_t row, hit *seen)
{
    double sum[3] = {0, 0, 0}, rgb[3];
    int side = w->where.rays;
    for (int i = 0; i < side * side; i++) {
        double dx = (i % side + 0.5) / side, dy = ((double)(i / side) + 0.5) / side;
        shade(w, column + dx - 0.5 * w->where.width, 0.5 * w->where.height - row - dy, i, seen,
              rgb);
        for (int c = 0; c < 3; c++) {
            sum[c] += fmin(rgb[c], 1);
        }
    }
    size_t at = (size_t)(w->where.y + row) * w->picture->width + w->where.x + column;
    for (int c = 0; c < 3; c++) {
        w->picture->pixels[3 * at + (size_t)c] = (uint8_t)(255 * sum[c] / (side * side) + 0.5);
    }
}

static void draw_band(void *context, size_t index)
{
    const view *w = context;
    hit seen[SEEN];
    uint32_t first = w->first_row + (uint32_t)index * BAND;
    uint32_t end = w->where.height - first < BAND ? w->where.height : first + BAND;
    for (int i = 0; i < SEEN; i++) {
        seen[i].openness = -1;
    }
    for (uint32_t column = 0; column < w->where.width; column++) {
        for (uint32_t row = first; row < end; row++) {
            draw_pixel(w, column, row, seen);
        }
    }
}

static sf_status draw_bands(view *w, sf_task *task)
{
    while (w->first_row < w->where.height) {
        uint32_t left = (w->where.height - w->first_row + BAND - 1) / BAND;
        uint32_t count = left < BANDS ? left : BANDS;
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        if (task->parallel_for != NULL) {
            task->parallel_for(task->user, count, draw_band, w);
        } else {
            for (uint32_t i = 0; i < count; i++) {
                draw_band(w, i);
            }
        }
        w->first_row += count * BAND;
        w->first_row = w->first_row < w->where.height ? w->first_row : w->where.height;
        if (task->progress != NULL) {
            task->progress(task->user, (double)w->first_row / w->where.height);
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Set-up
// ---------------------------------------------------------------------------------------------

static void lay_bed(view *w, const sf_box *bounds, double low[3], double high[3])
{
    double margin = BED_MARGIN * fmax(high[0] - low[0], high[1] - low[1]);
    w->bed_mm = low[2];
    w->has_bed = w->camera.forward[2] < -0.02;
    for (int i = 0; i < 2; i++) {
        low[i] -= margin;
        high[i] += margin;
        w->bed_low[i] = low[i];
        w->bed_high[i] = high[i];
    }
    if (w->has_bed) {
        w->volume.mirror = bounds->z0;
    }
    w->line_mm = legend_round_length(fmax(high[0] - low[0], high[1] - low[1]) / 8);
}

static void normalize(double v[3])
{
    double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

// The lamp's points lie on a spiral that fills a disk evenly (each a golden angle further), and go
// to the rays of a pixel in an order that puts neighbours far apart: a step without a common
// factor.
static void set_light(view *w)
{
    int count = w->where.rays * w->where.rays, far = count == RAYS_MAX ? 4 : 3;
    for (int i = 0; i < 3; i++) {
        w->light[i] =
            -0.5 * w->camera.right[i] + 0.62 * w->camera.up[i] - 0.6 * w->camera.forward[i];
    }
    normalize(w->light);
    for (int k = 0; k < count; k++) {
        double radius = LAMP * sqrt((k + 0.5) / count), turn = 2.39996322972865332 * k;
        double *point = w->lamp[far * k % count];
        for (int i = 0; i < 3; i++) {
            point[i] = w->light[i] + radius * cos(turn) * w->camera.right[i] +
                       radius * sin(turn) * w->camera.up[i];
        }
        normalize(point);
    }
}

static void set_up(view *w, const cli_options *asked)
{
    const sf_box *framed = &w->what->framed;
    double low[3], high[3];
    place_of_box(&w->volume.lattice, framed, low, high);
    w->camera = camera_make(asked->azimuth_deg, asked->elevation_deg, low, high, 1, 1);
    lay_bed(w, framed, low, high);
    w->camera = camera_make(asked->azimuth_deg, asked->elevation_deg, low, high, w->where.width,
                            w->where.height);
    set_light(w);
}

double picture_aspect(const cli_job *job, const sf_lattice *lattice, sf_box framed)
{
    double low[3], high[3];
    place_of_box(lattice, &framed, low, high);
    for (int i = 0; i < 2; i++) {
        double margin = BED_MARGIN * fmax(high[0] - low[0], high[1] - low[1]);
        low[i] -= margin;
        high[i] += margin;
    }
    double tall = 1e6; // one of the two sides decides: where there is room enough for the other
    camera wide =
        camera_make(job->options.azimuth_deg, job->options.elevation_deg, low, high, 1, tall);
    camera high_one =
        camera_make(job->options.azimuth_deg, job->options.elevation_deg, low, high, tall, 1);
    return high_one.pixel_mm / wide.pixel_mm;
}

exit_status picture_paint(cli_job *job, const subject *what, canvas *picture, frame where,
                          double *pixel_mm)
{
    view w;
    memset(&w, 0, sizeof w);
    w.what = what;
    w.picture = picture;
    w.where = where;
    if (!volume_create(&w.volume, what->shape)) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the picture.");
    }
    progress_phase("drawing");
    set_up(&w, &job->options);
    sf_status status = draw_bands(&w, &job->task);
    volume_destroy(&w.volume);
    *pixel_mm = w.camera.pixel_mm;
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, NULL, "the picture", EXIT_RESOURCE);
}

exit_status picture_draw(cli_job *job, const subject *what, canvas *picture, double *bar_mm)
{
    const uint32_t *size = job->options.pixels;
    const swatch colours[] = {{picture_matter, "prints"},
                              {what->other, "cannot print without supports"}};
    frame where = {0, 0, size[0], size[1] - legend_height(size[1]), 3};
    double pixel_mm;
    if (!canvas_create(picture, size[0], size[1])) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the picture.");
    }
    exit_status status = picture_paint(job, what, picture, where, &pixel_mm);
    if (status == EXIT_GOOD) {
        *bar_mm = legend_draw(picture, pixel_mm, 0.25 * size[0], colours,
                              what->shape != what->plain ? 2 : 1);
    }
    return status;
}
