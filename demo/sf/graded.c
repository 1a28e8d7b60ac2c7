// SPDX-License-Identifier: MIT
// Layer by layer: sample, mix, halftone, write.
//
// Nothing larger than a layer is ever held, whatever the size of the solid. The folder appears
// whole or not at all.

#include "graded.h"

#include "graded_package.h"
#include "lattice.h"
#include "output.h"
#include "package.h"
#include "press.h"
#include "progress.h"

#include <sf/io.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double MISS = 1e-9; // of the property's own size: what is rounding

static void free_press(press *p)
{
    for (int i = 0; i < MATERIALS_PROPERTIES_MAX; i++) {
        free(p->values[i]);
    }
    for (int i = 0; i < MATERIALS_MAX; i++) {
        free(p->tones[i]);
    }
    free(p->ids);
    grade_picture_end(&p->picture);
    sf_layers_end(p->layers);
    sf_directory_close(p->directory);
    sf_grid_destroy(p->grid);
    sf_diffuser_destroy(p->diffuser);
    sf_halftone_destroy(p->halftone);
    sf_mask_destroy(p->mask);
    sf_shell_destroy(p->shell);
    sf_sampler_destroy(p->sampler);
    sf_limit_destroy(p->limit);
}

static exit_status fail_call(cli_job *job, sf_status status, const sf_fault *fault)
{
    return job_fail_call(job, status, fault, job->options.input, EXIT_INPUT);
}

// ---------------------------------------------------------------------------------------------
// Setting up
// ---------------------------------------------------------------------------------------------

// The box around what is to be sliced.
static sf_status find_box(press *p, const solid_input *in, double low[3], double high[3])
{
    sf_tets_view v = sf_tets_get_view(in->tets);
    sf_refine_rules rules =
        p->job->options.given & OPTION_SEPARABLE ? SF_REFINE_SEPARABLE : SF_REFINE_STANDARD;
    if (in->cage != NULL) {
        sf_status status = sf_limit_create(in->cage, rules, NULL, &p->job->task, &p->limit);
        progress_phase("measuring the solid");
        return status == SF_OK ? sf_limit_bounds(p->limit, NULL, &p->job->task, low, high) : status;
    }
    for (int i = 0; i < 3; i++) {
        low[i] = INFINITY;
        high[i] = -INFINITY;
    }
    for (size_t i = 0; i < 4 * v.tet_count; i++) { // points that none uses lie anywhere
        for (size_t j = 0; j < 3; j++) {
            double x = v.positions[3 * (size_t)v.corners[i] + j];
            low[j] = fmin(low[j], x);
            high[j] = fmax(high[j], x);
        }
    }
    return SF_OK;
}

// A shape that has no outside to be cut along.
static exit_status fail_shape(cli_job *job, const solid_input *in)
{
    return sf_cage_get_view(in->cage).dimension < 3
               ? job_fail(job, EXIT_INPUT,
                          "%s is a surface; only a solid can be graded, from a mesh of cells.",
                          job->options.input)
               : job_fail(job, EXIT_INPUT,
                          "%s: its cells close upon themselves: each face has a cell on both of "
                          "its sides, so that the solid ends nowhere; leave a face open.",
                          job->options.input);
}

// Refuse layers that take more memory than --memory allows. Of the stack one layer is held: what
// press_planes() takes, and a shell's slices.
static exit_status check_memory(const press *p)
{
    const sf_lattice *l = &p->made->lattice;
    const cli_options *asked = &p->job->options;
    double plane = (double)l->nx * l->ny, numbers = (double)p->m->property_count + p->m->count;
    double slices = p->keep.count > 0 ? 2 * p->keep.distance_mm / l->layer_mm + 8 : 2;
    double bytes = plane * (8 * numbers + 1) + slices * 8 * (double)sf_slice_stride(l->nx) * l->ny;
    if (asked->picture != NULL) {
        bytes += grade_picture_bytes(l);
    }
    double mib = ceil(bytes / 1048576);
    return mib <= asked->memory_mib
               ? EXIT_GOOD
               : job_fail(p->job, EXIT_RESOURCE,
                          "A layer of %u x %u voxels takes %.0f MiB with its properties and "
                          "tones%s, and --memory allows %.0f; take a coarser --pitch, a lower "
                          "--resolution, or --memory %.0f.",
                          l->nx, l->ny, mib, asked->picture != NULL ? ", and its picture" : "",
                          asked->memory_mib, mib);
}

exit_status press_shape(press *p, const solid_input *in, const size_t *channels)
{
    double low[3], high[3];
    uint32_t lift;
    sf_fault fault = {SF_OK, 0, 0, ""};
    progress_phase("looking at the solid");
    sf_status status = find_box(p, in, low, high);
    if (status == SF_ERR_UNSUPPORTED) {
        return fail_shape(p->job, in);
    }
    if (status != SF_OK) {
        return fail_call(p->job, status, NULL);
    }
    exit_status chosen = lattice_fit(p->job, low, high, &p->made->lattice, &lift);
    if (chosen == EXIT_GOOD) {
        chosen = check_memory(p);
    }
    if (chosen != EXIT_GOOD) {
        return chosen;
    }
    progress_phase("cutting the surface");
    status = in->cage != NULL
                 ? sf_sampler_create(p->limit, &p->made->lattice, NULL, p->m->property_count,
                                     channels, NULL, &p->job->task, &p->sampler, &fault)
                 : sf_sampler_of_tets(in->tets, &p->made->lattice, p->m->property_count, channels,
                                      NULL, &p->sampler, &fault);
    (void)sf_sampler_surface(p->sampler, &p->made->surface_error_mm);
    return status == SF_OK ? EXIT_GOOD : fail_call(p->job, status, &fault);
}

// Where the shell is, taking from the surface as it is cut: as much farther as that may be off.
static exit_status set_up_shell(press *p)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    const char *option = p->job->options.given & OPTION_SHELL ? "--shell" : "--keep-out";
    if (p->keep.count == 0) {
        return EXIT_GOOD;
    }
    double distance = p->keep.distance_mm + p->made->surface_error_mm;
    sf_status status = sf_shell_create(sf_sampler_surface(p->sampler, NULL), &p->made->lattice,
                                       distance, NULL, &p->shell, &fault);
    if (status == SF_ERR_OVERFLOW) {
        return job_fail(p->job, EXIT_USAGE,
                        "%s reaches %g mm, which is more than 255 voxels; take a thinner one, or a "
                        "coarser --pitch.",
                        option, p->keep.distance_mm);
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(p->job, status, &fault, option, EXIT_USAGE);
}

// The mask of a layer repeats after so many voxels: wider than the one that is built in, since the
// spectrum of a wide one is rounder, for a quarter of a second.
enum { MASK_WIDTH = 64 };

static sf_status set_up_mask(press *p)
{
    const sf_lattice *l = &p->made->lattice;
    const double pitch[3] = {l->pitch_x_mm, l->pitch_y_mm, l->layer_mm};
    if (p->job->options.mask == CLI_MASK_DIFFUSE) {
        return sf_diffuser_create(l->nx, l->ny, p->m->count, pitch, NULL, &p->diffuser);
    }
    sf_mask_options how = sf_mask_options_default();
    how.kind = p->job->options.mask == CLI_MASK_ISOTROPIC ? SF_MASK_ISOTROPIC : SF_MASK_SLICE;
    memcpy(how.pitch_mm, pitch, sizeof pitch);
    how.nx = how.ny = MASK_WIDTH;
    progress_phase("making the mask");
    sf_status status = sf_mask_create(&how, NULL, &p->job->task, &p->mask);
    return status == SF_OK ? sf_halftone_create(p->mask, p->m->count, NULL, &p->halftone) : status;
}

static exit_status fail_mask(press *p, sf_status status)
{
    const sf_lattice *l = &p->made->lattice;
    if (status != SF_ERR_ARGUMENT) {
        return fail_call(p->job, status, NULL);
    }
    return job_fail(p->job, EXIT_USAGE,
                    "Voxels of %g x %g x %g mm cannot be halftoned: no side may be more than 64 "
                    "times another; give --pitch with sides that are more alike.",
                    l->pitch_x_mm, l->pitch_y_mm, l->layer_mm);
}

int press_planes(press *p)
{
    const sf_lattice *l = &p->made->lattice;
    size_t plane = (size_t)l->nx * l->ny;
    sf_lattice one = *l;
    int good = 1;
    one.nz = 2;
    for (size_t i = 0; i < p->m->property_count; i++) {
        p->values[i] = malloc(plane * sizeof(double));
        good = good && p->values[i] != NULL;
    }
    for (uint32_t i = 0; i < p->m->count; i++) {
        p->tones[i] = malloc(plane * sizeof(double));
        good = good && p->tones[i] != NULL;
    }
    p->ids = malloc(plane);
    return good && p->ids != NULL && sf_grid_create(&one, NULL, &p->grid) == SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Layers
// ---------------------------------------------------------------------------------------------

static int is_solid(sf_slice s, uint32_t x, uint32_t y)
{
    return (int)(s.words[(size_t)y * s.stride + x / 64] >> x % 64 & 1);
}

// From properties to tones, voxel by voxel.
void press_mix(press *p, sf_slice solid)
{
    materials *m = p->m;
    for (uint32_t y = 0; y < solid.height; y++) {
        for (uint32_t x = 0; x < solid.width; x++) {
            size_t at = (size_t)y * solid.width + x;
            double wanted[MATERIALS_PROPERTIES_MAX], fractions[MATERIALS_MAX] = {0};
            if (!is_solid(solid, x, y)) {
                continue;
            }
            for (size_t i = 0; i < m->property_count; i++) {
                wanted[i] = p->values[i][at];
            }
            double miss = materials_mix(m, wanted, fractions);
            p->made->missed += miss > MISS * (1 + fabs(wanted[0]));
            p->made->worst_miss = fmax(p->made->worst_miss, miss);
            for (uint32_t i = 0; i < m->count; i++) {
                p->tones[i][at] = fractions[i];
                p->made->asked[i] += fractions[i];
            }
        }
    }
}

// Which solid voxels of a layer are near the surface.
static sf_status find_shell(press *p, uint32_t k, sf_slice solid)
{
    sf_slice near = sf_grid_slice(p->grid, 1);
    sf_slice_sums sums;
    sf_status status = sf_shell_slice(p->shell, k, near);
    if (status == SF_OK) {
        status = sf_slice_and(near, solid, near);
    }
    if (status == SF_OK) {
        status = sf_slice_measure(near, &sums);
    }
    if (status == SF_OK) {
        p->made->shell += sums.count;
        for (size_t i = 0; i < p->keep.count; i++) {
            p->keep.outs[i].where = near;
        }
    }
    return status;
}

static sf_status halftone(press *p, uint32_t k, sf_slice solid)
{
    sf_tone_plane planes[MATERIALS_MAX];
    for (uint32_t i = 0; i + 1 < p->m->count; i++) {
        sf_tone_plane plane = {p->tones[i], solid.width};
        planes[i] = plane;
    }
    sf_tones tones;
    memset(&tones, 0, sizeof tones);
    if (p->shell != NULL) {
        sf_status status = find_shell(p, k, solid);
        if (status != SF_OK) {
            return status;
        }
        tones.keep_outs = p->keep.outs;
        tones.keep_out_count = p->keep.count;
    }
    tones.struct_size = sizeof tones;
    tones.width = solid.width;
    tones.height = solid.height;
    tones.layer = k;
    tones.type = SF_TONE_F64;
    tones.planes = planes;
    tones.solid = solid;
    sf_materials to = {NULL, p->ids, solid.width, NULL};
    return p->diffuser != NULL ? sf_diffuser_slice(p->diffuser, &tones, &to)
                               : sf_halftone_slice(p->halftone, &tones, &to, NULL);
}

static exit_status press_layers(press *p)
{
    cli_job *job = p->job;
    const sf_lattice *l = &p->made->lattice;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_slice solid = sf_grid_slice(p->grid, 0);
    sf_status status = SF_OK;
    progress_phase("grading");
    for (uint32_t k = 0; status == SF_OK && k < l->nz; k++) {
        status = sf_task_is_cancelled(&job->task)
                     ? SF_ERR_CANCELLED
                     : sf_sampler_slice(p->sampler, k, solid, p->values);
        if (status == SF_OK) {
            press_mix(p, solid);
            status = halftone(p, k, solid);
        }
        if (status == SF_OK && p->picture.front != NULL) {
            grade_picture_look(&p->picture, k, solid, p->values[0], p->ids);
        }
        if (status == SF_OK) {
            status = sf_layers_add(p->layers, p->ids, l->nx, &fault);
        }
        if (job->task.progress != NULL) {
            job->task.progress(job->task.user, (k + 1.0) / l->nz);
        }
    }
    return status == SF_OK ? EXIT_GOOD : fail_call(job, status, &fault);
}

exit_status press_look_for_solid(press *p)
{
    sf_status status = sf_sampler_report(p->sampler, &p->made->voxels);
    if (status != SF_OK) {
        return fail_call(p->job, status, NULL);
    }
    return p->made->voxels.solid > 0
               ? EXIT_GOOD
               : job_fail(p->job, EXIT_INPUT,
                          "%s: No voxel has its centre inside the solid; take a finer --pitch, or "
                          "check --units.",
                          p->job->options.input);
}

static exit_status publish(press *p, const char *path)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_layers_finish(p->layers, p->made->uses, &fault);
    if (status == SF_OK) {
        status = sf_directory_commit(p->directory, &fault);
        p->directory = NULL;
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(p->job, status, &fault, path, EXIT_RESOURCE);
}

static exit_status draw(press *p, const sf_property *property)
{
    canvas to;
    exit_status status = grade_picture_draw(p->job, &p->picture, p->m, property, &to);
    if (status == EXIT_GOOD) {
        status = output_save_picture(p->job, &to, p->job->options.picture);
        canvas_destroy(&to);
    }
    return status;
}

static exit_status run(press *p, const solid_input *in, const size_t *channels, const char *path)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    exit_status status = press_shape(p, in, channels);
    if (status != EXIT_GOOD) {
        return status;
    }
    if (p->job->options.picture != NULL) {
        status = grade_picture_begin(p->job, &p->made->lattice, &p->picture);
    }
    if (status == EXIT_GOOD) {
        status = set_up_shell(p);
    }
    if (status != EXIT_GOOD) {
        return status;
    }
    sf_status made = set_up_mask(p);
    if (made != SF_OK) {
        return fail_mask(p, made);
    }
    if (!press_planes(p)) {
        return job_fail(p->job, EXIT_RESOURCE, "There is no memory for a layer.");
    }
    made = sf_directory_write(path, NULL, &p->directory, &fault);
    if (made == SF_OK) {
        made = sf_layers_begin(sf_directory_folder(p->directory), &p->made->lattice, p->m->count,
                               p->m->table, NULL, &p->layers, &fault);
    }
    if (made != SF_OK) {
        return job_fail_call(p->job, made, &fault, path, EXIT_RESOURCE);
    }
    status = press_layers(p);
    if (status == EXIT_GOOD) {
        status = press_look_for_solid(p);
    }
    if (status == EXIT_GOOD && p->picture.front != NULL) {
        const sf_channel *all;
        (void)solids_channels(in, &all);
        status = draw(p, &all[channels[0]].property);
    }
    return status == EXIT_GOOD ? publish(p, path) : status;
}

exit_status graded_write(cli_job *job, const solid_input *in, const size_t *channels, materials *m,
                         const shells *shell, const char *path, graded *made)
{
    press p;
    memset(&p, 0, sizeof p);
    memset(made, 0, sizeof *made);
    p.job = job;
    p.m = m;
    p.keep = *shell;
    p.made = made;
    exit_status status = package_is_asked(path) ? graded_package(&p, in, channels, path)
                                                : run(&p, in, channels, path);
    free_press(&p);
    return status;
}
