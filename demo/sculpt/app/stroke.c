// SPDX-License-Identifier: MIT
// What an editor does with the brush in hand.
//
// The dabs of a stroke are kept until it ends, and then written into the session; where there is no
// memory for that the model goes on and the session is said to be incomplete.

#include "stroke.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "tip.h"

#define RADIUS_MOST_VX 96.0

static sf_box join(sf_box a, sf_box b)
{
    if (a.x0 >= a.x1 || b.x0 >= b.x1) {
        return a.x0 >= a.x1 ? b : a;
    }
    sf_box both = {a.x0 < b.x0 ? a.x0 : b.x0, a.y0 < b.y0 ? a.y0 : b.y0, a.z0 < b.z0 ? a.z0 : b.z0,
                   a.x1 > b.x1 ? a.x1 : b.x1, a.y1 > b.y1 ? a.y1 : b.y1, a.z1 > b.z1 ? a.z1 : b.z1};
    return both;
}

// What was printable when the next stroke begins.
static void follow(editor *e, sf_box box)
{
    for (uint32_t z = box.z0; z < box.z1; z++) {
        (void)!sf_slice_copy(sf_grid_slice(e->base, z),
                             sf_grid_slice(sf_sculpt_printable(e->model), z));
    }
}

void editor_note(editor *e, const sf_sculpt_change *change)
{
    sf_box all = join(join(change->drawn, change->printable), change->material);
    e->changed = join(e->changed, all);
    e->change = *change;
    e->touched = join(e->touched, all);
    if (e->drag != DRAG_STROKE) {
        follow(e, all);
    }
}

void editor_record_step(editor *e, sf_session_step step)
{
    if (e->twin != NULL) {
        e->twin->step(e->twin->user, step);
    }
    e->is_recorded = e->is_recorded && sf_session_add_step(e->session, step) == SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The brush
// ---------------------------------------------------------------------------------------------

void editor_bound_brush(editor *e)
{
    sf_lattice l = sf_sculpt_options_of(e->model).lattice;
    double least = 0.6 * l.pitch_x_mm, most = RADIUS_MOST_VX * l.pitch_x_mm;
    double r = e->brush.radius_mm;
    e->brush.radius_mm = r > least ? (r < most ? r : most) : least;
    if (e->drag != DRAG_STROKE) {
        tip_forget(e);
    }
}

// Control takes away where the brush adds, and adds where it takes away; shift smooths.
static sf_brush_kind kind_of(const editor *e, unsigned mods)
{
    static const sf_brush_kind others[SF_BRUSH_KIND_COUNT] = {
        [SF_BRUSH_ADD_TRIM] = SF_BRUSH_REMOVE_PRESERVE,
        [SF_BRUSH_REMOVE_PRESERVE] = SF_BRUSH_ADD_TRIM,
        [SF_BRUSH_ADD_GROW] = SF_BRUSH_REMOVE_TRIM,
        [SF_BRUSH_REMOVE_TRIM] = SF_BRUSH_ADD_GROW,
        [SF_BRUSH_SMOOTH_TRIM] = SF_BRUSH_SMOOTH_TRIM,
        [SF_BRUSH_PAINT] = SF_BRUSH_PAINT};
    if ((mods & MOD_SHIFT) != 0) {
        return SF_BRUSH_SMOOTH_TRIM;
    }
    return (mods & MOD_CONTROL) != 0 ? others[e->brush.kind] : e->brush.kind;
}

static sf_brush brush_of(const editor *e)
{
    sf_brush brush = sf_brush_default();
    brush.kind = e->kind_under_way;
    brush.tip = e->tip;
    brush.material = e->brush.material;
    brush.passes = e->brush.passes;
    brush.mirror_x = e->brush.mirror_x;
    brush.mirror_y = e->brush.mirror_y;
    return brush;
}

// ---------------------------------------------------------------------------------------------
// Strokes
// ---------------------------------------------------------------------------------------------

static int keep(editor *e, const sf_dab *dabs, size_t count)
{
    if (e->dab_count + count > e->dab_capacity) {
        size_t capacity = 2 * (e->dab_count + count);
        sf_dab *more = realloc(e->dabs, capacity * sizeof *more);
        if (more == NULL) {
            return 0;
        }
        e->dabs = more;
        e->dab_capacity = capacity;
    }
    for (size_t i = 0; i < count; i++) {
        e->dabs[e->dab_count++] = dabs[i];
    }
    return 1;
}

static void put(editor *e, const sf_dab *dabs, size_t count)
{
    sf_sculpt_change change;
    sf_status status = sf_sculpt_dab(e->model, dabs, count, &change);
    if (status != SF_OK) {
        snprintf(e->said, sizeof e->said, "The stroke was given up: %s", sf_status_message(status));
        e->drag = DRAG_NONE;
        if (e->twin != NULL) {
            e->twin->give_up(e->twin->user);
        }
        return;
    }
    if (e->twin != NULL) {
        e->twin->dab(e->twin->user, dabs, count);
    }
    e->is_recorded = keep(e, dabs, count) && e->is_recorded;
    editor_note(e, &change);
}

void editor_stroke_begin(editor *e, unsigned mods)
{
    e->kind_under_way = kind_of(e, mods);
    e->dab_count = 0;
    if (!tip_make(e)) {
        snprintf(e->said, sizeof e->said,
                 "A brush of that size cannot be made: there is no memory, "
                 "or the mesh has no voxel then.");
        return;
    }
    sf_brush brush = brush_of(e);
    if (sf_sculpt_begin(e->model, &brush) == SF_OK) {
        e->said[0] = '\0';
        const sf_box none = {0, 0, 0, 0, 0, 0};
        e->drag = DRAG_STROKE;
        if (e->twin != NULL) {
            e->twin->begin(e->twin->user, &brush);
        }
        e->touched = none;
        e->last = e->place;
        put(e, &e->place, 1);
    }
}

static int32_t part_of(int32_t from, int32_t to, int32_t i, int32_t count)
{
    return from + (int32_t)((int64_t)(to - from) * i / count);
}

static int32_t longest(sf_dab a, sf_dab b)
{
    int32_t x = abs(b.x - a.x), y = abs(b.y - a.y), z = abs(b.z - a.z);
    return x > y ? (x > z ? x : z) : (y > z ? y : z);
}

// Along a line, in pieces that are no longer than there is room for.
void editor_stroke_on(editor *e)
{
    enum { MOST = 512 };
    const sf_dab from = e->last, to = e->place;
    int32_t pieces = 1 + longest(from, to) / (MOST - 1);
    if (!e->has_place) {
        return;
    }
    for (int32_t i = 1; i <= pieces && e->drag == DRAG_STROKE; i++) {
        sf_dab line[MOST],
            next = {part_of(from.x, to.x, i, pieces), part_of(from.y, to.y, i, pieces),
                    part_of(from.z, to.z, i, pieces)};
        size_t count;
        if (sf_dab_line(e->last, next, line, MOST, &count) == SF_OK && count > 1) {
            e->last = next;
            put(e, line + 1, count - 1);
        }
    }
}

static void record(editor *e)
{
    sf_brush brush = brush_of(e);
    uint32_t tip = 0;
    e->is_recorded = e->is_recorded && tip_record(e, &tip) &&
                     sf_session_add_stroke(e->session, &brush, tip, e->dabs, e->dab_count) == SF_OK;
}

void editor_stroke_end(editor *e)
{
    sf_sculpt_change change;
    if (e->drag != DRAG_STROKE || sf_sculpt_end(e->model, &change) != SF_OK) {
        return;
    }
    e->drag = DRAG_NONE;
    if (e->twin != NULL) {
        e->twin->end(e->twin->user);
    }
    record(e);
    editor_note(e, &change);
    follow(e, e->touched);
}

void editor_stroke_give_up(editor *e)
{
    sf_sculpt_change change;
    if (e->drag == DRAG_STROKE && sf_sculpt_abandon(e->model, &change) == SF_OK) {
        e->drag = DRAG_NONE;
        if (e->twin != NULL) {
            e->twin->give_up(e->twin->user);
        }
        editor_note(e, &change);
    }
}
