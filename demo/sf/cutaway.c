// SPDX-License-Identifier: MIT
// A picture of a hollow part, cut open.
//
// The cut goes along x or y, whichever is the more across to the camera, through the layer or row
// where the cavity is largest, so that there is something to see. What stays of the inside has a
// colour of its own.

#include "cutaway.h"

#include "legend.h"
#include "picture.h"

#include <math.h>
#include <string.h>

// Voxels of the cavity in each plane across an axis: the plane with the most of them.
static uint32_t widest_plane(const sf_grid *carved, int along_x)
{
    sf_lattice l = sf_grid_lattice(carved);
    uint32_t best = 0;
    uint64_t most = 0;
    for (uint32_t i = 0; i < (along_x ? l.nx : l.ny); i++) {
        uint64_t count = 0;
        for (uint32_t k = 0; k < l.nz; k++) {
            sf_slice slice = sf_grid_slice(carved, k);
            for (uint32_t j = 0; j < (along_x ? l.ny : l.nx); j++) {
                count += (uint64_t)sf_slice_get(slice, along_x ? i : j, along_x ? j : i);
            }
        }
        best = count > most ? i : best;
        most = count > most ? count : most;
    }
    return best;
}

// Empty what lies in front of the cut. The camera looks from the side that its azimuth names.
static sf_status cut(sf_grid *grid, const sf_grid *carved, double azimuth_deg)
{
    const double degree = 3.14159265358979323846 / 180;
    sf_lattice l = sf_grid_lattice(grid);
    double x = cos(azimuth_deg * degree), y = sin(azimuth_deg * degree);
    int along_x = fabs(x) > fabs(y);
    uint32_t at = widest_plane(carved, along_x);
    sf_rect front = {0, 0, l.nx, l.ny};
    if (along_x) {
        *(x > 0 ? &front.x0 : &front.x1) = x > 0 ? at + 1 : at;
    } else {
        *(y > 0 ? &front.y0 : &front.y1) = y > 0 ? at + 1 : at;
    }
    sf_status status = SF_OK;
    for (uint32_t k = 0; status == SF_OK && k < l.nz; k++) {
        status = sf_slice_fill(sf_grid_slice(grid, k), front, 0);
    }
    return status;
}

exit_status cutaway_draw(cli_job *job, const part *p, const cavity *c, canvas *picture,
                         double *bar_mm)
{
    const uint32_t *size = job->options.pixels;
    const swatch colours[] = {{picture_matter, "wall"}, {picture_added, "left inside"}};
    frame where = {0, 0, size[0], size[1] - legend_height(size[1]), 3};
    subject what = {NULL, c->wall, picture_added, sf_grid_bounds(p->grid)};
    sf_grid *half = NULL;
    double pixel_mm;
    sf_status status = sf_grid_clone(c->done.after, NULL, &half);
    if (status == SF_OK) {
        status = cut(half, c->carved, job->options.azimuth_deg);
    }
    what.shape = half;
    exit_status drawn = EXIT_GOOD;
    if (status != SF_OK || !canvas_create(picture, size[0], size[1])) {
        drawn = job_fail(job, EXIT_RESOURCE, "There is no memory for the picture.");
    }
    if (drawn == EXIT_GOOD) {
        drawn = picture_paint(job, &what, picture, where, &pixel_mm);
    }
    if (drawn == EXIT_GOOD) {
        *bar_mm = legend_draw(picture, pixel_mm, 0.25 * size[0], colours, 2);
    }
    sf_grid_destroy(half);
    return drawn;
}
