// SPDX-License-Identifier: MIT
// Connected pieces of a grid: of what is solid, or of what is empty.

#ifndef SF_VOXEL_PIECES_H
#define SF_VOXEL_PIECES_H

#include <sf/voxel.h>

// What is looked at, and what counts as connected. The two are a pair for which a closed wall parts
// inside from outside.
typedef enum sfi_pieces_of {
    SFI_PIECES_SOLID, // through faces, edges and corners: 26 neighbours
    SFI_PIECES_EMPTY  // through faces: 6 neighbours, as what flows
} sfi_pieces_of;

typedef struct sfi_pieces {
    sf_lattice lattice; // heights belong to the grid
    sf_run *runs;       // layer by layer, in row order; a label is the number of a piece
    size_t run_count, run_capacity;
    size_t *first;  // nz + 1: runs of layer k are first[k] .. first[k + 1]
    uint32_t count; // pieces, numbered by their first run
} sfi_pieces;

// SF_OK; SF_ERR_OVERFLOW: 2^32 runs or more; SF_ERR_MEMORY; SF_ERR_CANCELLED, heeded at every
// layer. Nothing is left to destroy after a failure.
sf_status sfi_pieces_create(const sf_grid *grid, sfi_pieces_of what, const sf_allocator *allocator,
                            sf_task *task, sfi_pieces *pieces);
void sfi_pieces_destroy(sfi_pieces *pieces, const sf_allocator *allocator);

// The piece that voxel (x, y, k) belongs to, or UINT32_MAX where it belongs to none.
uint32_t sfi_pieces_at(const sfi_pieces *pieces, uint32_t x, uint32_t y, uint32_t k);

#endif
