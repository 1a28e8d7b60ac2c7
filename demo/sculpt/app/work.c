// SPDX-License-Identifier: MIT
// Workspaces: which one is worked in, and the events that go to its desk.

#include "work.h"

#include <stdio.h>

#include "balance/balance_desk.h"
#include "grade/grade_desk.h"

typedef struct maker {
    const char *name;
    desk *(*make)(void);
} maker;

static const maker makers[WORK_COUNT] = {
    [WORK_SCULPT] = {"sculpt", NULL},
    [WORK_BALANCE] = {"balance", balance_desk_create},
    [WORK_GRADE] = {"grade", grade_desk_create},
};

const char *work_name(workspace work)
{
    return makers[work].name;
}

desk *editor_desk(const editor *e)
{
    return e->desks[e->work];
}

// The desk of a workspace, made where it was not; NULL where there is no memory.
static desk *find_desk(editor *e, workspace work)
{
    if (e->desks[work] != NULL) {
        return e->desks[work];
    }
    desk *d = makers[work].make();
    if (d == NULL) {
        snprintf(e->said, sizeof e->said, "There is no memory for that workspace.");
        return NULL;
    }
    e->desks[work] = d;
    const sf_grid *shape = sf_sculpt_printable(e->model);
    if (d->is->adopt != NULL && sf_grid_popcount(shape) > 0 && !d->is->adopt(d, shape, d->said)) {
        snprintf(e->said, sizeof e->said, "%s", d->said);
    }
    return d;
}

void work_go_to(editor *e, workspace work)
{
    int has_desk = makers[work].make != NULL;
    if (e->drag != DRAG_NONE || work == e->work || (!has_desk && work != WORK_SCULPT)) {
        return;
    }
    if (has_desk && find_desk(e, work) == NULL) {
        return;
    }
    e->work = work;
    e->has_place = 0;
    if (has_desk) {
        e->desks[work]->is_stale = 1;
    }
    editor_frame_all(e);
}

void work_set(editor *e, int setting, double x)
{
    desk *d = editor_desk(e);
    if (d != NULL) {
        d->is->set(d, setting, x);
    }
}

int work_act(editor *e, int action)
{
    desk *d = editor_desk(e);
    if (d == NULL || action == DO_FRAME || action == DO_CLOSE) {
        return 0;
    }
    if (e->drag == DRAG_STROKE && action != DO_GIVE_UP && action != DO_STEP) {
        return 1; // one thing at a time
    }
    d->is->act(d, action);
    if (action == DO_GIVE_UP && e->drag == DRAG_STROKE) {
        e->drag = DRAG_NONE;
    }
    return 1;
}

int work_key(editor *e, int code, unsigned mods)
{
    desk *d = editor_desk(e);
    if (d != NULL) {
        d->is->key(d, code, mods);
    }
    return d != NULL;
}

int work_is_busy(const editor *e)
{
    const desk *d = editor_desk(e);
    return d != NULL && d->is->is_busy(d);
}

void work_destroy(editor *e)
{
    for (int i = 0; i < WORK_COUNT; i++) {
        if (e->desks[i] != NULL) {
            e->desks[i]->is->destroy(e->desks[i]);
        }
    }
}
