// SPDX-License-Identifier: MIT
// The connected pieces of what is printed so far.

#ifndef SF_BALANCE_PIECES_H
#define SF_BALANCE_PIECES_H

#include <sf/voxel.h>

#include "base/exact.h"
#include "base/polygon.h"

// One piece. Heights are in whole units, of which a layer has `weight`; sums over voxels count each
// as often.
typedef struct sfi_piece {
    uint32_t parent;
    uint32_t number;                    // its index once the layer is done; UINT32_MAX before
    uint8_t is_on_bed, is_here, is_new; // has voxels on the bed; in this layer; only in this layer
    uint64_t voxels;
    sfi_exact mass, x, y, z; // sums of 1, x, y and twice the height of the middle
    sf_box box;
    size_t first, corners;       // of its hull on the bed, in the corners of all
    size_t gathered, start, end; // for a moment: corners that it will be the hull of, and where
    double margin_rad;           // of the last layer that it had voxels in
    size_t edge;
} sfi_piece;

typedef struct sfi_layer_runs {
    sf_run *runs;
    size_t capacity, count;
} sfi_layer_runs;

typedef struct sfi_pieces {
    sf_allocator allocator;
    sf_connectivity connectivity;
    sfi_layer_runs below, here; // a label is the index of a piece
    sfi_piece *list, *spare;
    size_t capacity, spare_capacity;
    uint32_t old, count; // pieces of the layers below; these and those of the layer
    sfi_corner *corners, *spare_corners;
    size_t corner_capacity, spare_corner_capacity, corner_count;
} sfi_pieces;

// Where a layer lies, in units.
typedef struct sfi_layer {
    uint32_t index;
    uint64_t bottom, top;
    int is_bed;
} sfi_layer;

// Add a layer: afterwards there is a piece for each connected set that has voxels in it or on the
// bed. SF_ERR_OVERFLOW, SF_ERR_MEMORY; then the pieces may only be released.
sf_status sfi_pieces_add(sfi_pieces *pieces, sf_slice slice, const sfi_layer *layer);
void sfi_pieces_release(sfi_pieces *pieces);

#endif
