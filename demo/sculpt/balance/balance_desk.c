// SPDX-License-Identifier: MIT
// The Balance workspace as a desk: its life, its settings and actions, its files.

#include "balance_desk.h"

#include <sf/io.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/event.h"
#include "balance.h"
#include "desk/hash.h"
#include "desk/mesh_file.h"

static double between(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

// ---------------------------------------------------------------------------------------------
// Settings
// ---------------------------------------------------------------------------------------------

// What is asked for has changed: all is computed anew.
static void change_plan(balance *b, int setting, double x)
{
    balance_plan *p = &b->state.plan;
    balance_remember(b, setting);
    switch (setting) {
    case BALANCE_GAMMA:
        p->gamma_deg = between(x, 0, 45);
        break;
    case BALANCE_WALL:
        p->wall_mm = between(x, 1e-3 * b->state.size_mm, b->state.size_mm);
        break;
    case BALANCE_CARVING:
        p->carving = (balance_carving)between(x, 0, BALANCE_PLANES);
        break;
    case BALANCE_BENDS:
        p->bends = x > 0;
        break;
    default:
        p->resolution = (uint32_t)between(x, 16, 160);
        break;
    }
    balance_drop(b);
    (void)balance_place(b);
}

static void set(desk *d, int setting, double x)
{
    balance *b = (balance *)d;
    balance_state *s = &b->state;
    if (b->is_dragging && setting == BALANCE_SELECTED) {
        return; // the one in hand stays in it
    }
    d->is_stale = 1;
    switch (setting) {
    case BALANCE_TOOL:
        s->tool = (balance_tool)between(x, 0, BALANCE_TOOL_COUNT - 1);
        break;
    case BALANCE_GLASS:
        s->shows_glass = x > 0;
        break;
    case BALANCE_SELECTED:
        s->selected = (int)between(x, -1, (double)s->plan.handle_count - 1);
        break;
    case BALANCE_COUNT:
        s->wanted = (uint32_t)between(x, 1, BALANCE_HANDLES_MAX);
        break;
    case BALANCE_SCALE:
        if (s->selected >= 0) {
            sf_pose pose = balance_pose_of(b, (size_t)s->selected);
            pose.scale = between(x, 0.3, 3);
            balance_remember(b, setting);
            balance_set_pose(b, (size_t)s->selected, &pose);
        }
        break;
    case BALANCE_GAMMA:
    case BALANCE_WALL:
    case BALANCE_CARVING:
    case BALANCE_BENDS:
    case BALANCE_RESOLUTION:
        change_plan(b, setting, x);
        break;
    default:
        break;
    }
}

// ---------------------------------------------------------------------------------------------
// Actions
// ---------------------------------------------------------------------------------------------

static void place_handles(balance *b)
{
    balance_plan before = b->state.plan;
    if (balance_put_handles(b)) {
        balance_plan after = b->state.plan;
        b->state.plan = before;
        balance_remember(b, -1);
        b->state.plan = after;
        b->state.selected = b->state.hovered = -1;
        balance_drop(b);
    }
}

static void remove_handle(balance *b)
{
    balance_plan *p = &b->state.plan;
    if (b->state.selected < 0) {
        return;
    }
    balance_remember(b, -1);
    size_t at = (size_t)b->state.selected;
    memmove(p->handles + at, p->handles + at + 1, (--p->handle_count - at) * sizeof *p->handles);
    b->state.selected = b->state.hovered = -1;
    balance_drop(b);
}

static void toggle_lock(balance *b)
{
    if (b->state.selected >= 0) {
        size_t at = (size_t)b->state.selected;
        balance_remember(b, -1);
        balance_lock(b, at, !b->state.plan.handles[at].locked);
    }
}

// Poses that were set by hand, all forgotten.
static void begin_anew(balance *b)
{
    balance_remember(b, -1);
    for (size_t i = 0; i < b->state.plan.handle_count; i++) {
        b->state.plan.handles[i].pose = sf_pose_identity();
        b->state.plan.handles[i].locked = 0;
    }
    b->state.is_running = b->is_pending = 0;
    balance_drop(b);
    (void)balance_place(b);
}

static void keep_one_stance(balance *b)
{
    if (b->state.plan.stance_count > 1) {
        balance_remember(b, -1);
        b->state.plan.stance_count = 1;
        balance_drop(b);
        (void)balance_place(b);
    }
}

// Stop; a handle that is being moved goes back to where it was, and is not moved again by redo.
static void give_up(balance *b)
{
    if (b->is_dragging == 2) {
        balance_undo(b);
        b->state.redo_count--;
    }
    b->state.is_running = b->is_pending = b->is_dragging = 0;
    b->state.selected = -1;
}

// On, or stop. What has ended is not gone on with: nothing would come of it.
static void run(balance *b)
{
    balance_state *s = &b->state;
    if (!s->is_running && s->has_report && s->report.ended) {
        snprintf(b->base.said, sizeof b->base.said,
                 "It has ended: change what is asked for, move a handle, or begin anew.");
        return;
    }
    s->is_running = !s->is_running;
}

static void act(desk *d, int action)
{
    balance *b = (balance *)d;
    d->is_stale = 1;
    switch (action) {
    case DO_UNDO:
        balance_undo(b);
        break;
    case DO_REDO:
        balance_redo(b);
        break;
    case DO_CLEAR:
        begin_anew(b);
        break;
    case DO_GIVE_UP:
        give_up(b);
        break;
    case DO_STEP:
        balance_step(b);
        break;
    case BALANCE_RUN:
        run(b);
        break;
    case BALANCE_ROUND:
        b->is_pending = 1;
        break;
    case BALANCE_PLACE:
        place_handles(b);
        break;
    case BALANCE_LOCK:
        toggle_lock(b);
        break;
    case BALANCE_REMOVE:
        remove_handle(b);
        break;
    case BALANCE_ONE_STANCE:
        keep_one_stance(b);
        break;
    default:
        break;
    }
}

static void key(desk *d, int code, unsigned mods)
{
    const balance_state *s = &((const balance *)d)->state;
    (void)mods;
    switch (code) {
    case ' ':
        act(d, BALANCE_RUN);
        break;
    case 'N':
        act(d, BALANCE_ROUND);
        break;
    case 'A':
        act(d, BALANCE_PLACE);
        break;
    case 'L':
        act(d, BALANCE_LOCK);
        break;
    case 'X':
        act(d, BALANCE_REMOVE);
        break;
    case 'H':
        set(d, BALANCE_GLASS, !s->shows_glass);
        break;
    case '[':
    case ']':
        if (s->selected >= 0) {
            double scale = balance_pose_of((const balance *)d, (size_t)s->selected).scale;
            set(d, BALANCE_SCALE, code == ']' ? scale * 1.05 : scale / 1.05);
        }
        break;
    default:
        if (code >= '1' && code < '1' + BALANCE_TOOL_COUNT) {
            set(d, BALANCE_TOOL, code - '1');
        }
    }
}

static int is_busy(const desk *d)
{
    const balance *b = (const balance *)d;
    return (b->state.is_running && !(b->state.has_report && b->state.report.ended)) ||
           b->is_pending;
}

// ---------------------------------------------------------------------------------------------
// Files
// ---------------------------------------------------------------------------------------------

static int open_file(desk *d, const char *path, char why[DESK_WHY_SIZE])
{
    sf_mesh *mesh = mesh_file_read(path, why);
    if (mesh == NULL) {
        return 0;
    }
    if (!balance_take_mesh((balance *)d, mesh, why)) {
        sf_mesh_destroy(mesh);
        return 0;
    }
    return 1;
}

static int adopt(desk *d, const sf_grid *shape, char why[DESK_WHY_SIZE])
{
    sf_surface_options smooth = sf_surface_options_default();
    sf_mesh *mesh = NULL;
    smooth.smooth_passes = 12;
    sf_status status = sf_grid_surface(shape, &smooth, NULL, NULL, &mesh);
    if (status != SF_OK) {
        snprintf(why, DESK_WHY_SIZE, "%s", sf_status_message(status));
        return 0;
    }
    if (!balance_take_mesh((balance *)d, mesh, why)) {
        sf_mesh_destroy(mesh);
        return 0;
    }
    return 1;
}

// "part.stl" becomes "part_inner.stl".
static int name_inner(const char *path, char name[DESK_WHY_SIZE])
{
    const char *dot = strrchr(path, '.');
    int stem = dot != NULL ? (int)(dot - path) : (int)strlen(path);
    return snprintf(name, DESK_WHY_SIZE, "%.*s_inner%s", stem, path, path + stem) < DESK_WHY_SIZE;
}

static int save_file(const desk *d, const char *path, char why[DESK_WHY_SIZE])
{
    const balance *b = (const balance *)d;
    sf_mesh_view cavity = balance_cavity(b);
    char inner[DESK_WHY_SIZE];
    if (sf_mesh_format_from_name(path) == SF_MESH_FORMAT_AUTO) {
        snprintf(why, DESK_WHY_SIZE, "%.180s: give a name that ends in .stl, .obj, .ply or .3mf.",
                 path);
        return 0;
    }
    if (!name_inner(path, inner)) {
        snprintf(why, DESK_WHY_SIZE, "That name is too long.");
        return 0;
    }
    return mesh_file_write(balance_outer(b), path, why) &&
           (cavity.triangle_count == 0 || mesh_file_write(cavity, inner, why));
}

// ---------------------------------------------------------------------------------------------
// What it is
// ---------------------------------------------------------------------------------------------

static int bounds(const desk *d, double low[3], double high[3])
{
    return sf_mesh_bounds(balance_outer((const balance *)d), low, high) == SF_OK;
}

static uint64_t hash(const desk *d)
{
    const balance *b = (const balance *)d;
    const balance_plan *p = &b->state.plan;
    uint64_t h = HASH_NONE;
    const sf_mesh_view meshes[2] = {balance_outer(b), balance_cavity(b)};
    for (int i = 0; i < 2; i++) {
        h = hash_add(h, meshes[i].vertices, 3 * meshes[i].vertex_count * sizeof(double));
        h = hash_add(h, meshes[i].triangles, 3 * meshes[i].triangle_count * sizeof(uint32_t));
    }
    for (size_t i = 0; i < p->handle_count; i++) {
        sf_pose pose = balance_pose_of(b, i);
        h = hash_add(h, p->handles[i].at_mm, sizeof p->handles[i].at_mm);
        h = hash_add(h, &pose, sizeof pose);
    }
    return hash_add(h, b->state.com_mm, sizeof b->state.com_mm);
}

static void destroy(desk *d)
{
    balance *b = (balance *)d;
    sf_stand_destroy(b->stand);
    for (int i = 0; i < BALANCE_STANCES_MAX; i++) {
        sf_stance_destroy(b->stances[i]);
    }
    sf_mesh_destroy(b->placed);
    sf_mesh_destroy(b->given);
    free(b);
}

static const desk_class balance_class = {.name = "balance",
                                         .destroy = destroy,
                                         .open = open_file,
                                         .adopt = adopt,
                                         .save = save_file,
                                         .hover = balance_hover,
                                         .press = balance_press,
                                         .drag = balance_drag,
                                         .release = balance_release,
                                         .key = key,
                                         .set = set,
                                         .act = act,
                                         .is_busy = is_busy,
                                         .show = balance_show,
                                         .bounds = bounds,
                                         .hash = hash};

desk *balance_desk_create(void)
{
    char why[DESK_WHY_SIZE];
    balance *b = calloc(1, sizeof *b);
    sf_mesh *mesh = b != NULL ? balance_first_mesh() : NULL;
    if (mesh == NULL) {
        free(b);
        return NULL;
    }
    b->base.is = &balance_class;
    b->state.wanted = 5;
    b->state.shows_glass = 1;
    b->last_setting = -1;
    if (!balance_take_mesh(b, mesh, why)) {
        sf_mesh_destroy(mesh);
        destroy(&b->base);
        return NULL;
    }
    return &b->base;
}

const balance_state *balance_desk_state(const desk *d)
{
    return &((const balance *)d)->state;
}
