// SPDX-License-Identifier: MIT
// Scenes that the program makes itself, for people without a part at hand, for tests and benches.

#ifndef DEMO_SCENES_SCENE_H
#define DEMO_SCENES_SCENE_H

#include <sf/sf.h>

// Size of a scene's box in mm, its lower corner at the origin. Returns 0 when there is no such
// scene. There is "garden": a gate, a mushroom, a lamp on an arm, a bird in the air.
int scene_size(const char *name, double size_mm[3]);

// Make the voxels of `grid` solid whose centres lie in the scene. The grid must be empty.
sf_status scene_draw(const char *name, sf_grid *grid, sf_task *task);

#endif
