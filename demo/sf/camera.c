// SPDX-License-Identifier: MIT
// An orthographic camera. Lengths that lie across the view are true everywhere in the picture,
// which is what makes a scale bar honest.

#include "camera.h"

#include <math.h>

#define MARGIN 0.9 // part of the view that the box may take

static void aim(camera *c, double azimuth, double elevation)
{
    const double forward[3] = {-cos(azimuth) * cos(elevation), -sin(azimuth) * cos(elevation),
                               -sin(elevation)};
    const double right[3] = {-sin(azimuth), cos(azimuth), 0};
    const double up[3] = {-cos(azimuth) * sin(elevation), -sin(azimuth) * sin(elevation),
                          cos(elevation)};
    for (int i = 0; i < 3; i++) {
        c->forward[i] = forward[i];
        c->right[i] = right[i];
        c->up[i] = up[i];
    }
}

camera camera_make(double azimuth_deg, double elevation_deg, const double low_mm[3],
                   const double high_mm[3], double width, double height)
{
    const double degree = 3.14159265358979323846 / 180;
    double across = 0, upwards = 0, diagonal = 0;
    camera c;
    aim(&c, azimuth_deg * degree, elevation_deg * degree);
    for (int i = 0; i < 3; i++) {
        double side = high_mm[i] - low_mm[i];
        c.centre_mm[i] = 0.5 * (low_mm[i] + high_mm[i]);
        across += side * fabs(c.right[i]);
        upwards += side * fabs(c.up[i]);
        diagonal += side;
    }
    c.pixel_mm = fmax(across / width, upwards / height) / MARGIN;
    c.depth_mm = 2 * diagonal;
    return c;
}

void camera_start(const camera *c, double x, double y, double start_mm[3])
{
    for (int i = 0; i < 3; i++) {
        start_mm[i] = c->centre_mm[i] + c->pixel_mm * (x * c->right[i] + y * c->up[i]) -
                      c->depth_mm * c->forward[i];
    }
}
