// SPDX-License-Identifier: MIT
// A graded solid as a 3MF file.

#ifndef DEMO_SF_GRADED_PACKAGE_H
#define DEMO_SF_GRADED_PACKAGE_H

#include "press.h"

// Slice a solid, mix, and write its surface with what is inside: fractions of the materials and the
// properties that they were mixed for, layer by layer.
exit_status graded_package(press *p, const solid_input *in, const size_t *channels,
                           const char *path);

#endif
