// SPDX-License-Identifier: MIT
// Filling layers: what one thread does.

#ifndef SF_MESH_FILL_H
#define SF_MESH_FILL_H

#include "mesh/bucket.h"
#include "mesh/hole.h"

// What one thread needs.
typedef struct sfi_fill_lane {
    sfi_lane rows;
    sfi_hole_lane holes; // where the mesh has some
} sfi_fill_lane;

struct sf_voxelizer {
    sf_allocator allocator;
    sfi_frame frame;
    sfi_skin skin;
    sfi_buckets buckets;
    sf_fill fill;
    sfi_fill_lane lane; // of slices that are asked for one at a time
};

// Where slices go: into a grid, or into one slice. And on whose behalf.
typedef struct sfi_target {
    sf_grid *grid;
    sf_slice slice;
    const sf_task *task; // NULL: nobody can stop it
} sfi_target;

sf_status sfi_fill_lane_create(const sf_voxelizer *v, sfi_fill_lane *lane);
void sfi_fill_lane_destroy(sfi_fill_lane *lane, const sf_allocator *allocator);

// Layers that a triangle's crossings lie in: the reach for the buckets.
void sfi_fill_reach(const sfi_frame *frame, const sfi_skin *skin, size_t triangle, uint32_t *k0,
                    uint32_t *k1);

// Fill the layers k0 <= k < k1, all in one slab. The lane counts what was done. Once the task is
// cancelled it leaves early, with any number of rows not written.
void sfi_fill_layers(const sf_voxelizer *v, sfi_fill_lane *lane, uint32_t k0, uint32_t k1,
                     const sfi_target *to);

#endif
