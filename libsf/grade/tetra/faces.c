// SPDX-License-Identifier: MIT
// The boundary of tetrahedra: faces that only one of them has.
//
// Faces are sorted by their points, the largest first, then the middle one, then the least: three
// passes that count, whose time does not depend on how many meet in one point. Like ones then lie
// next to each other. A tetrahedron and its neighbour go around a face they share in opposite
// directions.

#include "grade/tetra/faces.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

// The faces of a tetrahedron a b c d with (b - a) x (c - a) . (d - a) above 0, outwards.
static const uint8_t sides[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

// Face f is side f % 4 of tetrahedron f / 4; turned so that the least point comes first.
static void face_of(const uint32_t *corners, size_t f, uint32_t face[3])
{
    const uint32_t *tet = corners + f / 4 * 4;
    const uint8_t *side = sides[f % 4];
    uint32_t least = 0;
    for (uint32_t i = 1; i < 3; i++) {
        least = tet[side[i]] < tet[side[least]] ? i : least;
    }
    for (uint32_t i = 0; i < 3; i++) {
        face[i] = tet[side[(least + i) % 3]];
    }
}

// Point `rank` of a face, 0 for the least.
static uint32_t ranked(const uint32_t *corners, size_t f, int rank)
{
    uint32_t face[3];
    face_of(corners, f, face);
    int falls = face[1] > face[2];
    return rank == 0 ? face[0] : face[rank == 1 ? 1 + falls : 2 - falls];
}

// One pass: in the order of point `rank`, and else as before.
static void sort_by(const uint32_t *corners, size_t count, int rank, size_t points,
                    uint32_t *starts, const uint32_t *from, uint32_t *to)
{
    uint32_t sum = 0;
    memset(starts, 0, points * sizeof *starts);
    for (size_t i = 0; i < count; i++) {
        starts[ranked(corners, from[i], rank)]++;
    }
    for (size_t i = 0; i < points; i++) {
        uint32_t here = starts[i];
        starts[i] = sum;
        sum += here;
    }
    for (size_t i = 0; i < count; i++) {
        to[starts[ranked(corners, from[i], rank)]++] = from[i];
    }
}

// Whether a face goes around the same points as the first of a group: 1 the same way, -1 the other
// way, 0 not.
static int compare(const uint32_t *corners, size_t f, const uint32_t first[3])
{
    uint32_t face[3];
    face_of(corners, f, face);
    return face[0] != first[0]                          ? 0
           : face[1] == first[1] && face[2] == first[2] ? 1
           : face[1] == first[2] && face[2] == first[1] ? -1
                                                        : 0;
}

static sf_status collect(const uint32_t *corners, size_t count, const uint32_t *order,
                         sfi_faces *faces)
{
    for (size_t i = 0; i < count;) {
        uint32_t first[3];
        size_t end = i + 1;
        int balance = 1;
        face_of(corners, order[i], first);
        for (; end < count && compare(corners, order[end], first) != 0; end++) {
            balance += compare(corners, order[end], first);
        }
        if (end - i > 2 || balance == 2) {
            faces->crowded++;
        } else if (end - i == 1) {
            if (!sfi_grow_array(&faces->allocator, (void **)&faces->corners, &faces->capacity,
                                faces->count + 1, 3 * sizeof *faces->corners)) {
                return SF_ERR_MEMORY;
            }
            memcpy(faces->corners + 3 * faces->count++, first, sizeof first);
        }
        i = end;
    }
    return SF_OK;
}

sf_status sfi_faces_make(const uint32_t *corners, size_t tets, size_t points,
                         const sf_allocator *allocator, sfi_faces *faces)
{
    sfi_faces made = {*allocator, 0, 0, NULL, 0};
    size_t count = 4 * tets;
    uint32_t *starts = sfi_alloc_array(allocator, points, sizeof *starts);
    uint32_t *a = sfi_alloc_array(allocator, count, sizeof *a);
    uint32_t *b = sfi_alloc_array(allocator, count, sizeof *b);
    sf_status status = SF_ERR_MEMORY;
    if (starts != NULL && a != NULL && b != NULL) {
        for (size_t i = 0; i < count; i++) {
            a[i] = (uint32_t)i;
        }
        sort_by(corners, count, 2, points, starts, a, b);
        sort_by(corners, count, 1, points, starts, b, a);
        sort_by(corners, count, 0, points, starts, a, b);
        status = collect(corners, count, b, &made);
    }
    sfi_free_array(allocator, b, count, sizeof *b);
    sfi_free_array(allocator, a, count, sizeof *a);
    sfi_free_array(allocator, starts, points, sizeof *starts);
    if (status == SF_OK) {
        *faces = made;
    } else {
        sfi_faces_free(&made);
    }
    return status;
}

void sfi_faces_free(sfi_faces *faces)
{
    sfi_free_array(&faces->allocator, faces->corners, faces->capacity, 3 * sizeof *faces->corners);
    memset(faces, 0, sizeof *faces);
}
