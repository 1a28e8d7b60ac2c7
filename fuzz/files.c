// SPDX-License-Identifier: MIT
// The world's files and folders, which are memory, and its sources and sinks, which may break.
//
// What a writer wrote last is what a reader is given, so that readers see good files as well as bad
// ones; now and then some of its bytes are others. Reads are short on purpose: of 1 to 97 bytes.

#include "world.h"

#include <sf/contour_io.h>
#include <sf/gltf.h>

static int is_broken(world *w)
{
    if (!w->armed) {
        return 0;
    }
    long index = w->transfers++;
    int broken = w->break_at >= 0 && index >= w->break_at;
    w->breaks += broken;
    return broken;
}

static void append(world_file *f, const void *data, size_t size)
{
    if (f->size + size > f->capacity) {
        f->capacity = 2 * (f->size + size) + 64;
        f->bytes = realloc(f->bytes, f->capacity);
    }
    if (size > 0) {
        memcpy(f->bytes + f->size, data, size);
    }
    f->size += size;
}

static sf_status write_file(void *user, const void *data, size_t size)
{
    world *w = user;
    if (is_broken(w) || w->writing == NULL || w->writing->size + size > (1u << 26)) {
        w->missing++;
        return SF_ERR_IO;
    }
    append(w->writing, data, size);
    return SF_OK;
}

static sf_status read_file(void *user, void *data, size_t capacity, size_t *size)
{
    world *w = user;
    if (is_broken(w)) {
        return SF_ERR_IO;
    }
    size_t left = w->cursor.size - w->cursor.position;
    size_t most = 1 + (w->cursor.position * 31 + capacity) % 97;
    size_t count = capacity < left ? capacity : left;
    count = count < most ? count : most;
    if (count > 0) {
        memcpy(data, (const unsigned char *)w->cursor.data + w->cursor.position, count);
    }
    w->cursor.position += count;
    *size = count;
    return SF_OK;
}

static world_file *find_file(world *w, const char *name)
{
    for (size_t i = 0; i < w->file_count; i++) {
        if (strcmp(w->files[i].name, name) == 0) {
            return &w->files[i];
        }
    }
    return NULL;
}

static world_file *new_file(world *w, const char *name)
{
    world_file *f = find_file(w, name);
    if (f == NULL && w->file_count < WORLD_FILES && strlen(name) < sizeof w->files[0].name) {
        f = &w->files[w->file_count++];
        memset(f, 0, sizeof *f);
        memcpy(f->name, name, strlen(name));
    }
    if (f != NULL) {
        f->size = 0;
    }
    return f;
}

static sf_source open_bytes(world *w, const void *bytes, size_t size)
{
    sf_memory_cursor cursor = {bytes, size, 0};
    sf_source source = {read_file, w};
    w->cursor = cursor;
    return source;
}

// Some bytes of a copy are others, or its end is missing.
static sf_source open_spoilt(world *w, const void *bytes, size_t size)
{
    unsigned char *copy = world_scratch(w, size);
    memcpy(copy, bytes, size);
    for (uint32_t i = draw_below(&w->in, 4); i > 0 && size > 0; i--) {
        copy[draw_word(&w->in) % size] = draw_byte(&w->in);
    }
    if (draw_below(&w->in, 4) == 0 && size > 0) {
        size = draw_word(&w->in) % size;
    }
    return open_bytes(w, copy, size);
}

static sf_source open_file_of(world *w, const world_file *f)
{
    return draw_odd(&w->in, 2) ? open_spoilt(w, f->bytes, f->size)
                               : open_bytes(w, f->bytes, f->size);
}

sf_sink world_sf_sink(world *w)
{
    sf_sink sink = {write_file, w};
    w->writing = new_file(w, "written");
    if (draw_odd(&w->in, 32)) {
        sink.write = NULL;
    }
    if (draw_odd(&w->in, 8)) {
        w->break_at = draw_below(&w->in, 16);
    }
    return sink;
}

sf_source world_sf_source(world *w)
{
    size_t left = w->in.size - w->in.at, count = draw_below(&w->in, 64);
    count = count < left ? count : left;
    const void *bytes = w->in.size > 0 ? w->in.bytes + w->in.at : NULL;
    w->in.at += w->in.at + count <= w->in.size ? count : 0;
    return open_bytes(w, bytes, w->in.size > 0 ? count : 0);
}

static sf_status write_object(world *w, const char *kind, const void *object, sf_sink sink)
{
    if (strcmp(kind, "sf_mesh") == 0) {
        sf_mesh_format format = (sf_mesh_format)(1 + draw_below(&w->in, 3)); // OFF is only read
        return sf_mesh_write(sf_mesh_get_view(object), format, sink);
    }
    if (strcmp(kind, "sf_cage") == 0) {
        sf_cage_view view = sf_cage_get_view(object);
        return sf_cage_write_vtk(&view, (int)draw_below(&w->in, 2), NULL, sink, NULL);
    }
    if (strcmp(kind, "sf_session") == 0) {
        return sf_session_write(object, sink);
    }
    if (strcmp(kind, "sf_contour_stack") == 0) {
        sf_contour_format format = (sf_contour_format)draw_below(&w->in, 2);
        return sf_contour_stack_write(object, format, sink);
    }
    return sf_exchange_write(object, sink, NULL);
}

sf_source world_source_of_scene(world *w)
{
    const sf_mesh *mesh = world_need(w, "sf_mesh");
    sf_sink sink = {write_file, w};
    w->writing = new_file(w, "scene");
    if (mesh == NULL || w->writing == NULL ||
        sf_gltf_write(sf_mesh_get_view(mesh), NULL, sink) != SF_OK) {
        return world_sf_source(w);
    }
    return open_file_of(w, w->writing);
}

sf_source world_source_of(world *w, const char *kind)
{
    sf_source nothing = {NULL, NULL};
    if (draw_odd(&w->in, 32)) {
        return nothing;
    }
    if (draw_odd(&w->in, 4)) {
        return world_sf_source(w);
    }
    const void *object = world_need(w, kind);
    sf_sink sink = {write_file, w};
    w->writing = new_file(w, "object");
    if (object == NULL || w->writing == NULL || write_object(w, kind, object, sink) != SF_OK) {
        return open_bytes(w, NULL, 0);
    }
    return open_file_of(w, w->writing);
}

// --- folders -------------------------------------------------------------------------------------

static sf_status open_name(void *user, const char *name, sf_source *source)
{
    world *w = user;
    const world_file *f = find_file(w, name);
    w->missing += f == NULL;
    if (f == NULL || is_broken(w)) {
        return SF_ERR_IO;
    }
    *source = open_file_of(w, f);
    return SF_OK;
}

static void close_name(void *user, sf_source source)
{
    (void)user;
    (void)source;
}

static sf_status begin_name(void *user, const char *name, sf_sink *sink)
{
    world *w = user;
    if (is_broken(w)) {
        return SF_ERR_IO;
    }
    if (strchr(name, '/') != NULL || name[0] == '\0' || strcmp(name, "..") == 0) {
        world_fail(w, "writes a file whose name is not plain");
    }
    w->writing = new_file(w, name);
    sf_sink made = {write_file, w};
    *sink = made;
    return SF_OK;
}

static sf_status commit_name(void *user, int keep)
{
    world *w = user;
    if (!keep) {
        w->writing = NULL;
        return SF_OK;
    }
    return is_broken(w) ? SF_ERR_IO : SF_OK;
}

sf_folder world_sf_folder(world *w)
{
    sf_folder folder = {open_name, close_name, begin_name, commit_name, w};
    if (draw_odd(&w->in, 32)) {
        folder.open = NULL;
        folder.begin = NULL;
    }
    if (draw_odd(&w->in, 8)) {
        w->break_at = draw_below(&w->in, 16);
    }
    return folder;
}

sf_folder world_folder_of_stack(world *w)
{
    sf_folder folder = {open_name, close_name, begin_name, commit_name, w};
    const sf_grid *grid = world_need(w, "sf_grid");
    if (grid != NULL && find_file(w, "stack.json") == NULL) {
        (void)!sf_stack_write(grid, NULL, folder, NULL, NULL);
    }
    return world_sf_folder(w);
}
