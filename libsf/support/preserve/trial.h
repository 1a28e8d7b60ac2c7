// SPDX-License-Identifier: MIT
// Trial: matter taken from a shape on probation.

#ifndef SF_SUPPORT_TRIAL_H
#define SF_SUPPORT_TRIAL_H

#include "support/rule/rule.h"
#include "support/rule/terms.h"

// What a voxel was.
typedef struct sfi_loss {
    uint32_t z, y, x;
    uint8_t code; // under slack; 1 else
} sfi_loss;

// A shape, under slack with the codes of its layers from `first` on, and what was taken since the
// trial began, lower layers first.
typedef struct sfi_trial {
    sf_grid *grid;
    const sf_terms *terms;
    sf_lattice lattice;
    uint32_t first;
    sf_allocator allocator;
    uint8_t *codes;
    size_t layer_bytes;                                              // of codes
    uint8_t costs[SFI_SLACK_REACH_MAX + 1][SFI_SLACK_REACH_MAX + 1]; // of reaching, by dy and dx
    sf_element element;                                              // of all steps but a table's
    sfi_loss *losses;
    size_t count, capacity;
} sfi_trial;

// Memory for a shape; under slack the codes are yet to be filled in. Destroying what is all zero
// does nothing. SF_ERR_MEMORY.
sf_status sfi_trial_create(sfi_trial *trial, sf_grid *grid, const sf_terms *terms, uint32_t first,
                           const sf_allocator *allocator);
void sfi_trial_destroy(sfi_trial *trial);

// The codes of row y of layer k.
uint8_t *sfi_trial_codes(const sfi_trial *trial, uint32_t k, uint32_t y);

// The step from layer k.
sf_status sfi_trial_element(const sfi_trial *trial, uint32_t k, sf_element *element);

// Voxel (x, y) of layer k gets a lower code; 0 removes it. SF_ERR_MEMORY.
sf_status sfi_trial_lower(sfi_trial *trial, uint32_t k, uint32_t y, uint32_t x, uint8_t code);

// Under slack: lower the codes of layer k by what was lost below it, which are losses from `from`
// to the last. *died: a voxel there is reached no more; it and perhaps others keep their codes.
// Bridges are not looked at. SF_ERR_MEMORY.
sf_status sfi_trial_rise(sfi_trial *trial, uint32_t k, size_t from, int *died);

// Give back all that was taken, or begin anew from here.
void sfi_trial_undo(sfi_trial *trial);
void sfi_trial_begin(sfi_trial *trial);

#endif
