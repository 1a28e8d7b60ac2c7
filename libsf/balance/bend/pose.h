// SPDX-License-Identifier: MIT
// Poses of handles, as the numbers that an optimiser turns.

#ifndef SF_BALANCE_POSE_H
#define SF_BALANCE_POSE_H

#include <sf/handles.h>

// The parameters of a handle: its scale, its shift along x, y, z in mm, and a turn beyond the one
// that it has, about x, y, z through its centre, in radians. The last is 0 at every pose, so that
// derivatives by it are those of a small turn.
enum { SFI_POSE_SCALE = 0, SFI_POSE_SHIFT = 1, SFI_POSE_TURN = 4, SFI_POSE_SIZE = 7 };

// Coefficients of the basis' functions, 12 numbers a handle: what handles in these poses do.
void sfi_pose_coefficients(const sf_pose *poses, const double *centres, size_t handle_count,
                           double *coefficients);

// Derivatives by the parameters, 7 a handle, from those by the coefficients, 12 a handle.
void sfi_pose_pull(const sf_pose *poses, size_t handle_count, const double *by_coefficients,
                   double *by_parameters);

// form_p = J^T form_y J: second derivatives of a quadratic form in the coefficients, square of 12 a
// handle, by the parameters, square of 7 a handle, without what comes of the curvature of turns.
void sfi_pose_pull_form(const sf_pose *poses, size_t handle_count, const double *by_coefficients,
                        double *by_parameters);

// sf_pose_move() by numbers.
sf_status sfi_pose_move(sf_pose *pose, const double by[SFI_POSE_SIZE]);

#endif
