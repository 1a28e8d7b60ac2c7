// SPDX-License-Identifier: MIT
// The part that a verb works on: read, turned upright, sized, and put on a lattice.

#include "part.h"

#include "cages.h"
#include "describe.h"
#include "gltf_input.h"
#include "inner.h"
#include "lattice.h"
#include "place.h"
#include "print_job.h"
#include "progress.h"
#include "scene.h"
#include "sliced.h"
#include "upright.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define SCENE_PREFIX "scene:"

// Options that say how a mesh is to be understood; nothing else has a use for them.
#define MESH_ONLY (OPTION_UP | OPTION_UNITS | OPTION_SCALE | OPTION_SIZE | OPTION_FILL)

// ---------------------------------------------------------------------------------------------
// Reading
// ---------------------------------------------------------------------------------------------

static exit_status refuse_options(cli_job *job, uint64_t useless, const char *what)
{
    if ((job->options.given & useless) == 0) {
        return EXIT_GOOD;
    }
    return job_fail(job, EXIT_USAGE,
                    "%s has its own size and axes: leave out --up, --units, --scale, --size, "
                    "--fill%s.",
                    what,
                    useless & OPTION_PITCH        ? ", --pitch and --resolution"
                    : useless & OPTION_RESOLUTION ? " and --resolution"
                                                  : "");
}

exit_status part_load_mesh(cli_job *job, const char *path, sf_mesh **mesh)
{
    sf_file *file = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    if (gltf_looks_like(path)) {
        return gltf_load_mesh(job, path, mesh);
    }
    sf_status status = sf_file_open(path, NULL, &file, &fault);
    if (status != SF_OK) {
        return job_fail_call(job, status, &fault, path, EXIT_INPUT);
    }
    progress_phase("reading");
    status = sf_mesh_read(sf_file_source(file), sf_mesh_format_from_name(path), NULL, NULL, mesh,
                          &fault);
    sf_file_close(file);
    if ((status == SF_ERR_FORMAT || status == SF_ERR_UNSUPPORTED) && cages_look_like(path)) {
        return job_fail(
            job, EXIT_INPUT,
            "%s is a cage or a mesh of cells, not a surface: 'sf grade' makes layers of "
            "it, 'sf refine' a finer cage.",
            path);
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_INPUT);
}

static double longest_side(sf_mesh_view view, double low[3], double high[3])
{
    double longest = 0;
    if (sf_mesh_bounds(view, low, high) == SF_OK) {
        for (int i = 0; i < 3; i++) {
            longest = fmax(longest, high[i] - low[i]);
        }
    }
    return longest;
}

// Turn upright, and to millimetres of the asked size.
static exit_status place(cli_job *job, part *p)
{
    const cli_options *asked = &job->options;
    double low[3], high[3], factor = asked->unit_mm * asked->scale;
    double longest = longest_side(sf_mesh_get_view(p->mesh), low, high);
    if (!(longest > 0) || !isfinite(longest)) {
        return job_fail(job, EXIT_INPUT, "%s: The part has no extent; there is nothing to print.",
                        asked->input);
    }
    if (asked->given & OPTION_SIZE) {
        factor = asked->size_mm / longest;
    }
    p->to_build = upright(asked->up, factor);
    sf_status status = sf_mesh_transform(p->mesh, &p->to_build);
    longest *= factor;
    if (status != SF_OK || !isfinite(longest) || !(longest > 0)) {
        return job_fail(job, EXIT_USAGE,
                        "%s: With this --units, --scale or --size the part is "
                        "%g mm long; coordinates must stay finite.",
                        asked->input, longest);
    }
    if ((asked->given & (OPTION_UNITS | OPTION_SCALE | OPTION_SIZE)) == 0 &&
        (longest < 5 || longest > 1000)) {
        if (gltf_looks_like(asked->input)) {
            job_warn(
                job,
                "The part is %.4g mm long, because glTF is in metres; if its numbers are meant "
                "as mm, say --scale 0.001, else --size.",
                longest);
            return EXIT_GOOD;
        }
        job_warn(job,
                 "The part is %.4g mm long, taking its unit for mm; if it is meant larger or "
                 "smaller, say --units, --scale or --size.",
                 longest);
    }
    return EXIT_GOOD;
}

static exit_status read_mesh(cli_job *job, part *p)
{
    p->kind = PART_MESH;
    if ((job->options.given & OPTION_UNITS) != 0 && gltf_looks_like(job->options.input)) {
        return job_fail(job, EXIT_USAGE,
                        "glTF is in metres, so leave out --units; --scale 0.001 takes its numbers "
                        "for mm.");
    }
    exit_status status = part_load_mesh(job, job->options.input, &p->mesh);
    return status == EXIT_GOOD ? place(job, p) : status;
}

// What is built may have slices, which are taken then, or is one mesh.
static exit_status read_3mf(cli_job *job, part *p)
{
    sf_threemf *document = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    exit_status status = sliced_open(job, job->options.input, &document);
    if (status == EXIT_GOOD && sf_threemf_is_sliced(document)) {
        p->kind = PART_STACK;
        status = refuse_options(job, MESH_ONLY, "A file of slices");
        if (status == EXIT_GOOD) {
            status = sliced_draw(job, document, p);
        }
    } else if (status == EXIT_GOOD) {
        p->kind = PART_MESH;
        sf_status made = sf_threemf_merge(document, NULL, NULL, &p->mesh, &fault);
        status = made == SF_OK ? place(job, p)
                               : job_fail_call(job, made, &fault, job->options.input, EXIT_INPUT);
    }
    sf_threemf_destroy(document);
    return status;
}

// A stack carries the rule, its angle, the bridges and the bed that it was made for, and an option
// takes the place of one: --angle turns the stack's rule to another angle, --rule asks for another
// rule at the same angle. Bridges say what a printer can do at any angle, so they stay under
// another rule; but not without a word.
static void take_rule(cli_job *job, part *p, const sf_stack_info *info)
{
    cli_options *asked = &job->options;
    int is_rule_asked = (asked->given & OPTION_RULE) != 0;
    int is_angle_asked = (asked->given & OPTION_ANGLE) != 0;
    int has_angle = info->rule != SF_RULE_BOX3;
    p->bed_layer = info->bed_layer;
    p->own_rule = !is_rule_asked && (has_angle || !is_angle_asked);
    p->own_bridges = (asked->given & OPTION_BRIDGE) == 0;
    if (p->own_rule) {
        asked->rule = info->rule;
    } else if (!is_rule_asked) {
        job_warn(job, "The stack's rule, box3, takes no angle; --angle asks for another rule.");
    }
    if (has_angle && !is_angle_asked) {
        asked->angle_rad = info->angle_rad;
    }
    if (p->own_bridges) {
        asked->bridge_mm[0] = info->bridge_span_mm;
        asked->bridge_mm[1] = info->bridge_anchor_mm;
    }
    if ((is_rule_asked || is_angle_asked) && p->own_bridges && info->bridge_span_mm > 0) {
        job_warn(job,
                 "The stack's bridges of up to %g mm stay beside the rule that was asked for; "
                 "--bridge 0 leaves them out.",
                 info->bridge_span_mm);
    }
}

// A stack carries its own lattice too.
static exit_status read_stack(cli_job *job, part *p)
{
    const cli_options *asked = &job->options;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_directory *directory = NULL;
    sf_stack_info info;
    p->kind = PART_STACK;
    exit_status refused =
        refuse_options(job, MESH_ONLY | OPTION_PITCH | OPTION_RESOLUTION, "A stack of pictures");
    if (refused != EXIT_GOOD) {
        return refused;
    }
    progress_phase("reading");
    sf_status status = sf_directory_read(asked->input, NULL, &directory, &fault);
    if (status == SF_OK) {
        status = sf_stack_read(sf_directory_folder(directory), NULL, &job->task, &p->grid, &info,
                               &fault);
        sf_directory_close(directory);
    }
    if (status != SF_OK) {
        return job_fail_call(job, status, &fault, asked->input, EXIT_INPUT);
    }
    if (info.has_rule) {
        take_rule(job, p, &info);
    }
    return EXIT_GOOD;
}

static exit_status read_scene(cli_job *job, part *p)
{
    const cli_options *asked = &job->options;
    const char *name = asked->input == NULL ? "garden" : asked->input + strlen(SCENE_PREFIX);
    double size_mm[3];
    sf_lattice lattice;
    p->kind = PART_SCENE;
    exit_status status = refuse_options(job, MESH_ONLY, "A scene");
    if (status != EXIT_GOOD) {
        return status;
    }
    if (!scene_size(name, size_mm)) {
        return job_fail(job, EXIT_INPUT, "There is no scene '%s'; there is scene:garden.", name);
    }
    double low[3] = {0, 0, 0};
    status = lattice_choose(job, low, size_mm, &lattice, &p->lift);
    if (status != EXIT_GOOD) {
        return status;
    }
    progress_phase("drawing the scene");
    sf_status made = sf_grid_create(&lattice, NULL, &p->grid);
    if (made == SF_OK) {
        made = scene_draw(name, p->grid, &job->task);
    }
    return made == SF_OK ? EXIT_GOOD : job_fail_call(job, made, NULL, name, EXIT_RESOURCE);
}

static exit_status read_any(cli_job *job, part *p)
{
    const char *input = job->options.input;
    struct stat entry;
    memset(p, 0, sizeof *p);
    p->bed_layer = SF_BED_AUTO;
    p->to_build = upright(AXIS_Z, 1);
    if (input == NULL || strncmp(input, SCENE_PREFIX, strlen(SCENE_PREFIX)) == 0) {
        return read_scene(job, p);
    }
    if (stat(input, &entry) == 0 && S_ISDIR(entry.st_mode)) {
        return read_stack(job, p);
    }
    if (print_job_is_named(input)) {
        exit_status refused = refuse_options(job, MESH_ONLY | OPTION_RESOLUTION, "A job");
        return refused == EXIT_GOOD ? print_job_open(job, p) : refused;
    }
    if (print_job_is_contours(input)) {
        exit_status refused = refuse_options(job, MESH_ONLY, "A file of contours");
        return refused == EXIT_GOOD ? print_job_read_contours(job, p) : refused;
    }
    return sf_mesh_format_from_name(input) == SF_MESH_FORMAT_THREEMF ? read_3mf(job, p)
                                                                     : read_mesh(job, p);
}

exit_status part_open(cli_job *job, part *p)
{
    exit_status status = read_any(job, p);
    return status == EXIT_GOOD ? inner_read(job, p) : status;
}

exit_status part_read(cli_job *job, part *p)
{
    exit_status status = part_open(job, p);
    return status == EXIT_GOOD && p->layers != NULL ? print_job_load(job, p) : status;
}

// ---------------------------------------------------------------------------------------------
// Voxels
// ---------------------------------------------------------------------------------------------

static exit_status fill(cli_job *job, part *p)
{
    sf_voxelize_options how = sf_voxelize_options_default();
    sf_voxelize_report done;
    how.fill = job->options.fill;
    progress_phase("turning into voxels");
    sf_status status =
        sf_grid_voxelize(p->grid, sf_mesh_get_view(p->mesh), &how, NULL, &job->task, &done);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, job->options.input, EXIT_INPUT);
    }
    if (done.solid_voxels == 0) {
        return job_fail(job, EXIT_INPUT,
                        "%s: No voxel has its centre inside the part: it is too thin, or has no "
                        "inside; try a finer --pitch, or --fill surface.",
                        job->options.input);
    }
    if (done.boundary_edges > 0) {
        job_warn(job,
                 "The mesh is not closed (%llu open edges); what is inside was judged by "
                 "winding numbers.",
                 (unsigned long long)done.boundary_edges);
    }
    if (done.flipped) {
        job_warn(job, "The mesh is inside out; it was turned.");
    }
    return EXIT_GOOD;
}

exit_status part_voxelize(cli_job *job, part *p)
{
    double low[3], high[3];
    sf_lattice lattice;
    if (p->grid != NULL) {
        return EXIT_GOOD;
    }
    if (p->layers != NULL) {
        return print_job_load(job, p);
    }
    longest_side(sf_mesh_get_view(p->mesh), low, high);
    exit_status status = lattice_choose(job, low, high, &lattice, &p->lift);
    if (status == EXIT_GOOD) {
        status = inner_align(job, p, &lattice);
    }
    if (status != EXIT_GOOD) {
        return status;
    }
    sf_status made = sf_grid_create(&lattice, NULL, &p->grid);
    if (made != SF_OK) {
        return job_fail_call(job, made, NULL, "the grid", EXIT_RESOURCE);
    }
    status = fill(job, p);
    return status == EXIT_GOOD ? inner_take(job, p) : status;
}

// ---------------------------------------------------------------------------------------------
// Rule and bed
// ---------------------------------------------------------------------------------------------

static exit_status choose_bed(cli_job *job, part *p, const sf_lattice *lattice)
{
    double bed_mm = job->options.bed_mm;
    uint32_t k = 0;
    if ((job->options.given & OPTION_BED) == 0) {
        return EXIT_GOOD;
    }
    while (k < lattice->nz && sf_lattice_layer_bottom(lattice, k + 1) <=
                                  bed_mm + 1e-6 * sf_lattice_layer_height(lattice, k)) {
        k++;
    }
    if (k == lattice->nz) {
        return job_fail(job, EXIT_USAGE, "--bed %g lies above the part, which ends at %g mm.",
                        bed_mm, sf_lattice_layer_bottom(lattice, lattice->nz));
    }
    p->bed_layer = k;
    return EXIT_GOOD;
}

// Where nobody asked for a rule, the one that an angle is best met with: on oblong pixels slack.
static void choose_rule(cli_job *job, const part *p, const sf_lattice *lattice)
{
    cli_options *asked = &job->options;
    if ((asked->given & OPTION_RULE) == 0 && !p->own_rule && asked->rule == SF_RULE_OCTAGON &&
        lattice->pitch_x_mm != lattice->pitch_y_mm) {
        asked->rule = SF_RULE_SLACK;
    }
}

// A rule that cannot be: the command line's fault, or that of the stack that brought it.
static exit_status refuse_rule(cli_job *job, sf_status status, const sf_fault *fault, int is_own,
                               const char *option, const char *field)
{
    char subject[sizeof job->message];
    snprintf(subject, sizeof subject, "%.400s: stack.json: %s", job->options.input, field);
    return is_own ? job_fail_call(job, status, fault, subject, EXIT_INPUT)
                  : job_fail_call(job, status, fault, option, EXIT_USAGE);
}

exit_status part_make_rule(cli_job *job, part *p)
{
    sf_lattice lattice = part_lattice(p);
    choose_rule(job, p, &lattice);
    sf_fault fault = {SF_OK, 0, 0, ""};
    size_t count = sf_rule_table_count(&lattice);
    if (count > 0) {
        p->table = malloc(count * sizeof *p->table);
        if (p->table == NULL) {
            return job_fail(job, EXIT_RESOURCE, "There is no memory for the rule's table.");
        }
    }
    sf_status status = sf_rule_make(job->options.rule, job->options.angle_rad, &lattice, p->table,
                                    &p->rule, &fault);
    if (status != SF_OK) {
        int is_own = p->own_rule && (job->options.given & OPTION_ANGLE) == 0;
        return refuse_rule(job, status, &fault, is_own, sf_rule_kind_name(job->options.rule),
                           "rule");
    }
    status = sf_rule_set_bridges(&p->rule, job->options.bridge_mm[0], job->options.bridge_mm[1],
                                 &lattice, &fault);
    if (status != SF_OK) {
        return refuse_rule(job, status, &fault, p->own_bridges, "--bridge", "bridge_mm");
    }
    p->has_rule = 1;
    return choose_bed(job, p, &lattice);
}

sf_terms part_terms(const part *p)
{
    sf_terms terms = sf_terms_default();
    terms.rule = p->rule;
    terms.bed_layer = p->bed_layer;
    return terms;
}

sf_transform part_to_input(const cli_job *job)
{
    return upright_back(job->options.up);
}

void part_release(part *p)
{
    sf_mesh_destroy(p->mesh);
    sf_mesh_destroy(p->inner);
    sf_grid_destroy(p->grid);
    print_job_close(p);
    free(p->table);
    memset(p, 0, sizeof *p);
}
