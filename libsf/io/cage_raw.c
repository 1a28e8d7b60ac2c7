// SPDX-License-Identifier: MIT
// Filling a raw cage: tokens, points, elements, all of them checked as far as one can alone.

#include "io/cage_raw.h"

#include "base/status.h"
#include "io/number.h"

#include <float.h>
#include <math.h>
#include <string.h>

void sfi_raw_begin(sfi_raw *raw, sfi_cursor *cursor, const sf_cage_read_options *options,
                   sf_fault *fault)
{
    memset(raw, 0, sizeof *raw);
    raw->cursor = cursor;
    raw->options = *options;
    raw->fault = fault;
    raw->positions = sfi_list_of(3 * sizeof(double));
    raw->corners = sfi_list_of(sizeof(uint32_t));
    raw->cells = sfi_list_of(sizeof(sfi_raw_cell));
    raw->creases = raw->sharps = sfi_list_of(sizeof(sfi_raw_mark));
    raw->arrays = sfi_list_of(sizeof(sfi_raw_array));
}

void sfi_raw_end(sfi_raw *raw)
{
    const sf_allocator *allocator = &raw->cursor->allocator;
    sfi_list_free(allocator, &raw->positions);
    sfi_list_free(allocator, &raw->corners);
    sfi_list_free(allocator, &raw->cells);
    sfi_list_free(allocator, &raw->creases);
    sfi_list_free(allocator, &raw->sharps);
    sfi_list_free(allocator, &raw->arrays);
}

sf_status sfi_raw_push(sfi_raw *raw, sfi_list *list, const void *item)
{
    return sfi_list_push(&raw->cursor->allocator, list, item);
}

static sf_status too_many(const sfi_raw *raw, size_t most, const char *what)
{
    return sfi_fault_set(raw->fault, SF_ERR_OVERFLOW, raw->cursor->line,
                         sfi_cursor_offset(raw->cursor), "the file has more than %zu %s", most,
                         what);
}

sf_status sfi_raw_point(sfi_raw *raw, const double xyz[3])
{
    if (!(fabs(xyz[0]) <= DBL_MAX && fabs(xyz[1]) <= DBL_MAX && fabs(xyz[2]) <= DBL_MAX)) {
        return sfi_cursor_fault(raw->cursor, raw->fault,
                                "a point has a coordinate that is infinite or not a number; "
                                "correct it or export the file again");
    }
    if (raw->positions.count >= raw->options.points_max) {
        return too_many(raw, raw->options.points_max, "points; raise points_max");
    }
    return sfi_raw_push(raw, &raw->positions, xyz);
}

sf_status sfi_raw_cell_begin(sfi_raw *raw, uint32_t dimension)
{
    if (raw->cells.count >= SF_CAGE_POINT_MAX) {
        return too_many(raw, SF_CAGE_POINT_MAX, "elements");
    }
    sfi_raw_cell cell = {0, (uint32_t)raw->corners.count, 0, raw->cursor->line, dimension};
    return sfi_raw_push(raw, &raw->cells, &cell);
}

sf_status sfi_raw_corner(sfi_raw *raw, uint32_t point)
{
    if (raw->corners.count >= raw->options.corners_max) {
        return too_many(raw, raw->options.corners_max, "corners of cells; raise corners_max");
    }
    SF_TRY(sfi_raw_push(raw, &raw->corners, &point));
    sfi_raw_last_cell(raw)->count++;
    return SF_OK;
}

sf_status sfi_raw_mark_sharp(sfi_raw *raw, sfi_list *list, uint32_t a, uint32_t b)
{
    sfi_raw_mark mark = {SF_SHARP, {a, b}, raw->cursor->line};
    if (list->count >= SF_CAGE_POINT_MAX) {
        return too_many(raw, SF_CAGE_POINT_MAX, "creases or sharp points");
    }
    return sfi_raw_push(raw, list, &mark);
}

size_t sfi_raw_word(sfi_raw *raw, char token[SFI_TOKEN_SIZE])
{
    size_t length = sfi_cursor_token(raw->cursor, token, 1);
    while (length > 0 && token[0] == '#') {
        sfi_cursor_skip_line(raw->cursor);
        length = sfi_cursor_token(raw->cursor, token, 1);
    }
    return length;
}

sf_status sfi_raw_number(sfi_raw *raw, const char *expected, double *value)
{
    char token[SFI_TOKEN_SIZE];
    sfi_raw_word(raw, token);
    if (!sfi_number_parse(token, value)) {
        return sfi_cursor_fault_token(raw->cursor, raw->fault, expected, token);
    }
    return SF_OK;
}

sf_status sfi_raw_whole(sfi_raw *raw, const char *expected, uint32_t most, uint32_t *value)
{
    char token[SFI_TOKEN_SIZE];
    int64_t whole;
    sfi_raw_word(raw, token);
    if (!sfi_integer_parse(token, &whole) || whole < 0 || whole > (int64_t)most) {
        return sfi_cursor_fault_token(raw->cursor, raw->fault, expected, token);
    }
    *value = (uint32_t)whole;
    return SF_OK;
}

sf_status sfi_raw_unsupported(sfi_raw *raw, const char *sentence)
{
    if (raw->cursor->failure != SF_OK) {
        return sfi_cursor_fault(raw->cursor, raw->fault, "");
    }
    return sfi_fault_set(raw->fault, SF_ERR_UNSUPPORTED, raw->cursor->line,
                         sfi_cursor_offset(raw->cursor), "%s", sentence);
}

sf_status sfi_raw_property(sfi_raw *raw, const char *name, sf_property *property)
{
    if (sf_property_named(name, property) != SF_OK) {
        return sfi_cursor_fault(raw->cursor, raw->fault,
                                "the name of some data is empty or longer than 47 bytes; give them "
                                "a shorter one");
    }
    return SF_OK;
}
