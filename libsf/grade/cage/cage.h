// SPDX-License-Identifier: MIT
// The inside of a cage.

#ifndef SF_GRADE_CAGE_CAGE_H
#define SF_GRADE_CAGE_CAGE_H

#include <sf/cage.h>

#include "grade/cage/complex.h"
#include "grade/channels.h"

struct sf_cage {
    sf_allocator allocator;
    uint32_t points;
    uint32_t cells; // faces in dimension 2
    double *positions;
    uint32_t *starts, *corners;
    size_t crease_count, sharp_count;
    sf_crease *creases;
    sf_sharp_point *sharps;
    sfi_channels channels;
    sfi_complex complex; // sharp as creases and sharps say
};

// Coordinates lie within this, mm.
#define SFI_CAGE_REACH 1e12

// Whether all of `points` positions do; the fault names the first that does not.
sf_status sfi_positions_check(size_t points, const double *positions, sf_fault *fault);

#endif
