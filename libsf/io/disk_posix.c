// SPDX-License-Identifier: MIT
// Files and folders by POSIX.1-2008. On Windows this file is empty, so that every build compiles
// the same list.

#define _POSIX_C_SOURCE 200809L
#define _FILE_OFFSET_BITS 64

#include "io/disk.h"

#ifndef _WIN32

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int reason(int failed)
{
    if (!failed) {
        return 0;
    }
    return errno != 0 ? errno : EIO;
}

sfi_disk_kind sfi_disk_look(const char *path)
{
    struct stat found;
    if (stat(path, &found) != 0) {
        return SFI_DISK_NOTHING;
    }
    if (S_ISREG(found.st_mode)) {
        return SFI_DISK_FILE;
    }
    return S_ISDIR(found.st_mode) ? SFI_DISK_FOLDER : SFI_DISK_OTHER;
}

unsigned long sfi_disk_process(void)
{
    return (unsigned long)getpid();
}

int sfi_disk_create(const char *path, FILE **file)
{
    int descriptor = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        return reason(1);
    }
    FILE *opened = fdopen(descriptor, "wb");
    if (opened == NULL) {
        int why = reason(1);
        close(descriptor);
        unlink(path);
        return why;
    }
    *file = opened;
    return 0;
}

int sfi_disk_sync(FILE *file)
{
    if (fflush(file) != 0) {
        return reason(1);
    }
    // Some file systems have nothing to sync and say so with EINVAL.
    return reason(fsync(fileno(file)) != 0 && errno != EINVAL && errno != ENOTSUP);
}

int sfi_disk_size(FILE *file, uint64_t *size)
{
    struct stat found;
    errno = 0;
    if (fstat(fileno(file), &found) != 0 || found.st_size < 0 || !S_ISREG(found.st_mode)) {
        return reason(1);
    }
    *size = (uint64_t)found.st_size;
    return 0;
}

int sfi_disk_seek(FILE *file, uint64_t offset)
{
    if (offset > INT64_MAX) {
        return EOVERFLOW;
    }
    return reason(fseeko(file, (off_t)offset, SEEK_SET) != 0);
}

void sfi_disk_copy_rights(const char *path, const char *model)
{
    struct stat found;
    if (stat(model, &found) == 0) {
        // A file that stays with the rights of a new one is a nuisance, not a loss.
        int ignored = chmod(path, found.st_mode & 0777);
        (void)ignored;
    }
}

int sfi_disk_rename(const char *from, const char *to)
{
    return reason(rename(from, to) != 0);
}

void sfi_disk_sync_folder(const char *folder)
{
    // The rename has happened; whether it outlasts a power cut is all that is asked for here.
    int descriptor = open(folder, O_RDONLY | O_CLOEXEC);
    if (descriptor >= 0) {
        int ignored = fsync(descriptor);
        (void)ignored;
        close(descriptor);
    }
}

int sfi_disk_make_folder(const char *path)
{
    return reason(mkdir(path, 0777) != 0);
}

int sfi_disk_remove_file(const char *path)
{
    return reason(unlink(path) != 0);
}

int sfi_disk_remove_folder(const char *path)
{
    return reason(rmdir(path) != 0);
}

int sfi_disk_list(const char *folder, int (*visit)(void *user, const char *name), void *user)
{
    DIR *open_folder = opendir(folder);
    if (open_folder == NULL) {
        return reason(1);
    }
    int result = 0;
    const struct dirent *entry;
    while (result == 0 && (entry = readdir(open_folder)) != NULL) {
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0) {
            result = visit(user, entry->d_name);
        }
    }
    closedir(open_folder);
    return result;
}

#endif
