// SPDX-License-Identifier: MIT
// Without a window: a picture, a hash, times.

#ifndef SCULPT_APP_SHOT_H
#define SCULPT_APP_SHOT_H

#include "options.h"

// Does what --headless was asked for. The program's exit status.
int app_run_headless(const app_options *options);

#endif
