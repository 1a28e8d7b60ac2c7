// SPDX-License-Identifier: MIT
// Stances as carving sees them: up, and half-spaces.

#ifndef SF_BALANCE_BASES_H
#define SF_BALANCE_BASES_H

#include <sf/stance.h>

#include "balance/stance/target.h"

typedef struct sfi_bases {
    sfi_base *bases;
    size_t count;
    sf_halfspace *halfspaces; // of all of them, one after the other
    size_t halfspace_count;
} sfi_bases;

// SF_OK; SF_ERR_ARGUMENT: a stance is NULL, or all are where there should be some; SF_ERR_OVERFLOW;
// SF_ERR_MEMORY. Nothing is left to destroy after a failure.
sf_status sfi_bases_create(const sf_stance *const *stances, size_t count,
                           const sf_allocator *allocator, sfi_bases *bases);
void sfi_bases_destroy(sfi_bases *bases, const sf_allocator *allocator);

#endif
