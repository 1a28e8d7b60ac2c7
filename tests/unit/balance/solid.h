// SPDX-License-Identifier: MIT
// The oracle of weights: the corners of a grid's voxels with dense matrices, written from the
// definition. A box lets a quarter of its volume over the square of an edge flow along each of its
// twelve edges, and gives an eighth of its volume to each corner; the energy is L M^-1 L.

#ifndef SF_TEST_BALANCE_SOLID_H
#define SF_TEST_BALANCE_SOLID_H

#include "test.h"

#include <sf/voxel.h>

typedef struct solid {
    sf_lattice lattice;
    size_t count; // nodes, in (z, y, x) order
    int *node_of; // of each corner of the lattice, or -1
    double *at;   // x, y, z of each node
    double *mass, *laplacian, *energy;
} solid;

static inline sf_grid *random_solid(const sf_lattice *lattice, double density)
{
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(lattice, NULL, &grid), SF_OK);
    for (uint32_t n = 0; n < lattice->nx * lattice->ny * lattice->nz; n++) {
        uint32_t x = n % lattice->nx, y = n / lattice->nx % lattice->ny,
                 z = n / lattice->nx / lattice->ny;
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, z), x, y, test_random_unit() < density), SF_OK);
    }
    return grid;
}

// The corner of a voxel, as a number of the lattice's corners; corner 0..7, x fastest.
static inline size_t solid_corner(const sf_lattice *l, uint32_t x, uint32_t y, uint32_t z,
                                  int corner)
{
    size_t cx = x + (size_t)(corner & 1), cy = y + (size_t)(corner >> 1 & 1),
           cz = z + (size_t)(corner >> 2);
    return (cz * (l->ny + 1u) + cy) * (l->nx + 1u) + cx;
}

static inline void solid_add_voxel(solid *s, uint32_t x, uint32_t y, uint32_t z)
{
    const sf_lattice *l = &s->lattice;
    double edge[3] = {l->pitch_x_mm, l->pitch_y_mm, sf_lattice_layer_height(l, z)};
    double volume = edge[0] * edge[1] * edge[2];
    for (int c = 0; c < 8; c++) {
        size_t i = (size_t)s->node_of[solid_corner(l, x, y, z, c)];
        s->mass[i] += volume / 8;
        for (int axis = 0; axis < 3; axis++) {
            size_t j = (size_t)s->node_of[solid_corner(l, x, y, z, c ^ (1 << axis))];
            double flow = volume / 4 / (edge[axis] * edge[axis]);
            s->laplacian[i * s->count + i] += flow;
            s->laplacian[i * s->count + j] -= flow;
        }
    }
}

static inline void solid_place(solid *s, size_t corner, size_t node)
{
    const sf_lattice *l = &s->lattice;
    size_t row = l->nx + 1u, slab = row * (l->ny + 1u);
    s->at[3 * node] = l->origin_mm[0] + (double)(corner % row) * l->pitch_x_mm;
    s->at[3 * node + 1] = l->origin_mm[1] + (double)(corner / row % (l->ny + 1u)) * l->pitch_y_mm;
    s->at[3 * node + 2] = sf_lattice_layer_bottom(l, (uint32_t)(corner / slab));
}

static inline void solid_begin(solid *s, const sf_grid *grid)
{
    sf_lattice l = sf_grid_lattice(grid);
    size_t corners = (l.nx + 1u) * (l.ny + 1u) * (size_t)(l.nz + 1u);
    s->lattice = l;
    s->count = 0;
    s->node_of = calloc(corners, sizeof *s->node_of);
    uint32_t voxels = l.nx * l.ny * l.nz;
    for (uint32_t n = 0; n < 8 * voxels; n++) {
        uint32_t v = n / 8, x = v % l.nx, y = v / l.nx % l.ny, z = v / l.nx / l.ny;
        if (sf_slice_get(sf_grid_slice(grid, z), x, y)) {
            s->node_of[solid_corner(&l, x, y, z, (int)(n % 8))] = 1;
        }
    }
    s->at = malloc(3 * corners * sizeof *s->at);
    for (size_t c = 0; c < corners; c++) {
        if (s->node_of[c]) {
            solid_place(s, c, s->count);
        }
        s->node_of[c] = s->node_of[c] ? (int)s->count++ : -1;
    }
    s->mass = calloc(s->count, sizeof *s->mass);
    s->laplacian = calloc(s->count * s->count, sizeof *s->laplacian);
    s->energy = calloc(s->count * s->count, sizeof *s->energy);
    for (uint32_t v = 0; v < voxels; v++) {
        uint32_t x = v % l.nx, y = v / l.nx % l.ny, z = v / l.nx / l.ny;
        if (sf_slice_get(sf_grid_slice(grid, z), x, y)) {
            solid_add_voxel(s, x, y, z);
        }
    }
    for (size_t i = 0; i < s->count; i++) {
        for (size_t k = 0; k < s->count; k++) {
            double part = s->laplacian[i * s->count + k] / s->mass[k];
            for (size_t j = 0; part != 0 && j < s->count; j++) {
                s->energy[i * s->count + j] += part * s->laplacian[k * s->count + j];
            }
        }
    }
}

static inline void solid_end(solid *s)
{
    free(s->node_of);
    free(s->at);
    free(s->mass);
    free(s->laplacian);
    free(s->energy);
}

// Least w . energy w with w given where held: Gaussian elimination with the largest pivots.
static inline void solid_solve(const solid *s, const uint8_t *held, double *w)
{
    size_t n = s->count, *free_nodes = malloc(n * sizeof *free_nodes), count = 0;
    for (size_t i = 0; i < n; i++) {
        if (!held[i]) {
            free_nodes[count++] = i;
        }
    }
    double *m = malloc(count * (count + 1) * sizeof *m);
    for (size_t i = 0; i < count; i++) {
        double *row = m + i * (count + 1);
        row[count] = 0;
        for (size_t j = 0; j < n; j++) {
            row[count] -= held[j] ? s->energy[free_nodes[i] * n + j] * w[j] : 0;
        }
        for (size_t j = 0; j < count; j++) {
            row[j] = s->energy[free_nodes[i] * n + free_nodes[j]];
        }
    }
    for (size_t k = 0; k < count; k++) {
        size_t pivot = k;
        for (size_t i = k + 1; i < count; i++) {
            pivot = fabs(m[i * (count + 1) + k]) > fabs(m[pivot * (count + 1) + k]) ? i : pivot;
        }
        for (size_t j = k; j <= count; j++) {
            double swap = m[k * (count + 1) + j];
            m[k * (count + 1) + j] = m[pivot * (count + 1) + j];
            m[pivot * (count + 1) + j] = swap;
        }
        for (size_t i = k + 1; i < count; i++) {
            double part = m[i * (count + 1) + k] / m[k * (count + 1) + k];
            for (size_t j = k; part != 0 && j <= count; j++) {
                m[i * (count + 1) + j] -= part * m[k * (count + 1) + j];
            }
        }
    }
    for (size_t k = count; k-- > 0;) {
        double sum = m[k * (count + 1) + count];
        for (size_t j = k + 1; j < count; j++) {
            sum -= m[k * (count + 1) + j] * w[free_nodes[j]];
        }
        w[free_nodes[k]] = sum / m[k * (count + 1) + k];
    }
    free(m);
    free(free_nodes);
}

#endif
