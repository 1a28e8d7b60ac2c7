// SPDX-License-Identifier: MIT
// A cavity that is in a file of its own, as `sf stand` writes it. What is printed is the part
// without it.
//
// Its surface is that of voxels, and what rests on what is only known on those: on others, shifted
// by half a voxel, a step that carries becomes one that does not. So the part is put on the same
// ones: its voxels have the lower corner of the cavity for a corner. A cavity faces inwards or, as
// a body to be taken away, outwards; holes go on beyond the part, and take nothing there.

#include "inner.h"

#include "progress.h"

#include <math.h>

#define ROUNDING_VX 1e-3 // a file has 32-bit floats

static exit_status fail(cli_job *job, sf_status status)
{
    return job_fail_call(job, status, NULL, job->options.inner, EXIT_INPUT);
}

static int is_apart(const part *p)
{
    double low[2][3], high[2][3];
    int apart = sf_mesh_bounds(sf_mesh_get_view(p->mesh), low[0], high[0]) != SF_OK ||
                sf_mesh_bounds(sf_mesh_get_view(p->inner), low[1], high[1]) != SF_OK;
    for (int i = 0; i < 3; i++) {
        apart = apart || low[0][i] >= high[1][i] || low[1][i] >= high[0][i];
    }
    return apart;
}

exit_status inner_read(cli_job *job, part *p)
{
    const char *path = job->options.inner;
    if (path == NULL) {
        return EXIT_GOOD;
    }
    if (p->kind != PART_MESH) {
        return job_fail(job, EXIT_USAGE,
                        "--inner goes with a mesh; what is layers has its cavities in it.");
    }
    exit_status status = part_load_mesh(job, path, &p->inner);
    if (status != EXIT_GOOD) {
        return status;
    }
    sf_status turned = sf_mesh_transform(p->inner, &p->to_build);
    if (turned != SF_OK) {
        return fail(job, turned);
    }
    report_text(job->report, "inner", path);
    return is_apart(p)
               ? job_fail(job, EXIT_INPUT,
                          "--inner %s: It lies beside the part; a cavity lies in it, in the "
                          "same axes and units.",
                          path)
               : EXIT_GOOD;
}

// One more voxel on the lower side of an axis.
static exit_status widen(cli_job *job, uint32_t *count, uint32_t most)
{
    if (*count >= most) {
        return job_fail(job, EXIT_USAGE,
                        "With --inner there is a voxel too many along an axis; take a coarser "
                        "--pitch.");
    }
    (*count)++;
    return EXIT_GOOD;
}

exit_status inner_align(cli_job *job, const part *p, sf_lattice *lattice)
{
    double low[3], high[3], edge[3] = {lattice->pitch_x_mm, lattice->pitch_y_mm, lattice->layer_mm};
    uint32_t *const counts[3] = {&lattice->nx, &lattice->ny, &lattice->nz};
    const uint32_t most[3] = {SF_EXTENT_MAX, SF_EXTENT_MAX, SF_LAYER_MAX};
    exit_status status = EXIT_GOOD;
    if (p->inner == NULL || sf_mesh_bounds(sf_mesh_get_view(p->inner), low, high) != SF_OK) {
        return EXIT_GOOD;
    }
    for (int i = 0; status == EXIT_GOOD && i < 3; i++) {
        double steps = (low[i] - lattice->origin_mm[i]) / edge[i];
        double beyond = steps - floor(steps + ROUNDING_VX);
        lattice->origin_mm[i] += beyond * edge[i];
        if (beyond >= ROUNDING_VX) {
            lattice->origin_mm[i] -= edge[i];
            status = widen(job, counts[i], most[i]);
        }
    }
    if (status == EXIT_GOOD) {
        lattice->origin_mm[2] -= edge[2];
        status = widen(job, counts[2], most[2]);
    }
    return status;
}

exit_status inner_take(cli_job *job, part *p)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    sf_grid *hollow = NULL;
    sf_voxelize_report done;
    if (p->inner == NULL) {
        return EXIT_GOOD;
    }
    progress_phase("turning the cavity into voxels");
    sf_status status = sf_grid_create(&lattice, NULL, &hollow);
    if (status == SF_OK) {
        status =
            sf_grid_voxelize(hollow, sf_mesh_get_view(p->inner), NULL, NULL, &job->task, &done);
    }
    for (uint32_t k = 0; status == SF_OK && k < lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(p->grid, k);
        status = sf_slice_subtract(slice, slice, sf_grid_slice(hollow, k));
    }
    if (status == SF_OK && done.boundary_edges > 0) {
        job_warn(job, "--inner %s: The mesh is not closed (%llu open edges).", job->options.inner,
                 (unsigned long long)done.boundary_edges);
    }
    sf_grid_destroy(hollow);
    return status == SF_OK ? EXIT_GOOD : fail(job, status);
}
