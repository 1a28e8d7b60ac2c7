// SPDX-License-Identifier: MIT
// A part made hollow, its voids drained, and looked at again.
//
// The wall is what comes nearer to the surface than --wall; of a part without a mesh, or whose mesh
// has holes, also what comes nearer to what is not solid. What is carved leaves nothing hanging
// that was carried before. What a hole does not fit into is filled again, so that nothing is shut
// in where --drain was given. Figures are of the result: how thin the wall is, is measured.

#include "cavity.h"

#include "describe.h"
#include "progress.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HALVINGS = 40 };

static exit_status fail(cli_job *job, sf_status status, const char *what)
{
    return job_fail_call(job, status, NULL, what, EXIT_RESOURCE);
}

// a = a AND NOT b
static sf_status subtract(sf_grid *a, const sf_grid *b)
{
    sf_status status = SF_OK;
    for (uint32_t k = 0; status == SF_OK && k < sf_grid_lattice(a).nz; k++) {
        sf_slice slice = sf_grid_slice(a, k);
        status = sf_slice_subtract(slice, slice, sf_grid_slice(b, k));
    }
    return status;
}

// ---------------------------------------------------------------------------------------------
// The wall
// ---------------------------------------------------------------------------------------------

static exit_status look_at_mesh(cli_job *job, const part *p, cavity *c)
{
    sf_topology topology;
    if (p->mesh == NULL) {
        return EXIT_GOOD;
    }
    sf_status status = sf_mesh_analyze(sf_mesh_get_view(p->mesh), NULL, &topology);
    c->is_closed = status == SF_OK && topology.closed && topology.oriented &&
                   topology.flipped_shells == 0 && !topology.flipped;
    return status == SF_OK ? EXIT_GOOD : fail(job, status, "the mesh");
}

// wall = wall OR what is near to what is not solid
static sf_status add_inside_wall(cli_job *job, const part *p, double wall_mm, sf_grid *wall)
{
    sf_lattice lattice = sf_grid_lattice(wall);
    sf_grid *inside = NULL;
    sf_status status = sf_grid_create(&lattice, NULL, &inside);
    if (status == SF_OK) {
        status = sf_grid_wall_inside(p->grid, wall_mm, NULL, &job->task, inside);
    }
    for (uint32_t k = 0; status == SF_OK && k < lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(wall, k);
        status = sf_slice_or(slice, slice, sf_grid_slice(inside, k));
    }
    sf_grid_destroy(inside);
    return status;
}

static exit_status find_wall(cli_job *job, const part *p, const densities *d, cavity *c)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    double wall_mm = job->options.wall_mm;
    progress_phase("measuring the wall");
    sf_status status = sf_grid_create(&lattice, NULL, &c->wall);
    if (status == SF_OK && p->mesh != NULL) {
        status =
            sf_grid_wall(p->grid, sf_mesh_get_view(p->mesh), wall_mm, NULL, &job->task, c->wall);
    }
    if (status == SF_OK && !c->is_closed) {
        status = add_inside_wall(job, p, wall_mm, c->wall);
    }
    if (status == SF_ERR_UNSUPPORTED) {
        return job_fail(job, EXIT_USAGE,
                        "--wall %g is more than 253 voxels of %g mm; take a coarser --pitch.",
                        wall_mm, fmin(lattice.pitch_x_mm, lattice.pitch_y_mm));
    }
    if (status == SF_OK) {
        status = densities_keep(d, c->wall);
    }
    c->wall_voxels = sf_grid_popcount(c->wall);
    return status == SF_OK ? EXIT_GOOD : fail(job, status, "the wall");
}

// ---------------------------------------------------------------------------------------------
// Carving and draining
// ---------------------------------------------------------------------------------------------

static exit_status carve(cli_job *job, const part *p, const sf_terms *terms, cavity *c)
{
    sf_carve_options o = sf_carve_options_default();
    exit_status good = EXIT_GOOD;
    if (job->options.min_feature_mm > 0) {
        good = change_width(job, p, &o.strut_width_vx);
    }
    if (good != EXIT_GOOD) {
        return good;
    }
    progress_phase("carving");
    sf_status status =
        sf_grid_carve(p->grid, c->wall, terms, &o, NULL, &job->task, c->done.after, NULL);
    if (status == SF_OK) {
        status = sf_grid_clone(p->grid, NULL, &c->carved);
    }
    if (status == SF_OK) {
        status = subtract(c->carved, c->done.after);
    }
    if (status != SF_OK) {
        return fail(job, status, "carving");
    }
    if (sf_grid_popcount(c->carved) == 0) {
        return job_fail(job, EXIT_PROPERTY,
                        "Nothing can be carved: with walls of %g mm nothing is left inside%s. "
                        "Nothing was written.",
                        job->options.wall_mm,
                        c->wall_voxels < sf_grid_popcount(p->grid) ? " that carries nothing" : "");
    }
    return EXIT_GOOD;
}

static exit_status count_voids(cli_job *job, const part *p, cavity *c)
{
    sf_voids_options o = sf_voids_options_default();
    sf_voids_report r;
    o.bed_layer = p->bed_layer;
    o.bed_is_open = 1;
    progress_phase("looking for voids");
    sf_status status = sf_grid_voids(c->done.after, &o, NULL, &job->task, &r, NULL);
    if (status != SF_OK) {
        return fail(job, status, "the voids");
    }
    c->void_count = r.trap_count;
    c->void_voxels = r.trap_voxels;
    return EXIT_GOOD;
}

static exit_status drain(cli_job *job, const sf_terms *terms, cavity *c)
{
    sf_lattice lattice = sf_grid_lattice(c->wall);
    sf_drain_options o = sf_drain_options_default();
    if (job->options.drain_mm == 0) {
        return EXIT_GOOD;
    }
    c->drains = malloc(CAVITY_DRAINS_MAX * sizeof *c->drains);
    if (c->drains == NULL) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the holes.");
    }
    o.diameter_mm = job->options.drain_mm;
    o.count = job->options.drain_count;
    o.fill = 1;
    o.drains = c->drains;
    o.drain_capacity = CAVITY_DRAINS_MAX;
    progress_phase("drilling");
    sf_status status = sf_grid_drain(c->done.after, terms, &o, NULL, &job->task, &c->drained);
    if (status == SF_ERR_UNSUPPORTED) {
        return job_fail(job, EXIT_USAGE, "--drain %g is more than 500 voxels of %g mm.",
                        o.diameter_mm, fmin(lattice.pitch_x_mm, lattice.pitch_y_mm));
    }
    c->drain_count = (size_t)(c->drained.drain_count - c->drained.drains_dropped);
    return status == SF_OK ? EXIT_GOOD : fail(job, status, "the holes");
}

// ---------------------------------------------------------------------------------------------
// Measuring
// ---------------------------------------------------------------------------------------------

// Without a mesh: the largest thickness of wall that holds nothing of what is carved.
static sf_status measure_inside(cli_job *job, const part *p, cavity *c)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    double pitch = fmin(lattice.pitch_x_mm, lattice.pitch_y_mm);
    double low = job->options.wall_mm, high = fmin(2 * low + 2 * pitch, 252 * pitch);
    sf_grid *wall = NULL;
    sf_status status = sf_grid_create(&lattice, NULL, &wall);
    for (int i = 0; status == SF_OK && i < HALVINGS && high - low > 1e-9 * high; i++) {
        double middle = 0.5 * (low + high);
        status = sf_grid_wall_inside(p->grid, middle, NULL, &job->task, wall);
        int meets = 0;
        for (uint32_t k = 0; status == SF_OK && !meets && k < lattice.nz; k++) {
            sf_slice slice = sf_grid_slice(wall, k);
            status = sf_slice_and(slice, slice, sf_grid_slice(c->carved, k));
            meets = sf_slice_popcount(slice) > 0;
        }
        *(meets ? &high : &low) = middle;
    }
    c->wall_min_mm = low;
    sf_grid_destroy(wall);
    return status;
}

static exit_status measure(cli_job *job, const part *p, const densities *d, cavity *c)
{
    sf_status status = subtract(c->carved, c->done.after); // what was filled again is not carved
    progress_phase("measuring what is left");
    c->carved_voxels = sf_grid_popcount(c->carved);
    c->carved_mm3 = describe_volume(c->carved);
    double solid = describe_volume(p->grid),
           kept = solid - describe_volume(c->wall) - c->carved_mm3;
    c->kept_mm3 = kept > 1e-9 * solid ? kept : 0; // the rest is rounding
    c->wall_min_mm = INFINITY;
    if (status == SF_OK && c->carved_voxels > 0) {
        status = c->is_closed ? sf_grid_clearance(c->carved, sf_mesh_get_view(p->mesh), NULL,
                                                  &job->task, &c->wall_min_mm)
                              : measure_inside(job, p, c);
    }
    if (status == SF_OK && c->carved_voxels == 0) {
        return job_fail(job, EXIT_PROPERTY,
                        "Nothing can be carved that a hole of %g mm fits into. Nothing was "
                        "written.",
                        job->options.drain_mm);
    }
    exit_status weighed = densities_weigh(job, d, p->grid, &c->before);
    if (weighed == EXIT_GOOD) {
        weighed = densities_weigh(job, d, c->done.after, &c->after);
    }
    return status == SF_OK ? weighed : fail(job, status, "the wall");
}

exit_status cavity_make(cli_job *job, const part *p, const masks *m, const densities *d, cavity *c)
{
    sf_terms terms = masks_terms(p, m);
    double start = job_seconds(job);
    memset(c, 0, sizeof *c);
    exit_status status = change_begin(job, p, &terms, &c->done);
    if (status == EXIT_GOOD) {
        status = look_at_mesh(job, p, c);
    }
    if (status == EXIT_GOOD) {
        status = find_wall(job, p, d, c);
    }
    if (status == EXIT_GOOD) {
        status = carve(job, p, &terms, c);
    }
    if (status == EXIT_GOOD) {
        status = count_voids(job, p, c);
    }
    if (status == EXIT_GOOD) {
        status = drain(job, &terms, c);
    }
    if (status == EXIT_GOOD) {
        status = measure(job, p, d, c);
    }
    return status == EXIT_GOOD ? change_end(job, p, &terms, start, &c->done) : status;
}

int cavity_holds(const cli_job *job, const cavity *c)
{
    return c->done.holds && (job->options.drain_mm == 0 || c->drained.closed_count == 0);
}

void cavity_release(cavity *c)
{
    change_release(&c->done);
    sf_grid_destroy(c->wall);
    sf_grid_destroy(c->carved);
    free(c->drains);
    memset(c, 0, sizeof *c);
}
