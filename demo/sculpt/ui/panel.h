// SPDX-License-Identifier: MIT
// The panel beside the shape: brush, view, files, history, and what the keys do.
//
// It changes nothing by itself. What a person sets comes out as events, as keys and the pointer do,
// so that it can be recorded; what concerns files comes out as a request.

#ifndef SCULPT_UI_PANEL_H
#define SCULPT_UI_PANEL_H

#include "app/editor.h"

#ifdef __cplusplus
extern "C" {
#endif

struct GLFWwindow;

typedef struct panel panel;

enum { PANEL_PATH_SIZE = 512 };

// What a person asks for with a file.
typedef enum panel_wish {
    WISH_NOTHING,
    WISH_OPEN,    // a mesh or a session
    WISH_BRUSH,   // a mesh as the brush's shape
    WISH_SESSION, // save it
    WISH_SHAPE,   // save it: a mesh or a folder
    WISH_PICTURE
} panel_wish;

typedef struct panel_request {
    panel_wish wish;
    char path[PANEL_PATH_SIZE];
} panel_request;

// Callbacks of the window that are set before are called as well. NULL where it fails.
panel *panel_create(struct GLFWwindow *window, float scale);
void panel_destroy(panel *p);

// Lay it out; events go to `emit`. `request` says what is wished for with a file.
void panel_draw(panel *p, const editor *e, double frame_ms,
                void (*emit)(void *user, const app_event *event), void *user,
                panel_request *request);

// Whether the pointer, or the keyboard, is the panel's now.
int panel_has_pointer(const panel *p);
int panel_has_keys(const panel *p);

#ifdef __cplusplus
}
#endif

#endif
