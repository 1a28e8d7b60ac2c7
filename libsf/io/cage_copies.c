// SPDX-License-Identifier: MIT
// Points written more than once, where a property jumps.
//
// Formats for looking at things have one value for each point, or one for each cell. A property
// that jumps from one cell to the next has neither, so the point between them is written twice.
// Corners of a point share a copy if all of the properties that need copies agree there. Copies are
// looked up in a hash table, by their points and values: a list for each point would do where a few
// cells meet, but thousands may.

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

static uint64_t mix(uint64_t h, uint64_t word)
{
    h = (h ^ word) * 0x9e3779b97f4a7c15u;
    return h ^ h >> 31;
}

static uint64_t hash_corner(const sf_cage_view *view, const sfi_channel_form *forms,
                            uint32_t corner)
{
    uint64_t h = mix(0, view->corners[corner]);
    for (size_t i = 0; i < view->channel_count; i++) {
        double value = forms[i] == SFI_BY_COPY ? sfi_corner_value(view, i, corner) : 0;
        uint64_t bits = 0; // of zero, of either sign
        if (value != 0) {
            memcpy(&bits, &value, sizeof bits);
        }
        h = mix(h, bits);
    }
    return h;
}

// The copy of a corner's point that has the corner's values, made if there is none. The first of a
// point is that point.
static uint32_t copy_for(sfi_copies *c, const sf_cage_view *view, const sfi_channel_form *forms,
                         uint32_t corner)
{
    uint32_t point = view->corners[corner];
    size_t mask = c->slot_count - 1, at = (size_t)hash_corner(view, forms, corner) & mask;
    for (; c->slots[at] != NONE; at = (at + 1) & mask) {
        uint32_t copy = c->slots[at];
        if (c->point_of[copy] == point && agree(view, forms, c->corner_of[copy], corner)) {
            return copy;
        }
    }
    int is_first = c->corner_of[point] == NONE;
    uint32_t copy = is_first ? point : (uint32_t)(c->points + c->extra++);
    c->slots[at] = copy;
    c->point_of[copy] = point;
    c->corner_of[copy] = corner;
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
    sfi_copies c = {
        view->point_count, view->starts[view->cell_count], 0, NULL, NULL, NULL, NULL, 1};
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
    while (c.slot_count <= 2 * c.corners) {
        c.slot_count *= 2;
    }
    c.slots = sfi_alloc_array(allocator, c.slot_count, sizeof *c.slots);
    *copies = c;
    if (c.items == NULL || c.point_of == NULL || c.corner_of == NULL || c.slots == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < c.points; i++) {
        c.point_of[i] = i;
        c.corner_of[i] = NONE;
    }
    memset(c.slots, 0xff, c.slot_count * sizeof *c.slots);
    for (uint32_t i = 0; i < c.corners; i++) {
        c.items[i] = copy_for(&c, view, forms, i);
    }
    *copies = c;
    return c.points + c.extra <= INT32_MAX ? SF_OK : SF_ERR_OVERFLOW;
}

void sfi_copies_free(sfi_copies *copies, const sf_allocator *allocator)
{
    size_t most = copies->points + copies->corners;
    sfi_free_array(allocator, copies->slots, copies->slot_count, sizeof *copies->slots);
    sfi_free_array(allocator, copies->corner_of, most, sizeof *copies->corner_of);
    sfi_free_array(allocator, copies->point_of, most, sizeof *copies->point_of);
    sfi_free_array(allocator, copies->items, copies->corners, sizeof *copies->items);
}
