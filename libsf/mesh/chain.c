// SPDX-License-Identifier: MIT
// The edges of snapped triangles: do they cancel, and which belong together?
//
// A mesh has an inside when its boundary, as a chain of directed edges, is zero. The usual table of
// edges answers that, but it costs more than the voxels do. A fingerprint needs no table: give each
// undirected edge a pseudo-random number made from its ends (their
// numbers, or their places where files repeat corners), add it where a triangle
// runs the edge upwards, subtract it where downwards. The sum of a closed chain is 0; any other sum
// is 0 by chance only, one in 2^64 (and then its holes are merely not mended). Only meshes that
// fail it pay for the sort.
//
// The sort is two stable counting sorts over corners: linear time, no comparisons, and the same
// order everywhere.

#include "mesh/chain.h"

#include "base/memory.h"
#include "base/size.h"

#include <string.h>

// The finisher of splitmix64 (Steele, Lea, Flood, 2014).
static uint64_t mix(uint64_t z)
{
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

static uint64_t point_hash(const sfi_point *p)
{
    return mix(mix((uint64_t)(uint32_t)p->x << 32 | (uint32_t)p->y) + (uint32_t)p->z);
}

static uint64_t fingerprint(uint64_t from, uint64_t to)
{
    if (from == to) {
        return 0;
    }
    return from < to ? mix(from ^ mix(to)) : 0 - mix(to ^ mix(from));
}

static int closed_by_number(const uint32_t *triangles, size_t triangle_count)
{
    uint64_t sum = 0;
    for (size_t t = 0; t < triangle_count; t++) {
        uint64_t before = triangles[3 * t + 2];
        for (size_t i = 0; i < 3; i++) {
            uint64_t corner = triangles[3 * t + i];
            uint64_t low = before < corner ? before : corner, sign = 0 - (uint64_t)(low == corner);
            uint64_t value = mix(low << 32 | (before ^ corner ^ low));
            sum += before == corner ? 0 : (value ^ sign) - sign;
            before = corner;
        }
    }
    return sum == 0;
}

static int closed_by_place(const sfi_point *points, const uint32_t *triangles,
                           size_t triangle_count)
{
    uint64_t sum = 0;
    for (size_t t = 0; t < triangle_count; t++) {
        const uint32_t *corner = triangles + 3 * t;
        uint64_t a = point_hash(points + corner[0]), b = point_hash(points + corner[1]);
        uint64_t c = point_hash(points + corner[2]);
        sum += fingerprint(a, b) + fingerprint(b, c) + fingerprint(c, a);
    }
    return sum == 0;
}

int sfi_chain_closed(const sfi_point *points, const uint32_t *triangles, size_t triangle_count)
{
    return closed_by_number(triangles, triangle_count) ||
           closed_by_place(points, triangles, triangle_count);
}

static int same_point(const sfi_point *a, const sfi_point *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

sf_status sfi_chain_weld(const sfi_point *points, size_t point_count, const uint32_t *triangles,
                         size_t triangle_count, const sf_allocator *allocator, uint32_t *welded)
{
    size_t slots = 16;
    while (slots / 2 < point_count) { // point_count < 2^32, a half-full table
        if (!sfi_size_mul(slots, 2, &slots)) {
            return SF_ERR_OVERFLOW;
        }
    }
    uint32_t *table = sfi_alloc_array(allocator, slots, sizeof *table);
    if (table == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(table, 0xff, slots * sizeof *table);
    for (size_t i = 0; i < 3 * triangle_count; i++) {
        const sfi_point *p = points + triangles[i];
        size_t slot = (size_t)point_hash(p) & (slots - 1);
        while (table[slot] != SFI_NOBODY && !same_point(points + table[slot], p)) {
            slot = (slot + 1) & (slots - 1);
        }
        if (table[slot] == SFI_NOBODY) {
            table[slot] = triangles[i];
        }
        welded[i] = table[slot];
    }
    sfi_free_array(allocator, table, slots, sizeof *table);
    return SF_OK;
}

static uint32_t low_corner(const uint32_t *triangles, uint32_t h)
{
    uint32_t from = sfi_edge_from(triangles, h), to = sfi_edge_to(triangles, h);
    return from < to ? from : to;
}

static uint32_t high_corner(const uint32_t *triangles, uint32_t h)
{
    uint32_t from = sfi_edge_from(triangles, h), to = sfi_edge_to(triangles, h);
    return from < to ? to : from;
}

// One stable counting sort of half-edges by a corner. `from` NULL stands for 0, 1, 2, ...
static void sort_by(uint32_t (*key)(const uint32_t *, uint32_t), const uint32_t *triangles,
                    const uint32_t *from, uint32_t *to, size_t count, uint32_t *places,
                    size_t point_count)
{
    memset(places, 0, (point_count + 1) * sizeof *places);
    for (size_t i = 0; i < count; i++) {
        places[key(triangles, (uint32_t)i) + 1]++;
    }
    for (size_t p = 0; p < point_count; p++) {
        places[p + 1] += places[p];
    }
    for (size_t i = 0; i < count; i++) {
        uint32_t h = from != NULL ? from[i] : (uint32_t)i;
        to[places[key(triangles, h)]++] = h;
    }
}

sf_status sfi_chain_sort(const uint32_t *triangles, size_t triangle_count, size_t point_count,
                         const sf_allocator *allocator, uint32_t *order)
{
    size_t count = 3 * triangle_count;
    uint32_t *places = sfi_alloc_array(allocator, point_count + 1, sizeof *places);
    uint32_t *by_high = sfi_alloc_array(allocator, count, sizeof *by_high);
    int good = places != NULL && by_high != NULL;
    if (good) {
        sort_by(high_corner, triangles, NULL, by_high, count, places, point_count);
        sort_by(low_corner, triangles, by_high, order, count, places, point_count);
    }
    sfi_free_array(allocator, by_high, count, sizeof *by_high);
    sfi_free_array(allocator, places, point_count + 1, sizeof *places);
    return good ? SF_OK : SF_ERR_MEMORY;
}

size_t sfi_chain_group(const uint32_t *triangles, const uint32_t *order, size_t count, size_t first,
                       int64_t *net)
{
    uint32_t low = low_corner(triangles, order[first]);
    uint32_t high = high_corner(triangles, order[first]);
    size_t end = first;
    int64_t sum = 0;
    while (end < count && low_corner(triangles, order[end]) == low &&
           high_corner(triangles, order[end]) == high) {
        sum += sfi_edge_from(triangles, order[end]) == low ? 1 : -1;
        end++;
    }
    *net = low == high ? 0 : sum;
    return end;
}
