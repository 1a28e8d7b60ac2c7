// SPDX-License-Identifier: MIT
// sf slice: the part as layers, as it is.

#include "describe.h"
#include "output.h"
#include "progress.h"
#include "verbs.h"

#include <stdlib.h>

#define RULE_GIVEN (OPTION_RULE | OPTION_ANGLE | OPTION_BRIDGE | OPTION_BED)

// What a layer holds; `components` is UINT32_MAX where there was no memory to count them.
typedef struct layer_count {
    uint64_t voxels;
    uint32_t components;
} layer_count;

typedef struct counting {
    const sf_grid *grid;
    layer_count *counts;
} counting;

static void count_layer(void *context, size_t k)
{
    counting *c = context;
    sf_slice slice = sf_grid_slice(c->grid, (uint32_t)k);
    size_t count = 0;
    sf_run *runs = NULL;
    sf_status status = sf_slice_run_count(slice, &count);
    if (status == SF_OK && count > 0) {
        runs = malloc(count * sizeof *runs);
        status = runs == NULL ? SF_ERR_MEMORY : sf_slice_runs(slice, runs, count, &count);
    }
    if (status == SF_OK) {
        c->counts[k].voxels = sf_slice_popcount(slice);
        status = sf_runs_label(runs, count, SF_CONNECT_CORNERS, &c->counts[k].components);
    }
    free(runs);
    if (status != SF_OK) {
        c->counts[k].components = UINT32_MAX;
    }
}

static exit_status count_layers(cli_job *job, const part *p, layer_count **counts)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    counting c = {p->grid, calloc(lattice.nz, sizeof **counts)};
    *counts = c.counts;
    if (c.counts == NULL) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory to count the layers.");
    }
    progress_phase("counting");
    if (job->task.parallel_for != NULL) {
        job->task.parallel_for(job->task.user, lattice.nz, count_layer, &c);
    } else {
        for (uint32_t k = 0; k < lattice.nz; k++) {
            count_layer(&c, k);
        }
    }
    for (uint32_t k = 0; k < lattice.nz; k++) {
        if (c.counts[k].components == UINT32_MAX) {
            return job_fail(job, EXIT_RESOURCE, "There is no memory to count the layers.");
        }
    }
    return EXIT_GOOD;
}

static void report_layers(cli_job *job, const part *p, const layer_count *counts)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    report_count(job->report, "solid_voxels", sf_grid_popcount(p->grid));
    report_number(job->report, "volume_mm3", describe_volume(p->grid));
    report_begin_list(job->report, "layers");
    for (uint32_t k = 0; k < lattice.nz; k++) {
        report_begin(job->report, NULL);
        report_number(job->report, "z_mm", sf_lattice_layer_bottom(&lattice, k));
        report_count(job->report, "voxels", counts[k].voxels);
        report_count(job->report, "components", counts[k].components);
        report_end(job->report);
    }
    report_end(job->report);
}

static void say_where(cli_job *job)
{
    if (job->options.output != NULL) {
        report_text(job->report, "output", job->options.output);
        report_say(job->report, "Written to %s.", job->options.output);
    } else {
        report_say(job->report, "Nothing was written; -o FOLDER says where to.");
    }
}

static exit_status slice(cli_job *job, part *p)
{
    layer_count *counts = NULL;
    exit_status status = part_voxelize(job, p);
    // Slicing needs no rule; the stack that is written carries what was said of one, or what the
    // stack that was read says.
    if (status == EXIT_GOOD && (p->own_rule || (job->options.given & RULE_GIVEN))) {
        status = part_make_rule(job, p);
    }
    if (status != EXIT_GOOD) {
        return status;
    }
    describe_part(job, p, "slice");
    status = count_layers(job, p, &counts);
    if (status == EXIT_GOOD && job->options.output != NULL) {
        status = output_save(job, p, p->grid, job->options.output);
    }
    if (status == EXIT_GOOD) {
        report_layers(job, p, counts);
        char volume[DESCRIBE_MM3_SIZE];
        report_say(job->report, "%llu solid voxels, %s.",
                   (unsigned long long)sf_grid_popcount(p->grid),
                   describe_mm3(describe_volume(p->grid), volume));
        report_number(job->report, "seconds", job_seconds(job));
        say_where(job);
    }
    free(counts);
    return status;
}

exit_status verb_slice(cli_job *job)
{
    part p;
    exit_status status = output_check(job, 0);
    if (status != EXIT_GOOD) {
        return status;
    }
    status = part_read(job, &p);
    if (status == EXIT_GOOD) {
        status = slice(job, &p);
    }
    part_release(&p);
    return status;
}
