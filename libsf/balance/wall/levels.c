// SPDX-License-Identifier: MIT
// Heights of a lattice's layers: summed once from the lowest up, where each call of
// sf_lattice_layer_bottom() would sum anew.

#include "balance/wall/levels.h"

#include <math.h>

double *sfi_levels_create(const sf_lattice *lattice, const sf_allocator *allocator)
{
    double *levels = sfi_alloc_array(allocator, (size_t)lattice->nz + 1, sizeof *levels);
    if (levels == NULL) {
        return NULL;
    }
    levels[0] = lattice->origin_mm[2];
    for (uint32_t k = 0; k < lattice->nz; k++) {
        levels[k + 1] = lattice->heights_mm != NULL
                            ? levels[k] + lattice->heights_mm[k]
                            : lattice->origin_mm[2] + (k + 1.0) * lattice->layer_mm;
    }
    return levels;
}

void sfi_levels_destroy(double *levels, const sf_lattice *lattice, const sf_allocator *allocator)
{
    sfi_free_array(allocator, levels, (size_t)lattice->nz + 1, sizeof *levels);
}

double sfi_levels_diagonal(const sf_lattice *lattice, const double *levels)
{
    double x = lattice->nx * lattice->pitch_x_mm, y = lattice->ny * lattice->pitch_y_mm;
    double z = levels[lattice->nz] - levels[0];
    return sqrt(x * x + y * y + z * z);
}

double sfi_levels_forgive(const sf_lattice *lattice, double length_mm, double coordinate_mm)
{
    const double all[8] = {length_mm,
                           coordinate_mm,
                           lattice->origin_mm[0],
                           lattice->origin_mm[1],
                           lattice->origin_mm[2],
                           lattice->origin_mm[0] + lattice->nx * lattice->pitch_x_mm,
                           lattice->origin_mm[1] + lattice->ny * lattice->pitch_y_mm,
                           sf_lattice_layer_bottom(lattice, lattice->nz)};
    double largest = 0;
    for (int i = 0; i < 8; i++) {
        largest = fabs(all[i]) > largest ? fabs(all[i]) : largest;
    }
    double left = length_mm - 0x1p-40 * largest;
    return left > 0 ? left : 0;
}
