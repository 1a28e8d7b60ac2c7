// SPDX-License-Identifier: MIT
// Does the part print without supports, and where not?

#include "judgement.h"

#include "describe.h"
#include "place.h"
#include "progress.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FINDINGS_MAX = 65536 };

static sf_check_options how_to_check(const part *p)
{
    sf_check_options options = sf_check_options_default();
    options.rule = p->rule;
    options.bed_layer = p->bed_layer;
    return options;
}

sf_status count_unsupported(cli_job *job, const part *p, const sf_grid *grid,
                            sf_check_report *counts)
{
    sf_check_options options = how_to_check(p);
    return sf_grid_check(grid, &options, NULL, &job->task, counts, NULL);
}

// What the findings cost to fix. The map that this needs takes two bytes a voxel, so
// --memory may forbid it; then they are told by what a trim takes.
static exit_status price(cli_job *job, const part *p, judgement *j)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    sf_terms terms = part_terms(p);
    double mib = 2.0 * lattice.nx * lattice.ny * lattice.nz / 1048576;
    size_t places = j->finding_count > 0 ? j->finding_count : 1;
    j->costs = malloc(places * sizeof *j->costs);
    j->order = malloc(2 * places * sizeof *j->order);
    if (j->costs == NULL || j->order == NULL) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the costs.");
    }
    j->ranks = j->order + places;
    j->priced = mib <= job->options.memory_mib;
    sf_status status = SF_OK;
    if (j->priced) {
        progress_phase("pricing");
        status = sf_findings_cost(p->grid, &terms, j->findings, j->finding_count, NULL, &job->task,
                                  j->costs, NULL);
    }
    for (size_t i = 0; !j->priced && i < j->finding_count; i++) {
        j->costs[i].trim_voxels = j->findings[i].volume;
        j->costs[i].grow_voxels = SF_COST_NONE;
    }
    if (status == SF_OK) {
        status = sf_findings_rank(j->findings, j->costs, j->finding_count, j->order);
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, NULL, "the costs", EXIT_INPUT);
}

exit_status judge(cli_job *job, const part *p, judgement *j)
{
    sf_check_options options = how_to_check(p);
    memset(j, 0, sizeof *j);
    j->findings = malloc(FINDINGS_MAX * sizeof *j->findings);
    if (j->findings == NULL) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the findings.");
    }
    options.findings = j->findings;
    options.finding_capacity = FINDINGS_MAX;
    progress_phase("checking");
    sf_status status =
        sf_grid_check(p->grid, &options, NULL, &job->task, &j->counts, &j->finding_count);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "the check", EXIT_INPUT);
    }
    exit_status priced = price(job, p, j);
    return priced == EXIT_GOOD ? hollows_find(job, p, &j->hollows) : priced;
}

void judgement_release(judgement *j)
{
    free(j->findings);
    free(j->costs);
    free(j->order);
    hollows_release(&j->hollows);
    memset(j, 0, sizeof *j);
}

// ---------------------------------------------------------------------------------------------
// Fields
// ---------------------------------------------------------------------------------------------

static const char *kind_name(sf_finding_kind kind)
{
    return kind == SF_FINDING_ISLAND ? "island" : "overhang";
}

static void report_finding(report *r, const sf_lattice *lattice, const judgement *j, size_t index,
                           uint32_t rank)
{
    const sf_finding *f = &j->findings[index];
    const sf_finding_cost *cost = &j->costs[index];
    double low[3], high[3];
    place_of_box(lattice, &f->box, low, high);
    report_begin(r, NULL);
    report_text(r, "kind", kind_name(f->kind));
    report_count(r, "layer", f->layer);
    report_number(r, "z_mm", sf_lattice_layer_bottom(lattice, f->layer));
    report_count(r, "area_voxels", f->area);
    report_number(r, "area_mm2", (double)f->area * lattice->pitch_x_mm * lattice->pitch_y_mm);
    report_count(r, "volume_voxels", f->volume);
    report_numbers(r, "low_mm", low, 3);
    report_numbers(r, "high_mm", high, 3);
    if (f->cause == SF_FINDING_ROOT) {
        report_null(r, "cause");
    } else {
        report_count(r, "cause", f->cause);
    }
    report_count(r, "trim_voxels", cost->trim_voxels);
    if (cost->grow_voxels == SF_COST_NONE) {
        report_null(r, "grow_voxels");
    } else {
        report_count(r, "grow_voxels", cost->grow_voxels);
    }
    report_count(r, "rank", rank);
    report_end(r);
}

// The findings, each with its place in the order. ranks[]: that order turned round.
static void report_findings(report *r, const sf_lattice *lattice, const judgement *j,
                            uint32_t *ranks)
{
    for (size_t i = 0; i < j->finding_count; i++) {
        ranks[j->order[i]] = (uint32_t)i;
    }
    report_begin_list(r, "findings");
    for (size_t i = 0; i < j->finding_count; i++) {
        report_finding(r, lattice, j, i, ranks[i]);
    }
    report_end(r);
}

static void report_fields(report *r, const sf_lattice *lattice, const judgement *j)
{
    const sf_check_report *c = &j->counts;
    report_count(r, "solid_voxels", c->solid_voxels);
    report_count(r, "unsupported_voxels", c->unsupported_voxels);
    report_count(r, "trimmed_voxels", c->trimmed_voxels);
    report_count(r, "island_count", c->island_count);
    report_count(r, "overhang_count", c->overhang_count);
    report_flag(r, "support_free", c->support_free);
    report_findings(r, lattice, j, j->ranks);
    report_count(r, "findings_dropped", c->findings_dropped);
}

// ---------------------------------------------------------------------------------------------
// Sentences
// ---------------------------------------------------------------------------------------------

static void say_finding(report *r, const sf_lattice *lattice, const judgement *j, size_t index,
                        double voxel_mm3)
{
    const sf_finding *f = &j->findings[index];
    uint64_t grow = j->costs[index].grow_voxels;
    char fix[64] = "";
    char where[PLACE_WORDS_SIZE], volume[DESCRIBE_MM3_SIZE], below[DESCRIBE_MM3_SIZE];
    if (grow != SF_COST_NONE) {
        snprintf(fix, sizeof fix, "; %s below would hold it",
                 describe_mm3((double)grow * voxel_mm3, below));
    }
    place_words(lattice, &f->box, 1, where);
    report_say(r, "  %-8s from %s: %s cannot print%s", kind_name(f->kind), where,
               describe_mm3((double)f->volume * voxel_mm3, volume), fix);
}

// The findings that cost most to fix, one by one, and the others in one line.
static void say_findings(report *r, const sf_lattice *lattice, const judgement *j, double voxel_mm3,
                         size_t most)
{
    const sf_check_report *c = &j->counts;
    size_t count = j->finding_count < most ? j->finding_count : most;
    uint64_t rest = c->island_count + c->overhang_count - count, said = 0;
    for (size_t i = 0; i < count; i++) {
        say_finding(r, lattice, j, j->order[i], voxel_mm3);
        said += j->findings[j->order[i]].volume;
    }
    if (rest > 0) {
        char together[DESCRIBE_MM3_SIZE];
        report_say(r, "  and %llu that cost%s less, %s together (--json lists %s)",
                   (unsigned long long)rest, rest == 1 ? "s" : "",
                   describe_mm3((double)(c->trimmed_voxels - said) * voxel_mm3, together),
                   c->findings_dropped > 0 ? "65536" : "all");
    }
}

static void say_verdict(report *r, const sf_check_report *c)
{
    if (c->support_free) {
        report_say(r, "It prints without supports.");
        return;
    }
    report_say(r,
               "It does not print without supports: %llu overhang%s and %llu island%s; %.3g %% "
               "of its matter cannot print.",
               (unsigned long long)c->overhang_count, c->overhang_count == 1 ? "" : "s",
               (unsigned long long)c->island_count, c->island_count == 1 ? "" : "s",
               100.0 * (double)c->trimmed_voxels / (double)c->solid_voxels);
}

void judgement_report(cli_job *job, const part *p, const judgement *j, size_t said)
{
    report *r = job->report;
    sf_lattice lattice = sf_grid_lattice(p->grid);
    report_fields(r, &lattice, j);
    report_number(r, "volume_mm3", describe_volume(p->grid));
    say_verdict(r, &j->counts);
    say_findings(r, &lattice, j, place_voxel_mm3(p->grid), said);
    hollows_report(job, p, &j->hollows);
}
