// SPDX-License-Identifier: MIT
// PLY in: text, little-endian and big-endian, after G. Turk, "The PLY Polygon File Format", 1994.
//
// The header is a small program that says how to read the rest: elements, each with a count and a
// list of properties, each a number or a list of numbers. Every element is read by that program;
// what is neither a coordinate of a vertex nor the corner list of a face is read and dropped.
// Values pass through double, which holds every type of the format exactly.
//
// No count is trusted. An element that has no properties takes no bytes, so its rows are not even
// counted: otherwise twenty bytes of header could ask for 2^60 turns of a loop.

#include "io/readers.h"

#include "base/memory.h"
#include "base/status.h"
#include "io/number.h"

#include <string.h>

#define ELEMENTS_MAX 32
#define PROPERTIES_MAX 256

typedef enum ply_type {
    TYPE_NONE,
    INT8,
    UINT8,
    INT16,
    UINT16,
    INT32,
    UINT32,
    FLOAT32,
    FLOAT64
} ply_type;

static const struct {
    const char *name;
    ply_type type;
} type_names[] = {
    {"char", INT8},     {"int8", INT8},       {"uchar", UINT8},    {"uint8", UINT8},
    {"short", INT16},   {"int16", INT16},     {"ushort", UINT16},  {"uint16", UINT16},
    {"int", INT32},     {"int32", INT32},     {"uint", UINT32},    {"uint32", UINT32},
    {"float", FLOAT32}, {"float32", FLOAT32}, {"double", FLOAT64}, {"float64", FLOAT64},
};

static const unsigned char type_size[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};

typedef enum ply_role {
    ROLE_NONE = -1,
    ROLE_X = 0,
    ROLE_Y = 1,
    ROLE_Z = 2,
    ROLE_CORNERS = 3
} ply_role;

typedef struct ply_property {
    ply_type count_type; // of a list; TYPE_NONE for a number
    ply_type type;
    ply_role role;
} ply_property;

typedef struct ply_element {
    int64_t rows;
    size_t first, count; // its properties
    int is_vertex, is_face;
} ply_element;

typedef enum ply_order { ORDER_NONE, TEXT, LITTLE, BIG } ply_order;

typedef struct ply_reader {
    sfi_mesh_reader *mesh;
    ply_order order;
    size_t element_count, property_count;
    ply_element elements[ELEMENTS_MAX];
    ply_property properties[PROPERTIES_MAX];
} ply_reader;

static sf_status fault(const ply_reader *ply, const char *sentence)
{
    return sfi_cursor_fault(ply->mesh->cursor, ply->mesh->fault, sentence);
}

// --- the header ----------------------------------------------------------------------------------

static sf_status read_type(ply_reader *ply, const char *token, ply_type *type)
{
    for (size_t i = 0; i < sizeof type_names / sizeof type_names[0]; i++) {
        if (strcmp(token, type_names[i].name) == 0) {
            *type = type_names[i].type;
            return SF_OK;
        }
    }
    return sfi_cursor_fault_token(ply->mesh->cursor, ply->mesh->fault, "a PLY number type", token);
}

static sf_status read_format(ply_reader *ply)
{
    char token[SFI_TOKEN_SIZE];
    sfi_cursor_token(ply->mesh->cursor, token, 0);
    if (strcmp(token, "ascii") == 0) {
        ply->order = TEXT;
    } else if (strcmp(token, "binary_little_endian") == 0) {
        ply->order = LITTLE;
    } else if (strcmp(token, "binary_big_endian") == 0) {
        ply->order = BIG;
    } else {
        return sfi_cursor_fault_token(ply->mesh->cursor, ply->mesh->fault,
                                      "ascii, binary_little_endian or binary_big_endian", token);
    }
    return SF_OK;
}

static sf_status read_element(ply_reader *ply)
{
    char token[SFI_TOKEN_SIZE];
    if (ply->element_count == ELEMENTS_MAX) {
        return fault(ply, "the header names more than 32 elements; write a plainer file");
    }
    ply_element *element = &ply->elements[ply->element_count];
    sfi_cursor_token(ply->mesh->cursor, token, 0);
    element->first = ply->property_count;
    element->count = 0;
    element->is_vertex = strcmp(token, "vertex") == 0;
    element->is_face = strcmp(token, "face") == 0;
    sfi_cursor_token(ply->mesh->cursor, token, 0);
    if (!sfi_integer_parse(token, &element->rows) || element->rows < 0) {
        return sfi_cursor_fault_token(ply->mesh->cursor, ply->mesh->fault, "a number of elements",
                                      token);
    }
    ply->element_count++;
    return SF_OK;
}

static ply_role role_of(const ply_element *element, const char *name, int is_list)
{
    if (element->is_vertex && !is_list && name[0] >= 'x' && name[0] <= 'z' && name[1] == '\0') {
        return (ply_role)(name[0] - 'x');
    }
    if (element->is_face && is_list &&
        (strcmp(name, "vertex_indices") == 0 || strcmp(name, "vertex_index") == 0)) {
        return ROLE_CORNERS;
    }
    return ROLE_NONE;
}

static int has_role(const ply_reader *ply, const ply_element *element, ply_role role)
{
    int found = 0;
    for (size_t i = 0; i < element->count; i++) {
        found += ply->properties[element->first + i].role == role;
    }
    return found == 1;
}

static sf_status read_property(ply_reader *ply)
{
    char token[SFI_TOKEN_SIZE];
    if (ply->element_count == 0) {
        return fault(ply, "the header names a property before any element; correct it");
    }
    if (ply->property_count == PROPERTIES_MAX) {
        return fault(ply, "the header names more than 256 properties; write a plainer file");
    }
    ply_property property = {TYPE_NONE, TYPE_NONE, ROLE_NONE};
    sfi_cursor_token(ply->mesh->cursor, token, 0);
    int is_list = strcmp(token, "list") == 0;
    if (is_list) {
        sfi_cursor_token(ply->mesh->cursor, token, 0);
        SF_TRY(read_type(ply, token, &property.count_type));
        if (property.count_type >= FLOAT32) {
            return fault(ply, "the length of a list is declared as no integer; correct the header");
        }
        sfi_cursor_token(ply->mesh->cursor, token, 0);
    }
    SF_TRY(read_type(ply, token, &property.type));
    if (sfi_cursor_token(ply->mesh->cursor, token, 0) == 0) {
        return fault(ply, "the header has a property without a name; correct it");
    }
    ply_element *element = &ply->elements[ply->element_count - 1];
    property.role = role_of(element, token, is_list);
    if (property.role == ROLE_CORNERS && has_role(ply, element, ROLE_CORNERS)) {
        property.role = ROLE_NONE; // a file that lists corners twice: the first list counts
    }
    if (property.role == ROLE_CORNERS && property.type >= FLOAT32) {
        return fault(ply, "the corners of faces are declared as no integers; correct the header");
    }
    ply->properties[ply->property_count++] = property;
    element->count++;
    return SF_OK;
}

static sf_status check_header(const ply_reader *ply)
{
    if (ply->order == ORDER_NONE) {
        return fault(ply, "the header has no format line; correct it");
    }
    int vertices = 0;
    for (size_t i = 0; i < ply->element_count; i++) {
        const ply_element *element = &ply->elements[i];
        vertices += element->is_vertex;
        if (element->is_vertex &&
            !(has_role(ply, element, ROLE_X) && has_role(ply, element, ROLE_Y) &&
              has_role(ply, element, ROLE_Z))) {
            return fault(ply,
                         "the header does not give vertices one x, one y and one z; correct it");
        }
    }
    if (vertices != 1) {
        return fault(ply, "the header does not name the element vertex once; correct it");
    }
    return SF_OK;
}

static sf_status read_header(ply_reader *ply)
{
    char token[SFI_TOKEN_SIZE];
    sfi_cursor *cursor = ply->mesh->cursor;
    sfi_cursor_token(cursor, token, 0);
    if (strcmp(token, "ply") != 0) {
        return sfi_cursor_fault_token(cursor, ply->mesh->fault, "the word ply", token);
    }
    for (;;) {
        sfi_cursor_skip_line(cursor);
        sf_status status = SF_OK;
        if (sfi_cursor_token(cursor, token, 1) == 0) {
            return fault(ply, "the file ends within its header; it is cut short");
        }
        if (strcmp(token, "end_header") == 0) {
            sfi_cursor_skip_line(cursor);
            return check_header(ply);
        }
        if (strcmp(token, "format") == 0) {
            status = read_format(ply);
        } else if (strcmp(token, "element") == 0) {
            status = read_element(ply);
        } else if (strcmp(token, "property") == 0) {
            status = read_property(ply);
        } else if (strcmp(token, "comment") != 0 && strcmp(token, "obj_info") != 0) {
            status =
                sfi_cursor_fault_token(cursor, ply->mesh->fault,
                                       "format, element, property, comment or end_header", token);
        }
        SF_TRY(status);
    }
}

// --- the data ------------------------------------------------------------------------------------

static double decode(ply_type type, uint64_t bits)
{
    float single;
    double value;
    uint32_t low = (uint32_t)bits;
    switch (type) {
    case INT8:
        return (double)bits - (bits & 0x80 ? 256.0 : 0.0);
    case INT16:
        return (double)bits - (bits & 0x8000 ? 65536.0 : 0.0);
    case INT32:
        return (double)bits - (bits & 0x80000000u ? 4294967296.0 : 0.0);
    case FLOAT32:
        memcpy(&single, &low, sizeof single);
        return (double)single;
    case FLOAT64:
        memcpy(&value, &bits, sizeof value);
        return value;
    default:
        return (double)bits;
    }
}

static sf_status read_value(ply_reader *ply, ply_type type, double *value)
{
    if (ply->order == TEXT) {
        return sfi_reader_number(ply->mesh, value, 1);
    }
    unsigned char bytes[8];
    size_t size = type_size[type];
    if (sfi_cursor_read(ply->mesh->cursor, bytes, size) < size) {
        return fault(ply,
                     "the file ends before all elements that its header names; it is cut short");
    }
    uint64_t bits = 0;
    for (size_t i = 0; i < size; i++) {
        bits = bits << 8 | bytes[ply->order == BIG ? i : size - 1 - i];
    }
    *value = decode(type, bits);
    return SF_OK;
}

// A value that counts or numbers something: whole, not negative, within 32 bits.
static sf_status read_whole(ply_reader *ply, ply_type type, uint32_t *whole)
{
    double value;
    SF_TRY(read_value(ply, type, &value));
    if (!(value >= 0.0 && value <= (double)UINT32_MAX) || value != (double)(uint32_t)value) {
        return fault(ply, "a list length or a vertex number is negative or not whole; export the "
                          "file again");
    }
    *whole = (uint32_t)value;
    return SF_OK;
}

// A list; corners are kept for the face, other lists are read and dropped.
static sf_status read_list(ply_reader *ply, const ply_property *property)
{
    double dropped;
    uint32_t length = 0;
    SF_TRY(read_whole(ply, property->count_type, &length));
    for (uint32_t i = 0; i < length; i++) {
        if (property->role != ROLE_CORNERS) {
            SF_TRY(read_value(ply, property->type, &dropped));
            continue;
        }
        uint32_t corner = 0;
        SF_TRY(read_whole(ply, property->type, &corner));
        SF_TRY(sfi_reader_corner(ply->mesh, corner));
    }
    return SF_OK;
}

static sf_status read_row(ply_reader *ply, const ply_element *element)
{
    double xyz[3] = {0.0, 0.0, 0.0}, dropped;
    int has_corners = 0;
    for (size_t i = 0; i < element->count; i++) {
        const ply_property *property = &ply->properties[element->first + i];
        if (property->count_type != TYPE_NONE) {
            has_corners |= property->role == ROLE_CORNERS;
            SF_TRY(read_list(ply, property));
        } else {
            SF_TRY(read_value(ply, property->type,
                              property->role == ROLE_NONE ? &dropped : &xyz[property->role]));
        }
    }
    if (element->is_vertex) {
        return sfi_reader_vertex(ply->mesh, xyz);
    }
    return has_corners ? sfi_reader_polygon(ply->mesh) : SF_OK;
}

static sf_status read_elements(ply_reader *ply)
{
    for (size_t i = 0; i < ply->element_count; i++) {
        const ply_element *element = &ply->elements[i];
        for (int64_t row = 0; element->count > 0 && row < element->rows; row++) {
            SF_TRY(read_row(ply, element));
        }
    }
    return SF_OK;
}

sf_status sfi_ply_read(sfi_mesh_reader *reader)
{
    const sf_allocator *allocator = &reader->cursor->allocator;
    ply_reader *ply = sfi_alloc_array(allocator, 1, sizeof *ply);
    if (ply == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(ply, 0, sizeof *ply);
    ply->mesh = reader;
    sf_status status = read_header(ply);
    if (status == SF_OK) {
        status = read_elements(ply);
    }
    sfi_free_array(allocator, ply, 1, sizeof *ply);
    return status;
}
