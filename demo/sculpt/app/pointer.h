// SPDX-License-Identifier: MIT
// The pointer of an editor.

#ifndef SCULPT_APP_POINTER_H
#define SCULPT_APP_POINTER_H

#include "editor.h"

// Find anew what it is over, as when the camera has moved.
void pointer_find(editor *e);

void pointer_move(editor *e, const app_event *event);
void pointer_press(editor *e, const app_event *event);
void pointer_release(editor *e, const app_event *event);

#endif
