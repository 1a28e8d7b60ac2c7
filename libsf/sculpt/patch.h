// SPDX-License-Identifier: MIT
// Patch: a rectangle of a slice in words of its own, so that it is one string of bits.
//
// Windows on a grid begin with a word of it and have its rows far apart. A patch begins with the
// first column of its rectangle, and ends each row with at least one bit that is empty. So a step
// to the side is a shift of the string, a step to another row a distance in words, and no loop
// over it asks where a row begins or ends: what a shift carries from one row into the next falls
// on the empty bit, and is masked away.
//
// Planes are pieces of memory for patches, used for one after the other. Two empty rows lie before
// and after the rows of a plane, and one word more. A plane is emptied when it is placed, so that
// the last bits of its rows are empty from the beginning, whichever of them are written.

#ifndef SF_SCULPT_PATCH_H
#define SF_SCULPT_PATCH_H

#include <sf/voxel.h>

// What the planes of one patch have in common.
typedef struct sfi_patch {
    sf_rect rect;    // in the grid
    uint32_t height; // rows
    size_t stride;   // words of a row
} sfi_patch;

sfi_patch sfi_patch_make(sf_rect rect);

// Words of a plane for patches up to this size, all around them.
size_t sfi_patch_room(uint32_t width, uint32_t height);

// The first row of an empty plane for a patch, in memory of sfi_patch_room() words.
uint64_t *sfi_patch_place(const sfi_patch *p, uint64_t *memory);

// plane |= what a slice holds in the rectangle; word 0 of its rows is column x0, its first row y0.
void sfi_patch_load(const sfi_patch *p, uint64_t *plane, sf_slice slice, uint32_t x0, uint32_t y0);

// The plane as a slice.
static inline sf_slice sfi_patch_slice(const sfi_patch *p, uint64_t *plane)
{
    sf_slice slice = {plane, p->rect.x1 - p->rect.x0, p->height, p->stride};
    return slice;
}

// Rows first <= y < end of a patch, which may reach two rows beyond it on either side.
typedef struct sfi_rows {
    int64_t first, end;
} sfi_rows;

static inline sfi_rows sfi_rows_grow(sfi_rows rows, int64_t by)
{
    sfi_rows grown = {rows.first - by, rows.end + by};
    return grown;
}

// The steps of nearly all rules: the plus, and the square around it.
typedef enum sfi_step_shape { SFI_STEP_PLUS, SFI_STEP_SQUARE, SFI_STEP_OTHER } sfi_step_shape;

sfi_step_shape sfi_step_shape_of(const sf_element *element);

// to = from, a voxel wider on either side.
void sfi_patch_widen(const sfi_patch *p, uint64_t *to, const uint64_t *from, sfi_rows rows);

// from &= ~(what is a step from `taken`), a plus or a square; `scratch` is written. Returns whether
// anything is left, in these rows.
int sfi_patch_subtract_step(const sfi_patch *p, sfi_step_shape shape, uint64_t *from,
                            const uint64_t *taken, uint64_t *scratch, sfi_rows rows);

#endif
