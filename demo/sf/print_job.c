// SPDX-License-Identifier: MIT
// Jobs of printers and files of contours, read as parts and written.
//
// A job that is only checked passes by a layer at a time, so that one of any length can be judged
// in the memory of a few layers; whoever changes it needs all of it in a grid.

#include "print_job.h"

#include "describe.h"
#include "lattice.h"
#include "output.h"
#include "progress.h"

#include <sf/contour_io.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int ends_with(const char *path, const char *ending)
{
    size_t length = strlen(path), size = strlen(ending);
    if (length < size) {
        return 0;
    }
    for (size_t i = 0; i < size; i++) {
        char c = path[length - size + i];
        if ((c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) != ending[i]) {
            return 0;
        }
    }
    return 1;
}

int print_job_is_named(const char *path)
{
    return ends_with(path, ".sl1") || ends_with(path, ".sl1s") || ends_with(path, ".photon");
}

int print_job_is_contours(const char *path)
{
    return ends_with(path, ".cli");
}

// ---------------------------------------------------------------------------------------------
// Jobs
// ---------------------------------------------------------------------------------------------

exit_status print_job_open(cli_job *job, part *p)
{
    const cli_options *asked = &job->options;
    sf_job_options options = sf_job_options_default();
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_job_info info;
    sf_bytes bytes;
    p->kind = PART_JOB;
    if (asked->given & OPTION_THRESHOLD) {
        options.threshold = asked->threshold;
    }
    if (asked->given & OPTION_PITCH) {
        options.pitch_mm[0] = asked->pitch_mm[0];
        options.pitch_mm[1] = asked->pitch_mm[1];
    }
    progress_phase("reading");
    sf_status status = sf_file_open(asked->input, NULL, &p->file, &fault);
    if (status == SF_OK) {
        status = sf_file_bytes(p->file, &bytes, &fault);
    }
    if (status == SF_OK) {
        status = sf_job_open(bytes, &options, NULL, &p->layers, &fault);
    }
    if (status == SF_OK) {
        status = sf_job_describe(p->layers, &info);
    }
    if (status != SF_OK) {
        return job_fail_call(job, status, &fault, asked->input, EXIT_INPUT);
    }
    p->lattice = sf_job_lattice(p->layers);
    report_text(job->report, "job", info.format == SF_JOB_SL1 ? "sl1" : "photon");
    report_count(job->report, "threshold", options.threshold);
    if (!info.has_pitch && (asked->given & OPTION_PITCH) == 0) {
        job_warn(job,
                 "The job does not say how large its pixels are; they were taken for those of an "
                 "SL1, %g mm. --pitch says otherwise.",
                 p->lattice.pitch_x_mm);
    }
    return EXIT_GOOD;
}

exit_status print_job_load(cli_job *job, part *p)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    exit_status fits = lattice_check_given(job, &p->lattice);
    if (fits != EXIT_GOOD) {
        return fits;
    }
    progress_phase("reading the layers");
    sf_status status = sf_grid_create(&p->lattice, NULL, &p->grid);
    for (uint32_t k = 0; status == SF_OK && k < p->lattice.nz; k++) {
        status = sf_task_is_cancelled(&job->task)
                     ? SF_ERR_CANCELLED
                     : sf_job_read(p->layers, k, sf_grid_slice(p->grid, k), &fault);
        if (job->task.progress != NULL) {
            job->task.progress(job->task.user, (k + 1.0) / p->lattice.nz);
        }
    }
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, &fault, job->options.input, EXIT_INPUT);
}

void print_job_close(part *p)
{
    sf_job_close(p->layers);
    sf_file_close(p->file);
    p->layers = NULL;
    p->file = NULL;
}

// ---------------------------------------------------------------------------------------------
// Contours
// ---------------------------------------------------------------------------------------------

// The longest side of what the contours enclose, by a lattice that is coarse enough for any.
static double longest_of(const sf_contour_stack *stack, double *heights)
{
    double pitch = 1e-9, longest = 0;
    sf_lattice lattice;
    size_t count = sf_contour_stack_count(stack);
    while (sf_contour_stack_lattice(stack, pitch, pitch, heights, count, &lattice) ==
               SF_ERR_OVERFLOW &&
           pitch < 1e12) {
        pitch *= 10;
    }
    if (sf_contour_stack_lattice(stack, pitch, pitch, heights, count, &lattice) == SF_OK) {
        longest = pitch * (lattice.nx > lattice.ny ? lattice.nx : lattice.ny);
    }
    for (size_t k = 0; k < count; k++) {
        longest = fmax(longest, heights[k]);
    }
    return longest;
}

static exit_status draw(cli_job *job, part *p, const sf_contour_stack *stack, double *heights)
{
    const cli_options *asked = &job->options;
    double pitch[2] = {asked->pitch_mm[0], asked->pitch_mm[1]};
    if ((asked->given & OPTION_PITCH) == 0) {
        pitch[0] = pitch[1] = longest_of(stack, heights) / asked->resolution;
    }
    sf_status status = sf_contour_stack_lattice(stack, pitch[0], pitch[1], heights,
                                                sf_contour_stack_count(stack), &p->lattice);
    if (status != SF_OK) {
        return job_fail(job, EXIT_INPUT,
                        "%s: Nothing in it encloses an area that these voxels could show; try "
                        "another --pitch.",
                        asked->input);
    }
    exit_status fits = lattice_check_given(job, &p->lattice);
    if (fits != EXIT_GOOD) {
        return fits;
    }
    progress_phase("drawing the contours");
    status =
        sf_grid_from_contours(stack, &p->lattice, SF_CONTOUR_NONZERO, NULL, &job->task, &p->grid);
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, NULL, asked->input, EXIT_INPUT);
}

exit_status print_job_read_contours(cli_job *job, part *p)
{
    sf_contour_stack *stack = NULL;
    sf_file *file = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    p->kind = PART_JOB;
    progress_phase("reading");
    sf_status status = sf_file_open(job->options.input, NULL, &file, &fault);
    if (status == SF_OK) {
        status = sf_contour_stack_read(sf_file_source(file), NULL, NULL, &stack, &fault);
        sf_file_close(file);
    }
    if (status != SF_OK) {
        return job_fail_call(job, status, &fault, job->options.input, EXIT_INPUT);
    }
    double *heights = malloc(sf_contour_stack_count(stack) * sizeof *heights);
    exit_status done = heights != NULL
                           ? draw(job, p, stack, heights)
                           : job_fail(job, EXIT_RESOURCE, "There is no memory for the heights.");
    free(heights); // the grid has its own
    sf_contour_stack_destroy(stack);
    return done;
}

// ---------------------------------------------------------------------------------------------
// Judging
// ---------------------------------------------------------------------------------------------

enum { RUNS_MAX = 262144 };

// What passes by.
typedef struct passing {
    cli_job *job;
    part *p;
    judgement *j;
    sf_checker *checker;
    sf_void_search *voids;
    sf_slice slice;
    void *memory;
    sf_fault fault;
} passing;

static sf_status begin(passing *w)
{
    const sf_lattice *l = &w->p->lattice;
    sf_check_options check = sf_check_options_default();
    sf_voids_options voids = hollows_options(w->p, &w->j->hollows);
    size_t size;
    check.rule = w->p->rule;
    check.bed_layer = w->p->bed_layer;
    check.width = l->nx;
    check.height = l->ny;
    check.findings = w->j->findings;
    check.finding_capacity = JUDGEMENT_FINDINGS_MAX;
    check.run_capacity = RUNS_MAX;
    sf_status status = sf_checker_size(&check, &size);
    if (status != SF_OK) {
        return status;
    }
    w->memory = malloc(size + 64);
    w->slice.words = calloc((size_t)l->ny * sf_slice_stride(l->nx), sizeof *w->slice.words);
    if (w->memory == NULL || w->slice.words == NULL) {
        return SF_ERR_MEMORY;
    }
    w->slice.width = l->nx;
    w->slice.height = l->ny;
    w->slice.stride = sf_slice_stride(l->nx);
    char *aligned = (char *)w->memory + (64 - (uintptr_t)w->memory % 64) % 64;
    status = sf_checker_place(&check, aligned, size, &w->checker);
    return status == SF_OK ? sf_void_search_create(&voids, l->nx, l->ny, NULL, &w->voids) : status;
}

static sf_status take_layers(passing *w)
{
    const sf_lattice *l = &w->p->lattice;
    for (uint32_t k = 0; k < l->nz; k++) {
        sf_status status = sf_task_is_cancelled(&w->job->task)
                               ? SF_ERR_CANCELLED
                               : sf_job_read(w->p->layers, k, w->slice, &w->fault);
        if (status == SF_OK) {
            w->p->volume_mm3 += (double)sf_slice_popcount(w->slice) * l->pitch_x_mm *
                                l->pitch_y_mm * sf_lattice_layer_height(l, k);
            status = sf_checker_push(w->checker, w->slice);
        }
        if (status == SF_OK) {
            status = sf_void_search_push(w->voids, w->slice);
        }
        if (status != SF_OK) {
            return status;
        }
        if (w->job->task.progress != NULL) {
            w->job->task.progress(w->job->task.user, (k + 1.0) / l->nz);
        }
    }
    sf_status status = sf_checker_report(w->checker, &w->j->counts, &w->j->finding_count);
    return status == SF_OK
               ? sf_void_search_finish(w->voids, &w->j->hollows.counts, &w->j->hollows.count)
               : status;
}

exit_status print_job_judge(cli_job *job, part *p, judgement *j)
{
    passing w = {.job = job, .p = p, .j = j};
    exit_status done = judgement_begin(job, j);
    if (done == EXIT_GOOD) {
        done = hollows_begin(job, &j->hollows);
    }
    if (done != EXIT_GOOD) {
        return done;
    }
    progress_phase("checking the layers");
    sf_status status = begin(&w);
    if (status == SF_OK) {
        status = take_layers(&w);
    }
    sf_void_search_destroy(w.voids);
    free(w.slice.words);
    free(w.memory);
    if (status != SF_OK) {
        return job_fail_call(job, status, &w.fault, job->options.input, EXIT_INPUT);
    }
    p->solid_voxels = j->counts.solid_voxels;
    if (j->counts.runs_dropped > 0) {
        job_warn(job, "So much hangs that not all of it could be laid to a place; the places' "
                      "volumes are too small.");
    }
    return judgement_settle(job, p, j);
}

// ---------------------------------------------------------------------------------------------
// Writing
// ---------------------------------------------------------------------------------------------

exit_status print_job_save(cli_job *job, const part *p, const sf_grid *grid, const char *path)
{
    sf_save *save = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    uint32_t changed = 0;
    sf_status status = sf_save_begin(path, NULL, &save, &fault);
    if (status != SF_OK) {
        return job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
    }
    progress_phase("writing the job");
    if (p->layers != NULL) {
        status = sf_job_rewrite(p->layers, grid, sf_save_sink(save), &job->task, &changed, &fault);
    } else {
        status = sf_sl1_write(grid, NULL, NULL, sf_save_sink(save), &job->task, &fault);
    }
    if (status != SF_OK) {
        sf_save_abort(save);
        return job_fail_call(job, status, &fault, path,
                             status == SF_ERR_IO ? EXIT_RESOURCE : EXIT_INPUT);
    }
    status = sf_save_commit(save, &fault);
    if (status != SF_OK) {
        return job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
    }
    if (p->layers != NULL) {
        report_count(job->report, "changed_layers", changed);
        report_say(job->report, "%u of its %u layers changed; everything else is as it was.",
                   changed, p->lattice.nz);
    }
    return EXIT_GOOD;
}
