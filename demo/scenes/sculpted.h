// SPDX-License-Identifier: MIT
// Scenes that brushes made, as sessions: for people without an idea, for tests and for benches.

#ifndef DEMO_SCENES_SCULPTED_H
#define DEMO_SCENES_SCULPTED_H

#include <sf/session.h>

// Names of them all; NULL after the last.
extern const char *const sculpted_names[];

// The strokes of a scene, on a cube of `resolution` voxels along each side (64 to 512), of which
// 512 are 0.25 mm each: the same shape whatever the resolution. SF_ERR_ARGUMENT: no such scene.
//
//   shaun        a sheep: four legs, a body of two balls that are trimmed into an arch, its wool in
//                little balls, a head with ears
//   pumpkin      hollow, with ribs, a face to carve out and arms; for a tea light
//   intertwined  three strands around each other, joined at the top
sf_status sculpted_session(const char *name, uint32_t resolution, const sf_allocator *allocator,
                           sf_session **session);

#endif
