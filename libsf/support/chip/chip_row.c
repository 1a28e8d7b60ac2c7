// SPDX-License-Identifier: MIT
// What a decoder hands over: runs and grey pixels of the row that it was asked for.
//
// Whatever a job's file says ends here, so this is where it is doubted: a run must not be empty,
// leave the row, or begin before the last one ends. What was wrong is kept, so that a decoder that
// does not look at what it is told cannot carry on.
//
// Freestanding.

#include "base/status.h"
#include "support/chip/chip.h"

static sf_status refuse(sf_chip *chip, sf_status status)
{
    if (chip->row_status == SF_OK) {
        chip->row_status = status;
    }
    return status;
}

sf_status sf_chip_solid(sf_chip *chip, uint32_t x0, uint32_t x1)
{
    if (chip == NULL || !chip->is_open) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(chip->row_status);
    if (x0 < chip->row_x || x0 >= x1 || x1 > chip->width) {
        return refuse(chip, SF_ERR_ARGUMENT);
    }
    chip->row_x = x1;
    if (sfi_chip_is_dense(chip)) {
        sfi_chip_dense_add(chip, x0, x1);
        return SF_OK;
    }
    sf_status status = sfi_chip_runs_add(chip, x0, x1);
    return status == SF_OK ? SF_OK : refuse(chip, status);
}

sf_status sf_chip_grey(sf_chip *chip, uint32_t x, const uint8_t *pixels, uint32_t count,
                       uint8_t threshold)
{
    if (chip == NULL || !chip->is_open) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(chip->row_status);
    if ((pixels == NULL && count > 0) || x < chip->row_x || x > chip->width ||
        count > chip->width - x) {
        return refuse(chip, SF_ERR_ARGUMENT);
    }
    for (uint32_t i = 0; i < count; i++) {
        uint32_t first = i;
        while (i < count && pixels[i] >= threshold) {
            i++;
        }
        if (i > first) {
            SF_TRY(sf_chip_solid(chip, x + first, x + i));
        }
    }
    return SF_OK;
}
