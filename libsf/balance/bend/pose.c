// SPDX-License-Identifier: MIT
// Poses of handles, as the numbers that an optimiser turns.
//
// A pose scales by s, turns by R and shifts by t: the coefficients of a handle's four functions
// (balance/bend/basis.h) are the columns of s R, then c + t. Their derivatives are R e_q by the
// scale, the identity by the shift, and e_a x (s R e_q) by a turn about axis a beyond R.

#include "balance/bend/pose.h"

#include "mesh/vector.h"

#include <math.h>
#include <string.h>

void sfi_pose_coefficients(const sf_pose *poses, const double *centres, size_t handle_count,
                           double *coefficients)
{
    for (size_t j = 0; j < handle_count; j++) {
        double *y = coefficients + 12 * j;
        for (size_t d = 0; d < 3; d++) {
            for (size_t q = 0; q < 3; q++) {
                y[3 * q + d] = poses[j].scale * poses[j].turn[3 * d + q];
            }
            y[9 + d] = centres[3 * j + d] + poses[j].shift_mm[d];
        }
    }
}

// Derivatives of one handle's 12 coefficients by its 7 parameters.
static void differentiate(const sf_pose *pose, double jacobian[12][SFI_POSE_SIZE])
{
    memset(jacobian, 0, 12 * sizeof *jacobian);
    for (size_t q = 0; q < 3; q++) {
        double column[3];
        for (size_t d = 0; d < 3; d++) {
            column[d] = pose->turn[3 * d + q];
            jacobian[3 * q + d][SFI_POSE_SCALE] = column[d];
        }
        for (size_t a = 0; a < 3; a++) {
            double axis[3] = {a == 0, a == 1, a == 2}, moved[3];
            sfi_cross(axis, column, moved);
            for (size_t d = 0; d < 3; d++) {
                jacobian[3 * q + d][SFI_POSE_TURN + a] = pose->scale * moved[d];
            }
        }
        jacobian[9 + q][SFI_POSE_SHIFT + q] = 1;
    }
}

void sfi_pose_pull(const sf_pose *poses, size_t handle_count, const double *by_coefficients,
                   double *by_parameters)
{
    for (size_t j = 0; j < handle_count; j++) {
        double jacobian[12][SFI_POSE_SIZE];
        differentiate(&poses[j], jacobian);
        for (size_t p = 0; p < SFI_POSE_SIZE; p++) {
            double sum = 0;
            for (size_t y = 0; y < 12; y++) {
                sum += jacobian[y][p] * by_coefficients[12 * j + y];
            }
            by_parameters[SFI_POSE_SIZE * j + p] = sum;
        }
    }
}

// One block of the form, between the parameters of two handles.
static void pull_block(double first[12][SFI_POSE_SIZE], double second[12][SFI_POSE_SIZE],
                       const double *from, size_t from_stride, double *to, size_t to_stride)
{
    double half[12][SFI_POSE_SIZE];
    for (size_t y = 0; y < 12; y++) {
        for (size_t p = 0; p < SFI_POSE_SIZE; p++) {
            half[y][p] = 0;
            for (size_t z = 0; z < 12; z++) {
                half[y][p] += from[y * from_stride + z] * second[z][p];
            }
        }
    }
    for (size_t o = 0; o < SFI_POSE_SIZE; o++) {
        for (size_t p = 0; p < SFI_POSE_SIZE; p++) {
            double sum = 0;
            for (size_t y = 0; y < 12; y++) {
                sum += first[y][o] * half[y][p];
            }
            to[o * to_stride + p] = sum;
        }
    }
}

void sfi_pose_pull_form(const sf_pose *poses, size_t handle_count, const double *by_coefficients,
                        double *by_parameters)
{
    size_t from_stride = 12 * handle_count, to_stride = SFI_POSE_SIZE * handle_count;
    for (size_t i = 0; i < handle_count; i++) {
        double first[12][SFI_POSE_SIZE], second[12][SFI_POSE_SIZE];
        differentiate(&poses[i], first);
        for (size_t j = 0; j < handle_count; j++) {
            differentiate(&poses[j], second);
            pull_block(first, second, by_coefficients + 12 * i * from_stride + 12 * j, from_stride,
                       by_parameters + SFI_POSE_SIZE * (i * to_stride + j), to_stride);
        }
    }
}

sf_status sfi_pose_move(sf_pose *pose, const double by[SFI_POSE_SIZE])
{
    sf_pose_change change = {.scale = by[SFI_POSE_SCALE]};
    for (size_t d = 0; d < 3; d++) {
        change.shift_mm[d] = by[SFI_POSE_SHIFT + d];
        change.spin_rad[d] = by[SFI_POSE_TURN + d];
    }
    return sf_pose_move(pose, &change);
}
