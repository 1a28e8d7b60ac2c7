// SPDX-License-Identifier: MIT
// Writing legacy VTK.
//
// Version 3.0 is what every program reads that reads VTK at all. Binary blocks end with a line end
// of their own, as VTK writes them.
//
// Source: Kitware, "VTK file formats", the legacy ones; vtkDataWriter.cxx of VTK 9 for names.

#include "io/vtk_write.h"

#include <string.h>

void sfi_vtk_write_head(sfi_vtk_writer *writer, sf_sink sink, int binary, const char *title)
{
    sfi_emitter_begin(&writer->out, sink);
    writer->binary = binary;
    sfi_vtk_write_text(writer, "# vtk DataFile Version 3.0\n");
    sfi_vtk_write_text(writer, title);
    sfi_vtk_write_text(writer, binary ? "\nBINARY" : "\nASCII");
    sfi_vtk_write_text(writer, "\nDATASET UNSTRUCTURED_GRID\n");
}

void sfi_vtk_write_text(sfi_vtk_writer *writer, const char *text)
{
    sfi_emit_text(&writer->out, text);
}

void sfi_vtk_write_count(sfi_vtk_writer *writer, uint64_t count)
{
    sfi_emit_whole(&writer->out, count);
}

void sfi_vtk_write_name(sfi_vtk_writer *writer, const char *name)
{
    static const char digits[] = "0123456789ABCDEF";
    for (size_t i = 0; name[i] != '\0'; i++) {
        unsigned char byte = (unsigned char)name[i];
        if (byte < '!' || byte > '~' || byte == '"' || byte == '%') {
            char code[3] = {'%', digits[byte >> 4], digits[byte & 15]};
            sfi_emit_bytes(&writer->out, code, sizeof code);
        } else {
            sfi_emit_bytes(&writer->out, &name[i], 1);
        }
    }
}

static void write_bits(sfi_vtk_writer *writer, uint64_t bits, size_t size)
{
    unsigned char bytes[8];
    for (size_t i = 0; i < size; i++) {
        bytes[i] = (unsigned char)(bits >> 8 * (size - 1 - i));
    }
    sfi_emit_bytes(&writer->out, bytes, size);
}

void sfi_vtk_write_double(sfi_vtk_writer *writer, double value, int last)
{
    if (writer->binary) {
        uint64_t bits;
        memcpy(&bits, &value, sizeof bits);
        write_bits(writer, bits, 8);
        return;
    }
    sfi_emit_number(&writer->out, value);
    sfi_emit_text(&writer->out, last ? "\n" : " ");
}

void sfi_vtk_write_int(sfi_vtk_writer *writer, uint32_t value, int last)
{
    if (writer->binary) {
        write_bits(writer, value, 4);
        return;
    }
    sfi_emit_whole(&writer->out, value);
    sfi_emit_text(&writer->out, last ? "\n" : " ");
}

void sfi_vtk_write_break(sfi_vtk_writer *writer)
{
    if (writer->binary) {
        sfi_emit_text(&writer->out, "\n");
    }
}

sf_status sfi_vtk_write_end(sfi_vtk_writer *writer)
{
    return sfi_emitter_end(&writer->out);
}
