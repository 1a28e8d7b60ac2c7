// SPDX-License-Identifier: MIT
// Neighbouring triangles made to look the same way.
//
// A breadth-first walk over the edges that have exactly two triangles, with a queue of triangles.
// The first triangle of a patch keeps its side, every other follows the neighbour from which it was
// reached; in the end the patch as a whole takes the side that fewer triangles have to leave.

#include "mesh/orient.h"

#include "base/memory.h"

#include <string.h>

enum { UNSEEN = 0, KEPT = 1, TURNED = 2 };

// The other half-edge of each edge with exactly two, else SFI_NOBODY.
static void find_mates(const uint32_t *triangles, const uint32_t *order, size_t count,
                       uint32_t *mates)
{
    memset(mates, 0xff, count * sizeof *mates);
    for (size_t first = 0, end; first < count; first = end) {
        int64_t net;
        end = sfi_chain_group(triangles, order, count, first, &net);
        uint32_t h = order[first];
        if (end - first == 2 && sfi_edge_from(triangles, h) != sfi_edge_to(triangles, h)) {
            mates[h] = order[first + 1];
            mates[order[first + 1]] = h;
        }
    }
}

// Walk the patch of one triangle; its triangles end up in queue[0..]. Returns their number.
static size_t walk(const uint32_t *triangles, const uint32_t *mates, uint32_t seed, uint8_t *sides,
                   uint32_t *queue)
{
    size_t head = 0, tail = 0;
    sides[seed] = KEPT;
    queue[tail++] = seed;
    while (head < tail) {
        uint32_t t = queue[head++];
        for (uint32_t h = 3 * t; h < 3 * t + 3; h++) {
            uint32_t mate = mates[h];
            if (mate == SFI_NOBODY || sides[mate / 3] != UNSEEN) {
                continue;
            }
            int agree = sfi_edge_from(triangles, h) != sfi_edge_from(triangles, mate);
            sides[mate / 3] = (uint8_t)(agree ? sides[t] : KEPT + TURNED - sides[t]);
            queue[tail++] = mate / 3;
        }
    }
    return tail;
}

// Turn what a walk found, or its complement where that is less.
static size_t turn_patch(uint32_t *triangles, const uint8_t *sides, const uint32_t *queue,
                         size_t count)
{
    size_t turned = 0;
    for (size_t i = 0; i < count; i++) {
        turned += sides[queue[i]] == TURNED;
    }
    int side = turned > count - turned ? KEPT : TURNED;
    for (size_t i = 0; i < count; i++) {
        if (sides[queue[i]] == side) {
            uint32_t *corner = triangles + 3 * (size_t)queue[i], swap = corner[1];
            corner[1] = corner[2];
            corner[2] = swap;
        }
    }
    return side == TURNED ? turned : count - turned;
}

sf_status sfi_orient(uint32_t *triangles, size_t triangle_count, size_t point_count,
                     const sf_allocator *allocator, size_t *turned)
{
    size_t count = 3 * triangle_count;
    uint32_t *order = sfi_alloc_array(allocator, count, sizeof *order);
    uint32_t *mates = sfi_alloc_array(allocator, count, sizeof *mates);
    uint8_t *sides = sfi_alloc_array(allocator, triangle_count, 1);
    sf_status status = SF_ERR_MEMORY;
    if (order != NULL && mates != NULL && sides != NULL) {
        status = sfi_chain_sort(triangles, triangle_count, point_count, allocator, order);
    }
    if (status == SF_OK) {
        find_mates(triangles, order, count, mates);
        memset(sides, UNSEEN, triangle_count);
        *turned = 0;
        for (size_t t = 0; t < triangle_count; t++) {
            if (sides[t] == UNSEEN) { // the order is done with and serves as the queue
                size_t patch = walk(triangles, mates, (uint32_t)t, sides, order);
                *turned += turn_patch(triangles, sides, order, patch);
            }
        }
    }
    sfi_free_array(allocator, sides, triangle_count, 1);
    sfi_free_array(allocator, mates, count, sizeof *mates);
    sfi_free_array(allocator, order, count, sizeof *order);
    return status;
}
