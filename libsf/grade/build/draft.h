// SPDX-License-Identifier: MIT
// A cage while it is built.

#ifndef SF_GRADE_BUILD_DRAFT_H
#define SF_GRADE_BUILD_DRAFT_H

#include <sf/cage_build.h>

// Arrays that grow; when something did not fit, `status` says so, and nothing more is added.
typedef struct sfi_draft {
    sf_allocator allocator;
    sf_status status;
    size_t points, cells, corners;
    size_t point_capacity, start_capacity, corner_capacity;
    double *positions;
    uint32_t *starts, *items;
} sfi_draft;

void sfi_draft_begin(const sf_allocator *allocator, sfi_draft *draft);

// Append a point, and give its number; a cell of `count` points.
uint32_t sfi_draft_point(sfi_draft *draft, const double at[3]);
void sfi_draft_cell(sfi_draft *draft, uint32_t count, const uint32_t *points);

// Make the cage, and free the draft, whatever comes of it.
sf_status sfi_draft_end(sfi_draft *draft, sf_cage **cage, sf_fault *fault);

#endif
