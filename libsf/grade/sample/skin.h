// SPDX-License-Identifier: MIT
// The outside of a limit as triangles.

#ifndef SF_GRADE_SAMPLE_SKIN_H
#define SF_GRADE_SAMPLE_SKIN_H

#include "grade/limit/limit.h"

#include <sf/mesh.h>

typedef struct sfi_skin {
    sf_allocator allocator;
    size_t vertex_count, triangle_count;
    double *vertices;    // mm
    uint32_t *triangles; // outwards
    double error_mm;     // no point of the shape's surface is farther from the triangles
} sfi_skin;

// Cut the sides of pieces that lie outside finely enough that no triangle is farther than
// `tolerance_mm` from the surface, or as finely as is served. SF_ERR_MEMORY; SF_ERR_OVERFLOW;
// SF_ERR_CANCELLED.
sf_status sfi_skin_make(const sf_limit *limit, double tolerance_mm, const sf_allocator *allocator,
                        sf_task *task, sfi_skin *skin);
void sfi_skin_free(sfi_skin *skin);

#endif
