// SPDX-License-Identifier: MIT
// Voxels that are less than a distance apart, as structuring elements.

#ifndef SF_BALANCE_APART_H
#define SF_BALANCE_APART_H

#include <sf/voxel.h>

// How far two voxels that are (dx, dy) apart are held to be along an axis: (|d| - less) pitches,
// and not less than 0.
#define SFI_APART_BOXES 1.0   // the gap between the boxes
#define SFI_APART_CENTRES 0.0 // the distance of the centres

// The element of all (dx, dy) whose squared distance across is less than `left` mm2. Returns 0
// where there is none; what would reach beyond SF_REACH_MAX is cut off.
int sfi_apart_element(double left, double less, double pitch_x_mm, double pitch_y_mm,
                      sf_element *element);

// Whether none of these elements is cut off.
int sfi_apart_fits(double limit_mm, double pitch_x_mm, double pitch_y_mm);

#endif
