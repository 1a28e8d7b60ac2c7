// SPDX-License-Identifier: MIT
// A zip archive as a stream: entry after entry, then the directory.
//
// Nothing is held but the directory and the compressor, so that an archive of any size passes
// through. Sizes and checksums follow the bytes they are of. Equal contents are equal archives: no
// clock and no owner is in it.

#ifndef SF_IO_ZIP_WRITE_H
#define SF_IO_ZIP_WRITE_H

#include <sf/base.h>

typedef struct sfi_zip_out_state sfi_zip_out;

sf_status sfi_zip_out_create(sf_sink sink, const sf_allocator *allocator, sfi_zip_out **zip);

// Begin an entry; its bytes go to `entry`. Bytes that are compressed already (`is_dense`) are
// passed on as they are. SF_ERR_OVERFLOW where an archive without 64-bit sizes cannot hold it.
sf_status sfi_zip_out_begin(sfi_zip_out *zip, const char *name, int is_dense, sf_sink *entry);
sf_status sfi_zip_out_end(sfi_zip_out *zip);

// Write the directory. After it, or any failure, only destroying is left to do.
sf_status sfi_zip_out_finish(sfi_zip_out *zip);
void sfi_zip_out_destroy(sfi_zip_out *zip);

#endif
