// SPDX-License-Identifier: MIT
// Voxels that are less than a distance apart, as structuring elements.
//
// A distance that grows with |dx| and with |dy| makes a set that is symmetric, convex along rows
// and never widens with |dy|: a structuring element. The half width of a row comes from a root and
// is then made exact by the very comparison that it stands for.

#include "balance/wall/apart.h"

#include <math.h>

static double squared(double steps, double less, double pitch)
{
    double length = (steps - less) * pitch;
    return length > 0 ? length * length : 0;
}

// The largest dx, at most `most`, whose share is less than `rest`, or -1.
static int half_width(double rest, double less, double pitch, int most)
{
    double about = floor(sqrt(rest) / pitch + less) + 1;
    int dx = about < most ? (int)about : most;
    while (dx >= 0 && !(squared(dx, less, pitch) < rest)) {
        dx--;
    }
    return dx;
}

int sfi_apart_element(double left, double less, double pitch_x_mm, double pitch_y_mm,
                      sf_element *element)
{
    int reach = -1, width = SF_REACH_MAX;
    while (reach < (int)SF_REACH_MAX) {
        double rest = left - squared(reach + 1, less, pitch_y_mm);
        width = rest > 0 ? half_width(rest, less, pitch_x_mm, width) : -1;
        if (width < 0) {
            break;
        }
        element->half_width[++reach] = (uint16_t)width;
    }
    element->reach_y = (uint16_t)(reach > 0 ? reach : 0);
    return reach >= 0;
}

int sfi_apart_fits(double limit_mm, double pitch_x_mm, double pitch_y_mm)
{
    double pitch = pitch_x_mm < pitch_y_mm ? pitch_x_mm : pitch_y_mm;
    return limit_mm / pitch < SF_REACH_MAX - 2.0;
}
