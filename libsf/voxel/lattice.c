// SPDX-License-Identifier: MIT
// Lattices: where voxels lie in millimetres.

#include "base/status.h"

#include <sf/voxel.h>

#include <math.h>

static int is_length(double value)
{
    return value > 0.0 && value <= 1e12;
}

static int is_place(double value)
{
    return fabs(value) <= 1e12;
}

sf_status sf_lattice_validate(const sf_lattice *lattice)
{
    if (lattice == NULL || lattice->nx == 0 || lattice->ny == 0 || lattice->nz == 0 ||
        !is_length(lattice->pitch_x_mm) || !is_length(lattice->pitch_y_mm)) {
        return SF_ERR_ARGUMENT;
    }
    if (lattice->nx > SF_EXTENT_MAX || lattice->ny > SF_EXTENT_MAX || lattice->nz > SF_LAYER_MAX) {
        return SF_ERR_OVERFLOW;
    }
    for (int axis = 0; axis < 3; axis++) {
        if (!is_place(lattice->origin_mm[axis])) {
            return SF_ERR_ARGUMENT;
        }
    }
    if (lattice->heights_mm == NULL) {
        return is_length(lattice->layer_mm) ? SF_OK : SF_ERR_ARGUMENT;
    }
    for (uint32_t k = 0; k < lattice->nz; k++) {
        if (!is_length(lattice->heights_mm[k])) {
            return SF_ERR_ARGUMENT;
        }
    }
    return SF_OK;
}

double sf_lattice_layer_height(const sf_lattice *lattice, uint32_t k)
{
    return lattice->heights_mm != NULL ? lattice->heights_mm[k] : lattice->layer_mm;
}

double sf_lattice_layer_bottom(const sf_lattice *lattice, uint32_t k)
{
    if (lattice->heights_mm == NULL) {
        return lattice->origin_mm[2] + (double)k * lattice->layer_mm;
    }
    double z = lattice->origin_mm[2];
    for (uint32_t i = 0; i < k; i++) {
        z += lattice->heights_mm[i];
    }
    return z;
}
