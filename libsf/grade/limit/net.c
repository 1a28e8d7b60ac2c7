// SPDX-License-Identifier: MIT
// Which rings are regular.
//
// Inside, a ring of 27 cells in rows and columns is that of a tri-cubic B-spline. At a smooth
// boundary with four cells and four boundary faces at each point a layer is missing, and the rules
// of the boundary are those of a spline whose missing layer P[-1] is 2 P[0] - P[1]: then
// (P[-1] + 6 P[0] + P[1]) / 8 = P[0], and refinement keeps that relation. Where two such sides meet
// the same holds if the edge between them is sharp for ever, and nowhere else: the rules of a
// smooth block edge are no product.

#include "grade/limit/net.h"

#include <string.h>

// What is known of a ring as a grid: of each axis the layers of cells before and behind the first
// cell, 0 or 1, and the points found so far.
typedef struct grid {
    uint32_t dimension;
    int before[3], behind[3];
    uint32_t at[64];    // ring points, by their place in the grid
    uint32_t place[64]; // their places in the grid, by ring point
} grid;

static uint32_t grid_place(const int8_t *shift, uint32_t corner)
{
    uint32_t place = 0;
    for (uint32_t axis = 0; axis < 3; axis++) {
        place += (uint32_t)(shift[axis] + 1 + (int)(corner >> axis & 1)) << 2 * axis;
    }
    return place;
}

// Along an axis that the ring does not have all of it lies at 1.
static uint32_t coordinate(uint32_t place, uint32_t axis)
{
    return place >> 2 * axis & 3;
}

// Place the points. Returns 0 if a cell lies beyond the grid, or a point at two places, or two at
// one.
static int lay_out(const sfi_ring *ring, grid *g)
{
    uint32_t corners = 1u << ring->dimension;
    memset(g, 0, sizeof *g);
    g->dimension = ring->dimension;
    memset(g->at, 0xff, sizeof g->at);
    memset(g->place, 0xff, sizeof g->place);
    for (uint32_t cell = 0; cell < ring->cells; cell++) {
        const int8_t *shift = ring->shifts + 3 * (size_t)cell;
        for (uint32_t axis = 0; axis < 3; axis++) {
            if (shift[axis] < -1 || shift[axis] > 1) {
                return 0;
            }
            g->before[axis] |= shift[axis] < 0;
            g->behind[axis] |= shift[axis] > 0;
        }
        for (uint32_t corner = 0; corner < corners; corner++) {
            uint32_t point = ring->items[(size_t)corners * cell + corner];
            uint32_t place = grid_place(shift, corner);
            if (point >= 64 || (g->at[place] != SFI_NONE && g->at[place] != point) ||
                (g->place[point] != SFI_NONE && g->place[point] != place)) {
                return 0;
            }
            g->at[place] = point;
            g->place[point] = place;
        }
    }
    return 1;
}

// Cells fill the box and each is there once: their number is that of the box, and none has the
// shift of another, for then both would have the same points.
static int is_box(const sfi_ring *ring, const grid *g)
{
    uint32_t cells = 1, points = 1;
    for (uint32_t axis = 0; axis < g->dimension; axis++) {
        uint32_t layers = (uint32_t)(1 + g->before[axis] + g->behind[axis]);
        cells *= layers;
        points *= layers + 1;
    }
    return ring->cells == cells && ring->points == points;
}

// A side of a cell is outside just where it lies on a side of the box without a layer of cells.
static int is_outside_right(const sfi_ring *ring, const grid *g)
{
    for (uint32_t cell = 0; cell < ring->cells; cell++) {
        uint32_t expected = 0;
        for (uint32_t axis = 0; axis < g->dimension; axis++) {
            int here = ring->shifts[3 * (size_t)cell + axis];
            expected |= (uint32_t)(!g->before[axis] && here == 0) << 2 * axis;
            expected |= (uint32_t)(!g->behind[axis] && here == 0) << (2 * axis + 1);
        }
        if (ring->outside[cell] != expected) {
            return 0;
        }
    }
    return 1;
}

// On how many sides of the box without a layer of cells a point lies.
static uint32_t outside_count(const grid *g, uint32_t point)
{
    uint32_t count = 0;
    for (uint32_t axis = 0; axis < g->dimension; axis++) {
        uint32_t at = coordinate(g->place[point], axis);
        count += (at == 1 && !g->before[axis]) || (at == 2 && !g->behind[axis]);
    }
    return count;
}

// Whether an edge of the box lies between two sides that are outside both.
static int is_block_edge(const grid *g, uint32_t a, uint32_t b)
{
    uint32_t together = 0;
    for (uint32_t axis = 0; axis < g->dimension; axis++) {
        uint32_t at = coordinate(g->place[a], axis);
        together += at == coordinate(g->place[b], axis) &&
                    ((at == 1 && !g->before[axis]) || (at == 2 && !g->behind[axis]));
    }
    return together >= 2;
}

// Edges of the first cell's points along which two outer sides meet: as many as must be sharp.
static uint32_t block_edges(const grid *g)
{
    uint32_t count = 0;
    for (uint32_t axis = 0; axis < 3 && g->dimension == 3; axis++) {
        uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        uint32_t lines =
            (uint32_t)((!g->before[u] + !g->behind[u]) * (!g->before[v] + !g->behind[v]));
        count += lines * (uint32_t)(1 + g->before[axis] + g->behind[axis]);
    }
    return count;
}

// What must be sharp is so for ever, and nothing else is. In dimension 2 sides meet in points.
static int is_sharp_right(const sfi_ring *ring, const grid *g)
{
    uint32_t found = 0, expected = block_edges(g);
    for (uint32_t corner = 0; g->dimension == 2 && corner < 4; corner++) {
        expected += outside_count(g, corner) == 2;
    }
    for (uint32_t i = 0; i < ring->sharps; i++) {
        const sfi_ring_sharp *s = &ring->sharp[i];
        int is_point = s->a == s->b;
        int fits = is_point ? outside_count(g, s->a) == g->dimension : is_block_edge(g, s->a, s->b);
        if (s->sharpness < SF_SHARP || !fits) {
            return 0;
        }
        found +=
            is_point ? g->dimension == 2 : 1; // where three edges meet the point is sharp anyway
    }
    return found == expected;
}

int sfi_net_find(const sfi_ring *ring, sfi_net *net)
{
    grid g;
    if (!lay_out(ring, &g) || !is_box(ring, &g) || !is_outside_right(ring, &g) ||
        !is_sharp_right(ring, &g)) {
        return 0;
    }
    net->outside = ring->outside[0];
    memset(net->at, 0xff, sizeof net->at);
    if (ring->dimension == 3) {
        memcpy(net->at, g.at, sizeof net->at);
    } else {
        memcpy(net->at, g.at + 16, 16 * sizeof *net->at); // the plane that it lies in
    }
    return 1;
}
