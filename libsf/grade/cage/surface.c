// SPDX-License-Identifier: MIT
// A surface that meets itself is refused.
//
// Where more than two faces of the boundary meet in an edge, or two fans of them in a point, there
// is no smooth surface to converge to: the rules would pull apart what hangs together in name only.
// Corners of faces are joined across the edges that two faces share; a point all of whose corners
// are one set then has one fan.

#include "grade/cage/surface.h"

#include "base/memory.h"
#include "base/status.h"
#include "grade/cage/joins.h"

#include <string.h>

static uint32_t next_corner(const sfi_complex *c, uint32_t face, uint32_t corner)
{
    return corner + 1 < c->face_points.starts[face + 1] ? corner + 1 : c->face_points.starts[face];
}

static sf_status refuse_edge(const sfi_complex *c, uint32_t edge, sf_fault *fault)
{
    return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "the boundary meets itself in the edge of points %lu and %lu: more than "
                         "two of its faces hold it; move the parts that touch there apart, or "
                         "put the corners of a cell there in order",
                         (unsigned long)c->edge_points[2 * (size_t)edge],
                         (unsigned long)c->edge_points[2 * (size_t)edge + 1]);
}

// What has been seen of an edge: the corner where its first face goes along it, and that face.
typedef struct seen {
    uint32_t corner, face, count;
} seen;

static sf_status join_corners(const sfi_complex *c, seen *edges, uint32_t *roots, sf_fault *fault)
{
    for (uint32_t f = 0; f < c->faces; f++) {
        for (uint32_t i = c->face_points.starts[f];
             sfi_on_surface(c, f) && i < c->face_points.starts[f + 1]; i++) {
            uint32_t edge = c->face_edges[i];
            seen *s = &edges[edge];
            if (s->count++ == 0) {
                s->corner = i;
                s->face = f;
                continue;
            }
            if (s->count > 2) {
                return refuse_edge(c, edge, fault);
            }
            // The two go along the edge in opposite directions.
            sfi_joins_add(roots, i, next_corner(c, s->face, s->corner));
            sfi_joins_add(roots, next_corner(c, f, i), s->corner);
        }
    }
    return SF_OK;
}

static sf_status check_points(const sfi_complex *c, uint32_t *first, uint32_t *roots,
                              sf_fault *fault)
{
    memset(first, 0xff, c->points * sizeof *first);
    for (uint32_t f = 0; f < c->faces; f++) {
        for (uint32_t i = c->face_points.starts[f];
             sfi_on_surface(c, f) && i < c->face_points.starts[f + 1]; i++) {
            uint32_t point = c->face_points.items[i], root = sfi_joins_root(roots, i);
            if (first[point] == SFI_NONE) {
                first[point] = root;
            } else if (first[point] != root) {
                return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                                     "the boundary meets itself in point %lu: its faces there do "
                                     "not follow each other in one fan; give each part a point of "
                                     "its own",
                                     (unsigned long)point);
            }
        }
    }
    return SF_OK;
}

sf_status sfi_surface_check(const sfi_complex *complex, sf_fault *fault)
{
    const sf_allocator *allocator = &complex->allocator;
    uint32_t corners = complex->face_points.starts[complex->faces];
    seen *edges = sfi_alloc_array(allocator, complex->edges, sizeof *edges);
    uint32_t *roots = sfi_alloc_array(allocator, corners, sizeof *roots);
    uint32_t *first = sfi_alloc_array(allocator, complex->points, sizeof *first);
    sf_status status = SF_ERR_MEMORY;
    if (edges != NULL && roots != NULL && first != NULL) {
        memset(edges, 0, complex->edges * sizeof *edges);
        sfi_joins_begin(roots, corners);
        status = join_corners(complex, edges, roots, fault);
        if (status == SF_OK) {
            status = check_points(complex, first, roots, fault);
        }
    }
    sfi_free_array(allocator, first, complex->points, sizeof *first);
    sfi_free_array(allocator, roots, corners, sizeof *roots);
    sfi_free_array(allocator, edges, complex->edges, sizeof *edges);
    return status;
}
