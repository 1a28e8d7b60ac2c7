// SPDX-License-Identifier: MIT
// Between the axes of the input and build axes.

#include "turned.h"

#include "place.h"
#include "upright.h"

#include <math.h>
#include <string.h>

// The matrix only has ones, one a row: a sum would make numbers out of infinities that are none.
static void turn(const sf_transform *map, const double from[3], double to[3])
{
    double made[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            double entry = map->matrix[3 * i + j];
            if (entry > 0 || entry < 0) {
                made[i] = entry * from[j] + 0.0; // no negative zeros
            }
        }
    }
    memcpy(to, made, sizeof made);
}

void turned_axis(axis which, double direction[3])
{
    const double z[3] = {0, 0, 1};
    sf_transform back = upright_back(which);
    turn(&back, z, direction);
}

void turned_to_build(const cli_job *job, const double from[3], double to[3])
{
    sf_transform map = upright(job->options.up, 1);
    turn(&map, from, to);
}

void turned_to_input(const cli_job *job, const double from[3], double to[3])
{
    place_point(job->options.up, from, to);
}

void turned_box(const cli_job *job, const double low[3], const double high[3], double to_low[3],
                double to_high[3])
{
    double a[3], b[3];
    turned_to_build(job, low, a);
    turned_to_build(job, high, b);
    for (int i = 0; i < 3; i++) {
        to_low[i] = fmin(a[i], b[i]);
        to_high[i] = fmax(a[i], b[i]);
    }
}
