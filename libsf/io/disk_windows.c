// SPDX-License-Identifier: MIT
// Files and folders by the Windows API. Elsewhere this file is empty, so that every build compiles
// the same list.

#include "io/disk.h"

#ifdef _WIN32

#define WIN32_LEAN_AND_MEAN

#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <string.h>
#include <sys/stat.h>
#include <windows.h>

// The errors that a person can do something about.
static int reason(BOOL succeeded)
{
    if (succeeded) {
        return 0;
    }
    switch (GetLastError()) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
        return ENOENT;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
        return EEXIST;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_WRITE_PROTECT:
        return EACCES;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
        return ENOSPC;
    case ERROR_DIR_NOT_EMPTY:
        return ENOTEMPTY;
    default:
        return EIO;
    }
}

sfi_disk_kind sfi_disk_look(const char *path)
{
    DWORD found = GetFileAttributesA(path);
    if (found == INVALID_FILE_ATTRIBUTES) {
        return SFI_DISK_NOTHING;
    }
    if (found & FILE_ATTRIBUTE_DIRECTORY) {
        return SFI_DISK_FOLDER;
    }
    return found & FILE_ATTRIBUTE_DEVICE ? SFI_DISK_OTHER : SFI_DISK_FILE;
}

unsigned long sfi_disk_process(void)
{
    return GetCurrentProcessId();
}

int sfi_disk_create(const char *path, FILE **file)
{
    int descriptor = _open(path, _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY, _S_IREAD | _S_IWRITE);
    if (descriptor < 0) {
        return errno != 0 ? errno : EIO;
    }
    FILE *opened = _fdopen(descriptor, "wb");
    if (opened == NULL) {
        _close(descriptor);
        DeleteFileA(path);
        return EIO;
    }
    *file = opened;
    return 0;
}

int sfi_disk_sync(FILE *file)
{
    return fflush(file) != 0 || _commit(_fileno(file)) != 0 ? (errno != 0 ? errno : EIO) : 0;
}

int sfi_disk_size(FILE *file, uint64_t *size)
{
    __int64 found = _filelengthi64(_fileno(file));
    if (found < 0) {
        return EIO;
    }
    *size = (uint64_t)found;
    return 0;
}

int sfi_disk_seek(FILE *file, uint64_t offset)
{
    return offset <= INT64_MAX && _fseeki64(file, (__int64)offset, SEEK_SET) == 0 ? 0 : EIO;
}

void sfi_disk_copy_rights(const char *path, const char *model)
{
    (void)path; // rights come from the folder
    (void)model;
}

int sfi_disk_rename(const char *from, const char *to)
{
    // A folder cannot be moved over another, not even an empty one.
    if (sfi_disk_look(from) == SFI_DISK_FOLDER && sfi_disk_look(to) == SFI_DISK_FOLDER &&
        !RemoveDirectoryA(to)) {
        return reason(FALSE);
    }
    return reason(MoveFileExA(from, to, MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH));
}

void sfi_disk_sync_folder(const char *folder)
{
    (void)folder; // MOVEFILE_WRITE_THROUGH has done so
}

int sfi_disk_make_folder(const char *path)
{
    return reason(CreateDirectoryA(path, NULL));
}

int sfi_disk_remove_file(const char *path)
{
    return reason(DeleteFileA(path));
}

int sfi_disk_remove_folder(const char *path)
{
    return reason(RemoveDirectoryA(path));
}

int sfi_disk_list(const char *folder, int (*visit)(void *user, const char *name), void *user)
{
    char pattern[MAX_PATH];
    WIN32_FIND_DATAA entry;
    size_t length = strlen(folder);
    if (length + 3 > sizeof pattern) {
        return ENAMETOOLONG;
    }
    memcpy(pattern, folder, length);
    memcpy(pattern + length, "/*", 3);
    HANDLE found = FindFirstFileA(pattern, &entry);
    if (found == INVALID_HANDLE_VALUE) {
        return reason(FALSE);
    }
    int result = 0;
    do {
        if (strcmp(entry.cFileName, ".") != 0 && strcmp(entry.cFileName, "..") != 0) {
            result = visit(user, entry.cFileName);
        }
    } while (result == 0 && FindNextFileA(found, &entry));
    FindClose(found);
    return result;
}

#endif
