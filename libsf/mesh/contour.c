// SPDX-License-Identifier: MIT
// Contours in a plane: directed edges, linked into tours.
//
// Where a contour touches itself in a spot, several edges end there and as many start. Which
// belongs to which decides what the tours are. Here an edge goes on with the first one that is met
// when turning right from where it came: between the two lies only what both have on their left. So
// the visits to a spot own sectors that have nothing in common, a hole that touches the outline is
// part of one tour with it, and two pieces that meet in a point are two tours. Nobody downstream
// has to know about spots that are visited twice.
//
// All directions are compared by exact signs (base/exact.h).

#include "mesh/contour.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

#define NOBODY UINT32_MAX

// 0: less than half a turn away from a, 1: half, 2: more, 3: none, which is met last.
static int sector(const sfi_spot *spots, uint32_t at, uint32_t a, uint32_t b, int way)
{
    int turn = way * sfi_spot_turn(spots, at, a, b);
    if (turn != 0) {
        return turn > 0 ? 0 : 2;
    }
    return (a < at) == (b < at) ? 3 : 1; // on one line, numbers tell the sides apart
}

int sfi_spot_sooner(const sfi_spot *spots, uint32_t at, uint32_t a, uint32_t b, uint32_t c, int way)
{
    int first = sector(spots, at, a, b, way), second = sector(spots, at, a, c, way);
    return first != second ? first < second : way * sfi_spot_turn(spots, at, b, c) > 0;
}

sfi_node_kind sfi_contour_kind(const sfi_contour *c, uint32_t node)
{
    uint32_t before = c->from[c->prev[node]], at = c->from[node], after = c->from[c->next[node]];
    if (before < at && at < after) {
        return SFI_NODE_LOWER;
    }
    if (after < at && at < before) {
        return SFI_NODE_UPPER;
    }
    int wide = sfi_spot_turn(c->spots, before, at, after) < 0;
    if (before > at) {
        return wide ? SFI_NODE_SPLIT : SFI_NODE_START;
    }
    return wide ? SFI_NODE_MERGE : SFI_NODE_END;
}

// ends[s] = where the edges that start in spot s end in `list`, edges in their order.
static void sort_by_start(const sfi_contour *c, uint32_t *ends, uint32_t *list)
{
    memset(ends, 0, c->spot_count * sizeof *ends);
    for (size_t i = 0; i < c->count; i++) {
        ends[c->from[i]]++;
    }
    uint32_t sum = 0;
    for (size_t s = 0; s < c->spot_count; s++) {
        uint32_t count = ends[s];
        ends[s] = sum;
        sum += count;
    }
    for (size_t i = 0; i < c->count; i++) {
        list[ends[c->from[i]]++] = (uint32_t)i;
    }
}

// The edge that goes on from `at` for one that came from `came`: of those that nobody took yet.
static uint32_t goes_on(const sfi_contour *c, const uint32_t *edges, const uint32_t *list,
                        size_t count, uint32_t came, uint32_t at)
{
    uint32_t best = NOBODY;
    for (size_t i = 0; i < count; i++) {
        uint32_t edge = list[i];
        if (c->prev[edge] == NOBODY &&
            (best == NOBODY || sfi_spot_sooner(c->spots, at, came, edges[2 * (size_t)edge + 1],
                                               edges[2 * (size_t)best + 1], -1))) {
            best = edge;
        }
    }
    return best;
}

static sf_status link_edges(sfi_contour *c, const uint32_t *edges, uint32_t *ends, uint32_t *list)
{
    sort_by_start(c, ends, list);
    memset(c->prev, 0xff, c->count * sizeof *c->prev);
    for (size_t i = 0; i < c->count; i++) {
        uint32_t at = edges[2 * i + 1], first = at == 0 ? 0 : ends[at - 1];
        uint32_t next = goes_on(c, edges, list + first, ends[at] - first, edges[2 * i], at);
        if (next == NOBODY) {
            return SF_ERR_INTERNAL; // no boundary: more edges end in a spot than start there
        }
        c->next[i] = next;
        c->prev[next] = (uint32_t)i;
    }
    return SF_OK;
}

sf_status sfi_contour_create(const sfi_spot *spots, size_t spot_count, const uint32_t *edges,
                             size_t edge_count, const sf_allocator *allocator, sfi_contour *made)
{
    sfi_contour c = {spots, spot_count, edge_count, NULL, NULL, NULL};
    c.from = sfi_alloc_array(allocator, edge_count, sizeof *c.from);
    c.next = sfi_alloc_array(allocator, edge_count, sizeof *c.next);
    c.prev = sfi_alloc_array(allocator, edge_count, sizeof *c.prev);
    uint32_t *ends = sfi_alloc_array(allocator, spot_count, sizeof *ends);
    uint32_t *list = sfi_alloc_array(allocator, edge_count, sizeof *list);
    sf_status status = SF_ERR_MEMORY;
    if (c.from != NULL && c.next != NULL && c.prev != NULL && ends != NULL && list != NULL) {
        for (size_t i = 0; i < edge_count; i++) {
            c.from[i] = edges[2 * i];
        }
        status = link_edges(&c, edges, ends, list);
    }
    sfi_free_array(allocator, ends, spot_count, sizeof *ends);
    sfi_free_array(allocator, list, edge_count, sizeof *list);
    if (status != SF_OK) {
        sfi_contour_destroy(&c, allocator);
        return status;
    }
    *made = c;
    return SF_OK;
}

void sfi_contour_destroy(sfi_contour *c, const sf_allocator *allocator)
{
    sfi_free_array(allocator, c->from, c->count, sizeof *c->from);
    sfi_free_array(allocator, c->next, c->count, sizeof *c->next);
    sfi_free_array(allocator, c->prev, c->count, sizeof *c->prev);
    memset(c, 0, sizeof *c);
}
