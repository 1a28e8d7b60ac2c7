// SPDX-License-Identifier: MIT
// The panel's part for the Grade workspace.

#ifndef SCULPT_UI_PANEL_GRADE_H
#define SCULPT_UI_PANEL_GRADE_H

#include "desk/desk.h"
#include "outlet.h"

void panel_grade(const outlet &out, const desk *d);
void panel_grade_keys();

#endif
