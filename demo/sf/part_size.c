// SPDX-License-Identifier: MIT
// How large a part is: where its voxels lie, and what they hold. A part whose layers were only
// looked at has no grid, so it says what was counted.

#include "part.h"

#include "describe.h"
#include "place.h"

sf_lattice part_lattice(const part *p)
{
    return p->grid != NULL ? sf_grid_lattice(p->grid) : p->lattice;
}

double part_volume_mm3(const part *p)
{
    return p->grid != NULL ? describe_volume(p->grid) : p->volume_mm3;
}

double part_voxel_mm3(const part *p)
{
    sf_lattice l = part_lattice(p);
    if (p->grid != NULL) {
        return place_voxel_mm3(p->grid);
    }
    return p->solid_voxels > 0 ? p->volume_mm3 / (double)p->solid_voxels
                               : l.pitch_x_mm * l.pitch_y_mm * sf_lattice_layer_height(&l, 0);
}
