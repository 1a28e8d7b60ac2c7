// SPDX-License-Identifier: MIT
// A folder of the disk as a stack sees it, and writing one without ever showing half.
//
// Files are written into a new folder beside the target. Committing renames it to the target's
// name. An empty folder in that place gives way in one step. An earlier stack cannot, because a
// rename does not replace a full folder: it is first renamed aside, and removed when the new one
// stands; a crash between the two renames leaves both, whole, under names that begin with the
// target's. Only folders in which every file is part of a stack are ever replaced, so nobody's
// other files can be lost.

#include <sf/io.h>

#include "base/memory.h"
#include "base/status.h"
#include "io/disk.h"
#include "io/path.h"
#include "io/stack.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

// Names tried for folders beside the target.
#define NAMES 100
// Room for the ending of such a name, and for the name of a file.
#define BESIDE_BYTES 64
#define NAME_BYTES 260

struct sf_directory {
    sf_allocator allocator;
    char *path;      // as the caller named it, separators at its end left out
    char *temporary; // the folder being written, or NULL when this one is read
    FILE *stream;    // the file being written, or NULL; its path is in scratch
    int failure;     // errno value of its first write that failed, or 0
    char *scratch;   // room for any path in these folders, so that removing needs no memory
    size_t scratch_size;
};

// --- what stands at the target -------------------------------------------------------------------

typedef struct contents {
    int entries, has_document, has_others;
    char other[64]; // the first entry that is no part of a stack
} contents;

static int note_entry(void *user, const char *name)
{
    contents *found = user;
    found->entries++;
    found->has_document |= strcmp(name, SFI_STACK_DOCUMENT) == 0;
    if (!sfi_stack_owns(name) && !found->has_others) {
        found->has_others = 1;
        snprintf(found->other, sizeof found->other, "%s", name);
    }
    return 0;
}

// SF_OK when the path is free, an empty folder (*full 0), or a stack and nothing else (*full 1).
static sf_status check_target(const char *path, int *full, sf_fault *fault)
{
    contents found = {0, 0, 0, ""};
    sfi_disk_kind kind = sfi_disk_look(path);
    *full = 0;
    if (kind == SFI_DISK_NOTHING) {
        return SF_OK;
    }
    if (kind != SFI_DISK_FOLDER) {
        return sfi_path_fault(fault, "cannot write a stack to", path, EEXIST);
    }
    int why = sfi_disk_list(path, note_entry, &found);
    if (why != 0) {
        return sfi_path_fault(fault, "cannot look into", path, why);
    }
    if (found.has_others || (found.entries > 0 && !found.has_document)) {
        return sfi_fault_set(fault, SF_ERR_IO, 0, 0,
                             "the folder is neither empty nor an earlier stack (it %s%s), so it is "
                             "not replaced; name another folder",
                             found.has_others ? "holds " : "has no " SFI_STACK_DOCUMENT,
                             found.other);
    }
    *full = found.entries > 0;
    return SF_OK;
}

typedef struct removal {
    sf_directory *directory;
    const char *folder;
    int only_ours; // leave what is no part of a stack
} removal;

static int remove_entry(void *user, const char *name)
{
    const removal *r = user;
    char *path = r->directory->scratch;
    if ((!r->only_ours || sfi_stack_owns(name)) &&
        sfi_path_put(path, r->directory->scratch_size, r->folder, name)) {
        sfi_disk_remove_file(path);
    }
    return 0;
}

// Remove a folder of files, as far as that goes. Some systems lose count when entries go while they
// list, so it is listed again until it is gone.
static void remove_folder(sf_directory *directory, const char *folder, int only_ours)
{
    removal r = {directory, folder, only_ours};
    for (int i = 0; i < 3 && sfi_disk_remove_folder(folder) != 0; i++) {
        sfi_disk_list(folder, remove_entry, &r);
    }
}

// --- begin and end -------------------------------------------------------------------------------

static sf_directory *make(const char *path, const sf_allocator *allocator)
{
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_directory *made = sfi_alloc_array(&from, 1, sizeof *made);
    if (made == NULL) {
        return NULL;
    }
    sf_directory empty = {from, NULL, NULL, NULL, 0, NULL, 0};
    *made = empty;
    size_t length = strlen(path);
    while (length > 1 && (path[length - 1] == '/' || path[length - 1] == '\\')) {
        length--;
    }
    made->path = sfi_alloc_array(&from, length + 1, 1);
    made->scratch_size = length + BESIDE_BYTES + NAME_BYTES;
    made->scratch = sfi_alloc_array(&from, made->scratch_size, 1);
    if (made->path != NULL) {
        memcpy(made->path, path, length);
        made->path[length] = '\0';
    }
    if (made->path == NULL || made->scratch == NULL) {
        sf_directory_close(made);
        return NULL;
    }
    return made;
}

static void drop_file(sf_directory *directory)
{
    if (directory->stream != NULL) {
        fclose(directory->stream);
        sfi_disk_remove_file(directory->scratch);
    }
    directory->stream = NULL;
}

void sf_directory_close(sf_directory *directory)
{
    if (directory == NULL) {
        return;
    }
    sf_allocator allocator = directory->allocator;
    drop_file(directory);
    if (directory->temporary != NULL) {
        remove_folder(directory, directory->temporary, 0);
    }
    sfi_path_free(&allocator, directory->temporary);
    sfi_path_free(&allocator, directory->path);
    sfi_free_array(&allocator, directory->scratch, directory->scratch_size, 1);
    sfi_free_array(&allocator, directory, 1, sizeof *directory);
}

static sf_status check_arguments(const char *path, sf_directory **directory, sf_fault *fault)
{
    return path != NULL && path[0] != '\0' && directory != NULL
               ? SF_OK
               : sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no path, or no place for the folder");
}

sf_status sf_directory_read(const char *path, const sf_allocator *allocator,
                            sf_directory **directory, sf_fault *fault)
{
    SF_TRY(check_arguments(path, directory, fault));
    sfi_disk_kind kind = sfi_disk_look(path);
    if (kind != SFI_DISK_FOLDER) {
        return sfi_path_fault(fault, "cannot open the folder", path,
                              kind == SFI_DISK_NOTHING ? ENOENT : ENOTDIR);
    }
    sf_directory *made = make(path, allocator);
    if (made == NULL) {
        return sfi_fault_set(fault, SF_ERR_MEMORY, 0, 0, "there is not enough memory");
    }
    *directory = made;
    return SF_OK;
}

// Make a folder beside the target, or (from != NULL) rename one to there; its path into *name.
static sf_status beside(sf_directory *directory, const char *word, const char *from, char **name,
                        sf_fault *fault)
{
    int why = EEXIST;
    for (unsigned i = 0; i < NAMES && (why == EEXIST || why == ENOTEMPTY); i++) {
        char *path = sfi_path_sibling(&directory->allocator, directory->path, i, word);
        if (path == NULL) {
            return sfi_fault_set(fault, SF_ERR_MEMORY, 0, 0, "there is not enough memory");
        }
        if (from != NULL && sfi_disk_look(path) != SFI_DISK_NOTHING) {
            why = EEXIST;
        } else {
            why = from == NULL ? sfi_disk_make_folder(path) : sfi_disk_rename(from, path);
        }
        if (why == 0) {
            *name = path;
            return SF_OK;
        }
        sfi_path_free(&directory->allocator, path);
    }
    return sfi_path_fault(fault, "cannot write the folder", directory->path, why);
}

sf_status sf_directory_write(const char *path, const sf_allocator *allocator,
                             sf_directory **directory, sf_fault *fault)
{
    int full;
    SF_TRY(check_arguments(path, directory, fault));
    sf_directory *made = make(path, allocator);
    if (made == NULL) {
        return sfi_fault_set(fault, SF_ERR_MEMORY, 0, 0, "there is not enough memory");
    }
    size_t folder = sfi_path_folder_length(made->path);
    const char *last = made->path + folder + (made->path[folder] == '/' && folder > 0);
    sf_status status = check_target(made->path, &full, fault);
    if (status == SF_OK &&
        (strcmp(last, ".") == 0 || strcmp(last, "..") == 0 || strcmp(made->path, "/") == 0)) {
        status = sfi_fault_set(fault, SF_ERR_IO, 0, 0,
                               "the folder that one stands in cannot be replaced; name another");
    }
    if (status == SF_OK) {
        status = beside(made, "tmp", NULL, &made->temporary, fault);
    }
    if (status != SF_OK) {
        sf_directory_close(made);
        return status;
    }
    *directory = made;
    return SF_OK;
}

// Put the finished folder in the target's place.
static sf_status publish(sf_directory *directory, sf_fault *fault)
{
    int full;
    char *aside = NULL;
    SF_TRY(check_target(directory->path, &full, fault));
    if (full) {
        SF_TRY(beside(directory, "old", directory->path, &aside, fault));
    }
    int why = sfi_disk_rename(directory->temporary, directory->path);
    if (why != 0 && aside != NULL) {
        sfi_disk_rename(aside, directory->path); // the old one back
        sfi_path_free(&directory->allocator, aside);
    }
    if (why != 0) {
        return sfi_path_fault(fault, "cannot write the folder", directory->path, why);
    }
    sfi_path_free(&directory->allocator, directory->temporary);
    directory->temporary = NULL;
    sfi_path_sync_folder(directory->path);
    if (aside != NULL) {
        remove_folder(directory, aside, 1);
        sfi_path_free(&directory->allocator, aside);
    }
    return SF_OK;
}

sf_status sf_directory_commit(sf_directory *directory, sf_fault *fault)
{
    if (directory == NULL || directory->temporary == NULL) {
        sf_directory_close(directory);
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no folder is being written");
    }
    drop_file(directory);
    sfi_disk_sync_folder(directory->temporary);
    sf_status status = publish(directory, fault);
    sf_directory_close(directory);
    return status;
}

// --- the folder ----------------------------------------------------------------------------------

static int is_plain(const char *name)
{
    return name != NULL && name[0] != '\0' && strpbrk(name, "/\\:") == NULL &&
           strcmp(name, ".") != 0 && strcmp(name, "..") != 0;
}

static sf_status folder_open(void *user, const char *name, sf_source *source)
{
    sf_directory *directory = user;
    sf_file *file = NULL;
    if (!is_plain(name)) {
        return SF_ERR_ARGUMENT;
    }
    const char *folder = directory->temporary != NULL ? directory->temporary : directory->path;
    char *path = sfi_path_join(&directory->allocator, folder, '/', name);
    if (path == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = sf_file_open(path, &directory->allocator, &file, NULL);
    sfi_path_free(&directory->allocator, path);
    if (status == SF_OK) {
        *source = sf_file_source(file);
    }
    return status;
}

static void folder_close(void *user, sf_source source)
{
    (void)user;
    sf_file_close(source.user);
}

static sf_status write_stream(void *user, const void *data, size_t size)
{
    sf_directory *directory = user;
    if (directory->failure == 0 && fwrite(data, 1, size, directory->stream) != size) {
        directory->failure = errno != 0 ? errno : EIO;
    }
    return directory->failure == 0 ? SF_OK : SF_ERR_IO;
}

static sf_status folder_begin(void *user, const char *name, sf_sink *sink)
{
    sf_directory *directory = user;
    if (!is_plain(name) || directory->temporary == NULL || directory->stream != NULL) {
        return SF_ERR_ARGUMENT;
    }
    if (!sfi_path_put(directory->scratch, directory->scratch_size, directory->temporary, name)) {
        return SF_ERR_ARGUMENT;
    }
    directory->failure = 0;
    if (sfi_disk_create(directory->scratch, &directory->stream) != 0) {
        directory->stream = NULL;
        return SF_ERR_IO;
    }
    sink->write = write_stream;
    sink->user = directory;
    return SF_OK;
}

static sf_status folder_commit(void *user, int keep)
{
    sf_directory *directory = user;
    if (directory->stream == NULL) {
        return SF_OK; // nothing was begun
    }
    int failed = directory->failure != 0 || (keep && sfi_disk_sync(directory->stream) != 0);
    if (!keep || failed) {
        drop_file(directory);
        return keep ? SF_ERR_IO : SF_OK;
    }
    FILE *stream = directory->stream;
    directory->stream = NULL;
    return fclose(stream) == 0 ? SF_OK : SF_ERR_IO;
}

sf_folder sf_directory_folder(sf_directory *directory)
{
    sf_folder folder = {folder_open, folder_close, folder_begin, folder_commit, directory};
    if (directory == NULL) {
        memset(&folder, 0, sizeof folder);
    }
    return folder;
}
