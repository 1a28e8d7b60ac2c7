// SPDX-License-Identifier: MIT
// What a SpaceMouse did, as events, so that it is recorded and done again as all else is.

#include "fly.h"

static int put_action(int action, app_event *event)
{
    const app_event e = {EVENT_DO, action, 0, 0, 0, 0, 0, 0};
    *event = e;
    return 1;
}

int app_fly(const space_motion *motion, double aspect, app_event events[FLY_EVENTS_MOST])
{
    space_motion moves = *motion;
    int count = 0;
    if ((motion->pressed & SPACE_ESCAPE) != 0) {
        count += put_action(DO_GIVE_UP, &events[count]);
    }
    if ((motion->pressed & SPACE_UNDO) != 0) {
        count += put_action(DO_UNDO, &events[count]);
    }
    if ((motion->pressed & SPACE_FIT) != 0) {
        count += put_action(DO_FRAME, &events[count]);
    }
    moves.pressed = 0;
    if (!space_motion_is_none(&moves)) {
        // An event's shares are of the width along x and of the height along y.
        double across = aspect > 0 ? motion->right / aspect : motion->right;
        const app_event e = {EVENT_FLY,    0,           0, across, motion->up, motion->forward,
                             motion->turn, motion->tilt};
        events[count++] = e;
    }
    return count;
}
