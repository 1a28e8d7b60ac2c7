// SPDX-License-Identifier: MIT
// Zip archives made in memory: what stands in them is stored, so that a test can write any XML and
// change any byte. Parts of 3MF files that many tests begin with.

#ifndef SF_TEST_STORED_ZIP_H
#define SF_TEST_STORED_ZIP_H

#include <sf/threemf.h>

#include "failing_allocator.h"
#include "test.h"

#include <stdarg.h>

typedef struct archive {
    unsigned char bytes[65536];
    size_t size;
    unsigned char directory[8192];
    size_t directory_size;
    unsigned count;
} archive;

static inline uint32_t crc_of(const void *data, size_t size)
{
    const unsigned char *bytes = data;
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int k = 0; k < 8; k++) {
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
        }
    }
    return ~crc;
}

static inline size_t put_number(unsigned char *at, uint64_t value, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        at[i] = i < 8 ? (unsigned char)(value >> 8 * i) : 0;
    }
    return size;
}

// What both headers of an entry say; `flags` 1 is encrypted, `method` 0 stored.
static inline size_t put_entry(unsigned char *at, const char *name, uint32_t crc, size_t packed,
                               size_t size, unsigned flags, unsigned method)
{
    size_t n = put_number(at, flags, 2);
    n += put_number(at + n, method, 2);
    n += put_number(at + n, 0x00210000u, 4);
    n += put_number(at + n, crc, 4);
    n += put_number(at + n, packed, 4);
    n += put_number(at + n, size, 4);
    n += put_number(at + n, strlen(name), 2);
    return n + put_number(at + n, 0, 2);
}

// An entry of `packed` bytes that unfold to `size`.
static inline void archive_add_as(archive *a, const char *name, const void *data, size_t packed,
                                  size_t size, unsigned flags, unsigned method)
{
    uint32_t crc = crc_of(data, packed);
    size_t offset = a->size, length = strlen(name);
    unsigned char *d = a->directory + a->directory_size, *b = a->bytes + a->size;
    if (a->size + packed + length + 64 > sizeof a->bytes ||
        a->directory_size + length + 64 > sizeof a->directory) {
        test_case_failures++;
        return;
    }
    b += put_number(b, 0x04034b50u, 4);
    b += put_number(b, 20, 2);
    b += put_entry(b, name, crc, packed, size, flags, method);
    memcpy(b, name, length);
    memcpy(b + length, data, packed);
    a->size = (size_t)(b - a->bytes) + length + packed;
    d += put_number(d, 0x02014b50u, 4);
    d += put_number(d, 20, 2);
    d += put_number(d, 20, 2);
    d += put_entry(d, name, crc, packed, size, flags, method);
    d += put_number(d, 0, 10); // no comment, disk 0, no attributes
    d += put_number(d, offset, 4);
    memcpy(d, name, length);
    a->directory_size = (size_t)(d - a->directory) + length;
    a->count++;
}

static inline void archive_add(archive *a, const char *name, const char *text)
{
    archive_add_as(a, name, text, strlen(text), strlen(text), 0, 0);
}

static inline void archive_end(archive *a)
{
    size_t offset = a->size;
    memcpy(a->bytes + a->size, a->directory, a->directory_size);
    a->size += a->directory_size;
    unsigned char *b = a->bytes + a->size;
    b += put_number(b, 0x06054b50u, 4);
    b += put_number(b, 0, 4);
    b += put_number(b, a->count, 2);
    b += put_number(b, a->count, 2);
    b += put_number(b, a->directory_size, 4);
    b += put_number(b, offset, 4);
    b += put_number(b, 0, 2);
    a->size = (size_t)(b - a->bytes);
}

// The same, with the end of an archive of 64-bit sizes: everything said twice, once in each width;
// or only in the wide one, where `is_only_wide`. Beginnings of entries become wide too.
static inline void archive_end_wide(archive *a, int is_only_wide)
{
    size_t offset = a->size, record, count = is_only_wide ? 0xffff : a->count;
    memcpy(a->bytes + a->size, a->directory, a->directory_size);
    record = a->size + a->directory_size;
    unsigned char *b = a->bytes + record;
    b += put_number(b, 0x06064b50u, 4);
    b += put_number(b, 44, 8);
    b += put_number(b, 45u | 45u << 16, 4);
    b += put_number(b, 0, 8);
    b += put_number(b, a->count, 8);
    b += put_number(b, a->count, 8);
    b += put_number(b, a->directory_size, 8);
    b += put_number(b, offset, 8);
    b += put_number(b, 0x07064b50u, 4);
    b += put_number(b, 0, 4);
    b += put_number(b, record, 8);
    b += put_number(b, 1, 4);
    b += put_number(b, 0x06054b50u, 4);
    b += put_number(b, 0, 4);
    b += put_number(b, count, 2);
    b += put_number(b, count, 2);
    b += put_number(b, is_only_wide ? UINT32_MAX : a->directory_size, 4);
    b += put_number(b, is_only_wide ? UINT32_MAX : offset, 4);
    b += put_number(b, 0, 2);
    a->size = (size_t)(b - a->bytes);
}

// Let the last entry's directory record say its sizes and place by 64 bits.
static inline void archive_widen(archive *a, uint64_t size, uint64_t packed, uint64_t place)
{
    size_t name = 0; // the record begins 46 bytes before its name, which ends the directory
    unsigned char *end = a->directory + a->directory_size, *record = end - 46;
    while (memcmp(record, "PK\1\2", 4) != 0 || name != (size_t)(record[28] | record[29] << 8)) {
        record--;
        name++;
    }
    memset(record + 20, 0xff, 8);
    memset(record + 42, 0xff, 4);
    put_number(record + 30, 28, 2);
    end += put_number(end, 1, 2);
    end += put_number(end, 24, 2);
    end += put_number(end, size, 8);
    end += put_number(end, packed, 8);
    end += put_number(end, place, 8);
    a->directory_size = (size_t)(end - a->directory);
}

#define RELS(target)                                                                               \
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"       \
    "<Relationship Target=\"" target "\" Id=\"a\" "                                                \
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"

#define CORE_NS "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\""
#define MATERIAL_NS "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\""
#define PRODUCTION_NS "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\""
#define SLICE_NS "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\""

// A model with what stands in its resources and in its build.
#define MODEL(attributes, resources, build)                                                        \
    "<model " CORE_NS " " MATERIAL_NS " " PRODUCTION_NS " " SLICE_NS " " attributes                \
    "><resources>" resources "</resources><build>" build "</build></model>"

// A corner of a cube: volume 1/6.
#define CORNER                                                                                     \
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"           \
    "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles>"     \
    "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"                 \
    "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" "                           \
    "v3=\"3\"/></triangles></mesh>"
#define OBJECT(id, inside) "<object id=\"" id "\" name=\"part\">" inside "</object>"
#define ITEM(id) "<item objectid=\"" id "\"/>"

// A file of one model part.
static inline void archive_model(archive *a, const char *model)
{
    memset(a, 0, sizeof *a);
    archive_add(a, "_rels/.rels", RELS("/3D/3dmodel.model"));
    archive_add(a, "3D/3dmodel.model", model);
    archive_end(a);
}

static inline sf_status archive_read(const archive *a, const sf_read_limits *limits,
                                     const sf_allocator *allocator, sf_threemf **document,
                                     sf_fault *fault)
{
    sf_memory_cursor cursor = {a->bytes, a->size, 0};
    return sf_threemf_read(sf_memory_source(&cursor), limits, allocator, document, fault);
}

// Whether reading fails as expected, with a sentence that has these words, and leaves nothing.
static inline int refused(const archive *a, const sf_read_limits *limits, sf_status expected,
                          const char *words)
{
    failing_allocator memory;
    sf_threemf *document = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    failing_begin(&memory, -1);
    sf_status status = archive_read(a, limits, &memory.allocator, &document, &fault);
    int good = status == expected && document == NULL && fault.status == status &&
               strstr(fault.message, words) != NULL && memory.live == 0 && memory.faults == 0;
    if (!good) {
        printf("# expected \"%s\"; got %s, line %u: \"%s\"\n", words, sf_status_name(status),
               fault.line, fault.message);
    }
    sf_threemf_destroy(document);
    return good;
}

// Bytes that are written.
typedef struct bucket {
    unsigned char *bytes;
    size_t size, capacity;
    size_t most; // more are refused; SIZE_MAX: none
} bucket;

static inline sf_status bucket_write(void *user, const void *data, size_t size)
{
    bucket *b = user;
    if (size > b->most || b->size > b->most - size) {
        return SF_ERR_IO;
    }
    if (b->size + size > b->capacity) {
        b->capacity = 2 * (b->size + size);
        b->bytes = realloc(b->bytes, b->capacity);
    }
    memcpy(b->bytes + b->size, data, size);
    b->size += size;
    return SF_OK;
}

static inline sf_sink bucket_sink(bucket *b)
{
    sf_sink sink = {bucket_write, b};
    memset(b, 0, sizeof *b);
    b->most = SIZE_MAX;
    return sink;
}

#endif
