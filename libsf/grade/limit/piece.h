// SPDX-License-Identifier: MIT
// What comes of a kind of ring when it is cut once.

#ifndef SF_GRADE_LIMIT_PIECE_H
#define SF_GRADE_LIMIT_PIECE_H

#include "grade/limit/atlas.h"

// Work out the pieces of a kind: their kinds, which are added where they are new, and the matrices
// that lead to them. SF_ERR_MEMORY.
sf_status sfi_piece_find_all(sfi_atlas *atlas, uint32_t kind);

#endif
