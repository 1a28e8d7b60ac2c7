// SPDX-License-Identifier: MIT
// A zip archive out: records copied as they lie, and new ones, stored.

#ifndef SF_IO_ARCHIVE_WRITE_H
#define SF_IO_ARCHIVE_WRITE_H

#include "io/archive.h"

// An archive under way: bytes go to the sink, directory records wait in memory.
typedef struct sfi_archive_out {
    sf_allocator allocator;
    sf_sink sink;
    uint64_t at; // bytes written so far
    unsigned char *directory;
    size_t directory_size, directory_capacity;
    uint32_t count;
} sfi_archive_out;

// Bytes in memory that grow: a picture before its size and checksum are known.
typedef struct sfi_archive_blob {
    sf_allocator allocator;
    unsigned char *bytes;
    size_t size, capacity;
} sfi_archive_blob;

sf_sink sfi_archive_blob_sink(sfi_archive_blob *blob);
void sfi_archive_blob_release(sfi_archive_blob *blob);

// A new entry, stored, dated 1980. SF_ERR_OVERFLOW beyond 4 GiB.
sf_status sfi_archive_add(sfi_archive_out *out, const char *name, const void *data, size_t size);

// The directory and the end.
sf_status sfi_archive_close(sfi_archive_out *out);
void sfi_archive_out_release(sfi_archive_out *out);

// Write an archive again: entry `i` anew where `replace` leaves bytes in the blob, which is empty
// at first; else its record as it lies. So is all else: what lies before the first record, the
// order of both lists, comments.
typedef sf_status (*sfi_archive_replace)(void *user, size_t entry, sfi_archive_blob *blob);
sf_status sfi_archive_copy(const sfi_archive *archive, sf_sink sink, sfi_archive_replace replace,
                           void *user);

#endif
