// SPDX-License-Identifier: MIT
// sf info: what a part is. Of a stack or a scene, which are voxels, what only triangles have is
// null.

#include "describe.h"
#include "mass.h"
#include "part.h"
#include "progress.h"
#include "verbs.h"

#include <math.h>

static void report_mass(report *r, const sf_mass *m, const double bounds[6])
{
    report_numbers(r, "com_mm", m->com_mm, 3);
    report_numbers(r, "inertia_mm5", m->inertia_mm5, 6);
    report_begin(r, "bounds_mm");
    report_numbers(r, "low", bounds, 3);
    report_numbers(r, "high", bounds + 3, 3);
    report_end(r);
}

static void report_fields(report *r, const char *input, const sf_mesh_view *mesh,
                          const sf_topology *t, const sf_mass *m, const double bounds[6])
{
    report_text(r, "verb", "info");
    report_text(r, "input", input);
    report_count(r, "triangles", mesh->triangle_count);
    report_count(r, "vertices", t->vertex_count);
    report_flag(r, "closed", t->closed);
    report_count(r, "boundary_edges", t->boundary_edges);
    report_count(r, "nonmanifold_edges", t->nonmanifold_edges);
    report_count(r, "misoriented_edges", t->misoriented_edges);
    report_count(r, "degenerate_triangles", t->degenerate_triangles);
    report_count(r, "shells", t->shells);
    report_count(r, "flipped_shells", t->flipped_shells);
    report_flag(r, "oriented", t->oriented);
    report_flag(r, "flipped", t->flipped);
    report_number(r, "volume_mm3", m->volume_mm3);
    report_number(r, "area_mm2", m->area_mm2);
    report_mass(r, m, bounds);
}

// A coordinate for people: rounding errors of the file's author are zeros.
static double tidy(double coordinate, const double bounds[6])
{
    double largest = 0;
    for (int i = 0; i < 6; i++) {
        largest = fmax(largest, fabs(bounds[i]));
    }
    return fabs(coordinate) < 1e-9 * largest ? 0 : coordinate;
}

static void say_place(report *r, const char *what, const double at[3], const double bounds[6])
{
    report_say(r, "%-15s (%.6g, %.6g, %.6g) mm", what, tidy(at[0], bounds), tidy(at[1], bounds),
               tidy(at[2], bounds));
}

static void say_bounds(report *r, const double bounds[6])
{
    report_say(r, "size            %.6g x %.6g x %.6g mm", bounds[3] - bounds[0],
               bounds[4] - bounds[1], bounds[5] - bounds[2]);
    say_place(r, "lower corner", bounds, bounds);
    say_place(r, "upper corner", bounds + 3, bounds);
}

static void say(report *r, const char *input, const sf_mesh_view *mesh, const sf_topology *t,
                const sf_mass *m, const double bounds[6])
{
    report_say(r, "%s: %zu triangles, %zu vertices, %zu shell%s", input, mesh->triangle_count,
               t->vertex_count, t->shells, t->shells == 1 ? "" : "s");
    say_bounds(r, bounds);
    report_say(r, "volume          %.8g mm3%s", m->volume_mm3,
               t->closed ? "" : " (an estimate: the surface has holes)");
    report_say(r, "area            %.8g mm2", m->area_mm2);
    say_place(r, "centre of mass", m->com_mm, bounds);
    if (t->closed && t->oriented && !t->flipped) {
        report_say(r, "The surface is closed and faces outwards.");
    } else if (t->closed && t->oriented) {
        report_say(r, "The surface is closed, but inside out.");
    } else if (t->closed) {
        report_say(r,
                   "The surface is closed, but %zu edges join triangles that face opposite ways.",
                   t->misoriented_edges);
    } else {
        report_say(r, "The surface is not closed: %zu edges have one triangle only.",
                   t->boundary_edges);
    }
    if (t->nonmanifold_edges > 0) {
        report_say(r, "%zu edges have more than two triangles.", t->nonmanifold_edges);
    }
    if (t->degenerate_triangles > 0) {
        report_say(r, "%zu triangles have two equal corners.", t->degenerate_triangles);
    }
}

static exit_status examine(cli_job *job, const part *p)
{
    sf_mesh_view mesh = sf_mesh_get_view(p->mesh);
    sf_topology topology;
    sf_mass mass;
    double bounds[6];
    progress_phase("examining");
    sf_status status = sf_mesh_analyze(mesh, NULL, &topology);
    if (status == SF_OK) {
        status = sf_mesh_measure(mesh, &mass);
    }
    if (status == SF_OK) {
        status = sf_mesh_bounds(mesh, bounds, bounds + 3);
    }
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, job->options.input, EXIT_INPUT);
    }
    report_fields(job->report, job->options.input, &mesh, &topology, &mass, bounds);
    say(job->report, job->options.input, &mesh, &topology, &mass, bounds);
    return EXIT_GOOD;
}

// Corners of the box around the solid voxels.
static void grid_bounds(const sf_grid *grid, double bounds[6])
{
    sf_lattice lattice = sf_grid_lattice(grid);
    sf_box box = sf_grid_bounds(grid);
    const uint32_t x[2] = {box.x0, box.x1}, y[2] = {box.y0, box.y1}, z[2] = {box.z0, box.z1};
    for (int i = 0; i < 2; i++) {
        bounds[3 * i] = lattice.origin_mm[0] + x[i] * lattice.pitch_x_mm;
        bounds[3 * i + 1] = lattice.origin_mm[1] + y[i] * lattice.pitch_y_mm;
        bounds[3 * i + 2] = sf_lattice_layer_bottom(&lattice, z[i]);
    }
}

static exit_status examine_grid(cli_job *job, const part *p)
{
    static const char *const absent[] = {"triangles",
                                         "vertices",
                                         "closed",
                                         "boundary_edges",
                                         "nonmanifold_edges",
                                         "misoriented_edges",
                                         "shells",
                                         "flipped_shells",
                                         "oriented",
                                         "flipped",
                                         "degenerate_triangles",
                                         "area_mm2"};
    report *r = job->report;
    double bounds[6];
    uint64_t solid = sf_grid_popcount(p->grid);
    progress_phase("examining");
    sf_mass mass = mass_of_grid(p->grid);
    grid_bounds(p->grid, bounds);
    for (int i = 0; solid == 0 && i < 6; i++) {
        bounds[i] = NAN;
    }
    describe_part(job, p, "info");
    for (size_t i = 0; i < sizeof absent / sizeof absent[0]; i++) {
        report_null(r, absent[i]);
    }
    report_count(r, "solid_voxels", solid);
    report_number(r, "volume_mm3", mass.volume_mm3);
    report_mass(r, &mass, bounds);
    if (solid == 0) {
        report_say(r, "No voxel is solid.");
        return EXIT_GOOD;
    }
    say_bounds(r, bounds);
    report_say(r, "volume          %.8g mm3 (%llu voxels)", mass.volume_mm3,
               (unsigned long long)solid);
    say_place(r, "centre of mass", mass.com_mm, bounds);
    return EXIT_GOOD;
}

exit_status verb_info(cli_job *job)
{
    part p;
    exit_status status = part_read(job, &p);
    if (status == EXIT_GOOD) {
        status = p.kind == PART_MESH ? examine(job, &p) : examine_grid(job, &p);
    }
    if (status == EXIT_GOOD) {
        report_number(job->report, "seconds", job_seconds(job));
    }
    part_release(&p);
    return status;
}
