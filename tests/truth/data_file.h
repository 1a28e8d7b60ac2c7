// SPDX-License-Identifier: MIT
// Meshes of the folder that SF_DATA names.

#ifndef TESTS_TRUTH_DATA_FILE_H
#define TESTS_TRUTH_DATA_FILE_H

#include <sf/io.h>

#include "test.h"

// Read a mesh below SF_DATA; NULL, and a failed check, when it cannot be read.
static inline sf_mesh *data_mesh(const char *path)
{
    char name[1024];
    sf_file *file = NULL;
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    snprintf(name, sizeof name, "%s/%s", getenv("SF_DATA"), path);
    sf_status status = sf_file_open(name, NULL, &file, &fault);
    if (status == SF_OK) {
        status = sf_mesh_read(sf_file_source(file), SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, &fault);
        sf_file_close(file);
    }
    if (status != SF_OK) {
        printf("# %s: %s\n", path, fault.message);
    }
    CHECK_EQ(status, SF_OK);
    return mesh;
}

#endif
