// SPDX-License-Identifier: MIT
// What hangs together at the points and edges of a complex.

#include "grade/refine/rules.h"

#include "base/status.h"

void sfi_rules_free(sfi_rules *rules)
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

sf_status sfi_rules_begin(const sfi_complex *complex, int separable, sfi_rules *rules)
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
        sfi_rules_free(&r);
    }
    return status;
}
