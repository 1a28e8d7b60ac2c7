// SPDX-License-Identifier: MIT
// Meshes of a hollow part.
//
// The outside of a hollow part is what it was, so where nothing was drilled it keeps its own
// triangles, and the cavity is a second surface inside, turned inside out. On the part's lattice
// such a mesh is just the voxels that were made: those of the input, less those that were carved. A
// hole would have to cut triangles; there all is written as the voxels' surface. Who wants the
// input's surface with holes in it takes the cavity alone, and lets a slicer take it away.

#include "hollow_mesh.h"

#include "output.h"
#include "progress.h"

#include <stdlib.h>

static exit_status fail(cli_job *job, sf_status status)
{
    return job_fail_call(job, status, NULL, "the mesh", EXIT_RESOURCE);
}

// Append the triangles of a mesh, as they are or turned around.
static sf_status append(sf_mesh *to, sf_mesh_view from, int turned)
{
    uint32_t first = (uint32_t)sf_mesh_get_view(to).vertex_count;
    sf_status status = sf_mesh_add_vertices(to, from.vertices, from.vertex_count);
    for (size_t t = 0; status == SF_OK && t < from.triangle_count; t++) {
        const uint32_t *c = from.triangles + 3 * t;
        uint32_t corners[3] = {first + c[0], first + c[turned ? 2 : 1], first + c[turned ? 1 : 2]};
        status = sf_mesh_add_triangles(to, corners, 1);
    }
    return status;
}

sf_status hollow_join(sf_mesh_view outer, sf_mesh_view inner, int turned, sf_mesh **made)
{
    sf_status status = sf_mesh_create(NULL, made);
    if (status == SF_OK) {
        status = append(*made, outer, 0);
    }
    return status == SF_OK ? append(*made, inner, turned) : status;
}

static sf_status join(cli_job *job, const part *p, const cavity *c, sf_mesh **made)
{
    sf_surface_options how = sf_surface_options_default();
    sf_mesh *inner = NULL;
    how.smooth_passes = job->options.smooth;
    sf_status status = sf_grid_surface(c->carved, &how, NULL, &job->task, &inner);
    if (status == SF_OK) {
        status = hollow_join(sf_mesh_get_view(p->mesh), sf_mesh_get_view(inner), 1, made);
    }
    sf_mesh_destroy(inner);
    return status;
}

// In the axes of the input.
static exit_status make_mesh(cli_job *job, const part *p, const cavity *c, sf_mesh **made)
{
    if (!c->is_closed || c->drained.drain_count > 0) {
        return output_make_mesh(job, p, c->done.after, "smoothed", made);
    }
    sf_mesh *mesh = NULL;
    progress_phase("making the mesh");
    sf_status status = join(job, p, c, &mesh);
    exit_status done = status == SF_OK ? EXIT_GOOD : fail(job, status);
    if (done == EXIT_GOOD && job->options.smooth > 0) {
        done = output_look_at_smoothed(job, p, mesh, "smoothed");
    }
    sf_transform back = part_to_input(job);
    if (done == EXIT_GOOD) {
        status = sf_mesh_transform(mesh, &back);
        done = status == SF_OK ? EXIT_GOOD : fail(job, status);
    }
    *made = mesh;
    return done;
}

static exit_status save_halves(cli_job *job, const halves *h, const char *path)
{
    exit_status status = EXIT_GOOD;
    for (int i = 0; status == EXIT_GOOD && !h->missed && i < 2; i++) {
        char name[HALVES_PATH_SIZE];
        status = halves_name(job, path, i, name);
        if (status == EXIT_GOOD) {
            status = output_write_mesh(job, h->mesh[i], name);
        }
    }
    return status;
}

exit_status hollow_save(cli_job *job, const part *p, const cavity *c, const char *path, halves *h)
{
    sf_mesh *mesh = NULL;
    exit_status status = make_mesh(job, p, c, &mesh);
    if (status == EXIT_GOOD && (job->options.given & OPTION_CUT)) {
        progress_phase("cutting the mesh");
        status = halves_make(job, mesh, sf_mesh_format_from_name(path), h);
    }
    if (status == EXIT_GOOD) {
        status = output_write_mesh(job, mesh, path);
    }
    if (status == EXIT_GOOD && (job->options.given & OPTION_CUT)) {
        status = save_halves(job, h, path);
    }
    sf_mesh_destroy(mesh);
    return status;
}

// ---------------------------------------------------------------------------------------------
// The cavity alone
// ---------------------------------------------------------------------------------------------

// A lattice with one more voxel, or layer, on every side. `heights` is freed by the caller.
static int widen(const sf_lattice *l, sf_lattice *wide, double **heights)
{
    *wide = *l;
    *heights = NULL;
    wide->nx += 2;
    wide->ny += 2;
    wide->nz += 2;
    wide->origin_mm[0] -= l->pitch_x_mm;
    wide->origin_mm[1] -= l->pitch_y_mm;
    wide->origin_mm[2] -= sf_lattice_layer_height(l, 0);
    if (l->heights_mm == NULL) {
        return 1;
    }
    *heights = malloc(wide->nz * sizeof **heights);
    for (uint32_t k = 0; *heights != NULL && k < wide->nz; k++) {
        uint32_t inside = k == 0 ? 0 : k - 1 < l->nz ? k - 1 : l->nz - 1;
        (*heights)[k] = sf_lattice_layer_height(l, inside);
    }
    wide->heights_mm = *heights;
    return *heights != NULL;
}

static int was_solid(const part *p, int64_t x, int64_t y, int64_t k)
{
    sf_lattice l = sf_grid_lattice(p->grid);
    return x >= 0 && y >= 0 && k >= 0 && x < l.nx && y < l.ny && k < l.nz &&
           sf_slice_get(sf_grid_slice(p->grid, (uint32_t)k), (uint32_t)x, (uint32_t)y);
}

// A voxel that is gone, and around one that was drilled what was air.
static sf_status take(const part *p, const cavity *c, uint32_t x, uint32_t y, uint32_t k,
                      sf_grid *wide)
{
    int drilled = !sf_slice_get(sf_grid_slice(c->carved, k), x, y), reach = drilled ? 1 : 0;
    sf_status status = SF_OK;
    for (int d = 0; status == SF_OK && d < 27; d++) {
        int dx = d % 3 - 1, dy = d / 3 % 3 - 1, dk = d / 9 - 1;
        int centre = dx == 0 && dy == 0 && dk == 0;
        if (centre || (reach && !was_solid(p, (int64_t)x + dx, (int64_t)y + dy, (int64_t)k + dk))) {
            status =
                sf_slice_set(sf_grid_slice(wide, (uint32_t)((int64_t)k + 1 + dk)),
                             (uint32_t)((int64_t)x + 1 + dx), (uint32_t)((int64_t)y + 1 + dy), 1);
        }
    }
    return status;
}

static sf_status fill(const part *p, const cavity *c, sf_grid *wide)
{
    sf_lattice l = sf_grid_lattice(p->grid);
    sf_status status = SF_OK;
    for (uint32_t k = 0; k < l.nz; k++) {
        sf_slice before = sf_grid_slice(p->grid, k), after = sf_grid_slice(c->done.after, k);
        for (uint32_t y = 0; y < l.ny; y++) {
            for (uint32_t x = 0; status == SF_OK && x < l.nx; x++) {
                if (sf_slice_get(before, x, y) && !sf_slice_get(after, x, y)) {
                    status = take(p, c, x, y, k, wide);
                }
            }
        }
    }
    return status;
}

exit_status hollow_cavity_mesh(cli_job *job, const part *p, const cavity *c, sf_mesh **made)
{
    sf_lattice l = sf_grid_lattice(p->grid), wide_lattice;
    sf_surface_options how = sf_surface_options_default();
    sf_grid *wide = NULL;
    sf_mesh *mesh = NULL;
    double *heights;
    progress_phase("making the cavity's mesh");
    how.smooth_passes = job->options.smooth;
    sf_status status = widen(&l, &wide_lattice, &heights) ? SF_OK : SF_ERR_MEMORY;
    if (status == SF_OK) {
        status = sf_grid_create(&wide_lattice, NULL, &wide);
    }
    if (status == SF_OK) {
        status = fill(p, c, wide);
    }
    if (status == SF_OK) {
        status = sf_grid_surface(wide, &how, NULL, &job->task, &mesh);
    }
    sf_transform back = part_to_input(job);
    if (status == SF_OK) {
        status = sf_mesh_transform(mesh, &back);
    }
    sf_grid_destroy(wide);
    free(heights);
    if (status != SF_OK) {
        sf_mesh_destroy(mesh);
        return fail(job, status);
    }
    *made = mesh;
    return EXIT_GOOD;
}

exit_status hollow_save_cavity(cli_job *job, const part *p, const cavity *c, const char *path)
{
    sf_mesh *mesh = NULL;
    exit_status status = hollow_cavity_mesh(job, p, c, &mesh);
    if (status == EXIT_GOOD) {
        status = output_write_mesh(job, mesh, path);
    }
    sf_mesh_destroy(mesh);
    return status;
}
