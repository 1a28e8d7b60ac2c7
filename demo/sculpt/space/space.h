// SPDX-License-Identifier: MIT
// SpaceMice: found, heard, lost and found again.

#ifndef SCULPT_SPACE_SPACE_H
#define SCULPT_SPACE_SPACE_H

#include "motion.h"

typedef struct space space;

// NULL only where there is no memory; that there is no device is no error.
space *space_create(void);
void space_destroy(space *s);

// What all devices did since the last call; never waits. `now_s` is seconds that only grow. 0 where
// they did nothing, and then motion is zero.
int space_poll(space *s, double now_s, space_motion *motion);

// Seconds until it is worth polling again.
double space_patience(const space *s);

// A sentence where there is a device and it cannot be used, else NULL.
const char *space_trouble(const space *s);

#endif
