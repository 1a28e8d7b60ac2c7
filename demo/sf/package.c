// SPDX-License-Identifier: MIT
// A 3MF file of meshes, with a picture of them for those who look through folders.
//
// The picture is held in memory, since it is small and the file names its size.

#include "package.h"

#include "picture.h"

#include <sf/threemf.h>

#include <stdlib.h>
#include <string.h>

enum { THUMBNAIL = 256 };

// A PNG file as it grows.
typedef struct bytes {
    unsigned char *data;
    size_t size, capacity;
} bytes;

static sf_status put(void *user, const void *data, size_t size)
{
    bytes *b = user;
    if (size > b->capacity - b->size) {
        size_t capacity = 2 * (b->size + size);
        unsigned char *grown = realloc(b->data, capacity);
        if (grown == NULL) {
            return SF_ERR_MEMORY;
        }
        b->data = grown;
        b->capacity = capacity;
    }
    memcpy(b->data + b->size, data, size);
    b->size += size;
    return SF_OK;
}

int package_is_asked(const char *path)
{
    return sf_mesh_format_from_name(path) == SF_MESH_FORMAT_THREEMF;
}

exit_status package_picture(cli_job *job, const sf_grid *grid, canvas *picture)
{
    subject what = {grid, grid, picture_lost, sf_grid_bounds(grid)};
    frame where = {0, 0, THUMBNAIL, THUMBNAIL, 2};
    double pixel_mm = 0;
    memset(picture, 0, sizeof *picture);
    if (!sf_stack_has_png()) {
        return EXIT_GOOD;
    }
    return canvas_create(picture, THUMBNAIL, THUMBNAIL)
               ? picture_paint(job, &what, picture, where, &pixel_mm)
               : job_fail(job, EXIT_RESOURCE, "There is no memory for the thumbnail.");
}

static sf_status write_view(const package_body *bodies, size_t count, sf_threemf_object *objects,
                            sf_threemf_item *items, const sf_threemf_extras *extras, sf_save *save,
                            sf_fault *fault)
{
    static const sf_transform same = {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
    for (size_t i = 0; i < count; i++) {
        sf_threemf_object object = {
            bodies[i].name, SF_THREEMF_MODEL, sf_mesh_get_view(bodies[i].mesh),
            NULL,           SF_THREEMF_NONE,  0};
        objects[i] = object;
        items[i].object = (uint32_t)i;
        items[i].placed = same;
    }
    sf_threemf_view view = {NULL, 0, objects, count, items, count, 0};
    return sf_threemf_write(&view, extras, sf_save_sink(save), NULL, NULL, fault);
}

exit_status package_write(cli_job *job, const package_body *bodies, size_t count,
                          const canvas *picture, const char *path, sf_save *save)
{
    bytes png = {NULL, 0, 0};
    sf_sink sink = {put, &png};
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_threemf_extras extras = sf_threemf_extras_default();
    sf_threemf_object *objects = malloc(count * sizeof *objects);
    sf_threemf_item *items = malloc(count * sizeof *items);
    sf_status status = objects != NULL && items != NULL ? SF_OK : SF_ERR_MEMORY;
    if (status == SF_OK && picture->pixels != NULL) {
        status = sf_png_write_rgb(picture->pixels, picture->width, picture->height, sink);
        extras.thumbnail = png.data;
        extras.thumbnail_size = png.size;
    }
    if (status == SF_OK) {
        status = write_view(bodies, count, objects, items, &extras, save, &fault);
    }
    free(png.data);
    free(objects);
    free(items);
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
}
