// SPDX-License-Identifier: MIT
// Contours as the library itself asks for them: drawn as runs, which go wherever the caller likes.

#ifndef SF_VOXEL_CONTOUR_H
#define SF_VOXEL_CONTOUR_H

#include <sf/contour.h>

// Takes a run of solid voxels; called in row order, from left to right, never for empty ones, and
// with an empty voxel between those of a row. What it returns ends the drawing unless it is SF_OK.
typedef sf_status (*sfi_contour_run)(void *user, uint32_t x0, uint32_t x1, uint32_t y);

// Draw the contours on a lattice as runs. Checks everything before the first run.
sf_status sfi_contour_draw(const sf_lattice *lattice, const sf_contours *contours,
                           sf_contour_fill fill, const sf_allocator *allocator, sf_fault *fault,
                           sfi_contour_run run, void *user);

// What every call asks of contours: starts that begin at 0 and never fall, and points where there
// are some. The number of points is left in `points`.
sf_status sfi_contour_check(const sf_contours *contours, size_t *points);

#endif
