// SPDX-License-Identifier: MIT
// Where a model comes to rest that is put down, and left alone.

#include "stand_rest.h"

#include "stand_feet.h"
#include "stand_say.h"
#include "turned.h"

#define DEGREES (180 / 3.14159265358979323846)

static void say(const cli_job *job, const model *m, const double com[3], const sf_rest *rest)
{
    double up[3], asked[3], build[3], there[3];
    char from[STAND_DIRECTION_SIZE], to[STAND_DIRECTION_SIZE], way[STAND_DIRECTION_SIZE];
    report *r = job->report;
    turned_axis(m->up, asked);
    turned_axis(job->options.up, build);
    turned_to_input(job, rest->up, up);
    turned_to_input(job, com, there);
    report_text(r, "verb", "stand");
    report_text(r, "input", job->options.input);
    report_text(r, "up", stand_direction(asked, from));
    report_text(r, "build", stand_direction(build, way));
    report_numbers(r, "com_mm", there, 3);
    report_begin(r, "rest");
    report_numbers(r, "up", up, 3);
    report_number(r, "tilt_deg", rest->tilt_rad * DEGREES);
    report_number(r, "height_mm", rest->height_mm);
    report_number(r, "margin_deg", rest->margin_rad * DEGREES);
    report_count(r, "contacts", rest->contact_count);
    report_count(r, "turns", rest->turn_count);
    report_end(r);
    if (rest->turn_count == 0) {
        report_say(r, "%s: put down with %s up it stays as it is.", job->options.input, from);
    } else {
        report_say(r,
                   "%s: put down with %s up it tips over, %llu time%s, and comes to rest with %s "
                   "up, %.1f degrees from where it was.",
                   job->options.input, from, (unsigned long long)rest->turn_count,
                   rest->turn_count == 1 ? "" : "s", stand_direction(up, to),
                   rest->tilt_rad * DEGREES);
    }
    report_say(r,
               "There it lies on %llu corners, its centre of mass %.4g mm above the ground, and "
               "stays until the ground tilts by %.2f degrees.",
               (unsigned long long)rest->contact_count, rest->height_mm,
               rest->margin_rad * DEGREES);
}

exit_status stand_rest(cli_job *job, const model *m)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    double com[3], axis_up[3], up[3];
    sf_rest rest;
    turned_axis(m->up, axis_up);
    turned_to_build(job, axis_up, up);
    sf_status status = stand_weigh(job, m, com);
    if (status == SF_OK) {
        status = sf_mesh_rest(sf_mesh_get_view(m->part.mesh), com, up, 1, NULL, &rest, &fault);
    }
    if (status != SF_OK) {
        return job_fail_call(job, status, &fault, job->options.input, EXIT_INPUT);
    }
    say(job, m, com, &rest);
    report_number(job->report, "seconds", job_seconds(job));
    return EXIT_GOOD;
}
