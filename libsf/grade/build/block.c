// SPDX-License-Identifier: MIT
// Blocks of hexahedra.

#include "grade/build/draft.h"

#include "base/status.h"

#include <math.h>

static int is_box(const double low[3], const double high[3])
{
    for (int axis = 0; axis < 3; axis++) {
        if (!(low[axis] < high[axis] && isfinite(low[axis]) && isfinite(high[axis]))) {
            return 0;
        }
    }
    return 1;
}

static void add_points(const uint32_t counts[3], const double low[3], const double high[3],
                       sfi_draft *draft)
{
    for (uint32_t k = 0; k <= counts[2]; k++) {
        for (uint32_t j = 0; j <= counts[1]; j++) {
            for (uint32_t i = 0; i <= counts[0] && draft->status == SF_OK; i++) {
                const uint32_t place[3] = {i, j, k};
                double at[3];
                for (int axis = 0; axis < 3; axis++) {
                    double t = (double)place[axis] / counts[axis];
                    at[axis] = (1 - t) * low[axis] + t * high[axis];
                }
                (void)sfi_draft_point(draft, at);
            }
        }
    }
}

static void add_cells(const uint32_t counts[3], sfi_draft *draft)
{
    uint32_t row = counts[0] + 1, layer = row * (counts[1] + 1);
    for (uint32_t k = 0; k < counts[2]; k++) {
        for (uint32_t j = 0; j < counts[1]; j++) {
            for (uint32_t i = 0; i < counts[0] && draft->status == SF_OK; i++) {
                uint32_t p = i + row * j + layer * k, q = p + layer;
                const uint32_t corners[8] = {p, p + 1, p + row + 1, p + row,
                                             q, q + 1, q + row + 1, q + row};
                sfi_draft_cell(draft, 8, corners);
            }
        }
    }
}

sf_status sf_cage_block(const uint32_t counts[3], const double low_mm[3], const double high_mm[3],
                        const sf_allocator *allocator, sf_cage **cage)
{
    if (counts == NULL || low_mm == NULL || high_mm == NULL || cage == NULL || counts[0] == 0 ||
        counts[1] == 0 || counts[2] == 0 || !is_box(low_mm, high_mm)) {
        return SF_ERR_ARGUMENT;
    }
    double corners = 8.0 * counts[0] * counts[1] * counts[2];
    if (corners > SF_CAGE_POINT_MAX) {
        return SF_ERR_OVERFLOW;
    }
    sfi_draft draft;
    sfi_draft_begin(allocator, &draft);
    add_points(counts, low_mm, high_mm, &draft);
    add_cells(counts, &draft);
    return sfi_draft_end(&draft, cage, NULL);
}
