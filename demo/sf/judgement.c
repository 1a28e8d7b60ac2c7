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
    sf_lattice lattice = part_lattice(p);
    sf_terms terms = part_terms(p);
    double mib = 2.0 * lattice.nx * lattice.ny * lattice.nz / 1048576;
    size_t room = j->finding_count > 0 ? j->finding_count : 1;
    j->costs = malloc(room * sizeof *j->costs);
    j->order = malloc(2 * room * sizeof *j->order);
    if (j->costs == NULL || j->order == NULL) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the costs.");
    }
    j->ranks = j->order + room;
    j->priced = p->grid != NULL && mib <= job->options.memory_mib;
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

exit_status judgement_begin(cli_job *job, judgement *j)
{
    memset(j, 0, sizeof *j);
    j->findings = malloc(JUDGEMENT_FINDINGS_MAX * sizeof *j->findings);
    return j->findings != NULL
               ? EXIT_GOOD
               : job_fail(job, EXIT_RESOURCE, "There is no memory for the findings.");
}

exit_status judgement_settle(cli_job *job, const part *p, judgement *j)
{
    exit_status done = price(job, p, j);
    return done == EXIT_GOOD ? groups_make(job, j->findings, j->costs, j->finding_count, &j->groups)
                             : done;
}

exit_status judge(cli_job *job, const part *p, judgement *j)
{
    sf_check_options options = how_to_check(p);
    exit_status done = judgement_begin(job, j);
    if (done != EXIT_GOOD) {
        return done;
    }
    options.findings = j->findings;
    options.finding_capacity = JUDGEMENT_FINDINGS_MAX;
    progress_phase("checking");
    sf_status status =
        sf_grid_check(p->grid, &options, NULL, &job->task, &j->counts, &j->finding_count);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "the check", EXIT_INPUT);
    }
    done = judgement_settle(job, p, j);
    return done == EXIT_GOOD ? hollows_find(job, p, &j->hollows) : done;
}

void judgement_release(judgement *j)
{
    free(j->findings);
    free(j->costs);
    free(j->order);
    groups_release(&j->groups);
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

static void report_finding(report *r, const places *in, const judgement *j, size_t index,
                           uint32_t rank)
{
    const sf_finding *f = &j->findings[index];
    const sf_finding_cost *cost = &j->costs[index];
    double low[3], high[3];
    place_box(in, &f->box, low, high);
    report_begin(r, NULL);
    report_text(r, "kind", kind_name(f->kind));
    report_count(r, "layer", f->layer);
    report_number(r, "height_mm", sf_lattice_layer_bottom(&in->lattice, f->layer));
    report_count(r, "area_voxels", f->area);
    report_number(r, "area_mm2", (double)f->area * in->lattice.pitch_x_mm * in->lattice.pitch_y_mm);
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
static void report_findings(report *r, const places *in, const judgement *j, uint32_t *ranks)
{
    for (size_t i = 0; i < j->finding_count; i++) {
        ranks[j->order[i]] = (uint32_t)i;
    }
    report_begin_list(r, "findings");
    for (size_t i = 0; i < j->finding_count; i++) {
        report_finding(r, in, j, i, ranks[i]);
    }
    report_end(r);
}

// What the sentences count.
static void report_groups(report *r, const groups *g)
{
    report_begin(r, "places");
    report_count(r, "overhangs", groups_count(g, SF_FINDING_OVERHANG));
    report_count(r, "islands", groups_count(g, SF_FINDING_ISLAND));
    report_begin(r, "crumbs");
    report_count(r, "most_voxels", g->crumb_most);
    report_count(r, "count", g->crumbs[0] + g->crumbs[1]);
    report_count(r, "voxels", g->crumb_voxels);
    report_end(r);
    report_end(r);
}

static void report_fields(report *r, const places *in, const judgement *j)
{
    const sf_check_report *c = &j->counts;
    report_count(r, "solid_voxels", c->solid_voxels);
    report_count(r, "unsupported_voxels", c->unsupported_voxels);
    report_count(r, "trimmed_voxels", c->trimmed_voxels);
    report_count(r, "island_count", c->island_count);
    report_count(r, "overhang_count", c->overhang_count);
    report_flag(r, "support_free", c->support_free);
    report_findings(r, in, j, j->ranks);
    report_count(r, "findings_dropped", c->findings_dropped);
    report_groups(r, &j->groups);
}

// ---------------------------------------------------------------------------------------------
// Sentences
// ---------------------------------------------------------------------------------------------

static void say_group(report *r, const places *in, const groups *g, size_t index, double voxel_mm3)
{
    const sf_finding *f = &g->heads[index];
    uint64_t grow = g->costs[index].grow_voxels;
    char fix[64] = "";
    char where[PLACE_WORDS_SIZE], volume[DESCRIBE_MM3_SIZE], below[DESCRIBE_MM3_SIZE];
    if (grow != SF_COST_NONE) {
        snprintf(fix, sizeof fix, "; %s below would hold it",
                 describe_mm3((double)grow * voxel_mm3, below));
    }
    place_words(in, &f->box, 1, where);
    report_say(r, "  %-8s from %s: %s cannot print%s", kind_name(f->kind), where,
               describe_mm3((double)f->volume * voxel_mm3, volume), fix);
}

// "812 places of at most 3 voxels"; empty where there are none.
enum { WORDS_SIZE = 64 };
static void name_crumbs(const groups *g, char words[WORDS_SIZE])
{
    uint64_t count = g->crumbs[0] + g->crumbs[1];
    words[0] = '\0';
    if (count > 0) {
        snprintf(words, WORDS_SIZE, "%llu place%s of at most %u voxel%s", (unsigned long long)count,
                 count == 1 ? "" : "s", g->crumb_most, g->crumb_most == 1 ? "" : "s");
    }
}

// Those that were not said, in one line: `rest` and crumbs.
static void say_others(report *r, const groups *g, double voxel_mm3, uint64_t rest,
                       uint64_t rest_voxels, const char *all)
{
    char less[96] = "", few[128] = "", crumbs[WORDS_SIZE], volume[DESCRIBE_MM3_SIZE];
    name_crumbs(g, crumbs);
    if (rest > 0) {
        snprintf(less, sizeof less, "and %llu that cost%s less, %s together%s",
                 (unsigned long long)rest, rest == 1 ? "s" : "",
                 describe_mm3((double)rest_voxels * voxel_mm3, volume),
                 crumbs[0] != '\0' ? ", " : "");
    }
    if (crumbs[0] != '\0') {
        snprintf(few, sizeof few, "and %s, %s together", crumbs,
                 describe_mm3((double)g->crumb_voxels * voxel_mm3, volume));
    }
    report_say(r, "  %s%s (--json lists %s)", less, few, all);
}

// The places that cost most to fix, one by one, and the others in one line.
static void say_groups(report *r, const places *in, const judgement *j, double voxel_mm3,
                       size_t most)
{
    const sf_check_report *c = &j->counts;
    const groups *g = &j->groups;
    uint64_t said = 0, said_voxels = 0;
    for (size_t i = 0; i < g->count && said < most; i++) {
        if (!groups_is_crumb(g, g->order[i])) {
            say_group(r, in, g, g->order[i], voxel_mm3);
            said_voxels += g->heads[g->order[i]].volume;
            said++;
        }
    }
    uint64_t others = groups_count(g, SF_FINDING_OVERHANG) + groups_count(g, SF_FINDING_ISLAND) +
                      c->findings_dropped;
    // Where there are crumbs only, the verdict has said it.
    if (others > said || (said > 0 && g->crumb_voxels > 0)) {
        say_others(r, g, voxel_mm3, others - said,
                   c->trimmed_voxels - g->crumb_voxels - said_voxels,
                   c->findings_dropped > 0 ? "65536" : "all");
    }
}

static const char *name_count(uint64_t count, const char *name, char words[WORDS_SIZE])
{
    words[0] = '\0';
    if (count > 0) {
        snprintf(words, WORDS_SIZE, "%llu %s%s", (unsigned long long)count, name,
                 count == 1 ? "" : "s");
    }
    return words;
}

static void say_verdict(report *r, const judgement *j, double voxel_mm3)
{
    const sf_check_report *c = &j->counts;
    char words[4][WORDS_SIZE], list[4 * WORDS_SIZE + 24] = "", hangs[DESCRIBE_MM3_SIZE];
    if (c->support_free) {
        report_say(r, "It prints without supports.");
        return;
    }
    name_count(groups_count(&j->groups, SF_FINDING_OVERHANG), "overhang", words[0]);
    name_count(groups_count(&j->groups, SF_FINDING_ISLAND), "island", words[1]);
    name_count(c->findings_dropped, "further region", words[2]);
    name_crumbs(&j->groups, words[3]);
    for (int i = 0, left = 0; i < 4; i++, left = 0) {
        for (int k = i + 1; k < 4; k++) {
            left += words[k][0] != '\0';
        }
        size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s", words[i],
                 words[i][0] == '\0' || left == 0 ? ""
                 : left == 1                      ? " and "
                                                  : ", ");
    }
    report_say(r,
               "It does not print without supports: %s; %s hang in the air, and with what rests on "
               "them %.3g %% of its matter cannot print.",
               list, describe_mm3((double)c->unsupported_voxels * voxel_mm3, hangs),
               100.0 * (double)c->trimmed_voxels / (double)c->solid_voxels);
}

void judgement_report(cli_job *job, const part *p, const judgement *j, int is_brief)
{
    int is_hollow = j->hollows.counts.trap_count + j->hollows.counts.cup_count > 0;
    size_t most = !is_brief ? 4 : is_hollow ? 1 : 2;
    report *r = job->report;
    places in = {part_lattice(p), job->options.up};
    report_fields(r, &in, j);
    report_number(r, "volume_mm3", part_volume_mm3(p));
    say_verdict(r, j, part_voxel_mm3(p));
    say_groups(r, &in, j, part_voxel_mm3(p), most);
    hollows_report(job, p, &j->hollows);
    hollows_say(job, p, &j->hollows, is_brief);
}
