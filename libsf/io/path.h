// SPDX-License-Identifier: MIT
// Paths as text: joining, siblings, and showing one in a sentence.

#ifndef SF_IO_PATH_H
#define SF_IO_PATH_H

#include <sf/base.h>

// `path` and `name` with a separator between them, or (separator 0) without; NULL when memory is
// short.
char *sfi_path_join(const sf_allocator *allocator, const char *path, char separator,
                    const char *name);
void sfi_path_free(const sf_allocator *allocator, char *path);

// FOLDER/NAME into a buffer; returns 0 when it does not fit.
int sfi_path_put(char *buffer, size_t capacity, const char *folder, const char *name);

// A name beside `path` that is most likely free: PATH.sf-PROCESS-NUMBER.WORD.
char *sfi_path_sibling(const sf_allocator *allocator, const char *path, unsigned number,
                       const char *word);

// Length of the part of a path that names its folder, separator left out; 0 when there is none.
size_t sfi_path_folder_length(const char *path);

// Make the renaming of `path` last, by syncing its folder.
void sfi_path_sync_folder(const char *path);

// Fill a fault about a path: "WHAT PATH: why" with an errno value as the reason.
sf_status sfi_path_fault(sf_fault *fault, const char *what, const char *path, int reason);

#endif
