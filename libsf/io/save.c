// SPDX-License-Identifier: MIT
// A path turned into a sink that never shows half a file.
//
// Bytes go to a new file beside the target, in the same folder and so on the same disk. Committing
// brings them onto the disk, renames the file over the target, and syncs the folder: whoever opens
// the path at any moment, after a power cut too, finds the old file or the new one, whole. Only
// ordinary files are replaced: a rename over a device would not write to it, but destroy it.

#include <sf/io.h>

#include "base/memory.h"
#include "base/status.h"
#include "io/disk.h"
#include "io/path.h"

#include <errno.h>
#include <stdio.h>

// Names tried for the temporary file.
#define NAMES 100

struct sf_save {
    sf_allocator allocator;
    FILE *stream;
    char *path, *temporary;
    int failure; // errno value of the first write that failed, or 0
};

static void release(sf_save *save)
{
    sf_allocator allocator = save->allocator;
    if (save->stream != NULL) {
        fclose(save->stream);
    }
    if (save->temporary != NULL) {
        sfi_disk_remove_file(save->temporary);
    }
    sfi_path_free(&allocator, save->temporary);
    sfi_path_free(&allocator, save->path);
    sfi_free_array(&allocator, save, 1, sizeof *save);
}

// Create the temporary file; leaves save->temporary NULL when it fails.
static sf_status create(sf_save *save, sf_fault *fault)
{
    int why = EEXIST;
    for (unsigned i = 0; i < NAMES && why == EEXIST; i++) {
        char *name = sfi_path_sibling(&save->allocator, save->path, i, "tmp");
        if (name == NULL) {
            return SF_ERR_MEMORY;
        }
        why = sfi_disk_create(name, &save->stream);
        if (why == 0) {
            // Writers hand on blocks, and are to hear of a full disk from the one that does not
            // fit.
            (void)setvbuf(save->stream, NULL, _IONBF, 0);
            save->temporary = name;
        } else {
            sfi_path_free(&save->allocator, name);
        }
    }
    return why == 0 ? SF_OK : sfi_path_fault(fault, "cannot write", save->path, why);
}

static sf_status check_target(const char *path, sf_fault *fault)
{
    switch (sfi_disk_look(path)) {
    case SFI_DISK_FOLDER:
        return sfi_path_fault(fault, "cannot write", path, EISDIR);
    case SFI_DISK_OTHER:
        return sfi_fault_set(fault, SF_ERR_IO, 0, 0,
                             "this is no ordinary file, so it cannot be replaced; name a file");
    default:
        return SF_OK;
    }
}

sf_status sf_save_begin(const char *path, const sf_allocator *allocator, sf_save **save,
                        sf_fault *fault)
{
    if (path == NULL || path[0] == '\0' || save == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no path, or no place for the file");
    }
    SF_TRY(check_target(path, fault));
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_save *made = sfi_alloc_array(&from, 1, sizeof *made);
    sf_status status = SF_ERR_MEMORY;
    if (made != NULL) {
        sf_save empty = {from, NULL, NULL, NULL, 0};
        *made = empty;
        made->path = sfi_path_join(&from, path, 0, "");
        status = made->path != NULL ? create(made, fault) : SF_ERR_MEMORY;
    }
    if (status == SF_ERR_MEMORY) {
        sfi_fault_set(fault, status, 0, 0, "there is not enough memory");
    }
    if (status != SF_OK) {
        sf_save_abort(made);
        return status;
    }
    *save = made;
    return SF_OK;
}

static sf_status write_stream(void *user, const void *data, size_t size)
{
    sf_save *save = user;
    if (save->failure == 0 && fwrite(data, 1, size, save->stream) != size) {
        save->failure = errno != 0 ? errno : EIO;
    }
    return save->failure == 0 ? SF_OK : SF_ERR_IO;
}

sf_sink sf_save_sink(sf_save *save)
{
    sf_sink sink = {save != NULL ? write_stream : NULL, save};
    return sink;
}

sf_status sf_save_commit(sf_save *save, sf_fault *fault)
{
    if (save == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "there is nothing to save");
    }
    int why = save->failure;
    if (why == 0) {
        why = sfi_disk_sync(save->stream);
    }
    if (fclose(save->stream) != 0 && why == 0) {
        why = errno != 0 ? errno : EIO;
    }
    save->stream = NULL;
    sf_status status = why == 0 ? check_target(save->path, fault) : SF_OK;
    if (why == 0 && status == SF_OK) {
        sfi_disk_copy_rights(save->temporary, save->path);
        why = sfi_disk_rename(save->temporary, save->path);
    }
    if (why != 0) {
        status = sfi_path_fault(fault, "cannot write", save->path, why);
    } else if (status == SF_OK) {
        sfi_path_free(&save->allocator, save->temporary);
        save->temporary = NULL;
        sfi_path_sync_folder(save->path);
    }
    release(save);
    return status;
}

void sf_save_abort(sf_save *save)
{
    if (save != NULL) {
        release(save);
    }
}
