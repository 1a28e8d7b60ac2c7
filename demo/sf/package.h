// SPDX-License-Identifier: MIT
// A 3MF file of meshes, with a picture of them for those who look through folders.

#ifndef DEMO_SF_PACKAGE_H
#define DEMO_SF_PACKAGE_H

#include "canvas.h"
#include "part.h"

// A mesh in the axes of the input, and what people call it.
typedef struct package_body {
    const char *name;
    const sf_mesh *mesh;
} package_body;

// Whether a name asks for 3MF.
int package_is_asked(const char *path);

// Write meshes into a file that was begun, each in its place; `picture` may have no pixels.
exit_status package_write(cli_job *job, const package_body *bodies, size_t count,
                          const canvas *picture, const char *path, sf_save *save);

// Draw a grid as a thumbnail. Without PNG the picture has no pixels, and all is well.
exit_status package_picture(cli_job *job, const sf_grid *grid, canvas *picture);

#endif
