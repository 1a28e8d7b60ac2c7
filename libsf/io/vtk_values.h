// SPDX-License-Identifier: MIT
// The numbers of a legacy VTK file: text, or binary with the highest byte first.

#ifndef SF_IO_VTK_VALUES_H
#define SF_IO_VTK_VALUES_H

#include "io/cursor.h"

typedef struct sfi_vtk_type {
    const char *name;
    uint8_t bytes; // in binary; 0: bits, eight in a byte
    char kind;     // 'u': unsigned, 'i': signed, 'f': floating point
} sfi_vtk_type;

// So many numbers of one type, one after the other.
typedef struct sfi_vtk_numbers {
    sfi_cursor *cursor;
    sf_fault *fault;
    const sfi_vtk_type *type;
    int binary;
    unsigned bits, bit_count; // of a byte of bits, what is left
} sfi_vtk_numbers;

// The type of that name, in lower case; NULL when it has none that is a number.
const sfi_vtk_type *sfi_vtk_type_named(const char *name);

// The next number. The rest of the line before the first one must have been skipped, in binary.
sf_status sfi_vtk_number(sfi_vtk_numbers *numbers, double *value);

// The next number, which counts or numbers something.
sf_status sfi_vtk_whole(sfi_vtk_numbers *numbers, uint32_t *value);

#endif
