// SPDX-License-Identifier: MIT
// Writing legacy VTK: numbers as text or as binary with the highest byte first, and names.

#ifndef SF_IO_VTK_WRITE_H
#define SF_IO_VTK_WRITE_H

#include "io/emitter.h"

typedef struct sfi_vtk_writer {
    sfi_emitter out;
    int binary;
} sfi_vtk_writer;

// The first four lines: version 3.0, an unstructured grid. The title is one line.
void sfi_vtk_write_head(sfi_vtk_writer *writer, sf_sink sink, int binary, const char *title);

// Words and whole numbers of the lines between blocks of numbers; a name, as VTK encodes it.
void sfi_vtk_write_text(sfi_vtk_writer *writer, const char *text);
void sfi_vtk_write_count(sfi_vtk_writer *writer, uint64_t count);
void sfi_vtk_write_name(sfi_vtk_writer *writer, const char *name);

// A number of a block: a double, or an int. `last` ends a line of text.
void sfi_vtk_write_double(sfi_vtk_writer *writer, double value, int last);
void sfi_vtk_write_int(sfi_vtk_writer *writer, uint32_t value, int last);

// The end of a block of numbers.
void sfi_vtk_write_break(sfi_vtk_writer *writer);

// All of it has been written: SF_OK, or what the sink said first.
sf_status sfi_vtk_write_end(sfi_vtk_writer *writer);

#endif
