// SPDX-License-Identifier: MIT
// Block-max search: winners of blocks of 64, looked for again only where they may have changed.
//
// A key that falls below its block's winner takes its place at once. Only a winner whose key rises
// leaves its block stale, and a stale block is searched when somebody asks. A step of void and
// cluster changes some hundred keys that lie together, few of them winners.

#include "grade/tone/tournament.h"

#include "base/memory.h"

#include <string.h>

enum { SIDE = 64 };

static size_t blocks_of(size_t count)
{
    return count / SIDE + (count % SIDE != 0);
}

static int winners_create(sfi_winners *w, size_t count, const sf_allocator *allocator)
{
    w->count = count;
    w->keys = sfi_alloc_array(allocator, count, sizeof *w->keys);
    w->at = sfi_alloc_array(allocator, count, sizeof *w->at);
    w->stale = sfi_alloc_array(allocator, count, sizeof *w->stale);
    if (w->keys == NULL || w->at == NULL || w->stale == NULL) {
        return 0;
    }
    memset(w->keys, 0xff, count * sizeof *w->keys);
    memset(w->at, 0, count * sizeof *w->at);
    memset(w->stale, 0, count * sizeof *w->stale);
    return 1;
}

static void winners_destroy(sfi_winners *w, const sf_allocator *allocator)
{
    sfi_free_array(allocator, w->keys, w->count, sizeof *w->keys);
    sfi_free_array(allocator, w->at, w->count, sizeof *w->at);
    sfi_free_array(allocator, w->stale, w->count, sizeof *w->stale);
}

sf_status sfi_tournament_create(sfi_tournament *t, size_t count, const sf_allocator *allocator)
{
    memset(t, 0, sizeof *t);
    t->count = count;
    t->keys = sfi_alloc_array(allocator, count, sizeof *t->keys);
    if (t->keys == NULL || !winners_create(&t->blocks, blocks_of(count), allocator) ||
        !winners_create(&t->groups, blocks_of(blocks_of(count)), allocator)) {
        sfi_tournament_destroy(t, allocator);
        return SF_ERR_MEMORY;
    }
    memset(t->keys, 0xff, count * sizeof *t->keys);
    return SF_OK;
}

void sfi_tournament_destroy(sfi_tournament *t, const sf_allocator *allocator)
{
    sfi_free_array(allocator, t->keys, t->count, sizeof *t->keys);
    winners_destroy(&t->blocks, allocator);
    winners_destroy(&t->groups, allocator);
    memset(t, 0, sizeof *t); // whose owner may not know that it was never made
}

// What stands in a place of one level when a key below it has become another.
static void challenge(sfi_winners *w, size_t place, uint32_t voxel, uint64_t key)
{
    if (w->stale[place]) {
        return;
    }
    if (key < w->keys[place]) {
        w->keys[place] = key;
        w->at[place] = voxel;
    } else if (w->at[place] == voxel && w->keys[place] != key) {
        w->stale[place] = 1;
    }
}

void sfi_tournament_set(sfi_tournament *t, uint32_t voxel, uint64_t key)
{
    t->keys[voxel] = key;
    challenge(&t->blocks, voxel / SIDE, voxel, key);
    challenge(&t->groups, voxel / SIDE / SIDE, voxel, key);
}

static void find_in_block(sfi_tournament *t, size_t block)
{
    size_t end = (block + 1) * SIDE < t->count ? (block + 1) * SIDE : t->count;
    size_t best = block * SIDE;
    for (size_t v = best + 1; v < end; v++) {
        best = t->keys[v] < t->keys[best] ? v : best;
    }
    t->blocks.keys[block] = t->keys[best];
    t->blocks.at[block] = (uint32_t)best;
    t->blocks.stale[block] = 0;
}

static void find_in_group(sfi_tournament *t, size_t group)
{
    size_t count = t->blocks.count;
    size_t end = (group + 1) * SIDE < count ? (group + 1) * SIDE : count;
    t->groups.keys[group] = SFI_NO_KEY;
    for (size_t b = group * SIDE; b < end; b++) {
        if (t->blocks.stale[b]) {
            find_in_block(t, b);
        }
        if (t->blocks.keys[b] < t->groups.keys[group]) {
            t->groups.keys[group] = t->blocks.keys[b];
            t->groups.at[group] = t->blocks.at[b];
        }
    }
    t->groups.stale[group] = 0;
}

uint32_t sfi_tournament_least(sfi_tournament *t)
{
    uint64_t key = SFI_NO_KEY;
    uint32_t at = 0;
    for (size_t g = 0; g < t->groups.count; g++) {
        if (t->groups.stale[g]) {
            find_in_group(t, g);
        }
        if (t->groups.keys[g] < key) {
            key = t->groups.keys[g];
            at = t->groups.at[g];
        }
    }
    return at;
}
