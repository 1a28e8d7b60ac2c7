// SPDX-License-Identifier: MIT
// Counts of voxels become volumes and masses.
//
// Where all layers are equally high, volume is one product of an exact count; else voxels are
// summed layer by layer, from the lowest up, so that the sum is the same everywhere.

#include <sf/halftone.h>

#include "base/status.h"

static int densities_are_good(const double *density, uint32_t count)
{
    for (uint32_t j = 0; density != NULL && j < count; j++) {
        if (!(density[j] >= 0.0 && density[j] <= 1e12)) {
            return 0;
        }
    }
    return 1;
}

static sf_status count_fits(const uint64_t *counts, uint32_t layers, uint32_t material_count)
{
    for (uint32_t j = 0; j < material_count; j++) {
        uint64_t sum = 0;
        for (uint32_t k = 0; k < layers; k++) {
            uint64_t here = counts[(size_t)k * material_count + j];
            if (here > UINT64_MAX - sum) {
                return SF_ERR_OVERFLOW;
            }
            sum += here;
        }
    }
    return SF_OK;
}

static sf_material_use use_of(const sf_lattice *lattice, const uint64_t *counts, uint32_t stride)
{
    sf_material_use use = {0, 0.0, 0.0};
    double column = 0.0; // voxels times heights
    for (uint32_t k = 0; k < lattice->nz; k++) {
        uint64_t here = counts[(size_t)k * stride];
        use.voxels += here;
        column += (double)here * sf_lattice_layer_height(lattice, k);
    }
    if (lattice->heights_mm == NULL) {
        column = (double)use.voxels * lattice->layer_mm;
    }
    use.volume_mm3 = column * (lattice->pitch_x_mm * lattice->pitch_y_mm);
    return use;
}

sf_status sf_material_uses(const sf_lattice *lattice, const uint64_t *counts,
                           uint32_t material_count, const double *density_g_cm3,
                           sf_material_use *uses)
{
    SF_TRY(sf_lattice_validate(lattice));
    if (counts == NULL || uses == NULL || material_count < 1 || material_count > 255 ||
        !densities_are_good(density_g_cm3, material_count)) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(count_fits(counts, lattice->nz, material_count));
    for (uint32_t j = 0; j < material_count; j++) {
        uses[j] = use_of(lattice, counts + j, material_count);
        if (density_g_cm3 != NULL) {
            uses[j].mass_g = uses[j].volume_mm3 * density_g_cm3[j] / 1000.0;
        }
    }
    return SF_OK;
}
