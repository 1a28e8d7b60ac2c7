// SPDX-License-Identifier: MIT
// Meshes in files, by the ending of their names, with a sentence where that fails.

#ifndef SCULPT_DESK_MESH_FILE_H
#define SCULPT_DESK_MESH_FILE_H

#include <sf/mesh.h>

#include "desk.h"

// NULL where that fails.
sf_mesh *mesh_file_read(const char *path, char why[DESK_WHY_SIZE]);

// 0 where that fails; then nothing shows under the name.
int mesh_file_write(sf_mesh_view mesh, const char *path, char why[DESK_WHY_SIZE]);

#endif
