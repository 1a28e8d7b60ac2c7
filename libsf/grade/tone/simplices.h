// SPDX-License-Identifier: MIT
// Simplices between points.

#ifndef SF_GRADE_TONE_SIMPLICES_H
#define SF_GRADE_TONE_SIMPLICES_H

#include <sf/mixture.h>

typedef struct sfi_simplices {
    uint32_t *corners; // `side` to a simplex, rising
    size_t count, capacity;
    size_t side;
} sfi_simplices;

// Whether no more than 2^22 simplices of `side` corners can be made of so many points.
int sfi_simplices_fit(size_t points, size_t side);

// The Delaunay simplices of points given by `side` fractions each, of sum 1.
sf_status sfi_simplices_create(const double *fractions, size_t points, size_t side,
                               const sf_allocator *allocator, sfi_simplices *simplices);
void sfi_simplices_destroy(sfi_simplices *simplices, const sf_allocator *allocator);

#endif
