// SPDX-License-Identifier: MIT
// Settings as slicers write them: a line each, "key = value".
//
// Only numbers are asked for, and of a list of them ("10,20") only the first. A key that stands
// twice has its last value, as readers that fill in a record have it.

#include "io/job.h"
#include "io/number.h"

#include <string.h>

static int is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

// The number between two places, if that is one.
static int parse(const char *from, const char *to, double *value)
{
    char number[64];
    while (from < to && is_blank(*from)) {
        from++;
    }
    const char *end = from;
    while (end < to && *end != ',' && *end != ';' && !is_blank(*end)) {
        end++;
    }
    size_t size = (size_t)(end - from);
    if (size == 0 || size >= sizeof number) {
        return 0;
    }
    memcpy(number, from, size);
    number[size] = '\0';
    return sfi_number_parse(number, value);
}

// Where the value of a line begins, if its key is that one.
static const char *value_of(const char *line, const char *end, const char *key)
{
    size_t size = strlen(key);
    while (line < end && is_blank(*line)) {
        line++;
    }
    if ((size_t)(end - line) <= size || memcmp(line, key, size) != 0) {
        return NULL;
    }
    line += size;
    while (line < end && is_blank(*line)) {
        line++;
    }
    return line < end && *line == '=' ? line + 1 : NULL;
}

int sfi_config_number(const char *text, size_t size, const char *key, double *value)
{
    const char *end = text + size;
    int found = 0;
    for (const char *line = text; line < end;) {
        const char *stop = memchr(line, '\n', (size_t)(end - line));
        stop = stop != NULL ? stop : end;
        const char *at = value_of(line, stop, key);
        double number;
        if (at != NULL && parse(at, stop, &number)) {
            *value = number;
            found = 1;
        }
        line = stop < end ? stop + 1 : end;
    }
    return found;
}
