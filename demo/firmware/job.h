// SPDX-License-Identifier: MIT
// A job as the example firmware reads it: layers as runs, in a stream of bytes.
//
// This stands in for whatever format a printer has; what it shows is how such a format is decoded
// row by row, with a buffer of 64 bytes, by a function that trusts nothing it reads. All numbers
// are unsigned, in groups of seven bits, lowest first, where the highest bit of a byte says that
// more follow (LEB128).
//
//     "SFJOB1\n"   width   height   layers
//     then for each layer, from the bed up, for each row, from y = 0: a number of runs, and for
//     each of them the empty voxels before it and its length

#ifndef FIRMWARE_JOB_H
#define FIRMWARE_JOB_H

#include <sf/chip.h>

// Where a job is, and what its head says.
typedef struct job {
    // Stores the next bytes, at least one and at most `capacity`; 0: there are no more.
    size_t (*read)(void *user, uint8_t *bytes, size_t capacity);
    void *user;
    uint32_t width, height, layers;
    uint32_t used, filled;
    uint8_t bytes[64];
} job;

// Read the head: SF_ERR_FORMAT where it is none.
sf_status job_begin(job *job);

// Pass over a whole layer, for a job that is gone on with.
sf_status job_skip_layer(job *job);

// Decodes one row for sf_chip_push(); user is the job. SF_ERR_FORMAT: the bytes are no row.
sf_status job_decode(void *user, sf_chip *chip, uint32_t layer, uint32_t y);

#endif
