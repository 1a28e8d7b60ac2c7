// SPDX-License-Identifier: MIT
// A graded solid as a 3MF file: the surface, the materials, and what is mixed where.
//
// Nothing is halftoned: that is for whoever prints the file, on a printer of his own. Fractions and
// properties are pictures of 16 bits a voxel. What lies between the centres of voxels is
// interpolated, so voxels outside of the solid are given what the nearest in their row has, or in
// the nearest row: the surface would else take from a value that means nothing.

#include "graded_package.h"

#include "output.h"
#include "package.h"
#include "progress.h"

#include <sf/threemf.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FIELDS_MAX = MATERIALS_MAX + MATERIALS_PROPERTIES_MAX };

typedef struct filler {
    press *p;
    size_t count;
    sf_threemf_field fields[FIELDS_MAX];
    const double *from[FIELDS_MAX];
} filler;

static uint16_t level(const sf_threemf_field *f, double value)
{
    double share = (value - f->low) / (f->high - f->low);
    return (uint16_t)floor(fmin(fmax(share, 0), 1) * 65535 + 0.5);
}

static int is_solid(sf_slice s, uint32_t x, uint32_t y)
{
    return (int)(s.words[(size_t)y * s.stride + x / 64] >> x % 64 & 1);
}

// The nearest solid voxel of a row takes the place of those that are not; 0 where there is none.
static int fill_row(const sf_threemf_field *f, const double *from, sf_slice solid, uint32_t y,
                    uint16_t *row)
{
    uint32_t last = solid.width;
    for (uint32_t x = 0; x < solid.width; x++) {
        if (!is_solid(solid, x, y)) {
            continue;
        }
        row[x] = level(f, from[x]);
        uint32_t begin = last == solid.width ? 0 : last + 1;
        for (uint32_t i = begin; i < x; i++) {
            row[i] = last == solid.width || 2 * i > last + x ? row[x] : row[last];
        }
        last = x;
    }
    for (uint32_t i = last; i < solid.width; i++) {
        row[i] = row[last];
    }
    return last < solid.width;
}

static void fill_plane(const sf_threemf_field *f, const double *from, sf_slice solid,
                       uint16_t *plane)
{
    size_t width = solid.width;
    uint32_t last = solid.height;
    for (uint32_t y = 0; y < solid.height; y++) {
        if (!fill_row(f, from + y * width, solid, y, plane + y * width)) {
            continue;
        }
        uint32_t begin = last == solid.height ? 0 : last + 1;
        for (uint32_t i = begin; i < y; i++) {
            uint32_t near = last == solid.height || 2 * i > last + y ? y : last;
            memcpy(plane + i * width, plane + near * width, width * sizeof *plane);
        }
        last = y;
    }
    for (uint32_t i = last + 1; i < solid.height; i++) {
        memcpy(plane + i * width, plane + last * width, width * sizeof *plane);
    }
}

static sf_status fill_layer(void *user, uint32_t k, uint16_t *const *planes)
{
    filler *fill = user;
    sf_slice solid = sf_grid_slice(fill->p->grid, 0);
    sf_status status = sf_sampler_slice(fill->p->sampler, k, solid, fill->p->values);
    if (status == SF_OK) {
        press_mix(fill->p, solid);
        for (size_t i = 0; i < fill->count; i++) {
            fill_plane(&fill->fields[i], fill->from[i], solid, planes[i]);
        }
    }
    return status;
}

// Fractions from 0 to 1, properties from the least to the greatest value that a point has.
static void choose_fields(filler *fill, const solid_input *in, const size_t *channels)
{
    press *p = fill->p;
    const sf_channel *all;
    (void)solids_channels(in, &all);
    for (uint32_t i = 0; i < p->m->count; i++) {
        sf_threemf_field f = {p->m->table[i].name, 0, 1};
        fill->fields[fill->count] = f;
        fill->from[fill->count++] = p->tones[i];
    }
    for (size_t i = 0; i < p->m->property_count; i++) {
        const sf_channel *c = &all[channels[i]];
        sf_threemf_field f = {p->m->properties[i], c->values[0], c->values[0]};
        for (size_t k = 0; k < c->value_count; k++) {
            f.low = fmin(f.low, c->values[k]);
            f.high = fmax(f.high, c->values[k]);
        }
        f.high = f.high > f.low ? f.high : f.low + fmax(1, fabs(f.low));
        fill->fields[fill->count] = f;
        fill->from[fill->count++] = p->values[i];
    }
}

static sf_status write_file(filler *fill, sf_save *save, sf_fault *fault)
{
    press *p = fill->p;
    sf_threemf_colour colours[MATERIALS_MAX];
    for (uint32_t i = 0; i < p->m->count; i++) {
        const uint8_t *rgb = p->m->table[i].colour;
        sf_threemf_colour c = {p->m->table[i].name, {rgb[0], rgb[1], rgb[2], 255}, 0};
        colours[i] = c;
    }
    sf_threemf_object object = {
        "graded solid", SF_THREEMF_MODEL, sf_sampler_surface(p->sampler, NULL),
        NULL,           SF_THREEMF_NONE,  0};
    sf_threemf_item item = {0, {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}}};
    sf_threemf_view view = {colours, p->m->count, &object, 1, &item, 1, 0};
    sf_threemf_volume volume = {0, p->made->lattice, fill->count, fill->fields,
                                0, fill_layer,       fill};
    sf_threemf_extras extras = sf_threemf_extras_default();
    extras.volume = &volume;
    return sf_threemf_write(&view, &extras, sf_save_sink(save), NULL, &p->job->task, fault);
}

static exit_status save_file(filler *fill, const char *path)
{
    cli_job *job = fill->p->job;
    sf_save *save = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_save_begin(path, NULL, &save, &fault);
    progress_phase("grading");
    if (status == SF_OK) {
        status = write_file(fill, save, &fault);
    }
    exit_status done = status == SF_OK ? press_look_for_solid(fill->p)
                                       : job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
    if (done != EXIT_GOOD) {
        sf_save_abort(save);
        return done;
    }
    status = sf_save_commit(save, &fault);
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
}

exit_status graded_package(press *p, const solid_input *in, const size_t *channels,
                           const char *path)
{
    filler fill;
    memset(&fill, 0, sizeof fill);
    fill.p = p;
    exit_status status = press_shape(p, in, channels);
    if (status != EXIT_GOOD) {
        return status;
    }
    if (!press_planes(p)) {
        return job_fail(p->job, EXIT_RESOURCE, "There is no memory for a layer.");
    }
    choose_fields(&fill, in, channels);
    return save_file(&fill, path);
}
