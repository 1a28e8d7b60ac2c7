// SPDX-License-Identifier: MIT
// Points written more than once, where a property jumps.
//
// Formats for looking at things have one value for each point, or one for each cell. A property
// that jumps from one cell to the next has neither, so the point between them is written twice.
// Corners of a point share a copy if all of the properties that need copies agree there. A point
// has as many copies as cells around it at the most, so that a list is searched faster than a
// table.

#include "io/cage_copies.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

#define NONE UINT32_MAX

static int is_by_cell(const sf_cage_view *view, size_t channel)
{
    for (size_t i = 0; i < view->cell_count; i++) {
        double first = sfi_corner_value(view, channel, view->starts[i]);
        for (uint32_t j = view->starts[i]; j < view->starts[i + 1]; j++) {
            if (sfi_corner_value(view, channel, j) != first) {
                return 0;
            }
        }
    }
    return 1;
}

void sfi_channel_forms(const sf_cage_view *view, sfi_channel_form forms[SF_PROPERTY_MAX])
{
    for (size_t i = 0; i < view->channel_count; i++) {
        forms[i] = view->channels[i].indices == NULL ? SFI_BY_POINT
                   : is_by_cell(view, i)             ? SFI_BY_CELL
                                                     : SFI_BY_COPY;
    }
}

static int agree(const sf_cage_view *view, const sfi_channel_form *forms, uint32_t a, uint32_t b)
{
    for (size_t i = 0; i < view->channel_count; i++) {
        if (forms[i] == SFI_BY_COPY &&
            sfi_corner_value(view, i, a) != sfi_corner_value(view, i, b)) {
            return 0;
        }
    }
    return 1;
}

// The copy of a corner's point that has the corner's values, made if there is none.
static uint32_t copy_for(sfi_copies *c, const sf_cage_view *view, const sfi_channel_form *forms,
                         uint32_t corner)
{
    uint32_t copy = view->corners[corner], last = copy;
    if (c->corner_of[copy] == NONE) {
        c->corner_of[copy] = corner;
        return copy;
    }
    while (copy != NONE && !agree(view, forms, c->corner_of[copy], corner)) {
        last = copy;
        copy = c->next[copy];
    }
    if (copy == NONE) {
        copy = (uint32_t)(c->points + c->extra++);
        c->next[last] = copy;
        c->next[copy] = NONE;
        c->point_of[copy] = view->corners[corner];
        c->corner_of[copy] = corner;
    }
    return copy;
}

static int needs_copies(const sf_cage_view *view, const sfi_channel_form *forms)
{
    for (size_t i = 0; i < view->channel_count; i++) {
        if (forms[i] == SFI_BY_COPY) {
            return 1;
        }
    }
    return 0;
}

sf_status sfi_copies_make(sfi_copies *copies, const sf_cage_view *view,
                          const sfi_channel_form *forms, const sf_allocator *allocator)
{
    sfi_copies c = {view->point_count, view->starts[view->cell_count], 0, NULL, NULL, NULL, NULL};
    *copies = c;
    if (!needs_copies(view, forms)) {
        return SF_OK;
    }
    size_t most;
    if (!sfi_size_add(c.points, c.corners, &most) || most > UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    c.items = sfi_alloc_array(allocator, c.corners, sizeof *c.items);
    c.point_of = sfi_alloc_array(allocator, most, sizeof *c.point_of);
    c.corner_of = sfi_alloc_array(allocator, most, sizeof *c.corner_of);
    c.next = sfi_alloc_array(allocator, most, sizeof *c.next);
    *copies = c;
    if (c.items == NULL || c.point_of == NULL || c.corner_of == NULL || c.next == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < c.points; i++) {
        c.point_of[i] = i;
        c.corner_of[i] = c.next[i] = NONE;
    }
    for (uint32_t i = 0; i < c.corners; i++) {
        c.items[i] = copy_for(&c, view, forms, i);
    }
    *copies = c;
    return c.points + c.extra <= INT32_MAX ? SF_OK : SF_ERR_OVERFLOW;
}

void sfi_copies_free(sfi_copies *copies, const sf_allocator *allocator)
{
    size_t most = copies->points + copies->corners;
    sfi_free_array(allocator, copies->next, most, sizeof *copies->next);
    sfi_free_array(allocator, copies->corner_of, most, sizeof *copies->corner_of);
    sfi_free_array(allocator, copies->point_of, most, sizeof *copies->point_of);
    sfi_free_array(allocator, copies->items, copies->corners, sizeof *copies->items);
}
