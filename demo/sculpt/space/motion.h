// SPDX-License-Identifier: MIT
// From where the cap of a SpaceMouse is held to what that does to a camera.

#ifndef SCULPT_SPACE_MOTION_H
#define SCULPT_SPACE_MOTION_H

#include "report.h"

enum { SPACE_UNDO = 1, SPACE_FIT = 2, SPACE_ESCAPE = 4 };

// The camera moves to its right and upwards by halves of the picture's height, forward by powers of
// e of its distance, and turns around what it looks at: azimuth and elevation in radians.
typedef struct space_motion {
    double right, up, forward, turn, tilt;
    unsigned pressed; // SPACE_UNDO and so on: what was pressed since
} space_motion;

// Add what a cap does that is held so for some seconds.
void space_motion_add(space_motion *motion, const space_state *state, double seconds);

// Add the buttons that are held now and were not before.
void space_motion_press(space_motion *motion, const space_model *model, uint32_t before,
                        uint32_t now);

int space_motion_is_none(const space_motion *motion);

#endif
