// SPDX-License-Identifier: MIT
// An orthographic camera.

#ifndef DEMO_SF_CAMERA_H
#define DEMO_SF_CAMERA_H

#include <stdint.h>

typedef struct camera {
    double forward[3], right[3], up[3]; // unit vectors; forward points away from the eye
    double centre_mm[3];                // what the middle of the view shows
    double pixel_mm;                    // size of a pixel
    double depth_mm;                    // the eye's plane stands this far before the centre
} camera;

// Look at a box from an azimuth (0: from +x, -90: from -y) and an elevation, so that the box fills
// width x height pixels but for a margin.
camera camera_make(double azimuth_deg, double elevation_deg, const double low_mm[3],
                   const double high_mm[3], double width, double height);

// Start of the ray through a point of the picture, in pixels from its middle, y upwards.
void camera_start(const camera *c, double x, double y, double start_mm[3]);

#endif
