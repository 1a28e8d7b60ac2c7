// SPDX-License-Identifier: MIT
// sf run: the main job. Check a part, make it printable, write everything to a folder, and say in
// ten lines what was found and where it lies.

#include "change.h"
#include "describe.h"
#include "judgement.h"
#include "output.h"
#include "picture.h"
#include "results.h"
#include "verbs.h"

#include <sys/stat.h>

// Said before the work begins, not after it.
static exit_status check_folder(cli_job *job, const char *folder)
{
    struct stat entry;
    if (output_kind_of(folder) != OUTPUT_STACK) {
        return job_fail(job, EXIT_USAGE, "-o %s: 'sf run' writes a folder.", folder);
    }
    if (stat(folder, &entry) == 0 && !S_ISDIR(entry.st_mode)) {
        return job_fail(job, EXIT_RESOURCE, "-o %s: there is a file of that name; name a folder.",
                        folder);
    }
    return EXIT_GOOD;
}

static exit_status save_picture(cli_job *job, const results *r, const subject *what,
                                const char *name)
{
    canvas picture = {NULL, 0, 0};
    char path[RESULTS_PATH_SIZE];
    double bar_mm;
    if (!sf_stack_has_png()) {
        return EXIT_GOOD;
    }
    exit_status status = results_path(job, r, name, path);
    if (status == EXIT_GOOD) {
        status = picture_draw(job, what, &picture, &bar_mm);
    }
    if (status == EXIT_GOOD) {
        status = output_save_picture(job, &picture, path);
    }
    canvas_destroy(&picture);
    return status;
}

// The picture before shows what the trim took away, so it needs both grids.
static exit_status save_pictures(cli_job *job, const results *r, const sf_grid *before,
                                 const sf_grid *after)
{
    subject first = {before, after, before}, second = {after, after, before};
    exit_status status = save_picture(job, r, &first, "before.png");
    return status == EXIT_GOOD ? save_picture(job, r, &second, "after.png") : status;
}

static exit_status save_shapes(cli_job *job, const results *r, const part *p, const sf_grid *after)
{
    char path[RESULTS_PATH_SIZE];
    exit_status status = results_path(job, r, "printable.stl", path);
    if (status == EXIT_GOOD) {
        status = output_save_mesh(job, p, after, path);
    }
    if (status == EXIT_GOOD) {
        status = results_path(job, r, "layers", path);
    }
    return status == EXIT_GOOD ? output_save_stack(job, p, after, path) : status;
}

static exit_status save_report(cli_job *job, const results *to)
{
    char path[RESULTS_PATH_SIZE];
    report *r = job->report;
    const char *folder = job->options.output;
    report_number(r, "seconds", job_seconds(job));
    report_text(r, "output", folder);
    report_say(r, "The shape that prints is %s/printable.stl, its layers are in %s/layers/.",
               folder, folder);
    if (sf_stack_has_png()) {
        report_say(r, "See %s/before.png and %s/after.png; all figures are in %s/report.json.",
                   folder, folder, folder);
    } else {
        report_say(r, "All figures are in %s/report.json.", folder);
        job_warn(job, "No pictures were drawn: this build was made without PNG.");
    }
    exit_status status = results_path(job, to, "report.json", path);
    return status == EXIT_GOOD ? output_save_report(job, path) : status;
}

static exit_status save_all(cli_job *job, const part *p, const sf_grid *after)
{
    results to;
    exit_status status = results_begin(job, job->options.output, &to);
    if (status == EXIT_GOOD) {
        status = save_shapes(job, &to, p, after);
    }
    if (status == EXIT_GOOD) {
        status = save_pictures(job, &to, p->grid, after);
    }
    if (status == EXIT_GOOD) {
        status = save_report(job, &to);
    }
    if (status == EXIT_GOOD) {
        status = results_publish(job, &to);
    }
    results_drop(&to);
    return status;
}

static exit_status trim_and_save(cli_job *job, const part *p)
{
    const masks none = {NULL, NULL, NULL};
    change trimmed;
    exit_status status = change_make(job, p, &none, SF_OPERATION_TRIM, &trimmed);
    if (status == EXIT_GOOD) {
        change_report(job->report, "trim", &trimmed);
        change_say(job->report, &trimmed);
        status = save_all(job, p, trimmed.after);
    }
    status = status == EXIT_GOOD && !trimmed.holds ? EXIT_PROPERTY : status;
    change_release(&trimmed);
    return status;
}

static exit_status run(cli_job *job, part *p)
{
    judgement j;
    exit_status status = part_voxelize(job, p);
    if (status == EXIT_GOOD) {
        status = part_make_rule(job, p);
    }
    if (status != EXIT_GOOD) {
        return status;
    }
    describe_part(job, p, "run");
    status = judge(job, p, &j);
    if (status == EXIT_GOOD) {
        judgement_report(job, p, &j);
        status = trim_and_save(job, p);
    }
    judgement_release(&j);
    return status;
}

exit_status verb_run(cli_job *job)
{
    part p;
    if (job->options.output == NULL) {
        job->options.output = "out";
    }
    exit_status status = check_folder(job, job->options.output);
    if (status != EXIT_GOOD) {
        return status;
    }
    status = part_read(job, &p);
    if (status == EXIT_GOOD) {
        status = run(job, &p);
    }
    part_release(&p);
    return status;
}
