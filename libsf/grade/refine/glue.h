// SPDX-License-Identifier: MIT
// How the corners of cells hang together for one property.

#ifndef SF_GRADE_REFINE_GLUE_H
#define SF_GRADE_REFINE_GLUE_H

#include "grade/cage/complex.h"

// Points of a property: corners of cells that meet and agree.
typedef struct sfi_glue {
    uint32_t points;   // how many
    uint32_t corners;  // of all cells
    uint32_t *items;   // of each corner its point
    uint32_t *sources; // of each point the value that it is given
} sfi_glue;

// Glue the cells of a complex where both name the same values at all points of a face that they
// share (in dimension 2 of an edge). `indices` names a value for each corner. SF_ERR_MEMORY.
sf_status sfi_glue_make(const sfi_complex *complex, const uint32_t *indices,
                        const sf_allocator *allocator, sfi_glue *glue);
void sfi_glue_free(const sf_allocator *allocator, sfi_glue *glue);

// Whether corners are glued wherever they meet: the property jumps nowhere, and has the points of
// the complex. Then `sources` receives, of each point, the value that it is given; the first one
// for points that no cell uses.
int sfi_glue_is_whole(const sfi_complex *complex, const sfi_glue *glue, uint32_t *sources);

// The complex that glued cells make, sharp where the one they came from is. SF_ERR_MEMORY.
sf_status sfi_glue_complex(const sfi_complex *complex, const sfi_glue *glue,
                           const sf_allocator *allocator, sfi_complex *glued);

#endif
