// SPDX-License-Identifier: MIT
// A legacy VTK file being read: what the three parts of its reader share.

#ifndef SF_IO_VTK_READER_H
#define SF_IO_VTK_READER_H

#include "io/vtk_read.h"
#include "io/vtk_values.h"

typedef struct sfi_vtk_reader {
    sfi_vtk *vtk;
    sfi_cursor *cursor;
    sf_fault *fault;
    int binary;
    int has_offsets; // version 5 and later
    int has_points, has_cells, has_types;
    sfi_vtk_home home; // of the data that come next
    uint32_t rows;     // how many rows those have, but for fields
} sfi_vtk_reader;

// A sentence about the place where the cursor stands.
sf_status sfi_vtk_fault(const sfi_vtk_reader *r, const char *sentence);
sf_status sfi_vtk_unsupported(const sfi_vtk_reader *r, const char *sentence);

// The next token, in lower case, of this line or (lines != 0) a later one; one that must be `word`.
size_t sfi_vtk_word(sfi_vtk_reader *r, char token[SFI_TOKEN_SIZE], int lines);
sf_status sfi_vtk_expect(sfi_vtk_reader *r, const char *word);

// A count, of this line; the same in a token.
sf_status sfi_vtk_read_count(sfi_vtk_reader *r, uint32_t *count);
sf_status sfi_vtk_parse_count(sfi_vtk_reader *r, const char *token, uint32_t *count);

// A name: VTK writes blanks and other odd bytes as % and two digits.
sf_status sfi_vtk_read_name(sfi_vtk_reader *r, char name[SFI_TOKEN_SIZE], int lines);

// Numbers of the type that stands next on the line, and such as have no type but int.
sf_status sfi_vtk_read_type(sfi_vtk_reader *r, sfi_vtk_numbers *numbers);
sfi_vtk_numbers sfi_vtk_integers(const sfi_vtk_reader *r);

// To be called before the first number: in binary they begin behind the line's end.
void sfi_vtk_begin_data(sfi_vtk_reader *r);

// Data of the kind that `word` begins; a field; METADATA, which ends at an empty line.
sf_status sfi_vtk_read_data(sfi_vtk_reader *r, const char *word);
sf_status sfi_vtk_read_field(sfi_vtk_reader *r);
void sfi_vtk_pass_over(sfi_vtk_reader *r);

#endif
