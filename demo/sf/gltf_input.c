// SPDX-License-Identifier: MIT
// Parts from glTF files.
//
// tinygltf, which parses them, is tried by a child first (child.c). Buffers that stand in other
// files are looked for beside the file itself and nowhere else.

#include "gltf_input.h"

#include "child.h"
#include "progress.h"

#include <sf/gltf.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct trial {
    const unsigned char *bytes;
    size_t size;
    sf_gltf_options options;
} trial;

int gltf_looks_like(const char *path)
{
    char head[4] = "";
    if (sf_mesh_format_from_name(path) == SF_MESH_FORMAT_GLTF) {
        return 1;
    }
    FILE *file = fopen(path, "rb");
    int is_one = file != NULL && fread(head, 1, 4, file) == 4 && memcmp(head, "glTF", 4) == 0;
    if (file != NULL) {
        fclose(file);
    }
    return is_one;
}

static sf_status read_trial(const trial *t, sf_mesh **mesh, sf_gltf_report *passed, sf_fault *fault)
{
    sf_memory_cursor cursor = {t->bytes, t->size, 0};
    return sf_gltf_read(sf_memory_source(&cursor), &t->options, NULL, mesh, passed, fault);
}

// A child that runs out of memory has found that the parent would.
static int try_gltf(void *context)
{
    sf_mesh *mesh = NULL;
    sf_status status = read_trial(context, &mesh, NULL, NULL);
    sf_mesh_destroy(mesh);
    return status == SF_ERR_MEMORY;
}

static void warn(cli_job *job, const sf_gltf_report *r)
{
    if (r->skinned + r->morphed + r->animations > 0) {
        job_warn(
            job,
            "The glTF file has %zu animations, %zu nodes with a skin and %zu meshes with shapes to "
            "blend to; none is applied: the part is as it was modelled.",
            r->animations, r->skinned, r->morphed);
    }
    if (r->passed > 0) {
        job_warn(job, "The glTF file has %zu sets of points or lines, which are passed over.",
                 r->passed);
    }
}

// The folder that a file lies in.
static sf_status open_folder(const char *path, sf_directory **directory)
{
    const char *slash = strrchr(path, '/');
    size_t length = slash == NULL ? 0 : (size_t)(slash - path);
    char *folder = malloc(length + 2);
    if (folder == NULL) {
        return SF_ERR_MEMORY;
    }
    memcpy(folder, slash == NULL ? "." : slash == path ? "/" : path, length + (length == 0));
    folder[length + (length == 0)] = '\0';
    sf_status status = sf_directory_read(folder, NULL, directory, NULL);
    free(folder);
    return status;
}

exit_status gltf_load_mesh(cli_job *job, const char *path, sf_mesh **mesh)
{
    unsigned char *bytes = NULL;
    size_t size = 0;
    sf_gltf_report passed;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_directory *directory = NULL;
    progress_phase("reading");
    exit_status status = child_read_bytes(job, path, &bytes, &size);
    trial t = {bytes, size, sf_gltf_options_default()};
    sf_folder folder;
    if (status == EXIT_GOOD && open_folder(path, &directory) == SF_OK) {
        folder = sf_directory_folder(directory);
        t.options.folder = &folder;
    }
    if (status == EXIT_GOOD && sf_gltf_is_served() && !child_survives(try_gltf, &t)) {
        status =
            job_fail(job, EXIT_INPUT,
                     "%s is damaged so badly that the library for glTF fails, or wants more than "
                     "8 GiB or a minute to be read.",
                     path);
    }
    if (status == EXIT_GOOD) {
        sf_status read = read_trial(&t, mesh, &passed, &fault);
        status = read == SF_OK ? EXIT_GOOD : job_fail_call(job, read, &fault, path, EXIT_INPUT);
    }
    if (status == EXIT_GOOD) {
        warn(job, &passed);
    }
    sf_directory_close(directory);
    free(bytes);
    return status;
}
