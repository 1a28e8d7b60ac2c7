// SPDX-License-Identifier: MIT
// A shape as a mesh with colours, for viewers.

#ifndef DEMO_SF_COLORED_H
#define DEMO_SF_COLORED_H

#include "picture.h"

// Whether a name asks for one.
int colored_is_asked(const char *path);

// Write what a picture would show, from all sides: the surface of the shape in the axes of the
// input, each corner of a voxel that is not plain in the other colour.
exit_status colored_save(cli_job *job, const subject *what, const char *path);

#endif
