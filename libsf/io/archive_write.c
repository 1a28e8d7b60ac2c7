// SPDX-License-Identifier: MIT
// A zip archive out. An archive that is written again keeps every byte that does not have to
// change: records are copied from where one begins to where the next one does, with whatever stands
// between them, and so are directory records and the end, but for the places in the file. An entry
// that is replaced keeps its name, its extra fields, its date and attributes; it is stored, so size
// and checksum stand in front of it.
//
// Nothing here sees a compressor: pictures are compressed already.

#include "io/archive_write.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

#ifdef SF_HAVE_ZLIB

#define BLOCK 65536u
#define DATE 0x0021 // the first day of 1980
enum { LOCAL = 0x04034b50, CENTRAL = 0x02014b50, END = 0x06054b50, VERSION = 20 };

static sf_status add_bytes(void *user, const void *data, size_t size)
{
    sfi_archive_blob *blob = user;
    size_t need;
    if (!sfi_size_add(blob->size, size, &need) ||
        !sfi_grow_array(&blob->allocator, (void **)&blob->bytes, &blob->capacity, need, 1)) {
        return SF_ERR_MEMORY;
    }
    memcpy(blob->bytes + blob->size, data, size);
    blob->size = need;
    return SF_OK;
}

sf_sink sfi_archive_blob_sink(sfi_archive_blob *blob)
{
    sf_sink sink = {add_bytes, blob};
    return sink;
}

void sfi_archive_blob_release(sfi_archive_blob *blob)
{
    sfi_free_array(&blob->allocator, blob->bytes, blob->capacity, 1);
    blob->bytes = NULL;
    blob->size = blob->capacity = 0;
}

static sf_status write_bytes(sfi_archive_out *out, const void *data, uint64_t size)
{
    if (out->at + size >= UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    out->at += size;
    return size > 0 ? out->sink.write(out->sink.user, data, (size_t)size) : SF_OK;
}

static sf_status add_central(sfi_archive_out *out, const void *data, size_t size)
{
    size_t need;
    if (!sfi_size_add(out->directory_size, size, &need) ||
        !sfi_grow_array(&out->allocator, (void **)&out->directory, &out->directory_capacity, need,
                        1)) {
        return SF_ERR_MEMORY;
    }
    memcpy(out->directory + out->directory_size, data, size);
    out->directory_size = need;
    return SF_OK;
}

// What both records of an entry say of its bytes, from the place of the method on.
static void put_sizes(unsigned char *method, unsigned char *crc, uint32_t sum, uint32_t size)
{
    sfi_archive_put16(method, 0);
    sfi_archive_put32(crc, sum);
    sfi_archive_put32(crc + 4, size);
    sfi_archive_put32(crc + 8, size);
}

sf_status sfi_archive_add(sfi_archive_out *out, const char *name, const void *data, size_t size)
{
    unsigned char local[SFI_ARCHIVE_LOCAL_SIZE] = {0}, central[SFI_ARCHIVE_CENTRAL_SIZE] = {0};
    uint16_t length = (uint16_t)strlen(name);
    if (size >= UINT32_MAX || out->count == UINT16_MAX - 1) {
        return SF_ERR_OVERFLOW;
    }
    uint32_t sum = sfi_archive_crc(0, data, size), at = (uint32_t)out->at;
    sfi_archive_put32(local, LOCAL);
    sfi_archive_put16(local + 4, VERSION);
    sfi_archive_put16(local + 12, DATE);
    put_sizes(local + 8, local + 14, sum, (uint32_t)size);
    sfi_archive_put16(local + 26, length);
    sfi_archive_put32(central, CENTRAL);
    sfi_archive_put16(central + 4, VERSION);
    sfi_archive_put16(central + 6, VERSION);
    sfi_archive_put16(central + 14, DATE);
    put_sizes(central + 10, central + 16, sum, (uint32_t)size);
    sfi_archive_put16(central + 28, length);
    sfi_archive_put32(central + 42, at);
    SF_TRY(write_bytes(out, local, sizeof local));
    SF_TRY(write_bytes(out, name, length));
    SF_TRY(write_bytes(out, data, size));
    SF_TRY(add_central(out, central, sizeof central));
    SF_TRY(add_central(out, name, length));
    out->count++;
    return SF_OK;
}

sf_status sfi_archive_close(sfi_archive_out *out)
{
    unsigned char end[SFI_ARCHIVE_END_SIZE] = {0};
    sfi_archive_put32(end, END);
    sfi_archive_put16(end + 8, (uint16_t)out->count);
    sfi_archive_put16(end + 10, (uint16_t)out->count);
    sfi_archive_put32(end + 12, (uint32_t)out->directory_size);
    sfi_archive_put32(end + 16, (uint32_t)out->at);
    SF_TRY(write_bytes(out, out->directory, out->directory_size));
    return write_bytes(out, end, sizeof end);
}

void sfi_archive_out_release(sfi_archive_out *out)
{
    sfi_free_array(&out->allocator, out->directory, out->directory_capacity, 1);
    out->directory = NULL;
    out->directory_size = out->directory_capacity = 0;
}

// ---------------------------------------------------------------------------------------------
// Written again
// ---------------------------------------------------------------------------------------------

typedef struct copying {
    const sfi_archive *archive;
    sfi_archive_out out;
    unsigned char *directory; // a copy of the archive's, with its end, that is corrected
    unsigned char *block;
    sfi_archive_blob blob;
} copying;

static sf_status copy_range(copying *c, uint64_t from, uint64_t to)
{
    while (from < to) {
        size_t step = to - from < BLOCK ? (size_t)(to - from) : BLOCK;
        SF_TRY(c->archive->bytes.read_at(c->archive->bytes.user, from, c->block, step));
        SF_TRY(write_bytes(&c->out, c->block, step));
        from += step;
    }
    return SF_OK;
}

// A record with other bytes behind its head, which keeps name and extra fields.
static sf_status write_anew(copying *c, const sfi_archive_entry *e)
{
    unsigned char head[SFI_ARCHIVE_LOCAL_SIZE], *central = c->directory + e->central;
    if (c->blob.size >= UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    uint32_t size = (uint32_t)c->blob.size, sum = sfi_archive_crc(0, c->blob.bytes, size);
    SF_TRY(c->archive->bytes.read_at(c->archive->bytes.user, e->begin, head, sizeof head));
    uint16_t flags = (uint16_t)(sfi_archive_u16(head + 6) & ~0x0008u); // sizes stand in front
    sfi_archive_put16(head + 6, flags);
    put_sizes(head + 8, head + 14, sum, size);
    sfi_archive_put16(central + 8, (uint16_t)(e->flags & ~0x0008u));
    put_sizes(central + 10, central + 16, sum, size);
    SF_TRY(write_bytes(&c->out, head, sizeof head));
    SF_TRY(copy_range(c, e->begin + SFI_ARCHIVE_LOCAL_SIZE, e->data));
    return write_bytes(&c->out, c->blob.bytes, size);
}

static sf_status copy_entry(copying *c, size_t i, sfi_archive_replace replace, void *user)
{
    const sfi_archive_entry *e = &c->archive->entries[i];
    sfi_archive_put32(c->directory + e->central + 42, (uint32_t)c->out.at);
    c->blob.size = 0;
    SF_TRY(replace(user, i, &c->blob));
    return c->blob.size > 0 ? write_anew(c, e) : copy_range(c, e->begin, e->end);
}

static sf_status copy_all(copying *c, sfi_archive_replace replace, void *user)
{
    const sfi_archive *a = c->archive;
    size_t bytes = a->directory_size + a->end_size;
    memcpy(c->directory, a->directory, bytes);
    SF_TRY(copy_range(c, 0, a->count > 0 ? a->entries[a->order[0]].begin : a->directory_at));
    for (size_t i = 0; i < a->count; i++) {
        SF_TRY(copy_entry(c, a->order[i], replace, user));
    }
    sfi_archive_put32(c->directory + a->directory_size + 16, (uint32_t)c->out.at);
    return write_bytes(&c->out, c->directory, bytes);
}

sf_status sfi_archive_copy(const sfi_archive *archive, sf_sink sink, sfi_archive_replace replace,
                           void *user)
{
    const sf_allocator *a = &archive->allocator;
    size_t bytes = archive->directory_size + archive->end_size;
    copying c = {.archive = archive};
    c.out.sink = sink;
    c.out.allocator = c.blob.allocator = *a;
    c.directory = sfi_alloc_array(a, bytes, 1);
    c.block = sfi_alloc_array(a, BLOCK, 1);
    sf_status status =
        c.directory != NULL && c.block != NULL ? copy_all(&c, replace, user) : SF_ERR_MEMORY;
    sfi_archive_blob_release(&c.blob);
    sfi_free_array(a, c.block, BLOCK, 1);
    sfi_free_array(a, c.directory, bytes, 1);
    return status;
}

#endif
