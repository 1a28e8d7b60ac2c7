// SPDX-License-Identifier: MIT
// Which kernel table is in use.
//
// The one piece of global state in libsf: a pointer to a const table, read and written with relaxed
// atomics. Threads that race to choose write the same value, and no other memory hangs on it.

#include "simd/kernels.h"

#include <stddef.h>

static const sfi_kernels *chosen;

const sfi_kernels *sfi_kernels_for(sf_isa isa)
{
    switch (isa) {
    case SF_ISA_REFERENCE:
        return sfi_kernels_reference();
    case SF_ISA_WORD:
        return sfi_kernels_word();
    case SF_ISA_SSE2:
        return sfi_kernels_sse2();
    case SF_ISA_NEON:
        return sfi_kernels_neon();
    case SF_ISA_AVX2:
        return sfi_kernels_avx2();
    case SF_ISA_AVX512:
        return sfi_kernels_avx512();
    case SF_ISA_COUNT:
        break;
    }
    return NULL;
}

static const sfi_kernels *best_up_to(sf_isa limit)
{
    for (int isa = (int)limit; isa > (int)SF_ISA_REFERENCE; isa--) {
        const sfi_kernels *kernels = sfi_kernels_for((sf_isa)isa);
        if (kernels != NULL) {
            return kernels;
        }
    }
    return sfi_kernels_reference();
}

const sfi_kernels *sfi_kernels_get(void)
{
    const sfi_kernels *kernels = __atomic_load_n(&chosen, __ATOMIC_RELAXED);
    if (kernels == NULL) {
        kernels = best_up_to((sf_isa)(SF_ISA_COUNT - 1));
        __atomic_store_n(&chosen, kernels, __ATOMIC_RELAXED);
    }
    return kernels;
}

const char *sf_isa_limit(sf_isa limit)
{
    if ((unsigned)limit >= (unsigned)SF_ISA_COUNT) {
        limit = (sf_isa)(SF_ISA_COUNT - 1);
    }
    const sfi_kernels *kernels = best_up_to(limit);
    __atomic_store_n(&chosen, kernels, __ATOMIC_RELAXED);
    return kernels->name;
}
