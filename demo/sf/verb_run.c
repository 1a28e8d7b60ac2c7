// SPDX-License-Identifier: MIT
// sf run: the main job. Check a part, make it printable in three ways, write everything to a
// folder, and say in ten lines what was found, what each way costs, and where it lies.

#include "describe.h"
#include "judgement.h"
#include "output.h"
#include "panels.h"
#include "picture.h"
#include "results.h"
#include "verbs.h"
#include "versions.h"

#include <math.h>
#include <stdio.h>
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
    results nothing;
    exit_status status = results_begin(job, folder, &nothing);
    results_drop(&nothing);
    return status;
}

// The picture before shows what a trim would take away.
static exit_status draw_before(cli_job *job, const part *p, const versions *v, canvas *picture)
{
    subject what = {p->grid, v->made[VERSION_TRIM].after, picture_lost, sf_grid_bounds(p->grid)};
    double bar_mm;
    return picture_draw(job, &what, picture, &bar_mm);
}

static exit_status draw_after(cli_job *job, const part *p, const versions *v, canvas *picture)
{
    char figures[VERSION_COUNT][VERSIONS_FIGURES_SIZE];
    panel panels[VERSION_COUNT];
    char title[64];
    uint32_t count = 0;
    snprintf(title, sizeof title, "%s (printable.stl)", versions_name(v->printable));
    for (int i = 0; i < VERSION_COUNT; i++) {
        if (v->there[i]) {
            panels[count].shape = v->made[i].after;
            panels[count].title = i == v->printable ? title : versions_name(i);
            panels[count++].figures = versions_figures(v, i, figures[i]);
        }
    }
    return panels_draw(job, p->grid, panels, count, picture);
}

typedef exit_status drawing(cli_job *job, const part *p, const versions *v, canvas *picture);

static exit_status save_picture(cli_job *job, const results *to, const part *p, const versions *v,
                                drawing *draw, const char *name)
{
    canvas picture = {NULL, 0, 0};
    char path[RESULTS_PATH_SIZE];
    exit_status status = results_path(job, to, name, path);
    if (status == EXIT_GOOD) {
        status = draw(job, p, v, &picture);
    }
    if (status == EXIT_GOOD) {
        status = output_save_picture(job, &picture, path);
    }
    canvas_destroy(&picture);
    return status;
}

static exit_status save_shapes(cli_job *job, const results *to, const part *p, const versions *v)
{
    static const char *const keys[] = {"smoothed_trim", "smoothed_grow", "smoothed_repair"};
    char path[RESULTS_PATH_SIZE];
    exit_status status = EXIT_GOOD;
    for (int i = 0; i < VERSION_COUNT && status == EXIT_GOOD; i++) {
        if (v->there[i]) {
            status = results_path(job, to, versions_file(v, i), path);
        }
        if (v->there[i] && status == EXIT_GOOD) {
            status = output_save_mesh(job, p, v->made[i].after, path, keys[i]);
        }
    }
    if (status == EXIT_GOOD) {
        status = results_path(job, to, "layers", path);
    }
    return status == EXIT_GOOD ? output_save_stack(job, p, v->made[v->printable].after, path)
                               : status;
}

// A strut of one voxel is right by geometry, and more than most printers can make.
static void say_printable(cli_job *job, const part *p, const versions *v)
{
    const char *folder = job->options.output;
    sf_lattice lattice = sf_grid_lattice(p->grid);
    char struts[80] = "";
    if (v->made[v->printable].added_voxels > 0 && !(job->options.min_feature_mm > 0)) {
        snprintf(struts, sizeof struts, ", with struts of %.3g mm (--min-feature MM: thicker)",
                 fmin(lattice.pitch_x_mm, lattice.pitch_y_mm));
    }
    report_say(job->report, "%s/printable.stl is the %s%s; its layers are in %s/layers/.", folder,
               versions_name(v->printable), struts, folder);
}

static exit_status save_report(cli_job *job, const results *to, const part *p, const versions *v)
{
    char path[RESULTS_PATH_SIZE];
    report *r = job->report;
    const char *folder = job->options.output;
    report_text(r, "printable", versions_name(v->printable));
    report_number(r, "seconds", job_seconds(job));
    report_text(r, "output", folder);
    say_printable(job, p, v);
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

static exit_status save_all(cli_job *job, const part *p, const versions *v)
{
    results to;
    exit_status status = results_begin(job, job->options.output, &to);
    if (status == EXIT_GOOD) {
        status = save_shapes(job, &to, p, v);
    }
    if (status == EXIT_GOOD && sf_stack_has_png()) {
        status = save_picture(job, &to, p, v, draw_before, "before.png");
    }
    if (status == EXIT_GOOD && sf_stack_has_png()) {
        status = save_picture(job, &to, p, v, draw_after, "after.png");
    }
    if (status == EXIT_GOOD) {
        status = save_report(job, &to, p, v);
    }
    if (status == EXIT_GOOD) {
        status = results_publish(job, &to);
    }
    if (status != EXIT_GOOD) {
        results_name_target(job, &to);
    }
    results_drop(&to);
    return status;
}

static exit_status change_and_save(cli_job *job, const part *p)
{
    versions v;
    exit_status status = versions_make(job, p, &v);
    if (status == EXIT_GOOD) {
        versions_say(job->report, &v, job->options.output);
        status = save_all(job, p, &v);
    }
    if (status == EXIT_GOOD && !v.made[v.printable].holds) {
        status = EXIT_PROPERTY;
    }
    versions_release(&v);
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
        judgement_report(job, p, &j, 1); // ten lines in all
        status = change_and_save(job, p);
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
