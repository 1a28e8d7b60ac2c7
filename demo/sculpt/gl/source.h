// SPDX-License-Identifier: MIT
// Sources of shaders, as the build put them into the program (embed.awk).

#ifndef SCULPT_GL_SOURCE_H
#define SCULPT_GL_SOURCE_H

#include <stddef.h>

typedef struct gl_source {
    const char *name;         // of the file: "walk.comp"
    const char *const *lines; // each with its newline; NULL after the last
} gl_source;

// All of them; one without a name after the last.
extern const gl_source gl_sources[];

#endif
