// SPDX-License-Identifier: MIT
// A path turned into a source, or into bytes that can be read anywhere; and bytes of memory.

#include <sf/job.h>

#include "base/memory.h"
#include "base/status.h"
#include "io/disk.h"
#include "io/path.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

struct sf_file {
    sf_allocator allocator;
    FILE *stream;
};

sf_status sf_file_open(const char *path, const sf_allocator *allocator, sf_file **file,
                       sf_fault *fault)
{
    if (path == NULL || file == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no path, or no place for the file");
    }
    if (sfi_disk_look(path) == SFI_DISK_FOLDER) { // which some systems open all the same
        return sfi_path_fault(fault, "cannot open", path, EISDIR);
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_file *made = sfi_alloc_array(&from, 1, sizeof *made);
    if (made == NULL) {
        return sfi_fault_set(fault, SF_ERR_MEMORY, 0, 0, "there is not enough memory");
    }
    made->allocator = from;
    made->stream = fopen(path, "rb");
    if (made->stream == NULL) {
        int why = errno;
        sf_file_close(made);
        return sfi_path_fault(fault, "cannot open", path, why);
    }
    *file = made;
    return SF_OK;
}

static sf_status read_stream(void *user, void *data, size_t capacity, size_t *size)
{
    sf_file *file = user;
    *size = fread(data, 1, capacity, file->stream);
    return *size == 0 && ferror(file->stream) ? SF_ERR_IO : SF_OK;
}

sf_source sf_file_source(sf_file *file)
{
    sf_source source = {file != NULL ? read_stream : NULL, file};
    return source;
}

static sf_status read_at(void *user, uint64_t offset, void *data, size_t size)
{
    sf_file *file = user;
    if (sfi_disk_seek(file->stream, offset) != 0) {
        return SF_ERR_IO;
    }
    return fread(data, 1, size, file->stream) == size ? SF_OK : SF_ERR_IO;
}

sf_status sf_file_bytes(sf_file *file, sf_bytes *bytes, sf_fault *fault)
{
    uint64_t size = 0;
    if (file == NULL || bytes == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no file, or no place for its bytes");
    }
    if (sfi_disk_size(file->stream, &size) != 0) {
        return sfi_fault_set(fault, SF_ERR_IO, 0, 0,
                             "it is no ordinary file, which could be read at any place");
    }
    sf_bytes made = {read_at, size, file};
    *bytes = made;
    return SF_OK;
}

static sf_status copy_at(void *user, uint64_t offset, void *data, size_t size)
{
    const sf_memory_cursor *memory = user;
    if (size > memory->size || offset > memory->size - size) {
        return SF_ERR_IO;
    }
    memcpy(data, (const unsigned char *)memory->data + offset, size);
    return SF_OK;
}

sf_bytes sf_memory_bytes(sf_memory_cursor *memory)
{
    sf_bytes bytes = {copy_at, memory->size, memory};
    return bytes;
}

void sf_file_close(sf_file *file)
{
    if (file != NULL) {
        sf_allocator allocator = file->allocator;
        if (file->stream != NULL) {
            fclose(file->stream);
        }
        sfi_free_array(&allocator, file, 1, sizeof *file);
    }
}
