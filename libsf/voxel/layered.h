// SPDX-License-Identifier: MIT
// Connected sets of voxels that grow layer by layer.

#ifndef SF_VOXEL_LAYERED_H
#define SF_VOXEL_LAYERED_H

#include <sf/voxel.h>

// Runs of one layer.
typedef struct sfi_layer_runs {
    sf_run *runs;
    size_t capacity, count;
} sfi_layer_runs;

// The sets that the layers so far fall into. A node is a set as it was below the latest layer, or a
// component of that layer; a run's label is its node. Begin with allocator and connectivity, and
// all else zero.
typedef struct sfi_layered {
    sf_allocator allocator;
    sf_connectivity connectivity; // through faces, or through edges and corners as well
    sfi_layer_runs below, here;
    uint32_t *parent; // of each node; see sfi_layered_root()
    size_t capacity;
    uint32_t old, count; // nodes of the layers below, which come first; and all
} sfi_layered;

// Add a layer: a node for each of its components, joined with the old ones that it touches.
// SF_ERR_OVERFLOW, SF_ERR_MEMORY; then it may only be released.
sf_status sfi_layered_push(sfi_layered *sets, sf_slice slice);

// The lowest node of a node's set: an old one, if there is one in it.
uint32_t sfi_layered_root(const sfi_layered *sets, uint32_t node);

// Go on to the next layer: the sets that still count get new numbers, 0 to count - 1, and all other
// nodes are forgotten. number[root] is that of a root; those of runs of the layer have one.
void sfi_layered_settle(sfi_layered *sets, const uint32_t *number, uint32_t count);

void sfi_layered_release(sfi_layered *sets);

#endif
