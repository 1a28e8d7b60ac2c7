// SPDX-License-Identifier: MIT
// Samplers: a surface says which voxels are solid, a teller what they are.

#include "grade/sample/sampler.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

sf_sample_options sf_sample_options_default(void)
{
    sf_sample_options options = {sizeof options, 0.05};
    return options;
}

void sf_sampler_destroy(sf_sampler *sampler)
{
    if (sampler == NULL) {
        return;
    }
    sf_allocator allocator = sampler->allocator;
    sf_voxelizer_destroy(sampler->voxelizer);
    if (sampler->teller.destroy != NULL) {
        sampler->teller.destroy(sampler->teller.state);
    }
    sfi_free_array(&allocator, sampler->bottoms, (size_t)sampler->lattice.nz + 1, sizeof(double));
    sfi_free_array(&allocator, sampler, 1, sizeof *sampler);
}

double sfi_smallest_pitch(const sf_lattice *lattice)
{
    const sf_lattice *l = lattice;
    double least = l->pitch_x_mm < l->pitch_y_mm ? l->pitch_x_mm : l->pitch_y_mm;
    for (uint32_t k = 0; k < l->nz; k++) {
        double height = sf_lattice_layer_height(l, k);
        least = height < least ? height : least;
    }
    return least;
}

sf_status sfi_sampler_begin(const sf_lattice *lattice, size_t channel_count,
                            const sf_allocator *allocator, sf_sampler **sampler, sf_fault *fault)
{
    if (lattice == NULL || sampler == NULL || channel_count > SF_PROPERTY_MAX) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_lattice_validate(lattice));
    if ((uint64_t)lattice->nx * lattice->ny > SF_SAMPLE_VOXEL_MAX / lattice->nz) {
        return sfi_fault_set(
            fault, SF_ERR_OVERFLOW, 0, 0,
            "the lattice has %lu x %lu x %lu voxels, more than 2^40; make the pitch "
            "larger",
            (unsigned long)lattice->nx, (unsigned long)lattice->ny, (unsigned long)lattice->nz);
    }
    sf_sampler *made = sfi_alloc_array(allocator, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = *allocator;
    made->lattice = *lattice;
    made->lattice.heights_mm = NULL;
    made->channel_count = channel_count;
    made->bottoms = sfi_alloc_array(allocator, (size_t)lattice->nz + 1, sizeof *made->bottoms);
    if (made->bottoms == NULL) {
        sf_sampler_destroy(made);
        return SF_ERR_MEMORY;
    }
    for (uint32_t k = 0; k <= lattice->nz; k++) {
        made->bottoms[k] = k == 0 ? lattice->origin_mm[2]
                                  : made->bottoms[k - 1] + sf_lattice_layer_height(lattice, k - 1);
    }
    *sampler = made;
    return SF_OK;
}

sf_status sfi_sampler_surface(sf_sampler *sampler, const sf_lattice *lattice, sf_mesh_view surface,
                              double error_mm, sf_fault *fault)
{
    sampler->surface = surface;
    sampler->error_mm = error_mm;
    return sf_voxelizer_create(surface, lattice, NULL, &sampler->allocator, &sampler->voxelizer,
                               fault);
}

sf_mesh_view sf_sampler_surface(const sf_sampler *sampler, double *error_mm)
{
    sf_mesh_view view = {NULL, 0, NULL, 0};
    if (sampler != NULL) {
        view = sampler->surface;
        if (error_mm != NULL) {
            *error_mm = sampler->error_mm;
        }
    }
    return view;
}

sf_status sf_sampler_report(const sf_sampler *sampler, sf_sample_report *report)
{
    if (sampler == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    *report = sampler->report;
    return SF_OK;
}

void sfi_copy_values(const sf_sampler *sampler, double *const *values, size_t from, size_t to)
{
    for (size_t i = 0; i < sampler->channel_count; i++) {
        values[i][to] = values[i][from];
    }
}

sf_status sf_sampler_slice(sf_sampler *sampler, uint32_t k, sf_slice solid, double *const *values)
{
    if (sampler == NULL || k >= sampler->lattice.nz ||
        (sampler->channel_count > 0 && values == NULL)) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < sampler->channel_count; i++) {
        if (values[i] == NULL) {
            return SF_ERR_ARGUMENT;
        }
    }
    sf_slice_sums sums;
    SF_TRY(sf_voxelizer_slice(sampler->voxelizer, k, solid));
    SF_TRY(sf_slice_measure(solid, &sums));
    size_t plane = (size_t)sampler->lattice.nx * sampler->lattice.ny;
    for (size_t i = 0; i < sampler->channel_count; i++) {
        memset(values[i], 0, plane * sizeof *values[i]);
    }
    double middle = (sampler->bottoms[k] + sampler->bottoms[k + 1]) / 2;
    sampler->report.solid += sums.count;
    return sampler->channel_count == 0
               ? SF_OK
               : sampler->teller.tell(sampler->teller.state, sampler, k, middle, solid, values);
}
