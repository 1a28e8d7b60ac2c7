// SPDX-License-Identifier: MIT
// What a SpaceMouse did, as events.

#ifndef SCULPT_APP_FLY_H
#define SCULPT_APP_FLY_H

#include "event.h"
#include "space/motion.h"

#define FLY_EVENTS_MOST 4

// The events, in order; how many. `aspect` is the picture's width by its height.
int app_fly(const space_motion *motion, double aspect, app_event events[FLY_EVENTS_MOST]);

#endif
