// SPDX-License-Identifier: MIT
// The connected pieces of what is printed so far.

#ifndef SF_BALANCE_PRINTED_H
#define SF_BALANCE_PRINTED_H

#include <sf/voxel.h>

#include "base/exact.h"
#include "base/polygon.h"
#include "voxel/layered.h"

// One piece. Heights are in whole units, of which a layer has `weight`; sums over voxels count each
// as often.
typedef struct sfi_piece {
    uint8_t is_on_bed, is_here, is_new; // has voxels on the bed; in this layer; only in this layer
    uint64_t voxels;
    sfi_exact mass, x, y, z; // sums of 1, x, y and twice the height of the middle
    sf_box box;
    size_t first, corners;       // of its hull on the bed, in the corners of all
    size_t gathered, start, end; // for a moment: corners that it will be the hull of, and where
    double margin_rad;           // of the last layer that it had voxels in
    size_t edge;
} sfi_piece;

// All pieces. Begin with the allocator and the connectivity of the sets, and all else zero.
typedef struct sfi_printed {
    sfi_layered sets;
    sfi_piece *list, *spare; // of each node of the sets; after a layer, its pieces
    uint32_t *number;        // for a moment: of each node, its index once the layer is done
    size_t capacity, spare_capacity, number_capacity;
    sfi_corner *corners, *spare_corners;
    size_t corner_capacity, spare_corner_capacity, corner_count;
} sfi_printed;

// Where a layer lies, in units.
typedef struct sfi_layer {
    uint32_t index;
    uint64_t bottom, top;
    int is_bed;
} sfi_layer;

// Add a layer: afterwards there is a piece for each connected set that has voxels in it or on the
// bed. SF_ERR_OVERFLOW, SF_ERR_MEMORY; then the pieces may only be released.
sf_status sfi_printed_add(sfi_printed *printed, sf_slice slice, const sfi_layer *layer);
void sfi_printed_release(sfi_printed *printed);

#endif
