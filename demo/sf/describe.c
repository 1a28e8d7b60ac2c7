// SPDX-License-Identifier: MIT
// What every verb says about its input and its lattice.

#include "describe.h"

#include "values.h"

#include <stdio.h>
#include <stdlib.h>

double describe_volume(const sf_grid *grid)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    double volume = 0;
    for (uint32_t k = 0; k < lattice.nz; k++) {
        volume += (double)sf_slice_popcount(sf_grid_slice(grid, k)) *
                  sf_lattice_layer_height(&lattice, k);
    }
    return volume * lattice.pitch_x_mm * lattice.pitch_y_mm;
}

const char *describe_mm3(double volume_mm3, char text[DESCRIBE_MM3_SIZE])
{
    const char *form = volume_mm3 >= 1000 && volume_mm3 < 1e15 ? "%.0f mm3" : "%.4g mm3";
    snprintf(text, DESCRIBE_MM3_SIZE, form, volume_mm3);
    return text;
}

void describe_lattice(report *r, const sf_lattice *lattice)
{
    double pitch[2] = {lattice->pitch_x_mm, lattice->pitch_y_mm};
    report_begin(r, "lattice");
    report_count(r, "nx", lattice->nx);
    report_count(r, "ny", lattice->ny);
    report_count(r, "nz", lattice->nz);
    report_numbers(r, "pitch_mm", pitch, 2);
    if (lattice->heights_mm == NULL) {
        report_number(r, "layer_mm", lattice->layer_mm);
    } else {
        report_numbers(r, "layer_mm", lattice->heights_mm, lattice->nz);
    }
    report_numbers(r, "origin_mm", lattice->origin_mm, 3);
    report_end(r);
}

static void report_rule(report *r, const part *p, const sf_lattice *lattice,
                        const cli_options *asked)
{
    const double degrees = 180 / 3.14159265358979323846;
    sf_rule_angles angles;
    report_begin(r, "rule");
    report_text(r, "kind", sf_rule_kind_name(p->rule.kind));
    if (p->rule.kind == SF_RULE_BOX3) {
        report_null(r, "angle_deg");
    } else {
        report_number(r, "angle_deg", values_angle_deg(asked));
    }
    if (asked->bridge_mm[0] > 0) {
        report_numbers(r, "bridge_mm", asked->bridge_mm, 2);
    }
    if (sf_rule_measure(&p->rule, lattice, &angles) == SF_OK) {
        report_number(r, "allows_x_deg", angles.axis_x_rad * degrees);
        report_number(r, "allows_y_deg", angles.axis_y_rad * degrees);
        report_number(r, "allows_diagonal_deg", angles.diagonal_rad * degrees);
        report_number(r, "allows_steepest_deg", angles.steepest_rad * degrees);
    }
    report_end(r);
}

static void say_part(report *r, const part *p, const sf_lattice *lattice, const cli_options *asked)
{
    char rule[96] = "", bridges[48] = "";
    if (asked->bridge_mm[0] > 0) {
        snprintf(bridges, sizeof bridges, ", bridges up to %g mm", asked->bridge_mm[0]);
    }
    if (!p->has_rule) {
        // slicing alone needs no rule
    } else if (p->rule.kind == SF_RULE_BOX3) {
        snprintf(rule, sizeof rule, ", rule box3%s", bridges);
    } else {
        snprintf(rule, sizeof rule, ", overhangs up to %g degrees (%s)%s", values_angle_deg(asked),
                 sf_rule_kind_name(p->rule.kind), bridges);
    }
    report_say(r, "%s: %u x %u x %u voxels of %.4g x %.4g x %.4g mm%s",
               asked->input != NULL ? asked->input : "scene:garden", lattice->nx, lattice->ny,
               lattice->nz, lattice->pitch_x_mm, lattice->pitch_y_mm,
               sf_lattice_layer_height(lattice, 0), rule);
}

void describe_part(cli_job *job, const part *p, const char *verb)
{
    sf_lattice lattice = part_lattice(p);
    report *r = job->report;
    report_text(r, "verb", verb);
    report_text(r, "input", job->options.input != NULL ? job->options.input : "scene:garden");
    describe_lattice(r, &lattice);
    if (p->has_rule) {
        report_rule(r, p, &lattice, &job->options);
    }
    if (p->bed_layer == SF_BED_AUTO) {
        report_text(r, "bed_layer", "first with matter");
    } else {
        report_count(r, "bed_layer", p->bed_layer);
    }
    say_part(r, p, &lattice, &job->options);
}
