// SPDX-License-Identifier: MIT
// Small files in JSON that options name: opened, looked at, and values taken out of them.

#ifndef DEMO_SF_JSON_READ_H
#define DEMO_SF_JSON_READ_H

#include "job.h"

// Leave a sentence about the file that an option named.
exit_status json_fail(cli_job *job, exit_status status, const char *option, const char *path,
                      const char *what);

#ifdef SF_HAVE_JANSSON

#include <jansson.h>

enum { JSON_ITEMS_MAX = 64, JSON_WHY_SIZE = 256 };

// Why a file is no JSON, and in which line: one that cannot be opened has none.
void json_why(const json_error_t *error, char why[JSON_WHY_SIZE]);

// Read a file of a format, version 1, with a list of 1 to `most` objects under a key. The list is
// `items`, which is valid until json_decref(*root).
exit_status json_read_list(cli_job *job, const char *option, const char *path, const char *format,
                           const char *key, size_t most, json_t **root, const json_t **items);

// Take a value where there is one; returns 0 where there is one that will not do.
int json_get_number(const json_t *object, const char *key, double *value);
int json_get_flag(const json_t *object, const char *key, int *value);
int json_get_triple(const json_t *object, const char *key, double value[3]);

// The place in `names` of a text, or `missing` where there is none; -1 where it is no such text.
int json_get_choice(const json_t *object, const char *key, const char *const *names, int count,
                    int missing);

// Whether all keys of an object are among `names`.
int json_has_only(const json_t *object, const char *const *names, size_t count);

#endif

#endif
