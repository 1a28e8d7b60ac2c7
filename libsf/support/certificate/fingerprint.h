// SPDX-License-Identifier: MIT
// Fingerprints of grids, as a part of longer work.

#ifndef SF_SUPPORT_FINGERPRINT_H
#define SF_SUPPORT_FINGERPRINT_H

#include <sf/certificate.h>

#include "base/task.h"

// What sf_grid_sha256() does; progress goes from `done` of `total` onwards, one for each slice.
sf_status sfi_grid_sha256(const sf_grid *grid, sfi_progress *progress, uint64_t done,
                          uint64_t total, uint8_t digest[SF_SHA256_SIZE]);

#endif
