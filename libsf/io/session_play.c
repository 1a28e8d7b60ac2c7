// SPDX-License-Identifier: MIT
// Sessions: doing again what was recorded.

#include "base/status.h"
#include "io/session.h"

sf_status sf_session_begin(const sf_session *session, const sf_allocator *allocator,
                           sf_sculpt **model)
{
    if (session == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_sculpt_options options = sf_sculpt_options_default();
    options.lattice = session->options.lattice;
    options.rule = session->rule;
    options.bed_layer = session->options.bed_layer;
    options.keep_drawn = session->options.keep_drawn;
    options.history_size = session->options.history_size;
    return sf_sculpt_create(&options, allocator, model);
}

// ---------------------------------------------------------------------------------------------
// Shapes
// ---------------------------------------------------------------------------------------------

// Runs as a grid and materials, to be freed by the caller whatever is returned.
static sf_status unpack(const sf_session *session, const sfi_session_run *runs, size_t count,
                        const sf_allocator *allocator, sf_grid **grid, uint8_t **materials)
{
    const sf_lattice *l = &session->options.lattice;
    SF_TRY(sf_grid_create(l, allocator, grid));
    *materials = sfi_alloc_array(allocator, (size_t)l->nx * l->ny * l->nz, 1);
    if (*materials == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(*materials, 0, (size_t)l->nx * l->ny * l->nz);
    for (size_t i = 0; i < count; i++) {
        const sfi_session_run *r = &runs[i];
        sf_rect rect = {r->x, r->y, r->x + r->length, r->y + 1};
        SF_TRY(sf_slice_fill(sf_grid_slice(*grid, r->z), rect, 1));
        memset(*materials + ((size_t)r->z * l->ny + r->y) * l->nx + r->x, r->material, r->length);
    }
    return SF_OK;
}

// Free what unpack() made.
static void drop(const sf_session *session, const sf_allocator *allocator, sf_grid *grid,
                 uint8_t *materials)
{
    const sf_lattice *l = &session->options.lattice;
    sf_grid_destroy(grid);
    sfi_free_array(allocator, materials, (size_t)l->nx * l->ny * l->nz, 1);
}

static sf_status replace(const sf_session *session, const sfi_session_run *runs, size_t count,
                         const sf_allocator *allocator, sf_sculpt *model, sf_sculpt_change *change)
{
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_grid *grid = NULL;
    uint8_t *materials = NULL;
    sf_status status = unpack(session, runs, count, &from, &grid, &materials);
    if (status == SF_OK) {
        status = sf_sculpt_replace(model, grid, materials, change);
    }
    drop(session, &from, grid, materials);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Steps
// ---------------------------------------------------------------------------------------------

static sf_status play_other(sf_session_step step, sf_sculpt *model, sf_sculpt_change *change)
{
    if (step == SF_SESSION_DROP_GHOSTS) {
        return sf_sculpt_drop_ghosts(model, change);
    }
    sf_status status =
        step == SF_SESSION_UNDO ? sf_sculpt_undo(model, change) : sf_sculpt_redo(model, change);
    return status == SF_ERR_INFEASIBLE ? SF_OK : status;
}

int sf_session_stroke(const sf_session *session, size_t step, sf_brush *brush, const sf_dab **dabs,
                      size_t *count)
{
    if (session == NULL || brush == NULL || dabs == NULL || count == NULL ||
        step >= session->items.count) {
        return 0;
    }
    const sfi_session_item *item = (const sfi_session_item *)session->items.items + step;
    if (item->kind != SFI_STEP_STROKE) {
        return 0;
    }
    *brush = item->brush;
    brush->tip = sf_session_tip(session, item->tip);
    *dabs = item->count > 0 ? (const sf_dab *)session->dabs.items + item->first : NULL;
    *count = item->count;
    return 1;
}

static sf_status play(const sf_session *session, size_t step, const sf_allocator *allocator,
                      sf_sculpt *model, sf_sculpt_change *change)
{
    const sfi_session_item *item = (const sfi_session_item *)session->items.items + step;
    if (item->kind == SFI_STEP_OTHER) {
        return play_other(item->other, model, change);
    }
    if (item->kind == SFI_STEP_SHAPE) {
        return replace(session, (const sfi_session_run *)session->runs.items + item->first,
                       item->count, allocator, model, change);
    }
    sf_brush brush;
    const sf_dab *dabs;
    size_t count;
    (void)sf_session_stroke(session, step, &brush, &dabs, &count);
    return sf_sculpt_stroke(model, &brush, dabs, count, change);
}

sf_status sf_session_play(const sf_session *session, size_t step, const sf_allocator *allocator,
                          sf_sculpt *model, sf_sculpt_change *change)
{
    sf_sculpt_change found = {.added_voxels = 0}; // also where there is nothing to undo or redo
    if (session == NULL || model == NULL || step >= session->items.count) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(play(session, step, allocator, model, change != NULL ? &found : NULL));
    if (change != NULL) {
        *change = found;
    }
    return SF_OK;
}

// SF_OK where the model is what the state says.
static sf_status compare(const sf_session *session, const sf_sculpt *model)
{
    sfi_list runs = sfi_list_of(sizeof(sfi_session_run));
    sf_status status =
        sfi_session_runs_of(session, sf_sculpt_drawn(model), sf_sculpt_materials(model), &runs);
    int is_same = runs.count == session->state.count;
    for (size_t i = 0; status == SF_OK && is_same && i < runs.count; i++) {
        const sfi_session_run *a = (const sfi_session_run *)runs.items + i;
        const sfi_session_run *b = (const sfi_session_run *)session->state.items + i;
        is_same = a->z == b->z && a->y == b->y && a->x == b->x && a->length == b->length &&
                  a->material == b->material;
    }
    sfi_list_free(&session->allocator, &runs);
    return status != SF_OK ? status : is_same ? SF_OK : SF_ERR_FORMAT;
}

static sf_status play_all(const sf_session *session, const sf_allocator *allocator, sf_task *task,
                          sf_sculpt *model)
{
    for (size_t i = 0; i < session->items.count; i++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(sf_session_play(session, i, allocator, model, NULL));
        if (task != NULL && task->progress != NULL) {
            task->progress(task->user, (double)(i + 1) / (double)session->items.count);
        }
    }
    return session->has_state ? compare(session, model) : SF_OK;
}

sf_status sf_session_replay(const sf_session *session, const sf_allocator *allocator, sf_task *task,
                            sf_sculpt **model)
{
    sf_sculpt *made = NULL;
    if (model == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_session_begin(session, allocator, &made));
    sf_status status = play_all(session, allocator, task, made);
    if (status != SF_OK) {
        sf_sculpt_destroy(made);
        return status;
    }
    *model = made;
    return SF_OK;
}

sf_status sf_session_open(const sf_session *session, const sf_allocator *allocator,
                          sf_sculpt **model)
{
    sf_sculpt *made = NULL;
    if (session == NULL || model == NULL) {
        return SF_ERR_ARGUMENT;
    }
    if (!session->has_state) {
        return SF_ERR_INFEASIBLE;
    }
    SF_TRY(sf_session_begin(session, allocator, &made));
    sf_status status =
        replace(session, session->state.items, session->state.count, allocator, made, NULL);
    if (status != SF_OK) {
        sf_sculpt_destroy(made);
        return status;
    }
    *model = made;
    return SF_OK;
}
