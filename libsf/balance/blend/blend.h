// SPDX-License-Identifier: MIT
// Poses as affine maps.

#ifndef SF_BALANCE_BLEND_H
#define SF_BALANCE_BLEND_H

#include <sf/blend.h>

// What a pose does to a point: p -> matrix p + shift, row after row.
typedef struct sfi_map {
    double matrix[9], shift[3];
} sfi_map;

// The maps of all handles. Returns 0 where a pose is not finite.
int sfi_maps_make(const sf_pose *poses, const double *centers, size_t count, sfi_map *maps);

// matrix p, and with + shift.
static inline void sfi_map_turn(const double matrix[9], const double p[3], double out[3])
{
    for (int r = 0; r < 3; r++) {
        out[r] = (matrix[3 * r] * p[0] + matrix[3 * r + 1] * p[1]) + matrix[3 * r + 2] * p[2];
    }
}

// The sum of weight times map.
static inline void sfi_maps_mix(const sfi_map *maps, const double *w, size_t count, sfi_map *mix)
{
    sfi_map sum = {{0}, {0}};
    for (size_t j = 0; j < count; j++) {
        for (int n = 0; n < 9; n++) {
            sum.matrix[n] += w[j] * maps[j].matrix[n];
        }
        for (int n = 0; n < 3; n++) {
            sum.shift[n] += w[j] * maps[j].shift[n];
        }
    }
    *mix = sum;
}

#endif
