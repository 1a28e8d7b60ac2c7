// SPDX-License-Identifier: MIT
// Decoding a job, row by row. Freestanding, as all that goes into a printer.

#include "job.h"

// The next byte, or -1 at the end.
static int next_byte(job *j)
{
    if (j->used == j->filled) {
        size_t size = j->read(j->user, j->bytes, sizeof j->bytes);
        if (size == 0 || size > sizeof j->bytes) {
            return -1;
        }
        j->used = 0;
        j->filled = (uint32_t)size;
    }
    return j->bytes[j->used++];
}

// The next number, below 2^28: more than any that a layer has.
static sf_status next_number(job *j, uint32_t *number)
{
    *number = 0;
    for (unsigned shift = 0; shift < 28; shift += 7) {
        int byte = next_byte(j);
        if (byte < 0) {
            return SF_ERR_FORMAT;
        }
        *number |= (uint32_t)(byte & 127) << shift;
        if (byte < 128) {
            return SF_OK;
        }
    }
    return SF_ERR_FORMAT;
}

sf_status job_begin(job *j)
{
    static const char magic[] = "SFJOB1\n";
    uint32_t *const numbers[3] = {&j->width, &j->height, &j->layers};
    j->used = j->filled = 0;
    for (int i = 0; magic[i] != '\0'; i++) {
        if (next_byte(j) != magic[i]) {
            return SF_ERR_FORMAT;
        }
    }
    for (int i = 0; i < 3; i++) {
        sf_status status = next_number(j, numbers[i]);
        if (status != SF_OK) {
            return status;
        }
    }
    return SF_OK;
}

// One row; without a checker it is passed over.
static sf_status next_row(job *j, sf_chip *chip)
{
    uint32_t count, gap, length, x = 0;
    sf_status status = next_number(j, &count);
    for (; status == SF_OK && count > 0; count--) {
        status = next_number(j, &gap);
        if (status == SF_OK) {
            status = next_number(j, &length);
        }
        if (status != SF_OK) {
            return status;
        }
        x += gap;
        if (x > j->width || length == 0 || length > j->width - x) {
            return SF_ERR_FORMAT;
        }
        if (chip != NULL) {
            status = sf_chip_solid(chip, x, x + length);
        }
        x += length;
    }
    return status;
}

sf_status job_skip_layer(job *j)
{
    sf_status status = SF_OK;
    for (uint32_t y = 0; status == SF_OK && y < j->height; y++) {
        status = next_row(j, NULL);
    }
    return status;
}

sf_status job_decode(void *user, sf_chip *chip, uint32_t layer, uint32_t y)
{
    (void)layer;
    (void)y;
    return next_row(user, chip);
}
