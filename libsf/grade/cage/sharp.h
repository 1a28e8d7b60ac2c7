// SPDX-License-Identifier: MIT
// What is sharp in a cage.

#ifndef SF_GRADE_CAGE_SHARP_H
#define SF_GRADE_CAGE_SHARP_H

#include "grade/cage/complex.h"

// Put a cage's creases and sharp points into its complex. SF_ERR_ARGUMENT, SF_ERR_UNSUPPORTED with
// a sentence: one that is there twice, is no number of 0 or more, is no edge, or lies inside;
// SF_ERR_MEMORY.
sf_status sfi_sharp_set(const sf_cage_view *view, sfi_complex *complex, sf_fault *fault);

#endif
