// SPDX-License-Identifier: MIT
// What is seen of a graded solid while its layers go by, from one of three sides.
//
// From the front one looks along y, from the side against x, from the top against z; the picture
// goes across along x, y, x, and up along z, z, y. Nothing but the view is held.

#include "grade_picture.h"

#include <stdlib.h>
#include <string.h>

double grade_picture_bytes(const sf_lattice *lattice)
{
    double x = lattice->nx, y = lattice->ny, z = lattice->nz;
    double most = x * z > y * z ? x * z : y * z;
    most = x * y > most ? x * y : most;
    return most * (3 * sizeof(double) + 1) + GRADE_PICTURE_LAYERS * x * y;
}

static exit_status choose_view(cli_job *job, grade_picture *p)
{
    const cli_options *asked = &job->options;
    const sf_lattice *l = &p->lattice;
    if (asked->given & OPTION_VIEW) {
        if (asked->azimuth_deg == 0 && asked->elevation_deg == 0) {
            p->view = GRADE_SIDE;
        } else if (asked->azimuth_deg == -90 && asked->elevation_deg > 0) {
            p->view = GRADE_TOP;
        } else if (asked->azimuth_deg != -90 || asked->elevation_deg != 0) {
            return job_fail(job, EXIT_USAGE, "--view: 'sf grade' draws front, side or top.");
        }
    }
    uint32_t deep = p->view == GRADE_FRONT ? l->ny : p->view == GRADE_SIDE ? l->nx : l->nz;
    p->slice = asked->given & OPTION_SLICE ? asked->slice : deep / 2;
    if (p->slice >= deep) {
        return job_fail(job, EXIT_USAGE, "--slice %u: there are %u across that view, from 0 to %u.",
                        p->slice, deep, deep - 1);
    }
    p->across = p->view == GRADE_SIDE ? l->ny : l->nx;
    p->up = p->view == GRADE_TOP ? l->ny : l->nz;
    p->pitch_mm[0] = p->view == GRADE_SIDE ? l->pitch_y_mm : l->pitch_x_mm;
    p->pitch_mm[1] = p->view == GRADE_TOP ? l->pitch_y_mm : l->layer_mm;
    return EXIT_GOOD;
}

exit_status grade_picture_begin(cli_job *job, const sf_lattice *lattice, grade_picture *p)
{
    memset(p, 0, sizeof *p);
    p->lattice = *lattice;
    exit_status status = choose_view(job, p);
    if (status != EXIT_GOOD) {
        return status;
    }
    size_t view = (size_t)p->across * p->up, plane = (size_t)lattice->nx * lattice->ny;
    p->front = calloc(view, sizeof *p->front);
    p->depth = calloc(view, sizeof *p->depth);
    p->cut = calloc(view, sizeof *p->cut);
    p->has_cut = calloc(view, 1);
    int good = p->front != NULL && p->depth != NULL && p->cut != NULL && p->has_cut != NULL;
    for (size_t i = 0; good && i < view; i++) {
        p->depth[i] = -1;
    }
    for (uint32_t i = 0; i < GRADE_PICTURE_LAYERS; i++) {
        p->which[i] = (uint32_t)((uint64_t)lattice->nz * (i + 1) / (GRADE_PICTURE_LAYERS + 1));
        p->layers[i] = calloc(plane, 1);
        good = good && p->layers[i] != NULL;
    }
    return good ? EXIT_GOOD
                : job_fail(job, EXIT_RESOURCE, "There is no memory for what the picture shows.");
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

// A solid voxel: where it is in the view, how far away, and in which slice across it.
static void see(grade_picture *p, uint32_t x, uint32_t y, uint32_t k, double value)
{
    const sf_lattice *l = &p->lattice;
    uint32_t u = p->view == GRADE_SIDE ? y : x, v = p->view == GRADE_TOP ? y : k;
    uint32_t slice = p->view == GRADE_FRONT ? y : p->view == GRADE_SIDE ? x : k;
    double depth = p->view == GRADE_FRONT  ? y * l->pitch_y_mm
                   : p->view == GRADE_SIDE ? (l->nx - 1 - x) * l->pitch_x_mm
                                           : (l->nz - 1 - k) * l->layer_mm;
    size_t at = (size_t)v * p->across + u;
    if (p->depth[at] < 0 || depth < p->depth[at]) {
        p->depth[at] = depth;
        p->front[at] = value;
    }
    if (slice == p->slice) {
        p->has_cut[at] = 1;
        p->cut[at] = value;
    }
}

void grade_picture_look(grade_picture *p, uint32_t k, sf_slice solid, const double *values,
                        const uint8_t *ids)
{
    for (uint32_t y = 0; y < solid.height; y++) {
        for (uint32_t x = 0; x < solid.width; x++) {
            if (is_solid(solid, x, y)) {
                see(p, x, y, k, values[(size_t)y * solid.width + x]);
            }
        }
    }
    for (int i = 0; i < GRADE_PICTURE_LAYERS; i++) {
        if (p->which[i] == k) {
            memcpy(p->layers[i], ids, (size_t)solid.width * solid.height);
        }
    }
}
