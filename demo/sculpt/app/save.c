// SPDX-License-Identifier: MIT
// What a person takes away.

#include "save.h"

#include <sf/io.h>
#include <stdio.h>

#include "desk/mesh_file.h"

// Who writes to a file that is under way.
typedef struct writing {
    const sf_session *session;
    const unsigned char *pixels;
    uint32_t width, height;
} writing;

static int say(char why[APP_WHY_SIZE], const char *path, sf_status status, const sf_fault *fault)
{
    const char *reason = fault->message[0] != '\0' ? fault->message : sf_status_message(status);
    if (status != SF_OK) {
        snprintf(why, APP_WHY_SIZE, "%s: %s", path, reason);
    }
    return status == SF_OK;
}

static sf_status write_to(const writing *w, sf_sink sink)
{
    if (w->session != NULL) {
        return sf_session_write(w->session, sink);
    }
    return sf_png_write_rgb(w->pixels, w->width, w->height, sink);
}

static int save(const writing *w, const char *path, char why[APP_WHY_SIZE])
{
    sf_save *file = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_save_begin(path, NULL, &file, &fault);
    if (status == SF_OK) {
        status = write_to(w, sf_save_sink(file));
        if (status == SF_OK) {
            status = sf_save_commit(file, &fault);
        } else {
            sf_save_abort(file);
        }
    }
    return say(why, path, status, &fault);
}

int app_save_session(const sf_session *session, const char *path, char why[APP_WHY_SIZE])
{
    writing w = {.session = session};
    if (session == NULL) {
        snprintf(why, APP_WHY_SIZE, "%s: there is no memory for the session", path);
        return 0;
    }
    return save(&w, path, why);
}

int app_save_picture(const unsigned char *pixels, uint32_t width, uint32_t height, const char *path,
                     char why[APP_WHY_SIZE])
{
    writing w = {.pixels = pixels, .width = width, .height = height};
    return save(&w, path, why);
}

static int save_layers(const sf_sculpt *model, const char *path, char why[APP_WHY_SIZE])
{
    sf_directory *directory = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_directory_write(path, NULL, &directory, &fault);
    if (status == SF_OK) {
        status = sf_stack_write(sf_sculpt_printable(model), NULL, sf_directory_folder(directory),
                                NULL, &fault);
        if (status == SF_OK) {
            status = sf_directory_commit(directory, &fault);
        } else {
            sf_directory_close(directory);
        }
    }
    return say(why, path, status, &fault);
}

int app_save_shape(const sf_sculpt *model, const char *path, char why[APP_WHY_SIZE])
{
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    if (sf_mesh_format_from_name(path) == SF_MESH_FORMAT_AUTO) {
        return save_layers(model, path, why);
    }
    sf_status status = sf_grid_surface(sf_sculpt_printable(model), NULL, NULL, NULL, &mesh);
    if (status != SF_OK) {
        return say(why, path, status, &fault);
    }
    int good = mesh_file_write(sf_mesh_get_view(mesh), path, why);
    sf_mesh_destroy(mesh);
    return good;
}

int app_save_work(editor *e, const char *path, char why[APP_WHY_SIZE])
{
    const desk *d = editor_desk(e);
    return d != NULL ? d->is->save(d, path, why) : app_save_session(editor_session(e), path, why);
}
