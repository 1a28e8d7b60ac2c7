// SPDX-License-Identifier: MIT
// sf check: does it print without supports, and where not? If asked, how steep is it, and does it
// topple while it is printed?

#include "describe.h"
#include "judgement.h"
#include "place.h"
#include "print_job.h"
#include "progress.h"
#include "verbs.h"

#include <stdlib.h>

#define DEGREES (180 / 3.14159265358979323846)

static void say_steepest(report *r, const places *in, const sf_steepest *s)
{
    char where[PLACE_WORDS_SIZE];
    place_words(in, &s->box, 0, where);
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
    places in = {sf_grid_lattice(p->grid), job->options.up};
    sf_steepest s;
    double low[3], high[3];
    progress_phase("looking for the steepest overhang");
    sf_status status = sf_grid_steepest(p->grid, p->bed_layer, NULL, &job->task, &s);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "--steepest", EXIT_INPUT);
    }
    place_box(&in, &s.box, low, high);
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
    say_steepest(r, &in, &s);
    return EXIT_GOOD;
}

static void say_printing(report *r, const places *in, const sf_printing_report *found)
{
    char where[PLACE_WORDS_SIZE];
    double degrees = found->margin_rad * DEGREES;
    if (found->layer == SF_BED_AUTO) {
        report_say(r, "Nothing of it stands on the bed.");
        return;
    }
    sf_box top = found->piece;
    top.z0 = found->layer;
    top.z1 = found->layer + 1;
    place_words(in, &top, 0, where);
    if (found->margin_rad < 0) {
        report_say(r,
                   "It would topple while it is printed, were it not stuck to the bed: after %u "
                   "layer%s a piece leans beyond its base, the worst by %.1f degrees, with its top "
                   "at %s.",
                   found->toppling_layers, found->toppling_layers == 1 ? "" : "s", -degrees, where);
    } else {
        report_say(r,
                   "It stands while it is printed: the piece nearest to falling would take a tilt "
                   "of %.1f degrees, with its top at %s.",
                   degrees, where);
    }
    if (found->floating_count > 0) {
        report_say(r, "%llu of its pieces begin%s in the air, and %s left out of that.",
                   (unsigned long long)found->floating_count, found->floating_count == 1 ? "s" : "",
                   found->floating_count == 1 ? "is" : "are");
    }
}

static void report_point(report *r, axis up, const char *key, const double at[3])
{
    double there[3];
    place_point(up, at, there);
    report_numbers(r, key, there, 3);
}

static void report_printing(report *r, const places *in, const sf_printing_report *found,
                            double *margins)
{
    double low[3], high[3];
    report_begin(r, "printing");
    report_flag(r, "topples", found->margin_rad < 0);
    report_number(r, "margin_deg", found->margin_rad * DEGREES);
    report_count(r, "toppling_layers", found->toppling_layers);
    report_count(r, "floating_pieces", found->floating_count);
    report_count(r, "standing_pieces", found->standing_count);
    if (found->layer != SF_BED_AUTO) {
        place_box(in, &found->piece, low, high);
        report_count(r, "layer", found->layer);
        report_number(r, "height_mm", sf_lattice_layer_bottom(&in->lattice, found->layer + 1));
        report_numbers(r, "low_mm", low, 3);
        report_numbers(r, "high_mm", high, 3);
        report_point(r, in->up, "com_mm", found->com_mm);
        report_point(r, in->up, "edge_from_mm", found->edge_mm[0]);
        report_point(r, in->up, "edge_to_mm", found->edge_mm[1]);
    }
    for (uint32_t k = 0; k < in->lattice.nz; k++) {
        margins[k] *= DEGREES;
    }
    report_numbers(r, "margins_deg", margins, in->lattice.nz);
    report_end(r);
    say_printing(r, in, found);
}

// Whether it stands after each of its layers; `topples` says so.
static exit_status look_at_printing(cli_job *job, const part *p, int *topples)
{
    places in = {sf_grid_lattice(p->grid), job->options.up};
    sf_printing_options options = sf_printing_options_default();
    sf_printing_report found;
    options.bed_layer = p->bed_layer;
    options.margin_capacity = in.lattice.nz;
    options.margins_rad = malloc(in.lattice.nz * sizeof *options.margins_rad);
    if (options.margins_rad == NULL) {
        return job_fail_call(job, SF_ERR_MEMORY, NULL, "--printing", EXIT_INPUT);
    }
    progress_phase("looking whether it topples");
    sf_status status = sf_grid_printing(p->grid, &options, NULL, &job->task, &found);
    if (status == SF_OK) {
        *topples = found.margin_rad < 0;
        report_printing(job->report, &in, &found, options.margins_rad);
    }
    free(options.margins_rad);
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, NULL, "--printing", EXIT_INPUT);
}

static exit_status check(cli_job *job, part *p)
{
    judgement j;
    int topples = 0;
    // A job passes by, unless something is asked that takes all of it at once.
    int passes = p->layers != NULL && !job->options.steepest && !job->options.printing;
    exit_status status = passes ? EXIT_GOOD : part_voxelize(job, p);
    if (status == EXIT_GOOD) {
        status = part_make_rule(job, p);
    }
    if (status != EXIT_GOOD) {
        return status;
    }
    describe_part(job, p, "check");
    status = passes ? print_job_judge(job, p, &j) : judge(job, p, &j);
    if (status == EXIT_GOOD) {
        judgement_report(job, p, &j, 0);
        status = job->options.steepest ? look_for_steepest(job, p) : EXIT_GOOD;
    }
    if (status == EXIT_GOOD && job->options.printing) {
        status = look_at_printing(job, p, &topples);
    }
    if (status == EXIT_GOOD) {
        report_number(job->report, "seconds", job_seconds(job));
        status = j.counts.support_free && !topples ? EXIT_GOOD : EXIT_PROPERTY;
    }
    judgement_release(&j);
    return status;
}

exit_status verb_check(cli_job *job)
{
    part p;
    exit_status status = part_open(job, &p);
    if (status == EXIT_GOOD) {
        status = check(job, &p);
    }
    part_release(&p);
    return status;
}
