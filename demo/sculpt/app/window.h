// SPDX-License-Identifier: MIT
// The window.

#ifndef SCULPT_APP_WINDOW_H
#define SCULPT_APP_WINDOW_H

#include "options.h"

// Opens it and stays until it is closed. The program's exit status.
int app_run_window(const app_options *options);

#endif
