// SPDX-License-Identifier: MIT
// Turning a part so that the axis that points up becomes z.

#ifndef DEMO_SF_UPRIGHT_H
#define DEMO_SF_UPRIGHT_H

#include "options.h"

// Map from the input's axes to build axes, times `factor`; `back` gives the turn back, factor 1.
// Both are proper rotations by quarter turns: nothing is mirrored and nothing is rounded.
sf_transform upright(axis up, double factor);
sf_transform upright_back(axis up);

#endif
