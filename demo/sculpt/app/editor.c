// SPDX-License-Identifier: MIT
// An editor: events in, strokes, steps and views out.
//
// At a desk most of them are the desk's; the camera is the editor's everywhere. Steps are recorded
// as they end.

#include "editor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "pointer.h"
#include "stroke.h"
#include "tip.h"
#include "work.h"

// ---------------------------------------------------------------------------------------------
// Life
// ---------------------------------------------------------------------------------------------

double editor_aspect(const editor *e)
{
    return e->height > 0 ? (double)e->width / e->height : 1;
}

// Where the shape lies, or the desk's things do; 0 where a desk is empty.
static int find_bounds(const editor *e, double low[3], double high[3])
{
    const desk *d = editor_desk(e);
    if (d != NULL) {
        return d->is->bounds(d, low, high);
    }
    sf_lattice l = sf_sculpt_options_of(e->model).lattice;
    sf_box b = sf_grid_bounds(sf_sculpt_drawn(e->model)), all = {0, 0, 0, l.nx, l.ny, l.nz / 2};
    b = b.x1 > 0 ? b : all;
    const double pitch[3] = {l.pitch_x_mm, l.pitch_y_mm, l.layer_mm};
    const uint32_t from[3] = {b.x0, b.y0, b.z0}, to[3] = {b.x1, b.y1, b.z1};
    for (int i = 0; i < 3; i++) {
        low[i] = l.origin_mm[i] + from[i] * pitch[i];
        high[i] = l.origin_mm[i] + to[i] * pitch[i];
    }
    return 1;
}

void editor_frame_all(editor *e)
{
    double low[3], high[3];
    if (find_bounds(e, low, high)) {
        e->camera =
            view_camera_fit(low, high, e->camera.azimuth, e->camera.elevation, editor_aspect(e));
    }
}

// A session that begins with what the model is now. Steps that the model could undo before are no
// part of it, so it is for models that a single step made, or none. The rule is that of another
// session, box3 where there is none.
static sf_session *begin_session(const sf_sculpt *model, const sf_session *like)
{
    sf_sculpt_options o = sf_sculpt_options_of(model);
    sf_session_options s =
        like != NULL ? sf_session_options_of(like) : sf_session_options_default();
    sf_session *session = NULL;
    s.lattice = o.lattice;
    s.bed_layer = o.bed_layer;
    s.keep_drawn = o.keep_drawn;
    s.history_size = o.history_size;
    sf_status status = sf_session_create(&s, NULL, &session);
    if (status == SF_OK && sf_grid_bounds(sf_sculpt_drawn(model)).x1 > 0) {
        status = sf_session_add_shape(session, sf_sculpt_drawn(model), sf_sculpt_materials(model));
    }
    if (status != SF_OK) {
        sf_session_destroy(session);
        return NULL;
    }
    return session;
}

int editor_replace(editor *e, sf_sculpt *model, sf_session *session)
{
    sf_grid *base = NULL;
    sf_session *begun = session == NULL ? begin_session(model, NULL) : NULL;
    if ((session == NULL && begun == NULL) ||
        sf_grid_clone(sf_sculpt_printable(model), NULL, &base) != SF_OK) {
        sf_session_destroy(begun);
        return 0;
    }
    sf_sculpt_destroy(e->model);
    sf_session_destroy(e->session);
    sf_grid_destroy(e->base);
    tip_forget(e);
    e->model = model;
    e->session = session != NULL ? session : begun;
    e->base = base;
    e->drag = DRAG_NONE;
    e->has_place = 0;
    e->is_recorded = 1;
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    sf_box all = {0, 0, 0, l.nx, l.ny, l.nz};
    e->changed = all;
    editor_frame_all(e);
    return 1;
}

const sf_session *editor_session(editor *e)
{
    sf_session *anew = e->is_recorded ? NULL : begin_session(e->model, e->session);
    if (e->is_recorded || anew == NULL) {
        return e->is_recorded ? e->session : NULL;
    }
    sf_session_destroy(e->session);
    e->session = anew;
    return anew;
}

editor *editor_create(sf_sculpt *model, sf_session *session, uint32_t width, uint32_t height)
{
    editor *e = calloc(1, sizeof *e);
    if (e == NULL) {
        sf_sculpt_destroy(model);
        sf_session_destroy(session);
        return NULL;
    }
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    editor_brush brush = {SF_BRUSH_ADD_TRIM, SF_TIP_SPHERE, 0, 1, 1, 0, 0, -1};
    e->brush = brush;
    e->brush.radius_mm = 0.06 * l.nx * l.pitch_x_mm;
    e->width = width;
    e->height = height;
    e->camera.azimuth = -1.05;
    e->camera.elevation = 0.42;
    e->overlays = view_overlays_default();
    e->overlays.cut_axis = 2;
    e->overlays.cut_mm = 0.25 * l.nz * l.layer_mm;
    if (!editor_replace(e, model, session)) {
        sf_sculpt_destroy(model);
        sf_session_destroy(session);
        free(e);
        return NULL;
    }
    return e;
}

void editor_destroy(editor *e)
{
    if (e != NULL) {
        sf_sculpt_destroy(e->model);
        sf_session_destroy(e->session);
        sf_grid_destroy(e->base);
        tip_destroy(e);
        work_destroy(e);
        free(e->dabs);
        free(e);
    }
}

// ---------------------------------------------------------------------------------------------
// Settings and actions
// ---------------------------------------------------------------------------------------------

static int to_int(double x, int low, int high)
{
    return x < low ? low : x > high ? high : (int)x;
}

static void set(editor *e, int setting, double x)
{
    editor_brush *b = &e->brush;
    view_overlays *o = &e->overlays;
    int *const flags[] = {
        [SET_MIRROR_X] = &b->mirror_x,   [SET_MIRROR_Y] = &b->mirror_y, [SET_GHOSTS] = &o->ghosts,
        [SET_OVERHANGS] = &o->overhangs, [SET_GROUND] = &o->ground,     [SET_SHADOWS] = &o->shadows,
        [SET_CUT] = &o->is_cut};
    if (e->drag == DRAG_STROKE && setting <= SET_PLANE) {
        return; // a stroke has one brush
    }
    if (setting >= DESK_BALANCE_FIRST) {
        work_set(e, setting, x);
        return;
    }
    switch (setting) {
    case SET_KIND:
        b->kind = (sf_brush_kind)to_int(x, 0, SF_BRUSH_KIND_COUNT - 1);
        break;
    case SET_SHAPE:
        b->shape = to_int(x, 0, e->tip_mesh != NULL ? TIP_MESH : SF_TIP_CONE);
        break;
    case SET_RADIUS:
        b->radius_mm = x;
        break;
    case SET_MATERIAL:
        b->material = (uint8_t)to_int(x, 1, VIEW_PALETTE_COUNT);
        break;
    case SET_PASSES:
        b->passes = (uint32_t)to_int(x, 1, (int)SF_BRUSH_PASSES_MAX);
        break;
    case SET_PLANE:
        b->plane = to_int(x, -1, 2);
        break;
    case SET_CUT_AXIS:
        o->cut_axis = to_int(x, 0, 2);
        break;
    case SET_CUT_MM:
        o->cut_mm = x;
        break;
    case SET_WORK:
        work_go_to(e, (workspace)to_int(x, 0, WORK_COUNT - 1));
        break;
    default:
        if (setting >= 0 && setting < SETTING_COUNT && flags[setting] != NULL) {
            *flags[setting] = x > 0;
        }
    }
    editor_bound_brush(e);
}

static void step(editor *e, int is_undo)
{
    sf_sculpt_change c;
    if (e->drag == DRAG_STROKE) {
        return;
    }
    sf_status status = is_undo ? sf_sculpt_undo(e->model, &c) : sf_sculpt_redo(e->model, &c);
    if (status == SF_OK) {
        editor_note(e, &c);
        editor_record_step(e, is_undo ? SF_SESSION_UNDO : SF_SESSION_REDO);
    }
}

static void clear(editor *e)
{
    sf_sculpt_change c;
    sf_lattice l = sf_sculpt_options_of(e->model).lattice;
    sf_grid *nothing = NULL;
    if (e->drag == DRAG_STROKE || sf_grid_create(&l, NULL, &nothing) != SF_OK) {
        return;
    }
    if (sf_sculpt_replace(e->model, NULL, NULL, &c) == SF_OK) {
        editor_note(e, &c);
        if (e->twin != NULL) {
            e->twin->replace(e->twin->user);
        }
        e->is_recorded = e->is_recorded && sf_session_add_shape(e->session, nothing, NULL) == SF_OK;
    }
    sf_grid_destroy(nothing);
}

static void drop_ghosts(editor *e)
{
    sf_sculpt_change c;
    if (e->drag != DRAG_STROKE && sf_sculpt_drop_ghosts(e->model, &c) == SF_OK) {
        editor_note(e, &c);
        editor_record_step(e, SF_SESSION_DROP_GHOSTS);
    }
}

static void act(editor *e, int action)
{
    if (work_act(e, action)) {
        return;
    }
    switch (action) {
    case DO_UNDO:
        step(e, 1);
        break;
    case DO_REDO:
        step(e, 0);
        break;
    case DO_FRAME:
        editor_frame_all(e);
        break;
    case DO_CLEAR:
        clear(e);
        break;
    case DO_DROP_GHOSTS:
        drop_ghosts(e);
        break;
    case DO_GIVE_UP:
        editor_stroke_give_up(e);
        break;
    case DO_CLOSE:
        act(e, DO_GIVE_UP);
        e->wants_close = 1;
        break;
    default:
        break;
    }
}

// A key does what a setting or an action does.
static void key(editor *e, int code, unsigned mods)
{
    editor_brush *b = &e->brush;
    if ((mods & MOD_CONTROL) != 0) {
        if (code == 'Z') {
            act(e, (mods & MOD_SHIFT) != 0 ? DO_REDO : DO_UNDO);
        } else if (code == 'Y') {
            act(e, DO_REDO);
        }
        return;
    }
    if (code != 'F' && code != 27 && work_key(e, code, mods)) {
        return;
    }
    switch (code) {
    case '[':
        set(e, SET_RADIUS, b->radius_mm / 1.1);
        break;
    case ']':
        set(e, SET_RADIUS, b->radius_mm * 1.1);
        break;
    case 'X':
        set(e, SET_MIRROR_X, !b->mirror_x);
        break;
    case 'Y':
        set(e, SET_MIRROR_Y, !b->mirror_y);
        break;
    case 'P':
        set(e, SET_PLANE, b->plane < 2 ? b->plane + 1 : -1);
        break;
    case 'O':
        set(e, SET_OVERHANGS, !e->overlays.overhangs);
        break;
    case 'G':
        set(e, SET_GROUND, !e->overlays.ground);
        break;
    case 'C':
        set(e, SET_CUT, !e->overlays.is_cut);
        break;
    case 'F':
        act(e, DO_FRAME);
        break;
    case 27:
        act(e, DO_GIVE_UP);
        break; // escape
    default:
        if (code >= '1' && code < '1' + SF_BRUSH_KIND_COUNT) {
            set(e, SET_KIND, code - '1');
        }
    }
}

static void fly(editor *e, const app_event *event)
{
    view_camera_pan(&e->camera, -event->x, -event->y, editor_aspect(e));
    view_camera_zoom(&e->camera, exp(-event->z));
    view_camera_orbit(&e->camera, event->a, event->b);
    pointer_find(e);
}

void editor_take(editor *e, const app_event *event)
{
    switch (event->kind) {
    case EVENT_SIZE:
        e->width = (uint32_t)to_int(event->x, 0, 16384);
        e->height = (uint32_t)to_int(event->y, 0, 16384);
        break;
    case EVENT_MOVE:
        pointer_move(e, event);
        break;
    case EVENT_PRESS:
        pointer_press(e, event);
        break;
    case EVENT_RELEASE:
        pointer_release(e, event);
        break;
    case EVENT_SCROLL:
        view_camera_zoom(&e->camera, exp(-0.12 * event->y));
        pointer_find(e);
        break;
    case EVENT_KEY:
        key(e, event->code, event->mods);
        break;
    case EVENT_SET:
        set(e, event->code, event->x);
        break;
    case EVENT_DO:
        act(e, event->code);
        break;
    case EVENT_FLY:
        fly(e, event);
        break;
    default:
        break;
    }
}

view_overlays editor_overlays(const editor *e)
{
    view_overlays o = e->overlays;
    o.has_cursor = e->has_place && (e->drag == DRAG_NONE || e->drag == DRAG_STROKE);
    o.has_plane = o.has_cursor && e->brush.plane >= 0;
    o.plane_axis = e->brush.plane >= 0 ? e->brush.plane : 0;
    o.is_box = e->brush.shape == SF_TIP_BOX;
    for (int i = 0; i < 3; i++) {
        o.cursor[i] = e->at_mm[i];
        o.reach[i] = e->brush.radius_mm;
    }
    return o;
}
