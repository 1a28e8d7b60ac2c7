// SPDX-License-Identifier: MIT
// The Grade workspace as a desk: its life, its settings and actions, its files.

#include "grade_desk.h"

#include <sf/cage_io.h>
#include <sf/io.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/event.h"
#include "desk/hash.h"
#include "grade.h"

static double between(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

// ---------------------------------------------------------------------------------------------
// Settings
// ---------------------------------------------------------------------------------------------

// To smooth goes by a share.
static double bound_amount(const grade *g, double x)
{
    if (g->state.operation == SF_PAINT_SMOOTH) {
        return between(x, 0, 1);
    }
    return between(x, -1e12, 1e12);
}

static void choose_channel(grade *g, double x)
{
    g->state.channel = (size_t)between(x, 0, (double)g->state.cage.channel_count - 1);
    grade_follow(g, 0);
    g->state.amount = bound_amount(g, g->state.high);
}

static void set_brush(grade_state *s, int setting, double x)
{
    switch (setting) {
    case GRADE_RADIUS:
        s->brush.radius_mm = between(x, 1e-6, 1e9);
        break;
    case GRADE_FALLOFF:
        s->brush.falloff = (sf_falloff)between(x, 0, SF_FALLOFF_GAUSSIAN);
        break;
    default:
        s->brush.where = (sf_paint_where)between(x, 0, SF_PAINT_INSIDE);
        break;
    }
}

// What concerns the section makes it old.
static void set_section(grade *g, int setting, double x)
{
    grade_state *s = &g->state;
    switch (setting) {
    case GRADE_CUT:
        s->is_cut = x > 0;
        break;
    case GRADE_CUT_AXIS:
        s->cut_axis = (int)between(x, 0, 2);
        break;
    case GRADE_CUT_SHARE:
        s->cut_share = between(x, 0, 1);
        break;
    case GRADE_MATERIALS:
        s->materials = (uint32_t)between(x, 2, GRADE_MATERIALS_MAX);
        break;
    default:
        s->resolution = (uint32_t)between(x, 32, 400);
        break;
    }
    grade_section_free(&g->section);
    g->is_section_old = s->is_cut;
}

static void set(desk *d, int setting, double x)
{
    grade *g = (grade *)d;
    grade_state *s = &g->state;
    if (g->is_pressed && (setting == GRADE_TOOL || setting == GRADE_CHANNEL)) {
        return; // a stroke has one tool and one property
    }
    d->is_stale = 1;
    switch (setting) {
    case GRADE_TOOL:
        s->tool = (grade_tool)between(x, 0, GRADE_TOOL_COUNT - 1);
        s->has_place = 0;
        break;
    case GRADE_CHANNEL:
        choose_channel(g, x);
        break;
    case GRADE_OPERATION:
        s->operation = (sf_paint_operation)between(x, 0, SF_PAINT_SMOOTH);
        s->amount = bound_amount(g, s->amount);
        break;
    case GRADE_AMOUNT:
        s->amount = bound_amount(g, x);
        break;
    case GRADE_RADIUS:
    case GRADE_FALLOFF:
    case GRADE_WHERE:
        set_brush(s, setting, x);
        break;
    case GRADE_CAGE:
        s->shows_cage = x > 0;
        break;
    case GRADE_CUT_SIDE:
        s->keeps_beyond = x > 0;
        break;
    case GRADE_CUT:
    case GRADE_CUT_AXIS:
    case GRADE_CUT_SHARE:
    case GRADE_MATERIALS:
    case GRADE_RESOLUTION:
        set_section(g, setting, x);
        break;
    default:
        break;
    }
}

// ---------------------------------------------------------------------------------------------
// Actions
// ---------------------------------------------------------------------------------------------

static void select_all(grade *g, double weight)
{
    for (size_t i = 0; i < g->state.cage.point_count; i++) {
        g->selected[i] = weight;
    }
    grade_count_selected(g);
}

static void apply(grade *g, int to_places)
{
    grade_state *s = &g->state;
    size_t changed = 0;
    if (s->selected_count == 0) {
        grade_say(g, "No point is selected: click on one, or take all with A.");
        return;
    }
    sf_status status = to_places ? sf_paint_smooth(g->cage, g->selected, 0.5, NULL, &changed)
                                 : sf_paint_values(g->cage, s->channel, g->selected, s->operation,
                                                   s->amount, NULL, &changed);
    grade_say(g, status != SF_OK ? sf_status_message(status) : "");
    if (status == SF_OK && changed > 0) {
        grade_record(g);
        grade_follow(g, to_places);
    }
}

// The stroke, or the move, that is under way.
static void give_up(grade *g)
{
    if (g->is_pressed && g->has_moved) {
        grade_record(g);
        grade_undo(g, 0);
    }
    g->is_pressed = g->has_moved = 0;
    select_all(g, 0);
}

static void act(desk *d, int action)
{
    grade *g = (grade *)d;
    d->is_stale = 1;
    switch (action) {
    case DO_UNDO:
        grade_undo(g, 0);
        break;
    case DO_REDO:
        grade_undo(g, 1);
        break;
    case DO_GIVE_UP:
        give_up(g);
        break;
    case DO_STEP:
        grade_section_make(g);
        break;
    case GRADE_ALL:
        select_all(g, 1);
        break;
    case DO_CLEAR:
    case GRADE_NONE:
        select_all(g, 0);
        break;
    case GRADE_APPLY:
        apply(g, 0);
        break;
    case GRADE_SMOOTH_PLACES:
        apply(g, 1);
        break;
    default:
        break;
    }
}

static void key(desk *d, int code, unsigned mods)
{
    const grade_state *s = &((const grade *)d)->state;
    (void)mods;
    switch (code) {
    case 'A':
        act(d, s->selected_count > 0 ? GRADE_NONE : GRADE_ALL);
        break;
    case ' ':
        act(d, GRADE_APPLY);
        break;
    case 'S':
        act(d, GRADE_SMOOTH_PLACES);
        break;
    case 'H':
        set(d, GRADE_CAGE, !s->shows_cage);
        break;
    case 'C':
        set(d, GRADE_CUT, !s->is_cut);
        break;
    case 'V':
        set(d, GRADE_CUT_AXIS, (s->cut_axis + 1) % 3);
        break;
    case 'B':
        set(d, GRADE_CUT_SIDE, !s->keeps_beyond);
        break;
    case '[':
        set(d, GRADE_RADIUS, s->brush.radius_mm / 1.1);
        break;
    case ']':
        set(d, GRADE_RADIUS, s->brush.radius_mm * 1.1);
        break;
    default:
        if (code >= '1' && code < '1' + GRADE_TOOL_COUNT) {
            set(d, GRADE_TOOL, code - '1');
        }
    }
}

static int is_busy(const desk *d)
{
    const grade *g = (const grade *)d;
    return g->is_section_old && !g->is_pressed;
}

// ---------------------------------------------------------------------------------------------
// Files
// ---------------------------------------------------------------------------------------------

static int say(char why[DESK_WHY_SIZE], const char *path, sf_status status, const sf_fault *fault)
{
    if (status != SF_OK) {
        snprintf(why, DESK_WHY_SIZE, "%.160s: %s", path,
                 fault->message[0] != '\0' ? fault->message : sf_status_message(status));
    }
    return status == SF_OK;
}

static int open_file(desk *d, const char *path, char why[DESK_WHY_SIZE])
{
    sf_file *file = NULL;
    sf_cage *cage = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_file_open(path, NULL, &file, &fault);
    if (status == SF_OK) {
        status = sf_cage_read(sf_file_source(file), NULL, NULL, &cage, NULL, &fault);
    }
    sf_file_close(file);
    if (!say(why, path, status, &fault)) {
        return 0;
    }
    grade *g = (grade *)d;
    if (!grade_take(g, cage, why)) {
        sf_cage_destroy(cage);
        return 0;
    }
    g->state.amount = bound_amount(g, g->state.amount);
    return 1;
}

static int save_file(const desk *d, const char *path, char why[DESK_WHY_SIZE])
{
    const grade *g = (const grade *)d;
    sf_save *file = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    size_t length = strlen(path);
    if (length < 5 || strcmp(path + length - 4, ".vtk") != 0) {
        snprintf(why, DESK_WHY_SIZE, "%.160s: give a name that ends in .vtk.", path);
        return 0;
    }
    sf_status status = sf_save_begin(path, NULL, &file, &fault);
    if (status == SF_OK) {
        status = sf_cage_write_vtk(&g->state.cage, 0, NULL, sf_save_sink(file), &fault);
        if (status == SF_OK) {
            status = sf_save_commit(file, &fault);
        } else {
            sf_save_abort(file);
        }
    }
    return say(why, path, status, &fault);
}

// ---------------------------------------------------------------------------------------------
// What it is
// ---------------------------------------------------------------------------------------------

static int bounds(const desk *d, double low[3], double high[3])
{
    const grade_state *s = &((const grade *)d)->state;
    memcpy(low, s->low_mm, sizeof s->low_mm);
    memcpy(high, s->high_mm, sizeof s->high_mm);
    return 1;
}

static uint64_t hash(const desk *d)
{
    const grade *g = (const grade *)d;
    const sf_cage_view *v = &g->state.cage;
    const grade_section *c = &g->section;
    uint64_t h = hash_add(HASH_NONE, v->positions, 3 * v->point_count * sizeof(double));
    for (size_t i = 0; i < v->channel_count; i++) {
        h = hash_add(h, v->channels[i].values, v->channels[i].value_count * sizeof(double));
    }
    h = hash_add(h, g->selected, v->point_count * sizeof *g->selected);
    if (c->material != NULL) {
        h = hash_add(h, c->material, (size_t)c->width * c->height);
    }
    return h;
}

static void destroy(desk *d)
{
    grade *g = (grade *)d;
    sf_cage_destroy(g->cage);
    sf_cage_history_destroy(g->history);
    grade_surface_free(&g->surface);
    grade_section_free(&g->section);
    free(g->selected);
    free(g->weights);
    free(g);
}

static const desk_class grade_class = {.name = "grade",
                                       .destroy = destroy,
                                       .open = open_file,
                                       .save = save_file,
                                       .hover = grade_hover,
                                       .press = grade_press,
                                       .drag = grade_drag,
                                       .release = grade_release,
                                       .key = key,
                                       .set = set,
                                       .act = act,
                                       .is_busy = is_busy,
                                       .show = grade_show,
                                       .bounds = bounds,
                                       .hash = hash};

desk *grade_desk_create(void)
{
    char why[DESK_WHY_SIZE];
    grade *g = calloc(1, sizeof *g);
    sf_cage *cage = g != NULL ? grade_first_cage() : NULL;
    if (cage == NULL) {
        free(g);
        return NULL;
    }
    g->base.is = &grade_class;
    g->state.shows_cage = 1;
    g->state.is_cut = 1;
    g->state.cut_axis = 1;
    g->state.keeps_beyond = 1;
    g->state.cut_share = 0.5;
    g->state.materials = 2;
    g->state.resolution = 160;
    g->state.brush = sf_paint_brush_default();
    if (!grade_take(g, cage, why)) {
        sf_cage_destroy(cage);
        destroy(&g->base);
        return NULL;
    }
    return &g->base;
}

const grade_state *grade_desk_state(const desk *d)
{
    return &((const grade *)d)->state;
}
