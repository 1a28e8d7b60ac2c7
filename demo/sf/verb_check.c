// SPDX-License-Identifier: MIT
// sf check: does it print without supports, and where not?

#include "describe.h"
#include "judgement.h"
#include "place.h"
#include "progress.h"
#include "verbs.h"

#define DEGREES (180 / 3.14159265358979323846)

static void say_steepest(report *r, const sf_lattice *lattice, const sf_steepest *s)
{
    char where[PLACE_WORDS_SIZE];
    place_words(lattice, &s->box, 0, where);
    if (!s->is_bounded) {
        report_say(r, "It would print at no angle: even at %.0f degrees something hangs at %s.",
                   s->angle_rad * DEGREES, where);
    } else if (s->layer == SF_BED_AUTO) {
        report_say(r, "Nothing of it leans by more than %.1f degrees from the vertical.",
                   s->angle_rad * DEGREES);
    } else {
        report_say(r, "Its steepest overhang is %.1f degrees from the vertical, at %s.",
                   s->angle_rad * DEGREES, where);
    }
}

static exit_status look_for_steepest(cli_job *job, const part *p)
{
    report *r = job->report;
    sf_lattice lattice = sf_grid_lattice(p->grid);
    sf_steepest s;
    double low[3], high[3];
    progress_phase("looking for the steepest overhang");
    sf_status status = sf_grid_steepest(p->grid, p->bed_layer, NULL, &job->task, &s);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "--steepest", EXIT_INPUT);
    }
    place_of_box(&lattice, &s.box, low, high);
    if (s.is_bounded) {
        report_number(r, "steepest_deg", s.angle_rad * DEGREES);
    } else {
        report_null(r, "steepest_deg");
    }
    if (s.layer != SF_BED_AUTO) {
        report_begin(r, "steepest_box_mm");
        report_numbers(r, "low", low, 3);
        report_numbers(r, "high", high, 3);
        report_end(r);
    }
    say_steepest(r, &lattice, &s);
    return EXIT_GOOD;
}

static exit_status check(cli_job *job, part *p)
{
    judgement j;
    exit_status status = part_voxelize(job, p);
    if (status == EXIT_GOOD) {
        status = part_make_rule(job, p);
    }
    if (status != EXIT_GOOD) {
        return status;
    }
    describe_part(job, p, "check");
    status = judge(job, p, &j);
    if (status == EXIT_GOOD) {
        judgement_report(job, p, &j, 0);
        status = job->options.steepest ? look_for_steepest(job, p) : EXIT_GOOD;
    }
    if (status == EXIT_GOOD) {
        report_number(job->report, "seconds", job_seconds(job));
        status = j.counts.support_free ? EXIT_GOOD : EXIT_PROPERTY;
    }
    judgement_release(&j);
    return status;
}

exit_status verb_check(cli_job *job)
{
    part p;
    exit_status status = part_read(job, &p);
    if (status == EXIT_GOOD) {
        status = check(job, &p);
    }
    part_release(&p);
    return status;
}
