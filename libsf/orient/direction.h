// SPDX-License-Identifier: MIT
// Directions that may point up, and the turn that makes one do so.

#ifndef SF_ORIENT_DIRECTION_H
#define SF_ORIENT_DIRECTION_H

#include <sf/mesh.h>

// A triangle's normal times its area.
typedef struct sfi_facet {
    double normal[3];
} sfi_facet;

// Directions that are always among them, and most of those that flat faces add.
enum { SFI_AXES = 6, SFI_FLATS_MAX = 32 };

// facets[i] of triangle i, turned around where the mesh is inside out.
void sfi_facets(sf_mesh_view mesh, int inside_out, sfi_facet *facets);

// Fill up[] with +z, the other axes, what turns large flat faces to the bed, and `spread`
// directions over the sphere; it has room for all. Returns how many there are. SF_ERR_MEMORY.
sf_status sfi_directions(const sfi_facet *facets, size_t facet_count, size_t spread,
                         const sf_allocator *allocator, double (*up)[3], size_t *count);

// The shortest turn of `up` to +z, row after row; half a turn around x for -z.
void sfi_direction_turn(const double up[3], double matrix[9]);

#endif
