// SPDX-License-Identifier: MIT
// Points and cells, one after the other, until they are a cage.

#include "grade/build/draft.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

void sfi_draft_begin(const sf_allocator *allocator, sfi_draft *draft)
{
    memset(draft, 0, sizeof *draft);
    draft->allocator = sfi_allocator_or_default(allocator);
    draft->status = sfi_grow_array(&draft->allocator, (void **)&draft->starts,
                                   &draft->start_capacity, 1, sizeof *draft->starts)
                        ? SF_OK
                        : SF_ERR_MEMORY;
    if (draft->status == SF_OK) {
        draft->starts[0] = 0;
    }
}

uint32_t sfi_draft_point(sfi_draft *draft, const double at[3])
{
    if (draft->status == SF_OK && draft->points == SF_CAGE_POINT_MAX) {
        draft->status = SF_ERR_OVERFLOW;
    }
    if (draft->status == SF_OK &&
        !sfi_grow_array(&draft->allocator, (void **)&draft->positions, &draft->point_capacity,
                        draft->points + 1, 3 * sizeof *draft->positions)) {
        draft->status = SF_ERR_MEMORY;
    }
    if (draft->status != SF_OK) {
        return 0;
    }
    memcpy(draft->positions + 3 * draft->points, at, 3 * sizeof *at);
    return (uint32_t)draft->points++;
}

void sfi_draft_cell(sfi_draft *draft, uint32_t count, const uint32_t *points)
{
    if (draft->status == SF_OK && draft->corners + count > SF_CAGE_POINT_MAX) {
        draft->status = SF_ERR_OVERFLOW;
    }
    if (draft->status == SF_OK &&
        (!sfi_grow_array(&draft->allocator, (void **)&draft->items, &draft->corner_capacity,
                         draft->corners + count, sizeof *draft->items) ||
         !sfi_grow_array(&draft->allocator, (void **)&draft->starts, &draft->start_capacity,
                         draft->cells + 2, sizeof *draft->starts))) {
        draft->status = SF_ERR_MEMORY;
    }
    if (draft->status != SF_OK) {
        return;
    }
    memcpy(draft->items + draft->corners, points, count * sizeof *points);
    draft->corners += count;
    draft->starts[++draft->cells] = (uint32_t)draft->corners;
}

sf_status sfi_draft_end(sfi_draft *draft, sf_cage **cage, sf_fault *fault)
{
    sf_status status = draft->status;
    if (status == SF_OK) {
        sf_cage_view view;
        memset(&view, 0, sizeof view);
        view.dimension = 3;
        view.point_count = draft->points;
        view.positions = draft->positions;
        view.cell_count = draft->cells;
        view.starts = draft->starts;
        view.corners = draft->items;
        status = sf_cage_create(&view, &draft->allocator, cage, fault);
    }
    sfi_free_array(&draft->allocator, draft->positions, draft->point_capacity,
                   3 * sizeof *draft->positions);
    sfi_free_array(&draft->allocator, draft->starts, draft->start_capacity, sizeof *draft->starts);
    sfi_free_array(&draft->allocator, draft->items, draft->corner_capacity, sizeof *draft->items);
    return status;
}
