// SPDX-License-Identifier: MIT
// A camera that goes around a point.

#include "camera.h"

#include <math.h>

#define QUARTER 1.57079632679489661923
#define MARGIN 1.06

// Short of the pole, where the azimuth would mean nothing.
#define ELEVATION_MOST (QUARTER - 0.01)

#define DISTANCE_LEAST 0.1
#define DISTANCE_MOST 1e7

static double between(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

view_frame view_camera_frame(const view_camera *camera, double aspect)
{
    view_frame f;
    double ca = cos(camera->azimuth), sa = sin(camera->azimuth);
    double ce = cos(camera->elevation), se = sin(camera->elevation);
    double half = tan(0.5 * camera->fov);
    const double back[3] = {ca * ce, sa * ce, se}, right[3] = {-sa, ca, 0};
    const double up[3] = {-ca * se, -sa * se, ce};
    for (int i = 0; i < 3; i++) {
        f.eye[i] = camera->target[i] + camera->distance * back[i];
        f.forward[i] = -back[i];
        f.right[i] = right[i] * half * aspect;
        f.up[i] = up[i] * half;
    }
    return f;
}

// The least distance from which all corners of a box lie within the picture.
static double distance_of(const view_camera *camera, const double half[3], double aspect)
{
    view_frame f = view_camera_frame(camera, aspect);
    double tall = tan(0.5 * camera->fov), wide = tall * aspect, least = 0;
    for (int corner = 0; corner < 8; corner++) {
        double along = 0, u = 0, v = 0;
        for (int i = 0; i < 3; i++) {
            double p = corner >> i & 1 ? half[i] : -half[i];
            along += p * f.forward[i];
            u += p * f.right[i] / wide;
            v += p * f.up[i] / tall;
        }
        least = fmax(least, fmax(fabs(u) / wide, fabs(v) / tall) - along);
    }
    return least;
}

view_camera view_camera_fit(const double low[3], const double high[3], double azimuth,
                            double elevation, double aspect)
{
    view_camera camera = {{0, 0, 0}, 1, azimuth, 0, 35 * QUARTER / 90};
    double half[3];
    camera.elevation = between(elevation, -ELEVATION_MOST, ELEVATION_MOST);
    for (int i = 0; i < 3; i++) {
        camera.target[i] = 0.5 * (low[i] + high[i]);
        half[i] = 0.5 * (high[i] - low[i]) * MARGIN;
    }
    camera.distance = between(distance_of(&camera, half, aspect), DISTANCE_LEAST, DISTANCE_MOST);
    return camera;
}

void view_camera_orbit(view_camera *camera, double by_azimuth, double by_elevation)
{
    camera->azimuth = fmod(camera->azimuth + by_azimuth, 4 * QUARTER);
    camera->elevation = between(camera->elevation + by_elevation, -ELEVATION_MOST, ELEVATION_MOST);
}

void view_camera_pan(view_camera *camera, double du, double dv, double aspect)
{
    view_frame f = view_camera_frame(camera, aspect);
    for (int i = 0; i < 3; i++) {
        camera->target[i] -= camera->distance * (du * f.right[i] + dv * f.up[i]);
    }
}

void view_camera_zoom(view_camera *camera, double factor)
{
    camera->distance = between(camera->distance * factor, DISTANCE_LEAST, DISTANCE_MOST);
}
