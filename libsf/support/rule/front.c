// SPDX-License-Identifier: MIT
// Carriers and fronts with memory from an allocator: for the operators, which own their scratch.
//
// The steps themselves (carry.c) take no memory, because a printer's processor runs them too.

#include "base/memory.h"
#include "base/status.h"
#include "support/rule/carry.h"

static sf_status reserve(const sf_allocator *allocator, size_t size, void **memory)
{
    *memory = NULL;
    if (size == 0) {
        return SF_OK;
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    *memory = sfi_alloc_array(&from, size / SFI_ALIGN, SFI_ALIGN);
    return *memory != NULL ? SF_OK : SF_ERR_MEMORY;
}

static void release(const sf_allocator *allocator, void *memory, size_t size)
{
    if (memory != NULL) {
        sf_allocator from = sfi_allocator_or_default(allocator);
        sfi_free_array(&from, memory, size / SFI_ALIGN, SFI_ALIGN);
    }
}

sf_status sfi_carrier_create(const sf_rule *rule, uint32_t width, uint32_t height,
                             const sf_allocator *allocator, sfi_carrier *carrier)
{
    size_t size;
    void *memory;
    if (!sfi_carrier_size(rule, width, height, &size)) {
        return SF_ERR_OVERFLOW;
    }
    SF_TRY(reserve(allocator, size, &memory));
    *carrier = sfi_carrier_place(rule, width, height, memory);
    return SF_OK;
}

void sfi_carrier_destroy(sfi_carrier *carrier, const sf_allocator *allocator)
{
    size_t size = 0;
    if (carrier->own.words != NULL &&
        sfi_carrier_size(&carrier->rule, carrier->width, carrier->height, &size)) {
        release(allocator, carrier->own.words, size);
    }
    carrier->own = SFI_NO_SLICE;
}

sf_status sfi_front_create(const sf_rule *rule, uint32_t width, uint32_t height,
                           const sf_allocator *allocator, sfi_front *front)
{
    size_t size;
    void *memory;
    if (!sfi_front_size(rule, width, height, &size)) {
        return SF_ERR_OVERFLOW;
    }
    SF_TRY(reserve(allocator, size, &memory));
    *front = sfi_front_place(rule, width, height, memory);
    return SF_OK;
}

void sfi_front_destroy(sfi_front *front, const sf_rule *rule, const sf_allocator *allocator)
{
    size_t size = 0;
    if (front->alive.words != NULL &&
        sfi_front_size(rule, front->alive.width, front->alive.height, &size)) {
        release(allocator, front->alive.words, size);
    }
    front->alive = SFI_NO_SLICE;
    front->slack = NULL;
}
