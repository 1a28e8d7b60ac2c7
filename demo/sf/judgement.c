// SPDX-License-Identifier: MIT
// Does the part print without supports, and where not?

#include "judgement.h"

#include "describe.h"
#include "progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FINDINGS_MAX = 65536, FINDINGS_SAID = 4 };

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
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, NULL, "the check", EXIT_INPUT);
}

void judgement_release(judgement *j)
{
    free(j->findings);
    j->findings = NULL;
}

// ---------------------------------------------------------------------------------------------
// Fields
// ---------------------------------------------------------------------------------------------

// Corners of a box of voxels in build axes, mm.
static void box_corners(const sf_lattice *lattice, const sf_box *box, double low[3], double high[3])
{
    low[0] = lattice->origin_mm[0] + box->x0 * lattice->pitch_x_mm;
    low[1] = lattice->origin_mm[1] + box->y0 * lattice->pitch_y_mm;
    low[2] = sf_lattice_layer_bottom(lattice, box->z0);
    high[0] = lattice->origin_mm[0] + box->x1 * lattice->pitch_x_mm;
    high[1] = lattice->origin_mm[1] + box->y1 * lattice->pitch_y_mm;
    high[2] = sf_lattice_layer_bottom(lattice, box->z1);
}

static const char *kind_name(sf_finding_kind kind)
{
    return kind == SF_FINDING_ISLAND ? "island" : "overhang";
}

static void report_finding(report *r, const sf_lattice *lattice, const sf_finding *f)
{
    double low[3], high[3];
    box_corners(lattice, &f->box, low, high);
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
    report_begin_list(r, "findings");
    for (size_t i = 0; i < j->finding_count; i++) {
        report_finding(r, lattice, &j->findings[i]);
    }
    report_end(r);
    report_count(r, "findings_dropped", c->findings_dropped);
}

// ---------------------------------------------------------------------------------------------
// Sentences
// ---------------------------------------------------------------------------------------------

// The findings that cost most, their numbers in `chosen`; returns how many.
static size_t choose_largest(const judgement *j, size_t chosen[FINDINGS_SAID])
{
    size_t count = 0;
    for (size_t i = 0; i < j->finding_count; i++) {
        size_t at = count < FINDINGS_SAID ? count++ : FINDINGS_SAID;
        while (at > 0 && j->findings[chosen[at - 1]].volume < j->findings[i].volume) {
            if (at < FINDINGS_SAID) {
                chosen[at] = chosen[at - 1];
            }
            at--;
        }
        if (at < FINDINGS_SAID) {
            chosen[at] = i;
        }
    }
    return count;
}

static void say_finding(report *r, const sf_lattice *lattice, const sf_finding *f, double voxel_mm3)
{
    double low[3], high[3];
    char volume[DESCRIBE_MM3_SIZE];
    box_corners(lattice, &f->box, low, high);
    report_say(r, "  %-8s from z = %7.2f mm, x %.1f to %.1f, y %.1f to %.1f: %s cannot print",
               kind_name(f->kind), sf_lattice_layer_bottom(lattice, f->layer), low[0], high[0],
               low[1], high[1], describe_mm3((double)f->volume * voxel_mm3, volume));
}

void judgement_report(cli_job *job, const part *p, const judgement *j)
{
    report *r = job->report;
    sf_lattice lattice = sf_grid_lattice(p->grid);
    const sf_check_report *c = &j->counts;
    double volume = describe_volume(p->grid), voxel_mm3 = 0;
    report_fields(r, &lattice, j);
    report_number(r, "volume_mm3", volume);
    if (c->support_free) {
        report_say(r, "It prints without supports.");
        return;
    }
    voxel_mm3 = c->solid_voxels > 0 ? volume / (double)c->solid_voxels : 0;
    report_say(r,
               "It does not print without supports: %llu overhang%s and %llu island%s; %.3g %% "
               "of its matter cannot print.",
               (unsigned long long)c->overhang_count, c->overhang_count == 1 ? "" : "s",
               (unsigned long long)c->island_count, c->island_count == 1 ? "" : "s",
               100.0 * (double)c->trimmed_voxels / (double)c->solid_voxels);
    size_t chosen[FINDINGS_SAID], count = choose_largest(j, chosen);
    for (size_t i = 0; i < count; i++) {
        say_finding(r, &lattice, &j->findings[chosen[i]], voxel_mm3);
    }
    uint64_t rest = c->island_count + c->overhang_count - count, said = 0;
    for (size_t i = 0; i < count; i++) {
        said += j->findings[chosen[i]].volume;
    }
    if (rest > 0) {
        char together[DESCRIBE_MM3_SIZE];
        report_say(r, "  and %llu smaller one%s, %s together (--json lists %s)",
                   (unsigned long long)rest, rest == 1 ? "" : "s",
                   describe_mm3((double)(c->trimmed_voxels - said) * voxel_mm3, together),
                   c->findings_dropped > 0 ? "65536" : "all");
    }
}
