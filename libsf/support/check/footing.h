// SPDX-License-Identifier: MIT
// What it costs to have something to stand on at each voxel.

#ifndef SF_SUPPORT_FOOTING_H
#define SF_SUPPORT_FOOTING_H

#include <sf/support.h>

// Price of a voxel that cannot be had; prices that are had end below it, "so much or more".
#define SFI_FOOTING_NONE 65535u

// Prices of the layers bed <= k < top. The price of a voxel is how many must be added to have it
// solid and carried, itself included: 0 where it is solid. That of voxel (x, y, k) is
// values[((k - bed) * height + y) * stride + x].
typedef struct sfi_footings {
    uint16_t *values;
    size_t count; // of all values
    uint32_t bed, top, height;
    size_t stride;
} sfi_footings;

static inline const uint16_t *sfi_footing_row(const sfi_footings *prices, uint32_t k, uint32_t y)
{
    return prices->values + ((size_t)(k - prices->bed) * prices->height + y) * prices->stride;
}

// What a voxel with nothing to spare carries in the step from layer k: the rule's element, under
// slack the part of it that the step itself pays for. Bridges are not in it.
sf_status sfi_footing_element(const sf_rule *rule, uint32_t k, sf_element *element);

// Prices of the layers below `top` on terms that sfi_terms_check() has passed; none where top lies
// not above the bed. SF_ERR_OVERFLOW, SF_ERR_MEMORY, SF_ERR_CANCELLED: nothing is held then.
sf_status sfi_footings_create(const sf_grid *grid, const sf_terms *terms, uint32_t bed,
                              uint32_t top, const sf_allocator *allocator, sf_task *task,
                              sfi_footings *prices);
void sfi_footings_destroy(sfi_footings *prices, const sf_allocator *allocator);

#endif
