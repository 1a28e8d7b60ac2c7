// SPDX-License-Identifier: MIT
// Buckets: a counting sort of triangles by slab, so that a slice looks at few of them.
//
// A triangle is listed in each slab that it matters to, so slabs need no memory of each other: they
// can be done in any order and side by side. Those that reach through more than TALL slabs stand in
// one list that every slab looks through, which keeps memory linear in the number of triangles.

#include "mesh/bucket.h"

#include "base/memory.h"

#include <string.h>

#define TALL 16u        // slabs that a triangle may be listed in
#define SLAB_ROWS 8192u // rows of a slab, at most (and at least one layer)
#define SLAB_LAYERS 64u

static uint32_t slab_layers(const sfi_frame *frame)
{
    uint32_t layers = SLAB_ROWS / frame->ny;
    layers = layers < 1 ? 1 : layers > SLAB_LAYERS ? SLAB_LAYERS : layers;
    while ((layers & (layers - 1)) != 0) {
        layers &= layers - 1; // a power of two: slabs do not cut the boxes of open meshes
    }
    return layers < frame->nz ? layers : frame->nz;
}

// First pass: slab range of each triangle, and how many entries each slab will have.
static void count_entries(const sfi_frame *frame, const sfi_skin *skin, sfi_reach reach,
                          sfi_buckets *buckets, uint32_t *ranges)
{
    memset(buckets->offsets, 0, ((size_t)buckets->slab_count + 1) * sizeof(size_t));
    for (size_t t = 0; t < skin->triangle_count; t++) {
        uint32_t k0, k1;
        reach(frame, skin, t, &k0, &k1);
        uint32_t s0 = k0 / buckets->layers, s1 = k0 < k1 ? (k1 - 1) / buckets->layers + 1 : s0;
        ranges[2 * t] = s0;
        ranges[2 * t + 1] = s1;
        if (s1 - s0 > TALL) {
            buckets->tall_count++;
            continue;
        }
        buckets->item_count += s1 - s0;
        for (uint32_t s = s0; s < s1; s++) {
            buckets->offsets[s + 1]++;
        }
    }
    for (uint32_t s = 0; s < buckets->slab_count; s++) {
        buckets->offsets[s + 1] += buckets->offsets[s];
    }
}

// Second pass: offsets[s] serves as the cursor of slab s, and is shifted back at the end.
static void place_entries(sfi_buckets *buckets, const uint32_t *ranges, size_t triangle_count)
{
    size_t tall = 0;
    for (size_t t = 0; t < triangle_count; t++) {
        uint32_t s0 = ranges[2 * t], s1 = ranges[2 * t + 1];
        if (s1 - s0 > TALL) {
            buckets->tall[tall++] = (uint32_t)t;
            continue;
        }
        for (uint32_t s = s0; s < s1; s++) {
            buckets->items[buckets->offsets[s]++] = (uint32_t)t;
        }
    }
    memmove(buckets->offsets + 1, buckets->offsets, buckets->slab_count * sizeof(size_t));
    buckets->offsets[0] = 0;
}

static int allocate_entries(sfi_buckets *buckets, const sf_allocator *allocator)
{
    if (buckets->item_count > 0) {
        buckets->items = sfi_alloc_array(allocator, buckets->item_count, sizeof(uint32_t));
    }
    if (buckets->tall_count > 0) {
        buckets->tall = sfi_alloc_array(allocator, buckets->tall_count, sizeof(uint32_t));
    }
    return (buckets->item_count == 0 || buckets->items != NULL) &&
           (buckets->tall_count == 0 || buckets->tall != NULL);
}

sf_status sfi_buckets_create(const sfi_frame *frame, const sfi_skin *skin, sfi_reach reach,
                             const sf_allocator *allocator, sfi_buckets *buckets)
{
    memset(buckets, 0, sizeof *buckets);
    buckets->layers = slab_layers(frame);
    buckets->slab_count = (frame->nz - 1) / buckets->layers + 1;
    buckets->offsets = sfi_alloc_array(allocator, (size_t)buckets->slab_count + 1, sizeof(size_t));
    if (buckets->offsets == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(buckets->offsets, 0, ((size_t)buckets->slab_count + 1) * sizeof(size_t));
    if (skin->triangle_count == 0) {
        return SF_OK;
    }
    uint32_t *ranges = sfi_alloc_array(allocator, skin->triangle_count, 2 * sizeof(uint32_t));
    int good = ranges != NULL;
    if (good) {
        count_entries(frame, skin, reach, buckets, ranges);
        good = allocate_entries(buckets, allocator);
    }
    if (good) {
        place_entries(buckets, ranges, skin->triangle_count);
    }
    sfi_free_array(allocator, ranges, skin->triangle_count, 2 * sizeof(uint32_t));
    if (!good) {
        sfi_buckets_destroy(buckets, allocator);
    }
    return good ? SF_OK : SF_ERR_MEMORY;
}

void sfi_buckets_destroy(sfi_buckets *buckets, const sf_allocator *allocator)
{
    sfi_free_array(allocator, buckets->offsets, (size_t)buckets->slab_count + 1, sizeof(size_t));
    sfi_free_array(allocator, buckets->items, buckets->item_count, sizeof(uint32_t));
    sfi_free_array(allocator, buckets->tall, buckets->tall_count, sizeof(uint32_t));
    memset(buckets, 0, sizeof *buckets);
}
