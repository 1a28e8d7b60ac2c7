// SPDX-License-Identifier: MIT
// How the body of a mesh changes with one vertex.

#ifndef SF_BALANCE_GRADIENT_H
#define SF_BALANCE_GRADIENT_H

#include "balance/bend/incidence.h"

// Of mass and first moments by the vertex's x, y, z: [0..2] of the mass, [3 + 3 d ..] of moment d.
// Density 1. Moments are about `middle`, which should lie near the mesh.
void sfi_vertex_gradient(const double *vertices, const uint32_t *triangles,
                         const sfi_incidence *incidence, size_t v, const double middle[3],
                         double gradient[12]);

#endif
