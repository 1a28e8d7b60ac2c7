// SPDX-License-Identifier: MIT
// Pieces of a ring.
//
// A ring is made a complex, and that is cut. At its rim the complex is not what the mesh was: cells
// are missing there. But each piece of the first cell depends on what touches the first cell only,
// and that is all there. What the rules would make of the rim is wrong, and never asked for.

#include "grade/limit/piece.h"

#include "base/memory.h"
#include "base/status.h"
#include "grade/refine/rules.h"

#include <string.h>

// ---------------------------------------------------------------------------------------------
// A ring as a complex
// ---------------------------------------------------------------------------------------------

static sf_status build(const sf_allocator *allocator, const sfi_ring *ring, sfi_complex *complex)
{
    uint32_t corners = 1u << ring->dimension;
    size_t count = (size_t)ring->cells * corners;
    uint32_t *starts = sfi_alloc_array(allocator, (size_t)ring->cells + 1, sizeof *starts);
    uint32_t *items = sfi_alloc_array(allocator, count, sizeof *items);
    sf_status status = SF_ERR_MEMORY;
    if (starts != NULL && items != NULL) {
        for (uint32_t i = 0; i <= ring->cells; i++) {
            starts[i] = corners * i;
        }
        for (size_t i = 0; i < count; i++) {
            size_t cell = i / corners * corners;
            items[i] = ring->items[cell + sfi_hex_bits((uint32_t)(i - cell))];
        }
        sfi_corners c = {ring->dimension, ring->points, ring->cells, starts, items};
        status = sfi_complex_build(&c, allocator, complex, NULL);
    }
    sfi_free_array(allocator, items, count, sizeof *items);
    sfi_free_array(allocator, starts, (size_t)ring->cells + 1, sizeof *starts);
    return status;
}

// Whether a face (in dimension 2 an edge) of a cell of the complex lies on the boundary of the
// mesh.
static int is_outside(const sfi_ring *ring, uint32_t cell, uint32_t side)
{
    static const uint8_t solid[6] = {4, 5, 2, 1, 3, 0}, flat[4] = {2, 1, 3, 0};
    return ring->outside[cell] >> (ring->dimension == 3 ? solid[side] : flat[side]) & 1;
}

// The rim is not boundary: a face there has its one cell on both sides, an edge is not open.
static void close_rim(const sfi_ring *ring, sfi_complex *c)
{
    for (uint32_t cell = 0; cell < ring->cells; cell++) {
        for (uint32_t side = 0; side < 2 * ring->dimension; side++) {
            if (c->dimension == 3) {
                size_t face = c->cell_faces.items[c->cell_faces.starts[cell] + side];
                if (c->face_cells[2 * face + 1] == SFI_NONE && !is_outside(ring, cell, side)) {
                    c->face_cells[2 * face + 1] = c->face_cells[2 * face];
                }
            } else if (!is_outside(ring, cell, side)) {
                c->edge_outside[c->face_edges[c->face_points.starts[cell] + side]] = 0;
            }
        }
    }
    if (c->dimension == 3) {
        memset(c->edge_outside, 0, c->edges);
        memset(c->point_outside, 0, c->points);
        sfi_complex_find_outside(c);
        return;
    }
    memset(c->point_outside, 0, c->points);
    for (size_t i = 0; i < 2 * (size_t)c->edges; i++) {
        c->point_outside[c->edge_points[i]] |= c->edge_outside[i / 2];
    }
}

static void sharpen(const sfi_ring *ring, sfi_complex *c)
{
    for (uint32_t i = 0; i < ring->sharps; i++) {
        const sfi_ring_sharp *s = &ring->sharp[i];
        if (s->a == s->b) {
            c->point_sharpness[s->a] = s->sharpness;
        }
        for (size_t e = 0; s->a != s->b && e < c->edges; e++) {
            const uint32_t *ends = c->edge_points + 2 * e;
            if ((ends[0] == s->a && ends[1] == s->b) || (ends[0] == s->b && ends[1] == s->a)) {
                c->edge_sharpness[e] = s->sharpness;
            }
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Its pieces
// ---------------------------------------------------------------------------------------------

// What it takes to cut a ring.
typedef struct cutter {
    sfi_complex whole, cut;
    sfi_rules rules;
    sfi_ring_finder finder;
    sfi_row row;
} cutter;

static void free_cutter(cutter *c)
{
    sfi_row_free(&c->row);
    sfi_ring_finder_free(&c->finder);
    sfi_rules_free(&c->rules);
    sfi_complex_free(&c->cut);
    sfi_complex_free(&c->whole);
}

static sf_status begin_cutter(const sfi_atlas *atlas, const sfi_ring *ring, cutter *c)
{
    const sf_allocator *allocator = &atlas->allocator;
    SF_TRY(build(allocator, ring, &c->whole));
    close_rim(ring, &c->whole);
    sharpen(ring, &c->whole);
    SF_TRY(sfi_complex_split(&c->whole, allocator, &c->cut));
    SF_TRY(sfi_rules_begin(&c->whole, atlas->separable, &c->rules));
    SF_TRY(sfi_ring_finder_begin(&c->cut, allocator, &c->finder));
    return sfi_row_begin(allocator, c->whole.points, &c->row) ? SF_OK : SF_ERR_MEMORY;
}

// The matrix whose rows are the points of the ring that was found last.
static sf_status make_matrix(cutter *c, sfi_matrix *matrix)
{
    const sfi_ring *ring = &c->finder.ring;
    sfi_matrix_maker maker;
    SF_TRY(sfi_matrix_begin(&c->whole.allocator, ring->points, c->whole.points, &maker));
    sf_status status = SF_OK;
    for (uint32_t i = 0; status == SF_OK && i < ring->points; i++) {
        sfi_row_clear(&c->row);
        sfi_rules_row(&c->rules, c->finder.points_at[i], &c->row);
        status = sfi_matrix_append(&maker, i, &c->row);
    }
    sfi_matrix_end(&maker, status == SF_OK ? matrix : NULL);
    return status;
}

static sf_status find_piece(sfi_atlas *atlas, uint32_t kind, uint32_t place, cutter *c)
{
    uint32_t child;
    SF_TRY(sfi_ring_find(&c->finder, sfi_hex_bits(place)));
    SF_TRY(make_matrix(c, &atlas->kinds[kind].steps[place]));
    SF_TRY(sfi_atlas_add(atlas, &c->finder.ring, &child)); // may move the kinds
    atlas->kinds[kind].children[place] = child;
    return SF_OK;
}

sf_status sfi_piece_find_all(sfi_atlas *atlas, uint32_t kind)
{
    cutter c;
    memset(&c, 0, sizeof c);
    sf_status status = begin_cutter(atlas, &atlas->kinds[kind].ring, &c);
    for (uint32_t place = 0; status == SF_OK && place < 1u << atlas->dimension; place++) {
        status = find_piece(atlas, kind, place, &c);
    }
    free_cutter(&c);
    return status;
}
