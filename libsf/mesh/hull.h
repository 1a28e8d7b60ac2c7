// SPDX-License-Identifier: MIT
// The convex hull of points in space, with its faces as polygons.

#ifndef SF_MESH_HULL_H
#define SF_MESH_HULL_H

#include <sf/mesh.h>

// Corners are points that lie between no others, faces are polygons of them, no two in one plane.
typedef struct sfi_hull {
    int dimension;     // 0: all points are one; 1: a segment; 2: a polygon, with two faces; 3
    uint32_t *corners; // numbers of points; all numbers below are places in this list
    size_t corner_count;
    size_t face_count;
    size_t *starts;   // of each face's loop, and one past the last: face_count + 1
    uint32_t *loops;  // corners around each face, counter-clockwise seen from outside
    uint32_t *across; // the face across the edge from a corner of a loop to the next
} sfi_hull;

// The hull of `count` points, three finite coordinates each. Coordinates are rounded to 2^-40 of
// the largest extent, or up to twice that; the hull is exactly that of the rounded points. Of
// points in one place any one stays, and always the same. `count` > 0. SF_ERR_OVERFLOW: more than
// 2^30 points; SF_ERR_MEMORY.
sf_status sfi_hull_create(const double *points, size_t count, const sf_allocator *allocator,
                          sfi_hull *hull);
void sfi_hull_destroy(sfi_hull *hull, const sf_allocator *allocator);

// The outward normal of a face, of length 1, from the points as they were given.
void sfi_hull_normal(const sfi_hull *hull, const double *points, size_t face, double normal[3]);

// How far a place lies outside of the hull: at most its distance, and 0 for what is inside.
double sfi_hull_outside(const sfi_hull *hull, const double *points, const double place[3]);

#endif
