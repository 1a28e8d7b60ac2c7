// SPDX-License-Identifier: MIT
// Rays through a grid.

#ifndef DEMO_SF_VOLUME_H
#define DEMO_SF_VOLUME_H

#include <sf/sf.h>

// A grid made ready for rays.
typedef struct volume {
    const sf_grid *grid;
    sf_lattice lattice;
    double *floors_mm; // bottom of each layer, and the top of the last
    uint8_t *blocks;   // whether any voxel of a block of 8 x 8 x 8 is solid
    uint32_t block_nx, block_ny, block_nz;
    int64_t mirror; // normals see a mirror under this layer; INT64_MIN: nothing
} volume;

// Where a ray met matter.
typedef struct hit {
    double t;         // distance along the ray, in units of its direction
    uint32_t x, y, z; // voxel
    double normal[3]; // outwards, in mm, length 1, smoothed over a few voxels
    double openness;  // 0 in a narrow crack, 0.5 on a plane, 1 on a needle
} hit;

// Returns 0 when there is no memory.
int volume_create(volume *v, const sf_grid *grid);
void volume_destroy(volume *v);

// First solid voxel on origin + t * direction, t >= 0. Returns 0 when there is none.
int volume_march(const volume *v, const double origin_mm[3], const double direction[3], hit *found);

// Normal and openness at a hit.
void volume_look_around(const volume *v, hit *found);

#endif
