// SPDX-License-Identifier: MIT
// JSON held against bounds before a parser sees it.
//
// tinygltf makes an object of up to two thousand bytes of every "{}" of a list of materials, goes
// down into extras by recursion, and copies the bytes of a binary file for every buffer that claims
// them: three bytes of text may cost a thousand of memory, and deep nesting the stack. So one pass
// over the text counts levels, objects, values and buffers outside of strings. It need not
// understand JSON: what is no JSON, the parser refuses; what is, has at least these counts.

#include "io/gltf_model.h"

#include "base/status.h"

#include <string.h>

enum { LEVELS_MAX = 64, NESTS_MAX = 200000, VALUES_MAX = 2000000 };
// Copies of a binary file's bytes beyond four of them.
static const uint64_t COPIES_MAX = (uint64_t)64 << 20;

typedef struct counts {
    size_t levels, deepest, nests, values, buffers;
    int in_buffers, is_hidden; // a name of the first level that is written in escapes
} counts;

// The string that begins at `at`: its end, behind the quote.
static size_t skip_string(const unsigned char *json, size_t size, size_t at, int *has_escapes)
{
    *has_escapes = 0;
    for (at++; at < size && json[at] != '"'; at++) {
        if (json[at] == '\\') {
            *has_escapes = 1;
            at++;
        }
    }
    return at < size ? at + 1 : size;
}

// A name of the first level says what the list behind it holds.
static void take_name(counts *c, const unsigned char *text, size_t length, int has_escapes)
{
    static const char buffers[] = "\"buffers\"";
    c->in_buffers = length == sizeof buffers - 1 && memcmp(text, buffers, length) == 0;
    c->is_hidden |= has_escapes;
}

static void count(counts *c, const unsigned char *json, size_t size)
{
    for (size_t at = 0; at < size && c->levels <= LEVELS_MAX;) {
        unsigned char byte = json[at];
        if (byte == '"') {
            int has_escapes;
            size_t end = skip_string(json, size, at, &has_escapes);
            if (c->levels == 1) {
                take_name(c, json + at, end - at, has_escapes);
            }
            at = end;
            continue;
        }
        if (byte == '{' || byte == '[') {
            c->buffers += c->levels == 2 && c->in_buffers;
            c->nests++;
            c->levels++;
            c->deepest = c->levels > c->deepest ? c->levels : c->deepest;
        } else if ((byte == '}' || byte == ']') && c->levels > 0) {
            c->levels--;
        }
        c->values += byte == ',';
        at++;
    }
}

sf_status sfi_gltf_guard(const unsigned char *json, size_t size, size_t binary_size,
                         sf_fault *fault)
{
    counts c = {0, 0, 0, 0, 0, 0, 0};
    count(&c, json, size);
    if (c.deepest > LEVELS_MAX) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "the file's JSON is nested deeper than %d levels", (int)LEVELS_MAX);
    }
    if (c.nests > NESTS_MAX || c.values > VALUES_MAX) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "the file's JSON has more than %d objects or %d values; save the part "
                             "in fewer pieces, or as STL",
                             (int)NESTS_MAX, (int)VALUES_MAX);
    }
    if (c.is_hidden) {
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                             "the file's JSON has a name at its first level that is written in "
                             "escapes, which no program does; export the part again");
    }
    if (c.buffers > 4 && (uint64_t)(c.buffers - 4) * binary_size > COPIES_MAX) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "%zu buffers claim the same %zu bytes; save the part with one buffer",
                             c.buffers, binary_size);
    }
    return SF_OK;
}
