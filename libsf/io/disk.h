// SPDX-License-Identifier: MIT
// What saving needs of the operating system, and nothing more; disk_posix.c and disk_windows.c.
//
// Calls return 0, or the reason as an errno value. Nothing else in libsf knows a path.

#ifndef SF_IO_DISK_H
#define SF_IO_DISK_H

#include <stdint.h>
#include <stdio.h>

typedef enum sfi_disk_kind {
    SFI_DISK_NOTHING = 0, // nothing there, or nothing that can be looked at
    SFI_DISK_FILE = 1,    // an ordinary file
    SFI_DISK_FOLDER = 2,
    SFI_DISK_OTHER = 3 // a device, a pipe, a socket
} sfi_disk_kind;

sfi_disk_kind sfi_disk_look(const char *path);

// A number that no other process has now.
unsigned long sfi_disk_process(void);

// A new file, for writing; EEXIST when there is one.
int sfi_disk_create(const char *path, FILE **file);

// Everything written so far, onto the disk itself.
int sfi_disk_sync(FILE *file);

// The size of an open file, and a move to a place in it; files of any size.
int sfi_disk_size(FILE *file, uint64_t *size);
int sfi_disk_seek(FILE *file, uint64_t offset);

// Give `path` the access rights of `model`, where there are such rights.
void sfi_disk_copy_rights(const char *path, const char *model);

// Rename a file over another, or a folder to a name that is free or an empty folder's: afterwards
// the name means the one or the other, never neither. `durable`: come back when the disk knows.
int sfi_disk_rename(const char *from, const char *to);
void sfi_disk_sync_folder(const char *folder);

int sfi_disk_make_folder(const char *path);
int sfi_disk_remove_file(const char *path);
int sfi_disk_remove_folder(const char *path);

// Call `visit` with each name in a folder (not . and ..) until it returns other than 0, and return
// that; an errno value when the folder cannot be read.
int sfi_disk_list(const char *folder, int (*visit)(void *user, const char *name), void *user);

#endif
