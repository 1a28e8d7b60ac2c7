// SPDX-License-Identifier: MIT
// Whether a binary STL is one closed, oriented 2-manifold when corners at one place are one vertex:
// each edge is run once each way, and the triangles around each vertex are one fan. From the bytes,
// without code of libsf.

#ifndef SF_TEST_VERIFY_CLOSED_H
#define SF_TEST_VERIFY_CLOSED_H

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct closed_corner {
    float p[3];
    uint32_t index;
} closed_corner;

// An edge as it is run, from the upper half of `key` to the lower, and where it leads around its
// first vertex: to the end of the edge of this triangle that comes back.
typedef struct closed_edge {
    uint64_t key;
    uint32_t back;
} closed_edge;

static inline int closed_by_place(const void *a, const void *b)
{
    const closed_corner *p = a, *q = b;
    for (int i = 0; i < 3; i++) {
        if (p->p[i] < q->p[i] || p->p[i] > q->p[i]) {
            return p->p[i] < q->p[i] ? -1 : 1;
        }
    }
    return 0;
}

static inline int closed_by_key(const void *a, const void *b)
{
    const closed_edge *p = a, *q = b;
    return (p->key > q->key) - (p->key < q->key);
}

static inline uint64_t closed_key(uint32_t from, uint32_t to)
{
    return (uint64_t)from << 32 | to;
}

// Vertices by corner: 0, 1, ... for each place.
static inline void closed_number(const unsigned char *stl, uint32_t count, uint32_t *vertices)
{
    closed_corner *corners = malloc((size_t)count * 3 * sizeof *corners);
    uint32_t number = 0;
    for (uint32_t i = 0; i < 3 * count; i++) {
        memcpy(corners[i].p, stl + 84 + (size_t)(i / 3) * 50 + 12 + i % 3 * 12, 12);
        corners[i].index = i;
    }
    qsort(corners, (size_t)count * 3, sizeof *corners, closed_by_place);
    for (uint32_t i = 0; i < 3 * count; i++) {
        number += i > 0 && closed_by_place(&corners[i - 1], &corners[i]) != 0;
        vertices[corners[i].index] = number;
    }
    free(corners);
}

// Steps of the walk around the vertex of edge `first` until it is back; 0 where it meets a hole.
static inline size_t closed_walk(const closed_edge *edges, size_t count, size_t first)
{
    size_t steps = 0, at = first;
    do {
        closed_edge next = {closed_key((uint32_t)(edges[first].key >> 32), edges[at].back), 0};
        const closed_edge *found = bsearch(&next, edges, count, sizeof *edges, closed_by_key);
        if (found == NULL || ++steps > count) {
            return 0;
        }
        at = (size_t)(found - edges);
    } while (at != first);
    return steps;
}

static inline int closed_fans(const closed_edge *edges, size_t count)
{
    for (size_t first = 0, end = 0; first < count; first = end) {
        while (end < count && edges[end].key >> 32 == edges[first].key >> 32) {
            if (end > first && edges[end].key == edges[end - 1].key) {
                return 0; // run twice the same way
            }
            end++;
        }
        if (closed_walk(edges, count, first) != end - first) {
            return 0;
        }
    }
    return 1;
}

// An edge that is run one way only has no partner, and the walk around its end finds a hole.
static inline int closed_stl(const void *bytes, size_t size)
{
    const unsigned char *stl = bytes;
    uint32_t count = 0;
    if (size < 84) {
        return 0;
    }
    memcpy(&count, stl + 80, 4);
    if (count == 0 || size != 84 + (size_t)count * 50) {
        return 0;
    }
    uint32_t *v = malloc((size_t)count * 3 * sizeof *v);
    closed_edge *edges = malloc((size_t)count * 3 * sizeof *edges);
    closed_number(stl, count, v);
    for (uint32_t i = 0; i < 3 * count; i++) {
        uint32_t next = i / 3 * 3 + (i + 1) % 3, last = i / 3 * 3 + (i + 2) % 3;
        edges[i].key = closed_key(v[i], v[next]);
        edges[i].back = v[last];
    }
    qsort(edges, (size_t)count * 3, sizeof *edges, closed_by_key);
    int good = closed_fans(edges, (size_t)count * 3);
    free(edges);
    free(v);
    return good;
}

#endif
