// SPDX-License-Identifier: MIT
// Cleanup: what a result can be bettered by without thought.
//
// Put back. A drawn voxel that was given up may be carried by what was added for others. The trim
// of R and V together is the largest support-free set there is in them; it holds R, and all of V
// that R can carry, however high: one sweep.
//
// Take away. From the top down, an addition goes when each voxel that it could carry has another
// supporter, is exempt, or is gone. What then carried only it is looked at next, a layer below. In
// the end no addition can be taken away alone.
//
// Taking away is done where the rule is an element. Under slack a supporter gives reach to all that
// stands on it, however high; there the forest over the result itself (repair.c) takes away what
// nothing was hung on.

#include "support/repair/repair.h"

#include "base/status.h"
#include "support/check/row.h"
#include "support/repair/path.h"
#include "support/rule/carry.h"
#include "voxel/slice.h"

// Whether some voxel of `above` rests on (x, y) of `slice` alone.
static int is_needed(sf_slice slice, sf_slice above, sf_slice exempt, const sf_element *e,
                     uint32_t x, uint32_t y)
{
    for (uint32_t row = y > e->reach_y ? y - e->reach_y : 0;
         row < slice.height && row <= y + e->reach_y; row++) {
        uint32_t w = e->half_width[row > y ? row - y : y - row], end = x + w + 1;
        const uint64_t *words = sfi_slice_row(above, row);
        end = end < slice.width ? end : slice.width;
        for (uint32_t v = sfi_row_find(words, end, x > w ? x - w : 0, 0); v < end;
             v = sfi_row_find(words, end, v + 1, 0)) {
            int is_free = exempt.words != NULL && sf_slice_get(exempt, v, row);
            if (!is_free && !sfi_has_other(slice, e, v, row, x, y)) {
                return 1;
            }
        }
    }
    return 0;
}

// Take additions of one layer away.
static void thin_layer(sf_slice slice, sf_slice drawn, sf_slice above, sf_slice exempt,
                       const sf_element *e)
{
    for (uint32_t y = 0; y < slice.height; y++) {
        uint64_t *row = sfi_slice_row(slice, y);
        const uint64_t *given = sfi_slice_row(drawn, y);
        for (size_t i = 0; i < sfi_row_words(slice.width); i++) {
            for (uint64_t w = row[i] & ~given[i]; w != 0; w &= w - 1) {
                uint32_t x = (uint32_t)i * 64 + sfi_lowest_bit(w);
                if (!is_needed(slice, above, exempt, e, x, y)) {
                    row[i] &= ~(w & (~w + 1));
                }
            }
        }
    }
}

static sf_status take_away(const sfi_job *job, sf_grid *result)
{
    sf_element e = {0, {0}};
    sf_slice none = SFI_NO_SLICE;
    sfi_sweep sweep = sfi_sweep_begin(job->pace, job->lattice.nz - job->bed);
    for (uint32_t k = job->lattice.nz; k-- > job->bed;) {
        sf_slice slice = sf_grid_slice(result, k), drawn = sf_grid_slice(job->drawn, k);
        SF_TRY(sfi_sweep_layer(&sweep));
        if (k + 1 == job->lattice.nz) {
            SF_TRY(sf_slice_and(slice, slice, drawn));
            continue;
        }
        SF_TRY(sf_rule_element(&job->rule, k, &e));
        sf_slice exempt = job->exempt != NULL ? sf_grid_slice(job->exempt, k + 1) : none;
        thin_layer(slice, drawn, sf_grid_slice(result, k + 1), exempt, &e);
    }
    return SF_OK;
}

sf_status sfi_cleanup(const sfi_job *job, sf_grid *result)
{
    sf_terms terms = sfi_job_terms(job);
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(result, k);
        SF_TRY(sf_slice_or(slice, slice, sf_grid_slice(job->drawn, k)));
    }
    SF_TRY(
        sfi_trim_into(result, result, &terms, job->bed, job->allocator, sfi_pace_next(job->pace)));
    return sfi_rule_is_element(&job->rule) ? take_away(job, result) : SF_OK;
}
