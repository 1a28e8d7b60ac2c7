// SPDX-License-Identifier: MIT
// What operators do with their terms before they begin.

#ifndef SF_SUPPORT_TERMS_H
#define SF_SUPPORT_TERMS_H

#include <sf/support.h>

// Terms that have been checked against a shape.
typedef struct sfi_ground {
    sf_lattice lattice; // of the shape
    uint32_t bed;       // layer that rests on the bed; nz when there is no matter to choose it by
} sfi_ground;

// SF_OK where the terms serve `shape`: their own size, the rule for all layers, the bed, and masks
// of the shape's counts. With SF_BED_AUTO the bed is the first layer of `shape` that holds matter.
sf_status sfi_terms_check(const sf_terms *terms, const sf_grid *shape, sfi_ground *ground);

// SF_OK where a further grid has the counts of the lattice; SF_ERR_SHAPE where it has not.
sf_status sfi_terms_match(const sf_lattice *lattice, const sf_grid *grid);

// The first layer that holds matter; nz when none does.
uint32_t sfi_first_matter(const sf_grid *grid);

// Whether a grid is one of the masks.
int sfi_terms_mask(const sf_terms *terms, const sf_grid *grid);

// Slice k of a mask, or SFI_NO_SLICE where the mask is NULL.
sf_slice sfi_mask_slice(const sf_grid *mask, uint32_t k);

// Trim `from` into `to`, which may be one grid: under the terms' rule and with its exempt voxels.
// Checked before by sfi_terms_check(). A cancel leaves `to` half done. SF_ERR_MEMORY comes before
// the first write.
sf_status sfi_trim_into(sf_grid *to, const sf_grid *from, const sf_terms *terms, uint32_t bed,
                        const sf_allocator *allocator, sf_task *task);

#endif
