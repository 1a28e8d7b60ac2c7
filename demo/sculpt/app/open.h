// SPDX-License-Identifier: MIT
// What a person begins with: an empty bed, a mesh, a scene.

#ifndef SCULPT_APP_OPEN_H
#define SCULPT_APP_OPEN_H

#include <sf/session.h>

#include "options.h"

#define APP_WHY_SIZE 320

// A mesh, in the middle of the bed, as large as it is; voxels are as large as it takes. What of it
// does not print without supports is left out. The model is new; NULL where that fails, and `why`
// gets a sentence.
sf_sculpt *app_open_mesh(const char *path, const app_options *options, char why[APP_WHY_SIZE]);

// What a session gives, in its own space; and the session, to be gone on with.
sf_sculpt *app_open_session(const char *path, sf_session **session, char why[APP_WHY_SIZE]);

// What the command line asks to begin with, and the session that made it; NULL where none did.
sf_sculpt *app_open(const app_options *options, sf_session **session, char why[APP_WHY_SIZE]);

// A number for a model: the same for the same bits and materials, and hardly for others.
uint64_t app_hash(const sf_sculpt *model);

// The same for its parts: two grids of the same counts, and a byte for each voxel.
uint64_t app_hash_of(const sf_grid *drawn, const sf_grid *printable, const uint8_t *materials);

#endif
