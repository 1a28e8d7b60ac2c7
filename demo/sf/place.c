// SPDX-License-Identifier: MIT
// Where voxels lie and how large they are, in build axes and mm.
//
// Layers may differ in height, so a voxel has no one volume; the mean of the solid ones is what a
// count of voxels is worth.

#include "place.h"

#include "describe.h"

void place_of_box(const sf_lattice *lattice, const sf_box *box, double low[3], double high[3])
{
    low[0] = lattice->origin_mm[0] + box->x0 * lattice->pitch_x_mm;
    low[1] = lattice->origin_mm[1] + box->y0 * lattice->pitch_y_mm;
    low[2] = sf_lattice_layer_bottom(lattice, box->z0);
    high[0] = lattice->origin_mm[0] + box->x1 * lattice->pitch_x_mm;
    high[1] = lattice->origin_mm[1] + box->y1 * lattice->pitch_y_mm;
    high[2] = sf_lattice_layer_bottom(lattice, box->z1);
}

double place_voxel_mm3(const sf_grid *grid)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    uint64_t solid = sf_grid_popcount(grid);
    return solid > 0
               ? describe_volume(grid) / (double)solid
               : lattice.pitch_x_mm * lattice.pitch_y_mm * sf_lattice_layer_height(&lattice, 0);
}
