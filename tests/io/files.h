// SPDX-License-Identifier: MIT
// Small mesh files made in memory, in every format and order of bytes, and reading them under an
// allocator that counts. The procedural twins of what stands in shared/data.

#ifndef SF_TEST_FILES_H
#define SF_TEST_FILES_H

#include <sf/io.h>

#include "failing_allocator.h"
#include "test.h"

#include <stdarg.h>

typedef struct file {
    unsigned char bytes[16384];
    size_t size;
} file;

static inline void put(file *f, const void *data, size_t size)
{
    if (f->size + size <= sizeof f->bytes) {
        memcpy(f->bytes + f->size, data, size);
        f->size += size;
    }
}

static inline void put_text(file *f, const char *format, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    put(f, text, (size_t)length);
}

// The low `size` bytes of a value, lowest first or (big) last.
static inline void put_bits(file *f, uint64_t bits, int size, int big)
{
    for (int i = 0; i < size; i++) {
        unsigned char byte = (unsigned char)(bits >> 8 * (big ? size - 1 - i : i));
        put(f, &byte, 1);
    }
}

static inline void put_float(file *f, double value, int big)
{
    float single = (float)value;
    uint32_t bits;
    memcpy(&bits, &single, sizeof bits);
    put_bits(f, bits, 4, big);
}

static inline void put_double(file *f, double value, int big)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_bits(f, bits, 8, big);
}

// The unit cube: eight corners, six quads, counter-clockwise seen from outside.
static const double cube_vertex[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                         {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
static const int cube_face[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                    {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

static inline const double *cube_corner(int triangle, int corner)
{
    return cube_vertex[cube_face[triangle / 2][corner == 0 ? 0 : triangle % 2 + corner]];
}

static inline void make_text_stl(file *f, const char *end_of_line)
{
    f->size = 0;
    put_text(f, "solid cube of vertex and facet%s", end_of_line);
    for (int t = 0; t < 12; t++) {
        put_text(f, "  facet normal 0 0 0%s    outer loop%s", end_of_line, end_of_line);
        for (int c = 0; c < 3; c++) {
            const double *p = cube_corner(t, c);
            put_text(f, "      vertex %e %g %.3f%s", p[0], p[1], p[2], end_of_line);
        }
        put_text(f, "    endloop%s  endfacet%s", end_of_line, end_of_line);
    }
    put_text(f, "endsolid cube%s", end_of_line);
}

// A header of 80 bytes that begins with `head`, a count that may lie, and twelve facets.
static inline void make_binary_stl(file *f, const char *head, uint32_t count)
{
    char header[80] = {0};
    f->size = 0;
    memcpy(header, head, strlen(head));
    put(f, header, sizeof header);
    put_bits(f, count, 4, 0);
    for (int t = 0; t < 12; t++) {
        for (int k = 0; k < 3; k++) {
            put_float(f, 0.0, 0);
        }
        for (int k = 0; k < 9; k++) {
            put_float(f, cube_corner(t, k / 3)[k % 3], 0);
        }
        put_bits(f, 0, 2, 0);
    }
}

static inline void make_obj(file *f)
{
    f->size = 0;
    put_text(f, "# a cube\nmtllib none.mtl\no cube\n");
    for (int i = 0; i < 8; i++) {
        put_text(f, "v %g %g %g\n", cube_vertex[i][0], cube_vertex[i][1], cube_vertex[i][2]);
    }
    put_text(f, "vt 0 0\nvn 0 0 1\ng sides\ns off\n");
    static const char *const form[6] = {"f %d %d %d %d\n",
                                        "f %d/1 %d/1 %d/1 %d/1\n",
                                        "f %d//1 %d//1 %d//1 %d//1\n",
                                        "f %d/1/1 %d/1/1 %d/1/1 %d/1/1 \r\n",
                                        "f %d %d \\\n %d %d # quad\n",
                                        "f\t%d %d\\\n %d %d\n"};
    for (int i = 0; i < 6; i++) {
        const int *q = cube_face[i];
        int back = i == 2 || i == 4 ? -9 : 0; // counted from the last vertex
        put_text(f, form[i], q[0] + 1 + back, q[1] + 1 + back, q[2] + 1 + back, q[3] + 1 + back);
    }
}

static inline void make_off(file *f, const char *word)
{
    f->size = 0;
    put_text(f, "%s # cube\n\n8 6 12\n", word);
    for (int i = 0; i < 8; i++) {
        put_text(f, "%g %g %g%s\n", cube_vertex[i][0], cube_vertex[i][1], cube_vertex[i][2],
                 word[0] == 'O' ? "" : " 255 0 0 255");
    }
    put_text(f, "# faces\n");
    for (int i = 0; i < 6; i++) {
        const int *q = cube_face[i];
        put_text(f, "4 %d %d %d %d 0.5 0.5 0.5\n", q[0], q[1], q[2], q[3]);
    }
}

typedef struct ply_kind {
    const char *order;   // as in the header
    int big, text, wide; // wide: doubles
    const char *count_type, *index_type;
    int count_size, index_size;
} ply_kind;

static inline void put_ply(file *f, const ply_kind *kind, double value, int size, int real)
{
    if (kind->text) {
        put_text(f, "%g ", value);
    } else if (real && size == 8) {
        put_double(f, value, kind->big);
    } else if (real) {
        put_float(f, value, kind->big);
    } else {
        put_bits(f, (uint64_t)(int64_t)value, size, kind->big);
    }
}

// With elements, properties and lists that nobody knows before, between and after what counts.
static inline void make_ply(file *f, const ply_kind *kind)
{
    const char *real = kind->wide ? "double" : "float";
    int real_size = kind->wide ? 8 : 4;
    f->size = 0;
    put_text(f, "ply\nformat %s 1.0\ncomment element vertex 7\nobj_info nothing\n", kind->order);
    put_text(f, "element camera 1\nproperty short a\nproperty list uchar float b\n");
    put_text(f, "element vertex 8\nproperty uchar red\nproperty %s x\nproperty %s y\n", real, real);
    put_text(f, "property list int8 int16 more\nproperty %s z\nproperty float quality\n", real);
    put_text(f, "element face 6\nproperty float x\nproperty list %s %s vertex_indices\n",
             kind->count_type, kind->index_type);
    put_text(f,
             "property list uint16 double texcoord\nelement edge 1\nproperty int8 e\nend_header\n");
    put_ply(f, kind, -3, 2, 0);
    put_ply(f, kind, 2, 1, 0);
    put_ply(f, kind, 0.5, 4, 1);
    put_ply(f, kind, 0.25, 4, 1);
    for (int i = 0; i < 8; i++) {
        put_ply(f, kind, 200, 1, 0);
        put_ply(f, kind, cube_vertex[i][0], real_size, 1);
        put_ply(f, kind, cube_vertex[i][1], real_size, 1);
        put_ply(f, kind, i % 3, 1, 0);
        for (int k = 0; k < i % 3; k++) {
            put_ply(f, kind, -7, 2, 0);
        }
        put_ply(f, kind, cube_vertex[i][2], real_size, 1);
        put_ply(f, kind, 1.5, 4, 1);
    }
    for (int i = 0; i < 6; i++) {
        put_ply(f, kind, 9.0, 4, 1);
        put_ply(f, kind, 4, kind->count_size, 0);
        for (int c = 0; c < 4; c++) {
            put_ply(f, kind, cube_face[i][c], kind->index_size, 0);
        }
        put_ply(f, kind, 1, 2, 0);
        put_ply(f, kind, 0.125, 8, 1);
    }
    put_ply(f, kind, -1, 1, 0);
}

static const ply_kind ply_kinds[] = {
    {"ascii", 0, 1, 0, "uchar", "int", 1, 4},
    {"binary_little_endian", 0, 0, 0, "uchar", "int", 1, 4},
    {"binary_big_endian", 1, 0, 0, "uint8", "int32", 1, 4},
    {"binary_little_endian", 0, 0, 1, "char", "char", 1, 1},
    {"binary_big_endian", 1, 0, 1, "ushort", "uint8", 2, 1},
    {"binary_little_endian", 0, 0, 0, "short", "ushort", 2, 2},
    {"binary_big_endian", 1, 0, 0, "int", "int16", 4, 2},
    {"binary_big_endian", 1, 0, 1, "uint32", "uint", 4, 4},
};
#define PLY_KINDS (sizeof ply_kinds / sizeof ply_kinds[0])

// Every small valid file there is, by number; 0 when there are no more. What it is, for messages.
static inline const char *make_any(file *f, size_t number)
{
    if (number < PLY_KINDS) {
        make_ply(f, &ply_kinds[number]);
        return "PLY";
    }
    switch (number - PLY_KINDS) {
    case 0:
        make_text_stl(f, "\n");
        return "text STL";
    case 1:
        make_text_stl(f, "\r\n");
        return "text STL, CRLF";
    case 2:
        make_binary_stl(f, "made by hand", 12);
        return "binary STL";
    case 3:
        make_binary_stl(f, "solid facet of lies", 12);
        return "binary STL that begins like text";
    case 4:
        make_obj(f);
        return "OBJ";
    case 5:
        make_off(f, "OFF");
        return "OFF";
    case 6:
        make_off(f, "COFF");
        return "COFF";
    case 7:
        make_binary_stl(f, "streamed", 0);
        return "binary STL without a count";
    case 9:
        make_text_stl(f, "\r");
        return "text STL, CR";
    case 8:
        make_binary_stl(f, "streamed", UINT32_MAX);
        return "binary STL with all ones for a count";
    default:
        return NULL;
    }
}

// Read from memory in one go.
static inline sf_status read_bytes(const void *data, size_t size, sf_mesh_format format,
                                   const sf_read_limits *limits, const sf_allocator *allocator,
                                   sf_mesh **mesh, sf_fault *fault)
{
    sf_memory_cursor cursor = {data, size, 0};
    return sf_mesh_read(sf_memory_source(&cursor), format, limits, allocator, mesh, fault);
}

// Whether a refusal says something: its own status, a sentence that ends, and no mesh.
static inline int refused_well(sf_status status, const sf_fault *fault, const sf_mesh *mesh)
{
    size_t length = strlen(fault->message);
    return status != SF_OK && fault->status == status && mesh == NULL && length > 20 &&
           length < SF_FAULT_MESSAGE_SIZE - 1;
}

// A source that hands out one byte at a time, of a cursor.
static inline sf_status read_one_byte(void *user, void *data, size_t capacity, size_t *size)
{
    sf_memory_cursor *cursor = user;
    *size = capacity > 0 && cursor->position < cursor->size;
    if (*size > 0) {
        memcpy(data, (const unsigned char *)cursor->data + cursor->position++, 1);
    }
    return SF_OK;
}

#endif
