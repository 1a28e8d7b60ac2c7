// SPDX-License-Identifier: MIT
// Trim, incremental, for changes that have a rectangle in each layer.

#ifndef SF_SUPPORT_TRIM_AREA_H
#define SF_SUPPORT_TRIM_AREA_H

#include <sf/support.h>

#include "voxel/area.h"

// What sf_grid_trim_box() does, for an area; what changed is joined to *changed. The area must lie
// within the grids, and the bed layer must be given.
sf_status sfi_trim_area(const sf_grid *drawn, sf_grid *printable, const sf_rule *rule,
                        uint32_t bed_layer, const sfi_area *edited, sfi_area *changed);

#endif
