// SPDX-License-Identifier: MIT
// Programs of the graphics card, made of the sources that the build put in.

#ifndef SCULPT_GL_PROGRAM_H
#define SCULPT_GL_PROGRAM_H

#include <stddef.h>

// A compute program of a source and those that it includes. 0 where that fails: then `log` says
// why, cut to its size.
unsigned gl_compute_program(const char *name, char *log, size_t log_size);

// The same of a vertex and a fragment shader.
unsigned gl_draw_program(const char *vertex, const char *fragment, char *log, size_t log_size);

#endif
