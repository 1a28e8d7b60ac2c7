// SPDX-License-Identifier: MIT
// Rows of the price map.

#ifndef SF_SUPPORT_PRICE_ROW_H
#define SF_SUPPORT_PRICE_ROW_H

#include "support/repair/repair.h"

// Rows that a row of prices is made in; element x of each is voxel x, and `reach` more lie on both
// sides of those that are as wide as a plane.
typedef struct sfi_price_lanes {
    size_t width;    // elements in each
    int16_t *add;    // what filling costs, 0 where it is free
    int16_t *inside; // all ones in the room, else 0
    int16_t *exempt; // all ones where nothing is asked for; unused where `has_exempt` is 0
    int16_t *least;  // least price below
    int16_t *left;   // under slack: the code that the best of that price leaves
    int16_t *merged; // scratch
    int16_t *memory;
    int has_exempt;
} sfi_price_lanes;

sf_status sfi_price_lanes_create(sfi_price_lanes *lanes, const sfi_plane *plane,
                                 const sf_allocator *allocator);
void sfi_price_lanes_destroy(sfi_price_lanes *lanes, const sf_allocator *allocator);

// A row of voxels: bits, and costs of filling (NULL: 1 each) times `scale`. exempt may be NULL.
typedef struct sfi_price_voxels {
    const uint64_t *room, *free, *exempt;
    const uint8_t *add;
    int16_t scale;
} sfi_price_voxels;

// Fill add, inside and exempt for voxels x0 <= x < x1.
void sfi_price_lanes_load(sfi_price_lanes *lanes, const sfi_price_voxels *voxels, uint32_t x0,
                          uint32_t x1);

// least = nothing to pay, for the bed.
void sfi_price_free_row(sfi_price_lanes *lanes, uint32_t x0, uint32_t x1);

// least = the least price in the element around each voxel. `below` is the row of the plane below
// at the same y, element 0 that of voxel 0.
void sfi_price_least_row(sfi_price_lanes *lanes, const sfi_plane *plane, const int16_t *below,
                         const sf_element *element, uint32_t x0, uint32_t x1);

// out = least + add where in the room, nothing elsewhere.
void sfi_price_add_row(const sfi_price_lanes *lanes, int16_t *out, uint32_t x0, uint32_t x1);

// Under slack: prices and codes of the row below and of this one; the steps from here down in
// planes, what each step gains, and the most that a code can be.
typedef struct sfi_price_labels {
    const int16_t *below, *low_codes;
    int16_t *here, *codes;
    const sfi_step *steps;
    size_t step_count;
    uint32_t gain;
    int16_t top;
} sfi_price_labels;

// here = the least price of what can carry each voxel, with what filling costs, and codes = the
// most that one of that price leaves.
void sfi_price_label_row(sfi_price_lanes *lanes, const sfi_price_labels *labels, int is_bed,
                         uint32_t x0, uint32_t x1);

// Most that an element reaches along x.
static inline uint32_t sfi_element_reach_x(const sf_element *e)
{
    uint32_t most = 0;
    for (uint32_t dy = 0; dy <= e->reach_y; dy++) {
        most = e->half_width[dy] > most ? e->half_width[dy] : most;
    }
    return most;
}

#endif
