// SPDX-License-Identifier: MIT
// How the surface of voxels comes apart at a corner of the lattice.

#ifndef SF_MESH_FANS_H
#define SF_MESH_FANS_H

#include <stdint.h>

// For every arrangement of the eight voxels around a lattice vertex. Octant o of them lies on the
// side of larger x where bit 0 is set, y bit 1, z bit 2; bit o of an arrangement says it is solid.
typedef struct sfi_fans {
    uint8_t count[256];      // fans of boundary faces around the vertex, 0..4
    uint8_t fan[256][24];    // fan of the face of solid octant o across axis a, at 3 o + a
    int8_t shift[256][4][3]; // where each fan's copy of the vertex goes: -1, 0, 1 along each axis
} sfi_fans;

void sfi_fans_make(sfi_fans *fans);

#endif
