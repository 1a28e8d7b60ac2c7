// SPDX-License-Identifier: MIT
// The matrix of one step of subdivision.

#include "grade/refine/rules.h"

#include "base/status.h"
#include "base/task.h"

#include <string.h>

static void free_neighbours(sfi_rules *rules)
{
    const sfi_complex *c = rules->complex;
    if (c != NULL) {
        sfi_lists_free(&c->allocator, c->points, &rules->point_edges);
        sfi_lists_free(&c->allocator, c->points, &rules->point_faces);
        sfi_lists_free(&c->allocator, c->points, &rules->point_cells);
        sfi_lists_free(&c->allocator, c->edges, &rules->edge_faces);
        sfi_lists_free(&c->allocator, c->edges, &rules->edge_cells);
    }
}

// What hangs together at the points and edges of a complex, which must stay as it is.
static sf_status find_neighbours(const sfi_complex *complex, int separable, sfi_rules *rules)
{
    const sf_allocator *allocator = &complex->allocator;
    sfi_rules r = {complex, separable, {0}, {0}, {0}, {0}, {0}};
    sf_status status = sfi_pairs_turn(allocator, complex->edges, complex->edge_points,
                                      complex->points, &r.point_edges);
    if (status == SF_OK) {
        status = sfi_lists_turn(allocator, complex->faces, complex->face_points.starts,
                                complex->face_points.items, complex->points, &r.point_faces);
    }
    if (status == SF_OK) {
        status = sfi_lists_turn(allocator, complex->faces, complex->face_points.starts,
                                complex->face_edges, complex->edges, &r.edge_faces);
    }
    if (status == SF_OK && complex->dimension == 3) {
        status = sfi_lists_turn(allocator, complex->cells, complex->cell_points.starts,
                                complex->cell_points.items, complex->points, &r.point_cells);
    }
    if (status == SF_OK && complex->dimension == 3) {
        status = sfi_lists_turn(allocator, complex->cells, complex->cell_edges.starts,
                                complex->cell_edges.items, complex->edges, &r.edge_cells);
    }
    if (status == SF_OK) {
        *rules = r;
    } else {
        free_neighbours(&r);
    }
    return status;
}

typedef void rule(const sfi_rules *rules, uint32_t element, sfi_row *row);

static sf_status append(const sfi_rules *rules, rule *rule_of, uint32_t count, uint32_t first,
                        sf_task *task, sfi_row *row, sfi_matrix_maker *maker)
{
    for (uint32_t i = 0; i < count; i++) {
        if (i % 4096 == 0 && sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        sfi_row_clear(row);
        rule_of(rules, i, row);
        SF_TRY(sfi_matrix_append(maker, first + i, row));
    }
    return SF_OK;
}

static sf_status append_all(const sfi_rules *rules, sf_task *task, sfi_row *row,
                            sfi_matrix_maker *maker)
{
    const sfi_complex *c = rules->complex;
    uint32_t edges = c->points, faces = edges + c->edges, cells = faces + c->faces;
    SF_TRY(append(rules, sfi_rules_point, c->points, 0, task, row, maker));
    SF_TRY(append(rules, sfi_rules_edge, c->edges, edges, task, row, maker));
    SF_TRY(append(rules, sfi_rules_face, c->faces, faces, task, row, maker));
    return append(rules, sfi_rules_cell, c->cells, cells, task, row, maker);
}

sf_status sfi_rules_matrix(const sfi_complex *complex, int separable, sf_task *task,
                           sfi_matrix *matrix)
{
    const sf_allocator *allocator = &complex->allocator;
    uint32_t rows = sfi_complex_split_points(complex);
    if (rows == 0) {
        return SF_ERR_OVERFLOW;
    }
    sfi_rules rules = {0};
    sfi_row row = {0};
    sfi_matrix_maker maker = {0};
    sf_status status = find_neighbours(complex, separable, &rules);
    if (status == SF_OK && !sfi_row_begin(allocator, complex->points, &row)) {
        status = SF_ERR_MEMORY;
    }
    if (status == SF_OK) {
        status = sfi_matrix_begin(allocator, rows, complex->points, &maker);
    }
    if (status == SF_OK) {
        status = append_all(&rules, task, &row, &maker);
    }
    sfi_matrix_end(&maker, status == SF_OK ? matrix : NULL);
    sfi_row_free(&row);
    free_neighbours(&rules);
    return status;
}
