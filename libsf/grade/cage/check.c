// SPDX-License-Identifier: MIT
// What a cage is like: how it hangs together, and whether its cells are the right way out.
//
// A cell is inverted where, at a corner, its three edges do not span a positive volume in the order
// that its kind gives them. That is a matter of where points are, so it is looked at here and not
// when a cage is made: somebody who moves points may pass through such a state.

#include "grade/cage/cage.h"

#include "base/memory.h"
#include "base/status.h"
#include "grade/cage/joins.h"

#include <string.h>

static void edge_vector(const sf_cage *cage, uint32_t from, uint32_t to, double d[3])
{
    for (uint32_t axis = 0; axis < 3; axis++) {
        d[axis] = cage->positions[3 * (size_t)to + axis] - cage->positions[3 * (size_t)from + axis];
    }
}

static double determinant(const double a[3], const double b[3], const double c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// The corner of a cell at which it is inverted; its number of corners if there is none.
static uint32_t inverted_corner(const sf_cage *cage, uint32_t cell)
{
    const uint32_t *points = cage->corners + cage->starts[cell];
    const sfi_shape *shape =
        sfi_shapes_get(cage->complex.shapes, cage->starts[cell + 1] - cage->starts[cell]);
    for (uint32_t i = 0; i < shape->corners; i++) {
        double edges[3][3];
        for (uint32_t j = 0; j < 3; j++) {
            edge_vector(cage, points[i], points[shape->corner_ends[i][j]], edges[j]);
        }
        if (!(determinant(edges[0], edges[1], edges[2]) > 0)) {
            return i;
        }
    }
    return shape->corners;
}

static void check_cells(const sf_cage *cage, sf_cage_report *r, sf_fault *fault)
{
    r->first_inverted = cage->cells;
    for (uint32_t cell = 0; cage->complex.dimension == 3 && cell < cage->cells; cell++) {
        uint32_t corners = cage->starts[cell + 1] - cage->starts[cell];
        uint32_t corner = inverted_corner(cage, cell);
        if (corner == corners) {
            continue;
        }
        if (r->inverted_cells++ == 0) {
            r->first_inverted = cell;
            (void)sfi_fault_set(fault, SF_OK, 0, 0,
                                "cell %lu is inverted or flat at its corner %lu (point %lu)",
                                (unsigned long)cell, (unsigned long)corner,
                                (unsigned long)cage->corners[cage->starts[cell] + corner]);
        }
    }
}

// Volume by the boundary: each of its faces as a fan around its middle, which both cells of a face
// inside would share. Seen from a corner of a cell: a point that no cell uses may be anywhere.
static double volume(const sf_cage *cage)
{
    const sfi_complex *c = &cage->complex;
    uint32_t first = cage->corners[0];
    const double *origin = cage->positions + 3 * (size_t)first;
    double sum = 0;
    for (uint32_t f = 0; f < c->faces; f++) {
        uint32_t start = c->face_points.starts[f], end = c->face_points.starts[f + 1];
        double middle[3] = {0, 0, 0};
        for (uint32_t i = start; i < end; i++) {
            for (uint32_t axis = 0; axis < 3; axis++) {
                middle[axis] +=
                    (cage->positions[3 * (size_t)c->face_points.items[i] + axis] - origin[axis]) /
                    (end - start);
            }
        }
        for (uint32_t i = start; c->face_cells[2 * (size_t)f + 1] == SFI_NONE && i < end; i++) {
            uint32_t next = i + 1 < end ? i + 1 : start;
            double a[3], b[3];
            edge_vector(cage, first, c->face_points.items[i], a);
            edge_vector(cage, first, c->face_points.items[next], b);
            sum += determinant(a, b, middle) / 6;
        }
    }
    return sum;
}

static void count_surface(const sfi_complex *c, sf_cage_report *r)
{
    for (uint32_t f = 0; c->dimension == 3 && f < c->faces; f++) {
        r->boundary_faces += c->face_cells[2 * (size_t)f + 1] == SFI_NONE;
    }
    for (uint32_t e = 0; c->dimension == 2 && e < c->edges; e++) {
        r->boundary_faces += c->edge_outside[e];
    }
    for (uint32_t v = 0; v < c->points; v++) {
        r->boundary_points += c->point_outside[v];
    }
}

// Points and edges by how many cells (in dimension 2 faces) they have.
static void count_cells_of(const sfi_complex *c, uint32_t *uses, sf_cage_report *r)
{
    const sfi_lists *tops = c->dimension == 3 ? &c->cell_points : &c->face_points;
    uint32_t count = c->dimension == 3 ? c->cells : c->faces;
    uint32_t regular = c->dimension == 3 ? 8 : 4;
    memset(uses, 0, c->points * sizeof *uses);
    for (uint32_t i = 0; i < tops->starts[count]; i++) {
        uses[tops->items[i]]++;
    }
    for (uint32_t v = 0; v < c->points; v++) {
        r->loose_points += uses[v] == 0;
        r->irregular_points += uses[v] != 0 && uses[v] != regular && !c->point_outside[v];
    }
    if (c->dimension == 3) {
        memset(uses, 0, c->edges * sizeof *uses);
        for (uint32_t i = 0; i < c->cell_edges.starts[c->cells]; i++) {
            uses[c->cell_edges.items[i]]++;
        }
        for (uint32_t e = 0; e < c->edges; e++) {
            r->irregular_edges += uses[e] != 4 && !c->edge_outside[e];
        }
    }
}

static void count_components(const sfi_complex *c, uint32_t *roots, sf_cage_report *r)
{
    sfi_joins_begin(roots, c->points);
    for (uint32_t e = 0; e < c->edges; e++) {
        sfi_joins_add(roots, c->edge_points[2 * (size_t)e], c->edge_points[2 * (size_t)e + 1]);
    }
    for (uint32_t v = 0; v < c->points; v++) {
        r->components += roots[v] == v;
    }
    r->components -= r->loose_points;
}

sf_status sf_cage_check(const sf_cage *cage, const sf_allocator *allocator, sf_cage_report *report,
                        sf_fault *fault)
{
    if (cage == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    const sfi_complex *c = &cage->complex;
    sf_allocator kept = sfi_allocator_or_default(allocator);
    size_t count = c->edges > c->points ? c->edges : c->points;
    uint32_t *uses = sfi_alloc_array(&kept, count, sizeof *uses);
    if (uses == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_cage_report r;
    memset(&r, 0, sizeof r);
    count_surface(c, &r);
    count_cells_of(c, uses, &r);
    count_components(c, uses, &r);
    check_cells(cage, &r, fault);
    r.volume_mm3 = c->dimension == 3 ? volume(cage) : 0;
    sfi_free_array(&kept, uses, count, sizeof *uses);
    *report = r;
    return SF_OK;
}
