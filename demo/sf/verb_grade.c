// SPDX-License-Identifier: MIT
// sf grade: a solid of many materials, as layers for a printer that mixes them.

#include "describe.h"
#include "graded.h"
#include "output.h"
#include "package.h"
#include "solids.h"
#include "verbs.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const mask_names[] = {"slice", "isotropic", "diffuse"};

// ---------------------------------------------------------------------------------------------
// Which property, which materials
// ---------------------------------------------------------------------------------------------

// The property that is meant where no file of materials says so.
static exit_status the_property(cli_job *job, const solid_input *in, const char **name)
{
    const sf_channel *channels;
    size_t count = solids_channels(in, &channels);
    if (job->options.property != NULL) {
        *name = job->options.property;
        return EXIT_GOOD;
    }
    if (count == 0) {
        return job_fail(
            job, EXIT_INPUT,
            "%s has no properties: give its points or cells some (point or cell data of "
            "VTK, references of Medit).",
            job->options.input);
    }
    if (count > 1) {
        return job_fail(job, EXIT_USAGE,
                        "%s has %zu properties, such as '%s' and '%s'; say which one "
                        "with --property, or which mixtures with --materials.",
                        job->options.input, count, channels[0].property.name,
                        channels[1].property.name);
    }
    *name = channels[0].property.name;
    return EXIT_GOOD;
}

// Two materials from the least to the greatest value that a point has.
static exit_status choose_two(cli_job *job, const solid_input *in, materials *m)
{
    const char *name = NULL;
    size_t channel = 0;
    exit_status status = the_property(job, in, &name);
    if (status == EXIT_GOOD) {
        status = solids_find_property(job, in, name, &channel);
    }
    if (status != EXIT_GOOD) {
        return status;
    }
    const sf_channel *channels;
    (void)solids_channels(in, &channels);
    const sf_channel *c = &channels[channel];
    double low = c->values[0], high = c->values[0];
    for (size_t i = 0; i < c->value_count; i++) {
        low = fmin(low, c->values[i]);
        high = fmax(high, c->values[i]);
    }
    if (low == high) {
        job_warn(
            job,
            "%s: '%s' is %g everywhere, so that all of it is of one material; paint it, or say "
            "by --materials what %g is.",
            job->options.input, name, low, low);
    }
    return materials_between(job, name, low, high, m);
}

static exit_status choose(cli_job *job, const solid_input *in, materials *m, size_t *channels)
{
    exit_status status =
        job->options.materials != NULL ? materials_read(job, m) : choose_two(job, in, m);
    if (status == EXIT_GOOD && job->options.property != NULL) {
        if (m->property_count != 1) {
            return job_fail(job, EXIT_USAGE,
                            "--property names one property, and the materials know "
                            "%zu.",
                            m->property_count);
        }
        snprintf(m->properties[0], SF_PROPERTY_NAME_SIZE, "%s", job->options.property);
    }
    for (size_t i = 0; status == EXIT_GOOD && i < m->property_count; i++) {
        status = solids_find_property(job, in, m->properties[i], &channels[i]);
    }
    return status;
}

// ---------------------------------------------------------------------------------------------
// What became of it
// ---------------------------------------------------------------------------------------------

static void report_materials(cli_job *job, const materials *m, const graded *g)
{
    report *r = job->report;
    report_begin_list(r, "materials");
    for (uint32_t i = 0; i < m->count; i++) {
        double solid = (double)(g->voxels.solid > 0 ? g->voxels.solid : 1);
        report_begin(r, NULL);
        report_text(r, "name", m->table[i].name);
        report_count(r, "voxels", g->uses[i].voxels);
        report_number(r, "volume_mm3", g->uses[i].volume_mm3);
        if (m->table[i].density_g_cm3 > 0) {
            report_number(r, "grams", g->uses[i].mass_g);
        } else {
            report_null(r, "grams");
        }
        report_number(r, "tone_asked", g->asked[i] / solid);
        report_number(r, "tone_obtained", (double)g->uses[i].voxels / solid);
        report_end(r);
    }
    report_end(r);
}

static void report_fields(cli_job *job, const solid_input *in, const materials *m, const graded *g)
{
    report *r = job->report;
    report_text(r, "verb", "grade");
    report_text(r, "input", job->options.input);
    solids_report(job, in);
    describe_lattice(r, &g->lattice);
    report_begin_list(r, "properties");
    for (size_t i = 0; i < m->property_count; i++) {
        report_text(r, NULL, m->properties[i]);
    }
    report_end(r);
    report_text(r, "mask", mask_names[job->options.mask]);
    report_number(r, "surface_error_mm", g->surface_error_mm);
    report_count(r, "solid_voxels", g->voxels.solid);
    report_count(r, "located_voxels", g->voxels.located);
    report_count(r, "filled_voxels", g->voxels.filled);
    report_count(r, "missed_voxels", g->missed);
    report_number(r, "worst_miss", g->worst_miss);
    if (job->options.given & (OPTION_SHELL | OPTION_KEEP_OUT)) {
        report_number(r, "shell_mm", job->options.shell_mm);
        report_count(r, "shell_voxels", g->shell);
    }
    report_materials(job, m, g);
    report_text(r, "output", job->options.output);
    if (job->options.picture != NULL) {
        report_text(r, "picture", job->options.picture);
    }
}

static void say(cli_job *job, const materials *m, const graded *g)
{
    report *r = job->report;
    const sf_lattice *l = &g->lattice;
    double solid = (double)(g->voxels.solid > 0 ? g->voxels.solid : 1);
    report_say(r, "%s: %u layers of %u x %u voxels, %.4g x %.4g x %.4g mm each; %llu are solid.",
               job->options.input, l->nz, l->nx, l->ny, l->pitch_x_mm, l->pitch_y_mm, l->layer_mm,
               (unsigned long long)g->voxels.solid);
    for (uint32_t i = 0; i < m->count; i++) {
        char volume[DESCRIBE_MM3_SIZE], grams[48] = "";
        if (m->table[i].density_g_cm3 > 0) {
            snprintf(grams, sizeof grams, ", %.4g g", g->uses[i].mass_g);
        }
        report_say(r, "  %-12s %s%s; asked for %.3f %% of the solid, got %.3f %%", m->table[i].name,
                   describe_mm3(g->uses[i].volume_mm3, volume), grams, 100 * g->asked[i] / solid,
                   100 * (double)g->uses[i].voxels / solid);
    }
    if (g->missed > 0) {
        report_say(r,
                   "%llu voxels ask for what no mixture has, and got the nearest one: off by at "
                   "most %.4g%s.",
                   (unsigned long long)g->missed, g->worst_miss,
                   m->property_count > 1 ? " spans of what was measured" : "");
    }
    report_say(r, "Written to %s.", job->options.output);
}

// A file of the mixture itself, which nobody has made dots of.
static void report_package(cli_job *job, const solid_input *in, const materials *m, const graded *g)
{
    report *r = job->report;
    const sf_lattice *l = &g->lattice;
    double solid = (double)(g->voxels.solid > 0 ? g->voxels.solid : 1);
    double voxel_mm3 = l->pitch_x_mm * l->pitch_y_mm * l->layer_mm;
    report_text(r, "verb", "grade");
    report_text(r, "input", job->options.input);
    solids_report(job, in);
    describe_lattice(r, l);
    report_number(r, "surface_error_mm", g->surface_error_mm);
    report_count(r, "solid_voxels", g->voxels.solid);
    report_say(r, "%s: a surface, and %u layers of %u x %u voxels, %.4g x %.4g x %.4g mm each.",
               job->options.input, l->nz, l->nx, l->ny, l->pitch_x_mm, l->pitch_y_mm, l->layer_mm);
    report_begin_list(r, "materials");
    for (uint32_t i = 0; i < m->count; i++) {
        char volume[DESCRIBE_MM3_SIZE];
        report_begin(r, NULL);
        report_text(r, "name", m->table[i].name);
        report_number(r, "volume_mm3", g->asked[i] * voxel_mm3);
        report_number(r, "tone_asked", g->asked[i] / solid);
        report_end(r);
        report_say(r, "  %-12s %s, %.3f %% of the solid", m->table[i].name,
                   describe_mm3(g->asked[i] * voxel_mm3, volume), 100 * g->asked[i] / solid);
    }
    report_end(r);
    report_text(r, "output", job->options.output);
    report_say(r, "Written to %s.", job->options.output);
}

// What 3MF holds is what is mixed where, not how a printer makes it of dots.
static exit_status check_package(cli_job *job)
{
    const uint64_t useless = OPTION_MASK | OPTION_SHELL | OPTION_KEEP_OUT | OPTION_PICTURE;
    return (job->options.given & useless) == 0
               ? EXIT_GOOD
               : job_fail(job, EXIT_USAGE,
                          "A 3MF file holds the mixture itself, and no dots: leave out --mask, "
                          "--shell, --keep-out and --picture.");
}

static exit_status grade(cli_job *job, const solid_input *in, materials *m)
{
    graded g;
    shells shell;
    size_t channels[MATERIALS_PROPERTIES_MAX];
    exit_status status = choose(job, in, m, channels);
    if (status == EXIT_GOOD) {
        status = shells_choose(job, m, &shell);
    }
    if (status == EXIT_GOOD) {
        status = graded_write(job, in, channels, m, &shell, job->options.output, &g);
    }
    if (status == EXIT_GOOD && package_is_asked(job->options.output)) {
        report_package(job, in, m, &g);
        report_number(job->report, "seconds", job_seconds(job));
    } else if (status == EXIT_GOOD) {
        report_fields(job, in, m, &g);
        say(job, m, &g);
        report_number(job->report, "seconds", job_seconds(job));
    }
    return status;
}

exit_status verb_grade(cli_job *job)
{
    materials m;
    solid_input in = {NULL, NULL};
    memset(&m, 0, sizeof m);
    if (job->options.output == NULL) {
        return job_fail(job, EXIT_USAGE, "Say where the layers go: -o FOLDER, or -o FILE.3mf.");
    }
    if (job->options.picture != NULL && output_kind_of(job->options.picture) != OUTPUT_PICTURE) {
        return job_fail(job, EXIT_USAGE, "--picture %s: a picture's name ends in .png.",
                        job->options.picture);
    }
    int is_package = package_is_asked(job->options.output);
    exit_status status = is_package ? check_package(job) : EXIT_GOOD;
    if (status == EXIT_GOOD) {
        status = output_probe(job, job->options.output, is_package ? OUTPUT_MESH : OUTPUT_STACK);
    }
    if (status == EXIT_GOOD) {
        status = output_probe(job, job->options.picture, OUTPUT_PICTURE);
    }
    if (status == EXIT_GOOD) {
        status = solids_read(job, &in);
    }
    if (status == EXIT_GOOD) {
        status = grade(job, &in, &m);
    }
    materials_free(&m);
    solids_release(&in);
    return status;
}
