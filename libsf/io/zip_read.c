// SPDX-License-Identifier: MIT
// A zip archive in memory: the archive of archive.h over bytes that were read from a source.
//
// That reader has looked at every record before an entry is asked for, and refuses archives whose
// entries overlap. Here are the names of packages, in which capitals do not count, and bounds on
// what unfolds. A part is looked for by a sum over its name, so that many long names that begin in
// the same way cost no more than others.

#include "io/zip_read.h"

#include "base/memory.h"
#include "base/status.h"
#include "io/archive.h"

#ifdef SF_HAVE_THREEMF

#include <string.h>

enum { BLOCK = 65536 };
static const uint64_t FREE_BYTES = 1048576; // what any entry may unfold to

struct sfi_zip_state {
    sf_allocator allocator;
    unsigned char *bytes;
    size_t size, capacity;
    sfi_archive archive;
    uint64_t *sums; // over the entries' names
    uint64_t left;  // bytes that may still unfold
    uint64_t bytes_max;
};

struct sfi_zip_entry_state {
    sfi_zip *zip;
    sfi_archive_reader *reader;
    sf_source source;
    size_t entry;  // its number
    uint64_t left; // bytes that it may still unfold to
    int at_end;
};

void sfi_zip_close(sfi_zip *zip)
{
    if (zip != NULL) {
        sf_allocator allocator = zip->allocator;
        sfi_free_array(&allocator, zip->sums, zip->archive.count, sizeof *zip->sums);
        sfi_archive_release(&zip->archive);
        sfi_free_array(&allocator, zip->bytes, zip->capacity, 1);
        sfi_free_array(&allocator, zip, 1, sizeof *zip);
    }
}

static sf_status read_bytes(sfi_zip *zip, sf_source source, sf_fault *fault)
{
    for (size_t got = 1; got > 0; zip->size += got) {
        size_t need;
        if (!sfi_size_add(zip->size, BLOCK, &need) ||
            !sfi_grow_array(&zip->allocator, (void **)&zip->bytes, &zip->capacity, need, 1)) {
            return SF_ERR_MEMORY;
        }
        sf_status status = source.read(source.user, zip->bytes + zip->size, BLOCK, &got);
        status = status == SF_OK && got > BLOCK ? SF_ERR_IO : status; // a broken promise
        if (status != SF_OK && status != SF_ERR_OVERFLOW) {
            return sfi_fault_set(fault, status, 0, zip->size, "reading the file failed");
        }
        if (status != SF_OK || got > zip->bytes_max - zip->size) {
            return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                                 "the file is larger than %llu bytes; raise bytes_max",
                                 (unsigned long long)zip->bytes_max);
        }
    }
    return SF_OK;
}

static int lower(int c)
{
    return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c;
}

// FNV-1a, of letters without capitals: Fowler, Noll and Vo, 1991.
static uint64_t sum_of(const char *name, size_t size)
{
    uint64_t sum = UINT64_C(0xcbf29ce484222325);
    for (size_t i = 0; i < size; i++) {
        sum = (sum ^ (unsigned char)lower(name[i])) * UINT64_C(0x100000001b3);
    }
    return sum;
}

// What stands in memory, as the archive asks for it; it asks for nothing else.
static sf_status read_at(void *user, uint64_t offset, void *data, size_t size)
{
    const sfi_zip *zip = user;
    memcpy(data, zip->bytes + offset, size);
    return SF_OK;
}

static sf_status open_archive(sfi_zip *zip, sf_fault *fault)
{
    sf_bytes bytes = {read_at, zip->size, zip};
    SF_TRY(sfi_archive_open(&zip->archive, bytes, &zip->allocator, fault));
    size_t count = zip->archive.count;
    if (count == 0) {
        return SF_OK;
    }
    zip->sums = sfi_alloc_array(&zip->allocator, count, sizeof *zip->sums);
    if (zip->sums == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        zip->sums[i] =
            sum_of(sfi_archive_name(&zip->archive, i), zip->archive.entries[i].name_size);
    }
    return SF_OK;
}

sf_status sfi_zip_open(sf_source source, uint64_t bytes_max, const sf_allocator *allocator,
                       sfi_zip **zip, sf_fault *fault)
{
    sf_allocator from = sfi_allocator_or_default(allocator);
    sfi_zip *made = sfi_alloc_array(&from, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = made->archive.allocator = from;
    made->left = made->bytes_max = bytes_max;
    sf_status status = read_bytes(made, source, fault);
    if (status == SF_OK) {
        status = open_archive(made, fault);
    }
    if (status != SF_OK) {
        sfi_zip_close(made);
        return status;
    }
    *zip = made;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Entries
// ---------------------------------------------------------------------------------------------

static int is_alike(const char *a, const char *b, size_t size)
{
    size_t i = 0;
    while (i < size && lower(a[i]) == lower(b[i])) {
        i++;
    }
    return i == size;
}

// Names are compared as those of packages are: capitals do not tell them apart.
static sf_status find(const sfi_zip *zip, const char *name, size_t *entry, sf_fault *fault)
{
    size_t found = 0, size = strlen(name);
    uint64_t sum = sum_of(name, size);
    for (size_t i = 0; i < zip->archive.count; i++) {
        if (zip->sums[i] == sum && zip->archive.entries[i].name_size == size &&
            is_alike(name, sfi_archive_name(&zip->archive, i), size)) {
            *entry = i;
            found++;
        }
    }
    if (found == 1) {
        return SF_OK;
    }
    return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                         found == 0 ? "the archive has no part '%.100s'; export the file again"
                                    : "the archive has two parts '%.100s', which readers would "
                                      "take differently; export the file again",
                         name);
}

sf_status sfi_zip_begin(sfi_zip *zip, const char *name, uint64_t ratio, sfi_zip_entry **entry,
                        sf_fault *fault)
{
    size_t number = 0;
    SF_TRY(find(zip, name, &number, fault));
    sfi_zip_entry *made = sfi_alloc_array(&zip->allocator, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->zip = zip;
    made->entry = number;
    uint64_t packed = zip->archive.entries[number].packed; // no more than the file has
    made->left =
        packed <= (UINT64_MAX - FREE_BYTES) / ratio ? packed * ratio + FREE_BYTES : UINT64_MAX;
    sf_status status =
        sfi_archive_begin(&zip->archive, number, &made->reader, &made->source, fault);
    if (status != SF_OK) {
        sfi_zip_end(made);
        return status;
    }
    *entry = made;
    return SF_OK;
}

static sf_status refuse(const sfi_zip_entry *entry, sf_status status, const char *sentence,
                        sf_fault *fault)
{
    const sfi_archive *a = &entry->zip->archive;
    int size = a->entries[entry->entry].name_size < 100 ? a->entries[entry->entry].name_size : 100;
    return sfi_fault_set(fault, status, 0, 0, "%.*s%s", size, sfi_archive_name(a, entry->entry),
                         sentence);
}

static sf_status too_large(const sfi_zip_entry *entry, sf_fault *fault)
{
    return entry->left < entry->zip->left
               ? refuse(entry, SF_ERR_OVERFLOW,
                        " unfolds to more than a model does; this looks like an attack", fault)
               : sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                               "the file unfolds to more than %llu bytes; raise bytes_max",
                               (unsigned long long)entry->zip->bytes_max);
}

sf_status sfi_zip_next(sfi_zip_entry *entry, void *data, size_t capacity, size_t *size,
                       sf_fault *fault)
{
    size_t got = 0;
    *size = 0;
    if (entry->at_end) {
        return SF_OK;
    }
    sf_status status = entry->source.read(entry->source.user, data, capacity, &got);
    if (status != SF_OK) {
        return status == SF_ERR_FORMAT
                   ? refuse(entry, status, " is damaged; copy or export the file again", fault)
                   : status;
    }
    if (got > entry->left || got > entry->zip->left) {
        return too_large(entry, fault);
    }
    entry->at_end = got == 0;
    entry->left -= got;
    entry->zip->left -= got;
    *size = got;
    return entry->at_end ? sfi_archive_finish(entry->reader, 0, fault) : SF_OK;
}

void sfi_zip_end(sfi_zip_entry *entry)
{
    if (entry != NULL) {
        sf_allocator allocator = entry->zip->allocator;
        sfi_archive_end(entry->reader);
        sfi_free_array(&allocator, entry, 1, sizeof *entry);
    }
}

#endif
