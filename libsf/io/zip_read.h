// SPDX-License-Identifier: MIT
// A zip archive in memory, read one entry at a time within bounds.
//
// The archive is read whole from its source, since its directory stands at its end. No name of an
// entry ever becomes a path: entries are looked up, never written. What unfolds is counted against
// the caller's bounds as it comes, whatever the directory claims; entries that overlap are refused.

#ifndef SF_IO_ZIP_READ_H
#define SF_IO_ZIP_READ_H

#include <sf/io.h>

typedef struct sfi_zip_state sfi_zip;
typedef struct sfi_zip_entry_state sfi_zip_entry;

// Read an archive of at most `bytes_max` bytes; its entries together unfold to no more than that.
sf_status sfi_zip_open(sf_source source, uint64_t bytes_max, const sf_allocator *allocator,
                       sfi_zip **zip, sf_fault *fault);
void sfi_zip_close(sfi_zip *zip);

// Begin to read the entry of that name; capitals count only where there is no other. SF_ERR_FORMAT
// where there is none, or more than one. It may unfold to `ratio` times its size in the archive and
// 1 MiB. One entry at a time.
sf_status sfi_zip_begin(sfi_zip *zip, const char *name, uint64_t ratio, sfi_zip_entry **entry,
                        sf_fault *fault);

// The next bytes of an entry; 0 at its end, where its checksum was found to be right.
sf_status sfi_zip_next(sfi_zip_entry *entry, void *data, size_t capacity, size_t *size,
                       sf_fault *fault);
void sfi_zip_end(sfi_zip_entry *entry);

#endif
