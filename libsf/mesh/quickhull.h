// SPDX-License-Identifier: MIT
// Convex hulls of points in space, as triangles.

#ifndef SF_MESH_QUICKHULL_H
#define SF_MESH_QUICKHULL_H

#include <sf/mesh.h>

// Coordinates are whole numbers from 0 to 2^SFI_HULL_BITS, kept in doubles.
#define SFI_HULL_BITS 40
// Most points.
#define SFI_HULL_POINTS_MAX ((size_t)1 << 30)

// A triangle, counter-clockwise seen from outside.
typedef struct sfi_face {
    uint32_t corner[3];
    uint32_t beside[3];      // the face across the edge from corner i to corner i + 1
    uint32_t first;          // of the points outside of it, or SFI_NO_POINT
    uint32_t furthest;       // among these
    double reach;            // of that one
    double normal[3], doubt; // for a sign in doubles, and how far it is to be believed
    int is_gone, is_seen;
} sfi_face;

#define SFI_NO_POINT UINT32_MAX

typedef struct sfi_faces {
    sfi_face *faces; // some of them gone
    size_t count, capacity;
} sfi_faces;

// On which side of the plane through a, b, c the point p lies: 1 where it sees them run
// counter-clockwise, 0 in the plane. Exact.
int sfi_side(const double *at, uint32_t a, uint32_t b, uint32_t c, uint32_t p);

// The hull of points, three numbers each, of which those of `simplex` do not lie in one plane.
// Triangles may lie in one plane, and their corners along one line or in the middle of such a face.
sf_status sfi_quickhull(const double *at, size_t count, const uint32_t simplex[4],
                        const sf_allocator *allocator, sfi_faces *hull);
void sfi_faces_destroy(sfi_faces *hull, const sf_allocator *allocator);

#endif
