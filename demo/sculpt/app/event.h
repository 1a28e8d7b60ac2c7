// SPDX-License-Identifier: MIT
// Events: all that a person can do to an editor, and a file of them.

#ifndef SCULPT_APP_EVENT_H
#define SCULPT_APP_EVENT_H

#include <stdio.h>

// Keys that are held.
enum { MOD_SHIFT = 1, MOD_CONTROL = 2, MOD_ALT = 4 };

// Buttons of a mouse.
enum { BUTTON_LEFT = 0, BUTTON_RIGHT = 1, BUTTON_MIDDLE = 2 };

typedef enum app_event_kind {
    EVENT_SIZE,  // the picture is x by y pixels
    EVENT_MOVE,  // the pointer is at x, y
    EVENT_PRESS, // of button `code`
    EVENT_RELEASE,
    EVENT_SCROLL, // by y notches
    EVENT_KEY,    // key `code`, a character of the keyboard: a letter is upper case
    EVENT_SET,    // number `code` of the settings becomes x
    EVENT_DO,     // action `code`
    EVENT_FLY,  // the camera by x, y, z to the right, up and forward, and turns by a, b; shares of
                // the picture and radians
    EVENT_OPEN, // a file, which is named beside the event
    EVENT_TIP,  // a mesh for the brush, named beside the event
    EVENT_KIND_COUNT
} app_event_kind;

// Settings.
typedef enum app_setting {
    SET_KIND,
    SET_SHAPE,
    SET_RADIUS,
    SET_MATERIAL,
    SET_PASSES,
    SET_MIRROR_X,
    SET_MIRROR_Y,
    SET_PLANE,
    SET_GHOSTS,
    SET_OVERHANGS,
    SET_GROUND,
    SET_SHADOWS,
    SET_CUT,
    SET_CUT_AXIS,
    SET_CUT_MM,
    SET_WORK, // the workspace: 0 to sculpt, 1 to balance, 2 to grade
    SETTING_COUNT
} app_setting;

typedef enum app_action {
    DO_UNDO,
    DO_REDO,
    DO_FRAME,   // show all
    DO_CLEAR,   // an empty bed
    DO_GIVE_UP, // the stroke that is under way
    DO_CLOSE,
    DO_DROP_GHOSTS,
    DO_STEP, // a piece of what a desk has under way
    ACTION_COUNT
} app_action;

typedef struct app_event {
    app_event_kind kind;
    int code;
    unsigned mods;
    double x, y, z, a, b;
} app_event;

enum { EVENT_PATH_SIZE = 512 };

// Whether its numbers are ones that a file of events may hold, and whether a path is. Who takes
// events from a person leaves out others, so that all that was done can be done again.
int app_event_is_good(const app_event *event);
int app_event_can_name(const char *path);

// Write one as a line of text, or read the next; 0 at the end, -1 for a line that is none. `path`
// is the file of EVENT_OPEN and EVENT_TIP; other events have none.
void app_event_write(FILE *file, const app_event *event, const char *path);
int app_event_read(FILE *file, app_event *event, char path[EVENT_PATH_SIZE]);

#endif
