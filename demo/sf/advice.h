// SPDX-License-Identifier: MIT
// How to look again at what was written.

#ifndef DEMO_SF_ADVICE_H
#define DEMO_SF_ADVICE_H

#include "part.h"

// Say which `sf check` looks at it on the same voxels and by the same rule as `p`. `path` is a mesh
// in the axes of the input, or a folder of layers; `inner` its cavity in a file of its own, or
// NULL.
void advice_check(cli_job *job, const part *p, const char *path, const char *inner);

#endif
