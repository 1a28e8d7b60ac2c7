// SPDX-License-Identifier: MIT
// The numbers of a legacy VTK file.
//
// All types pass through double, which holds every one of them exactly but integers of 64 bits
// beyond 2^53; those are no indices that we could use. "long" has 8 bytes, as on the machines that
// most files come from; "vtkIdType" has 4, because that is what VTK writes for it, whatever it has
// in memory.
//
// Source: Kitware, "VTK file formats", the legacy ones; vtkDataReader.cxx and vtkDataWriter.cxx of
// VTK 9.

#include "io/vtk_values.h"

#include "base/status.h"
#include "io/number.h"

#include <string.h>

static const sfi_vtk_type types[] = {
    {"bit", 0, 'u'},           {"char", 1, 'i'},         {"signed_char", 1, 'i'},
    {"unsigned_char", 1, 'u'}, {"short", 2, 'i'},        {"unsigned_short", 2, 'u'},
    {"int", 4, 'i'},           {"unsigned_int", 4, 'u'}, {"long", 8, 'i'},
    {"unsigned_long", 8, 'u'}, {"vtkidtype", 4, 'i'},    {"vtktypeint64", 8, 'i'},
    {"vtktypeuint64", 8, 'u'}, {"float", 4, 'f'},        {"double", 8, 'f'},
};

const sfi_vtk_type *sfi_vtk_type_named(const char *name)
{
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        if (strcmp(name, types[i].name) == 0) {
            return &types[i];
        }
    }
    return NULL;
}

static double decode(const sfi_vtk_type *type, uint64_t bits)
{
    float single;
    double value;
    uint32_t low = (uint32_t)bits;
    if (type->kind == 'f' && type->bytes == 4) {
        memcpy(&single, &low, sizeof single);
        return (double)single;
    }
    if (type->kind == 'f') {
        memcpy(&value, &bits, sizeof value);
        return value;
    }
    uint64_t sign = (uint64_t)1 << (8 * type->bytes - 1);
    if (type->kind == 'i' && (bits & sign) != 0) {
        return -(double)(((~bits & (sign - 1))) + 1);
    }
    return (double)bits;
}

static sf_status read_bytes(sfi_vtk_numbers *n, size_t size, uint64_t *bits)
{
    unsigned char bytes[8];
    if (sfi_cursor_read(n->cursor, bytes, size) < size) {
        return sfi_cursor_fault(n->cursor, n->fault,
                                "the file ends before all the numbers that it names; it is cut "
                                "short");
    }
    *bits = 0;
    for (size_t i = 0; i < size; i++) {
        *bits = *bits << 8 | bytes[i];
    }
    return SF_OK;
}

// The next bit; the highest of a byte comes first.
static sf_status read_bit(sfi_vtk_numbers *n, double *value)
{
    if (n->bit_count == 0) {
        uint64_t bits = 0;
        SF_TRY(read_bytes(n, 1, &bits));
        n->bits = (unsigned)bits;
        n->bit_count = 8;
    }
    *value = (double)(n->bits >> --n->bit_count & 1u);
    return SF_OK;
}

sf_status sfi_vtk_number(sfi_vtk_numbers *n, double *value)
{
    if (n->binary) {
        uint64_t bits = 0;
        if (n->type->bytes == 0) {
            return read_bit(n, value);
        }
        SF_TRY(read_bytes(n, n->type->bytes, &bits));
        *value = decode(n->type, bits);
        return SF_OK;
    }
    char token[SFI_TOKEN_SIZE];
    sfi_cursor_token(n->cursor, token, 1);
    if (!sfi_number_parse(token, value)) {
        return sfi_cursor_fault_token(n->cursor, n->fault, "a number", token);
    }
    return SF_OK;
}

sf_status sfi_vtk_whole(sfi_vtk_numbers *n, uint32_t *whole)
{
    double value = 0;
    SF_TRY(sfi_vtk_number(n, &value));
    if (!(value >= 0.0 && value <= (double)UINT32_MAX) || value != (double)(uint32_t)value) {
        return sfi_cursor_fault(n->cursor, n->fault,
                                "a count, a type or the number of a point is negative, not whole "
                                "or too large; export the file again");
    }
    *whole = (uint32_t)value;
    return SF_OK;
}
