// SPDX-License-Identifier: MIT
// The boundary of tetrahedra.

#ifndef SF_GRADE_TETRA_FACES_H
#define SF_GRADE_TETRA_FACES_H

#include <sf/base.h>

// Faces of one tetrahedron, outwards, in the order of their least points.
typedef struct sfi_faces {
    sf_allocator allocator;
    size_t count, capacity;
    uint32_t *corners; // three points each
    size_t crowded; // faces of more than two tetrahedra, or of two on the same side; not among them
} sfi_faces;

// SF_ERR_MEMORY.
sf_status sfi_faces_make(const uint32_t *corners, size_t tets, size_t points,
                         const sf_allocator *allocator, sfi_faces *faces);
void sfi_faces_free(sfi_faces *faces);

#endif
