// SPDX-License-Identifier: MIT
// The voxel of the least key among many whose keys change a few at a time.

#ifndef SF_GRADE_TONE_TOURNAMENT_H
#define SF_GRADE_TONE_TOURNAMENT_H

#include <sf/base.h>

// No key: the voxel does not take part.
#define SFI_NO_KEY UINT64_MAX

typedef struct sfi_winners {
    uint64_t *keys; // of the least voxel of each block, or SFI_NO_KEY
    uint32_t *at;   // that voxel
    uint8_t *stale; // whether it has to be found again
    size_t count;
} sfi_winners;

// Keys, the winners of blocks of 64 of them, and of groups of 64 blocks.
typedef struct sfi_tournament {
    uint64_t *keys;
    size_t count;
    sfi_winners blocks, groups;
} sfi_tournament;

// All without a key.
sf_status sfi_tournament_create(sfi_tournament *t, size_t count, const sf_allocator *allocator);
void sfi_tournament_destroy(sfi_tournament *t, const sf_allocator *allocator);

void sfi_tournament_set(sfi_tournament *t, uint32_t voxel, uint64_t key);

// The voxel of the least key. Keys are distinct, and one voxel at least takes part.
uint32_t sfi_tournament_least(sfi_tournament *t);

#endif
