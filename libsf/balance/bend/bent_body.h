// SPDX-License-Identifier: MIT
// Mass and first moments of a bent mesh, and how they change with what bends it.

#ifndef SF_BALANCE_BENT_BODY_H
#define SF_BALANCE_BENT_BODY_H

#include "balance/bend/basis.h"
#include "balance/bend/incidence.h"

#include <sf/body.h>

// Body of the closed mesh whose vertices are at `bent`, density 1, and its derivatives by the
// coefficients of the basis' functions: 12 numbers for each function, of the mass by the
// coefficient's x, y, z, then of the moments along x, y and z. The basis' points are the mesh's
// vertices. Moments are summed about `middle`, which should lie near the mesh, and given about the
// origin. SF_ERR_MEMORY leaves both as they were.
sf_status sfi_bent_body(const double *bent, const uint32_t *triangles,
                        const sfi_incidence *incidence, const sf_blend *basis,
                        const double middle[3], const sf_allocator *allocator, sf_task *task,
                        sf_body *body, double *gradient);

#endif
