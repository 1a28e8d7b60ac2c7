// SPDX-License-Identifier: MIT
// Values of a surface's vertices, on tetrahedra of voxels.
//
// Triangles are walked in steps of half a voxel. Each step gives the value there, between the
// corners', to the corner of a solid voxel that is nearest; a corner that is given several keeps
// their mean. These corners are fixed, and the library spreads their values over all others.

#include "painted.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NO_POINT UINT32_MAX

typedef struct corners {
    sf_lattice lattice;
    uint32_t *points; // the number of each corner's point, or NO_POINT
    double *sums;     // of each point
    uint32_t *counts;
} corners;

static size_t index_of(const corners *c, const long at[3])
{
    return ((size_t)at[2] * (c->lattice.ny + 1) + (size_t)at[1]) * (c->lattice.nx + 1) +
           (size_t)at[0];
}

static sf_status number_corners(corners *c, const sf_tets_view *v)
{
    const sf_lattice *l = &c->lattice;
    size_t count = (size_t)(l->nx + 1) * (l->ny + 1) * (l->nz + 1);
    c->points = malloc(count * sizeof *c->points);
    c->sums = calloc(v->point_count, sizeof *c->sums);
    c->counts = calloc(v->point_count, sizeof *c->counts);
    if (c->points == NULL || c->sums == NULL || c->counts == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(c->points, 0xff, count * sizeof *c->points);
    for (size_t i = 0; i < v->point_count; i++) {
        long at[3];
        for (int k = 0; k < 3; k++) {
            at[k] = lround((v->positions[3 * i + (size_t)k] - l->origin_mm[k]) / l->layer_mm);
        }
        c->points[index_of(c, at)] = (uint32_t)i;
    }
    return SF_OK;
}

// Give a value to the nearest corner around that is a solid voxel's.
static void give(corners *c, const double p[3], double value)
{
    double best = INFINITY;
    uint32_t point = NO_POINT;
    for (int i = 0; i < 8; i++) {
        long at[3];
        double square = 0;
        int is_in = 1;
        const uint32_t sizes[3] = {c->lattice.nx, c->lattice.ny, c->lattice.nz};
        for (int k = 0; k < 3; k++) {
            double u = (p[k] - c->lattice.origin_mm[k]) / c->lattice.layer_mm;
            at[k] = (long)floor(u) + (i >> k & 1);
            is_in = is_in && at[k] >= 0 && at[k] <= (long)sizes[k];
            square += (u - (double)at[k]) * (u - (double)at[k]);
        }
        if (is_in && square < best && c->points[index_of(c, at)] != NO_POINT) {
            best = square;
            point = c->points[index_of(c, at)];
        }
    }
    if (point != NO_POINT) {
        c->sums[point] += value;
        c->counts[point]++;
    }
}

static void walk_triangle(corners *c, const double *p[3], const double value[3])
{
    double longest = 0;
    for (int i = 0; i < 3; i++) {
        const double *a = p[i], *b = p[(i + 1) % 3];
        double square = 0;
        for (int k = 0; k < 3; k++) {
            square += (a[k] - b[k]) * (a[k] - b[k]);
        }
        longest = fmax(longest, sqrt(square));
    }
    int steps = 1 + (int)fmin(2 * longest / c->lattice.layer_mm, 1e5);
    for (int i = 0; i <= steps; i++) {
        for (int j = 0; i + j <= steps; j++) {
            double u = (double)i / steps, v = (double)j / steps, at[3];
            for (int k = 0; k < 3; k++) {
                at[k] = p[0][k] + u * (p[1][k] - p[0][k]) + v * (p[2][k] - p[0][k]);
            }
            give(c, at, value[0] + u * (value[1] - value[0]) + v * (value[2] - value[0]));
        }
    }
}

static sf_status paint(corners *c, sf_mesh_view mesh, const double *values, sf_tets *tets,
                       sf_fault *fault)
{
    sf_tets_view v = sf_tets_get_view(tets);
    sf_status status = number_corners(c, &v);
    uint8_t *fixed = calloc(v.point_count, 1);
    size_t count = 0;
    if (status != SF_OK || fixed == NULL) {
        free(fixed);
        return SF_ERR_MEMORY;
    }
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        const double *p[3];
        double value[3];
        for (int k = 0; k < 3; k++) {
            uint32_t corner = mesh.triangles[3 * t + (size_t)k];
            p[k] = mesh.vertices + 3 * (size_t)corner;
            value[k] = values[corner];
        }
        if (!isnan(value[0] + value[1] + value[2])) {
            walk_triangle(c, p, value);
        }
    }
    for (size_t i = 0; i < v.point_count && status == SF_OK; i++) {
        double mean = c->counts[i] > 0 ? c->sums[i] / c->counts[i] : 0;
        fixed[i] = c->counts[i] > 0;
        count += fixed[i];
        if (fixed[i]) {
            mean = fmin(fmax(mean, v.channels[0].property.low), v.channels[0].property.high);
            status = sf_tets_set_values(tets, 0, i, 1, &mean);
        }
    }
    if (status == SF_OK && count == 0) {
        status = fault->status = SF_ERR_ARGUMENT;
        strcpy(fault->message, "no triangle of the surface has values at all its corners");
    }
    status = status == SF_OK ? sf_tets_spread(tets, 0, fixed, NULL, NULL, NULL) : status;
    free(fixed);
    return status;
}

static sf_status make_grid(sf_mesh_view mesh, double pitch_mm, sf_grid **grid, sf_fault *fault)
{
    double low[3], high[3];
    sf_lattice l = {0, 0, 0, pitch_mm, pitch_mm, pitch_mm, NULL, {0, 0, 0}};
    sf_status status = sf_mesh_bounds(mesh, low, high);
    if (status != SF_OK) {
        return status;
    }
    uint32_t *sizes[3] = {&l.nx, &l.ny, &l.nz};
    for (int k = 0; k < 3; k++) {
        double cells = (high[k] - low[k]) / pitch_mm + 3;
        if (!(cells < 4096)) {
            fault->status = SF_ERR_OVERFLOW;
            strcpy(fault->message,
                   "the part would be more than 4096 voxels long; take a larger --pitch");
            return SF_ERR_OVERFLOW;
        }
        *sizes[k] = (uint32_t)cells;
        l.origin_mm[k] = low[k] - pitch_mm; // so that flat lower faces are met exactly
    }
    status = sf_grid_create(&l, NULL, grid);
    return status == SF_OK ? sf_grid_voxelize(*grid, mesh, NULL, NULL, NULL, NULL) : status;
}

sf_status painted_voxels(sf_mesh_view mesh, const double *values, const sf_property *property,
                         double pitch_mm, sf_tets **tets, sf_fault *fault)
{
    sf_grid *grid = NULL;
    sf_tets *made = NULL;
    corners c;
    memset(&c, 0, sizeof c);
    sf_status status = make_grid(mesh, pitch_mm, &grid, fault);
    if (status == SF_OK) {
        c.lattice = sf_grid_lattice(grid);
        status = sf_tets_of_grid(grid, property, NULL, &made, fault);
    }
    if (status == SF_OK) {
        status = paint(&c, mesh, values, made, fault);
    }
    free(c.points);
    free(c.sums);
    free(c.counts);
    sf_grid_destroy(grid);
    if (status != SF_OK) {
        sf_tets_destroy(made);
        return status;
    }
    *tets = made;
    return SF_OK;
}
