// SPDX-License-Identifier: MIT
// The fixed-point frame in which a mesh is voxelised.

#ifndef SF_MESH_FRAME_H
#define SF_MESH_FRAME_H

#include <sf/mesh.h>

// Units per voxel along x and y; along z per mean layer height. Centres lie on whole units.
#define SFI_UNIT_BITS 8
#define SFI_UNITS 256
// No coordinate of a point lies further than this from 0, so differences stay below 2^30.
#define SFI_UNITS_MAX (1 << 29)
// Most layers that a frame serves: their centres then lie within SFI_UNITS_MAX.
#define SFI_FRAME_LAYERS_MAX (1u << 20)

typedef struct sfi_point {
    int32_t x, y, z;
} sfi_point;

typedef struct sfi_frame {
    uint32_t nx, ny, nz;
    double origin_mm[3];
    double voxel_mm[3]; // pitch x, pitch y, mean layer height
    int32_t *centers;   // z of each layer's centre, or NULL: layer k has it at 256 k + 128
    int32_t *bottoms;   // z of each layer's bottom and of the top (nz + 1), with centers
} sfi_frame;

// A frame for a valid lattice; nothing of the lattice is kept.
sf_status sfi_frame_create(const sf_lattice *lattice, const sf_allocator *allocator,
                           sfi_frame *frame, sf_fault *fault);
void sfi_frame_destroy(sfi_frame *frame, const sf_allocator *allocator);

// Snap a position. Returns 0 when it is not finite or lies beyond SFI_UNITS_MAX.
int sfi_frame_snap(const sfi_frame *frame, const double xyz_mm[3], sfi_point *point);

// Layers whose centre z satisfies low <= z <= high, as a half-open range; empty is k0 >= k1.
void sfi_frame_layers(const sfi_frame *frame, int32_t low, int32_t high, uint32_t *k0,
                      uint32_t *k1);

// floor(v / 256) for every |v| < 2^30, without a shift of a negative number.
static inline int32_t sfi_floor_voxel(int32_t v)
{
    return (int32_t)((uint32_t)(v + (1 << 30)) >> SFI_UNIT_BITS) - (1 << (30 - SFI_UNIT_BITS));
}

// Rows (or uniform layers) below `count` whose centre 256 j + 128 lies in [low, high].
static inline void sfi_frame_range(int32_t low, int32_t high, uint32_t count, uint32_t *j0,
                                   uint32_t *j1)
{
    int32_t first = sfi_floor_voxel(low + (SFI_UNITS / 2 - 1));
    int32_t last = sfi_floor_voxel(high + SFI_UNITS / 2);
    *j0 = first < 0 ? 0 : (uint32_t)first;
    *j1 = last < 0 ? 0 : (uint32_t)last < count ? (uint32_t)last : count;
}

static inline int32_t sfi_frame_center(const sfi_frame *frame, uint32_t k)
{
    return frame->centers != NULL ? frame->centers[k] : (int32_t)(k * SFI_UNITS + SFI_UNITS / 2);
}

#endif
