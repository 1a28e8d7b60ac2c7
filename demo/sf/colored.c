// SPDX-License-Identifier: MIT
// A shape as a mesh with colours, for viewers.
//
// The surface's vertices are corners of voxels. One that touches a voxel which is in the shape and
// not plain has the other colour, so that what cannot print is coloured to its rim.

#include "colored.h"

#include "output.h"
#include "progress.h"

#include <sf/gltf.h>

#include <math.h>
#include <stdlib.h>

static int is_solid(const sf_grid *grid, const long at[3])
{
    sf_lattice l = sf_grid_lattice(grid);
    if (at[0] < 0 || at[1] < 0 || at[2] < 0 || at[0] >= (long)l.nx || at[1] >= (long)l.ny ||
        at[2] >= (long)l.nz) {
        return 0;
    }
    sf_slice s = sf_grid_slice(grid, (uint32_t)at[2]);
    return (int)(s.words[(size_t)at[1] * s.stride + (size_t)at[0] / 64] >> (at[0] % 64) & 1);
}

// Whether one of the eight voxels around a corner is in the shape and not plain.
static int is_other(const subject *what, const double place[3], const double *heights)
{
    sf_lattice l = sf_grid_lattice(what->shape);
    long corner[3] = {lround((place[0] - l.origin_mm[0]) / l.pitch_x_mm),
                      lround((place[1] - l.origin_mm[1]) / l.pitch_y_mm), 0};
    size_t low = 0, high = l.nz;
    while (low < high) { // the first bottom that does not lie below the corner
        size_t middle = (low + high) / 2;
        if (heights[middle] < place[2] - 1e-6 * l.pitch_x_mm) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    corner[2] = (long)low;
    for (int i = 0; i < 8; i++) {
        long at[3] = {corner[0] - (i & 1), corner[1] - (i >> 1 & 1), corner[2] - (i >> 2)};
        if (is_solid(what->shape, at) && !is_solid(what->plain, at)) {
            return 1;
        }
    }
    return 0;
}

// Bottoms of the layers, and the top.
static double *find_heights(const sf_grid *grid)
{
    sf_lattice l = sf_grid_lattice(grid);
    double *heights = malloc(((size_t)l.nz + 1) * sizeof *heights);
    if (heights != NULL) {
        heights[0] = sf_lattice_layer_bottom(&l, 0);
        for (uint32_t k = 0; k < l.nz; k++) {
            heights[k + 1] = l.heights_mm == NULL ? sf_lattice_layer_bottom(&l, k + 1)
                                                  : heights[k] + l.heights_mm[k];
        }
    }
    return heights;
}

static uint8_t *color(const subject *what, sf_mesh_view mesh)
{
    double *heights = find_heights(what->shape);
    uint8_t *colors = heights == NULL ? NULL : malloc(3 * mesh.vertex_count + 1);
    for (size_t i = 0; colors != NULL && i < mesh.vertex_count; i++) {
        const double *c =
            is_other(what, mesh.vertices + 3 * i, heights) ? what->other : picture_matter;
        for (size_t k = 0; k < 3; k++) {
            colors[3 * i + k] = (uint8_t)(255 * c[k] + 0.5);
        }
    }
    free(heights);
    return colors;
}

static sf_status write(const sf_mesh *mesh, const uint8_t *colors, const char *path,
                       sf_fault *fault)
{
    sf_save *file = NULL;
    sf_status status = sf_save_begin(path, NULL, &file, fault);
    if (status == SF_OK) {
        status = sf_gltf_write(sf_mesh_get_view(mesh), colors, sf_save_sink(file));
        if (status == SF_OK) {
            return sf_save_commit(file, fault);
        }
        sf_save_abort(file);
    }
    return status;
}

int colored_is_asked(const char *path)
{
    return output_kind_of(path) == OUTPUT_MESH &&
           sf_mesh_format_from_name(path) == SF_MESH_FORMAT_GLTF;
}

exit_status colored_save(cli_job *job, const subject *what, const char *path)
{
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_transform back = part_to_input(job);
    progress_phase("making the mesh");
    sf_status status = sf_grid_surface(what->shape, NULL, NULL, &job->task, &mesh);
    uint8_t *colors = status == SF_OK ? color(what, sf_mesh_get_view(mesh)) : NULL;
    if (status == SF_OK) {
        status = colors == NULL ? SF_ERR_MEMORY : sf_mesh_transform(mesh, &back);
    }
    if (status == SF_OK) {
        status = write(mesh, colors, path, &fault);
    }
    free(colors);
    sf_mesh_destroy(mesh);
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
}
