// SPDX-License-Identifier: MIT
// The cage: what is taken, what an edit leads to, what is undone.

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sf/cage_build.h>

#include "grade.h"

enum { HISTORY_BYTES = 64 << 20 };

// ---------------------------------------------------------------------------------------------
// What follows from the cage
// ---------------------------------------------------------------------------------------------

// The range of the property, which the colours span: that of its values, or its bounds where all
// values are one.
static void find_range(grade *g)
{
    grade_state *s = &g->state;
    const sf_channel *c = &s->cage.channels[s->channel];
    s->low = s->high = c->value_count > 0 ? c->values[0] : 0;
    for (size_t i = 1; i < c->value_count; i++) {
        s->low = fmin(s->low, c->values[i]);
        s->high = fmax(s->high, c->values[i]);
    }
    if (!(s->high > s->low)) {
        s->low = isfinite(c->property.low) ? c->property.low : s->low - 0.5;
        s->high =
            isfinite(c->property.high) && c->property.high > s->low ? c->property.high : s->low + 1;
    }
}

static void find_bounds(grade *g)
{
    grade_state *s = &g->state;
    const grade_surface *f = &g->surface;
    for (int i = 0; i < 3; i++) {
        s->low_mm[i] = INFINITY;
        s->high_mm[i] = -INFINITY;
    }
    for (size_t k = 0; k < 4 * f->face_count; k++) {
        const double *p = f->points + 3 * (size_t)f->corners[k];
        for (int i = 0; i < 3; i++) {
            s->low_mm[i] = fmin(s->low_mm[i], p[i]);
            s->high_mm[i] = fmax(s->high_mm[i], p[i]);
        }
    }
}

void grade_say(grade *g, const char *text)
{
    const grade_state *s = &g->state;
    if (text[0] == '\0' && s->inverted_cells > 0) {
        snprintf(g->base.said, sizeof g->base.said,
                 "%zu cell%s inside out, the first is number %zu: move its points back.",
                 s->inverted_cells, s->inverted_cells == 1 ? " is" : "s are", s->first_inverted);
    } else {
        snprintf(g->base.said, sizeof g->base.said, "%s", text);
    }
}

// Cells that lie inside out are said, and not refused: the next edit may mend them.
static void check(grade *g)
{
    sf_cage_report r;
    sf_fault fault = {SF_OK, 0, 0, ""};
    g->state.inverted_cells = 0;
    if (g->state.cage.dimension == 3 && sf_cage_check(g->cage, NULL, &r, &fault) == SF_OK) {
        g->state.inverted_cells = r.inverted_cells;
        g->state.first_inverted = r.first_inverted;
    }
    grade_say(g, "");
}

void grade_follow(grade *g, int places_too)
{
    grade_state *s = &g->state;
    s->cage = sf_cage_get_view(g->cage);
    find_range(g);
    sf_status status = places_too ? grade_surface_move(&g->surface, s->cage.positions) : SF_OK;
    if (status == SF_OK) {
        status = grade_surface_paint(&g->surface, s->channel, s->cage.channels[s->channel].values);
    }
    if (places_too) {
        find_bounds(g);
        check(g);
    }
    if (status != SF_OK) {
        snprintf(g->base.said, sizeof g->base.said, "%s", sf_status_message(status));
    }
    g->is_section_old = s->is_cut;
    g->base.is_stale = 1;
}

// ---------------------------------------------------------------------------------------------
// Steps
// ---------------------------------------------------------------------------------------------

void grade_record(grade *g)
{
    if (sf_cage_history_record(g->history, g->cage, NULL) != SF_OK) {
        snprintf(g->base.said, sizeof g->base.said, "There is no memory to undo that.");
    }
    g->state.history = sf_cage_history_get_state(g->history);
}

void grade_undo(grade *g, int is_redo)
{
    size_t changed = 0;
    sf_status status = is_redo ? sf_cage_history_redo(g->history, g->cage, &changed)
                               : sf_cage_history_undo(g->history, g->cage, &changed);
    g->state.history = sf_cage_history_get_state(g->history);
    if (status == SF_OK && changed > 0) {
        grade_follow(g, 1);
    }
}

// ---------------------------------------------------------------------------------------------
// Taking
// ---------------------------------------------------------------------------------------------

// A cage without a property gets one: a tone from 0 to 1.
static sf_status have_property(sf_cage *cage)
{
    sf_cage_view v = sf_cage_get_view(cage);
    sf_channel c = {.value_count = v.point_count};
    if (v.channel_count > 0) {
        return SF_OK;
    }
    double *values = calloc(v.point_count + 1, sizeof *values);
    sf_status status = values != NULL ? sf_property_named("tone", &c.property) : SF_ERR_MEMORY;
    if (status == SF_OK) {
        c.property.low = 0;
        c.property.high = 1;
        c.values = values;
        status = sf_cage_add_property(cage, &c, NULL);
    }
    free(values);
    return status;
}

static sf_status make_all(sf_cage *cage, grade *made)
{
    sf_status status = have_property(cage);
    if (status != SF_OK) {
        return status;
    }
    size_t points = sf_cage_get_view(cage).point_count;
    made->selected = calloc(points + 1, sizeof *made->selected);
    made->weights = calloc(points + 1, sizeof *made->weights);
    if (made->selected == NULL || made->weights == NULL) {
        return SF_ERR_MEMORY;
    }
    status = sf_cage_history_create(cage, HISTORY_BYTES, NULL, &made->history);
    return status == SF_OK ? grade_surface_make(cage, &made->surface) : status;
}

static void free_all(grade *g)
{
    sf_cage_history_destroy(g->history);
    grade_surface_free(&g->surface);
    free(g->selected);
    free(g->weights);
}

int grade_take(grade *g, sf_cage *cage, char why[DESK_WHY_SIZE])
{
    grade made;
    memset(&made, 0, sizeof made);
    sf_status status = make_all(cage, &made);
    if (status != SF_OK) {
        free_all(&made);
        snprintf(why, DESK_WHY_SIZE, "%s", sf_status_message(status));
        return 0;
    }
    if (made.surface.face_count == 0) { // each face has a cell on both sides
        free_all(&made);
        snprintf(why, DESK_WHY_SIZE, "That cage closes upon itself: it has no outside to show.");
        return 0;
    }
    free_all(g);
    sf_cage_destroy(g->cage);
    grade_section_free(&g->section);
    g->cage = cage;
    g->history = made.history;
    g->surface = made.surface;
    g->selected = made.selected;
    g->weights = made.weights;
    grade_state *s = &g->state;
    s->selected = g->selected;
    s->selected_count = 0;
    s->hovered = -1;
    s->has_place = g->is_pressed = 0;
    s->channel = 0;
    s->triangles = 2 * g->surface.face_count;
    s->history = sf_cage_history_get_state(g->history);
    grade_follow(g, 1);
    double size = 0;
    for (int i = 0; i < 3; i++) {
        size = fmax(size, s->high_mm[i] - s->low_mm[i]);
    }
    s->brush.radius_mm = 0.2 * size;
    s->amount = s->high;
    return 1;
}

// ---------------------------------------------------------------------------------------------
// The first cage
// ---------------------------------------------------------------------------------------------

// A beam that is bent, thicker at its ends, stiff below.
static void shape(double *p)
{
    double t = p[0] / 40, thick = 0.75 + 0.45 * t * t;
    p[1] *= thick;
    p[2] = 12 + (p[2] - 12) * thick + 9 * t * t;
}

sf_cage *grade_first_cage(void)
{
    static const uint32_t counts[3] = {6, 2, 2};
    static const double low[3] = {-40, -12, 0}, high[3] = {40, 12, 24};
    sf_cage *cage = NULL;
    sf_channel c = {.value_count = 0};
    if (sf_cage_block(counts, low, high, NULL, &cage) != SF_OK) {
        return NULL;
    }
    sf_cage_view v = sf_cage_get_view(cage);
    double *values = malloc(v.point_count * sizeof *values);
    double *positions = malloc(3 * v.point_count * sizeof *positions);
    sf_status status = values != NULL && positions != NULL ? sf_property_named("tone", &c.property)
                                                           : SF_ERR_MEMORY;
    if (status == SF_OK) {
        memcpy(positions, v.positions, 3 * v.point_count * sizeof *positions);
        for (size_t i = 0; i < v.point_count; i++) {
            double *p = positions + 3 * i;
            double x = p[0] / 40, z = p[2] / 24;
            values[i] = fmin(1, fmax(0, 1.1 - z - 0.35 * x * x));
            shape(p);
        }
        c.property.low = 0;
        c.property.high = 1;
        c.value_count = v.point_count;
        c.values = values;
        status = sf_cage_set_positions(cage, 0, v.point_count, positions);
    }
    if (status == SF_OK) {
        status = sf_cage_add_property(cage, &c, NULL);
    }
    free(values);
    free(positions);
    if (status != SF_OK) {
        sf_cage_destroy(cage);
        return NULL;
    }
    return cage;
}
