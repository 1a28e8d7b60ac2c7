// SPDX-License-Identifier: MIT
// The memory of a complex, and its boundary.

#include "grade/cage/complex.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

void sfi_complex_free(sfi_complex *complex)
{
    const sf_allocator *allocator = &complex->allocator;
    size_t edges = complex->edges, faces = complex->faces, points = complex->points;
    if (complex->face_points.starts != NULL) {
        sfi_free_array(allocator, complex->face_edges,
                       (size_t)complex->face_points.starts[faces] + 1, sizeof(uint32_t));
    }
    sfi_free_array(allocator, complex->edge_points, 2 * edges, sizeof(uint32_t));
    sfi_free_array(allocator, complex->face_cells, 2 * faces, sizeof(uint32_t));
    sfi_lists_free(allocator, complex->faces, &complex->face_points);
    sfi_lists_free(allocator, complex->cells, &complex->cell_points);
    sfi_lists_free(allocator, complex->cells, &complex->cell_faces);
    sfi_lists_free(allocator, complex->cells, &complex->cell_edges);
    sfi_free_array(allocator, complex->point_outside, points, 1);
    sfi_free_array(allocator, complex->edge_outside, edges, 1);
    sfi_free_array(allocator, complex->point_sharpness, points, sizeof(double));
    sfi_free_array(allocator, complex->edge_sharpness, edges, sizeof(double));
    sfi_free_array(allocator, complex->shapes, 1, sizeof *complex->shapes);
    memset(complex, 0, sizeof *complex);
}

static int alloc_arrays(sfi_complex *complex, size_t face_corners)
{
    const sf_allocator *allocator = &complex->allocator;
    size_t edges = complex->edges, faces = complex->faces, points = complex->points;
    complex->face_edges = sfi_alloc_array(allocator, face_corners + 1, sizeof(uint32_t));
    complex->edge_points = sfi_alloc_array(allocator, 2 * edges, sizeof(uint32_t));
    complex->face_cells = sfi_alloc_array(allocator, 2 * faces, sizeof(uint32_t));
    complex->point_outside = sfi_alloc_array(allocator, points, 1);
    complex->edge_outside = sfi_alloc_array(allocator, edges, 1);
    complex->point_sharpness = sfi_alloc_array(allocator, points, sizeof(double));
    complex->edge_sharpness = sfi_alloc_array(allocator, edges, sizeof(double));
    complex->shapes = sfi_alloc_array(allocator, 1, sizeof *complex->shapes);
    return complex->face_edges != NULL && complex->edge_points != NULL &&
           complex->face_cells != NULL && complex->point_outside != NULL &&
           complex->edge_outside != NULL && complex->point_sharpness != NULL &&
           complex->edge_sharpness != NULL && complex->shapes != NULL;
}

sf_status sfi_complex_alloc(sfi_complex *complex, size_t face_corners, size_t cell_corners,
                            size_t cell_faces, size_t cell_edges)
{
    const sf_allocator *allocator = &complex->allocator;
    if (!sfi_lists_alloc(allocator, complex->faces, face_corners, &complex->face_points) ||
        !sfi_lists_alloc(allocator, complex->cells, cell_corners, &complex->cell_points) ||
        !sfi_lists_alloc(allocator, complex->cells, cell_faces, &complex->cell_faces) ||
        !sfi_lists_alloc(allocator, complex->cells, cell_edges, &complex->cell_edges) ||
        !alloc_arrays(complex, face_corners)) {
        // Freed by the counts that it was taken by: face_edges goes with face_points.
        if (complex->face_points.starts == NULL) {
            complex->face_edges = NULL;
        }
        sfi_complex_free(complex);
        return SF_ERR_MEMORY;
    }
    memset(complex->face_cells, 0xff, 2 * (size_t)complex->faces * sizeof(uint32_t));
    memset(complex->point_outside, 0, complex->points);
    memset(complex->edge_outside, 0, complex->edges);
    memset(complex->shapes, 0, sizeof *complex->shapes);
    for (size_t i = 0; i < complex->points; i++) {
        complex->point_sharpness[i] = 0;
    }
    for (size_t i = 0; i < complex->edges; i++) {
        complex->edge_sharpness[i] = 0;
    }
    return SF_OK;
}

static void mark_edge(sfi_complex *complex, uint32_t edge)
{
    complex->edge_outside[edge] = 1;
    complex->point_outside[complex->edge_points[2 * (size_t)edge]] = 1;
    complex->point_outside[complex->edge_points[2 * (size_t)edge + 1]] = 1;
}

void sfi_complex_find_outside(sfi_complex *complex)
{
    const uint32_t *starts = complex->face_points.starts;
    if (complex->dimension == 3) {
        for (size_t f = 0; f < complex->faces; f++) {
            for (uint32_t i = starts[f];
                 complex->face_cells[2 * f + 1] == SFI_NONE && i < starts[f + 1]; i++) {
                mark_edge(complex, complex->face_edges[i]);
            }
        }
        return;
    }
    // Open is what an odd number of faces hold: one, for two is the most.
    for (uint32_t i = 0; i < starts[complex->faces]; i++) {
        complex->edge_outside[complex->face_edges[i]] ^= 1;
    }
    for (uint32_t e = 0; e < complex->edges; e++) {
        if (complex->edge_outside[e]) {
            mark_edge(complex, e);
        }
    }
}
