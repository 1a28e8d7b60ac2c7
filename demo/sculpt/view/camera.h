// SPDX-License-Identifier: MIT
// A camera that goes around a point.

#ifndef SCULPT_VIEW_CAMERA_H
#define SCULPT_VIEW_CAMERA_H

// Lengths in mm, angles in radians. z is up.
typedef struct view_camera {
    double target[3]; // what it looks at
    double distance;
    double azimuth;   // 0: from +x, -pi / 2: from -y
    double elevation; // above the horizon, within a quarter turn
    double fov;       // from the bottom of the picture to its top
} view_camera;

// Rays: from `eye` through the picture's point (u, v), each from -1 to 1, in the direction
// forward + u * right + v * up, which is as long as it comes out.
typedef struct view_frame {
    double eye[3], forward[3], right[3], up[3];
} view_frame;

// Look at a box so that it fills a picture of width / height, but for a margin.
view_camera view_camera_fit(const double low[3], const double high[3], double azimuth,
                            double elevation, double aspect);

view_frame view_camera_frame(const view_camera *camera, double aspect);

// Turn around the target; the elevation stops short of straight up and down.
void view_camera_orbit(view_camera *camera, double by_azimuth, double by_elevation);

// Move the target so that what lies at it moves by (du, dv) of the picture, each from -1 to 1.
void view_camera_pan(view_camera *camera, double du, double dv, double aspect);

// Come nearer: the distance becomes `factor` times as long.
void view_camera_zoom(view_camera *camera, double factor);

#endif
