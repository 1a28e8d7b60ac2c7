// SPDX-License-Identifier: MIT
// The cap is the shape in the hand: pushed to the right, the shape goes to the right, so the camera
// goes to the left; pulled nearer, the shape comes nearer; turned, it turns the same way. There is
// no roll, because z stays up.
//
// The farther the cap is from where it rests, the faster; speed grows with the square, so that a
// light touch is fine and a push is fast. About the middle nothing moves: caps do not come back to
// exactly where they were.

#include "motion.h"

#define REST 4.0

// Per second, the cap as far as it goes.
#define MOVE_MOST 2.5
#define FORWARD_MOST 1.8
#define TURN_MOST 2.4

// From -1 to 1.
static double speed_of(int number)
{
    double far = number < 0 ? -(double)number : number;
    far = far <= REST ? 0 : (far - REST) / (SPACE_FULL - REST);
    far = far > 1 ? 1 : far;
    return number < 0 ? -far * far : far * far;
}

void space_motion_add(space_motion *motion, const space_state *state, double seconds)
{
    const int *a = state->axes;
    motion->right -= MOVE_MOST * seconds * speed_of(a[SPACE_X]);
    motion->up += MOVE_MOST * seconds * speed_of(a[SPACE_Z]);
    motion->forward += FORWARD_MOST * seconds * speed_of(a[SPACE_Y]);
    motion->turn += TURN_MOST * seconds * speed_of(a[SPACE_RZ]);
    motion->tilt += TURN_MOST * seconds * speed_of(a[SPACE_RX]);
}

static int is_held(uint32_t buttons, int button)
{
    return button >= 0 && (buttons >> button & 1) != 0;
}

void space_motion_press(space_motion *motion, const space_model *model, uint32_t before,
                        uint32_t now)
{
    uint32_t fresh = now & ~before;
    motion->pressed |= (is_held(fresh, model->undo) ? (unsigned)SPACE_UNDO : 0) |
                       (is_held(fresh, model->fit) ? (unsigned)SPACE_FIT : 0) |
                       (is_held(fresh, model->escape) ? (unsigned)SPACE_ESCAPE : 0);
}

int space_motion_is_none(const space_motion *m)
{
    return !(m->right < 0) && !(m->right > 0) && !(m->up < 0) && !(m->up > 0) &&
           !(m->forward < 0) && !(m->forward > 0) && !(m->turn < 0) && !(m->turn > 0) &&
           !(m->tilt < 0) && !(m->tilt > 0) && m->pressed == 0;
}
