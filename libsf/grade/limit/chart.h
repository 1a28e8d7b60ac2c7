// SPDX-License-Identifier: MIT
// Which kind of ring each piece has, and of which points.

#ifndef SF_GRADE_LIMIT_CHART_H
#define SF_GRADE_LIMIT_CHART_H

#include "grade/limit/atlas.h"

typedef struct sfi_chart {
    sfi_atlas atlas;
    uint32_t pieces;
    uint32_t *kinds;  // of each piece
    uint32_t *across; // of each piece the ones across its sides, low and high by axis; SFI_NONE
    sfi_lists points; // of each piece the points of its ring, in the ring's order
    size_t item_capacity;
} sfi_chart;

// Chart the pieces of a complex of hexahedra or quadrilaterals, which is not needed afterwards.
// SF_ERR_MEMORY; SF_ERR_OVERFLOW; SF_ERR_CANCELLED.
sf_status sfi_chart_make(const sfi_complex *complex, int separable, const sf_allocator *allocator,
                         sf_task *task, sfi_chart *chart);
void sfi_chart_free(sfi_chart *chart);

// The values of a piece's ring: `width` for each of its points, out of those of all points.
void sfi_chart_gather(const sfi_chart *chart, uint32_t piece, uint32_t width, const double *values,
                      double *ring);

#endif
