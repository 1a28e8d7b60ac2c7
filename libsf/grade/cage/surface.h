// SPDX-License-Identifier: MIT
// Whether the surface of a complex is one that has a limit.

#ifndef SF_GRADE_CAGE_SURFACE_H
#define SF_GRADE_CAGE_SURFACE_H

#include "grade/cage/complex.h"

// Each edge of the surface lies between two of its faces (in dimension 2 at most two), and the
// faces around a point follow each other in one fan. SF_ERR_UNSUPPORTED with a sentence that names
// an edge or a point where not; SF_ERR_MEMORY.
sf_status sfi_surface_check(const sfi_complex *complex, sf_fault *fault);

#endif
