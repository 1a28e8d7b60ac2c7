// SPDX-License-Identifier: MIT
// Carving in the order of the distance to a plane.

#ifndef SF_BALANCE_PLANE_H
#define SF_BALANCE_PLANE_H

#include "balance/carve/carving.h"

// `made` is a copy of the solid, and what is carved is taken out of it; after a failure it may hold
// anything between the solid and what is needed.
sf_status sfi_carve_plane(const sfi_carving *carving, sf_grid *made, uint32_t *rounds);

#endif
