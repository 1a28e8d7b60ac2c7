// SPDX-License-Identifier: MIT
// What a verb found out: fields for machines, sentences for people, printed by one code path.
//
// Fields become JSON text as they are added, in a buffer that grows; sentences and warnings are
// kept apart and become the last two members. So a report needs no tree, its order is the order of
// the calls, and what stands in report.json is what --json prints. A lack of memory is remembered
// and comes out when the report is printed.

#include "report.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 8 };

// Bytes that grow.
typedef struct buffer {
    char *bytes;
    size_t size, capacity;
    int failed;
} buffer;

struct report {
    buffer fields, sentences, warnings; // sentences and warnings: lines
    int depth;
    char closer[DEPTH_MAX]; // what ends each open object or list
    int filled[DEPTH_MAX];  // whether something stands in it yet
};

// ---------------------------------------------------------------------------------------------
// Growing text
// ---------------------------------------------------------------------------------------------

static void append(buffer *b, const char *bytes, size_t size)
{
    if (b->failed || size > (size_t)-1 / 4 - b->size) {
        b->failed = 1;
        return;
    }
    if (b->size + size > b->capacity) {
        size_t capacity = 2 * (b->size + size) + 256;
        char *grown = realloc(b->bytes, capacity);
        if (grown == NULL) {
            b->failed = 1;
            return;
        }
        b->bytes = grown;
        b->capacity = capacity;
    }
    memcpy(b->bytes + b->size, bytes, size);
    b->size += size;
}

static void append_text(buffer *b, const char *text)
{
    append(b, text, strlen(text));
}

// A JSON string. Bytes that are no UTF-8 (paths may hold any) become U+FFFD.
static size_t utf8_length(const unsigned char *s)
{
    size_t length = s[0] < 0x80                   ? 1
                    : s[0] >= 0xc2 && s[0] < 0xe0 ? 2
                    : s[0] >= 0xe0 && s[0] < 0xf0 ? 3
                    : s[0] >= 0xf0 && s[0] < 0xf5 ? 4
                                                  : 0;
    for (size_t i = 1; i < length; i++) {
        if ((s[i] & 0xc0) != 0x80) {
            return 0;
        }
    }
    int overlong = (s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xf0 && s[1] < 0x90);
    int beyond = (s[0] == 0xed && s[1] >= 0xa0) || (s[0] == 0xf4 && s[1] >= 0x90);
    return length > 1 && (overlong || beyond) ? 0 : length;
}

static void append_string(buffer *b, const char *text, size_t size)
{
    append_text(b, "\"");
    for (size_t i = 0; i < size;) {
        const unsigned char *s = (const unsigned char *)text + i;
        char escaped[8];
        size_t length = utf8_length(s);
        if (*s == '"' || *s == '\\') {
            snprintf(escaped, sizeof escaped, "\\%c", *s);
            append_text(b, escaped);
        } else if (*s < 0x20) {
            snprintf(escaped, sizeof escaped, "\\u%04x", *s);
            append_text(b, escaped);
        } else if (length == 0) {
            append_text(b, "\xef\xbf\xbd");
            length = 1;
        } else {
            append(b, text + i, length);
        }
        i += length;
    }
    append_text(b, "\"");
}

// ---------------------------------------------------------------------------------------------
// Fields
// ---------------------------------------------------------------------------------------------

report *report_create(void)
{
    return calloc(1, sizeof(report));
}

void report_destroy(report *r)
{
    if (r != NULL) {
        free(r->fields.bytes);
        free(r->sentences.bytes);
        free(r->warnings.bytes);
        free(r);
    }
}

// A comma where one is due, a new line for members of objects near the top, the key.
static void lead(report *r, const char *key)
{
    buffer *b = &r->fields;
    if (r->filled[r->depth]) {
        append_text(b, ",");
    }
    if (r->depth == 0 || (key == NULL && r->depth == 1)) {
        append_text(b, r->depth == 0 ? "\n  " : "\n    ");
    } else if (r->filled[r->depth]) {
        append_text(b, " ");
    }
    r->filled[r->depth] = 1;
    if (key != NULL) {
        append_string(b, key, strlen(key));
        append_text(b, ": ");
    }
}

static void append_number(buffer *b, double value)
{
    char text[32];
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, NULL) == value) {
            break;
        }
    }
    append_text(b, isfinite(value) ? text : "null");
}

void report_number(report *r, const char *key, double value)
{
    lead(r, key);
    append_number(&r->fields, value);
}

void report_count(report *r, const char *key, uint64_t value)
{
    char text[24];
    snprintf(text, sizeof text, "%llu", (unsigned long long)value);
    lead(r, key);
    append_text(&r->fields, text);
}

void report_flag(report *r, const char *key, int value)
{
    lead(r, key);
    append_text(&r->fields, value ? "true" : "false");
}

void report_text(report *r, const char *key, const char *value)
{
    lead(r, key);
    append_string(&r->fields, value, strlen(value));
}

void report_null(report *r, const char *key)
{
    lead(r, key);
    append_text(&r->fields, "null");
}

void report_numbers(report *r, const char *key, const double *values, size_t count)
{
    lead(r, key);
    for (size_t i = 0; i < count; i++) {
        append_text(&r->fields, i == 0 ? "[" : ", ");
        append_number(&r->fields, values[i]);
    }
    append_text(&r->fields, count == 0 ? "[]" : "]");
}

static void begin(report *r, const char *key, char opener, char closer)
{
    lead(r, key);
    append(&r->fields, &opener, 1);
    if (r->depth + 1 < DEPTH_MAX) {
        r->depth++;
        r->closer[r->depth] = closer;
        r->filled[r->depth] = 0;
    } else {
        r->fields.failed = 1;
    }
}

void report_begin(report *r, const char *key)
{
    begin(r, key, '{', '}');
}

void report_begin_list(report *r, const char *key)
{
    begin(r, key, '[', ']');
}

void report_end(report *r)
{
    append(&r->fields, &r->closer[r->depth], 1);
    r->depth -= r->depth > 0;
}

// ---------------------------------------------------------------------------------------------
// Sentences
// ---------------------------------------------------------------------------------------------

void report_say(report *r, const char *format, ...)
{
    char line[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    append_text(&r->sentences, line);
    append_text(&r->sentences, "\n");
}

void report_warn(report *r, const char *sentence)
{
    append_text(&r->warnings, sentence);
    append_text(&r->warnings, "\n");
}

// Lines as a list of strings, the last member of the report.
static void append_lines(buffer *b, const char *key, const buffer *lines)
{
    append_text(b, ",\n  \"");
    append_text(b, key);
    append_text(b, "\": [");
    for (size_t at = 0, count = 0; at < lines->size; count++) {
        const char *line = lines->bytes + at;
        size_t length = (size_t)((const char *)memchr(line, '\n', lines->size - at) - line);
        append_text(b, count == 0 ? "\n    " : ",\n    ");
        append_string(b, line, length);
        at += length + 1;
    }
    append_text(b, "]");
}

static sf_status print(const buffer *b, sf_sink sink)
{
    if (b->failed) {
        return SF_ERR_MEMORY;
    }
    return b->size == 0 ? SF_OK : sink.write(sink.user, b->bytes, b->size);
}

sf_status report_print_json(const report *r, sf_sink sink)
{
    buffer whole = {NULL, 0, 0, r->fields.failed || r->sentences.failed || r->warnings.failed};
    append_text(&whole, "{");
    append(&whole, r->fields.bytes, r->fields.size);
    append_lines(&whole, "warnings", &r->warnings);
    append_lines(&whole, "summary", &r->sentences);
    append_text(&whole, "\n}\n");
    sf_status status = print(&whole, sink);
    free(whole.bytes);
    return status;
}

sf_status report_print_text(const report *r, sf_sink sink)
{
    return print(&r->sentences, sink);
}

sf_status report_print_warnings(const report *r, sf_sink sink)
{
    return print(&r->warnings, sink);
}
