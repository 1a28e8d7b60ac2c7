// SPDX-License-Identifier: MIT
// A zip archive as a stream, by zlib.
//
// Every entry is deflated, dense ones at level 0, so that readers that go front to back find its
// end.

#include "io/zip_write.h"

#include "base/memory.h"
#include "base/status.h"
#include "io/emitter.h"
#include "io/list.h"
#include "io/path.h"
#include "io/zlib_memory.h"

#ifdef SF_HAVE_THREEMF

#include <string.h>
#include <zlib.h>

enum { BLOCK = 16384, ENTRIES_MAX = 65534 };
enum { LOCAL = 0x04034b50, DESCRIPTOR = 0x08074b50, CENTRAL = 0x02014b50, END = 0x06054b50 };
enum { VERSION = 20, FLAGS = 0x0008, DEFLATED = 8, DATE = 0x0021 }; // the first day of 1980
static const uint64_t SIZE_MOST = UINT32_MAX - 1;

typedef struct entry {
    char *name;
    uint32_t crc, packed, size, offset;
} entry;

struct sfi_zip_out_state {
    sf_allocator allocator;
    sf_sink sink;
    sf_status status; // SF_OK, or what failed first
    uint64_t offset;  // bytes written so far
    sfi_list entries;
    z_stream stream;
    int is_open;
    uint64_t packed, size; // of the entry that is open
    uint32_t crc;
    unsigned char block[BLOCK];
};

// ---------------------------------------------------------------------------------------------
// Bytes
// ---------------------------------------------------------------------------------------------

static void hand_on(sfi_zip_out *zip, const void *data, size_t size)
{
    if (zip->status == SF_OK && zip->offset + size > SIZE_MOST) {
        zip->status = SF_ERR_OVERFLOW;
    }
    if (zip->status == SF_OK && size > 0) {
        zip->status = zip->sink.write(zip->sink.user, data, size);
        zip->offset += size;
    }
}

static sf_status pass(void *user, const void *data, size_t size)
{
    sfi_zip_out *zip = user;
    hand_on(zip, data, size);
    return zip->status;
}

static void emit_u16(sfi_emitter *out, unsigned value)
{
    const unsigned char bytes[2] = {(unsigned char)value, (unsigned char)(value >> 8)};
    sfi_emit_bytes(out, bytes, 2);
}

// Push what was given through the compressor; `how` is Z_NO_FLUSH or Z_FINISH.
static void squeeze(sfi_zip_out *zip, int how)
{
    int done = Z_OK;
    do {
        zip->stream.next_out = zip->block;
        zip->stream.avail_out = BLOCK;
        done = deflate(&zip->stream, how);
        size_t made = BLOCK - zip->stream.avail_out;
        if (done != Z_OK && done != Z_STREAM_END && done != Z_BUF_ERROR && zip->status == SF_OK) {
            zip->status = SF_ERR_INTERNAL;
        }
        zip->packed += made;
        hand_on(zip, zip->block, made);
    } while (zip->status == SF_OK &&
             (zip->stream.avail_out == 0 || (how == Z_FINISH && done != Z_STREAM_END)));
}

static sf_status write_entry(void *user, const void *data, size_t size)
{
    sfi_zip_out *zip = user;
    const unsigned char *bytes = data;
    while (size > 0 && zip->status == SF_OK) {
        uInt taken = size < (1u << 30) ? (uInt)size : 1u << 30;
        zip->crc = (uint32_t)crc32(zip->crc, bytes, taken);
        zip->size += taken;
        zip->stream.next_in = (unsigned char *)bytes;
        zip->stream.avail_in = taken;
        squeeze(zip, Z_NO_FLUSH);
        bytes += taken;
        size -= taken;
    }
    if (zip->size > SIZE_MOST && zip->status == SF_OK) {
        zip->status = SF_ERR_OVERFLOW;
    }
    return zip->status;
}

// ---------------------------------------------------------------------------------------------
// Archives
// ---------------------------------------------------------------------------------------------

sf_status sfi_zip_out_create(sf_sink sink, const sf_allocator *allocator, sfi_zip_out **zip)
{
    sf_allocator from = sfi_allocator_or_default(allocator);
    sfi_zip_out *made = sfi_alloc_array(&from, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = from;
    made->sink = sink;
    made->entries = sfi_list_of(sizeof(entry));
    *zip = made;
    return SF_OK;
}

static void emit_local(sfi_zip_out *zip, const char *name)
{
    sfi_emitter out;
    sf_sink sink = {pass, zip};
    sfi_emitter_begin(&out, sink);
    sfi_emit_u32(&out, LOCAL);
    emit_u16(&out, VERSION);
    emit_u16(&out, FLAGS);
    emit_u16(&out, DEFLATED);
    emit_u16(&out, 0);
    emit_u16(&out, DATE);
    for (int i = 0; i < 3; i++) { // checksum and sizes follow the bytes
        sfi_emit_u32(&out, 0);
    }
    emit_u16(&out, (unsigned)strlen(name));
    emit_u16(&out, 0);
    sfi_emit_text(&out, name);
    (void)sfi_emitter_end(&out);
}

static sf_status add_entry(sfi_zip_out *zip, const char *name)
{
    entry made = {sfi_path_join(&zip->allocator, name, 0, ""), 0, 0, 0, (uint32_t)zip->offset};
    if (made.name == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = sfi_list_push(&zip->allocator, &zip->entries, &made);
    if (status != SF_OK) {
        sfi_path_free(&zip->allocator, made.name);
    }
    return status;
}

sf_status sfi_zip_out_begin(sfi_zip_out *zip, const char *name, int is_dense, sf_sink *to)
{
    sf_sink sink = {write_entry, zip};
    if (zip->status == SF_OK && zip->entries.count >= ENTRIES_MAX) {
        zip->status = SF_ERR_OVERFLOW;
    }
    if (zip->status == SF_OK) {
        zip->status = add_entry(zip, name);
    }
    SF_TRY(zip->status);
    memset(&zip->stream, 0, sizeof zip->stream);
    zip->stream.zalloc = sfi_zlib_take;
    zip->stream.zfree = sfi_zlib_give_back;
    zip->stream.opaque = &zip->allocator;
    int made = deflateInit2(&zip->stream, is_dense ? 0 : 6, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY);
    if (made != Z_OK) {
        zip->status = made == Z_MEM_ERROR ? SF_ERR_MEMORY : SF_ERR_INTERNAL;
        return zip->status;
    }
    zip->is_open = 1;
    zip->packed = zip->size = 0;
    zip->crc = 0;
    emit_local(zip, name);
    *to = sink;
    return zip->status;
}

sf_status sfi_zip_out_end(sfi_zip_out *zip)
{
    sfi_emitter out;
    sf_sink sink = {pass, zip};
    entry *last = (entry *)zip->entries.items + zip->entries.count - 1;
    if (zip->status == SF_OK) {
        zip->stream.avail_in = 0;
        squeeze(zip, Z_FINISH);
    }
    (void)deflateEnd(&zip->stream);
    zip->is_open = 0;
    last->crc = zip->crc;
    last->packed = (uint32_t)zip->packed;
    last->size = (uint32_t)zip->size;
    sfi_emitter_begin(&out, sink);
    sfi_emit_u32(&out, DESCRIPTOR);
    sfi_emit_u32(&out, last->crc);
    sfi_emit_u32(&out, last->packed);
    sfi_emit_u32(&out, last->size);
    (void)sfi_emitter_end(&out);
    return zip->status;
}

static void emit_central(sfi_emitter *out, const entry *e)
{
    sfi_emit_u32(out, CENTRAL);
    emit_u16(out, VERSION);
    emit_u16(out, VERSION);
    emit_u16(out, FLAGS);
    emit_u16(out, DEFLATED);
    emit_u16(out, 0);
    emit_u16(out, DATE);
    sfi_emit_u32(out, e->crc);
    sfi_emit_u32(out, e->packed);
    sfi_emit_u32(out, e->size);
    emit_u16(out, (unsigned)strlen(e->name));
    for (int i = 0; i < 4; i++) { // extra fields, a comment, a disk, attributes
        emit_u16(out, 0);
    }
    sfi_emit_u32(out, 0);
    sfi_emit_u32(out, e->offset);
    sfi_emit_text(out, e->name);
}

sf_status sfi_zip_out_finish(sfi_zip_out *zip)
{
    sfi_emitter out;
    sf_sink sink = {pass, zip};
    const entry *entries = zip->entries.items;
    uint64_t begin = zip->offset, size = 0;
    sfi_emitter_begin(&out, sink);
    for (size_t i = 0; i < zip->entries.count; i++) {
        emit_central(&out, entries + i);
        size += 46 + strlen(entries[i].name);
    }
    sfi_emit_u32(&out, END);
    sfi_emit_u32(&out, 0);
    emit_u16(&out, (unsigned)zip->entries.count);
    emit_u16(&out, (unsigned)zip->entries.count);
    sfi_emit_u32(&out, (uint32_t)size);
    sfi_emit_u32(&out, (uint32_t)begin);
    emit_u16(&out, 0);
    (void)sfi_emitter_end(&out);
    return zip->status;
}

void sfi_zip_out_destroy(sfi_zip_out *zip)
{
    if (zip != NULL) {
        sf_allocator allocator = zip->allocator;
        entry *entries = zip->entries.items;
        if (zip->is_open) {
            (void)deflateEnd(&zip->stream);
        }
        for (size_t i = 0; i < zip->entries.count; i++) {
            sfi_path_free(&allocator, entries[i].name);
        }
        sfi_list_free(&allocator, &zip->entries);
        sfi_free_array(&allocator, zip, 1, sizeof *zip);
    }
}

#endif
