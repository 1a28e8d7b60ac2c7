// SPDX-License-Identifier: MIT
// Small files in JSON that options name. A key that is not known is refused: it is a slip of the
// pen more often than not, and what it meant would not be done.

#include "json_read.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

exit_status json_fail(cli_job *job, exit_status status, const char *option, const char *path,
                      const char *what)
{
    return job_fail(job, status, "%s %.300s: %s", option, path, what);
}

#ifdef SF_HAVE_JANSSON

void json_why(const json_error_t *error, char why[JSON_WHY_SIZE])
{
    if (error->line > 0) {
        snprintf(why, JSON_WHY_SIZE, "line %d: %s", error->line, error->text);
    } else {
        snprintf(why, JSON_WHY_SIZE, "%s", error->text);
    }
}

static exit_status check_head(cli_job *job, const char *option, const char *path,
                              const char *format, const char *key, size_t most, const json_t *root,
                              const json_t **items)
{
    const char *const keys[] = {"format", "version", key};
    const char *named = json_string_value(json_object_get(root, "format"));
    char why[160];
    double version = 0;
    if (named == NULL || strcmp(named, format) != 0 ||
        !json_get_number(root, "version", &version) || fabs(version - 1) > 0) {
        snprintf(why, sizeof why, "format must be %s, and version 1.", format);
        return json_fail(job, EXIT_INPUT, option, path, why);
    }
    *items = json_object_get(root, key);
    if (!json_is_array(*items) || json_array_size(*items) < 1 || json_array_size(*items) > most ||
        !json_has_only(root, keys, 3)) {
        snprintf(why, sizeof why, "beside format and version there is %s, a list of 1 to %zu.", key,
                 most);
        return json_fail(job, EXIT_INPUT, option, path, why);
    }
    return EXIT_GOOD;
}

exit_status json_read_list(cli_job *job, const char *option, const char *path, const char *format,
                           const char *key, size_t most, json_t **root, const json_t **items)
{
    json_error_t error;
    *root = json_load_file(path, JSON_REJECT_DUPLICATES, &error);
    if (*root == NULL) {
        char why[JSON_WHY_SIZE];
        json_why(&error, why);
        return json_fail(job, EXIT_INPUT, option, path, why);
    }
    exit_status status = check_head(job, option, path, format, key, most, *root, items);
    if (status != EXIT_GOOD) {
        json_decref(*root);
        *root = NULL;
    }
    return status;
}

int json_get_number(const json_t *object, const char *key, double *value)
{
    const json_t *found = json_object_get(object, key);
    if (json_is_number(found)) {
        *value = json_number_value(found);
    }
    return found == NULL || json_is_number(found);
}

int json_get_flag(const json_t *object, const char *key, int *value)
{
    const json_t *found = json_object_get(object, key);
    if (json_is_boolean(found)) {
        *value = json_is_true(found);
    }
    return found == NULL || json_is_boolean(found);
}

int json_get_triple(const json_t *object, const char *key, double value[3])
{
    const json_t *found = json_object_get(object, key);
    if (found == NULL) {
        return 1;
    }
    for (size_t i = 0; i < 3; i++) {
        const json_t *item = json_array_get(found, i);
        if (!json_is_number(item)) {
            return 0;
        }
        value[i] = json_number_value(item);
    }
    return json_array_size(found) == 3;
}

int json_get_choice(const json_t *object, const char *key, const char *const *names, int count,
                    int missing)
{
    const json_t *found = json_object_get(object, key);
    const char *text = json_string_value(found);
    for (int i = 0; text != NULL && i < count; i++) {
        if (strcmp(text, names[i]) == 0) {
            return i;
        }
    }
    return found == NULL ? missing : -1;
}

int json_has_only(const json_t *object, const char *const *names, size_t count)
{
    size_t known = 0;
    for (size_t i = 0; i < count; i++) {
        known += json_object_get(object, names[i]) != NULL;
    }
    return json_is_object(object) && known == json_object_size(object);
}

#endif
