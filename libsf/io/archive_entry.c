// SPDX-License-Identifier: MIT
// The bytes of one entry of a zip archive: as they are, or unfolded by zlib.
//
// No more comes out of an entry than its directory says, and a checksum is compared at its end.

#include "io/archive.h"

#include "base/memory.h"
#include "base/status.h"
#include "io/zlib_memory.h"

#if defined(SF_HAVE_ZLIB) || defined(SF_HAVE_THREEMF)

#include <stdio.h>
#include <string.h>
#include <zlib.h>

#define BLOCK 65536u
#define STEP_MAX (1u << 30) // what zlib counts in one go
enum { STORED = 0, DEFLATED = 8, ENCRYPTED = 1 };

struct sfi_archive_reader {
    sf_allocator allocator;
    const sfi_archive *archive;
    const sfi_archive_entry *entry;
    uint64_t taken; // packed bytes that were read
    uint64_t given; // bytes that came out
    uint32_t crc;
    int is_stream; // whether zlib is under way
    int end_seen;  // whether it has come to its end
    z_stream stream;
    unsigned char *block;
};

uint32_t sfi_archive_crc(uint32_t crc, const void *data, size_t size)
{
    const unsigned char *bytes = data;
    while (size > 0) {
        uInt step = size < (1u << 30) ? (uInt)size : 1u << 30;
        crc = (uint32_t)crc32(crc, bytes, step);
        bytes += step;
        size -= step;
    }
    return crc;
}

static sf_status read_packed(sfi_archive_reader *r, void *data, uint32_t size)
{
    const sf_bytes *bytes = &r->archive->bytes;
    SF_TRY(bytes->read_at(bytes->user, r->entry->data + r->taken, data, size));
    r->taken += size;
    return SF_OK;
}

// Packed bytes wait in the block, where the stream's input points.
static sf_status fill_block(sfi_archive_reader *r)
{
    uint64_t left = r->entry->packed - r->taken;
    uint32_t step = left < BLOCK ? (uint32_t)left : BLOCK;
    if (r->stream.avail_in == 0 && step > 0) {
        SF_TRY(read_packed(r, r->block, step));
        r->stream.next_in = r->block;
        r->stream.avail_in = step;
    }
    return SF_OK;
}

static sf_status copy_some(sfi_archive_reader *r, void *data, size_t capacity, size_t *size)
{
    SF_TRY(fill_block(r));
    *size = capacity < r->stream.avail_in ? capacity : r->stream.avail_in;
    memcpy(data, r->stream.next_in, *size);
    r->stream.next_in += *size;
    r->stream.avail_in -= (uInt)*size;
    return SF_OK;
}

static sf_status inflate_some(sfi_archive_reader *r, void *data, size_t capacity, size_t *size)
{
    r->stream.next_out = data;
    r->stream.avail_out = (uInt)capacity;
    while (r->stream.avail_out > 0) {
        SF_TRY(fill_block(r));
        int done = inflate(&r->stream, Z_NO_FLUSH);
        if (done == Z_STREAM_END) {
            r->end_seen = 1;
            break;
        }
        if (done == Z_MEM_ERROR) {
            return SF_ERR_MEMORY;
        }
        if (done != Z_OK) { // Z_BUF_ERROR too: there was room, so it is cut short
            return SF_ERR_FORMAT;
        }
    }
    *size = capacity - r->stream.avail_out;
    return SF_OK;
}

static sf_status next(void *user, void *data, size_t capacity, size_t *size)
{
    sfi_archive_reader *r = user;
    uint64_t left = r->entry->size - r->given;
    capacity = capacity < STEP_MAX ? capacity : STEP_MAX;
    capacity = capacity < left ? capacity : (size_t)left;
    *size = 0;
    if (capacity == 0) {
        return SF_OK;
    }
    SF_TRY(r->is_stream ? inflate_some(r, data, capacity, size)
                        : copy_some(r, data, capacity, size));
    r->crc = sfi_archive_crc(r->crc, data, *size);
    r->given += *size;
    return *size > 0 ? SF_OK : SF_ERR_FORMAT;
}

static sf_status about(const sfi_archive_reader *r, sf_status status, const char *sentence,
                       sf_fault *fault)
{
    int length = r->entry->name_size < 80 ? r->entry->name_size : 80;
    return sfi_fault_set(fault, status, 0, r->entry->begin, "%.*s: %s", length,
                         (const char *)r->archive->directory + r->entry->name, sentence);
}

static sf_status begin(sfi_archive_reader *r, sf_fault *fault)
{
    if ((r->entry->flags & ENCRYPTED) != 0) {
        return about(r, SF_ERR_UNSUPPORTED, "it is encrypted; save the file without a password",
                     fault);
    }
    if (r->entry->method == STORED && r->entry->packed != r->entry->size) {
        return about(r, SF_ERR_FORMAT, "it has two sizes; copy or export the file again", fault);
    }
    if (r->entry->method != STORED && r->entry->method != DEFLATED) {
        char sentence[96];
        snprintf(sentence, sizeof sentence, "it is packed by method %u, and only deflate is read",
                 (unsigned)r->entry->method);
        return about(r, SF_ERR_UNSUPPORTED, sentence, fault);
    }
    r->block = sfi_alloc_array(&r->allocator, BLOCK, 1);
    if (r->block == NULL) {
        return SF_ERR_MEMORY;
    }
    if (r->entry->method == STORED) {
        return SF_OK;
    }
    r->stream.zalloc = sfi_zlib_take;
    r->stream.zfree = sfi_zlib_give_back;
    r->stream.opaque = &r->allocator;
    if (inflateInit2(&r->stream, -15) != Z_OK) {
        return SF_ERR_MEMORY;
    }
    r->is_stream = 1;
    return SF_OK;
}

sf_status sfi_archive_begin(const sfi_archive *archive, size_t entry, sfi_archive_reader **reader,
                            sf_source *source, sf_fault *fault)
{
    sfi_archive_reader *r = sfi_alloc_array(&archive->allocator, 1, sizeof *r);
    if (r == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(r, 0, sizeof *r);
    r->allocator = archive->allocator;
    r->archive = archive;
    r->entry = &archive->entries[entry];
    sf_status status = begin(r, fault);
    if (status != SF_OK) {
        sfi_archive_end(r);
        return status;
    }
    sf_source made = {next, r};
    *source = made;
    *reader = r;
    return SF_OK;
}

// Whether what unfolds ends where the directory says; a reader that believes the stream would read
// on.
static sf_status check_end(sfi_archive_reader *r)
{
    unsigned char more;
    r->stream.next_out = &more;
    r->stream.avail_out = 1;
    for (int done = Z_OK; done != Z_STREAM_END;) {
        SF_TRY(fill_block(r));
        done = inflate(&r->stream, Z_NO_FLUSH);
        if ((done != Z_OK && done != Z_STREAM_END) || r->stream.avail_out == 0) {
            return done == Z_MEM_ERROR ? SF_ERR_MEMORY : SF_ERR_FORMAT;
        }
    }
    return SF_OK;
}

sf_status sfi_archive_finish(sfi_archive_reader *reader, uint64_t most, sf_fault *fault)
{
    unsigned char rest[4096];
    if (reader->entry->size - reader->given > most) {
        return about(reader, SF_ERR_FORMAT, "it holds more than belongs there", fault);
    }
    sf_status status = SF_OK;
    for (size_t got = 1; status == SF_OK && got > 0;) {
        status = next(reader, rest, sizeof rest, &got);
    }
    if (status == SF_OK && reader->is_stream && reader->end_seen == 0) {
        status = check_end(reader);
    }
    if (status != SF_OK) {
        return status == SF_ERR_FORMAT
                   ? about(reader, status, "it is damaged; copy or export the file again", fault)
                   : status;
    }
    return reader->crc == reader->entry->crc
               ? SF_OK
               : about(reader, SF_ERR_FORMAT,
                       "its checksum is wrong; copy or export the file again", fault);
}

void sfi_archive_end(sfi_archive_reader *reader)
{
    if (reader != NULL) {
        sf_allocator allocator = reader->allocator;
        if (reader->is_stream) {
            (void)inflateEnd(&reader->stream);
        }
        sfi_free_array(&allocator, reader->block, BLOCK, 1);
        sfi_free_array(&allocator, reader, 1, sizeof *reader);
    }
}

#endif
