// SPDX-License-Identifier: MIT
// Stances as carving sees them: up, and half-spaces, all in one array, so that who does not ask
// which stance one belongs to can walk through them.

#include "balance/carve/bases.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

// Half-spaces of all stances together.
static sf_status count_all(const sf_stance *const *stances, size_t count, size_t *sum)
{
    *sum = 0;
    for (size_t i = 0; i < count; i++) {
        size_t here = 0;
        sf_status status = sf_stance_halfspaces(stances[i], NULL, 0, &here);
        if (status != SF_OK && status != SF_ERR_CAPACITY) {
            return status;
        }
        if (!sfi_size_add(*sum, here, sum)) {
            return SF_ERR_OVERFLOW;
        }
    }
    return SF_OK;
}

static sf_status fill(const sf_stance *const *stances, sfi_bases *made)
{
    size_t used = 0;
    for (size_t i = 0; i < made->count; i++) {
        sfi_base *base = &made->bases[i];
        sf_stance_options options = sf_stance_get_options(stances[i]);
        memcpy(base->up, options.up, sizeof base->up);
        base->halfspaces = made->halfspaces + used;
        SF_TRY(sf_stance_halfspaces(stances[i], made->halfspaces + used,
                                    made->halfspace_count - used, &base->count));
        used += base->count;
    }
    return SF_OK;
}

sf_status sfi_bases_create(const sf_stance *const *stances, size_t count,
                           const sf_allocator *allocator, sfi_bases *bases)
{
    memset(bases, 0, sizeof *bases);
    if (count == 0) {
        return SF_OK;
    }
    for (size_t i = 0; i < count; i++) {
        if (stances == NULL || stances[i] == NULL) {
            return SF_ERR_ARGUMENT;
        }
    }
    sfi_bases made = {NULL, count, NULL, 0};
    SF_TRY(count_all(stances, count, &made.halfspace_count));
    made.bases = sfi_alloc_array(allocator, count, sizeof *made.bases);
    made.halfspaces = sfi_alloc_array(allocator, made.halfspace_count + 1, sizeof *made.halfspaces);
    sf_status status = SF_ERR_MEMORY;
    if (made.bases != NULL && made.halfspaces != NULL) {
        status = fill(stances, &made);
    }
    if (status != SF_OK) {
        sfi_bases_destroy(&made, allocator);
        return status;
    }
    *bases = made;
    return SF_OK;
}

void sfi_bases_destroy(sfi_bases *bases, const sf_allocator *allocator)
{
    sfi_free_array(allocator, bases->bases, bases->count, sizeof *bases->bases);
    sfi_free_array(allocator, bases->halfspaces, bases->halfspace_count + 1,
                   sizeof *bases->halfspaces);
    memset(bases, 0, sizeof *bases);
}
