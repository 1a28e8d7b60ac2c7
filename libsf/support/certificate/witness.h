// SPDX-License-Identifier: MIT
// What proves a shape support-free, found in one sweep.

#ifndef SF_SUPPORT_WITNESS_H
#define SF_SUPPORT_WITNESS_H

#include <sf/certificate.h>

#include "base/task.h"

// Evidence about a shape. Arrays come from `allocator`; begin with all else zero.
typedef struct sfi_witness {
    sf_allocator allocator;
    sf_certificate_layer *layers; // nz
    sf_run *exempt;
    size_t exempt_count, exempt_capacity;
    sf_certificate_span *spans;
    size_t span_count, span_capacity;
} sfi_witness;

// Look at every layer of a shape that the terms serve (sfi_terms_check()), resting on layer `bed`.
// Reports progress from `done` of `total` onwards. SF_ERR_INFEASIBLE: a voxel that nothing carries,
// named in `fault`. Whatever is returned, the witness must be released.
sf_status sfi_witness_find(sfi_witness *witness, const sf_grid *shape, const sf_terms *terms,
                           uint32_t bed, sfi_progress *progress, uint64_t done, uint64_t total,
                           sf_fault *fault);

void sfi_witness_release(sfi_witness *witness, uint32_t layer_count);

#endif
