// SPDX-License-Identifier: MIT
// Points written more than once, where a property jumps.

#ifndef SF_IO_CAGE_COPIES_H
#define SF_IO_CAGE_COPIES_H

#include <sf/cage.h>

// How a property is written.
typedef enum sfi_channel_form {
    SFI_BY_POINT, // the same at all corners of a point: data of points
    SFI_BY_CELL,  // the same at all corners of a cell: data of cells
    SFI_BY_COPY   // neither: data of points, some of which have copies
} sfi_channel_form;

// The first copy of each point has its number; the others follow. Where `extra` is 0 there are no
// arrays, and copies are points.
typedef struct sfi_copies {
    size_t points, corners, extra;
    uint32_t *items;     // for each corner of the cage, its copy
    uint32_t *point_of;  // for each copy, its point
    uint32_t *corner_of; // for each copy, a corner that has its values; UINT32_MAX: none
    uint32_t *slots;     // copies by what they are, while they are made; UINT32_MAX: free
    size_t slot_count;   // a power of two, more than twice the corners
} sfi_copies;

// What a property has at a corner.
static inline double sfi_corner_value(const sf_cage_view *view, size_t channel, uint32_t corner)
{
    const sf_channel *c = &view->channels[channel];
    return c->values[c->indices != NULL ? c->indices[corner] : view->corners[corner]];
}

// The form of each property; a cell's value is that of its first corner.
void sfi_channel_forms(const sf_cage_view *view, sfi_channel_form forms[SF_PROPERTY_MAX]);

// Make copies of points, so that each property of the form SFI_BY_COPY has one value at each copy.
// SF_ERR_MEMORY; SF_ERR_OVERFLOW: more than 2^31 - 1 copies.
sf_status sfi_copies_make(sfi_copies *copies, const sf_cage_view *view,
                          const sfi_channel_form *forms, const sf_allocator *allocator);
void sfi_copies_free(sfi_copies *copies, const sf_allocator *allocator);

#endif
