// SPDX-License-Identifier: MIT
// What an editor does with the brush in hand.

#ifndef SCULPT_APP_STROKE_H
#define SCULPT_APP_STROKE_H

#include "editor.h"

// Begin a stroke where the pointer is, go on to where it is now, end it, give it up.
void editor_stroke_begin(editor *e, unsigned mods);
void editor_stroke_on(editor *e);
void editor_stroke_end(editor *e);
void editor_stroke_give_up(editor *e);

// Bring the brush's radius within what a tip can be, and forget the tip.
void editor_bound_brush(editor *e);

// A call has changed the model.
void editor_note(editor *e, const sf_sculpt_change *change);

// A step was done.
void editor_record_step(editor *e, sf_session_step step);

#endif
