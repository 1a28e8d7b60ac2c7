// SPDX-License-Identifier: MIT
// Real models, from the folder that SF_DATA names, on a lattice of cubes.

#ifndef SF_TEST_VERIFY_MODEL_H
#define SF_TEST_VERIFY_MODEL_H

#include <sf/io.h>

#include "test.h"

static char models[512]; // the folder

static inline sf_mesh *read_model(const char *name)
{
    char path[1024];
    sf_file *file = NULL;
    sf_mesh *mesh = NULL, *merged = NULL;
    snprintf(path, sizeof path, "%s/%s", models, name);
    CHECK_EQ(sf_file_open(path, NULL, &file, NULL), SF_OK);
    if (file != NULL) {
        CHECK_EQ(sf_mesh_read(sf_file_source(file), SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, NULL),
                 SF_OK);
        sf_file_close(file);
    }
    if (mesh != NULL) {
        CHECK_EQ(sf_mesh_merge(sf_mesh_get_view(mesh), NULL, &merged), SF_OK);
        sf_mesh_destroy(mesh);
    }
    return merged;
}

// Cubes, one empty column around and none below.
static inline sf_lattice lattice_around(sf_mesh_view mesh, int resolution)
{
    double low[3], high[3], longest = 0.0;
    CHECK_EQ(sf_mesh_bounds(mesh, low, high), SF_OK);
    for (int i = 0; i < 3; i++) {
        longest = high[i] - low[i] > longest ? high[i] - low[i] : longest;
    }
    double pitch = longest / resolution;
    uint32_t counts[3];
    for (int i = 0; i < 3; i++) {
        counts[i] = (uint32_t)ceil((high[i] - low[i]) / pitch - 1e-6) + (i < 2 ? 2 : 0);
    }
    sf_lattice lattice = {
        counts[0], counts[1], counts[2], pitch,
        pitch,     pitch,     NULL,      {low[0] - pitch, low[1] - pitch, low[2]}};
    return lattice;
}

static inline sf_grid *voxelize(const char *name, int resolution)
{
    sf_mesh *mesh = read_model(name);
    sf_grid *grid = NULL;
    if (mesh != NULL) {
        sf_lattice lattice = lattice_around(sf_mesh_get_view(mesh), resolution);
        CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
        CHECK_EQ(sf_grid_voxelize(grid, sf_mesh_get_view(mesh), NULL, NULL, NULL, NULL), SF_OK);
        sf_mesh_destroy(mesh);
    }
    return grid;
}

#endif
