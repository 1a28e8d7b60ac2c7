// SPDX-License-Identifier: MIT
// A folder in memory, and pictures made by hand: PNG with nothing compressed, PBM.

#ifndef SF_TEST_STACK_FILES_H
#define SF_TEST_STACK_FILES_H

#include <sf/io.h>

#include "test.h"

#define MEMORY_FILES 64

typedef struct memory_file {
    char name[32];
    unsigned char *bytes;
    size_t size;
} memory_file;

typedef struct memory_folder {
    memory_file files[MEMORY_FILES];
    int count;
    memory_file draft;     // being written
    long budget;           // bytes that may still be written; negative: any number
    sf_memory_cursor open; // one file at a time
    int is_open, faults;
} memory_folder;

static inline memory_file *memory_find(memory_folder *folder, const char *name)
{
    for (int i = 0; i < folder->count; i++) {
        if (strcmp(folder->files[i].name, name) == 0) {
            return &folder->files[i];
        }
    }
    return NULL;
}

static inline sf_status memory_open(void *user, const char *name, sf_source *source)
{
    memory_folder *folder = user;
    const memory_file *file = memory_find(folder, name);
    if (file == NULL) {
        return SF_ERR_IO;
    }
    folder->faults += folder->is_open;
    folder->is_open = 1;
    sf_memory_cursor cursor = {file->bytes, file->size, 0};
    folder->open = cursor;
    *source = sf_memory_source(&folder->open);
    return SF_OK;
}

static inline void memory_close(void *user, sf_source source)
{
    memory_folder *folder = user;
    folder->faults += !folder->is_open || source.user != &folder->open;
    folder->is_open = 0;
}

static inline sf_status memory_write(void *user, const void *data, size_t size)
{
    memory_folder *folder = user;
    if (folder->budget >= 0 && (long)size > folder->budget) {
        return SF_ERR_IO;
    }
    folder->budget -= folder->budget >= 0 ? (long)size : 0;
    folder->draft.bytes = realloc(folder->draft.bytes, folder->draft.size + size + 1);
    memcpy(folder->draft.bytes + folder->draft.size, data, size);
    folder->draft.size += size;
    return SF_OK;
}

static inline sf_status memory_begin(void *user, const char *name, sf_sink *sink)
{
    memory_folder *folder = user;
    folder->faults += folder->draft.bytes != NULL || folder->count == MEMORY_FILES;
    memset(&folder->draft, 0, sizeof folder->draft);
    snprintf(folder->draft.name, sizeof folder->draft.name, "%s", name);
    sink->write = memory_write;
    sink->user = folder;
    return SF_OK;
}

static inline void memory_put(memory_folder *folder, const char *name, const void *bytes,
                              size_t size)
{
    memory_file *file = memory_find(folder, name);
    if (file == NULL) {
        file = &folder->files[folder->count++];
        snprintf(file->name, sizeof file->name, "%s", name);
        file->bytes = NULL;
    }
    unsigned char *copy = malloc(size + !size); // exact, so that a sanitizer sees one byte too many
    memcpy(copy, bytes, size);
    free(file->bytes);
    file->bytes = copy;
    file->size = size;
}

static inline sf_status memory_commit(void *user, int keep)
{
    memory_folder *folder = user;
    if (keep) {
        memory_put(folder, folder->draft.name, folder->draft.bytes, folder->draft.size);
    }
    free(folder->draft.bytes);
    folder->draft.bytes = NULL;
    return SF_OK;
}

static inline sf_folder memory_begin_folder(memory_folder *folder)
{
    sf_folder made = {memory_open, memory_close, memory_begin, memory_commit, folder};
    memset(folder, 0, sizeof *folder);
    folder->budget = -1;
    return made;
}

static inline void memory_end_folder(memory_folder *folder)
{
    for (int i = 0; i < folder->count; i++) {
        free(folder->files[i].bytes);
    }
    folder->count = 0;
}

static inline int memory_same(memory_folder *a, memory_folder *b)
{
    int good = a->count == b->count;
    for (int i = 0; good && i < a->count; i++) {
        const memory_file *other = memory_find(b, a->files[i].name);
        good = other != NULL && other->size == a->files[i].size &&
               memcmp(other->bytes, a->files[i].bytes, other->size) == 0;
    }
    return good;
}

// --- pictures by hand ----------------------------------------------------------------------------

typedef struct hand_png {
    unsigned char bytes[8192];
    size_t size;
} hand_png;

static inline void png_byte(hand_png *p, unsigned value)
{
    if (p->size < sizeof p->bytes) {
        p->bytes[p->size++] = (unsigned char)value;
    }
}

static inline void png_word(hand_png *p, uint32_t value)
{
    for (int shift = 24; shift >= 0; shift -= 8) {
        png_byte(p, value >> shift & 0xff);
    }
}

static inline void png_chunk(hand_png *p, const char *name, const unsigned char *data, size_t size)
{
    png_word(p, (uint32_t)size);
    size_t start = p->size;
    for (int i = 0; i < 4; i++) {
        png_byte(p, (unsigned char)name[i]);
    }
    for (size_t i = 0; i < size; i++) {
        png_byte(p, data[i]);
    }
    uint32_t crc = UINT32_MAX;
    for (size_t i = start; i < p->size; i++) {
        crc ^= p->bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
        }
    }
    png_word(p, ~crc);
}

// Rows of `row_bytes` from the top; one stored block.
static inline void png_make(hand_png *p, uint32_t width, uint32_t height, unsigned depth,
                            unsigned color, unsigned interlaced, const unsigned char *rows,
                            size_t row_bytes)
{
    static const unsigned char magic[] = {0x89, 'P', 'N', 'G', 13, 10, 26, 10};
    hand_png head, data;
    head.size = data.size = p->size = 0;
    for (size_t i = 0; i < sizeof magic; i++) {
        png_byte(p, magic[i]);
    }
    png_word(&head, width);
    png_word(&head, height);
    png_byte(&head, depth);
    png_byte(&head, color);
    png_byte(&head, 0);
    png_byte(&head, 0);
    png_byte(&head, interlaced);
    png_chunk(p, "IHDR", head.bytes, head.size);
    size_t size = height * (row_bytes + 1);
    png_byte(&data, 0x78);
    png_byte(&data, 0x01);
    png_byte(&data, 1);
    png_byte(&data, size & 0xff);
    png_byte(&data, size >> 8 & 0xff);
    png_byte(&data, ~size & 0xff);
    png_byte(&data, ~size >> 8 & 0xff);
    uint32_t a = 1, b = 0;
    for (size_t i = 0; i < size; i++) {
        unsigned byte = i % (row_bytes + 1) == 0
                            ? 0
                            : rows[i / (row_bytes + 1) * row_bytes + i % (row_bytes + 1) - 1];
        png_byte(&data, byte);
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    png_word(&data, b << 16 | a);
    png_chunk(p, "IDAT", data.bytes, data.size);
    png_chunk(p, "IEND", NULL, 0);
}

// stack.json of a stack of 3 x 2 x 1 voxels, with `pattern` and, behind it, anything else.
static inline void memory_put_document(memory_folder *folder, const char *pattern)
{
    char text[600];
    snprintf(text, sizeof text,
             "{\"format\":\"libsf-stack\",\"version\":1,\"units\":\"mm\",\"lattice\":{\"nx\":3,"
             "\"ny\":2,\"nz\":1,\"pitch_mm\":[0.1,0.2],\"layer_mm\":0.3,\"origin_mm\":[1,-2,3.5]},"
             "\"rule\":null,\"layers\":{\"pattern\":\"%s\",\"count\":1},\"solid\":\"white\","
             "\"row_order\":\"top_is_max_y\",\"unknown\":[1,{}]}",
             pattern);
    memory_put(folder, "stack.json", text, strlen(text));
}

#endif
