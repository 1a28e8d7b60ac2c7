// SPDX-License-Identifier: MIT
// A twin of the editor's model in the memory of the graphics card.
//
// Each call of the model is made on the card as well; nothing is read back while strokes are drawn.
// The two are the same bit for bit, but for what they can undo: the card begins with a copy and
// does not know the steps before it, and when a history forgets its oldest steps each does so by
// its own measure. Where the card may not know a step the model is copied anew.

#include "card.h"

#include <stdio.h>
#include <stdlib.h>

#include "open.h"

struct card {
    editor *editor;
    gpu_sculpt *model;
    editor_twin twin;
    size_t steps;                  // that the model's history had, forgotten ones counted
    size_t undo_count, redo_count; // steps that both can take
};

static void copy(card *c)
{
    (void)!gpu_sculpt_replace(c->model, sf_sculpt_drawn(c->editor->model),
                              sf_sculpt_materials(c->editor->model));
    c->undo_count = c->redo_count = 0;
}

static size_t steps_of(const sf_sculpt *model)
{
    sf_sculpt_history h = sf_sculpt_history_of(model);
    return h.undo_count + h.forgotten_count;
}

// The model may have one step more than before, and so has the card.
static void count_step(card *c)
{
    size_t steps = steps_of(c->editor->model);
    if (steps > c->steps) {
        c->undo_count++;
        c->redo_count = 0;
    }
    c->steps = steps;
}

static int forgets(const card *c)
{
    gpu_report report = {0};
    return sf_sculpt_history_of(c->editor->model).forgotten_count > 0 ||
           gpu_sculpt_report(c->model, &report) != SF_OK || report.forgotten_count > 0;
}

static void begin(void *user, const sf_brush *brush)
{
    card *c = user;
    (void)!gpu_sculpt_begin(c->model, brush);
}

static void dab(void *user, const sf_dab *dabs, size_t count)
{
    card *c = user;
    (void)!gpu_sculpt_dab(c->model, dabs, count);
}

static void end(void *user)
{
    card *c = user;
    (void)!gpu_sculpt_end(c->model);
    count_step(c);
}

static void give_up(void *user)
{
    card *c = user;
    (void)!gpu_sculpt_abandon(c->model);
}

static void replace(void *user)
{
    card *c = user;
    copy(c);
    count_step(c);
    c->undo_count = 0;
}

static void undo(card *c)
{
    if (c->undo_count > 0 && !forgets(c)) {
        (void)!gpu_sculpt_undo(c->model);
        c->undo_count--;
        c->redo_count++;
    } else {
        copy(c);
    }
}

static void redo(card *c)
{
    if (c->redo_count > 0 && !forgets(c)) {
        (void)!gpu_sculpt_redo(c->model);
        c->undo_count++;
        c->redo_count--;
    } else {
        copy(c);
    }
}

static void step(void *user, sf_session_step which)
{
    card *c = user;
    switch (which) {
    case SF_SESSION_UNDO:
        undo(c);
        break;
    case SF_SESSION_REDO:
        redo(c);
        break;
    default:
        (void)!gpu_sculpt_drop_ghosts(c->model);
        count_step(c);
        return;
    }
    c->steps = steps_of(c->editor->model);
}

card *card_create(editor *e, char why[APP_WHY_SIZE])
{
    const char *reason = "There is no memory for a twin on the graphics card.";
    sf_sculpt_options options = sf_sculpt_options_of(e->model);
    card *c = calloc(1, sizeof *c);
    if (c == NULL || gpu_sculpt_create(&options, &reason, &c->model) != SF_OK) {
        snprintf(why, APP_WHY_SIZE, "%.300s", reason);
        free(c);
        return NULL;
    }
    const editor_twin twin = {c, begin, dab, end, give_up, step, replace};
    c->editor = e;
    c->twin = twin;
    copy(c);
    c->steps = steps_of(e->model);
    e->twin = &c->twin;
    return c;
}

void card_destroy(card *c)
{
    if (c != NULL) {
        if (c->editor->twin == &c->twin) {
            c->editor->twin = NULL;
        }
        gpu_sculpt_destroy(c->model);
        free(c);
    }
}

gpu_view card_view(const card *c)
{
    return gpu_sculpt_view(c->model);
}

uint64_t card_hash(const card *c)
{
    sf_lattice l = sf_sculpt_options_of(c->editor->model).lattice;
    size_t voxels = (size_t)l.nx * l.ny * l.nz;
    sf_grid *drawn = NULL, *printable = NULL;
    uint8_t *materials = malloc(voxels);
    uint64_t hash = 0;
    if (materials != NULL && sf_grid_create(&l, NULL, &drawn) == SF_OK &&
        sf_grid_create(&l, NULL, &printable) == SF_OK &&
        gpu_sculpt_fetch(c->model, drawn, printable, materials) == SF_OK) {
        hash = app_hash_of(drawn, printable, materials);
    }
    sf_grid_destroy(drawn);
    sf_grid_destroy(printable);
    free(materials);
    return hash;
}
