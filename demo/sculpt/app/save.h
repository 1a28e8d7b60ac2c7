// SPDX-License-Identifier: MIT
// What a person takes away: a session, a mesh, a stack of layers, a picture.

#ifndef SCULPT_APP_SAVE_H
#define SCULPT_APP_SAVE_H

#include <sf/session.h>

#include "editor.h"

// Each returns 0 where it fails, with a sentence in `why`; then nothing shows under the name.
// A NULL session is one for which there was no memory.
int app_save_session(const sf_session *session, const char *path, char why[APP_WHY_SIZE]);

// What is printable: a mesh where the name ends in .stl, .obj, .ply or .3mf, else a folder with
// layers.
int app_save_shape(const sf_sculpt *model, const char *path, char why[APP_WHY_SIZE]);

// What is worked at: the session of the strokes, or what the desk saves.
int app_save_work(editor *e, const char *path, char why[APP_WHY_SIZE]);

// Pixels of 3 bytes, row 0 on top, as PNG.
int app_save_picture(const unsigned char *pixels, uint32_t width, uint32_t height, const char *path,
                     char why[APP_WHY_SIZE]);

#endif
