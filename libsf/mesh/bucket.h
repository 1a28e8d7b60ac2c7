// SPDX-License-Identifier: MIT
// Which triangles matter to which slab of layers.

#ifndef SF_MESH_BUCKET_H
#define SF_MESH_BUCKET_H

#include "mesh/skin.h"

typedef struct sfi_buckets {
    uint32_t layers; // layers of a slab; the last may have fewer
    uint32_t slab_count;
    size_t *offsets; // slab s has items[offsets[s]] .. items[offsets[s + 1]]
    uint32_t *items;
    size_t item_count;
    uint32_t *tall; // triangles that reach through too many slabs to be listed in each
    size_t tall_count;
} sfi_buckets;

// Layers from k0 to k1 that a triangle matters to; empty is k0 >= k1.
typedef void (*sfi_reach)(const sfi_frame *frame, const sfi_skin *skin, size_t triangle,
                          uint32_t *k0, uint32_t *k1);

sf_status sfi_buckets_create(const sfi_frame *frame, const sfi_skin *skin, sfi_reach reach,
                             const sf_allocator *allocator, sfi_buckets *buckets);
void sfi_buckets_destroy(sfi_buckets *buckets, const sf_allocator *allocator);

// Triangles of the slab that holds layer k; NULL where there are none.
static inline const uint32_t *sfi_buckets_slab(const sfi_buckets *buckets, uint32_t k,
                                               size_t *count)
{
    uint32_t slab = k / buckets->layers;
    *count = buckets->offsets[slab + 1] - buckets->offsets[slab];
    return *count > 0 ? buckets->items + buckets->offsets[slab] : NULL;
}

#endif
