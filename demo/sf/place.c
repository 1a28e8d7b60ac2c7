// SPDX-License-Identifier: MIT
// Where voxels lie and how large they are.
//
// Layers may differ in height, so a voxel has no one volume; the mean of the solid ones is what a
// count of voxels is worth.

#include "place.h"

#include "describe.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void place_of_box(const sf_lattice *lattice, const sf_box *box, double low[3], double high[3])
{
    low[0] = lattice->origin_mm[0] + box->x0 * lattice->pitch_x_mm;
    low[1] = lattice->origin_mm[1] + box->y0 * lattice->pitch_y_mm;
    low[2] = sf_lattice_layer_bottom(lattice, box->z0);
    high[0] = lattice->origin_mm[0] + box->x1 * lattice->pitch_x_mm;
    high[1] = lattice->origin_mm[1] + box->y1 * lattice->pitch_y_mm;
    high[2] = sf_lattice_layer_bottom(lattice, box->z1);
}

void place_point(axis up, const double from[3], double to[3])
{
    sf_transform back = upright_back(up);
    double made[3] = {0, 0, 0};
    for (int i = 0; i < 9; i++) {
        if (fabs(back.matrix[i]) > 0.5) {                     // sides may be infinitely far away
            made[i / 3] = back.matrix[i] * from[i % 3] + 0.0; // no negative zeros
        }
    }
    memcpy(to, made, sizeof made);
}

void place_box(const places *in, const sf_box *box, double low[3], double high[3])
{
    double a[3], b[3];
    place_of_box(&in->lattice, box, a, b);
    place_point(in->up, a, a);
    place_point(in->up, b, b);
    for (int i = 0; i < 3; i++) {
        low[i] = fmin(a[i], b[i]);
        high[i] = fmax(a[i], b[i]);
    }
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

// Of the input's axes, the one that is an axis of the lattice.
static int axis_of(axis up, int across)
{
    sf_transform map = upright(up, 1);
    int found = 0;
    for (int i = 0; i < 3; i++) {
        found = fabs(map.matrix[3 * across + i]) > 0.5 ? i : found;
    }
    return found;
}

static void write_range(const places *in, int across, double pitch_mm, const double low[3],
                        const double high[3], char words[PLACE_WORDS_SIZE])
{
    int which = axis_of(in->up, across), digits = digits_for(pitch_mm, 1);
    snprintf(words, PLACE_WORDS_SIZE, "%c %.*f to %.*f", "xyz"[which], digits,
             rounded(low[which], digits), digits, rounded(high[which], digits));
}

// Two of them, in the order of their names.
void place_words(const places *in, const sf_box *box, int in_column, char words[PLACE_WORDS_SIZE])
{
    const sf_lattice *l = &in->lattice;
    char ranges[2][PLACE_WORDS_SIZE];
    double low[3], high[3];
    place_box(in, box, low, high);
    int is_turned = axis_of(in->up, 0) > axis_of(in->up, 1);
    write_range(in, 0, l->pitch_x_mm, low, high, ranges[is_turned]);
    write_range(in, 1, l->pitch_y_mm, low, high, ranges[!is_turned]);
    int which = axis_of(in->up, 2), digits = digits_for(sf_lattice_layer_height(l, box->z0), 2);
    int is_down = in->up == AXIS_MINUS_X || in->up == AXIS_MINUS_Y || in->up == AXIS_MINUS_Z;
    snprintf(words, PLACE_WORDS_SIZE, "%c = %*.*f mm, %.80s, %.80s", "xyz"[which],
             in_column ? digits + 5 : 0, digits,
             rounded(is_down ? high[which] : low[which], digits), ranges[0], ranges[1]);
}

double place_voxel_mm3(const sf_grid *grid)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    uint64_t solid = sf_grid_popcount(grid);
    return solid > 0
               ? describe_volume(grid) / (double)solid
               : lattice.pitch_x_mm * lattice.pitch_y_mm * sf_lattice_layer_height(&lattice, 0);
}
