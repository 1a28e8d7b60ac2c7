// SPDX-License-Identifier: MIT
// The panel's part for the Balance workspace.

#ifndef SCULPT_UI_PANEL_BALANCE_H
#define SCULPT_UI_PANEL_BALANCE_H

#include "desk/desk.h"
#include "outlet.h"

void panel_balance(const outlet &out, const desk *d);
void panel_balance_keys();

#endif
