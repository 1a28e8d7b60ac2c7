// SPDX-License-Identifier: MIT
// Contours, cut into pieces that are monotone.
//
// A line sweeps over the plane from left to right. Edges that it meets and that have the inside
// above them are kept in order, each with its helper: the last node between it and the edge above
// it, which sees everything that comes next there. A split is joined to the helper of the edge
// below it, so that no piece begins in its middle, and a merge to the node after it, so that none
// ends there. Spots are numbered in the order of the sweep, which settles what lies above each
// other (as if the plane were sheared by next to nothing), and every test is an exact sign.
//
// Where a spot is visited more than once, each visit is a node of its own. Edges that end there
// leave the order before any that start there come into it, and an edge below a node has to lie
// below the spot, not in it; so visits do not disturb each other.
//
// Contours that cross confuse the order. Then diagonals go astray, but nothing else happens: they
// still join nodes, and whoever fills the pieces sees triangles that are turned around.
//
// Source: M. de Berg, O. Cheong, M. van Kreveld, M. Overmars, "Computational Geometry", 2008,
// section 3.2, after D. T. Lee and F. P. Preparata, 1977. The order is an array: what is moved in
// it is next to nothing beside the signs, for as many edges as a line meets.

#include "mesh/sweep.h"

#include "base/memory.h"

#include <string.h>

typedef struct sweep {
    const sfi_contour *contour;
    uint8_t *kinds;    // sfi_node_kind of each node
    uint32_t *helpers; // of each edge in the order
    uint32_t *crossed; // edges that the line meets with the inside above, from below upwards
    size_t crossed_count;
    uint32_t *nodes; // in the order of the sweep
    uint32_t *ends;  // scratch: of each spot's nodes
    sfi_diagonal *diagonals;
    size_t diagonal_count;
} sweep;

static uint32_t edge_end(const sweep *s, uint32_t edge)
{
    return s->contour->from[s->contour->next[edge]];
}

// 1 where a spot lies above an edge, -1 below, 0 on its line.
static int side(const sweep *s, uint32_t edge, uint32_t spot)
{
    return sfi_spot_turn(s->contour->spots, s->contour->from[edge], edge_end(s, edge), spot);
}

// How many edges of the order lie below a spot.
static size_t count_below(const sweep *s, uint32_t spot)
{
    size_t low = 0, high = s->crossed_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (side(s, s->crossed[middle], spot) > 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

static void put_edge(sweep *s, uint32_t edge)
{
    uint32_t spot = s->contour->from[edge], end = edge_end(s, edge);
    size_t at = count_below(s, spot);
    while (at < s->crossed_count && side(s, s->crossed[at], spot) == 0 &&
           side(s, s->crossed[at], end) > 0) {
        at++;
    }
    memmove(s->crossed + at + 1, s->crossed + at, (s->crossed_count - at) * sizeof *s->crossed);
    s->crossed[at] = edge;
    s->crossed_count++;
    s->helpers[edge] = edge;
}

// Where an edge stands in the order: right where its end is, unless contours cross.
static size_t find_edge(const sweep *s, uint32_t edge)
{
    size_t at = count_below(s, edge_end(s, edge));
    for (size_t i = at; i < s->crossed_count; i++) {
        if (s->crossed[i] == edge) {
            return i;
        }
    }
    for (size_t i = 0; i < at; i++) {
        if (s->crossed[i] == edge) {
            return i;
        }
    }
    return s->crossed_count;
}

static void join(sweep *s, uint32_t a, uint32_t b)
{
    sfi_diagonal diagonal = {a, b};
    s->diagonals[s->diagonal_count++] = diagonal;
}

// A merge waits for the next node that sees it.
static void close_merge(sweep *s, uint32_t edge, uint32_t node)
{
    uint32_t helper = s->helpers[edge];
    if (s->kinds[helper] == SFI_NODE_MERGE) {
        join(s, node, helper);
    }
}

// An edge that ends in a node leaves the order, for the one that goes on from it or for nothing.
static void leave_edge(sweep *s, uint32_t node, int goes_on)
{
    uint32_t edge = s->contour->prev[node];
    size_t at = find_edge(s, edge);
    close_merge(s, edge, node);
    if (goes_on) {
        s->crossed[at] = node;
        s->helpers[node] = node;
        return;
    }
    s->crossed_count--;
    memmove(s->crossed + at, s->crossed + at + 1, (s->crossed_count - at) * sizeof *s->crossed);
}

static void help_below(sweep *s, uint32_t node)
{
    size_t below = count_below(s, s->contour->from[node]);
    if (below == 0) {
        return; // contours that cross
    }
    uint32_t edge = s->crossed[below - 1];
    if (s->kinds[node] == SFI_NODE_SPLIT) {
        join(s, node, s->helpers[edge]);
    } else {
        close_merge(s, edge, node);
    }
    s->helpers[edge] = node;
}

static void visit(sweep *s, uint32_t node)
{
    switch (s->kinds[node]) {
    case SFI_NODE_START:
        put_edge(s, node);
        break;
    case SFI_NODE_SPLIT:
        help_below(s, node);
        put_edge(s, node);
        break;
    case SFI_NODE_END:
        leave_edge(s, node, 0);
        break;
    case SFI_NODE_MERGE:
        leave_edge(s, node, 0);
        help_below(s, node);
        break;
    case SFI_NODE_LOWER:
        leave_edge(s, node, 1);
        break;
    default:
        help_below(s, node);
    }
}

// Nodes by their spots; of one spot those that start last.
static void sort_nodes(sweep *s)
{
    const sfi_contour *c = s->contour;
    uint32_t sum = 0;
    memset(s->ends, 0, c->spot_count * sizeof *s->ends);
    for (size_t i = 0; i < c->count; i++) {
        s->kinds[i] = (uint8_t)sfi_contour_kind(c, (uint32_t)i);
        s->ends[c->from[i]]++;
    }
    for (size_t spot = 0; spot < c->spot_count; spot++) {
        uint32_t count = s->ends[spot];
        s->ends[spot] = sum;
        sum += count;
    }
    for (int starts = 0; starts < 2; starts++) {
        for (size_t i = 0; i < c->count; i++) {
            if ((s->kinds[i] == SFI_NODE_START || s->kinds[i] == SFI_NODE_SPLIT) == starts) {
                s->nodes[s->ends[c->from[i]]++] = (uint32_t)i;
            }
        }
    }
}

sf_status sfi_sweep_diagonals(const sfi_contour *c, const sf_allocator *allocator,
                              sfi_diagonal *diagonals, size_t *count)
{
    sweep s = {.contour = c, .diagonals = diagonals};
    s.kinds = sfi_alloc_array(allocator, c->count, sizeof *s.kinds);
    s.helpers = sfi_alloc_array(allocator, c->count, sizeof *s.helpers);
    s.crossed = sfi_alloc_array(allocator, c->count, sizeof *s.crossed);
    s.nodes = sfi_alloc_array(allocator, c->count, sizeof *s.nodes);
    s.ends = sfi_alloc_array(allocator, c->spot_count, sizeof *s.ends);
    int enough = s.kinds != NULL && s.helpers != NULL && s.crossed != NULL && s.nodes != NULL &&
                 s.ends != NULL;
    if (enough) {
        sort_nodes(&s);
        for (size_t i = 0; i < c->count; i++) {
            visit(&s, s.nodes[i]);
        }
        *count = s.diagonal_count;
    }
    sfi_free_array(allocator, s.kinds, c->count, sizeof *s.kinds);
    sfi_free_array(allocator, s.helpers, c->count, sizeof *s.helpers);
    sfi_free_array(allocator, s.crossed, c->count, sizeof *s.crossed);
    sfi_free_array(allocator, s.nodes, c->count, sizeof *s.nodes);
    sfi_free_array(allocator, s.ends, c->spot_count, sizeof *s.ends);
    return enough ? SF_OK : SF_ERR_MEMORY;
}
