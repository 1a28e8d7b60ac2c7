// SPDX-License-Identifier: MIT
// Pieces of the solid that no handle holds: each has, as one, the weights of the point of the other
// pieces that is closest to the middle of one of its cells.
//
// There may be as many of them as cells, so nothing here goes over all cells for each. The square
// of the distance from the middle of a cell to a box is a sum over the axes of squared gaps, so
// that the closest of many boxes is found one axis after the other, as a least sum with what it
// belongs to: along x for rows that hold a cell with weights, along y for what that reached, along
// z for cells of loose pieces only. A line is looked along outwards, only as far as the gap alone
// is no larger than what was found. Of boxes that are as close the last in (z, y, x) order counts,
// as it does for sfi_domain_search().
//
// Source: for points, T. Saito, J. Toriwaki, "New algorithms for Euclidean distance transformation
// of an n-dimensional digitized picture with applications", 1994.

#include "balance/handle/weights_loose.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <math.h>
#include <string.h>

// The closest cell with weights, as far as is known, and the square of its distance.
typedef struct nearest {
    double square;
    uint32_t cell; // SFI_NO_CELL: none yet
    uint32_t from; // of a piece: the cell of its own that is so close
} nearest;

static const nearest nothing = {INFINITY, SFI_NO_CELL, SFI_NO_CELL};

typedef struct survey {
    const sfi_domain *domain;
    nearest *box;   // of each place of the box
    nearest *line;  // one line of it
    nearest *piece; // of each piece
    uint32_t *node; // first node of each piece
    size_t longest, pieces;
} survey;

static int is_closer(const nearest *a, const nearest *b)
{
    return a->square < b->square || (a->square == b->square && a->cell != SFI_NO_CELL &&
                                     (b->cell == SFI_NO_CELL || a->cell > b->cell));
}

// Square of the gap between the middle of interval i and interval k.
static double gap(const double *plane, size_t i, size_t k)
{
    double middle = 0.5 * (plane[i] + plane[i + 1]);
    double by = i == k ? 0 : k > i ? plane[k] - middle : middle - plane[k + 1];
    return by * by;
}

static void look_at(const double *plane, size_t i, size_t k, const nearest *there, nearest *best)
{
    nearest found = {gap(plane, i, k) + there->square, there->cell, SFI_NO_CELL};
    if (there->cell != SFI_NO_CELL && is_closer(&found, best)) {
        *best = found;
    }
}

// The closest for place i of a line, whose places lie `stride` apart.
static nearest look_along(const double *plane, size_t count, const nearest *line, size_t stride,
                          size_t i)
{
    nearest best = line[i * stride];
    for (size_t k = i + 1; k < count && gap(plane, i, k) <= best.square; k++) {
        look_at(plane, i, k, &line[k * stride], &best);
    }
    for (size_t k = i; k-- > 0 && gap(plane, i, k) <= best.square;) {
        look_at(plane, i, k, &line[k * stride], &best);
    }
    return best;
}

// All places of one line, where any knows anything.
static void settle_line(const survey *s, int axis, nearest *line, size_t stride)
{
    size_t count = s->domain->cells[axis];
    int any = 0;
    for (size_t i = 0; i < count; i++) {
        s->line[i] = line[i * stride];
        any |= s->line[i].cell != SFI_NO_CELL;
    }
    for (size_t i = 0; any && i < count; i++) {
        line[i * stride] = look_along(s->domain->planes[axis], count, s->line, 1, i);
    }
}

static void settle_slabs(const survey *s, const uint8_t *skip)
{
    const sfi_domain *d = s->domain;
    size_t row = d->cells[0], slab = row * d->cells[1];
    for (size_t i = 0; i < d->box_count; i++) {
        uint32_t cell = d->cell_at[i];
        nearest here = {0, cell, SFI_NO_CELL};
        s->box[i] = cell != SFI_NO_CELL && !skip[cell] ? here : nothing;
    }
    for (size_t k = 0; k < d->cells[2]; k++) {
        for (size_t j = 0; j < d->cells[1]; j++) {
            settle_line(s, 0, s->box + k * slab + j * row, 1);
        }
        for (size_t i = 0; i < row; i++) {
            settle_line(s, 1, s->box + k * slab + i, row);
        }
    }
}

// Of each piece the first of its cells that is closest.
static void settle_pieces(const survey *s, const uint8_t *skip, const uint32_t *piece)
{
    const sfi_domain *d = s->domain;
    size_t slab = (size_t)d->cells[0] * d->cells[1];
    for (size_t p = 0; p < s->pieces; p++) {
        s->piece[p] = nothing;
        s->node[p] = UINT32_MAX;
    }
    for (uint32_t cell = 0; cell < d->cell_count; cell++) {
        if (skip[cell]) {
            const uint32_t *at = d->place + 3 * (size_t)cell;
            nearest *best = &s->piece[piece[d->corners[8 * (size_t)cell]]];
            nearest found = look_along(d->planes[2], d->cells[2],
                                       s->box + (size_t)at[1] * d->cells[0] + at[0], slab, at[2]);
            found.from = cell;
            *best = found.square < best->square ? found : *best;
        }
    }
}

static void write_weights(const survey *s, const uint8_t *owner, const uint32_t *piece,
                          sf_weights *weights)
{
    for (size_t i = 0; i < s->domain->node_count; i++) {
        double *w = weights->values + i * weights->count;
        if (owner[i] != SFI_NODE_LOOSE) {
            continue;
        }
        uint32_t *first = &s->node[piece[i]];
        if (*first == UINT32_MAX) {
            const nearest *n = &s->piece[piece[i]];
            double middle[3];
            sfi_domain_middle(s->domain, n->from, middle);
            sfi_spot spot = sfi_domain_spot(s->domain, middle, n->cell);
            sfi_weights_at(weights, &spot, w, NULL);
            *first = (uint32_t)i;
        } else {
            memcpy(w, weights->values + *first * weights->count, weights->count * sizeof *w);
        }
    }
}

static sf_status reserve(survey *s, const uint32_t *piece, const sf_allocator *allocator)
{
    const sfi_domain *d = s->domain;
    for (int axis = 0; axis < 3; axis++) {
        s->longest = d->cells[axis] > s->longest ? d->cells[axis] : s->longest;
    }
    for (size_t i = 0; i < d->node_count; i++) {
        s->pieces = piece[i] >= s->pieces ? (size_t)piece[i] + 1 : s->pieces;
    }
    s->box = sfi_alloc_array(allocator, d->box_count, sizeof *s->box);
    s->line = sfi_alloc_array(allocator, s->longest, sizeof *s->line);
    s->piece = sfi_alloc_array(allocator, s->pieces, sizeof *s->piece);
    s->node = sfi_alloc_array(allocator, s->pieces, sizeof *s->node);
    int all = s->box != NULL && s->line != NULL && s->piece != NULL && s->node != NULL;
    return all ? SF_OK : SF_ERR_MEMORY;
}

sf_status sfi_loose_settle(const uint8_t *owner, const uint32_t *piece,
                           const sf_allocator *allocator, sf_weights *weights)
{
    const sfi_domain *d = &weights->domain;
    survey s = {.domain = d};
    uint8_t *skip = sfi_alloc_array(allocator, d->cell_count, sizeof *skip);
    sf_status status = skip != NULL ? reserve(&s, piece, allocator) : SF_ERR_MEMORY;
    if (status == SF_OK) {
        for (size_t c = 0; c < d->cell_count; c++) {
            skip[c] = owner[d->corners[8 * c]] == SFI_NODE_LOOSE;
        }
        settle_slabs(&s, skip);
        settle_pieces(&s, skip, piece);
        write_weights(&s, owner, piece, weights);
    }
    sfi_free_array(allocator, skip, d->cell_count, sizeof *skip);
    sfi_free_array(allocator, s.box, d->box_count, sizeof *s.box);
    sfi_free_array(allocator, s.line, s.longest, sizeof *s.line);
    sfi_free_array(allocator, s.piece, s.pieces, sizeof *s.piece);
    sfi_free_array(allocator, s.node, s.pieces, sizeof *s.node);
    return status;
}
