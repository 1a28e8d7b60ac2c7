// SPDX-License-Identifier: MIT
// A zip archive in memory, by libzip.
//
// libzip takes its own memory from the C library. It is given bytes and never a path, so that it
// opens nothing. Only entries that are stored or deflated are read: other methods bring other
// decoders with them, and encryption a key that nobody has.

#include "io/zip_read.h"

#include "base/memory.h"
#include "base/status.h"
#include "io/path.h"

#ifdef SF_HAVE_THREEMF

#include <string.h>
#include <zip.h>

enum { BLOCK = 65536 };
static const uint64_t FREE_BYTES = 1048576; // what any entry may unfold to

struct sfi_zip_state {
    sf_allocator allocator;
    unsigned char *bytes;
    size_t size, capacity;
    zip_t *archive;
    uint64_t left; // bytes that may still unfold
    uint64_t bytes_max;
};

struct sfi_zip_entry_state {
    sfi_zip *zip;
    zip_file_t *file;
    char *name;
    uint64_t left; // bytes that it may still unfold to
    int at_end;
};

void sfi_zip_close(sfi_zip *zip)
{
    if (zip != NULL) {
        sf_allocator allocator = zip->allocator;
        if (zip->archive != NULL) {
            zip_discard(zip->archive);
        }
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

static sf_status open_archive(sfi_zip *zip, sf_fault *fault)
{
    zip_error_t why;
    zip_error_init(&why);
    zip_source_t *from = zip_source_buffer_create(zip->bytes, zip->size, 0, &why);
    if (from != NULL) {
        zip->archive = zip_open_from_source(from, ZIP_RDONLY, &why);
        if (zip->archive == NULL) {
            zip_source_free(from);
        }
    }
    int is_short = zip_error_code_zip(&why) == ZIP_ER_MEMORY;
    zip_error_fini(&why);
    if (zip->archive != NULL && zip->size > 0) { // libzip takes nothing for an empty archive
        return SF_OK;
    }
    return is_short ? SF_ERR_MEMORY
                    : sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                                    "this is no 3MF file or other zip archive, or its end is "
                                    "missing; copy or export it again");
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
    made->allocator = from;
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

static int lower(int c)
{
    return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c;
}

static int is_alike(const char *a, const char *b)
{
    while (*a != '\0' && lower(*a) == lower(*b)) {
        a++;
        b++;
    }
    return lower(*a) == lower(*b);
}

// Names are compared as those of packages are: capitals do not tell them apart.
static sf_status find(sfi_zip *zip, const char *name, zip_uint64_t *index, sf_fault *fault)
{
    zip_int64_t count = zip_get_num_entries(zip->archive, 0);
    unsigned found = 0;
    for (zip_int64_t i = 0; i < count; i++) {
        const char *other = zip_get_name(zip->archive, (zip_uint64_t)i, ZIP_FL_ENC_RAW);
        if (other != NULL && is_alike(name, other)) {
            *index = (zip_uint64_t)i;
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

static sf_status check(const sfi_zip *zip, const zip_stat_t *stat, const char *name,
                       sf_fault *fault)
{
    const zip_uint64_t need =
        ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD;
    if ((stat->valid & need) != need || stat->comp_size > zip->size) {
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                             "%.100s: the archive's directory is damaged", name);
    }
    if (stat->encryption_method != ZIP_EM_NONE) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "%.100s is encrypted; save the file without a password", name);
    }
    if (stat->comp_method != ZIP_CM_STORE && stat->comp_method != ZIP_CM_DEFLATE) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "%.100s is compressed by method %u, and only deflate is read", name,
                             (unsigned)stat->comp_method);
    }
    return SF_OK;
}

sf_status sfi_zip_begin(sfi_zip *zip, const char *name, uint64_t ratio, sfi_zip_entry **entry,
                        sf_fault *fault)
{
    zip_uint64_t index = 0;
    zip_stat_t stat;
    SF_TRY(find(zip, name, &index, fault));
    if (zip_stat_index(zip->archive, index, 0, &stat) != 0) {
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0, "%.100s cannot be found", name);
    }
    SF_TRY(check(zip, &stat, name, fault));
    sfi_zip_entry *made = sfi_alloc_array(&zip->allocator, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->zip = zip;
    made->left = stat.comp_size <= (UINT64_MAX - FREE_BYTES) / ratio
                     ? stat.comp_size * ratio + FREE_BYTES
                     : UINT64_MAX;
    made->name = sfi_path_join(&zip->allocator, name, 0, "");
    made->file = made->name != NULL ? zip_fopen_index(zip->archive, index, 0) : NULL;
    if (made->file == NULL) {
        int is_short =
            made->name == NULL || zip_error_code_zip(zip_get_error(zip->archive)) == ZIP_ER_MEMORY;
        sfi_zip_end(made);
        return is_short ? SF_ERR_MEMORY
                        : sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                                        "%.100s is damaged; copy or export the file again", name);
    }
    *entry = made;
    return SF_OK;
}

static sf_status too_large(const sfi_zip_entry *entry, sf_fault *fault)
{
    return entry->left < entry->zip->left
               ? sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                               "%.100s unfolds to more than a model does; this looks like an "
                               "attack",
                               entry->name)
               : sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                               "%.100s: the file unfolds to more than %llu bytes; raise bytes_max",
                               entry->name, (unsigned long long)entry->zip->bytes_max);
}

sf_status sfi_zip_next(sfi_zip_entry *entry, void *data, size_t capacity, size_t *size,
                       sf_fault *fault)
{
    *size = 0;
    if (entry->at_end) {
        return SF_OK;
    }
    zip_int64_t got = zip_fread(entry->file, data, capacity);
    if (got < 0) {
        int is_short = zip_error_code_zip(zip_file_get_error(entry->file)) == ZIP_ER_MEMORY;
        return is_short
                   ? SF_ERR_MEMORY
                   : sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                                   "%.100s is damaged; copy or export the file again", entry->name);
    }
    entry->at_end = got == 0;
    if ((uint64_t)got > entry->left || (uint64_t)got > entry->zip->left) {
        return too_large(entry, fault);
    }
    entry->left -= (uint64_t)got;
    entry->zip->left -= (uint64_t)got;
    *size = (size_t)got;
    return SF_OK;
}

void sfi_zip_end(sfi_zip_entry *entry)
{
    if (entry != NULL) {
        sf_allocator allocator = entry->zip->allocator;
        if (entry->file != NULL) {
            zip_fclose(entry->file);
        }
        sfi_path_free(&allocator, entry->name);
        sfi_free_array(&allocator, entry, 1, sizeof *entry);
    }
}

#endif
