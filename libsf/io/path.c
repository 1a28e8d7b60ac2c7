// SPDX-License-Identifier: MIT
// Paths as text. Both separators count on Windows, one elsewhere.

#include "io/path.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "io/disk.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

// Bytes of a path that a sentence shows; of a longer one, the end.
#define SHOWN_BYTES 100
// Longest path that systems open.
#define PATH_BYTES 4096

char *sfi_path_join(const sf_allocator *allocator, const char *path, char separator,
                    const char *name)
{
    size_t first = strlen(path), second = strlen(name), size;
    if (!sfi_size_add(first, second, &size) || !sfi_size_add(size, 2, &size)) {
        return NULL;
    }
    // The size that sfi_path_free() finds must be the one that was asked for.
    size -= separator == 0;
    char *joined = sfi_alloc_array(allocator, size, 1);
    if (joined != NULL) {
        memcpy(joined, path, first);
        joined[first] = separator;
        memcpy(joined + first + (separator != 0), name, second + 1);
    }
    return joined;
}

void sfi_path_free(const sf_allocator *allocator, char *path)
{
    if (path != NULL) {
        sfi_free_array(allocator, path, strlen(path) + 1, 1);
    }
}

char *sfi_path_sibling(const sf_allocator *allocator, const char *path, unsigned number,
                       const char *word)
{
    char ending[64];
    snprintf(ending, sizeof ending, ".sf-%lu-%u.%s", sfi_disk_process(), number, word);
    return sfi_path_join(allocator, path, 0, ending);
}

static int is_separator(char c)
{
#ifdef _WIN32
    return c == '/' || c == '\\' || c == ':';
#else
    return c == '/';
#endif
}

size_t sfi_path_folder_length(const char *path)
{
    size_t length = strlen(path);
    while (length > 0 && !is_separator(path[length - 1])) {
        length--;
    }
    return length > 1 ? length - 1 : length;
}

int sfi_path_put(char *buffer, size_t capacity, const char *folder, const char *name)
{
    int length = snprintf(buffer, capacity, "%s/%s", folder, name);
    return length > 0 && (size_t)length < capacity;
}

void sfi_path_sync_folder(const char *path)
{
    char folder[PATH_BYTES];
    size_t length = sfi_path_folder_length(path);
    if (length == 0) {
        sfi_disk_sync_folder(".");
    } else if (length < sizeof folder) {
        memcpy(folder, path, length);
        folder[length] = '\0';
        sfi_disk_sync_folder(folder);
    }
}

static const char *explain(int reason)
{
    switch (reason) {
    case ENOENT:
        return "there is no such file or folder; check the name";
    case EACCES:
    case EPERM:
        return "access is denied; check the rights or choose another place";
    case EROFS:
        return "the disk is read-only; choose another place";
    case ENOSPC:
        return "the disk is full; make room or choose another place";
    case EFBIG:
        return "a file may not be that large there; choose another place";
    case EISDIR:
        return "this is a folder; name a file";
    case ENOTDIR:
        return "a part of the path is no folder; check the name";
    case EEXIST:
    case ENOTEMPTY:
        return "the name is taken; choose another";
    case ENAMETOOLONG:
        return "the name is too long; choose a shorter one";
    case EMFILE:
    case ENFILE:
        return "too many files are open; close some";
    default:
        return "the system reports an error; try another place";
    }
}

sf_status sfi_path_fault(sf_fault *fault, const char *what, const char *path, int reason)
{
    size_t length = strlen(path);
    const char *shown = length > SHOWN_BYTES ? path + length - SHOWN_BYTES : path;
    return sfi_fault_set(fault, SF_ERR_IO, 0, 0, "%s %s%s: %s", what,
                         length > SHOWN_BYTES ? "..." : "", shown, explain(reason));
}
