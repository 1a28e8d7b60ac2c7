// SPDX-License-Identifier: MIT
// Drain holes of a model that was made to stand.
//
// A hole takes weight out of the wall, what the wall weighs there, so the stances judge the model
// again with its holes. Holes
// are voxels and the outside is triangles: what is written beside both is the cavity with its holes
// as one body, which a slicer takes from the outside; the holes of that body go on a voxel beyond
// it.

#include "stand_drill.h"

#include "describe.h"
#include "hollow_mesh.h"
#include "place.h"
#include "progress.h"
#include "turned.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEGREES (180 / 3.14159265358979323846)

static exit_status fail(cli_job *job, sf_status status)
{
    return job_fail_call(job, status, NULL, "the holes", EXIT_RESOURCE);
}

static sf_status copy(const sf_grid *from, sf_grid **to)
{
    sf_lattice lattice = sf_grid_lattice(from);
    sf_status status = sf_grid_create(&lattice, NULL, to);
    for (uint32_t k = 0; status == SF_OK && k < lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(from, k);
        status = sf_slice_and(sf_grid_slice(*to, k), slice, slice);
    }
    return status;
}

// What the model weighs.
static sf_body body_of(const model *m)
{
    sf_body made = {m->report.mass, {0, 0, 0}};
    for (int i = 0; i < 3; i++) {
        made.moment[i] = made.mass * m->report.com_mm[i];
    }
    return made;
}

// With what was drilled out and filled in.
static sf_status weigh(model *m, drilled *d)
{
    sf_body before, after;
    sf_status status =
        sf_grid_body(sf_stand_grid(m->stand), sf_stand_density(m->stand), NULL, &before);
    if (status == SF_OK) {
        status = sf_grid_body(d->after, sf_stand_density(m->stand), NULL, &after);
    }
    if (status == SF_OK) {
        after = sf_body_add(sf_body_add(body_of(m), -1, before), 1, after);
        status = sf_body_com(after, d->com_mm);
    }
    return status;
}

static sf_status judge(model *m, drilled *d)
{
    sf_status status = weigh(m, d);
    d->margin_rad = INFINITY;
    d->safe = 1;
    for (size_t i = 0; status == SF_OK && i < m->stances.count; i++) {
        sf_stance_verdict verdict;
        status = sf_stance_judge(sf_stand_stance(m->stand, i), d->com_mm, &verdict);
        if (status == SF_OK) {
            d->margin_rad = fmin(d->margin_rad, verdict.margin_rad);
            d->safe = d->safe && verdict.safe;
        }
    }
    return status;
}

static exit_status drill(cli_job *job, model *m, const sf_terms *terms)
{
    drilled *d = &m->drilled;
    const sf_stance *all[STANCES_MAX];
    sf_drain_options o = sf_drain_options_default();
    for (size_t i = 0; i < m->stances.count; i++) {
        all[i] = sf_stand_stance(m->stand, i);
    }
    o.diameter_mm = job->options.drain_mm;
    o.count = job->options.drain_count;
    o.fill = 1;
    o.density = sf_stand_density(m->stand);
    o.body = body_of(m);
    o.stances = all;
    o.stance_count = m->stances.count;
    o.drains = d->drains;
    o.drain_capacity = DRAINS_MAX;
    progress_phase("drilling");
    sf_status status = copy(sf_stand_grid(m->stand), &d->after);
    if (status == SF_OK) {
        status = sf_grid_drain(d->after, terms, &o, NULL, &job->task, &d->report);
    }
    if (status == SF_ERR_UNSUPPORTED) {
        return job_fail(job, EXIT_USAGE, "--drain %g is more than 500 voxels of %g mm.",
                        o.diameter_mm, m->options.pitch_mm);
    }
    if (status == SF_OK) {
        status = judge(m, d);
    }
    return status == SF_OK ? EXIT_GOOD : fail(job, status);
}

exit_status stand_drill(cli_job *job, model *m)
{
    part bent;
    if (m->cavity == NULL) {
        return EXIT_GOOD;
    }
    if (m->options.carve_mode == SF_CARVE_PLANE) { // where ceilings may hang, holes may go anywhere
        return drill(job, m, NULL);
    }
    memset(&bent, 0, sizeof bent);
    bent.bed_layer = SF_BED_AUTO;
    bent.grid = m->solid;
    exit_status status = part_make_rule(job, &bent);
    if (status == EXIT_GOOD) {
        sf_terms terms = part_terms(&bent);
        status = drill(job, m, &terms);
    }
    free(bent.table);
    return status;
}

exit_status stand_drill_mesh(cli_job *job, const model *m, sf_mesh **mesh)
{
    part bent;
    cavity inside;
    memset(&bent, 0, sizeof bent);
    memset(&inside, 0, sizeof inside);
    bent.grid = m->solid;
    inside.carved = m->cavity;
    inside.done.after = m->drilled.after;
    return hollow_cavity_mesh(job, &bent, &inside, mesh);
}

// ---------------------------------------------------------------------------------------------
// Words
// ---------------------------------------------------------------------------------------------

static double volume_of(const model *m, uint64_t voxels)
{
    return (double)voxels * place_voxel_mm3(m->drilled.after);
}

static void report_drain(const cli_job *job, const model *m, const sf_drain *d)
{
    double from[3], to[3];
    turned_to_input(job, d->from_mm, from);
    turned_to_input(job, d->to_mm, to);
    report_begin(job->report, NULL);
    report_numbers(job->report, "from_mm", from, 3);
    report_numbers(job->report, "to_mm", to, 3);
    report_number(job->report, "volume_mm3", volume_of(m, d->voxels));
    report_number(job->report, "mass", d->body.mass);
    report_end(job->report);
}

static void say(cli_job *job, const model *m)
{
    const sf_drain_report *done = &m->drilled.report;
    char volume[DESCRIBE_MM3_SIZE];
    report_say(
        job->report,
        "%llu of %llu voids drained by %llu hole%s of %g mm, %s in all; with them the margin "
        "is %.2f degrees%s.",
        (unsigned long long)done->drained_count, (unsigned long long)done->void_count,
        (unsigned long long)done->drain_count, done->drain_count == 1 ? "" : "s",
        job->options.drain_mm, describe_mm3(volume_of(m, done->removed_voxels), volume),
        m->drilled.margin_rad * DEGREES,
        m->drilled.safe || !m->report.safe ? "" : ", less than was asked for");
    if (done->filled_count > 0) {
        report_say(job->report, "%llu void%s too small for a hole and filled again.",
                   (unsigned long long)done->filled_count,
                   done->filled_count == 1 ? " was" : "s were");
    }
    if (done->closed_count > 0) {
        report_say(job->report, "%llu void%s still shut, where no hole may be drilled.",
                   (unsigned long long)done->closed_count,
                   done->closed_count == 1 ? " is" : "s are");
    }
}

void stand_drill_report(cli_job *job, const model *m)
{
    const drilled *d = &m->drilled;
    const double *com = d->com_mm;
    report *r = job->report;
    double there[3];
    if (d->after == NULL) {
        return;
    }
    turned_to_input(job, com, there);
    report_begin(r, "drained");
    report_count(r, "voids", d->report.void_count);
    report_count(r, "open", d->report.drained_count);
    report_count(r, "filled", d->report.filled_count);
    report_count(r, "closed", d->report.closed_count);
    report_number(r, "volume_mm3", volume_of(m, d->report.removed_voxels));
    report_number(r, "mass", d->report.removed.mass);
    report_number(r, "margin_deg", d->margin_rad * DEGREES);
    report_flag(r, "safe", d->safe);
    report_numbers(r, "com_mm", there, 3);
    report_begin_list(r, "holes");
    for (uint64_t i = 0; i < d->report.drain_count && i < DRAINS_MAX; i++) {
        report_drain(job, m, &d->drains[i]);
    }
    report_end(r);
    report_end(r);
    say(job, m);
}
