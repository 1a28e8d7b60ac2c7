// SPDX-License-Identifier: MIT
// sf orient: which way up does it print best, and why?

#include "describe.h"
#include "output.h"
#include "place.h"
#include "progress.h"
#include "values.h"
#include "verbs.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DEGREES (180 / 3.14159265358979323846)

typedef struct answer {
    sf_orientation *best; // the best one first
    size_t count;
    sf_orientation given;
} answer;

// ---------------------------------------------------------------------------------------------
// Fields
// ---------------------------------------------------------------------------------------------

// The turn is of the part with --up up; what is said is that of the part as it was read.
static void report_turn(const cli_job *job, const sf_orientation *o)
{
    sf_transform map = upright(job->options.up, 1);
    double up[3], matrix[9] = {0};
    place_point(job->options.up, o->up, up);
    for (int i = 0; i < 27; i++) {
        matrix[i / 3] += o->turn.matrix[i / 9 * 3 + i % 3] * map.matrix[i % 3 * 3 + i / 3 % 3];
    }
    report_numbers(job->report, "up", up, 3);
    report_numbers(job->report, "matrix", matrix, 9);
}

static void report_orientation(const cli_job *job, const char *key, const sf_orientation *o)
{
    report *r = job->report;
    report_begin(r, key);
    report_turn(job, o);
    report_numbers(r, "shift_mm", o->turn.shift_mm, 3);
    report_count(r, "solid_voxels", o->solid_voxels);
    report_count(r, "trimmed_voxels", o->trimmed_voxels);
    report_number(r, "trimmed_mm3", o->trimmed_mm3);
    report_number(r, "unsupported_mm2", o->unsupported_mm2);
    report_number(r, "height_mm", o->height_mm);
    report_number(r, "margin_deg", o->margin_rad * DEGREES);
    report_number(r, "score", o->score);
    report_end(r);
}

static void report_fields(cli_job *job, const sf_lattice *lattice, const answer *a)
{
    const cli_options *asked = &job->options;
    report *r = job->report;
    report_text(r, "verb", "orient");
    report_text(r, "input", asked->input);
    report_count(r, "resolution", asked->resolution);
    describe_lattice(r, lattice);
    report_begin(r, "rule");
    report_text(r, "kind", sf_rule_kind_name(asked->rule));
    if (asked->rule == SF_RULE_BOX3) {
        report_null(r, "angle_deg");
    } else {
        report_number(r, "angle_deg", values_angle_deg(asked));
    }
    report_end(r);
    report_orientation(job, "given", &a->given);
    report_begin_list(r, "orientations");
    for (size_t i = 0; i < a->count; i++) {
        report_orientation(job, NULL, &a->best[i]);
    }
    report_end(r);
}

// ---------------------------------------------------------------------------------------------
// Sentences
// ---------------------------------------------------------------------------------------------

static double share(const sf_orientation *o)
{
    return o->solid_voxels > 0 ? (double)o->trimmed_voxels / (double)o->solid_voxels : 0;
}

// A direction in words: an axis where it is one.
static void name_direction(const double up[3], char *words, size_t size)
{
    for (int i = 0; i < 3; i++) {
        if (fabs(fabs(up[i]) - 1) < 1e-9) {
            snprintf(words, size, "%c%c", up[i] < 0 ? '-' : '+', "xyz"[i]);
            return;
        }
    }
    snprintf(words, size, "(%.3f, %.3f, %.3f)", up[0], up[1], up[2]);
}

// A whole number of degrees.
static void describe_degrees(double radians, char words[32])
{
    double degrees = floor(radians * DEGREES + 0.5);
    snprintf(words, 32, "%.0f degree%s", degrees, degrees == 1 ? "" : "s");
}

// What became of it that way up, as the end of a sentence.
static void describe(const sf_orientation *o, char *words, size_t size)
{
    char lost[96] = "all of it prints without supports", stands[64] = "it falls over";
    char volume[DESCRIBE_MM3_SIZE], tipped[32];
    if (o->trimmed_voxels > 0) {
        snprintf(lost, sizeof lost, "%s (%.3g %%) cannot print",
                 describe_mm3(o->trimmed_mm3, volume), 100 * share(o));
    }
    if (o->margin_rad > 0) {
        describe_degrees(o->margin_rad, tipped);
        snprintf(stands, sizeof stands, "it stands until tipped by %s", tipped);
    }
    snprintf(words, size, "%s, it is %.4g mm high, and %s", lost, o->height_mm, stands);
}

// What makes the best one better than the part as it is.
static const char *reason(const sf_orientation *best, const sf_orientation *given)
{
    if (best->trimmed_voxels < given->trimmed_voxels) {
        return best->trimmed_voxels == 0 ? "nothing hangs over then" : "less hangs over then";
    }
    return best->height_mm < given->height_mm ? "it is lower then" : "it stands more safely then";
}

static void say(cli_job *job, const answer *a)
{
    report *r = job->report;
    const sf_orientation *best = &a->best[0];
    char words[256], up[64], turned[32];
    describe(&a->given, words, sizeof words);
    report_say(r, "%s, as it is: %s.", job->options.input, words);
    double there[3];
    place_point(job->options.up, best->up, there);
    if (best->up[2] == 1) {
        report_say(r, "No way up is better.");
    } else {
        name_direction(there, up, sizeof up);
        describe(best, words, sizeof words);
        describe_degrees(acos(fmax(-1, fmin(1, best->up[2]))), turned);
        report_say(r, "Best: turn it by %s so that its %s points up; %s.", turned, up,
                   reason(best, &a->given));
        report_say(r, "Then %s.", words);
    }
    for (size_t i = 1; i < a->count; i++) {
        place_point(job->options.up, a->best[i].up, there);
        name_direction(there, up, sizeof up);
        describe(&a->best[i], words, sizeof words);
        report_say(r, "  %zu. %s up: %s", i + 1, up, words);
    }
}

// ---------------------------------------------------------------------------------------------
// The verb
// ---------------------------------------------------------------------------------------------

static exit_status find(cli_job *job, const part *p, answer *a)
{
    const cli_options *asked = &job->options;
    sf_orient_options how = sf_orient_options_default();
    how.rule = asked->rule;
    how.angle_rad = asked->angle_rad;
    how.fill = asked->fill;
    how.resolution = asked->resolution;
    how.fine_count = asked->count;
    how.coarse_count = how.coarse_count > how.fine_count ? how.coarse_count : how.fine_count;
    how.coarse_resolution =
        how.coarse_resolution < how.resolution ? how.coarse_resolution : how.resolution;
    a->best = malloc(how.fine_count * sizeof *a->best);
    if (a->best == NULL) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the orientations.");
    }
    progress_phase("turning it around");
    sf_status status = sf_mesh_orient(sf_mesh_get_view(p->mesh), &how, NULL, &job->task, a->best,
                                      how.fine_count, &a->count, &a->given);
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, NULL, asked->input, EXIT_INPUT);
}

// Make voxels of the part as it is: to say what every verb says of a mesh that is open or inside
// out, and on which lattice "given" is. The other ways up are on voxels of the same size.
static exit_status try_as_given(cli_job *job, part *p, sf_lattice *lattice)
{
    exit_status status = part_voxelize(job, p);
    if (status == EXIT_GOOD) {
        *lattice = sf_grid_lattice(p->grid);
    }
    sf_grid_destroy(p->grid);
    p->grid = NULL;
    return status;
}

static exit_status write_turned(cli_job *job, part *p, const answer *a)
{
    const char *path = job->options.output;
    if (path == NULL) {
        report_say(job->report, "Nothing was written; -o OUT says where to.");
        return EXIT_GOOD;
    }
    sf_status status = sf_mesh_transform(p->mesh, &a->best[0].turn);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, path, EXIT_INPUT);
    }
    exit_status written = output_write_mesh(job, p->mesh, path);
    if (written == EXIT_GOOD) {
        report_text(job->report, "output", path);
        report_say(job->report, "Written to %s, z up and on z = 0.", path);
    }
    return written;
}

static exit_status orient(cli_job *job, part *p)
{
    answer a;
    sf_lattice lattice;
    memset(&a, 0, sizeof a);
    if (p->kind != PART_MESH) {
        return job_fail(job, EXIT_INPUT, "%s is no mesh; only a mesh can be turned.",
                        job->options.input);
    }
    exit_status status = try_as_given(job, p, &lattice);
    if (status == EXIT_GOOD) {
        status = find(job, p, &a);
    }
    if (status == EXIT_GOOD) {
        report_fields(job, &lattice, &a);
        say(job, &a);
        status = write_turned(job, p, &a);
    }
    if (status == EXIT_GOOD) {
        report_number(job->report, "seconds", job_seconds(job));
    }
    free(a.best);
    return status;
}

exit_status verb_orient(cli_job *job)
{
    part p;
    if (job->options.output != NULL && output_kind_of(job->options.output) != OUTPUT_MESH) {
        return job_fail(job, EXIT_USAGE,
                        "-o %s: this verb writes a mesh (.stl, .obj, .ply, .3mf, .glb).",
                        job->options.output);
    }
    exit_status status = output_probe(job, job->options.output, OUTPUT_MESH);
    if (status != EXIT_GOOD) {
        return status;
    }
    status = part_read(job, &p);
    if (status == EXIT_GOOD) {
        status = orient(job, &p);
    }
    part_release(&p);
    return status;
}
