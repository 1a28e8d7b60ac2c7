// SPDX-License-Identifier: MIT
// Without a window: a picture, a hash, times.

#ifndef SCULPT_APP_SHOT_H
#define SCULPT_APP_SHOT_H

#include "editor.h"
#include "options.h"

// Does what --headless was asked for. The program's exit status.
int app_run_headless(const app_options *options);

// Bring an editor to the view that the command line asks for.
void app_set_out(editor *e, const app_options *options);

#endif
