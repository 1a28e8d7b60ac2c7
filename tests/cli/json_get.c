// SPDX-License-Identifier: MIT
// Prints one value of a JSON file: json-get FILE a.b.2.c. Text is printed bare, everything else as
// JSON; a list or an object prints its number of members. Exit status 1 when there is no such value
// or the file is not JSON.

#include <jansson.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const json_t *step(const json_t *from, const char *key)
{
    return json_is_array(from) ? json_array_get(from, (size_t)strtoul(key, NULL, 10))
                               : json_object_get(from, key);
}

int main(int argc, char **argv)
{
    json_error_t error;
    json_t *root = argc == 3 ? json_load_file(argv[1], JSON_REJECT_DUPLICATES, &error) : NULL;
    const json_t *value = root;
    if (root == NULL) {
        fprintf(stderr, "json-get: %s\n", argc == 3 ? error.text : "FILE PATH");
        return 1;
    }
    for (char *key = strtok(argv[2], "."); key != NULL && value != NULL; key = strtok(NULL, ".")) {
        value = step(value, key);
    }
    int found = value != NULL;
    if (json_is_string(value)) {
        puts(json_string_value(value));
    } else if (json_is_array(value)) {
        printf("%lu\n", (unsigned long)json_array_size(value));
    } else if (json_is_object(value)) {
        printf("%lu\n", (unsigned long)json_object_size(value));
    } else if (found) {
        json_dumpf(value, stdout, JSON_ENCODE_ANY | JSON_REAL_PRECISION(12));
        putchar('\n');
    }
    json_decref(root);
    return !found;
}
