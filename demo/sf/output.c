// SPDX-License-Identifier: MIT
// Files that a verb writes.

#include "output.h"

#include "judgement.h"
#include "package.h"
#include "print_job.h"
#include "progress.h"

#include <string.h>
#include <sys/stat.h>

static const char *extension(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *dot = strrchr(slash != NULL ? slash : path, '.');
    int leading = dot != NULL && (dot == path || dot[-1] == '/'); // ".", "..", ".hidden"
    return dot != NULL && !leading && dot[1] != '\0' && dot[1] != '/' ? dot : "";
}

output_kind output_kind_of(const char *path)
{
    const char *dot = extension(path);
    size_t length = strlen(path);
    struct stat entry;
    if ((length > 0 && path[length - 1] == '/') ||
        (stat(path, &entry) == 0 && S_ISDIR(entry.st_mode))) {
        return OUTPUT_STACK;
    }
    sf_mesh_format format = sf_mesh_format_from_name(path);
    if (format != SF_MESH_FORMAT_AUTO) {
        // glTF is written as one binary file, which .gltf is not.
        return format == SF_MESH_FORMAT_OFF || strlen(dot) == 5 ? OUTPUT_UNKNOWN : OUTPUT_MESH;
    }
    if (strcmp(dot, ".png") == 0) {
        return OUTPUT_PICTURE;
    }
    if (print_job_is_named(path) && dot[1] == 's') {
        return OUTPUT_JOB;
    }
    return dot[0] == '\0' ? OUTPUT_STACK : OUTPUT_UNKNOWN;
}

exit_status output_probe(cli_job *job, const char *path, output_kind kind)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_directory *directory = NULL;
    sf_save *file = NULL;
    if (path == NULL) {
        return EXIT_GOOD;
    }
    sf_status status = kind == OUTPUT_STACK ? sf_directory_write(path, NULL, &directory, &fault)
                                            : sf_save_begin(path, NULL, &file, &fault);
    sf_directory_close(directory);
    sf_save_abort(file);
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
}

exit_status output_check(cli_job *job, int mesh_allowed)
{
    const char *path = job->options.output;
    if (path == NULL) {
        return EXIT_GOOD;
    }
    output_kind kind = output_kind_of(path);
    if (kind == OUTPUT_STACK || kind == OUTPUT_JOB || (kind == OUTPUT_MESH && mesh_allowed)) {
        return output_probe(job, path, kind);
    }
    return job_fail(
        job, EXIT_USAGE, "-o %s: this verb writes %s.", path,
        mesh_allowed
            ? "a mesh (.stl, .obj, .ply, .3mf, .glb), a job (.sl1) or, for a name without "
              "extension or with a slash at its end, a folder with a stack of pictures"
            : "a job (.sl1), or a folder with a stack of pictures; its name has no extension, or "
              "a slash at its end");
}

// ---------------------------------------------------------------------------------------------
// Meshes
// ---------------------------------------------------------------------------------------------

exit_status output_look_at_smoothed(cli_job *job, const part *p, const sf_mesh *mesh,
                                    const char *key)
{
    sf_grid *again = NULL;
    sf_check_report counts;
    sf_lattice lattice = sf_grid_lattice(p->grid);
    progress_phase("checking the smoothed mesh");
    sf_status status = sf_grid_create(&lattice, NULL, &again);
    if (status == SF_OK) {
        status = sf_grid_voxelize(again, sf_mesh_get_view(mesh), NULL, NULL, &job->task, NULL);
    }
    if (status == SF_OK) {
        status = count_unsupported(job, p, again, &counts);
    }
    sf_grid_destroy(again);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "the smoothed mesh", EXIT_RESOURCE);
    }
    report_begin(job->report, key);
    report_count(job->report, "passes", (uint64_t)job->options.smooth);
    report_count(job->report, "unsupported_voxels", counts.unsupported_voxels);
    report_count(job->report, "trimmed_voxels", counts.trimmed_voxels);
    report_flag(job->report, "support_free", counts.support_free);
    report_end(job->report);
    if (!counts.support_free) {
        job_warn(job, "Smoothed, %llu voxels are unsupported.",
                 (unsigned long long)counts.unsupported_voxels);
    }
    return EXIT_GOOD;
}

exit_status output_make_mesh(cli_job *job, const part *p, const sf_grid *grid, const char *key,
                             sf_mesh **mesh)
{
    sf_surface_options how = sf_surface_options_default();
    how.smooth_passes = job->options.smooth;
    progress_phase("making the mesh");
    sf_status status = sf_grid_surface(grid, &how, NULL, &job->task, mesh);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "the mesh", EXIT_RESOURCE);
    }
    exit_status checked = EXIT_GOOD;
    if (how.smooth_passes > 0) {
        checked = output_look_at_smoothed(job, p, *mesh, key);
    }
    sf_transform back = part_to_input(job);
    if (checked == EXIT_GOOD && sf_mesh_transform(*mesh, &back) != SF_OK) {
        return job_fail(job, EXIT_RESOURCE, "The mesh could not be turned back.");
    }
    return checked;
}

exit_status output_write_mesh(cli_job *job, const sf_mesh *mesh, const char *path)
{
    sf_save *save = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    progress_phase("writing the mesh");
    sf_status status = sf_save_begin(path, NULL, &save, &fault);
    if (status == SF_OK) {
        status = sf_mesh_write(sf_mesh_get_view(mesh), sf_mesh_format_from_name(path),
                               sf_save_sink(save));
        if (status == SF_OK) {
            status = sf_save_commit(save, &fault);
        } else {
            sf_save_abort(save);
        }
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
}

// The same as 3MF, with a picture of the grid.
static exit_status save_package(cli_job *job, const sf_mesh *mesh, const sf_grid *grid,
                                const char *path)
{
    sf_save *save = NULL;
    canvas picture;
    sf_fault fault = {SF_OK, 0, 0, ""};
    package_body body = {"part", mesh};
    exit_status status = package_picture(job, grid, &picture);
    if (status == EXIT_GOOD) {
        progress_phase("writing the mesh");
        sf_status begun = sf_save_begin(path, NULL, &save, &fault);
        status = begun == SF_OK ? package_write(job, &body, 1, &picture, path, save)
                                : job_fail_call(job, begun, &fault, path, EXIT_RESOURCE);
    }
    canvas_destroy(&picture);
    if (status != EXIT_GOOD) {
        sf_save_abort(save);
        return status;
    }
    sf_status done = sf_save_commit(save, &fault);
    return done == SF_OK ? EXIT_GOOD : job_fail_call(job, done, &fault, path, EXIT_RESOURCE);
}

exit_status output_save_mesh(cli_job *job, const part *p, const sf_grid *grid, const char *path,
                             const char *key)
{
    sf_mesh *mesh = NULL;
    exit_status status = output_make_mesh(job, p, grid, key, &mesh);
    if (status == EXIT_GOOD) {
        status = package_is_asked(path) ? save_package(job, mesh, grid, path)
                                        : output_write_mesh(job, mesh, path);
    }
    sf_mesh_destroy(mesh);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Stacks
// ---------------------------------------------------------------------------------------------

static sf_stack_info stack_info(const cli_job *job, const part *p)
{
    sf_stack_info info;
    memset(&info, 0, sizeof info);
    info.has_rule = p->has_rule;
    info.rule = p->rule.kind;
    info.angle_rad = job->options.angle_rad;
    info.bed_layer = p->bed_layer;
    info.bridge_span_mm = job->options.bridge_mm[0];
    info.bridge_anchor_mm = job->options.bridge_mm[1];
    return info;
}

exit_status output_begin_stack(cli_job *job, const part *p, const sf_grid *grid, const char *path,
                               sf_directory **directory)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_stack_info info = stack_info(job, p);
    *directory = NULL;
    progress_phase("writing the stack");
    sf_status status = sf_directory_write(path, NULL, directory, &fault);
    if (status == SF_OK) {
        status = sf_stack_write(grid, &info, sf_directory_folder(*directory), &job->task, &fault);
        if (status != SF_OK) {
            sf_directory_close(*directory);
            *directory = NULL;
        }
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
}

exit_status output_save_stack(cli_job *job, const part *p, const sf_grid *grid, const char *path)
{
    sf_directory *directory;
    sf_fault fault = {SF_OK, 0, 0, ""};
    exit_status begun = output_begin_stack(job, p, grid, path, &directory);
    if (begun != EXIT_GOOD) {
        return begun;
    }
    sf_status status = sf_directory_commit(directory, &fault);
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
}

exit_status output_save(cli_job *job, const part *p, const sf_grid *grid, const char *path)
{
    output_kind kind = output_kind_of(path);
    return kind == OUTPUT_MESH  ? output_save_mesh(job, p, grid, path, "smoothed")
           : kind == OUTPUT_JOB ? print_job_save(job, p, grid, path)
                                : output_save_stack(job, p, grid, path);
}

// ---------------------------------------------------------------------------------------------
// Pictures and reports
// ---------------------------------------------------------------------------------------------

exit_status output_save_picture(cli_job *job, const canvas *picture, const char *path)
{
    sf_save *save = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_save_begin(path, NULL, &save, &fault);
    if (status == SF_OK) {
        status =
            sf_png_write_rgb(picture->pixels, picture->width, picture->height, sf_save_sink(save));
        if (status == SF_OK) {
            status = sf_save_commit(save, &fault);
        } else {
            sf_save_abort(save);
        }
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
}

exit_status output_save_report(cli_job *job, const char *path)
{
    sf_save *save = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_save_begin(path, NULL, &save, &fault);
    if (status == SF_OK) {
        status = report_print_json(job->report, sf_save_sink(save));
        if (status == SF_OK) {
            status = sf_save_commit(save, &fault);
        } else {
            sf_save_abort(save);
        }
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
}
