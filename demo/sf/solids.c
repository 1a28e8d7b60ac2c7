// SPDX-License-Identifier: MIT
// Solids from files.
//
// Exchange files are HDF5, and libhdf5 does not promise to survive a file that is damaged or means
// harm. So a child of this process reads the bytes first, with a limit of time; only if it is well
// afterwards does the parent read the same bytes.

#include "solids.h"

#include "cages.h"
#include "child.h"
#include "progress.h"

#include <sf/exchange.h>
#include <sf/io.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void solids_release(solid_input *s)
{
    sf_cage_destroy(s->cage);
    sf_tets_destroy(s->tets);
    s->cage = NULL;
    s->tets = NULL;
}

// ---------------------------------------------------------------------------------------------
// Exchange files
// ---------------------------------------------------------------------------------------------

static sf_status read_exchange(const unsigned char *bytes, size_t size, sf_tets **tets,
                               sf_fault *fault)
{
    sf_memory_cursor cursor = {bytes, size, 0};
    return sf_exchange_read(sf_memory_source(&cursor), 0, NULL, tets, fault);
}

typedef struct trial {
    const unsigned char *bytes;
    size_t size;
} trial;

// Whatever a child finds in the bytes, it need only live through them.
static int try_exchange(void *context)
{
    const trial *t = context;
    sf_tets *tets = NULL;
    (void)read_exchange(t->bytes, t->size, &tets, NULL);
    sf_tets_destroy(tets);
    return 0;
}

static exit_status read_tets(cli_job *job, sf_tets **tets)
{
    unsigned char *bytes = NULL;
    size_t size = 0;
    sf_fault fault = {SF_OK, 0, 0, ""};
    progress_phase("reading");
    exit_status status = child_read_bytes(job, job->options.input, &bytes, &size);
    trial t = {bytes, size};
    if (status == EXIT_GOOD && sf_exchange_is_served() && !child_survives(try_exchange, &t)) {
        status =
            job_fail(job, EXIT_INPUT, "%s is damaged so badly that the library for HDF5 fails.",
                     job->options.input);
    }
    if (status == EXIT_GOOD) {
        sf_status read = read_exchange(bytes, size, tets, &fault);
        status = read == SF_OK ? EXIT_GOOD
                               : job_fail_call(job, read, &fault, job->options.input, EXIT_INPUT);
    }
    free(bytes);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Both kinds
// ---------------------------------------------------------------------------------------------

static int ends_with(const char *path, const char *end)
{
    size_t length = strlen(path), tail = strlen(end);
    return length >= tail && strcmp(path + length - tail, end) == 0;
}

static int has_only_tetrahedra(const sf_cage_view *v)
{
    for (size_t i = 0; i < v->cell_count; i++) {
        if (v->starts[i + 1] - v->starts[i] != 4) {
            return 0;
        }
    }
    return v->dimension == 3;
}

// A fine mesh of tetrahedra is no cage to be smoothed.
static exit_status take_as_tetrahedra(cli_job *job, solid_input *s)
{
    sf_cage_view v = sf_cage_get_view(s->cage);
    sf_tets_view view = {v.point_count, v.positions,     v.cell_count,
                         v.corners,     v.channel_count, v.channels};
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_tets_create(&view, NULL, &s->tets, &fault);
    sf_cage_destroy(s->cage);
    s->cage = NULL;
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, &fault, job->options.input, EXIT_INPUT);
}

exit_status solids_read(cli_job *job, solid_input *read)
{
    const char *path = job->options.input;
    if (ends_with(path, ".h5") || ends_with(path, ".hdf5")) {
        if (job->options.given & (OPTION_UNITS | OPTION_SCALE | OPTION_SIZE | OPTION_PAINT)) {
            return job_fail(
                job, EXIT_USAGE,
                "An exchange file is taken as it is: leave out --units, --scale, --size and "
                "--paint.");
        }
        return read_tets(job, &read->tets);
    }
    exit_status status = cages_read(job, &read->cage);
    if (status == EXIT_GOOD && ends_with(path, ".vtk")) {
        sf_cage_view view = sf_cage_get_view(read->cage);
        status = has_only_tetrahedra(&view) ? take_as_tetrahedra(job, read) : EXIT_GOOD;
    }
    return status;
}

size_t solids_channels(const solid_input *s, const sf_channel **channels)
{
    sf_cage_view cage = sf_cage_get_view(s->cage);
    sf_tets_view tets = sf_tets_get_view(s->tets);
    *channels = s->cage != NULL ? cage.channels : tets.channels;
    return s->cage != NULL ? cage.channel_count : tets.channel_count;
}

void solids_report(cli_job *job, const solid_input *s)
{
    report *r = job->report;
    sf_cage_view cage = sf_cage_get_view(s->cage);
    sf_tets_view tets = sf_tets_get_view(s->tets);
    const sf_channel *channels;
    size_t count = solids_channels(s, &channels);
    report_begin(r, s->cage != NULL ? "cage" : "tetrahedra");
    if (s->cage != NULL) {
        report_count(r, "dimension", cage.dimension);
    }
    report_count(r, "points", s->cage != NULL ? cage.point_count : tets.point_count);
    report_count(r, "cells", s->cage != NULL ? cage.cell_count : tets.tet_count);
    report_begin_list(r, "properties");
    for (size_t i = 0; i < count; i++) {
        report_text(r, NULL, channels[i].property.name);
    }
    report_end(r);
    report_end(r);
}

exit_status solids_find_property(cli_job *job, const solid_input *s, const char *name,
                                 size_t *channel)
{
    const sf_channel *channels;
    size_t count = solids_channels(s, &channels);
    char names[400] = "";
    for (size_t i = 0; i < count; i++) {
        size_t used = strlen(names);
        if (strcmp(channels[i].property.name, name) == 0) {
            *channel = i;
            return EXIT_GOOD;
        }
        snprintf(names + used, sizeof names - used, "%s'%s'", i > 0 ? ", " : "",
                 channels[i].property.name);
    }
    return count == 0 ? job_fail(job, EXIT_INPUT, "%s has no properties, so none is called '%s'.",
                                 job->options.input, name)
                      : job_fail(job, EXIT_INPUT, "%s has no property '%s'; it has %s.",
                                 job->options.input, name, names);
}
