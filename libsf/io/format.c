// SPDX-License-Identifier: MIT
// Which mesh format a file name asks for.

#include <sf/io.h>

#include <string.h>

typedef struct extension {
    const char *text; // lower case, with its dot
    sf_mesh_format format;
} extension;

static const extension extensions[] = {
    {".stl", SF_MESH_FORMAT_STL},   {".obj", SF_MESH_FORMAT_OBJ},     {".ply", SF_MESH_FORMAT_PLY},
    {".off", SF_MESH_FORMAT_OFF},   {".3mf", SF_MESH_FORMAT_THREEMF}, {".glb", SF_MESH_FORMAT_GLTF},
    {".gltf", SF_MESH_FORMAT_GLTF},
};

// ASCII only, whatever the locale says.
static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static int ends_with(const char *name, const char *ending)
{
    size_t name_length = strlen(name), length = strlen(ending);
    if (length > name_length) {
        return 0;
    }
    for (size_t i = 0; i < length; i++) {
        if (lower(name[name_length - length + i]) != ending[i]) {
            return 0;
        }
    }
    return 1;
}

sf_mesh_format sf_mesh_format_from_name(const char *name)
{
    for (size_t i = 0; name != NULL && i < sizeof extensions / sizeof extensions[0]; i++) {
        if (ends_with(name, extensions[i].text)) {
            return extensions[i].format;
        }
    }
    return SF_MESH_FORMAT_AUTO;
}
