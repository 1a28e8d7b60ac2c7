// SPDX-License-Identifier: MIT
// Poses: the identity, how one changes, and what it is as an affine map.
//
// A turn by an angle a about a unit axis u is, with r = u tan(a / 2) and q = r . r,
//
//     R = ((1 - q) I + 2 r r^T + 2 [r]) / (1 + q),
//
// [r] the matrix of the cross product: a rotation up to rounding whatever tan is, so that poses
// stay rotations over many changes.

#include "balance/blend/blend.h"

#include "base/math.h"

#include <math.h>
#include <string.h>

sf_pose sf_pose_identity(void)
{
    sf_pose pose = {1, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
    return pose;
}

static int is_pose(const sf_pose *pose)
{
    int finite = isfinite(pose->scale);
    for (int n = 0; n < 9; n++) {
        finite &= isfinite(pose->turn[n]);
    }
    for (int n = 0; n < 3; n++) {
        finite &= isfinite(pose->shift_mm[n]);
    }
    return finite;
}

static void make_turn(const double spin[3], double angle, double turn[9])
{
    double part = angle > 0 ? sfi_tan(0.5 * angle) / angle : 0.5;
    double r[3] = {part * spin[0], part * spin[1], part * spin[2]};
    double q = (r[0] * r[0] + r[1] * r[1]) + r[2] * r[2];
    const double cross[9] = {0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0};
    for (int n = 0; n < 9; n++) {
        double sum = 2 * r[n / 3] * r[n % 3] + 2 * cross[n];
        turn[n] = ((n % 4 == 0 ? 1 - q : 0) + sum) / (1 + q);
    }
}

sf_status sf_pose_move(sf_pose *pose, const sf_pose_change *change)
{
    if (pose == NULL || change == NULL || !is_pose(pose)) {
        return SF_ERR_ARGUMENT;
    }
    const double *s = change->spin_rad;
    double turn[9], angle = sqrt((s[0] * s[0] + s[1] * s[1]) + s[2] * s[2]);
    sf_pose made = *pose;
    if (!(angle < 3)) {
        return SF_ERR_ARGUMENT;
    }
    make_turn(s, angle, turn);
    made.scale += change->scale;
    for (int r = 0; r < 3; r++) {
        made.shift_mm[r] += change->shift_mm[r];
        for (int c = 0; c < 3; c++) {
            made.turn[3 * r + c] =
                (turn[3 * r] * pose->turn[c] + turn[3 * r + 1] * pose->turn[3 + c]) +
                turn[3 * r + 2] * pose->turn[6 + c];
        }
    }
    if (!is_pose(&made)) {
        return SF_ERR_ARGUMENT;
    }
    *pose = made;
    return SF_OK;
}

int sfi_maps_make(const sf_pose *poses, const double *centers, size_t count, sfi_map *maps)
{
    for (size_t j = 0; j < count; j++) {
        const double *c = centers + 3 * j;
        double turned[3];
        if (!is_pose(&poses[j])) {
            return 0;
        }
        for (int n = 0; n < 9; n++) {
            maps[j].matrix[n] = poses[j].scale * poses[j].turn[n];
        }
        sfi_map_turn(maps[j].matrix, c, turned);
        for (int n = 0; n < 3; n++) {
            maps[j].shift[n] = (c[n] - turned[n]) + poses[j].shift_mm[n];
        }
    }
    return 1;
}
