// SPDX-License-Identifier: MIT
// Reading a cage: which format it is, and what all formats share.

#include "io/cage_raw.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

sf_cage_read_options sf_cage_read_options_default(void)
{
    sf_cage_read_options options = {sizeof options, SF_CAGE_FORMAT_AUTO, UINT64_C(8) << 30,
                                    SF_CAGE_POINT_MAX, SF_CAGE_POINT_MAX};
    return options;
}

static int starts_with(const unsigned char *bytes, size_t have, const char *word)
{
    size_t length = strlen(word);
    return have >= length && memcmp(bytes, word, length) == 0;
}

// Judge by the first words. Medit files may begin with blanks and comments; the other two begin
// with their names.
static sf_cage_format sniff(sfi_cursor *cursor)
{
    size_t have;
    const unsigned char *bytes = sfi_cursor_peek(cursor, SFI_CURSOR_PEEK, &have);
    if (starts_with(bytes, have, "# vtk DataFile")) {
        return SF_CAGE_FORMAT_VTK;
    }
    if (starts_with(bytes, have, "MFEM ")) {
        return SF_CAGE_FORMAT_MFEM;
    }
    for (size_t i = 0; i < have; i++) {
        if (starts_with(bytes + i, have - i, "MeshVersionFormatted")) {
            return SF_CAGE_FORMAT_MEDIT;
        }
        if (bytes[i] == '#') {
            while (i + 1 < have && bytes[i] != '\n' && bytes[i] != '\r') {
                i++;
            }
        } else if (bytes[i] > ' ') {
            break;
        }
    }
    return SF_CAGE_FORMAT_AUTO;
}

static sf_status refuse(sfi_raw *raw)
{
    size_t have;
    (void)sfi_cursor_peek(raw->cursor, 1, &have);
    return sfi_cursor_fault_whole(
        raw->cursor, raw->fault,
        have == 0 ? "the file is empty; save the mesh again"
                  : "this is no Medit, MFEM or VTK file of cells; save the mesh "
                    "as one of these");
}

static sf_status read_as(sfi_raw *raw, sf_cage_format format, sf_cage **cage,
                         sf_cage_reading *reading)
{
    switch (format) {
    case SF_CAGE_FORMAT_MEDIT:
        SF_TRY(sfi_medit_read(raw));
        break;
    case SF_CAGE_FORMAT_MFEM:
        SF_TRY(sfi_mfem_read(raw));
        break;
    case SF_CAGE_FORMAT_VTK:
        return sfi_cage_vtk_read(raw, cage, reading);
    default:
        return refuse(raw);
    }
    if (raw->cursor->failure != SF_OK) {
        return sfi_cursor_fault(raw->cursor, raw->fault, "");
    }
    return sfi_raw_make(raw, cage, reading);
}

static sf_cage_read_options merged(const sf_cage_read_options *options)
{
    sf_cage_read_options merged = sf_cage_read_options_default();
    if (options != NULL) { // an older caller knows fewer fields, a newer one more
        size_t known = options->struct_size < sizeof merged ? options->struct_size : sizeof merged;
        memcpy(&merged, options, known);
    }
    merged.points_max =
        merged.points_max < SF_CAGE_POINT_MAX ? merged.points_max : SF_CAGE_POINT_MAX;
    merged.corners_max =
        merged.corners_max < SF_CAGE_POINT_MAX ? merged.corners_max : SF_CAGE_POINT_MAX;
    return merged;
}

sf_status sf_cage_read(sf_source source, const sf_cage_read_options *options,
                       const sf_allocator *allocator, sf_cage **cage, sf_cage_reading *reading,
                       sf_fault *fault)
{
    sf_cage_read_options within = merged(options);
    if (cage == NULL || source.read == NULL || (unsigned)within.format > SF_CAGE_FORMAT_VTK) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "no source, no place for the cage, or an unknown format");
    }
    sfi_cursor cursor;
    sf_cage *made = NULL;
    sf_cage_reading found = {within.format, 0, 0};
    sf_status status = sfi_cursor_begin(&cursor, source, within.bytes_max, allocator);
    if (status == SF_OK) {
        sfi_raw raw;
        sfi_raw_begin(&raw, &cursor, &within, fault);
        sfi_cursor_skip_mark(&cursor);
        if (found.format == SF_CAGE_FORMAT_AUTO) {
            found.format = sniff(&cursor);
        }
        status = read_as(&raw, found.format, &made, &found);
        sfi_raw_end(&raw);
    }
    sfi_cursor_end(&cursor);
    if (status == SF_ERR_MEMORY) {
        (void)sfi_fault_set(fault, status, 0, 0, "there is not enough memory for this cage");
    }
    if (status != SF_OK) {
        return status;
    }
    *cage = made;
    if (reading != NULL) {
        *reading = found;
    }
    return SF_OK;
}
