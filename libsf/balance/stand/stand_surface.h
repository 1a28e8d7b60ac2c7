// SPDX-License-Identifier: MIT
// The surface of a shape as bending wants it.

#ifndef SF_BALANCE_STAND_SURFACE_H
#define SF_BALANCE_STAND_SURFACE_H

#include "balance/bend/incidence.h"

// A vertex that no triangle uses: it is no part of the surface, and stays where it is.
#define SFI_NO_POINT UINT32_MAX

// Points of distinct position in the order of a space-filling curve, and the triangles with three
// distinct corners.
typedef struct sfi_stand_surface {
    double *points; // x, y, z of each
    uint32_t *triangles;
    uint32_t
        *point_of; // of each vertex of the mesh that was handed in; SFI_NO_POINT: no triangle's
    size_t point_count, triangle_count, vertex_count;
    size_t point_room, triangle_room;
    sfi_incidence incidence;
} sfi_stand_surface;

// Of a valid mesh with triangles. SF_ERR_MEMORY, SF_ERR_OVERFLOW; SF_ERR_ARGUMENT: no triangle has
// three distinct corners.
sf_status sfi_stand_surface_make(sf_mesh_view mesh, const sf_allocator *allocator,
                                 sfi_stand_surface *surface);

// Free what was made; one that is all zero is none.
void sfi_stand_surface_free(const sf_allocator *allocator, sfi_stand_surface *surface);

// vertices = where the points are, for each vertex of the mesh that was handed in.
void sfi_stand_surface_spread(const sfi_stand_surface *surface, const double *points,
                              double *vertices);

// View of the surface with its points anywhere.
sf_mesh_view sfi_stand_surface_view(const sfi_stand_surface *surface, const double *points);

#endif
