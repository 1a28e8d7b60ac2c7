// SPDX-License-Identifier: MIT
// Values of a surface's vertices, on tetrahedra.

#ifndef DEMO_FILL_PAINTED_H
#define DEMO_FILL_PAINTED_H

#include <sf/sf.h>

// Tetrahedra of the voxels inside a mesh, a property painted on its vertices spread over them; NaN:
// a vertex that is free. A value reaches the corners of voxels that its triangle passes.
sf_status painted_voxels(sf_mesh_view mesh, const double *values, const sf_property *property,
                         double pitch_mm, sf_tets **tets, sf_fault *fault);

#endif
