// SPDX-License-Identifier: MIT
// The directory of a zip archive, checked against the file before anything is read by it.
//
// The record that ends the archive must end the file, and the directory must end where that record
// begins, or where the one for sizes of 64 bits does; every entry must lie before the directory,
// whole, and none across another. So whatever a hostile directory says, no byte is read twice in
// the name of two entries, and all of them together are no larger than the file.

#include "io/archive.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

#define COMMENT_MAX 65535
#define ENTRIES_MAX 65534 // 65535 stands for an archive with sizes of 64 bits
enum { LOCAL = 0x04034b50, CENTRAL = 0x02014b50, END = 0x06054b50 };
enum { LOCATOR = 0x07064b50, WIDE_END = 0x06064b50, WIDE_FIELD = 0x0001 };

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
                         "this is no zip archive, such as a 3MF file or an SL1 job, or its end is "
                         "missing; copy it or export it again");
}

// A number of 32 bits or fewer, all of them set where only one of 64 bits can say it.
static int is_same(uint64_t narrow, uint64_t most, uint64_t wide)
{
    return narrow == wide || narrow == most;
}

// The record that says in 64 bits what `end` says, behind the directory; a locator between them
// says where. What the directory is said to be stays as it was when there is none.
static sf_status read_wide_end(sfi_archive *a, const unsigned char *end, uint64_t end_at,
                               sf_fault *fault)
{
    unsigned char locator[SFI_ARCHIVE_LOCATOR_SIZE], wide[SFI_ARCHIVE_WIDE_END_SIZE];
    if (end_at < sizeof locator + sizeof wide) {
        return SF_OK;
    }
    uint64_t locator_at = end_at - sizeof locator;
    SF_TRY(a->bytes.read_at(a->bytes.user, locator_at, locator, sizeof locator));
    uint64_t at = sfi_archive_u64(locator + 8);
    if (sfi_archive_u32(locator) != LOCATOR) {
        return SF_OK;
    }
    if (at > locator_at - sizeof wide) {
        return damaged(fault, locator_at, "its directory does not lie where its end says");
    }
    SF_TRY(a->bytes.read_at(a->bytes.user, at, wide, sizeof wide));
    uint64_t count = sfi_archive_u64(wide + 32), size = sfi_archive_u64(wide + 40);
    uint64_t directory_at = sfi_archive_u64(wide + 48);
    if (sfi_archive_u32(wide) != WIDE_END || sfi_archive_u64(wide + 4) != locator_at - at - 12 ||
        sfi_archive_u32(locator + 4) != 0 || sfi_archive_u32(wide + 16) != 0 ||
        sfi_archive_u32(wide + 20) != 0 || sfi_archive_u64(wide + 24) != count ||
        !is_same(a->count, UINT16_MAX, count) || !is_same(a->directory_size, UINT32_MAX, size) ||
        !is_same(a->directory_at, UINT32_MAX, directory_at) || size > at ||
        directory_at != at - size || !is_same(sfi_archive_u16(end + 8), UINT16_MAX, count)) {
        return damaged(fault, at, "its two ends say different things");
    }
    if (count > ENTRIES_MAX || size > SIZE_MAX - (a->bytes.size - at)) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, at,
                             "the archive has more than %d entries, or too many for this machine",
                             ENTRIES_MAX);
    }
    a->is_wide = 1;
    a->count = (size_t)count;
    a->directory_size = (size_t)size;
    a->directory_at = directory_at;
    a->end_size = (size_t)(a->bytes.size - at);
    return SF_OK;
}

// What the end says of the directory, which must lie right in front of it.
static sf_status parse_end(sfi_archive *a, const unsigned char *end, uint64_t end_at,
                           sf_fault *fault)
{
    a->count = sfi_archive_u16(end + 10);
    a->directory_size = sfi_archive_u32(end + 12);
    a->directory_at = sfi_archive_u32(end + 16);
    a->end_size = (size_t)(a->bytes.size - end_at);
    a->is_wide = 0;
    if (a->directory_at + a->directory_size != end_at) {
        SF_TRY(read_wide_end(a, end, end_at, fault));
    }
    if (!a->is_wide && (sfi_archive_u16(end + 8) != a->count || a->count > ENTRIES_MAX ||
                        a->directory_at + a->directory_size != end_at)) {
        return damaged(fault, end_at, "its directory does not lie where its end says");
    }
    if (sfi_archive_u16(end + 4) != 0 || sfi_archive_u16(end + 6) != 0) {
        return damaged(fault, end_at, "it is one of several pieces");
    }
    a->is_wide = a->is_wide || a->bytes.size > UINT32_MAX;
    return SF_OK;
}

static sf_status read_end(sfi_archive *a, sf_fault *fault)
{
    size_t size = SFI_ARCHIVE_END_SIZE + COMMENT_MAX, at = 0;
    size = a->bytes.size < size ? (size_t)a->bytes.size : size;
    if (size < SFI_ARCHIVE_END_SIZE) {
        return sfi_fault_set(
            fault, SF_ERR_FORMAT, 0, 0,
            "this is no zip archive, such as a 3MF file or an SL1 job: it is too short");
    }
    unsigned char *tail = sfi_alloc_array(&a->allocator, size, 1);
    if (tail == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = find_end(a, tail, size, &at, fault);
    if (status == SF_OK) {
        status = parse_end(a, tail + at, a->bytes.size - size + at, fault);
    }
    sfi_free_array(&a->allocator, tail, size, 1);
    return status;
}

// ---------------------------------------------------------------------------------------------
// The directory
// ---------------------------------------------------------------------------------------------

// Sizes and place in 64 bits, for those that 32 do not say: a field behind the name has them, in
// this order.
static int read_wide_field(sfi_archive *a, const unsigned char *record, sfi_archive_entry *e)
{
    uint64_t *const numbers[3] = {&e->size, &e->packed, &e->begin};
    const unsigned char *at = record + SFI_ARCHIVE_CENTRAL_SIZE + e->name_size;
    size_t left = sfi_archive_u16(record + 30), need = 0;
    for (int i = 0; i < 3; i++) {
        need += *numbers[i] == UINT32_MAX ? 8 : 0;
    }
    if (need == 0) {
        return 1;
    }
    a->is_wide = 1;
    while (left >= 4) {
        size_t size = sfi_archive_u16(at + 2);
        if (size > left - 4) {
            return 0;
        }
        if (sfi_archive_u16(at) == WIDE_FIELD) {
            const unsigned char *next = at + 4;
            for (int i = 0; size >= need && i < 3; i++) {
                if (*numbers[i] == UINT32_MAX) {
                    *numbers[i] = sfi_archive_u64(next);
                    next += 8;
                }
            }
            return size >= need;
        }
        at += 4 + size;
        left -= 4 + size;
    }
    return 0;
}

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
    if (!read_wide_field(a, record, &made)) {
        return damaged(fault, a->directory_at + *at, "an entry has no size");
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
static sf_status check_local(sfi_archive *a, sfi_archive_entry *e, uint64_t end, sf_fault *fault)
{
    unsigned char head[SFI_ARCHIVE_LOCAL_SIZE], name[256];
    const unsigned char *expected = a->directory + e->name;
    if (end - e->begin < SFI_ARCHIVE_LOCAL_SIZE) {
        return damaged(fault, e->begin, "two entries overlap");
    }
    SF_TRY(a->bytes.read_at(a->bytes.user, e->begin, head, sizeof head));
    uint64_t room = end - e->begin - SFI_ARCHIVE_LOCAL_SIZE;
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
        SF_TRY(check_local(a, e, end, fault));
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
