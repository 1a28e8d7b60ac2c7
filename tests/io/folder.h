// SPDX-License-Identifier: MIT
// A folder of the test's own beneath the current one, emptied and removed at the end.

#ifndef SF_TEST_FOLDER_H
#define SF_TEST_FOLDER_H

#include "io/disk.h"

#include "test.h"

static char test_folder[128];

static inline const char *folder_path(const char *name)
{
    static char path[8][512];
    static int next;
    next = (next + 1) % 8;
    snprintf(path[next], sizeof path[next], "%s/%s", test_folder, name);
    return path[next];
}

static inline void folder_begin(const char *name)
{
    snprintf(test_folder, sizeof test_folder, "test-%s-%lu", name, sfi_disk_process());
    if (sfi_disk_make_folder(test_folder) != 0) {
        printf("# cannot make %s\n", test_folder);
    }
}

static inline int folder_count_one(void *user, const char *name)
{
    (void)name;
    ++*(int *)user;
    return 0;
}

static inline int folder_count(const char *path)
{
    int count = 0;
    return sfi_disk_list(path, folder_count_one, &count) == 0 ? count : -1;
}

static inline int folder_remove_one(void *user, const char *name)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", (const char *)user, name);
    if (sfi_disk_look(path) == SFI_DISK_FOLDER) {
        char inner[1024];
        memcpy(inner, path, sizeof inner);
        sfi_disk_list(inner, folder_remove_one, inner);
        sfi_disk_remove_folder(inner);
    } else {
        sfi_disk_remove_file(path);
    }
    return 0;
}

static inline void folder_end(void)
{
    sfi_disk_list(test_folder, folder_remove_one, test_folder);
    sfi_disk_remove_folder(test_folder);
}

// The whole of a file; its size, or -1.
static inline long folder_read(const char *path, void *data, size_t capacity)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return -1;
    }
    size_t size = fread(data, 1, capacity, file);
    fclose(file);
    return (long)size;
}

static inline int folder_write(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        return 0;
    }
    fputs(text, file);
    return fclose(file) == 0;
}

#endif
