// SPDX-License-Identifier: MIT
// Meshes in files.

#include "mesh_file.h"

#include <sf/io.h>
#include <stdio.h>

static int say(char why[DESK_WHY_SIZE], const char *path, sf_status status, const sf_fault *fault)
{
    const char *reason = fault->message[0] != '\0' ? fault->message : sf_status_message(status);
    if (status != SF_OK) {
        snprintf(why, DESK_WHY_SIZE, "%.180s: %s", path, reason);
    }
    return status == SF_OK;
}

sf_mesh *mesh_file_read(const char *path, char why[DESK_WHY_SIZE])
{
    sf_file *file = NULL;
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_file_open(path, NULL, &file, &fault);
    if (status == SF_OK) {
        status = sf_mesh_read(sf_file_source(file), sf_mesh_format_from_name(path), NULL, NULL,
                              &mesh, &fault);
    }
    sf_file_close(file);
    return say(why, path, status, &fault) ? mesh : NULL;
}

int mesh_file_write(sf_mesh_view mesh, const char *path, char why[DESK_WHY_SIZE])
{
    sf_save *file = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_save_begin(path, NULL, &file, &fault);
    if (status == SF_OK) {
        status = sf_mesh_write(mesh, sf_mesh_format_from_name(path), sf_save_sink(file));
        if (status == SF_OK) {
            status = sf_save_commit(file, &fault);
        } else {
            sf_save_abort(file);
        }
    }
    return say(why, path, status, &fault);
}
