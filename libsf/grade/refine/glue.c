// SPDX-License-Identifier: MIT
// Where a property is continuous, and where it jumps.
//
// A property may name values at the corners of cells. Two cells with a face in common that name the
// same values all around it are glued there; else the face is, for this property, boundary on both
// sides. Glued cells make a complex of their own, with the same cells and the same corners in the
// same order as the solid's, so that a place in a cell is the same place in both; but its boundary
// rules let the property end at the jump. (The two complexes are what the paper on graded objects
// asks for as future work.)
//
// Corners that meet in a point or an edge only are not glued, even if they name the same value:
// what could blend them would have to go through cells that disagree.

#include "grade/refine/glue.h"

#include "base/memory.h"
#include "base/status.h"
#include "grade/cage/joins.h"

#include <string.h>

// Cells in dimension 3, faces in dimension 2.
typedef struct tops {
    const sfi_lists *points;
    uint32_t count;
} tops;

static tops tops_of(const sfi_complex *c)
{
    tops t = {c->dimension == 3 ? &c->cell_points : &c->face_points,
              c->dimension == 3 ? c->cells : c->faces};
    return t;
}

static uint32_t corner_at(const tops *t, uint32_t cell, uint32_t point)
{
    uint32_t corner = t->points->starts[cell];
    while (t->points->items[corner] != point) {
        corner++;
    }
    return corner;
}

// Join the corners of two cells at the points that they share, if they agree at all of them.
static void join(const tops *t, const uint32_t cells[2], uint32_t count, const uint32_t *points,
                 const uint32_t *indices, uint32_t *roots)
{
    for (uint32_t i = 0; i < count; i++) {
        if (indices[corner_at(t, cells[0], points[i])] !=
            indices[corner_at(t, cells[1], points[i])]) {
            return;
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        sfi_joins_add(roots, corner_at(t, cells[0], points[i]), corner_at(t, cells[1], points[i]));
    }
}

static void join_cells(const sfi_complex *c, const tops *t, const uint32_t *indices,
                       uint32_t *roots)
{
    for (uint32_t f = 0; f < c->faces; f++) {
        const uint32_t *cells = c->face_cells + 2 * (size_t)f;
        if (cells[1] != SFI_NONE) {
            uint32_t start = c->face_points.starts[f];
            join(t, cells, c->face_points.starts[f + 1] - start, c->face_points.items + start,
                 indices, roots);
        }
    }
}

// `first` holds, for each edge, the first face seen to have it.
static void join_faces(const sfi_complex *c, const tops *t, const uint32_t *indices,
                       uint32_t *first, uint32_t *roots)
{
    memset(first, 0xff, c->edges * sizeof *first);
    for (uint32_t f = 0; f < c->faces; f++) {
        for (uint32_t i = c->face_points.starts[f]; i < c->face_points.starts[f + 1]; i++) {
            uint32_t edge = c->face_edges[i];
            uint32_t faces[2] = {first[edge], f};
            if (faces[0] == SFI_NONE) {
                first[edge] = f;
            } else {
                join(t, faces, 2, c->edge_points + 2 * (size_t)edge, indices, roots);
            }
        }
    }
}

// Number the sets by their first corners.
static uint32_t number_points(const uint32_t *indices, uint32_t corners, uint32_t *roots,
                              uint32_t *items, uint32_t *sources)
{
    uint32_t points = 0;
    for (uint32_t i = 0; i < corners; i++) {
        uint32_t root = sfi_joins_root(roots, i);
        if (root == i) {
            sources[points] = indices[i];
            items[i] = points++;
        } else {
            items[i] = items[root];
        }
    }
    return points;
}

sf_status sfi_glue_make(const sfi_complex *complex, const uint32_t *indices,
                        const sf_allocator *allocator, sfi_glue *glue)
{
    tops t = tops_of(complex);
    uint32_t corners = t.points->starts[t.count];
    sfi_glue made = {0, corners, NULL, NULL};
    made.items = sfi_alloc_array(allocator, corners, sizeof *made.items);
    made.sources = sfi_alloc_array(allocator, corners, sizeof *made.sources);
    uint32_t *roots = sfi_alloc_array(allocator, corners, sizeof *roots);
    uint32_t *first = sfi_alloc_array(allocator, complex->edges, sizeof *first);
    sf_status status = SF_ERR_MEMORY;
    if (made.items != NULL && made.sources != NULL && roots != NULL && first != NULL) {
        sfi_joins_begin(roots, corners);
        if (complex->dimension == 3) {
            join_cells(complex, &t, indices, roots);
        } else {
            join_faces(complex, &t, indices, first, roots);
        }
        made.points = number_points(indices, corners, roots, made.items, made.sources);
        status = SF_OK;
    }
    sfi_free_array(allocator, first, complex->edges, sizeof *first);
    sfi_free_array(allocator, roots, corners, sizeof *roots);
    if (status == SF_OK) {
        *glue = made;
    } else {
        sfi_glue_free(allocator, &made);
    }
    return status;
}

void sfi_glue_free(const sf_allocator *allocator, sfi_glue *glue)
{
    sfi_free_array(allocator, glue->items, glue->corners, sizeof *glue->items);
    sfi_free_array(allocator, glue->sources, glue->corners, sizeof *glue->sources);
    memset(glue, 0, sizeof *glue);
}

int sfi_glue_is_whole(const sfi_complex *complex, const sfi_glue *glue, uint32_t *sources)
{
    tops t = tops_of(complex);
    memset(sources, 0xff, complex->points * sizeof *sources);
    for (uint32_t i = 0; i < glue->corners; i++) {
        uint32_t *first = &sources[t.points->items[i]];
        if (*first != SFI_NONE && *first != glue->items[i]) {
            return 0;
        }
        *first = glue->items[i];
    }
    for (uint32_t v = 0; v < complex->points; v++) {
        sources[v] = sources[v] == SFI_NONE ? 0 : glue->sources[sources[v]];
    }
    return 1;
}

// Both complexes list the edges of a cell in the same order.
static void copy_sharpness(const sfi_complex *from, sfi_complex *to)
{
    tops a = tops_of(from), b = tops_of(to);
    for (uint32_t i = 0; i < a.points->starts[a.count]; i++) {
        to->point_sharpness[b.points->items[i]] = from->point_sharpness[a.points->items[i]];
    }
    uint32_t edges = from->dimension == 3 ? from->cell_edges.starts[from->cells]
                                          : from->face_points.starts[from->faces];
    for (uint32_t i = 0; i < edges; i++) {
        uint32_t x = from->dimension == 3 ? from->cell_edges.items[i] : from->face_edges[i];
        uint32_t y = to->dimension == 3 ? to->cell_edges.items[i] : to->face_edges[i];
        to->edge_sharpness[y] = from->edge_sharpness[x];
    }
}

sf_status sfi_glue_complex(const sfi_complex *complex, const sfi_glue *glue,
                           const sf_allocator *allocator, sfi_complex *glued)
{
    tops t = tops_of(complex);
    sfi_corners corners = {complex->dimension, glue->points, t.count, t.points->starts,
                           glue->items};
    SF_TRY(sfi_complex_build(&corners, allocator, glued, NULL));
    copy_sharpness(complex, glued);
    return SF_OK;
}
