// SPDX-License-Identifier: MIT
// A model that is made to stand.
//
// The library knows one build direction, z; so the part is turned to it as for every other verb,
// and gravity, contacts and handles are turned with it. Each round leaves a line on a terminal, so
// that one sees the margin rise, and may stop where it is enough.

#include "stand_model.h"

#include "change.h"
#include "describe.h"
#include "extent.h"
#include "halves.h"
#include "progress.h"
#include "stances_check.h"
#include "stand_drill.h"
#include "stand_feet.h"

#include <math.h>
#include <string.h>

#define DEGREES (180 / 3.14159265358979323846)

// ---------------------------------------------------------------------------------------------
// The part
// ---------------------------------------------------------------------------------------------

// The same triangles, each the other way around.
static sf_status turn_over(sf_mesh **mesh)
{
    sf_mesh_view view = sf_mesh_get_view(*mesh);
    sf_mesh *made = NULL;
    sf_status status = sf_mesh_create(NULL, &made);
    if (status == SF_OK) {
        status = sf_mesh_add_vertices(made, view.vertices, view.vertex_count);
    }
    for (size_t t = 0; status == SF_OK && t < view.triangle_count; t++) {
        const uint32_t *c = view.triangles + 3 * t;
        const uint32_t corners[3] = {c[0], c[2], c[1]};
        status = sf_mesh_add_triangles(made, corners, 1);
    }
    if (status == SF_OK) {
        sf_mesh_destroy(*mesh);
        *mesh = made;
    } else {
        sf_mesh_destroy(made);
    }
    return status;
}

static exit_status close_mesh(cli_job *job, part *p)
{
    const char *input = job->options.input;
    sf_topology topology;
    sf_status status = sf_mesh_analyze(sf_mesh_get_view(p->mesh), NULL, &topology);
    if (status == SF_OK && (!topology.closed || !topology.oriented)) {
        return job_fail(job, EXIT_INPUT,
                        "%s: The mesh is %s, so it has no inside and no weight; close it first "
                        "('sf repair' or 'sf slice' and 'sf trim' write closed meshes).",
                        input, topology.closed ? "not oriented alike everywhere" : "open");
    }
    if (status == SF_OK && topology.flipped) {
        job_warn(job, "The mesh is inside out; it was turned.");
        status = turn_over(&p->mesh);
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, NULL, input, EXIT_INPUT);
}

static exit_status check_cubes(cli_job *job)
{
    const double *pitch = job->options.pitch_mm;
    if ((job->options.given & OPTION_PITCH) &&
        (fabs(pitch[1] - pitch[0]) > 0 || fabs(pitch[2] - pitch[0]) > 0)) {
        return job_fail(job, EXIT_USAGE, "'sf stand' works with cubes: --pitch takes one number.");
    }
    return EXIT_GOOD;
}

exit_status model_read(cli_job *job, model *m)
{
    double low[3], high[3];
    m->wall_min_mm = INFINITY;
    m->densities.all = 1;
    exit_status status = check_cubes(job);
    if (status == EXIT_GOOD) {
        status = part_read(job, &m->part);
    }
    if (status == EXIT_GOOD && m->part.mesh == NULL) {
        return job_fail(job, EXIT_INPUT, "%s: 'sf stand' takes a mesh.", job->options.input);
    }
    if (status == EXIT_GOOD) {
        status = halves_check_part(job, &m->part);
    }
    if (status == EXIT_GOOD) {
        status = close_mesh(job, &m->part);
    }
    if (status == EXIT_GOOD) {
        status = part_voxelize(job, &m->part);
    }
    if (status == EXIT_GOOD) {
        m->lattice = sf_grid_lattice(m->part.grid);
        status = densities_read(job, &m->part, &m->densities);
    }
    if (status == EXIT_GOOD && sf_mesh_bounds(sf_mesh_get_view(m->part.mesh), low, high) == SF_OK) {
        for (int i = 0; i < 3; i++) {
            m->size_mm = fmax(m->size_mm, high[i] - low[i]);
        }
    }
    return status;
}

// ---------------------------------------------------------------------------------------------
// Options
// ---------------------------------------------------------------------------------------------

static size_t voxel_of(double at, double origin, double pitch, uint32_t count)
{
    double v = floor((at - origin) / pitch);
    return v > 0 ? (v < count ? (size_t)v : count - 1) : 0;
}

static size_t voxel_at(const model *m, const double p[3])
{
    const sf_lattice *l = &m->lattice;
    size_t x = voxel_of(p[0], l->origin_mm[0], l->pitch_x_mm, l->nx);
    size_t y = voxel_of(p[1], l->origin_mm[1], l->pitch_y_mm, l->ny);
    size_t k = voxel_of(p[2], l->origin_mm[2], l->layer_mm, l->nz);
    return (k * l->ny + y) * l->nx + x;
}

static double density_at(void *user, const double p[3])
{
    const model *m = user;
    return m->densities.each != NULL ? m->densities.each[voxel_at(m, p)] : m->densities.all;
}

static int is_kept_at(void *user, const double p[3])
{
    const model *m = user;
    return m->densities.kept[voxel_at(m, p)] > 1;
}

static exit_status choose(cli_job *job, model *m)
{
    const cli_options *asked = &job->options;
    sf_stand_options *o = &m->options;
    *o = sf_stand_options_default();
    o->pitch_mm = m->lattice.pitch_x_mm;
    o->wall_mm = asked->wall_mm > 0 ? asked->wall_mm : 0.01 * m->size_mm;
    o->carve = (asked->given & OPTION_NO_CARVE) == 0;
    o->deform = (asked->given & OPTION_NO_DEFORM) == 0 && m->handles.count > 0;
    o->carve_mode = asked->stand.carve;
    o->solver = asked->stand.solver;
    o->mu = asked->stand.mu;
    o->shift_max_mm = asked->stand.shift_max_mm;
    o->turn = (asked->given & OPTION_TURN) != 0;
    o->rule = asked->rule;
    o->angle_rad = asked->angle_rad;
    if (asked->given & OPTION_NO_LAPLACIAN) {
        o->weight_details = 0;
    }
    if (asked->given & OPTION_DENSITY) {
        o->density = density_at;
        o->density_user = m;
    }
    if (m->densities.kept != NULL) {
        o->keep = is_kept_at;
        o->keep_user = m;
    }
    o->ballast = m->densities.masses;
    o->ballast_count = m->densities.mass_count;
    return asked->min_feature_mm > 0 ? change_width(job, &m->part, &o->strut_width_vx) : EXIT_GOOD;
}

// ---------------------------------------------------------------------------------------------
// Rounds
// ---------------------------------------------------------------------------------------------

// Places that were found on voxels may be too close to what holds still; the last ones, which were
// the worst, go then.
static exit_status prepare(cli_job *job, model *m)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_mesh_view mesh = sf_mesh_get_view(m->part.mesh);
    sf_status status;
    for (;;) {
        status =
            sf_stand_create(mesh, m->stances.each, m->stances.count, m->handles.each,
                            m->handles.count, &m->options, NULL, &job->task, &m->stand, &fault);
        if (status != SF_ERR_INFEASIBLE || !m->handles.are_placed || m->handles.count == 0) {
            break;
        }
        m->handles.count--;
        m->options.deform = m->options.deform && m->handles.count > 0;
    }
    for (size_t i = 0; status == SF_OK && i < m->handles.count; i++) {
        if (m->handles.posed[i]) {
            status =
                sf_stand_set_pose(m->stand, i, &m->handles.poses[i], m->handles.each[i].locked);
        }
    }
    if (status == SF_ERR_INFEASIBLE) {
        char words[EXTENT_WORDS_SIZE];
        extent_words(job, &m->part, words);
        return job_fail(job, EXIT_INPUT,
                        "%s: %s. What it stands on or hangs from counts as handle %zu; the model "
                        "spans %s.",
                        job->options.input, fault.message, m->handles.count + 1, words);
    }
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, &fault, job->options.input, EXIT_INPUT);
}

static void say_round(const model *m)
{
    const sf_stand_report *r = &m->report;
    char volume[DESCRIBE_MM3_SIZE];
    progress_line("round %2u: margin %7.2f degrees, %s carved out, bent by %.1f %% of its size",
                  r->rounds, r->margin_rad * DEGREES, describe_mm3(r->carved_mm3, volume),
                  100 * r->displacement_mm / m->size_mm);
}

// Solid as the rounds see it: by winding, where the shape runs into itself.
static sf_status make_cavity(cli_job *job, model *m, const sf_grid *carved)
{
    sf_lattice lattice = sf_grid_lattice(carved);
    sf_voxelize_options how = sf_voxelize_options_default();
    how.fill = SF_FILL_WINDING;
    sf_status status = sf_grid_create(&lattice, NULL, &m->solid);
    if (status == SF_OK) {
        status = sf_grid_create(&lattice, NULL, &m->cavity);
    }
    if (status == SF_OK) {
        status = sf_grid_voxelize(m->solid, sf_stand_outer(m->stand), &how, NULL, &job->task, NULL);
    }
    for (uint32_t k = 0; status == SF_OK && k < lattice.nz; k++) {
        status = sf_slice_subtract(sf_grid_slice(m->cavity, k), sf_grid_slice(m->solid, k),
                                   sf_grid_slice(carved, k));
    }
    return status;
}

// How near the cavity comes to the outside, as they are now.
static sf_status measure_wall(cli_job *job, model *m)
{
    const sf_grid *carved = sf_stand_grid(m->stand);
    if (carved == NULL || sf_stand_cavity(m->stand).triangle_count == 0) {
        return SF_OK;
    }
    sf_status status = make_cavity(job, m, carved);
    return status == SF_OK ? sf_grid_clearance(m->cavity, sf_stand_outer(m->stand), NULL,
                                               &job->task, &m->wall_min_mm)
                           : status;
}

// How far vertices went that came in, feet that were put flat included.
static double measure_moved(const model *m)
{
    sf_mesh_view was = sf_mesh_get_view(m->part.mesh), now = sf_stand_outer(m->stand);
    double most = 0;
    for (size_t v = 0; v < was.vertex_count && v < now.vertex_count; v++) {
        const double *a = was.vertices + 3 * v, *b = now.vertices + 3 * v;
        double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
        most = fmax(most, x * x + y * y + z * z);
    }
    return sqrt(most);
}

static exit_status go(cli_job *job, model *m)
{
    m->report = sf_stand_describe(m->stand);
    m->flattened_mm = measure_moved(m);
    sf_status status = SF_OK;
    progress_line("at first: margin %7.2f degrees", m->report.margin_rad * DEGREES);
    while (status == SF_OK && !m->report.ended) {
        progress_phase("balancing");
        status = sf_stand_round(m->stand, &job->task, &m->report);
        if (status == SF_OK) {
            say_round(m);
        }
    }
    m->moved_mm = measure_moved(m);
    if (status == SF_OK) {
        progress_phase("measuring the wall");
        status = measure_wall(job, m);
    }
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, NULL, job->options.input, EXIT_RESOURCE);
}

exit_status model_run(cli_job *job, model *m)
{
    exit_status status = stances_read(job, &m->part, m->up, &m->stances);
    if (status == EXIT_GOOD) {
        status = stances_check(job, &m->part, &m->stances);
    }
    if (status == EXIT_GOOD) {
        status = stand_feet(job, m);
    }
    if (status == EXIT_GOOD) {
        status = handles_read(job, &m->part, &m->stances, &m->handles);
    }
    if (status == EXIT_GOOD) {
        status = choose(job, m);
    }
    if (status == EXIT_GOOD) {
        progress_phase("preparing");
        status = prepare(job, m);
    }
    if (status == EXIT_GOOD) {
        status = go(job, m);
    }
    return status == EXIT_GOOD && job->options.drain_mm > 0 ? stand_drill(job, m) : status;
}

int model_holds(const model *m)
{
    return m->report.succeeded &&
           (m->drilled.after == NULL || (m->drilled.safe && m->drilled.report.closed_count == 0));
}

void model_release(model *m)
{
    sf_stand_destroy(m->stand);
    sf_grid_destroy(m->solid);
    sf_grid_destroy(m->cavity);
    sf_grid_destroy(m->drilled.after);
    densities_release(&m->densities);
    part_release(&m->part);
    memset(m, 0, sizeof *m);
}
