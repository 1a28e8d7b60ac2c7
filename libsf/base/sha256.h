// SPDX-License-Identifier: MIT
// SHA-256: a fingerprint of 32 bytes. Whoever finds two inputs with one fingerprint is the first.

#ifndef SF_BASE_SHA256_H
#define SF_BASE_SHA256_H

#include <stddef.h>
#include <stdint.h>

#define SFI_SHA256_SIZE 32

typedef struct sfi_sha256 {
    uint32_t state[8];
    uint64_t size; // bytes taken so far
    uint8_t block[64];
} sfi_sha256;

void sfi_sha256_begin(sfi_sha256 *hash);
void sfi_sha256_add(sfi_sha256 *hash, const void *data, size_t size);

// The fingerprint of all that was added. The hash must be begun anew after that.
void sfi_sha256_end(sfi_sha256 *hash, uint8_t digest[SFI_SHA256_SIZE]);

#endif
