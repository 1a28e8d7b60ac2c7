// SPDX-License-Identifier: MIT
// Tetrahedra out of voxels.
//
// A box is cut into the six tetrahedra that share its diagonal: each way from the low corner to the
// high one along three edges is one. All boxes are cut alike, so the diagonals of a face that two
// share are the same, and the tetrahedra conform. Points are corners of voxels, numbered as they
// are met; of the two planes of corners that a layer lies between, numbers are kept, and no more.

#include <sf/tetra.h>

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <string.h>

#define NO_POINT UINT32_MAX

typedef struct cutting {
    sf_lattice lattice;
    uint32_t *planes[2]; // numbers of corners below and above the layer
    size_t plane;        // corners of one
    size_t points, tets;
    double *positions; // or NULL: only counted
    uint32_t *corners;
} cutting;

static int is_solid(sf_slice s, uint32_t x, uint32_t y)
{
    return (int)(s.words[y * s.stride + x / 64] >> x % 64 & 1);
}

static uint32_t corner_at(cutting *c, uint32_t k, const uint32_t at[3])
{
    uint32_t *number = c->planes[at[2] - k] + (size_t)at[1] * ((size_t)c->lattice.nx + 1) + at[0];
    if (*number == NO_POINT) {
        *number = (uint32_t)c->points;
        if (c->positions != NULL) {
            double *p = c->positions + 3 * c->points;
            p[0] = c->lattice.origin_mm[0] + at[0] * c->lattice.pitch_x_mm;
            p[1] = c->lattice.origin_mm[1] + at[1] * c->lattice.pitch_y_mm;
            p[2] = sf_lattice_layer_bottom(&c->lattice, at[2]);
        }
        c->points++;
    }
    return *number;
}

// The ways along the axes, and whether they are an odd permutation, whose middle corners are
// swapped.
static void cut_voxel(cutting *c, uint32_t x, uint32_t y, uint32_t k)
{
    static const int ways[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                   {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int w = 0; w < 6; w++) {
        uint32_t at[3] = {x, y, k}, corner[4];
        corner[0] = corner_at(c, k, at);
        for (int i = 0; i < 3; i++) {
            at[ways[w][i]]++;
            corner[i + 1] = corner_at(c, k, at);
        }
        if (c->corners != NULL) {
            uint32_t *to = c->corners + 4 * c->tets;
            to[0] = corner[0];
            to[1] = corner[w < 3 ? 1 : 2];
            to[2] = corner[w < 3 ? 2 : 1];
            to[3] = corner[3];
        }
        c->tets++;
    }
}

static void cut_all(cutting *c, const sf_grid *grid)
{
    c->points = c->tets = 0;
    memset(c->planes[0], 0xff, c->plane * sizeof(uint32_t));
    for (uint32_t k = 0; k < c->lattice.nz; k++) {
        sf_slice s = sf_grid_slice(grid, k);
        memset(c->planes[1], 0xff, c->plane * sizeof(uint32_t));
        for (uint32_t y = 0; y < s.height; y++) {
            for (uint32_t x = 0; x < s.width; x++) {
                if (is_solid(s, x, y)) {
                    cut_voxel(c, x, y, k);
                }
            }
        }
        uint32_t *below = c->planes[0];
        c->planes[0] = c->planes[1];
        c->planes[1] = below;
    }
}

static sf_status make(cutting *c, const sf_grid *grid, const sf_property *property,
                      const sf_allocator *allocator, sf_tets **tets, sf_fault *fault)
{
    double least = property->low > 0 ? property->low : property->high < 0 ? property->high : 0;
    double *values = sfi_alloc_array(allocator, c->points, sizeof *values);
    size_t points = c->points, count = c->tets;
    c->positions = sfi_alloc_array(allocator, points, 3 * sizeof(double));
    c->corners = sfi_alloc_array(allocator, count, 4 * sizeof(uint32_t));
    sf_status status = SF_ERR_MEMORY;
    if (values != NULL && c->positions != NULL && c->corners != NULL) {
        for (size_t i = 0; i < points; i++) {
            values[i] = least;
        }
        cut_all(c, grid);
        sf_channel channel = {*property, points, values, NULL};
        sf_tets_view view = {points, c->positions, count, c->corners, 1, &channel};
        status = sf_tets_create(&view, allocator, tets, fault);
    }
    sfi_free_array(allocator, c->corners, count, 4 * sizeof(uint32_t));
    sfi_free_array(allocator, c->positions, points, 3 * sizeof(double));
    sfi_free_array(allocator, values, points, sizeof *values);
    return status;
}

sf_status sf_tets_of_grid(const sf_grid *grid, const sf_property *property,
                          const sf_allocator *allocator, sf_tets **tets, sf_fault *fault)
{
    sf_allocator from = sfi_allocator_or_default(allocator);
    cutting c;
    if (grid == NULL || property == NULL || tets == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "a pointer is NULL");
    }
    memset(&c, 0, sizeof c);
    c.lattice = sf_grid_lattice(grid);
    c.plane = ((size_t)c.lattice.nx + 1) * ((size_t)c.lattice.ny + 1);
    uint32_t *planes = sfi_alloc_array(&from, c.plane, 2 * sizeof(uint32_t));
    if (planes == NULL) {
        return sfi_fault_set(fault, SF_ERR_MEMORY, 0, 0, "there is not enough memory");
    }
    c.planes[0] = planes, c.planes[1] = planes + c.plane;
    cut_all(&c, grid);
    sf_status status = SF_OK;
    if (c.tets == 0) {
        status = sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "the grid has no solid voxels");
    } else if (c.tets >= (size_t)1 << 29 || c.points >= (size_t)1 << 31) {
        status = sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                               "the grid has too many solid voxels to cut into tetrahedra");
    } else {
        status = make(&c, grid, property, &from, tets, fault);
    }
    sfi_free_array(&from, planes, c.plane, 2 * sizeof(uint32_t));
    return status;
}
