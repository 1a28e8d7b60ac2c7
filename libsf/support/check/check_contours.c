// SPDX-License-Identifier: MIT
// Contours pushed into a check: drawn as runs, which the checker takes as they are.
//
// The runs are collected first, because a layer is pushed whole or not at all.

#include "base/memory.h"
#include "base/status.h"
#include "support/check/finding.h"
#include "voxel/contour.h"

typedef struct collected {
    sf_allocator allocator;
    sf_run *runs;
    size_t count, capacity;
} collected;

static sf_status collect(void *user, uint32_t x0, uint32_t x1, uint32_t y)
{
    collected *all = user;
    sf_run run = {x0, x1, y, 0};
    if (!sfi_grow_array(&all->allocator, (void **)&all->runs, &all->capacity, all->count + 1,
                        sizeof *all->runs)) {
        return SF_ERR_MEMORY;
    }
    all->runs[all->count++] = run;
    return SF_OK;
}

sf_status sf_checker_push_contours(sf_checker *checker, const sf_lattice *lattice,
                                   const sf_contours *contours, sf_contour_fill fill,
                                   const sf_allocator *allocator, sf_fault *fault)
{
    uint32_t width, height;
    if (checker == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_lattice_validate(lattice));
    sfi_checker_extent(checker, &width, &height);
    if (width != lattice->nx || height != lattice->ny) {
        return SF_ERR_SHAPE;
    }
    collected all = {sfi_allocator_or_default(allocator), NULL, 0, 0};
    sf_status status =
        sfi_contour_draw(lattice, contours, fill, &all.allocator, fault, collect, &all);
    if (status == SF_OK) {
        status = sf_checker_push_runs(checker, all.runs, all.count);
    }
    sfi_free_array(&all.allocator, all.runs, all.capacity, sizeof *all.runs);
    return status;
}
