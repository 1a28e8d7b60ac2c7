// SPDX-License-Identifier: MIT
// The limits of a cell's corners as weights of its ring's points.

#ifndef SF_GRADE_LIMIT_CORNER_H
#define SF_GRADE_LIMIT_CORNER_H

#include "grade/limit/atlas.h"

// Work out the corners of all kinds of a closed atlas. SF_ERR_MEMORY; SF_ERR_INTERNAL.
sf_status sfi_corners_find_all(sfi_atlas *atlas);

#endif
