// SPDX-License-Identifier: MIT
// A lump of voxels whose vertices are moved at random: a closed mesh with corners of all degrees.

#ifndef SF_TEST_BALANCE_LUMP_H
#define SF_TEST_BALANCE_LUMP_H

#include "law/stack.h"

#include <sf/mesh.h>

static inline sf_mesh *lump(double away)
{
    sf_lattice lattice = {5, 4, 4, 1, 1.5, 0.75, NULL, {away, -away, 2 * away}};
    sf_grid *grid = NULL;
    sf_mesh *made = NULL, *moved = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    for (uint32_t i = 0; i < 80; i++) {
        int solid = i == 30 || test_random_below(3) > 0;
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, i / 20), i % 5, i / 5 % 4, solid), SF_OK);
    }
    CHECK_EQ(sf_grid_surface(grid, NULL, NULL, NULL, &made), SF_OK);
    CHECK_EQ(sf_mesh_create(NULL, &moved), SF_OK);
    sf_mesh_view view = sf_mesh_get_view(made);
    for (size_t v = 0; v < view.vertex_count; v++) {
        double p[3];
        for (int d = 0; d < 3; d++) {
            p[d] = view.vertices[3 * v + (size_t)d] + 0.2 * test_random_unit();
        }
        CHECK_EQ(sf_mesh_add_vertices(moved, p, 1), SF_OK);
    }
    CHECK_EQ(sf_mesh_add_triangles(moved, view.triangles, view.triangle_count), SF_OK);
    sf_mesh_destroy(made);
    sf_grid_destroy(grid);
    return moved;
}

#endif
