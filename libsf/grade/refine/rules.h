// SPDX-License-Identifier: MIT
// The rules of Catmull-Clark subdivision as rows of weights.

#ifndef SF_GRADE_REFINE_RULES_H
#define SF_GRADE_REFINE_RULES_H

#include "grade/cage/complex.h"
#include "grade/refine/matrix.h"

// A complex, and what hangs together at its points and edges.
typedef struct sfi_rules {
    const sfi_complex *complex;
    int separable;         // the rule for extruded edges at the points that it is for
    sfi_lists point_edges; // of each point
    sfi_lists point_faces;
    sfi_lists point_cells;
    sfi_lists edge_faces; // of each edge
    sfi_lists edge_cells;
} sfi_rules;

// Look at a complex, which must stay as it is. SF_ERR_MEMORY.
sf_status sfi_rules_begin(const sfi_complex *complex, int separable, sfi_rules *rules);
void sfi_rules_free(sfi_rules *rules);

// Add to an empty row what a point of the next step comes of: points are those of points, edges,
// faces and cells, in that order.
void sfi_rules_row(const sfi_rules *rules, uint32_t point, sfi_row *row);

// The matrix of one step. SF_ERR_MEMORY;
// SF_ERR_OVERFLOW; SF_ERR_CANCELLED.
sf_status sfi_rules_matrix(const sfi_complex *complex, int separable, sf_task *task,
                           sfi_matrix *matrix);

#endif
