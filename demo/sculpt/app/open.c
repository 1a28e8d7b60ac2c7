// SPDX-License-Identifier: MIT
// What a person begins with: an empty bed, a mesh, a scene.

#include "open.h"

#include <sf/io.h>
#include <sf/session.h>
#include <stdio.h>
#include <string.h>

#include "desk/hash.h"
#include "desk/mesh_file.h"
#include "scene.h"
#include "sculpted.h"

// How much of the space's width a mesh may take.
#define SHARE 0.75

static void *fail(char why[APP_WHY_SIZE], const char *what, const char *reason)
{
    snprintf(why, APP_WHY_SIZE, "%s%s%s", what, *what != '\0' ? ": " : "", reason);
    return NULL;
}

static sf_sculpt *create(const app_options *o, double pitch_mm, char why[APP_WHY_SIZE])
{
    uint32_t resolution = o->resolution;
    sf_sculpt *model = NULL;
    sf_sculpt_options options = sf_sculpt_options_default();
    sf_lattice lattice = {
        resolution, resolution,
        resolution, pitch_mm,
        pitch_mm,   pitch_mm,
        NULL,       {-0.5 * resolution * pitch_mm, -0.5 * resolution * pitch_mm, 0}};
    options.lattice = lattice;
    options.keep_drawn = o->keep_drawn;
    sf_status status = sf_sculpt_create(&options, NULL, &model);
    return status == SF_OK ? model : fail(why, "", sf_status_message(status));
}

// A cube of voxels of 0.25 mm.
static sf_sculpt *open_empty(const app_options *o, char why[APP_WHY_SIZE])
{
    return create(o, 0.25, why);
}

// A model of a shape that `draw` makes; the model goes where it fails.
static sf_sculpt *fill(sf_sculpt *model, const char *name,
                       sf_status (*draw)(void *user, sf_grid *grid), void *user,
                       char why[APP_WHY_SIZE])
{
    sf_grid *grid = NULL;
    if (model == NULL) {
        return NULL;
    }
    sf_lattice lattice = sf_sculpt_options_of(model).lattice;
    sf_status status = sf_grid_create(&lattice, NULL, &grid);
    if (status == SF_OK) {
        status = draw(user, grid);
    }
    if (status == SF_OK) {
        status = sf_sculpt_replace(model, grid, NULL, NULL);
    }
    sf_grid_destroy(grid);
    if (status != SF_OK) {
        sf_sculpt_destroy(model);
        return fail(why, name, sf_status_message(status));
    }
    return model;
}

// ---------------------------------------------------------------------------------------------
// Scenes
// ---------------------------------------------------------------------------------------------

static sf_status draw_scene(void *user, sf_grid *grid)
{
    const char *name = user;
    double size[3];
    sf_lattice l = sf_grid_lattice(grid), moved = l;
    sf_grid *there = NULL;
    if (!scene_size(name, size)) {
        return SF_ERR_ARGUMENT;
    }
    moved.origin_mm[0] += 0.5 * size[0]; // scenes begin at 0
    moved.origin_mm[1] += 0.5 * size[1];
    sf_status status = sf_grid_create(&moved, NULL, &there);
    if (status == SF_OK) {
        status = scene_draw(name, there, NULL);
    }
    for (uint32_t z = 0; status == SF_OK && z < l.nz; z++) {
        status = sf_slice_copy(sf_grid_slice(grid, z), sf_grid_slice(there, z));
    }
    sf_grid_destroy(there);
    return status;
}

// The model that a session makes. The session goes on with it: what the model can undo, a session
// that began with its shape alone could not. A state that it kept would not be that at its end.
static sf_status replay(sf_session *made, sf_sculpt **model, sf_session **session)
{
    sf_status status = sf_session_replay(made, NULL, NULL, model);
    if (status != SF_OK) {
        sf_session_destroy(made);
        return status;
    }
    (void)!sf_session_keep_state(made, NULL);
    *session = made;
    return SF_OK;
}

// A scene that brushes made. Its sessions keep no ghosts; a model that shall is another, with the
// same shape, and no session.
static sf_sculpt *play(const app_options *o, sf_session **session, char why[APP_WHY_SIZE])
{
    sf_session *made = NULL;
    sf_sculpt *model = NULL, *kept;
    sf_status status = sculpted_session(o->scene, o->resolution, NULL, &made);
    if (status == SF_OK) {
        status = replay(made, &model, session);
    }
    if (status != SF_OK || !o->keep_drawn) {
        return status == SF_OK ? model : fail(why, o->scene, sf_status_message(status));
    }
    sf_session_destroy(*session);
    *session = NULL;
    kept = create(o, sf_sculpt_options_of(model).lattice.pitch_x_mm, why);
    if (kept != NULL) {
        status = sf_sculpt_replace(kept, sf_sculpt_drawn(model), sf_sculpt_materials(model), NULL);
    }
    sf_sculpt_destroy(model);
    if (kept != NULL && status != SF_OK) {
        sf_sculpt_destroy(kept);
        return fail(why, o->scene, sf_status_message(status));
    }
    return kept;
}

static sf_sculpt *open_scene(const app_options *o, sf_session **session, char why[APP_WHY_SIZE])
{
    const char *name = o->scene;
    double size[3], longest;
    char copy[64];
    for (size_t i = 0; sculpted_names[i] != NULL; i++) {
        if (strcmp(sculpted_names[i], name) == 0) {
            return play(o, session, why);
        }
    }
    if (!scene_size(name, size)) {
        return fail(why, name,
                    "there is no such scene; there are garden, shaun, pumpkin and intertwined");
    }
    longest = size[0] > size[1] ? size[0] : size[1];
    longest = size[2] > longest ? size[2] : longest;
    snprintf(copy, sizeof copy, "%s", name);
    return fill(create(o, longest / (SHARE * o->resolution), why), name, draw_scene, copy, why);
}

// ---------------------------------------------------------------------------------------------
// Meshes
// ---------------------------------------------------------------------------------------------

static sf_status draw_mesh(void *user, sf_grid *grid)
{
    sf_mesh *mesh = user;
    return sf_grid_voxelize(grid, sf_mesh_get_view(mesh), NULL, NULL, NULL, NULL);
}

sf_sculpt *app_open_mesh(const char *path, const app_options *o, char why[APP_WHY_SIZE])
{
    double low[3], high[3], longest = 0;
    sf_mesh *mesh = mesh_file_read(path, why);
    sf_sculpt *model = NULL;
    if (mesh == NULL) {
        return NULL;
    }
    sf_transform move = {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
    sf_status status = sf_mesh_bounds(sf_mesh_get_view(mesh), low, high);
    for (int i = 0; status == SF_OK && i < 3; i++) {
        longest = high[i] - low[i] > longest ? high[i] - low[i] : longest;
        move.shift_mm[i] = i < 2 ? -0.5 * (low[i] + high[i]) : -low[i];
    }
    if (status == SF_OK) {
        status = sf_mesh_transform(mesh, &move);
    }
    if (status != SF_OK || !(longest > 0)) {
        fail(why, path, "the mesh has no size");
    } else {
        model = fill(create(o, longest / (SHARE * o->resolution), why), path, draw_mesh, mesh, why);
    }
    sf_mesh_destroy(mesh);
    return model;
}

// ---------------------------------------------------------------------------------------------
// Sessions
// ---------------------------------------------------------------------------------------------

sf_sculpt *app_open_session(const char *path, sf_session **session, char why[APP_WHY_SIZE])
{
    sf_file *file = NULL;
    sf_session *made = NULL;
    sf_sculpt *model = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_file_open(path, NULL, &file, &fault);
    if (status == SF_OK) {
        status = sf_session_read(sf_file_source(file), 0, NULL, &made, &fault);
    }
    sf_file_close(file);
    if (status == SF_OK) {
        status = replay(made, &model, session);
    }
    if (status != SF_OK && fault.line > 0) {
        snprintf(why, APP_WHY_SIZE, "%s, line %u: %s", path, fault.line, fault.message);
        return NULL;
    }
    return status == SF_OK
               ? model
               : fail(why, path,
                      fault.message[0] != '\0' ? fault.message : sf_status_message(status));
}

sf_sculpt *app_open(const app_options *options, sf_session **session, char why[APP_WHY_SIZE])
{
    *session = NULL;
    if (options->session != NULL) {
        return app_open_session(options->session, session, why);
    }
    if (options->scene != NULL) {
        return open_scene(options, session, why);
    }
    return options->file != NULL ? app_open_mesh(options->file, options, why)
                                 : open_empty(options, why);
}

// ---------------------------------------------------------------------------------------------
// Hash
// ---------------------------------------------------------------------------------------------

static uint64_t add_grid(uint64_t hash, const sf_grid *grid)
{
    sf_lattice l = sf_grid_lattice(grid);
    for (uint32_t z = 0; z < l.nz; z++) {
        sf_slice s = sf_grid_slice(grid, z);
        for (uint32_t y = 0; y < l.ny; y++) {
            for (uint32_t i = 0; i < (l.nx + 63) / 64; i++) {
                hash = hash_number(hash, s.words[(size_t)y * s.stride + i], 8);
            }
        }
    }
    return hash;
}

uint64_t app_hash_of(const sf_grid *drawn, const sf_grid *printable, const uint8_t *materials)
{
    sf_lattice l = sf_grid_lattice(drawn);
    uint64_t hash = HASH_NONE;
    hash = add_grid(hash, drawn);
    hash = add_grid(hash, printable);
    for (size_t i = 0; i < (size_t)l.nx * l.ny * l.nz; i++) {
        hash = hash_number(hash, materials[i], 1);
    }
    return hash;
}

uint64_t app_hash(const sf_sculpt *model)
{
    return app_hash_of(sf_sculpt_drawn(model), sf_sculpt_printable(model),
                       sf_sculpt_materials(model));
}
