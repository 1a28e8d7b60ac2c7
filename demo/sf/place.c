// SPDX-License-Identifier: MIT
// Where voxels lie and how large they are, in build axes and mm.
//
// Layers may differ in height, so a voxel has no one volume; the mean of the solid ones is what a
// count of voxels is worth.

#include "place.h"

#include "describe.h"

#include <math.h>
#include <stdio.h>

void place_of_box(const sf_lattice *lattice, const sf_box *box, double low[3], double high[3])
{
    low[0] = lattice->origin_mm[0] + box->x0 * lattice->pitch_x_mm;
    low[1] = lattice->origin_mm[1] + box->y0 * lattice->pitch_y_mm;
    low[2] = sf_lattice_layer_bottom(lattice, box->z0);
    high[0] = lattice->origin_mm[0] + box->x1 * lattice->pitch_x_mm;
    high[1] = lattice->origin_mm[1] + box->y1 * lattice->pitch_y_mm;
    high[2] = sf_lattice_layer_bottom(lattice, box->z1);
}

// Digits after the point that tell one voxel from the next.
static int digits_for(double pitch_mm, int least)
{
    int digits = least;
    for (double step = pow(10, -least); step > pitch_mm && digits < 9; step /= 10) {
        digits++;
    }
    return digits;
}

// What rounds to nothing is nothing, and not less.
static double rounded(double value, int digits)
{
    return fabs(value) < 0.5 * pow(10, -digits) ? 0.0 : value;
}

void place_words(const sf_lattice *lattice, const sf_box *box, int in_column,
                 char words[PLACE_WORDS_SIZE])
{
    double low[3], high[3];
    place_of_box(lattice, box, low, high);
    int x = digits_for(lattice->pitch_x_mm, 1), y = digits_for(lattice->pitch_y_mm, 1);
    int z = digits_for(sf_lattice_layer_height(lattice, box->z0), 2);
    snprintf(words, PLACE_WORDS_SIZE, "z = %*.*f mm, x %.*f to %.*f, y %.*f to %.*f",
             in_column ? z + 5 : 0, z, rounded(low[2], z), x, rounded(low[0], x), x,
             rounded(high[0], x), y, rounded(low[1], y), y, rounded(high[1], y));
}

double place_voxel_mm3(const sf_grid *grid)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    uint64_t solid = sf_grid_popcount(grid);
    return solid > 0
               ? describe_volume(grid) / (double)solid
               : lattice.pitch_x_mm * lattice.pitch_y_mm * sf_lattice_layer_height(&lattice, 0);
}
