// SPDX-License-Identifier: MIT
// A context of OpenGL 4.5 without a window, a display or a screen.

#ifndef SCULPT_GL_HEADLESS_H
#define SCULPT_GL_HEADLESS_H

typedef struct gl_headless gl_headless;

// Make one and make it current. NULL where that fails, and *why is a sentence that says why.
gl_headless *gl_headless_create(const char **why);

void gl_headless_destroy(gl_headless *headless);

#endif
