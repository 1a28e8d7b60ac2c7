// SPDX-License-Identifier: MIT
// A zip archive that is read where it lies and can be written again byte for byte.
//
// One directory is parsed, once, and everything else follows it: where an entry's record begins and
// ends, what is read of it, what is copied. Libraries for archives show no record as it lies, and
// read a byte in the name of two entries; so this reads what slicers make (stored and deflated
// entries, in one piece), and refuses all else with a sentence. Archives with sizes of 64 bits are
// read and said to be wide; they cannot be written again. Names never become paths.
//
// Source: PKWARE, "APPNOTE.TXT, .ZIP File Format Specification", version 6.3.

#ifndef SF_IO_ARCHIVE_H
#define SF_IO_ARCHIVE_H

#include <sf/job.h>

#define SFI_ARCHIVE_LOCAL_SIZE 30
#define SFI_ARCHIVE_CENTRAL_SIZE 46
#define SFI_ARCHIVE_END_SIZE 22
#define SFI_ARCHIVE_LOCATOR_SIZE 20
#define SFI_ARCHIVE_WIDE_END_SIZE 56

// One entry, as the directory has it.
typedef struct sfi_archive_entry {
    size_t central; // where its record begins in the directory
    size_t name;    // where its name does; it is not ended by a 0
    uint16_t flags, method, name_size, central_size;
    uint32_t crc;
    uint64_t packed, size;
    uint64_t begin, end; // its record in the file: up to the next one's, or to the directory
    uint64_t data;       // where its bytes begin
} sfi_archive_entry;

typedef struct sfi_archive {
    sf_allocator allocator;
    sf_bytes bytes;
    unsigned char *directory; // with what ends the archive behind it
    size_t directory_size, end_size;
    uint64_t directory_at;
    sfi_archive_entry *entries; // in the directory's order
    uint32_t *order;            // entries in the order in which they lie
    size_t count;
    int is_wide; // whether 32 bits do not hold its sizes, or are not used for them
} sfi_archive;

// Read the directory of an archive and look at every entry's head. Begin with zeros; release it
// whatever came of it.
sf_status sfi_archive_open(sfi_archive *archive, sf_bytes bytes, const sf_allocator *allocator,
                           sf_fault *fault);
void sfi_archive_release(sfi_archive *archive);

// The entry's name, and whether it is that text.
const char *sfi_archive_name(const sfi_archive *archive, size_t entry);
int sfi_archive_is_named(const sfi_archive *archive, size_t entry, const char *name);

// An entry being read; `reader` is the state behind the source, which the caller keeps.
typedef struct sfi_archive_reader sfi_archive_reader;
sf_status sfi_archive_begin(const sfi_archive *archive, size_t entry, sfi_archive_reader **reader,
                            sf_source *source, sf_fault *fault);

// Read what is left, at most `most` bytes, and compare size and checksum.
sf_status sfi_archive_finish(sfi_archive_reader *reader, uint64_t most, sf_fault *fault);
void sfi_archive_end(sfi_archive_reader *reader);

// Little-endian numbers.
static inline uint16_t sfi_archive_u16(const unsigned char *at)
{
    return (uint16_t)(at[0] | at[1] << 8);
}

static inline uint32_t sfi_archive_u32(const unsigned char *at)
{
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static inline uint64_t sfi_archive_u64(const unsigned char *at)
{
    return sfi_archive_u32(at) | (uint64_t)sfi_archive_u32(at + 4) << 32;
}

static inline void sfi_archive_put16(unsigned char *at, uint16_t value)
{
    at[0] = (unsigned char)value;
    at[1] = (unsigned char)(value >> 8);
}

static inline void sfi_archive_put32(unsigned char *at, uint32_t value)
{
    sfi_archive_put16(at, (uint16_t)value);
    sfi_archive_put16(at + 2, (uint16_t)(value >> 16));
}

uint32_t sfi_archive_crc(uint32_t crc, const void *data, size_t size);

#endif
