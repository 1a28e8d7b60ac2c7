// SPDX-License-Identifier: MIT
// Workspaces: which one is worked in, and the events that go to its desk.

#ifndef SCULPT_APP_WORK_H
#define SCULPT_APP_WORK_H

#include "editor.h"

#ifdef __cplusplus
extern "C" {
#endif

// The names that --workspace takes; NULL for what this build has not.
const char *work_name(workspace work);

// Go to a workspace. A desk that is gone to for the first time takes the shape that was sculpted,
// if there is one and it is for shapes. editor.said tells why where that fails.
void work_go_to(editor *e, workspace work);

// Give a setting, an action or a key to the desk. The last two are 0 where they are not the desk's.
void work_set(editor *e, int setting, double x);
int work_act(editor *e, int action);
int work_key(editor *e, int code, unsigned mods);

// Whether the desk that is worked at wants to go on.
int work_is_busy(const editor *e);

void work_destroy(editor *e);

#ifdef __cplusplus
}
#endif

#endif
