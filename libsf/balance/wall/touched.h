// SPDX-License-Identifier: MIT
// Voxels that a surface touches, on a lattice and as far beyond it as matters.

#ifndef SF_BALANCE_TOUCHED_H
#define SF_BALANCE_TOUCHED_H

#include <sf/mesh.h>

// A grid on a lattice that goes on beyond another: in x by whole words, so that no bits need to be
// moved between the two.
typedef struct sfi_touched {
    sf_grid *grid;
    uint32_t before[3]; // voxels and layers that it has before the other's first
    uint32_t layers;
    double *levels; // bottoms of its layers, and the top; those of the other are just the same
} sfi_touched;

// Every voxel whose closed box a triangle touches is set, and none that all triangles stay away
// from by more than 2^-24 of a voxel or so. The lattice goes on where the mesh does, for `reach_mm`
// at most. The mesh is valid and has triangles. SF_OK; SF_ERR_OVERFLOW: more voxels than a grid may
// have; SF_ERR_MEMORY; SF_ERR_CANCELLED.
sf_status sfi_touched_create(sf_mesh_view mesh, const sf_lattice *lattice, double reach_mm,
                             const sf_allocator *allocator, sf_task *task, sfi_touched *touched);
void sfi_touched_destroy(sfi_touched *touched, const sf_allocator *allocator);

#endif
