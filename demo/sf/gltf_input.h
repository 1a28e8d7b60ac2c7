// SPDX-License-Identifier: MIT
// Parts from glTF files.

#ifndef DEMO_SF_GLTF_INPUT_H
#define DEMO_SF_GLTF_INPUT_H

#include "job.h"

// Whether a file is glTF, by its name or its first bytes.
int gltf_looks_like(const char *path);

// Read one, in mm with z up. What is passed over is said in a warning.
exit_status gltf_load_mesh(cli_job *job, const char *path, sf_mesh **mesh);

#endif
