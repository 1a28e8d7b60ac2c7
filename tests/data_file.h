// SPDX-License-Identifier: MIT
// Meshes of the folder that SF_DATA names.

#ifndef SF_TEST_DATA_FILE_H
#define SF_TEST_DATA_FILE_H

#include <sf/io.h>

#include "test.h"

// Read a mesh below SF_DATA; NULL, and why on standard output, when it cannot be read.
static inline sf_mesh *data_mesh_if(const char *path)
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
    return mesh;
}

// The same of one that must be there: a failed check when it cannot be read.
static inline sf_mesh *data_mesh(const char *path)
{
    sf_mesh *mesh = data_mesh_if(path);
    CHECK(mesh != NULL);
    return mesh;
}

#endif
