// SPDX-License-Identifier: MIT
// sf refine and sf tetra: a cage after some steps, as cells or as tetrahedra. sf exchange:
// tetrahedra from one format to another.

#include "cages.h"
#include "describe.h"
#include "solids.h"
#include "tets_write.h"
#include "verbs.h"

#include <stdio.h>
#include <string.h>

static exit_status refine(cli_job *job, const sf_cage *cage, sf_refinement **refinement)
{
    sf_refine_options how = sf_refine_options_default();
    how.steps = job->options.steps;
    how.rules = job->options.given & OPTION_SEPARABLE ? SF_REFINE_SEPARABLE : SF_REFINE_STANDARD;
    sf_status status = sf_refine(cage, &how, NULL, &job->task, refinement);
    if (status == SF_ERR_OVERFLOW || status == SF_ERR_MEMORY) {
        return job_fail(
            job, EXIT_RESOURCE,
            "There is no memory for %u steps: each makes eight times as many cells; take "
            "fewer --steps.",
            job->options.steps);
    }
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, NULL, job->options.input, EXIT_INPUT);
}

static void report_head(cli_job *job, const char *verb, const sf_cage *cage)
{
    report_text(job->report, "verb", verb);
    report_text(job->report, "input", job->options.input);
    report_count(job->report, "steps", job->options.steps);
    cages_report(job, cage);
}

static exit_status write_refined(cli_job *job, const sf_cage *cage, const sf_refinement *r)
{
    sf_cage_view view;
    sf_status got = sf_refinement_get_view(r, job->options.steps, &view);
    exit_status status = got == SF_OK ? tets_write_cage(job, &view, job->options.output)
                                      : job_fail_call(job, got, NULL, "step", EXIT_INPUT);
    if (status == EXIT_GOOD) {
        report_head(job, "refine", cage);
        report_count(job->report, "refined_points", view.point_count);
        report_count(job->report, "refined_cells", view.cell_count);
        report_text(job->report, "output", job->options.output);
        report_say(job->report, "%s: %zu cells are %zu after %u step%s, of %zu points.",
                   job->options.input, sf_cage_get_view(cage).cell_count, view.cell_count,
                   job->options.steps, job->options.steps == 1 ? "" : "s", view.point_count);
        report_say(job->report, "Written to %s.", job->options.output);
    }
    return status;
}

// The cell of the cage that a cell of a step came of.
static size_t cell_of(const sf_cage *cage, size_t cell, uint32_t steps)
{
    sf_cage_view view = sf_cage_get_view(cage);
    size_t found = 0, piece = cell >> 3 * (steps - 1);
    while (found + 1 < view.cell_count && view.starts[found + 1] <= piece) {
        found++;
    }
    return found;
}

static exit_status check_tets(cli_job *job, const sf_cage *cage, const sf_tets *tets,
                              sf_tets_report *found)
{
    sf_status status = sf_tets_check(tets, NULL, found);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, job->options.input, EXIT_INPUT);
    }
    if (found->inverted > 0) {
        return job_fail(job, EXIT_PROPERTY,
                        "%zu tetrahedra are inverted, the first of them in cell %zu of the cage; "
                        "straighten it, or take another step.",
                        found->inverted,
                        cell_of(cage, found->first_inverted / 6, job->options.steps));
    }
    return EXIT_GOOD;
}

static exit_status write_tets(cli_job *job, const sf_cage *cage, const sf_refinement *r)
{
    sf_tets *tets = NULL;
    sf_tets_report found;
    char volume[DESCRIBE_MM3_SIZE];
    sf_status got = sf_tets_of_refinement(r, job->options.steps, NULL, &tets);
    exit_status status =
        got == SF_OK ? check_tets(job, cage, tets, &found)
        : got == SF_ERR_UNSUPPORTED
            ? job_fail(job, EXIT_INPUT, "%s is a surface, and has no inside.", job->options.input)
            : job_fail_call(job, got, NULL, job->options.input, EXIT_INPUT);
    if (status == EXIT_GOOD) {
        status = tets_write(job, tets, job->options.output);
    }
    if (status == EXIT_GOOD) {
        sf_tets_view view = sf_tets_get_view(tets);
        report_head(job, "tetra", cage);
        report_count(job->report, "tetrahedra", view.tet_count);
        report_count(job->report, "points", view.point_count);
        report_number(job->report, "volume_mm3", found.volume_mm3);
        report_text(job->report, "output", job->options.output);
        report_say(job->report, "%s: %zu tetrahedra of %zu points after %u step%s; %s.",
                   job->options.input, view.tet_count, view.point_count, job->options.steps,
                   job->options.steps == 1 ? "" : "s", describe_mm3(found.volume_mm3, volume));
        report_say(job->report, "Written to %s.", job->options.output);
    }
    sf_tets_destroy(tets);
    return status;
}

static exit_status run(cli_job *job, int tetrahedra)
{
    sf_cage *cage = NULL;
    sf_refinement *r = NULL;
    exit_status status = tets_check_output(job, tetrahedra);
    if (status == EXIT_GOOD) {
        status = cages_read(job, &cage);
    }
    if (status == EXIT_GOOD) {
        status = refine(job, cage, &r);
    }
    if (status == EXIT_GOOD) {
        status = tetrahedra ? write_tets(job, cage, r) : write_refined(job, cage, r);
    }
    if (status == EXIT_GOOD) {
        report_number(job->report, "seconds", job_seconds(job));
    }
    sf_refinement_destroy(r);
    sf_cage_destroy(cage);
    return status;
}

exit_status verb_refine(cli_job *job)
{
    return run(job, 0);
}

exit_status verb_tetra(cli_job *job)
{
    return run(job, 1);
}

exit_status verb_exchange(cli_job *job)
{
    solid_input s = {NULL, NULL};
    exit_status status = tets_check_output(job, 1);
    if (status == EXIT_GOOD) {
        status = solids_read(job, &s);
    }
    if (status == EXIT_GOOD && s.tets == NULL) {
        status = job_fail(job, EXIT_INPUT, "%s holds a cage; 'sf tetra' makes tetrahedra of it.",
                          job->options.input);
    }
    if (status == EXIT_GOOD) {
        status = tets_write(job, s.tets, job->options.output);
    }
    if (status == EXIT_GOOD) {
        report_text(job->report, "verb", "exchange");
        report_text(job->report, "input", job->options.input);
        solids_report(job, &s);
        report_text(job->report, "output", job->options.output);
        report_say(job->report, "%s: %zu tetrahedra, written to %s.", job->options.input,
                   sf_tets_get_view(s.tets).tet_count, job->options.output);
        report_number(job->report, "seconds", job_seconds(job));
    }
    solids_release(&s);
    return status;
}
