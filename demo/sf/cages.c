// SPDX-License-Identifier: MIT
// Cages from files: read, brought to size, and looked at before any work is done.

#include "cages.h"

#include "progress.h"
#include "recipes.h"

#include <sf/cage_io.h>
#include <sf/io.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int is_exchange(const char *path)
{
    const char *dot = strrchr(path, '.');
    return dot != NULL && (strcmp(dot, ".h5") == 0 || strcmp(dot, ".hdf5") == 0);
}

int cages_look_like(const char *path)
{
    static const char *const firsts[] = {"# vtk DataFile", "MFEM ", "MeshVersionFormatted",
                                         "\x89HDF\r\n\x1a\n"};
    char bytes[512 + 1] = "";
    FILE *file = fopen(path, "rb");
    size_t have = file != NULL ? fread(bytes, 1, sizeof bytes - 1, file) : 0;
    if (file != NULL) {
        fclose(file);
    }
    for (size_t i = 0; i < sizeof firsts / sizeof firsts[0]; i++) {
        size_t length = strlen(firsts[i]);
        if (have >= length && memcmp(bytes, firsts[i], length) == 0) {
            return i > 0 || strstr(bytes, "UNSTRUCTURED_GRID") != NULL; // or VTK of another kind
        }
    }
    return 0;
}

static exit_status read_file(cli_job *job, sf_cage **cage, sf_cage_reading *reading)
{
    const char *path = job->options.input;
    sf_file *file = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_file_open(path, NULL, &file, &fault);
    if (status == SF_OK) {
        progress_phase("reading");
        status = sf_cage_read(sf_file_source(file), NULL, NULL, cage, reading, &fault);
        sf_file_close(file);
    }
    if (status == SF_ERR_FORMAT && is_exchange(path)) {
        return job_fail(
            job, EXIT_INPUT,
            "%s is no cage; the tetrahedra of an exchange file are taken by 'sf exchange' "
            "and 'sf grade'.",
            path);
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_INPUT);
}

// Millimetres in one unit of the file.
static double factor(const cli_options *asked, const sf_cage_view *view)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    double longest = 0;
    if ((asked->given & OPTION_SIZE) == 0) {
        return asked->unit_mm * asked->scale;
    }
    for (size_t i = 0; i < 3 * view->point_count; i++) {
        low[i % 3] = fmin(low[i % 3], view->positions[i]);
        high[i % 3] = fmax(high[i % 3], view->positions[i]);
    }
    for (int i = 0; i < 3; i++) {
        longest = fmax(longest, high[i] - low[i]);
    }
    return asked->size_mm / longest;
}

static exit_status bring_to_size(cli_job *job, sf_cage *cage)
{
    sf_cage_view view = sf_cage_get_view(cage);
    double scale = factor(&job->options, &view);
    if (scale == 1) {
        return EXIT_GOOD;
    }
    double *scaled = malloc(3 * view.point_count * sizeof *scaled);
    if (scaled == NULL) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the cage.");
    }
    for (size_t i = 0; i < 3 * view.point_count; i++) {
        scaled[i] = scale * view.positions[i];
    }
    sf_status status = sf_cage_set_positions(cage, 0, view.point_count, scaled);
    free(scaled);
    return status == SF_OK ? EXIT_GOOD
                           : job_fail(job, EXIT_USAGE,
                                      "The cage cannot be brought to that size; check --units, "
                                      "--scale and --size.");
}

static exit_status look(cli_job *job, const sf_cage *cage)
{
    sf_cage_report found;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_cage_check(cage, NULL, &found, &fault);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, job->options.input, EXIT_INPUT);
    }
    if (found.inverted_cells > 0) {
        return job_fail(job, EXIT_INPUT,
                        "%s: %s%s; a cell must have a positive volume at each of its corners.",
                        job->options.input, fault.message,
                        found.inverted_cells == 1 ? "" : ", and others are, too");
    }
    return EXIT_GOOD;
}

exit_status cages_read(cli_job *job, sf_cage **cage)
{
    sf_cage_reading reading;
    *cage = NULL;
    exit_status status = read_file(job, cage, &reading);
    if (status == EXIT_GOOD && reading.turned_cells > 0) {
        job_warn(job, "%zu cells were inside out, and are turned.", reading.turned_cells);
    }
    if (status == EXIT_GOOD) {
        status = bring_to_size(job, *cage);
    }
    if (status == EXIT_GOOD && job->options.paint != NULL) {
        status = recipes_apply(job, *cage);
    }
    return status == EXIT_GOOD ? look(job, *cage) : status;
}

void cages_report(cli_job *job, const sf_cage *cage)
{
    sf_cage_view view = sf_cage_get_view(cage);
    report *r = job->report;
    report_begin(r, "cage");
    report_count(r, "dimension", view.dimension);
    report_count(r, "points", view.point_count);
    report_count(r, "cells", view.cell_count);
    report_begin_list(r, "properties");
    for (size_t i = 0; i < view.channel_count; i++) {
        report_text(r, NULL, view.channels[i].property.name);
    }
    report_end(r);
    report_end(r);
}
