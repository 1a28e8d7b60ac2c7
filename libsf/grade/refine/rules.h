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

// Add to an empty row what the point becomes that belongs to an element.
void sfi_rules_cell(const sfi_rules *rules, uint32_t cell, sfi_row *row);
void sfi_rules_face(const sfi_rules *rules, uint32_t face, sfi_row *row);
void sfi_rules_edge(const sfi_rules *rules, uint32_t edge, sfi_row *row);
void sfi_rules_point(const sfi_rules *rules, uint32_t point, sfi_row *row);

// The matrix of one step: rows for points, edges, faces and cells, in that order. SF_ERR_MEMORY;
// SF_ERR_OVERFLOW; SF_ERR_CANCELLED.
sf_status sfi_rules_matrix(const sfi_complex *complex, int separable, sf_task *task,
                           sfi_matrix *matrix);

#endif
