// SPDX-License-Identifier: MIT
// A model of the library's, copied to where a view looks for it.

#ifndef SCULPT_VIEW_UPLOAD_H
#define SCULPT_VIEW_UPLOAD_H

#include <sf/sculpt.h>

#include "gpu/gpu_sculpt.h"

typedef struct view_upload view_upload;

// Buffers for grids of a lattice, empty. NULL where the card has no room; *why says so.
view_upload *view_upload_create(const sf_lattice *lattice, const char **why);
void view_upload_destroy(view_upload *upload);

// Copy what lies within a box, or everything where box is NULL. Both grids are of the lattice;
// materials may be NULL: then all is material 1. 0 where there is no memory.
int view_upload_copy(view_upload *upload, const sf_grid *drawn, const sf_grid *printable,
                     const uint8_t *materials, const sf_box *box);

gpu_view view_upload_view(const view_upload *upload);

#endif
