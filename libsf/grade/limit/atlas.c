// SPDX-License-Identifier: MIT
// An atlas: a kind for each ring that is different, and from kind to kind by subdivision.
//
// A mesh of ten thousand cells has some hundred kinds of rings. Cutting a cell once gives eight
// pieces whose rings are kinds again: mostly regular ones, and along what is irregular the same
// kinds over and over. So the kinds that come of those of a mesh are soon all there, and with each
// the sparse matrix that takes the values of a ring to those of a piece's ring. To come to the
// shape at a place is to go from ring to ring until one is regular, with a multiplication each
// time.

#include "grade/limit/atlas.h"

#include "base/memory.h"
#include "base/status.h"
#include "grade/limit/net.h"
#include "grade/limit/piece.h"

#include <string.h>

enum { MOST_KINDS = 1 << 20 };

sf_status sfi_atlas_begin(const sf_allocator *allocator, uint32_t dimension, int separable,
                          sfi_atlas *atlas)
{
    memset(atlas, 0, sizeof *atlas);
    atlas->allocator = *allocator;
    atlas->dimension = dimension;
    atlas->separable = separable;
    atlas->slot_count = 256;
    atlas->slots = sfi_alloc_array(allocator, atlas->slot_count, sizeof *atlas->slots);
    if (atlas->slots == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(atlas->slots, 0xff, atlas->slot_count * sizeof *atlas->slots);
    return SF_OK;
}

static void free_ring(const sf_allocator *allocator, sfi_ring *ring)
{
    size_t items = (size_t)ring->cells << ring->dimension;
    sfi_free_array(allocator, ring->items, items, sizeof *ring->items);
    sfi_free_array(allocator, ring->outside, ring->cells, sizeof *ring->outside);
    sfi_free_array(allocator, ring->shifts, 3 * (size_t)ring->cells, 1);
    sfi_free_array(allocator, ring->sharp, ring->sharps, sizeof *ring->sharp);
}

void sfi_atlas_free(sfi_atlas *atlas)
{
    const sf_allocator *allocator = &atlas->allocator;
    size_t corners = (size_t)1 << atlas->dimension;
    for (uint32_t i = 0; i < atlas->count; i++) {
        sfi_kind *kind = &atlas->kinds[i];
        for (size_t place = 0; place < corners; place++) {
            sfi_matrix_free(&kind->steps[place]);
        }
        sfi_free_array(allocator, kind->corners, corners * kind->ring.points,
                       sizeof *kind->corners);
        free_ring(allocator, &kind->ring);
    }
    sfi_free_array(allocator, atlas->kinds, atlas->capacity, sizeof *atlas->kinds);
    sfi_free_array(allocator, atlas->slots, atlas->slot_count, sizeof *atlas->slots);
    memset(atlas, 0, sizeof *atlas);
}

// ---------------------------------------------------------------------------------------------
// Finding kinds
// ---------------------------------------------------------------------------------------------

static uint64_t mix(uint64_t h, uint64_t word)
{
    h = (h ^ word) * 0x9e3779b97f4a7c15u;
    return h ^ h >> 31;
}

static uint64_t hash_ring(const sfi_ring *ring)
{
    uint64_t h = mix(ring->cells, ring->points);
    for (size_t i = 0; i < (size_t)ring->cells << ring->dimension; i++) {
        h = mix(h, ring->items[i]);
    }
    for (uint32_t i = 0; i < ring->cells; i++) {
        h = mix(h, ring->outside[i]);
    }
    for (uint32_t i = 0; i < ring->sharps; i++) {
        uint64_t bits;
        memcpy(&bits, &ring->sharp[i].sharpness, sizeof bits);
        h = mix(mix(h, (uint64_t)ring->sharp[i].a << 32 | ring->sharp[i].b), bits);
    }
    return h;
}

// Shifts follow from how cells touch.
static int same_ring(const sfi_ring *a, const sfi_ring *b)
{
    if (a->cells != b->cells || a->points != b->points || a->sharps != b->sharps ||
        memcmp(a->items, b->items, ((size_t)a->cells << a->dimension) * sizeof *a->items) != 0 ||
        memcmp(a->outside, b->outside, a->cells * sizeof *a->outside) != 0) {
        return 0;
    }
    for (uint32_t i = 0; i < a->sharps; i++) {
        if (a->sharp[i].a != b->sharp[i].a || a->sharp[i].b != b->sharp[i].b ||
            a->sharp[i].sharpness != b->sharp[i].sharpness) {
            return 0;
        }
    }
    return 1;
}

static size_t find_slot(const sfi_atlas *atlas, const sfi_ring *ring)
{
    size_t mask = atlas->slot_count - 1, at = (size_t)hash_ring(ring) & mask;
    while (atlas->slots[at] != SFI_NONE && !same_ring(&atlas->kinds[atlas->slots[at]].ring, ring)) {
        at = (at + 1) & mask;
    }
    return at;
}

static sf_status grow_slots(sfi_atlas *atlas)
{
    size_t count = 2 * atlas->slot_count;
    uint32_t *slots = sfi_alloc_array(&atlas->allocator, count, sizeof *slots);
    if (slots == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(slots, 0xff, count * sizeof *slots);
    sfi_free_array(&atlas->allocator, atlas->slots, atlas->slot_count, sizeof *atlas->slots);
    atlas->slots = slots;
    atlas->slot_count = count;
    for (uint32_t i = 0; i < atlas->count; i++) {
        slots[find_slot(atlas, &atlas->kinds[i].ring)] = i;
    }
    return SF_OK;
}

static sf_status copy_ring(const sf_allocator *allocator, const sfi_ring *ring, sfi_ring *copy)
{
    void *items, *outside = NULL, *shifts = NULL, *sharp = NULL;
    size_t item_count = (size_t)ring->cells << ring->dimension;
    int done =
        sfi_copy_array(allocator, ring->items, item_count, sizeof *ring->items, &items) &&
        sfi_copy_array(allocator, ring->outside, ring->cells, sizeof *ring->outside, &outside) &&
        sfi_copy_array(allocator, ring->shifts, 3 * (size_t)ring->cells, 1, &shifts) &&
        sfi_copy_array(allocator, ring->sharp, ring->sharps, sizeof *ring->sharp, &sharp);
    *copy = *ring;
    copy->items = items;
    copy->outside = outside;
    copy->shifts = shifts;
    copy->sharp = sharp;
    if (!done) {
        free_ring(allocator, copy);
        return SF_ERR_MEMORY;
    }
    return SF_OK;
}

sf_status sfi_atlas_add(sfi_atlas *atlas, const sfi_ring *ring, uint32_t *kind)
{
    size_t slot = find_slot(atlas, ring);
    if (atlas->slots[slot] != SFI_NONE) {
        *kind = atlas->slots[slot];
        return SF_OK;
    }
    if (atlas->count == MOST_KINDS) {
        return SF_ERR_OVERFLOW;
    }
    if (2 * ((size_t)atlas->count + 1) > atlas->slot_count) {
        SF_TRY(grow_slots(atlas));
        slot = find_slot(atlas, ring);
    }
    if (!sfi_grow_array(&atlas->allocator, (void **)&atlas->kinds, &atlas->capacity,
                        (size_t)atlas->count + 1, sizeof *atlas->kinds)) {
        return SF_ERR_MEMORY;
    }
    sfi_kind *made = &atlas->kinds[atlas->count];
    memset(made, 0, sizeof *made);
    memset(made->children, 0xff, sizeof made->children);
    SF_TRY(copy_ring(&atlas->allocator, ring, &made->ring));
    made->is_regular = sfi_net_find(ring, &made->net);
    atlas->most_points = ring->points > atlas->most_points ? ring->points : atlas->most_points;
    atlas->slots[slot] = atlas->count;
    *kind = atlas->count++;
    return SF_OK;
}

sf_status sfi_atlas_close(sfi_atlas *atlas, sf_task *task)
{
    for (uint32_t i = 0; i < atlas->count; i++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        if (!atlas->kinds[i].is_regular) {
            SF_TRY(sfi_piece_find_all(atlas, i));
        }
    }
    return SF_OK;
}
