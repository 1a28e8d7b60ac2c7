// SPDX-License-Identifier: MIT
// A progress bar on a terminal, and Ctrl-C.

#ifndef DEMO_SF_PROGRESS_H
#define DEMO_SF_PROGRESS_H

#include <sf/base.h>

// Make `task` show its progress on standard error (when that is a terminal and `quiet` is 0), use
// `threads` threads, and stop at Ctrl-C; a second Ctrl-C ends the program. One task a program.
void progress_attach(sf_task *task, int quiet, int threads);

// Name what the work that follows does ("reading part.stl"). Clears the bar of what came before.
void progress_phase(const char *name);

// Leave a line on the terminal, where there is one that may be drawn on; the bar goes on below it.
void progress_line(const char *format, ...)
#if defined(__GNUC__) && !defined(__MINGW32__) // whose printf is another
    __attribute__((format(printf, 1, 2)))
#endif
    ;

// Clear the bar and let the threads go.
void progress_end(void);

#endif
