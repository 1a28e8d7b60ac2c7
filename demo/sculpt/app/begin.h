// SPDX-License-Identifier: MIT
// The editor that the command line asks for.

#ifndef SCULPT_APP_BEGIN_H
#define SCULPT_APP_BEGIN_H

#include "editor.h"
#include "options.h"

// NULL where that fails: a sentence has gone to stderr, and *status is what to exit with.
editor *app_begin(const app_options *options, int *status);

// Open a file where one works: a mesh or a session, or what the desk opens. What cannot be opened
// leaves everything as it is; then it is 0, and editor.said says why.
int app_open_in_place(editor *e, const app_options *options, const char *path);

// Open a mesh for the brush. 0 where it cannot be: then the brush is as it was, and editor.said
// says why.
int app_open_tip(editor *e, const char *path);

#endif
