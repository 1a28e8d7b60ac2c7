// SPDX-License-Identifier: MIT
// The directory of a zip archive, checked against the file before anything is read by it.
//
// The record that ends the archive must end the file, and the directory must end where that record
// begins; every entry must lie before the directory, whole, and none across another. So whatever a
// hostile directory says, no byte is read twice in the name of two entries, and all of them
// together are no larger than the file.

#include "io/archive.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

#define COMMENT_MAX 65535
#define ENTRIES_MAX 65534 // 65535 stands for an archive with sizes of 64 bits
enum { LOCAL = 0x04034b50, CENTRAL = 0x02014b50, END = 0x06054b50 };

static sf_status damaged(sf_fault *fault, uint64_t offset, const char *what)
{
    return sfi_fault_set(fault, SF_ERR_FORMAT, 0, offset,
                         "the archive is damaged: %s; copy it or export it again", what);
}

// ---------------------------------------------------------------------------------------------
// The end
// ---------------------------------------------------------------------------------------------

// Read the end of the file, at most what a comment can make of it, and find the record in it.
static sf_status find_end(sfi_archive *a, unsigned char *tail, size_t size, size_t *at,
                          sf_fault *fault)
{
    SF_TRY(a->bytes.read_at(a->bytes.user, a->bytes.size - size, tail, size));
    for (size_t i = size - SFI_ARCHIVE_END_SIZE + 1; i-- > 0;) {
        if (sfi_archive_u32(tail + i) == END &&
            sfi_archive_u16(tail + i + 20) == size - i - SFI_ARCHIVE_END_SIZE) {
            *at = i;
            return SF_OK;
        }
    }
    return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                         "this is no zip archive, or its end is missing; copy it or export it "
                         "again");
}

static sf_status read_end(sfi_archive *a, sf_fault *fault)
{
    size_t size = SFI_ARCHIVE_END_SIZE + COMMENT_MAX, at = 0;
    size = a->bytes.size < size ? (size_t)a->bytes.size : size;
    if (size < SFI_ARCHIVE_END_SIZE) {
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0, "the file is too short for an archive");
    }
    if (a->bytes.size > UINT32_MAX) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "archives of more than 4 GiB are not read");
    }
    unsigned char *tail = sfi_alloc_array(&a->allocator, size, 1);
    if (tail == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = find_end(a, tail, size, &at, fault);
    if (status == SF_OK) {
        const unsigned char *end = tail + at;
        uint64_t end_at = a->bytes.size - size + at;
        a->count = sfi_archive_u16(end + 10);
        a->directory_size = sfi_archive_u32(end + 12);
        a->directory_at = sfi_archive_u32(end + 16);
        a->end_size = size - at;
        if (a->count > ENTRIES_MAX || a->directory_at == UINT32_MAX) {
            status = sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, end_at,
                                   "archives with sizes of 64 bits are not read");
        } else if (sfi_archive_u16(end + 4) != 0 || sfi_archive_u16(end + 6) != 0 ||
                   sfi_archive_u16(end + 8) != a->count ||
                   a->directory_at + a->directory_size != end_at) {
            status = damaged(fault, end_at, "its directory does not lie where its end says");
        }
    }
    sfi_free_array(&a->allocator, tail, size, 1);
    return status;
}

// ---------------------------------------------------------------------------------------------
// The directory
// ---------------------------------------------------------------------------------------------

static sf_status parse_entry(sfi_archive *a, size_t i, size_t *at, sf_fault *fault)
{
    const unsigned char *record = a->directory + *at;
    sfi_archive_entry *e = &a->entries[i];
    size_t left = a->directory_size - *at;
    if (left < SFI_ARCHIVE_CENTRAL_SIZE || sfi_archive_u32(record) != CENTRAL) {
        return damaged(fault, a->directory_at + *at, "its directory is cut short");
    }
    uint32_t size = (uint32_t)SFI_ARCHIVE_CENTRAL_SIZE + sfi_archive_u16(record + 28) +
                    sfi_archive_u16(record + 30) + sfi_archive_u16(record + 32);
    if (size > left || size > UINT16_MAX) {
        return damaged(fault, a->directory_at + *at, "an entry of its directory is too long");
    }
    sfi_archive_entry made = {.central = *at,
                              .name = *at + SFI_ARCHIVE_CENTRAL_SIZE,
                              .flags = sfi_archive_u16(record + 8),
                              .method = sfi_archive_u16(record + 10),
                              .name_size = sfi_archive_u16(record + 28),
                              .central_size = (uint16_t)size,
                              .crc = sfi_archive_u32(record + 16),
                              .packed = sfi_archive_u32(record + 20),
                              .size = sfi_archive_u32(record + 24),
                              .begin = sfi_archive_u32(record + 42)};
    if (made.packed == UINT32_MAX || made.size == UINT32_MAX || made.begin == UINT32_MAX) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, a->directory_at + *at,
                             "archives with sizes of 64 bits are not read");
    }
    *e = made;
    *at += size;
    return SF_OK;
}

// Heapsort by place: J. W. J. Williams, "Algorithm 232", 1964.
static void sink(const sfi_archive *a, size_t at, size_t count)
{
    uint32_t held = a->order[at];
    for (size_t child; (child = 2 * at + 1) < count; at = child) {
        child += child + 1 < count &&
                 a->entries[a->order[child]].begin < a->entries[a->order[child + 1]].begin;
        if (a->entries[held].begin >= a->entries[a->order[child]].begin) {
            break;
        }
        a->order[at] = a->order[child];
    }
    a->order[at] = held;
}

static void sort(const sfi_archive *a)
{
    for (size_t i = a->count / 2; i-- > 0;) {
        sink(a, i, a->count);
    }
    for (size_t i = a->count; i-- > 1;) {
        uint32_t last = a->order[i];
        a->order[i] = a->order[0];
        a->order[0] = last;
        sink(a, 0, i);
    }
}

// Look at the head in front of an entry's bytes: it must be there and say the same name.
static sf_status check_local(sfi_archive *a, sfi_archive_entry *e, uint32_t end, sf_fault *fault)
{
    unsigned char head[SFI_ARCHIVE_LOCAL_SIZE], name[256];
    const unsigned char *expected = a->directory + e->name;
    if (end - e->begin < SFI_ARCHIVE_LOCAL_SIZE) {
        return damaged(fault, e->begin, "two entries overlap");
    }
    SF_TRY(a->bytes.read_at(a->bytes.user, e->begin, head, sizeof head));
    uint32_t room = end - e->begin - SFI_ARCHIVE_LOCAL_SIZE;
    uint32_t before = (uint32_t)sfi_archive_u16(head + 26) + sfi_archive_u16(head + 28);
    if (sfi_archive_u32(head) != LOCAL || sfi_archive_u16(head + 26) != e->name_size ||
        before > room || sfi_archive_u16(head + 8) != e->method) {
        return damaged(fault, e->begin, "an entry is not where its directory says");
    }
    e->data = e->begin + SFI_ARCHIVE_LOCAL_SIZE + before;
    e->end = end;
    if (e->packed > end - e->data) {
        return damaged(fault, e->begin, "two entries overlap");
    }
    for (uint32_t done = 0, step; done < e->name_size; done += step) {
        step = e->name_size - done < sizeof name ? e->name_size - done : (uint32_t)sizeof name;
        SF_TRY(
            a->bytes.read_at(a->bytes.user, e->begin + SFI_ARCHIVE_LOCAL_SIZE + done, name, step));
        if (memcmp(name, expected + done, step) != 0) {
            return damaged(fault, e->begin, "an entry has two names");
        }
    }
    return SF_OK;
}

static sf_status check_entries(sfi_archive *a, sf_fault *fault)
{
    for (size_t i = 0; i < a->count; i++) {
        a->order[i] = (uint32_t)i;
    }
    sort(a);
    uint64_t end = a->directory_at;
    for (size_t i = a->count; i-- > 0;) {
        sfi_archive_entry *e = &a->entries[a->order[i]];
        if (e->begin >= end) {
            return damaged(fault, e->begin, "two entries overlap");
        }
        SF_TRY(check_local(a, e, (uint32_t)end, fault));
        end = e->begin;
    }
    return SF_OK;
}

static sf_status read_directory(sfi_archive *a, sf_fault *fault)
{
    size_t at = 0, bytes = a->directory_size + a->end_size;
    // The directory's bytes lie in the file, and an entry takes 46 of them.
    if (a->count > a->directory_size / SFI_ARCHIVE_CENTRAL_SIZE) {
        return damaged(fault, a->directory_at, "its directory is cut short");
    }
    a->directory = sfi_alloc_array(&a->allocator, bytes, 1);
    if (a->count > 0) {
        a->entries = sfi_alloc_array(&a->allocator, a->count, sizeof *a->entries);
        a->order = sfi_alloc_array(&a->allocator, a->count, sizeof *a->order);
    }
    if (a->directory == NULL || (a->count > 0 && (a->entries == NULL || a->order == NULL))) {
        return SF_ERR_MEMORY;
    }
    SF_TRY(a->bytes.read_at(a->bytes.user, a->directory_at, a->directory, bytes));
    for (size_t i = 0; i < a->count; i++) {
        SF_TRY(parse_entry(a, i, &at, fault));
    }
    if (at != a->directory_size) {
        return damaged(fault, a->directory_at + at, "its directory holds more than its entries");
    }
    return check_entries(a, fault);
}

sf_status sfi_archive_open(sfi_archive *archive, sf_bytes bytes, const sf_allocator *allocator,
                           sf_fault *fault)
{
    archive->allocator = sfi_allocator_or_default(allocator);
    archive->bytes = bytes;
    sf_status status = read_end(archive, fault);
    if (status != SF_OK) {
        archive->count = archive->directory_size = archive->end_size = 0;
        return status;
    }
    return read_directory(archive, fault);
}

void sfi_archive_release(sfi_archive *a)
{
    sfi_free_array(&a->allocator, a->directory, a->directory_size + a->end_size, 1);
    sfi_free_array(&a->allocator, a->entries, a->count, sizeof *a->entries);
    sfi_free_array(&a->allocator, a->order, a->count, sizeof *a->order);
    a->directory = NULL;
    a->entries = NULL;
    a->order = NULL;
}

const char *sfi_archive_name(const sfi_archive *archive, size_t entry)
{
    return (const char *)archive->directory + archive->entries[entry].name;
}

int sfi_archive_is_named(const sfi_archive *archive, size_t entry, const char *name)
{
    size_t size = strlen(name);
    return archive->entries[entry].name_size == size &&
           memcmp(sfi_archive_name(archive, entry), name, size) == 0;
}
