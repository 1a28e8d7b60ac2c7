// SPDX-License-Identifier: MIT
// Legacy VTK files in: the grammar.
//
// After three lines (version, title, ASCII or BINARY) the file is a sequence of sections, each a
// key word with what it needs to be read; words are not case-sensitive. Versions below 5 give cells
// as rows, each led by the number of its corners; from 5 on there are two arrays, where the corners
// of each cell begin, and the corners. Data may stand in a dozen forms; all of them are read,
// because nothing says where one ends but its own counts, and what nobody asks for is dropped.
//
// Source: Kitware, "VTK file formats", the legacy ones.

#include "io/vtk_reader.h"

#include "base/status.h"

#include <float.h>
#include <math.h>

void sfi_vtk_begin(sfi_vtk *vtk)
{
    memset(vtk, 0, sizeof *vtk);
    vtk->points_max = vtk->corners_max = UINT32_MAX - 1;
    vtk->points = sfi_list_of(3 * sizeof(double));
    vtk->starts = vtk->corners = vtk->types = vtk->lines = sfi_list_of(sizeof(uint32_t));
    vtk->arrays = sfi_list_of(sizeof(sfi_vtk_array));
}

void sfi_vtk_end(sfi_vtk *vtk, const sf_allocator *allocator)
{
    for (size_t i = 0; i < vtk->arrays.count; i++) {
        sfi_list_free(allocator, &((sfi_vtk_array *)vtk->arrays.items)[i].values);
    }
    sfi_list_free(allocator, &vtk->arrays);
    sfi_list_free(allocator, &vtk->lines);
    sfi_list_free(allocator, &vtk->types);
    sfi_list_free(allocator, &vtk->corners);
    sfi_list_free(allocator, &vtk->starts);
    sfi_list_free(allocator, &vtk->points);
}

const sfi_vtk_array *sfi_vtk_find(const sfi_vtk *vtk, sfi_vtk_home home, const char *name)
{
    const sfi_vtk_array *arrays = vtk->arrays.items;
    for (size_t i = 0; i < vtk->arrays.count; i++) {
        if (arrays[i].home == home && strcmp(arrays[i].name, name) == 0) {
            return &arrays[i];
        }
    }
    return NULL;
}

// --- points and cells ----------------------------------------------------------------------------

static sf_status too_many(const sfi_vtk_reader *r, size_t most, const char *what)
{
    return sfi_fault_set(r->fault, SF_ERR_OVERFLOW, r->cursor->line, sfi_cursor_offset(r->cursor),
                         "the file has more than %zu %s", most, what);
}

static sf_status read_points(sfi_vtk_reader *r)
{
    uint32_t count;
    sfi_vtk_numbers numbers;
    SF_TRY(sfi_vtk_read_count(r, &count));
    SF_TRY(sfi_vtk_read_type(r, &numbers));
    sfi_vtk_begin_data(r);
    if (count > r->vtk->points_max) {
        return too_many(r, r->vtk->points_max, "points; raise points_max");
    }
    for (uint32_t i = 0; i < count; i++) {
        double xyz[3] = {0, 0, 0};
        for (int axis = 0; axis < 3; axis++) {
            SF_TRY(sfi_vtk_number(&numbers, &xyz[axis]));
            if (!(fabs(xyz[axis]) <= DBL_MAX)) {
                return sfi_vtk_fault(r,
                                     "a point has a coordinate that is infinite or not a number; "
                                     "correct it or export the file again");
            }
        }
        SF_TRY(sfi_list_push(&r->cursor->allocator, &r->vtk->points, xyz));
    }
    return SF_OK;
}

static sf_status push_corner(sfi_vtk_reader *r, uint32_t point)
{
    if (r->vtk->corners.count >= r->vtk->corners_max) {
        return too_many(r, r->vtk->corners_max, "corners of cells; raise corners_max");
    }
    return sfi_list_push(&r->cursor->allocator, &r->vtk->corners, &point);
}

// Versions below 5: `count` rows, `size` numbers in all.
static sf_status read_rows(sfi_vtk_reader *r, uint32_t count, uint32_t size)
{
    const sf_allocator *allocator = &r->cursor->allocator;
    sfi_vtk_numbers numbers = sfi_vtk_integers(r);
    uint32_t start = 0, corners = 0, point = 0, left = size;
    SF_TRY(sfi_list_push(allocator, &r->vtk->starts, &start));
    for (uint32_t i = 0; i < count; i++) {
        SF_TRY(sfi_vtk_whole(&numbers, &corners));
        if (left == 0 || corners > left - 1) {
            return sfi_vtk_fault(
                r, "the cells have more corners than CELLS counts; correct that line");
        }
        left -= corners + 1;
        if (!r->binary) {
            SF_TRY(sfi_list_push(allocator, &r->vtk->lines, &r->cursor->line));
        }
        for (uint32_t j = 0; j < corners; j++) {
            SF_TRY(sfi_vtk_whole(&numbers, &point));
            SF_TRY(push_corner(r, point));
        }
        start = (uint32_t)r->vtk->corners.count;
        SF_TRY(sfi_list_push(allocator, &r->vtk->starts, &start));
    }
    return left == 0 ? SF_OK
                     : sfi_vtk_fault(
                           r, "the cells have fewer corners than CELLS counts; correct that line");
}

// From version 5 on: `count` places where corners begin or end, and `size` corners.
static sf_status read_offsets(sfi_vtk_reader *r, uint32_t count, uint32_t size)
{
    sfi_vtk_numbers numbers;
    uint32_t start = 0, last = 0, point = 0;
    SF_TRY(sfi_vtk_expect(r, "offsets"));
    SF_TRY(sfi_vtk_read_type(r, &numbers));
    sfi_vtk_begin_data(r);
    for (uint32_t i = 0; i < count; i++) {
        SF_TRY(sfi_vtk_whole(&numbers, &start));
        if (start < last || start > size || (i == 0 && start != 0)) {
            return sfi_vtk_fault(
                r, "the offsets of cells do not begin with 0, fall, or lead beyond the "
                   "corners; export the file again");
        }
        last = start;
        SF_TRY(sfi_list_push(&r->cursor->allocator, &r->vtk->starts, &start));
    }
    if (last != size) {
        return sfi_vtk_fault(
            r, "the last offset of cells is not the number of corners; export the file "
               "again");
    }
    SF_TRY(sfi_vtk_expect(r, "connectivity"));
    SF_TRY(sfi_vtk_read_type(r, &numbers));
    sfi_vtk_begin_data(r);
    for (uint32_t i = 0; i < size; i++) {
        SF_TRY(sfi_vtk_whole(&numbers, &point));
        SF_TRY(push_corner(r, point));
    }
    return SF_OK;
}

static sf_status read_cells(sfi_vtk_reader *r)
{
    uint32_t count, size;
    SF_TRY(sfi_vtk_read_count(r, &count));
    SF_TRY(sfi_vtk_read_count(r, &size));
    if (r->has_offsets) {
        return read_offsets(r, count, size);
    }
    sfi_vtk_begin_data(r);
    return read_rows(r, count, size);
}

static sf_status read_types(sfi_vtk_reader *r)
{
    uint32_t count, type = 0;
    SF_TRY(sfi_vtk_read_count(r, &count));
    sfi_vtk_begin_data(r);
    sfi_vtk_numbers numbers = sfi_vtk_integers(r);
    for (uint32_t i = 0; i < count; i++) {
        SF_TRY(sfi_vtk_whole(&numbers, &type));
        SF_TRY(sfi_list_push(&r->cursor->allocator, &r->vtk->types, &type));
    }
    return SF_OK;
}

// --- the file ------------------------------------------------------------------------------------

static sf_status once(const sfi_vtk_reader *r, int *has)
{
    if (*has) {
        return sfi_vtk_fault(r,
                             "points, cells or types of cells are there twice; correct the file");
    }
    *has = 1;
    return SF_OK;
}

static sf_status begin_rows(sfi_vtk_reader *r, sfi_vtk_home home)
{
    r->home = home;
    return sfi_vtk_read_count(r, &r->rows);
}

static sf_status read_section(sfi_vtk_reader *r, const char *word)
{
    if (strcmp(word, "points") == 0) {
        SF_TRY(once(r, &r->has_points));
        return read_points(r);
    }
    if (strcmp(word, "cells") == 0) {
        SF_TRY(once(r, &r->has_cells));
        return read_cells(r);
    }
    if (strcmp(word, "cell_types") == 0) {
        SF_TRY(once(r, &r->has_types));
        return read_types(r);
    }
    if (strcmp(word, "point_data") == 0 || strcmp(word, "cell_data") == 0) {
        return begin_rows(r, word[0] == 'p' ? SFI_VTK_POINTS : SFI_VTK_CELLS);
    }
    if (strcmp(word, "field") == 0) {
        return sfi_vtk_read_field(r);
    }
    if (strcmp(word, "metadata") == 0) {
        sfi_vtk_pass_over(r);
        return SF_OK;
    }
    return sfi_vtk_read_data(r, word);
}

// "# vtk DataFile Version x.y", a title, the kind of numbers, the kind of dataset.
static sf_status read_head(sfi_vtk_reader *r)
{
    char token[SFI_TOKEN_SIZE];
    SF_TRY(sfi_vtk_expect(r, "#"));
    SF_TRY(sfi_vtk_expect(r, "vtk"));
    SF_TRY(sfi_vtk_expect(r, "datafile"));
    SF_TRY(sfi_vtk_expect(r, "version"));
    sfi_vtk_word(r, token, 0);
    if (token[0] < '1' || token[0] > '5' || token[1] != '.') {
        return sfi_cursor_fault_token(r->cursor, r->fault, "a version from 1.0 to 5.1", token);
    }
    r->has_offsets = token[0] >= '5';
    sfi_cursor_skip_line(r->cursor);
    sfi_cursor_skip_line(r->cursor);
    sfi_vtk_word(r, token, 1);
    r->binary = strcmp(token, "binary") == 0;
    if (!r->binary && strcmp(token, "ascii") != 0) {
        return sfi_cursor_fault_token(r->cursor, r->fault, "the word ASCII or BINARY", token);
    }
    SF_TRY(sfi_vtk_expect(r, "dataset"));
    if (sfi_vtk_word(r, token, 0) > 0 && strcmp(token, "unstructured_grid") != 0) {
        return sfi_vtk_unsupported(
            r, "this is another kind of VTK file than an unstructured grid; convert "
               "it to one");
    }
    return token[0] != '\0' ? SF_OK : sfi_vtk_fault(r, "the file does not say what DATASET it is");
}

static sf_status check_counts(const sfi_vtk_reader *r)
{
    const sfi_vtk *vtk = r->vtk;
    size_t cells = vtk->starts.count > 0 ? vtk->starts.count - 1 : 0;
    if (!r->has_points || !r->has_cells || !r->has_types) {
        return sfi_vtk_fault(
            r, "the file ends before POINTS, CELLS and CELL_TYPES are there; it is cut "
               "short");
    }
    if (vtk->types.count != cells) {
        return sfi_fault_set(r->fault, SF_ERR_FORMAT, r->cursor->line, sfi_cursor_offset(r->cursor),
                             "the file has %zu cells and %zu types of cells; export it again",
                             cells, vtk->types.count);
    }
    return SF_OK;
}

sf_status sfi_vtk_read(sfi_vtk *vtk, sfi_cursor *cursor, sf_fault *fault)
{
    sfi_vtk_reader r = {vtk, cursor, fault, 0, 0, 0, 0, 0, SFI_VTK_FIELD, 0};
    char token[SFI_TOKEN_SIZE];
    SF_TRY(read_head(&r));
    while (sfi_vtk_word(&r, token, 1) > 0) {
        SF_TRY(read_section(&r, token));
    }
    if (cursor->failure != SF_OK) {
        return sfi_cursor_fault(cursor, fault, "");
    }
    return check_counts(&r);
}
