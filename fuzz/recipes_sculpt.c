// SPDX-License-Identifier: MIT
// How models to sculpt, sessions, solids that stand, and files are made out of bytes; and which
// recipe makes what kind.

#include "recipes.h"

#include <stdio.h>
#include <unistd.h>

// Paths lie in a folder of the process's own, which is made once and taken away at its end.
static char folder[64];

static void remove_folder(void)
{
    char command[128];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    (void)!system(command);
}

static const char *own_folder(void)
{
    if (folder[0] == '\0') {
        snprintf(folder, sizeof folder, "/tmp/libsf-fuzz-XXXXXX");
        if (mkdtemp(folder) == NULL) {
            perror(folder);
            abort();
        }
        atexit(remove_folder);
    }
    return folder;
}

const char *world_path(world *w)
{
    static const char *const names[] = {"a",  "b",         "a/c", "missing/x",
                                        "..", "a name/ b", "",    "layer_00000.png"};
    char *path = world_scratch(w, 512);
    if (draw_odd(&w->in, 16)) {
        return draw_below(&w->in, 2) ? NULL : "";
    }
    int length =
        snprintf(path, 512, "%s/%s", own_folder(),
                 names[draw_odd(&w->in, 2) ? draw_below(&w->in, 8) : draw_below(&w->in, 2)]);
    if (draw_odd(&w->in, 16)) { // longer than a name of a file may be
        memset(path + length, 'x', 300);
    }
    return path;
}

static void *make_tip(world *w)
{
    sf_tip *tip = NULL;
    const double radius[3] = {draw_below(&w->in, 12) / 4.0, draw_below(&w->in, 12) / 4.0,
                              draw_below(&w->in, 12) / 4.0};
    (void)!sf_tip_create((sf_tip_shape)draw_below(&w->in, 4), radius, &w->allocator, &tip);
    return tip;
}

static void *make_sculpt(world *w)
{
    sf_sculpt *model = NULL;
    sf_sculpt_options options = sf_sculpt_options_default();
    options.lattice = w->lattice;
    options.rule = w->rule;
    options.keep_drawn = (int)draw_below(&w->in, 2);
    options.history_size = 10000;
    if (sf_sculpt_create(&options, &w->allocator, &model) == SF_OK) {
        sf_brush brush = sf_brush_default();
        sf_dab dabs[2] = {world_sf_dab(w), world_sf_dab(w)};
        brush.tip = world_need(w, "sf_tip");
        if (brush.tip != NULL) {
            (void)!sf_sculpt_stroke(model, &brush, dabs, 2, NULL);
        }
        uint32_t then = draw_below(&w->in, 4);
        if (then == 1) {
            (void)!sf_sculpt_undo(model, NULL);
        } else if (then == 2 && brush.tip != NULL) {
            (void)!sf_sculpt_begin(model, &brush);
        }
    }
    return model;
}

static void *make_session(world *w)
{
    sf_session *session = NULL;
    sf_session_options options = sf_session_options_default();
    const double radius[3] = {1.5, 1.5, 1.5};
    uint32_t tip = 0;
    options.lattice = w->lattice;
    options.history_size = 10000;
    if (sf_session_create(&options, &w->allocator, &session) == SF_OK &&
        sf_session_add_tip(session, (sf_tip_shape)draw_below(&w->in, 4), radius, &tip) == SF_OK) {
        sf_brush brush = sf_brush_default();
        sf_dab dabs[2] = {world_sf_dab(w), world_sf_dab(w)};
        brush.kind = (sf_brush_kind)draw_below(&w->in, SF_BRUSH_KIND_COUNT);
        (void)!sf_session_add_stroke(session, &brush, tip, dabs, draw_below(&w->in, 3));
    }
    sf_sculpt *model = NULL;
    if (session != NULL && draw_below(&w->in, 2) &&
        sf_session_replay(session, &w->allocator, NULL, &model) == SF_OK) {
        (void)!sf_session_keep_state(session, model);
    }
    sf_sculpt_destroy(model);
    return session;
}

static void *make_contour_stack(world *w)
{
    sf_contour_stack *stack = NULL;
    if (sf_contour_stack_create(0, &w->allocator, &stack) == SF_OK) {
        for (uint32_t k = draw_below(&w->in, 4); k > 0; k--) {
            const sf_contours contours = world_sf_contours(w);
            (void)!sf_contour_stack_add(stack, 5 - k, &contours, NULL);
        }
    }
    return stack;
}

static void *make_void_search(world *w)
{
    sf_void_search *search = NULL;
    sf_voids_options options = sf_voids_options_default();
    (void)!sf_void_search_create(&options, w->lattice.nx, w->lattice.ny, &w->allocator, &search);
    return search;
}

static void *make_stand(world *w)
{
    sf_stand *stand = NULL;
    sf_stance_options stance = sf_stance_options_default();
    sf_stand_options options = sf_stand_options_default();
    sf_handle handle = world_sf_handle(w);
    options.pitch_mm = 1;
    options.wall_mm = 0.5;
    options.rounds_max = 1 + draw_below(&w->in, 2);
    options.deform = (int)draw_below(&w->in, 2);
    (void)!sf_stand_create(world_sf_mesh_view(w), &stance, 1, &handle, 1, &options, &w->allocator,
                           NULL, &stand, NULL);
    return stand;
}

static void *make_file(world *w, const char *kind)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", own_folder(), "a");
    sf_save *save = NULL;
    sf_file *file = NULL;
    sf_directory *directory = NULL;
    if (strcmp(kind, "sf_directory") == 0) {
        snprintf(path, sizeof path, "%s/%s", own_folder(), "folder");
        (void)!sf_directory_write(path, &w->allocator, &directory, NULL);
        return directory;
    }
    if (sf_save_begin(path, &w->allocator, &save, NULL) != SF_OK || strcmp(kind, "sf_save") == 0) {
        return save;
    }
    (void)!sf_save_commit(save, NULL);
    (void)!sf_file_open(path, &w->allocator, &file, NULL);
    return file;
}

const char *world_path_of(world *w, const char *kind)
{
    if (draw_odd(&w->in, 3)) {
        return world_path(w);
    }
    if (strcmp(kind, "sf_directory") == 0) {
        return own_folder();
    }
    sf_save *save = make_file(w, "sf_save");
    if (save != NULL && sf_save_commit(save, NULL) != SF_OK) {
        return NULL;
    }
    char *path = world_scratch(w, 128);
    snprintf(path, 128, "%s/a", own_folder());
    return path;
}

static void *make_layers(world *w)
{
    sf_layers *layers = NULL;
    sf_material materials[2] = {{"one", {255, 0, 0}, 1}, {"two", {0, 255, 0}, 2}};
    (void)!sf_layers_begin(world_sf_folder(w), &w->lattice, 1 + draw_below(&w->in, 2), materials,
                           &w->allocator, &layers, NULL);
    const uint8_t *nothing = world_scratch(w, (size_t)w->lattice.nx * w->lattice.ny);
    uint32_t whole = draw_below(&w->in, 2);
    for (uint32_t k = 0; layers != NULL && whole && k < w->lattice.nz; k++) {
        (void)!sf_layers_add(layers, nothing, w->lattice.nx, NULL);
    }
    return layers;
}

static void *make_path_finder(world *w)
{
    return world_make_path(w, 0);
}
static void *make_path_map(world *w)
{
    return world_make_path(w, 1);
}
static void *make_halftone(world *w)
{
    return world_make_tone_machine(w, 0);
}
static void *make_diffuser(world *w)
{
    return world_make_tone_machine(w, 1);
}
static void *make_voxelizer(world *w)
{
    return world_make_slicer(w, 0);
}
static void *make_shell(world *w)
{
    return world_make_slicer(w, 1);
}
static void *make_plain_file(world *w)
{
    return make_file(w, "sf_file");
}
static void *make_save(world *w)
{
    return make_file(w, "sf_save");
}
static void *make_directory(world *w)
{
    return make_file(w, "sf_directory");
}

static const struct {
    const char *kind;
    void *(*make)(world *w);
} recipes[] = {
    {"sf_cage", world_make_cage},
    {"sf_cage_history", world_make_history},
    {"sf_certificate", world_make_certificate},
    {"sf_checker", world_make_checker},
    {"sf_contour_stack", make_contour_stack},
    {"sf_curve", world_make_curve},
    {"sf_diffuser", make_diffuser},
    {"sf_directory", make_directory},
    {"sf_file", make_plain_file},
    {"sf_grid", world_make_grid},
    {"sf_halftone", make_halftone},
    {"sf_layers", make_layers},
    {"sf_limit", world_make_limit},
    {"sf_locator", world_make_locator},
    {"sf_mask", world_make_mask},
    {"sf_mesh", world_make_mesh},
    {"sf_mixture", world_make_mixture},
    {"sf_path_finder", make_path_finder},
    {"sf_path_map", make_path_map},
    {"sf_refinement", world_make_refinement},
    {"sf_sampler", world_make_sampler},
    {"sf_save", make_save},
    {"sf_sculpt", make_sculpt},
    {"sf_session", make_session},
    {"sf_shell", make_shell},
    {"sf_stance", world_make_stance},
    {"sf_stand", make_stand},
    {"sf_tets", world_make_tets},
    {"sf_tip", make_tip},
    {"sf_void_search", make_void_search},
    {"sf_voxelizer", make_voxelizer},
    {"sf_weights", world_make_weights},
};

void *world_make(world *w, const char *kind)
{
    int armed = w->armed;
    void *object = NULL;
    w->armed = 0; // what an argument needs is there
    for (size_t i = 0; i < sizeof recipes / sizeof *recipes; i++) {
        if (strcmp(recipes[i].kind, kind) == 0) {
            object = recipes[i].make(w);
        }
    }
    w->armed = armed;
    return object;
}
