// SPDX-License-Identifier: MIT
// The window, seen from inside: what its parts share.

#ifndef SCULPT_APP_APP_H
#define SCULPT_APP_APP_H

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <stdio.h>

#include "card.h"
#include "editor.h"
#include "options.h"
#include "rough.h"
#ifdef SCULPT_HAVE_PANEL
#include "ui/panel.h"
#endif
#ifdef SCULPT_HAVE_SPACE
#include "space/space.h"
#endif
#include "show.h"
#include "view/upload.h"

typedef struct app {
    const app_options *options;
    GLFWwindow *window;
    editor *editor;
    view *view;
    view_upload *upload; // NULL where there is
    card *twin;          // one of the model on the graphics card
    show show;           // of the desks; made when one is first seen
    FILE *record, *play;
    double frame_ms;
    int is_stale; // something happened that may show
    int is_rough; // and the last frame was a rough one
    rough rough;
#ifdef SCULPT_HAVE_PANEL
    panel *panel;
#endif
#ifdef SCULPT_HAVE_SPACE
    space *space;
    const char *space_trouble; // what was said of it last
#endif
} app;

// Take an event: into the record, then into the editor. `user` is the app.
void app_take(void *user, const app_event *event);

// Listen to the window.
void app_listen(app *a);

// Open a mesh or a session in the place of what is there. What cannot be opened leaves everything
// as it is, and says why in editor.said.
void app_open_file(app *a, const char *path);

// A mesh for the brush.
void app_open_brush(app *a, const char *path);

// Buffers for the editor's model; 0 where the card has no room, and then editor.said says so.
int app_look_anew(app *a);

#ifdef SCULPT_HAVE_PANEL
// Do what the panel asks for with a file.
void app_grant(app *a, const panel_request *request);
#endif

#endif
