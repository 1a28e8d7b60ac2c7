// SPDX-License-Identifier: MIT
// The words of a legacy VTK file: what stands between its numbers.

#include "io/vtk_reader.h"

#include "base/status.h"
#include "io/number.h"

sf_status sfi_vtk_fault(const sfi_vtk_reader *r, const char *sentence)
{
    return sfi_cursor_fault(r->cursor, r->fault, sentence);
}

sf_status sfi_vtk_unsupported(const sfi_vtk_reader *r, const char *sentence)
{
    if (r->cursor->failure != SF_OK) {
        return sfi_cursor_fault(r->cursor, r->fault, "");
    }
    return sfi_fault_set(r->fault, SF_ERR_UNSUPPORTED, r->cursor->line,
                         sfi_cursor_offset(r->cursor), "%s", sentence);
}

size_t sfi_vtk_word(sfi_vtk_reader *r, char token[SFI_TOKEN_SIZE], int lines)
{
    size_t length = sfi_cursor_token(r->cursor, token, lines);
    for (size_t i = 0; i < length; i++) {
        token[i] = (char)(token[i] >= 'A' && token[i] <= 'Z' ? token[i] - 'A' + 'a' : token[i]);
    }
    return length;
}

sf_status sfi_vtk_expect(sfi_vtk_reader *r, const char *word)
{
    char token[SFI_TOKEN_SIZE];
    sfi_vtk_word(r, token, 1);
    return strcmp(token, word) == 0 ? SF_OK
                                    : sfi_cursor_fault_token(r->cursor, r->fault, word, token);
}

sf_status sfi_vtk_parse_count(sfi_vtk_reader *r, const char *token, uint32_t *count)
{
    int64_t value;
    if (!sfi_integer_parse(token, &value) || value < 0 || value >= UINT32_MAX) {
        return sfi_cursor_fault_token(r->cursor, r->fault, "a count", token);
    }
    *count = (uint32_t)value;
    return SF_OK;
}

sf_status sfi_vtk_read_count(sfi_vtk_reader *r, uint32_t *count)
{
    char token[SFI_TOKEN_SIZE];
    sfi_cursor_token(r->cursor, token, 0);
    return sfi_vtk_parse_count(r, token, count);
}

static int hexadecimal(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

// A name: VTK writes blanks and other odd bytes as % and two digits.
sf_status sfi_vtk_read_name(sfi_vtk_reader *r, char name[SFI_TOKEN_SIZE], int lines)
{
    char token[SFI_TOKEN_SIZE];
    size_t length = sfi_cursor_token(r->cursor, token, lines), n = 0;
    if (length == 0) {
        return sfi_cursor_fault_token(r->cursor, r->fault, "a name", token);
    }
    for (size_t i = 0; i < length; i++) {
        int high = i + 2 < length && token[i] == '%' ? hexadecimal(token[i + 1]) : -1;
        int low = high >= 0 ? hexadecimal(token[i + 2]) : -1;
        int is_code = low >= 0 && high + low > 0;
        name[n++] = is_code ? (char)(16 * high + low) : token[i];
        i += is_code ? 2 : 0;
    }
    name[n] = '\0';
    return SF_OK;
}

// Numbers of a type that stands next on the line. In binary they begin behind the line's end.
sf_status sfi_vtk_read_type(sfi_vtk_reader *r, sfi_vtk_numbers *numbers)
{
    char token[SFI_TOKEN_SIZE];
    sfi_vtk_word(r, token, 0);
    const sfi_vtk_type *type = sfi_vtk_type_named(token);
    if (strcmp(token, "string") == 0 || strcmp(token, "variant") == 0) {
        return sfi_vtk_unsupported(r, "the file has data that are texts; remove them");
    }
    if (type == NULL) {
        return sfi_cursor_fault_token(r->cursor, r->fault, "a type of numbers that VTK has", token);
    }
    sfi_vtk_numbers made = {r->cursor, r->fault, type, r->binary, 0, 0};
    *numbers = made;
    return SF_OK;
}

void sfi_vtk_begin_data(sfi_vtk_reader *r)
{
    if (r->binary) {
        sfi_cursor_skip_line(r->cursor);
    }
}

sfi_vtk_numbers sfi_vtk_integers(const sfi_vtk_reader *r)
{
    sfi_vtk_numbers numbers = {r->cursor, r->fault, sfi_vtk_type_named("int"), r->binary, 0, 0};
    return numbers;
}
