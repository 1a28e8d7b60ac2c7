// SPDX-License-Identifier: MIT
// The files that `sf stand` writes. All are written aside first, which is where room may run out
// and where a person may cancel; then each takes its name, the report last. A file of an earlier
// run that this one has no use for goes: it would not belong to this report.

#include "stand_files.h"

#include "balance_picture.h"
#include "halves.h"
#include "hollow_mesh.h"
#include "output.h"
#include "package.h"
#include "progress.h"
#include "stand_drill.h"
#include "stand_layers.h"
#include "stand_prints.h"

#include <stdio.h>
#include <string.h>

enum { OUTER, INNER, CUT, LOW, HIGH, PACKAGE, PICTURE, REPORT, FILE_COUNT, PATH_SIZE = 4096 };

static const char *const endings[] = {"_outer.stl", "_inner.stl", "_cut.stl", "_low.stl",
                                      "_high.stl",  ".3mf",       ".png",     ".json"};
static const char *const keys[] = {"outer", "inner",   "cut",     NULL,
                                   NULL,    "package", "picture", "report"};

typedef struct file_set {
    char path[FILE_COUNT][PATH_SIZE];
    sf_save *save[FILE_COUNT]; // NULL: not written
    halves halves;
    stand_layers layers;
} file_set;

// "part" of "part.3mf", which asks for one file that has it all; else all of it.
static int prefix_length(const char *output)
{
    size_t length = strlen(output) - (package_is_asked(output) ? strlen(endings[PACKAGE]) : 0);
    return length < PATH_SIZE ? (int)length : PATH_SIZE;
}

static exit_status name_files(cli_job *job, file_set *files)
{
    memset(files, 0, sizeof *files);
    int prefix = prefix_length(job->options.output);
    for (int i = 0; i < FILE_COUNT; i++) {
        int length =
            snprintf(files->path[i], PATH_SIZE, "%.*s%s", prefix, job->options.output, endings[i]);
        if (length < 0 || length >= PATH_SIZE) {
            return job_fail(job, EXIT_USAGE, "-o: The path is too long.");
        }
    }
    return EXIT_GOOD;
}

exit_status stand_files_check(cli_job *job)
{
    file_set files;
    exit_status status = stand_layers_check(job);
    if (status == EXIT_GOOD) {
        status = halves_check(job, job->options.output != NULL);
    }
    if (status != EXIT_GOOD || job->options.output == NULL) {
        return status;
    }
    status = name_files(job, &files);
    for (int i = 0; status == EXIT_GOOD && i < FILE_COUNT; i++) {
        status = output_probe(job, files.path[i], i == PICTURE ? OUTPUT_PICTURE : OUTPUT_MESH);
    }
    return status;
}

static exit_status begin(cli_job *job, file_set *files, int which)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_save_begin(files->path[which], NULL, &files->save[which], &fault);
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, &fault, files->path[which], EXIT_RESOURCE);
}

static exit_status end(cli_job *job, const file_set *files, int which, sf_status status)
{
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, NULL, files->path[which], EXIT_RESOURCE);
}

static exit_status write_mesh(cli_job *job, file_set *files, int which, const sf_mesh *mesh)
{
    exit_status status = begin(job, files, which);
    return status == EXIT_GOOD ? end(job, files, which,
                                     sf_mesh_write(sf_mesh_get_view(mesh), SF_MESH_FORMAT_STL,
                                                   sf_save_sink(files->save[which])))
                               : status;
}

// A surface in build axes, in those of the input.
static exit_status write_surface(cli_job *job, file_set *files, int which, sf_mesh_view view)
{
    sf_mesh *mesh = NULL;
    sf_transform back = part_to_input(job);
    sf_status made = sf_mesh_create(NULL, &mesh);
    if (made == SF_OK) {
        made = sf_mesh_add_vertices(mesh, view.vertices, view.vertex_count);
    }
    if (made == SF_OK) {
        made = sf_mesh_add_triangles(mesh, view.triangles, view.triangle_count);
    }
    if (made == SF_OK) {
        made = sf_mesh_transform(mesh, &back);
    }
    exit_status status =
        made == SF_OK ? write_mesh(job, files, which, mesh) : end(job, files, which, made);
    sf_mesh_destroy(mesh);
    return status;
}

// Whether voids were drilled open or filled, which is not in the surfaces of rounds.
static int has_holes(const model *m)
{
    return m->drilled.after != NULL &&
           m->drilled.report.drain_count + m->drilled.report.filled_count > 0;
}

// The model with its cavity, in build axes; with holes it is the surface of its voxels, as that of
// `sf hollow` is.
static sf_status make_whole(cli_job *job, const model *m, sf_mesh **whole)
{
    return has_holes(m)
               ? sf_grid_surface(m->drilled.after, NULL, NULL, &job->task, whole)
               : hollow_join(sf_stand_outer(m->stand), sf_stand_cavity(m->stand), 0, whole);
}

static exit_status write_halves(cli_job *job, file_set *files, const model *m)
{
    sf_mesh *whole = NULL;
    sf_transform back = part_to_input(job);
    if ((job->options.given & OPTION_CUT) == 0) {
        return EXIT_GOOD;
    }
    sf_status made = make_whole(job, m, &whole);
    if (made == SF_OK) {
        made = sf_mesh_transform(whole, &back);
    }
    exit_status status = made == SF_OK ? halves_make(job, whole, SF_MESH_FORMAT_STL, &files->halves)
                                       : end(job, files, LOW, made);
    for (int i = 0; status == EXIT_GOOD && !files->halves.missed && i < 2; i++) {
        status = write_mesh(job, files, LOW + i, files->halves.mesh[i]);
    }
    sf_mesh_destroy(whole);
    return status;
}

// All in one file: the model with its cavity, or both halves of it, where they belong.
static exit_status write_package(cli_job *job, file_set *files, const model *m)
{
    sf_mesh *whole = NULL;
    canvas picture = {NULL, 0, 0};
    sf_transform back = part_to_input(job);
    int is_cut = (job->options.given & OPTION_CUT) != 0;
    sf_status made = make_whole(job, m, &whole);
    if (made == SF_OK) {
        made = sf_mesh_transform(whole, &back);
    }
    exit_status status = made == SF_OK ? EXIT_GOOD : end(job, files, PACKAGE, made);
    if (status == EXIT_GOOD && is_cut) {
        status = halves_make(job, whole, SF_MESH_FORMAT_THREEMF, &files->halves);
    }
    if (status == EXIT_GOOD && sf_stack_has_png()) {
        status = balance_picture_draw(job, m, &picture);
    }
    if (status == EXIT_GOOD) {
        status = begin(job, files, PACKAGE);
    }
    if (status == EXIT_GOOD) {
        int halved = is_cut && !files->halves.missed;
        const package_body bodies[2] = {
            {halved ? "low half" : "part", halved ? files->halves.mesh[0] : whole},
            {"high half", files->halves.mesh[1]}};
        status = package_write(job, bodies, halved ? 2 : 1, &picture, files->path[PACKAGE],
                               files->save[PACKAGE]);
    }
    canvas_destroy(&picture);
    sf_mesh_destroy(whole);
    return status;
}

static void report_halves(cli_job *job, const file_set *files)
{
    if ((job->options.given & OPTION_CUT) == 0) {
        return;
    }
    int is_package = files->save[PACKAGE] != NULL;
    halves_report(job, &files->halves, files->path[is_package ? PACKAGE : LOW],
                  files->path[is_package ? PACKAGE : HIGH]);
    if (files->save[CUT] != NULL && !files->halves.missed) {
        report_say(job->report,
                   "The halves have the holes, so their outside is that of voxels; for "
                   "a smooth one take _cut.stl from _outer.stl, and cut that.");
    }
}

// Cavity and holes as one body.
static exit_status write_cut(cli_job *job, file_set *files, const model *m)
{
    sf_mesh *mesh = NULL;
    if (!has_holes(m)) {
        return EXIT_GOOD;
    }
    exit_status status = stand_drill_mesh(job, m, &mesh);
    if (status == EXIT_GOOD) {
        status = write_mesh(job, files, CUT, mesh);
    }
    sf_mesh_destroy(mesh);
    return status;
}

static exit_status write_picture(cli_job *job, file_set *files, const model *m)
{
    canvas picture = {NULL, 0, 0};
    if (!sf_stack_has_png()) {
        return EXIT_GOOD;
    }
    exit_status status = balance_picture_draw(job, m, &picture);
    if (status == EXIT_GOOD) {
        status = begin(job, files, PICTURE);
    }
    if (status == EXIT_GOOD) {
        status = end(job, files, PICTURE,
                     sf_png_write_rgb(picture.pixels, picture.width, picture.height,
                                      sf_save_sink(files->save[PICTURE])));
    }
    canvas_destroy(&picture);
    return status;
}

static void report_layers(cli_job *job, const stand_layers *layers)
{
    const char *folder = job->options.layers, *certificate = job->options.certificate;
    if (layers->folder != NULL) {
        report_text(job->report, "layers", folder);
        report_say(job->report, "Layers are in %s.", folder);
    }
    if (layers->certificate != NULL) {
        report_text(job->report, "certificate", certificate);
        report_say(job->report, "Certified: see 'sf-verify %s %s'.", folder, certificate);
    }
}

// Holes are in the body that is to be taken away, and not in the cavity.
static exit_status advise(cli_job *job, const file_set *files, const model *m)
{
    int inner = files->save[CUT] != NULL ? CUT : INNER;
    if (files->save[PACKAGE] != NULL && files->layers.folder == NULL) {
        report_say(job->report, "Its cavity is of voxels, and on others it prints otherwise: to "
                                "check it on its own, write --layers, or a PREFIX.");
        return EXIT_GOOD;
    }
    return stand_prints_advise(job, m, files->path[OUTER],
                               files->save[inner] != NULL ? files->path[inner] : NULL,
                               files->layers.folder != NULL ? job->options.layers : NULL);
}

static void say_files(cli_job *job, const file_set *files)
{
    if (files->save[PACKAGE] != NULL) {
        report_say(job->report, "Written to %s%s and %s.", files->path[PACKAGE],
                   files->save[PICTURE] != NULL ? ", .png" : "", files->path[REPORT]);
        return;
    }
    report_say(job->report, "Written to %s_outer.stl%s%s%s and %s.json.", job->options.output,
               files->save[INNER] != NULL ? ", _inner.stl" : "",
               files->save[CUT] != NULL ? ", _cut.stl (cavity and holes, to be taken from it)" : "",
               files->save[PICTURE] != NULL ? ", .png" : "", job->options.output);
}

static exit_status write_report(cli_job *job, file_set *files, const model *m)
{
    exit_status status = begin(job, files, REPORT);
    report *r = job->report;
    report_number(r, "seconds", job_seconds(job));
    for (int i = 0; i < FILE_COUNT; i++) {
        if (keys[i] != NULL && files->save[i] != NULL) {
            report_text(r, keys[i], files->path[i]);
        } else if (keys[i] != NULL) {
            report_null(r, keys[i]);
        }
    }
    say_files(job, files);
    report_halves(job, files);
    report_layers(job, &files->layers);
    if (status == EXIT_GOOD) {
        status = advise(job, files, m);
    }
    return status == EXIT_GOOD
               ? end(job, files, REPORT, report_print_json(r, sf_save_sink(files->save[REPORT])))
               : status;
}

static exit_status publish(cli_job *job, file_set *files)
{
    exit_status status = EXIT_GOOD;
    if (sf_task_is_cancelled(&job->task)) {
        status = job_fail_call(job, SF_ERR_CANCELLED, NULL, "", EXIT_RESOURCE);
    }
    if (status == EXIT_GOOD) {
        status = stand_layers_commit(job, &files->layers);
    } else {
        stand_layers_abort(&files->layers);
    }
    for (int i = 0; i < FILE_COUNT; i++) {
        sf_fault fault = {SF_OK, 0, 0, ""};
        if (status != EXIT_GOOD) {
            sf_save_abort(files->save[i]);
        } else if (files->save[i] == NULL) {
            remove(files->path[i]);
        } else {
            sf_status done = sf_save_commit(files->save[i], &fault);
            status = done == SF_OK
                         ? EXIT_GOOD
                         : job_fail_call(job, done, &fault, files->path[i], EXIT_RESOURCE);
        }
        files->save[i] = NULL;
    }
    return status;
}

static exit_status write_surfaces(cli_job *job, file_set *files, const model *m)
{
    sf_mesh_view inside = sf_stand_cavity(m->stand);
    exit_status status = write_surface(job, files, OUTER, sf_stand_outer(m->stand));
    if (status == EXIT_GOOD && inside.triangle_count > 0) {
        status = write_surface(job, files, INNER, inside);
    }
    if (status == EXIT_GOOD) {
        status = write_cut(job, files, m);
    }
    return status == EXIT_GOOD ? write_halves(job, files, m) : status;
}

static exit_status write_all(cli_job *job, file_set *files, const model *m)
{
    exit_status status = package_is_asked(job->options.output) ? write_package(job, files, m)
                                                               : write_surfaces(job, files, m);
    if (status == EXIT_GOOD) {
        status = write_picture(job, files, m);
    }
    if (status == EXIT_GOOD) {
        status = stand_layers_begin(job, m, &files->layers);
    }
    return status == EXIT_GOOD ? write_report(job, files, m) : status;
}

exit_status stand_files_save(cli_job *job, const model *m)
{
    file_set files;
    exit_status status = name_files(job, &files);
    progress_phase("writing");
    if (status == EXIT_GOOD) {
        status = write_all(job, &files, m);
    }
    int missed = files.halves.missed;
    halves_release(&files.halves);
    if (status == EXIT_GOOD) {
        status = publish(job, &files);
        return status == EXIT_GOOD && missed ? EXIT_PROPERTY : status;
    }
    stand_layers_abort(&files.layers);
    for (int i = 0; i < FILE_COUNT; i++) {
        sf_save_abort(files.save[i]);
    }
    return status;
}
