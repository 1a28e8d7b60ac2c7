// SPDX-License-Identifier: MIT
// Bill: what a result costs, and the other questions that are asked of whole grids.
//
// All of them are one pass over words; nothing here is worth a progress report.

#include "support/repair/repair.h"

#include "base/status.h"
#include "support/check/row.h"
#include "voxel/slice.h"

static uint64_t sum_costs(const uint8_t *costs, const uint64_t *bits, size_t words)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < words; i++) {
        for (uint64_t w = bits[i]; w != 0; w &= w - 1) {
            sum += costs == NULL ? 1 : costs[i * 64 + sfi_lowest_bit(w)];
        }
    }
    return sum;
}

// Voxels of row a without those of row b: their number is added to count, their costs to
// cost. Bits past the width have none: what the caller drew may hold some.
static void bill_row(const uint8_t *costs, const uint64_t *a, const uint64_t *b, uint32_t width,
                     uint64_t *count, uint64_t *cost)
{
    uint64_t rest[SFI_ROW_WORDS_MAX];
    size_t words = sfi_row_words(width);
    const sfi_kernels *kernels = sfi_kernels_get();
    kernels->subtract_words(rest, a, b, words);
    rest[words - 1] &= sfi_tail_mask(width);
    uint64_t number = kernels->popcount(rest, words);
    *count += number;
    *cost += costs == NULL || number == 0 ? number : sum_costs(costs, rest, words);
}

sfi_bill sfi_job_bill(const sfi_job *job, const sf_grid *result)
{
    sfi_bill bill = {0, 0, 0};
    uint32_t nx = job->lattice.nx, ny = job->lattice.ny;
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        sf_slice is = sf_grid_slice(result, k), was = sf_grid_slice(job->drawn, k);
        for (uint32_t y = 0; y < ny; y++) {
            size_t at = ((size_t)k * ny + y) * nx;
            const uint64_t *now = sfi_slice_row(is, y), *then = sfi_slice_row(was, y);
            const uint8_t *add = job->add != NULL ? job->add + at : NULL;
            const uint8_t *remove = job->remove != NULL ? job->remove + at : NULL;
            uint64_t cost = 0;
            bill_row(add, now, then, nx, &bill.added, &cost);
            bill.cost += cost * job->scale;
            bill_row(remove, then, now, nx, &bill.removed, &bill.cost);
        }
    }
    return bill;
}

uint64_t sfi_job_cost_of_lost(const sfi_job *job)
{
    uint64_t count = 0, cost = 0;
    uint32_t nx = job->lattice.nx, ny = job->lattice.ny;
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        sf_slice drawn = sf_grid_slice(job->drawn, k), room = sf_grid_slice(job->room, k);
        for (uint32_t y = 0; y < ny; y++) {
            const uint8_t *remove =
                job->remove != NULL ? job->remove + ((size_t)k * ny + y) * nx : NULL;
            bill_row(remove, sfi_slice_row(drawn, y), sfi_slice_row(room, y), nx, &count, &cost);
        }
    }
    return cost;
}

uint64_t sfi_job_hanging(const sfi_job *job)
{
    return sf_grid_popcount(job->drawn) - sf_grid_popcount(job->roots);
}
