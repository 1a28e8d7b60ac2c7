// SPDX-License-Identifier: MIT
// Bodies: masses and first moments of meshes, voxels and points.
//
// Without densities a slice is summed in integers, and only the heights of the layers bring
// rounding in. With densities a row is summed in its order, then the rows, then the slices. Either
// way the result is the same bytes everywhere.

#include <sf/body.h>

#include "base/bits.h"
#include "base/status.h"
#include "base/task.h"
#include "voxel/slice.h"

#include <math.h>

// Sums over the solid voxels of a slice or row, in voxel indices.
typedef struct plane_sums {
    double weight, x, y;
} plane_sums;

// Add one row. Returns 0 where a solid voxel's density is not finite.
static int add_row(const uint64_t *row, uint32_t width, const float *density, uint32_t y,
                   plane_sums *to)
{
    double weight = 0, moment = 0;
    for (size_t i = 0; i < sfi_row_words(width); i++) {
        uint64_t word = i + 1 < sfi_row_words(width) ? row[i] : row[i] & sfi_tail_mask(width);
        for (; word != 0; word &= word - 1) {
            size_t x = 64 * i + sfi_lowest_bit(word);
            weight += density[x];
            moment += density[x] * (double)x;
        }
    }
    to->weight += weight;
    to->x += moment;
    to->y += weight * y;
    return isfinite(moment);
}

static sf_status measure_slice(sf_slice slice, const float *density, plane_sums *sums)
{
    plane_sums found = {0, 0, 0};
    sf_slice_sums exact;
    if (density == NULL) {
        SF_TRY(sf_slice_measure(slice, &exact));
        found.weight = (double)exact.count;
        found.x = (double)exact.x;
        found.y = (double)exact.y;
    }
    for (uint32_t y = 0; density != NULL && y < slice.height; y++) {
        if (!add_row(sfi_slice_row(slice, y), slice.width, density + (size_t)y * slice.width, y,
                     &found)) {
            return SF_ERR_ARGUMENT;
        }
    }
    *sums = found;
    return SF_OK;
}

sf_status sf_grid_body(const sf_grid *grid, const float *density, sf_task *task, sf_body *body)
{
    if (grid == NULL || body == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_lattice lattice = sf_grid_lattice(grid);
    size_t plane = (size_t)lattice.nx * lattice.ny;
    sfi_progress progress = sfi_progress_begin(task);
    sf_body sum = {0, {0, 0, 0}};
    double bottom = 0;
    for (uint32_t k = 0; k < lattice.nz; k++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        plane_sums s;
        const float *here = density == NULL ? NULL : density + plane * k;
        SF_TRY(measure_slice(sf_grid_slice(grid, k), here, &s));
        double height = sf_lattice_layer_height(&lattice, k);
        double area = lattice.pitch_x_mm * lattice.pitch_y_mm * height;
        sf_body layer = {area * s.weight,
                         {area * lattice.pitch_x_mm * (s.x + 0.5 * s.weight),
                          area * lattice.pitch_y_mm * (s.y + 0.5 * s.weight),
                          area * s.weight * (bottom + 0.5 * height)}};
        sum = sf_body_add(sum, 1, layer);
        bottom += height;
        sfi_progress_report(&progress, k + 1, lattice.nz);
    }
    for (int i = 0; i < 3; i++) {
        sum.moment[i] += sum.mass * lattice.origin_mm[i];
    }
    *body = sum;
    return SF_OK;
}

sf_status sf_mesh_body(sf_mesh_view mesh, double density, sf_body *body)
{
    sf_mass mass;
    if (body == NULL || !isfinite(density)) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_mesh_measure(mesh, &mass));
    body->mass = density * mass.volume_mm3;
    for (int i = 0; i < 3; i++) {
        body->moment[i] = body->mass * mass.com_mm[i];
    }
    return SF_OK;
}

sf_body sf_body_add(sf_body a, double factor, sf_body b)
{
    a.mass += factor * b.mass;
    for (int i = 0; i < 3; i++) {
        a.moment[i] += factor * b.moment[i];
    }
    return a;
}

sf_body sf_ballast_body(const sf_ballast *ballast, size_t count)
{
    sf_body sum = {0, {0, 0, 0}};
    for (size_t i = 0; ballast != NULL && i < count; i++) {
        double m = ballast[i].mass;
        const double *p = ballast[i].at_mm;
        sf_body one = {m, {m * p[0], m * p[1], m * p[2]}};
        sum = sf_body_add(sum, 1, one);
    }
    return sum;
}

sf_status sf_body_com(sf_body body, double com_mm[3])
{
    if (com_mm == NULL || !(body.mass > 0)) {
        return SF_ERR_ARGUMENT;
    }
    for (int i = 0; i < 3; i++) {
        com_mm[i] = body.moment[i] / body.mass;
    }
    return SF_OK;
}
