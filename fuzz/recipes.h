// SPDX-License-Identifier: MIT
// The recipes that world_make() chooses from, a function for each kind of object or for two of a
// kind. Each returns a new object, or NULL where the bytes make none.

#ifndef SF_FUZZ_RECIPES_H
#define SF_FUZZ_RECIPES_H

#include "world.h"

void *world_make_grid(world *w);
void *world_make_mesh(world *w);
void *world_make_cage(world *w);
void *world_make_weights(world *w);
void *world_make_stance(world *w);
void *world_make_checker(world *w);
void *world_make_certificate(world *w);
void *world_make_tets(world *w);
void *world_make_refinement(world *w);
void *world_make_limit(world *w);
void *world_make_path(world *w, int map);
void *world_make_mask(world *w);
void *world_make_tone_machine(world *w, int diffuses);
void *world_make_slicer(world *w, int shell);
void *world_make_curve(world *w);
void *world_make_mixture(world *w);
void *world_make_sampler(world *w);
void *world_make_locator(world *w);
void *world_make_history(world *w);

#endif
