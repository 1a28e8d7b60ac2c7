// SPDX-License-Identifier: MIT
// Rays through a grid.

#ifndef DEMO_SF_VOLUME_H
#define DEMO_SF_VOLUME_H

#include <sf/sf.h>

// What a row of voxels around a place holds.
typedef struct volume_window {
    int8_t solid,
        sum; // how many are solid, and the sum of their places, which count from the middle
} volume_window;

// A grid made ready for rays.
typedef struct volume {
    sf_lattice lattice;
    sf_box bounds;     // of all matter
    double *floors_mm; // bottom of each layer, and the top of the last
    sf_slice *slices;  // each layer's
    uint8_t *gaps;     // of each block of 8 x 8 x 8 voxels: how many blocks away the nearest with
                       // matter is, along the longest of the three axes; 0: it holds some itself
    uint32_t block_nx, block_ny, block_nz;
    volume_window *windows; // for each row of bits
    int64_t mirror;         // normals see a mirror under this layer; INT64_MIN: nothing
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
