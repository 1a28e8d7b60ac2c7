// SPDX-License-Identifier: MIT
// The data of a legacy VTK file.
//
// They stand in a dozen forms, each with a line of its own kind and as many numbers as that line
// and the count of points or cells ask for. All of them are read, because nothing but the counts
// says where one ends; kept are numbers, one for each point or cell, and the fields of the grid
// itself.

#include "io/vtk_reader.h"

#include "base/status.h"

#define ARRAYS_MAX 256

// `rows` rows of `components` numbers; kept under a name, or (NULL) dropped.
static sf_status read_array(sfi_vtk_reader *r, const char *name, uint32_t components, uint32_t rows,
                            sfi_vtk_numbers *numbers)
{
    const sf_allocator *allocator = &r->cursor->allocator;
    sfi_vtk_array *array = NULL;
    double value = 0;
    if (name != NULL && (components == 1 || r->home == SFI_VTK_FIELD)) {
        sfi_vtk_array made = {"", r->home, components, sfi_list_of(sizeof(double))};
        if (r->vtk->arrays.count == ARRAYS_MAX) {
            return sfi_vtk_unsupported(r, "the file has more than 256 sets of data; remove some");
        }
        memcpy(made.name, name, strlen(name) + 1);
        SF_TRY(sfi_list_push(allocator, &r->vtk->arrays, &made));
        array = (sfi_vtk_array *)r->vtk->arrays.items + r->vtk->arrays.count - 1;
    }
    // Rows of nothing take no bytes, so they are not even counted.
    for (uint64_t left = (uint64_t)components * rows; left > 0; left--) {
        SF_TRY(sfi_vtk_number(numbers, &value));
        if (array != NULL) {
            SF_TRY(sfi_list_push(allocator, &array->values, &value));
        }
    }
    return SF_OK;
}

// SCALARS name type [components], LOOKUP_TABLE name.
static sf_status read_scalars(sfi_vtk_reader *r)
{
    char name[SFI_TOKEN_SIZE], token[SFI_TOKEN_SIZE];
    sfi_vtk_numbers numbers;
    uint32_t components = 1;
    SF_TRY(sfi_vtk_read_name(r, name, 0));
    SF_TRY(sfi_vtk_read_type(r, &numbers));
    if (sfi_cursor_token(r->cursor, token, 0) > 0) {
        SF_TRY(sfi_vtk_parse_count(r, token, &components));
    }
    SF_TRY(sfi_vtk_expect(r, "lookup_table"));
    SF_TRY(sfi_vtk_read_name(r, token, 0));
    sfi_vtk_begin_data(r);
    return read_array(r, name, components, r->rows, &numbers);
}

// VECTORS name type, and others that say how many components they have by their names.
static sf_status read_fixed(sfi_vtk_reader *r, uint32_t components)
{
    char name[SFI_TOKEN_SIZE];
    sfi_vtk_numbers numbers;
    SF_TRY(sfi_vtk_read_name(r, name, 0));
    SF_TRY(sfi_vtk_read_type(r, &numbers));
    sfi_vtk_begin_data(r);
    return read_array(r, NULL, components, r->rows, &numbers);
}

// TEXTURE_COORDINATES name components type.
static sf_status read_texture(sfi_vtk_reader *r)
{
    char name[SFI_TOKEN_SIZE];
    sfi_vtk_numbers numbers;
    uint32_t components;
    SF_TRY(sfi_vtk_read_name(r, name, 0));
    SF_TRY(sfi_vtk_read_count(r, &components));
    SF_TRY(sfi_vtk_read_type(r, &numbers));
    sfi_vtk_begin_data(r);
    return read_array(r, NULL, components, r->rows, &numbers);
}

// COLOR_SCALARS name components, and LOOKUP_TABLE name rows, with four: bytes, or in text
// fractions.
static sf_status read_colours(sfi_vtk_reader *r, int is_table)
{
    char name[SFI_TOKEN_SIZE];
    uint32_t count;
    SF_TRY(sfi_vtk_read_name(r, name, 0));
    SF_TRY(sfi_vtk_read_count(r, &count));
    sfi_vtk_begin_data(r);
    sfi_vtk_numbers numbers = sfi_vtk_integers(r);
    numbers.type = sfi_vtk_type_named("unsigned_char");
    return read_array(r, NULL, is_table ? 4 : count, is_table ? count : r->rows, &numbers);
}

// METADATA, lines up to an empty one.
void sfi_vtk_pass_over(sfi_vtk_reader *r)
{
    char token[SFI_TOKEN_SIZE];
    do {
        sfi_cursor_skip_line(r->cursor);
    } while (sfi_cursor_token(r->cursor, token, 0) > 0);
}

// FIELD name arrays, and each array: name components rows type.
sf_status sfi_vtk_read_field(sfi_vtk_reader *r)
{
    char name[SFI_TOKEN_SIZE];
    uint32_t arrays, components, rows;
    sfi_vtk_numbers numbers;
    SF_TRY(sfi_vtk_read_name(r, name, 0));
    SF_TRY(sfi_vtk_read_count(r, &arrays));
    for (uint32_t i = 0; i < arrays; i++) {
        SF_TRY(sfi_vtk_read_name(r, name, 1));
        while (strcmp(name, "METADATA") == 0) {
            sfi_vtk_pass_over(r);
            SF_TRY(sfi_vtk_read_name(r, name, 1));
        }
        if (strcmp(name, "NULL_ARRAY") == 0) {
            continue;
        }
        SF_TRY(sfi_vtk_read_count(r, &components));
        SF_TRY(sfi_vtk_read_count(r, &rows));
        SF_TRY(sfi_vtk_read_type(r, &numbers));
        sfi_vtk_begin_data(r);
        SF_TRY(read_array(r, name, components, rows, &numbers));
    }
    return SF_OK;
}

sf_status sfi_vtk_read_data(sfi_vtk_reader *r, const char *word)
{
    static const struct {
        const char *word;
        uint32_t components;
    } fixed[] = {{"vectors", 3},    {"normals", 3},      {"tensors", 9},   {"tensors6", 6},
                 {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}};
    if (strcmp(word, "scalars") == 0) {
        return read_scalars(r);
    }
    if (strcmp(word, "texture_coordinates") == 0) {
        return read_texture(r);
    }
    if (strcmp(word, "color_scalars") == 0 || strcmp(word, "lookup_table") == 0) {
        return read_colours(r, word[0] == 'l');
    }
    for (size_t i = 0; i < sizeof fixed / sizeof fixed[0]; i++) {
        if (strcmp(word, fixed[i].word) == 0) {
            return read_fixed(r, fixed[i].components);
        }
    }
    return sfi_cursor_fault_token(r->cursor, r->fault, "a section of a VTK grid", word);
}
