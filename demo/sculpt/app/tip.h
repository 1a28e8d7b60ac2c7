// SPDX-License-Identifier: MIT
// The tip of the brush in hand: by formula, or a mesh that was opened for it.

#ifndef SCULPT_APP_TIP_H
#define SCULPT_APP_TIP_H

#include "editor.h"

// The brush's shape is the mesh: one beyond the shapes by formula.
enum { TIP_MESH = SF_TIP_CONE + 1 };

// Make the editor's tip where there is none. 0 where there is no memory, or the mesh is so small
// that it has no voxel.
int tip_make(editor *e);

// Forget it; it is made anew for the next stroke.
void tip_forget(editor *e);

// Write it into the session. 0 where there is no memory.
int tip_record(editor *e, uint32_t *tip);

// Take a mesh, which is the editor's from now on, for tips: as large as the brush's radius along
// its longest side. 0 where it has no size: then it stays the caller's.
int tip_take_mesh(editor *e, sf_mesh *mesh);

void tip_destroy(editor *e);

#endif
