// SPDX-License-Identifier: MIT
// What there is to say of a model that was made to stand: does it, by how much, at what price; and
// where it does not, how far it came, and whether carving alone ever could.

#include "stand_say.h"

#include "describe.h"
#include "stand_drill.h"
#include "turned.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define ROUNDING 1e-9 // of the size: less than that is none
#define SUNK 1e-4     // of the size: less than that is close enough, as <sf/stand.h> says
#define STILL 3e-6    // the same for vertices: contacts are put onto one plane
#define DEGREES (180 / 3.14159265358979323846)

static const char *const kinds[] = {
    [SF_STANCE_STAND] = "stand", [SF_STANCE_HANG] = "hang", [SF_STANCE_ROCK] = "rock"};

const char *stand_direction(const double up[3], char words[STAND_DIRECTION_SIZE])
{
    for (int i = 0; i < 3; i++) {
        if (fabs(fabs(up[i]) - 1) < 1e-9) {
            snprintf(words, STAND_DIRECTION_SIZE, "%c%c", up[i] < 0 ? '-' : '+', "xyz"[i]);
            return words;
        }
    }
    double shown[3];
    for (int i = 0; i < 3; i++) {
        shown[i] = floor(up[i] * 1000 + 0.5) / 1000 + 0.0; // no -0.000
    }
    snprintf(words, STAND_DIRECTION_SIZE, "(%.3f, %.3f, %.3f)", shown[0], shown[1], shown[2]);
    return words;
}

// ---------------------------------------------------------------------------------------------
// Fields
// ---------------------------------------------------------------------------------------------

static void report_point(const cli_job *job, const char *key, const double at[3])
{
    double there[3];
    turned_to_input(job, at, there);
    report_numbers(job->report, key, there, 3);
}

static void report_polygon(const cli_job *job, const sf_stance *stance)
{
    size_t count = 0;
    (void)!sf_stance_polygon(stance, NULL, 0, &count);
    double *corners = malloc((3 * count + 1) * sizeof *corners);
    report_begin_list(job->report, "support_polygon_mm");
    if (corners != NULL && sf_stance_polygon(stance, corners, count, &count) == SF_OK) {
        for (size_t i = 0; i < count; i++) {
            report_point(job, NULL, corners + 3 * i);
        }
    }
    report_end(job->report);
    free(corners);
}

static void report_stance(const cli_job *job, const model *m, size_t index)
{
    const sf_stance *stance = sf_stand_stance(m->stand, index);
    sf_stance_options asked = sf_stance_get_options(stance);
    sf_stance_verdict verdict;
    report *r = job->report;
    report_begin(r, NULL);
    report_text(r, "kind", kinds[asked.kind]);
    report_point(job, "up", asked.up);
    if (asked.kind == SF_STANCE_STAND) {
        report_number(r, "gamma_deg", asked.gamma_rad * DEGREES);
    } else {
        report_number(r, "tolerance_deg", asked.tolerance_rad * DEGREES);
    }
    if (asked.kind == SF_STANCE_HANG) {
        report_point(job, "point_mm", asked.point_mm);
    }
    if (sf_stance_judge(stance, m->report.com_mm, &verdict) == SF_OK) {
        report_flag(r, "stands", verdict.stands);
        report_flag(r, "safe", verdict.safe);
        report_number(r, "margin_deg", verdict.margin_rad * DEGREES);
    }
    report_polygon(job, stance);
    report_end(r);
}

static void report_shape(const cli_job *job, const model *m)
{
    const sf_stand_report *done = &m->report;
    report *r = job->report;
    report_number(r, "mass", done->mass);
    report_number(r, "carved_mm3", done->carved_mm3);
    report_flag(r, "cavity_support_free", done->hanging_voxels == 0);
    report_count(r, "hanging_voxels", done->hanging_voxels);
    report_number(r, "wall_min_mm", m->wall_min_mm);
    report_number(r, "max_displacement_mm", m->moved_mm);
    report_number(r, "energy", done->energy);
    report_number(r, "least_det", done->least_det);
    report_count(r, "folds", done->folded);
    report_count(r, "overlap_voxels", done->overlap_voxels);
    report_number(r, "sunk_mm", done->sunk_mm);
}

// The axis of a rotation, as long as its angle in degrees.
static void turn_of(const double m[9], double turn[3])
{
    double twice[3] = {m[7] - m[5], m[2] - m[6], m[3] - m[1]}; // 2 sin(angle) axis
    double sine = 0.5 * sqrt(twice[0] * twice[0] + twice[1] * twice[1] + twice[2] * twice[2]);
    double angle = atan2(sine, 0.5 * (m[0] + m[4] + m[8] - 1));
    for (int d = 0; d < 3; d++) {
        turn[d] = sine > 0 ? 0.5 * twice[d] / sine * angle * DEGREES : 0;
    }
}

static void report_handles(const cli_job *job, const model *m)
{
    report *r = job->report;
    report_begin_list(r, "handles");
    for (size_t i = 0; i < m->handles.count; i++) {
        const sf_handle *handle = &m->handles.each[i];
        sf_pose pose = sf_stand_get_pose(m->stand, i);
        double turn[3];
        turn_of(pose.turn, turn);
        report_begin(r, NULL);
        report_text(r, "kind", handle->kind == SF_HANDLE_BALL ? "ball" : "point");
        report_point(job, "at_mm", handle->at_mm);
        report_flag(r, "locked", handle->locked);
        report_begin(r, "pose");
        report_number(r, "scale", pose.scale);
        report_point(job, "shift_mm", pose.shift_mm);
        report_point(job, "turn_deg", turn);
        report_end(r);
        report_end(r);
    }
    report_end(r);
}

static void report_axes(const cli_job *job, const model *m)
{
    double up[3], build[3];
    char words[STAND_DIRECTION_SIZE];
    turned_axis(m->up, up);
    turned_axis(job->options.up, build);
    report_text(job->report, "up", stand_direction(up, words));
    report_text(job->report, "build", stand_direction(build, words));
}

static int only_stands(const model *m)
{
    return m->stances.count == 1 && m->stances.each[0].kind == SF_STANCE_STAND;
}

// Where nothing is carved, and where it does more than stand, there is none.
static int has_bound(const model *m)
{
    return only_stands(m) && m->options.carve && m->report.bound_rad * DEGREES < 90 - 1e-9;
}

static void report_fields(const cli_job *job, const model *m)
{
    const sf_stand_report *done = &m->report;
    report *r = job->report;
    report_text(r, "verb", "stand");
    report_text(r, "input", job->options.input);
    report_axes(job, m);
    report_flag(r, "stands", done->stands);
    report_flag(r, "safe", done->safe);
    report_flag(r, "succeeded", model_holds(m));
    report_number(r, "margin_deg", done->margin_rad * DEGREES);
    report_number(r, "margin_before_deg", done->margin_before_rad * DEGREES);
    report_number(r, "margin_modelled_deg", m->modelled_rad * DEGREES);
    report_number(r, "flattened_mm", m->flattened_mm);
    if (has_bound(m)) {
        report_number(r, "bound_deg", done->bound_rad * DEGREES);
    } else {
        report_null(r, "bound_deg");
    }
    report_point(job, "com_mm", done->com_mm);
    report_point(job, "com_before_mm", done->com_before_mm);
    report_polygon(job, sf_stand_stance(m->stand, 0));
    report_count(r, "iterations", done->rounds);
    report_count(r, "steps", done->steps);
    report_number(r, "pitch_mm", m->options.pitch_mm);
    report_number(r, "wall_mm", m->options.wall_mm);
    report_shape(job, m);
    report_handles(job, m);
    report_begin_list(r, "stances");
    for (size_t i = 0; i < m->stances.count; i++) {
        report_stance(job, m, i);
    }
    report_end(r);
}

// ---------------------------------------------------------------------------------------------
// Sentences
// ---------------------------------------------------------------------------------------------

static void say_bound(const cli_job *job, const model *m)
{
    if (has_bound(m)) {
        report_say(job->report,
                   "No carving of the shape as it was given passes a margin of %.2f degrees.",
                   m->report.bound_rad * DEGREES);
    }
}

static void say_standing(const cli_job *job, const model *m)
{
    const sf_stand_report *done = &m->report;
    double margin = done->margin_rad * DEGREES, gamma = m->stances.each[0].gamma_rad * DEGREES;
    report *r = job->report;
    if (done->safe) {
        report_say(r, "It stands until the ground tilts by %.1f degrees; %g were asked for.",
                   margin, gamma);
    } else if (done->stands) {
        report_say(r,
                   "It stands, but not safely: only until the ground tilts by %.2f degrees, and %g "
                   "were asked for. That is the best that was found.",
                   margin, gamma);
        say_bound(job, m);
    } else {
        report_say(r,
                   "It cannot stand: the best margin that was found is %.2f degrees, which is "
                   "%.2f short of those %g that were asked for.",
                   margin, gamma - margin, gamma);
        say_bound(job, m);
    }
}

static void say_stances(const cli_job *job, const model *m)
{
    char way[STAND_DIRECTION_SIZE];
    for (size_t i = 0; i < m->stances.count; i++) {
        const sf_stance *stance = sf_stand_stance(m->stand, i);
        sf_stance_options asked = sf_stance_get_options(stance);
        sf_stance_verdict v;
        double up[3];
        turned_to_input(job, asked.up, up);
        if (sf_stance_judge(stance, m->report.com_mm, &v) != SF_OK) {
            continue;
        }
        stand_direction(up, way);
        if (asked.kind == SF_STANCE_STAND) {
            report_say(job->report, "With %s up it %s%s: the margin is %.2f degrees, of %g.", way,
                       v.stands ? "stands" : "falls", v.safe || !v.stands ? "" : ", not safely",
                       v.margin_rad * DEGREES, asked.gamma_rad * DEGREES);
        } else {
            report_say(job->report, "With %s up it %s %.2f degrees from that; %g are allowed.", way,
                       asked.kind == SF_STANCE_HANG ? "hangs" : "comes to rest",
                       -v.margin_rad * DEGREES, asked.tolerance_rad * DEGREES);
        }
    }
    if (!m->report.safe) {
        report_say(job->report, "It does not rest as it was asked to: this is the best that was "
                                "found.");
    }
}

static void say_price(const cli_job *job, const model *m)
{
    const sf_stand_report *done = &m->report;
    char volume[DESCRIBE_MM3_SIZE], inside[128] = "nothing carved out";
    char outside[96] = "the outside is as it was";
    if (isfinite(m->wall_min_mm)) {
        snprintf(inside, sizeof inside, "%s carved out, the wall at least %.4g mm",
                 describe_mm3(done->carved_mm3, volume), m->wall_min_mm);
    }
    if (m->moved_mm > STILL * m->size_mm) {
        if (m->options.carve && !isfinite(m->wall_min_mm)) {
            snprintf(inside, sizeof inside, "nothing left to carve within walls of %.4g mm",
                     m->options.wall_mm);
        }
        snprintf(outside, sizeof outside, "moved by at most %.4g mm (%.3g %% of its size)",
                 m->moved_mm, 100 * m->moved_mm / m->size_mm);
    }
    report_say(job->report, "%u round%s: %s; %s.", done->rounds, done->rounds == 1 ? "" : "s",
               inside, outside);
}

static void warn(cli_job *job, const model *m)
{
    const sf_stand_report *done = &m->report;
    if (done->folded > 0) {
        job_warn(job, "It is folded over in %llu places, which nobody can print.",
                 (unsigned long long)done->folded);
    }
    if (done->overlap_voxels > 0) {
        job_warn(job, "It runs into itself, in %llu voxels.",
                 (unsigned long long)done->overlap_voxels);
    }
    if (done->sunk_mm > SUNK * m->size_mm) {
        job_warn(job, "What must stay clear of the ground comes %.3g mm too close to it.",
                 done->sunk_mm);
    }
}

// What else could be tried, where it did not come out as it was asked for.
static void say_advice(const cli_job *job, const model *m)
{
    const sf_stand_options *o = &m->options;
    report *r = job->report;
    if (m->report.succeeded) {
        return;
    }
    if (o->carve && !isfinite(m->wall_min_mm)) {
        report_say(r,
                   "With walls of %.4g mm there was nothing to carve: a thinner --wall, or a "
                   "finer --resolution, leaves more inside.",
                   o->wall_mm);
    }
    if (!o->carve || !o->deform) {
        report_say(r, "Without %s there is one way more.",
                   o->carve    ? "--no-deform"
                   : o->deform ? "--no-carve"
                               : "--no-carve and --no-deform");
    } else {
        report_say(r, "It may come further with a smaller --gamma, a larger --max-shift, more "
                      "--handles, or a wider foot.");
    }
}

// Feet that are put flat make the margin another: both are said, so that neither looks wrong.
static void say_first(const cli_job *job, const model *m)
{
    double before = m->report.margin_before_rad * DEGREES, modelled = m->modelled_rad * DEGREES;
    if (m->flattened_mm > STILL * m->size_mm) {
        report_say(job->report,
                   "%s: voxels of %.4g mm; as modelled the margin is %.2f degrees, with its feet "
                   "put flat, which moves them by at most %.3g mm, %.2f.",
                   job->options.input, m->options.pitch_mm, modelled, m->flattened_mm, before);
    } else {
        report_say(job->report, "%s: voxels of %.4g mm; at first the margin is %.2f degrees.",
                   job->options.input, m->options.pitch_mm, before);
    }
    if (m->report.safe && m->report.rounds <= 1 && !isfinite(m->wall_min_mm) &&
        !(m->moved_mm > STILL * m->size_mm)) {
        report_say(job->report, "It rests as it was asked to already: nothing was changed.");
    }
}

void stand_report(cli_job *job, const model *m)
{
    report_fields(job, m);
    say_first(job, m);
    if (only_stands(m)) {
        say_standing(job, m);
    } else {
        say_stances(job, m);
    }
    say_price(job, m);
    say_advice(job, m);
    stand_drill_report(job, m);
    warn(job, m);
}
