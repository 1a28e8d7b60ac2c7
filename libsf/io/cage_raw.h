// SPDX-License-Identifier: MIT
// A cage as a file gives it, before anything is known of it: what the three readers fill.
//
// Points, elements of any dimension, sharp edges and points, and data, in the order of the file and
// in any order among each other: some formats give the elements before the points. Everything
// remembers the line that it came from, so that what turns out to be wrong later can be named.
// Arrays grow as the bytes come; no count of a file is ever trusted for memory.

#ifndef SF_IO_CAGE_RAW_H
#define SF_IO_CAGE_RAW_H

#include <sf/cage_io.h>

#include "io/cursor.h"
#include "io/list.h"

// An element: its corners are corners[start .. start + count).
typedef struct sfi_raw_cell {
    double reference; // what the file calls it: a material, an attribute
    uint32_t start, count;
    uint32_t line;      // 0: not known
    uint32_t dimension; // below 2: neither a cell nor a face
} sfi_raw_cell;

// Something sharp: an edge by its two ends, or a point, twice.
typedef struct sfi_raw_mark {
    double sharpness;
    uint32_t points[2];
    uint32_t line;
} sfi_raw_mark;

// Data of the file that become a property.
typedef struct sfi_raw_array {
    sf_property property;
    int by_cell;          // one value for each element; 0: for each point
    const double *values; // whoever reads owns them
    size_t count;
} sfi_raw_array;

typedef struct sfi_raw {
    sfi_cursor *cursor;
    sf_fault *fault;
    sf_cage_read_options options;
    sfi_list positions;    // double[3], of each point
    sfi_list corners;      // uint32_t
    sfi_list cells;        // sfi_raw_cell
    sfi_list creases;      // sfi_raw_mark
    sfi_list sharps;       // sfi_raw_mark
    sfi_list arrays;       // sfi_raw_array
    uint32_t first_number; // what the file's first point is called, 0 or 1; for sentences
    // What the references of cells are called, as a property; NULL: they are none.
    const char *reference_name;
    // The point that each of the file's is a copy of, written by sf_cage_write_vtk() where a
    // property jumps; NULL: none is. Whoever reads owns it.
    uint32_t *joins;
} sfi_raw;

void sfi_raw_begin(sfi_raw *raw, sfi_cursor *cursor, const sf_cage_read_options *options,
                   sf_fault *fault);
void sfi_raw_end(sfi_raw *raw);

// Append an item to a list of the raw cage.
sf_status sfi_raw_push(sfi_raw *raw, sfi_list *list, const void *item);

// Append a point: finite and within the limits.
sf_status sfi_raw_point(sfi_raw *raw, const double xyz[3]);

// Begin an element at the line where the cursor is, then append its corners, counted from 0.
sf_status sfi_raw_cell_begin(sfi_raw *raw, uint32_t dimension);
sf_status sfi_raw_corner(sfi_raw *raw, uint32_t point);
static inline sfi_raw_cell *sfi_raw_last_cell(const sfi_raw *raw)
{
    return (sfi_raw_cell *)raw->cells.items + raw->cells.count - 1;
}

// Append an edge (or, with one point twice, a point) that is sharp for ever, to `list`.
sf_status sfi_raw_mark_sharp(sfi_raw *raw, sfi_list *list, uint32_t a, uint32_t b);

// The next token that is no comment, of this line or a later one.
size_t sfi_raw_word(sfi_raw *raw, char token[SFI_TOKEN_SIZE]);

// The next token as a number; as a whole one of 0 to most.
sf_status sfi_raw_number(sfi_raw *raw, const char *expected, double *value);
sf_status sfi_raw_whole(sfi_raw *raw, const char *expected, uint32_t most, uint32_t *value);

// A fault at the cursor's place: the file is well-formed, but no cage can be made of it.
sf_status sfi_raw_unsupported(sfi_raw *raw, const char *sentence);

// A property with the UUID that is made of its name. Names longer than a property's are refused.
sf_status sfi_raw_property(sfi_raw *raw, const char *name, sf_property *property);

// Make the cage of what was read.
sf_status sfi_raw_make(sfi_raw *raw, sf_cage **cage, sf_cage_reading *reading);

// The readers.
sf_status sfi_medit_read(sfi_raw *raw);
sf_status sfi_mfem_read(sfi_raw *raw);
sf_status sfi_cage_vtk_read(sfi_raw *raw, sf_cage **cage, sf_cage_reading *reading);

#endif
