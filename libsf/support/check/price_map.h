// SPDX-License-Identifier: MIT
// Price map: what it costs to have something to stand on at each voxel.

#ifndef SF_SUPPORT_CHECK_PRICE_MAP_H
#define SF_SUPPORT_CHECK_PRICE_MAP_H

#include <sf/support.h>

// Price of a voxel that cannot be had; prices that are had end below it, "so much or more".
#define SFI_PRICE_MAP_NONE 65535u

// Prices of the layers bed <= k < top. The price of a voxel is how many must be added to have it
// solid and carried, itself included: 0 where it is solid. That of voxel (x, y, k) is
// values[((k - bed) * height + y) * stride + x].
typedef struct sfi_price_map {
    uint16_t *values;
    size_t count; // of all values
    uint32_t bed, top, height;
    size_t stride;
} sfi_price_map;

static inline const uint16_t *sfi_price_map_row(const sfi_price_map *prices, uint32_t k, uint32_t y)
{
    return prices->values + ((size_t)(k - prices->bed) * prices->height + y) * prices->stride;
}

// What a voxel with nothing to spare carries in the step from layer k: the rule's element, under
// slack the part of it that the step itself pays for. Bridges are not in it.
sf_status sfi_price_map_element(const sf_rule *rule, uint32_t k, sf_element *element);

// Prices of the layers below `top` on terms that sfi_terms_check() has passed; none where top lies
// not above the bed. SF_ERR_OVERFLOW, SF_ERR_MEMORY, SF_ERR_CANCELLED: nothing is held then.
sf_status sfi_price_map_create(const sf_grid *grid, const sf_terms *terms, uint32_t bed,
                               uint32_t top, const sf_allocator *allocator, sf_task *task,
                               sfi_price_map *prices);
void sfi_price_map_destroy(sfi_price_map *prices, const sf_allocator *allocator);

#endif
