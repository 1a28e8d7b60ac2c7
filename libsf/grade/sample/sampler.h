// SPDX-License-Identifier: MIT
// The inside of a sampler.

#ifndef SF_GRADE_SAMPLE_SAMPLER_H
#define SF_GRADE_SAMPLE_SAMPLER_H

#include <sf/sample.h>

// What tells properties in the solid voxels of a slice: a walk through a limit, or tetrahedra.
typedef struct sfi_teller {
    void *state;
    // Fill the planes' solid voxels of layer k, whose centres are at height z. Adds to the report.
    sf_status (*tell)(void *state, sf_sampler *sampler, uint32_t k, double z, sf_slice solid,
                      double *const *values);
    void (*destroy)(void *state);
} sfi_teller;

struct sf_sampler {
    sf_allocator allocator;
    sf_lattice lattice; // without heights of its own: bottoms[] holds them
    double *bottoms;    // of layers, and the top
    size_t channel_count;
    sf_mesh_view surface; // the teller's
    double error_mm;      // of the surface
    sf_voxelizer *voxelizer;
    sfi_teller teller;
    sf_sample_report report;
};

// A sampler without surface and teller. SF_ERR_ARGUMENT, SF_ERR_OVERFLOW: a lattice that cannot be;
// SF_ERR_MEMORY.
sf_status sfi_sampler_begin(const sf_lattice *lattice, size_t channel_count,
                            const sf_allocator *allocator, sf_sampler **sampler, sf_fault *fault);

// Take a surface, which must stay, and prepare to voxelise it on the lattice as it was given. As
// sf_voxelizer_create().
sf_status sfi_sampler_surface(sf_sampler *sampler, const sf_lattice *lattice, sf_mesh_view surface,
                              double error_mm, sf_fault *fault);

// The smallest of a lattice's pitches and heights.
double sfi_smallest_pitch(const sf_lattice *lattice);

// The middle of voxel i along an axis, 0 or 1.
static inline double sfi_middle(const sf_lattice *l, uint32_t axis, uint32_t i)
{
    return l->origin_mm[axis] + (i + 0.5) * (axis == 0 ? l->pitch_x_mm : l->pitch_y_mm);
}

// Copy all planes' numbers of one voxel to another.
void sfi_copy_values(const sf_sampler *sampler, double *const *values, size_t from, size_t to);

#endif
