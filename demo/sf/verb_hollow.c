// SPDX-License-Identifier: MIT
// sf hollow: the inside out of a part, with walls of a given thickness, so that what printed
// without supports still does; and a way out for what is in it.

#include "advice.h"
#include "certify.h"
#include "cutaway.h"
#include "describe.h"
#include "hollow_mesh.h"
#include "output.h"
#include "verbs.h"

#include <string.h>

static exit_status save_picture(cli_job *job, const part *p, const cavity *c)
{
    canvas picture = {NULL, 0, 0};
    double bar_mm = 0;
    if (job->options.picture == NULL) {
        return EXIT_GOOD;
    }
    exit_status status = cutaway_draw(job, p, c, &picture, &bar_mm);
    if (status == EXIT_GOOD) {
        status = output_save_picture(job, &picture, job->options.picture);
    }
    if (status == EXIT_GOOD) {
        report_text(job->report, "picture", job->options.picture);
        report_number(job->report, "scale_bar_mm", bar_mm);
        report_say(job->report, "Drawn, cut open, to %s; the bar is %g mm long.",
                   job->options.picture, bar_mm);
    }
    canvas_destroy(&picture);
    return status;
}

static exit_status save_shapes(cli_job *job, const part *p, const cavity *c, halves *h)
{
    const char *path = job->options.output, *inner = job->options.cavity;
    exit_status status = EXIT_GOOD;
    if (path != NULL) {
        status = output_kind_of(path) == OUTPUT_MESH
                     ? hollow_save(job, p, c, path, h)
                     : output_save_stack(job, p, c->done.after, path);
    }
    if (status == EXIT_GOOD && inner != NULL) {
        status = hollow_save_cavity(job, p, c, inner);
    }
    return status;
}

static void say_halves(cli_job *job, const halves *h)
{
    char low[HALVES_PATH_SIZE], high[HALVES_PATH_SIZE];
    if ((job->options.given & OPTION_CUT) &&
        halves_name(job, job->options.output, 0, low) == EXIT_GOOD &&
        halves_name(job, job->options.output, 1, high) == EXIT_GOOD) {
        halves_report(job, h, low, high);
    }
}

static void say_files(cli_job *job, const part *p, const halves *h)
{
    const char *path = job->options.output, *inner = job->options.cavity;
    report_number(job->report, "seconds", job_seconds(job));
    if (path != NULL) {
        report_text(job->report, "output", path);
        report_say(job->report, "Written to %s.", path);
        advice_check(job, p, path, NULL);
    }
    say_halves(job, h);
    if (inner != NULL) {
        report_text(job->report, "cavity", inner);
        report_say(job->report, "The cavity, to be taken from the part, is in %s.", inner);
    }
    if (path == NULL && inner == NULL && job->options.picture == NULL) {
        report_say(job->report, "Nothing was written; -o OUT says where to.");
    }
}

static exit_status save_all(cli_job *job, const part *p, const cavity *c, halves *h)
{
    sf_save *certificate;
    exit_status status = certify_begin(job, p, &c->done, &certificate);
    if (status == EXIT_GOOD) {
        status = save_shapes(job, p, c, h);
    }
    if (status == EXIT_GOOD) {
        status = save_picture(job, p, c);
    }
    if (status != EXIT_GOOD) {
        sf_save_abort(certificate);
        return status;
    }
    status = certify_commit(job, certificate);
    if (status != EXIT_GOOD) {
        return status;
    }
    say_files(job, p, h);
    return cavity_holds(job, c) && !h->missed ? EXIT_GOOD : EXIT_PROPERTY;
}

static exit_status save(cli_job *job, const part *p, const cavity *c)
{
    halves h;
    memset(&h, 0, sizeof h);
    exit_status status = save_all(job, p, c, &h);
    halves_release(&h);
    return status;
}

static exit_status hollow(cli_job *job, const part *p)
{
    masks m;
    cavity c;
    densities d;
    memset(&c, 0, sizeof c);
    memset(&d, 0, sizeof d);
    exit_status status = masks_read(job, p, &m);
    if (status == EXIT_GOOD) {
        status = densities_read(job, p, &d);
    }
    if (status == EXIT_GOOD) {
        status = cavity_make(job, p, &m, &d, &c);
    }
    if (status == EXIT_GOOD) {
        cavity_report(job, p, &c);
        status = save(job, p, &c);
    }
    cavity_release(&c);
    densities_release(&d);
    masks_release(&m);
    return status;
}

static exit_status work(cli_job *job, part *p)
{
    exit_status status = part_read(job, p);
    if (status == EXIT_GOOD) {
        status = halves_check_part(job, p);
    }
    if (status == EXIT_GOOD) {
        status = part_voxelize(job, p);
    }
    if (status == EXIT_GOOD) {
        status = part_make_rule(job, p);
    }
    if (status == EXIT_GOOD) {
        describe_part(job, p, "hollow");
        status = hollow(job, p);
    }
    return status;
}

// Whether the files of the halves can be written.
static exit_status probe_halves(cli_job *job)
{
    const char *path = job->options.output;
    exit_status status = halves_check(job, path != NULL && output_kind_of(path) == OUTPUT_MESH);
    for (int i = 0; status == EXIT_GOOD && (job->options.given & OPTION_CUT) && i < 2; i++) {
        char name[HALVES_PATH_SIZE];
        status = halves_name(job, path, i, name);
        if (status == EXIT_GOOD) {
            status = output_probe(job, name, OUTPUT_MESH);
        }
    }
    return status;
}

// What the command line asks for, before any work is done.
static exit_status check(cli_job *job)
{
    const cli_options *asked = &job->options;
    if (!(asked->wall_mm > 0)) {
        return job_fail(job, EXIT_USAGE,
                        "'sf hollow' needs --wall MM, which says how thick the wall is to be.");
    }
    if (asked->cavity != NULL && output_kind_of(asked->cavity) != OUTPUT_MESH) {
        return job_fail(job, EXIT_USAGE,
                        "--cavity %s: a mesh's name ends in .stl, .obj, .ply, .3mf or .glb.",
                        asked->cavity);
    }
    if (asked->picture != NULL && output_kind_of(asked->picture) != OUTPUT_PICTURE) {
        return job_fail(job, EXIT_USAGE, "--picture %s: a picture's name ends in .png.",
                        asked->picture);
    }
    if (asked->picture != NULL && !sf_stack_has_png()) {
        return job_fail(job, EXIT_USAGE, "This build draws no pictures: it was made without PNG.");
    }
    exit_status status = output_check(job, 1);
    if (status == EXIT_GOOD) {
        status = probe_halves(job);
    }
    if (status == EXIT_GOOD && asked->cavity != NULL) {
        status = output_probe(job, asked->cavity, OUTPUT_MESH);
    }
    if (status == EXIT_GOOD && asked->picture != NULL) {
        status = output_probe(job, asked->picture, OUTPUT_PICTURE);
    }
    return status;
}

exit_status verb_hollow(cli_job *job)
{
    part p;
    exit_status status = check(job);
    if (status == EXIT_GOOD) {
        status = work(job, &p);
        part_release(&p);
    }
    return status;
}
