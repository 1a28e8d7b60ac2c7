// SPDX-License-Identifier: MIT
// A bent shape and what is asked of it: where its weight may lie, what must not touch the ground.
//
// The centre of mass c must lie in half-spaces n . c >= o, one for each edge that the shape could
// fall over; their change with the coefficients follows from that of mass and moments,
//
//     d (n . c) = (n . d M - (n . c) d m) / m.
//
// Every vertex but those that stand on a ground must stay a clearance above it, which is linear in
// the coefficients as it is. There are as many such rows as vertices, and all but a few say the
// same as their neighbours: the plane is cut into cells, and of each the lowest vertex speaks,
// where it is low enough to matter. How far the lowest of all vertices lies too low is always
// found.
//
// Where bending shrinks volume too far a row each asks for more, at the worst places: a solid that
// is turned inside out has a balance, but no shape.
//
// What is carried along, a mass m in the point p, moves as the solid there does; its moment is
// m sum phi_b(p) y_b, so that any number of such masses is one sum for each function.
//
// Source: R. Prevost and others, "Make It Stand", SIGGRAPH 2013, sections 3 and 5; that the safe
// region is a half-space for each edge, heights included, is the library's own.

#include "balance/bend/posture.h"

#include "balance/bend/bent_body.h"
#include "balance/stance/stance.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "mesh/vector.h"

#include <math.h>
#include <string.h>

// Cells of the ground along each side of a square of twice the shape's size, and the share of the
// size below which a vertex is low enough to get a row.
enum { CELLS = 32 };
#define LOW 0.1
// Places of least growth that get a row, and the growth below which they may.
enum { CRUSHED_ROWS = 48 };
#define NARROW 0.6
#define NO_VERTEX UINT32_MAX

// --- Memory --------------------------------------------------------------------------------------

static size_t places_of(const sfi_posture *posture, int which)
{
    return posture->stretches[which] != NULL ? posture->stretches[which]->place_count : 0;
}

static sf_status take_numbers(const sfi_posture *posture, sfi_posture_scratch *made)
{
    size_t handles = posture->energy->handle_count, rows, all;
    made->place_count = places_of(posture, 0) + places_of(posture, 1);
    made->row_capacity =
        posture->safe_count + CELLS * CELLS * posture->standing_count + CRUSHED_ROWS;
    if (!sfi_size_mul(handles, 12, &rows) || !sfi_size_add(rows, 1, &rows) ||
        !sfi_size_mul(rows, made->row_capacity, &rows) ||
        !sfi_size_mul(handles, 48 + 48 + 12 + 36 + 4, &all) || !sfi_size_add(all, rows, &all) ||
        !sfi_size_add(all, made->place_count, &all)) {
        return SF_ERR_MEMORY;
    }
    made->memory_count = all;
    made->memory = sfi_alloc_array(&made->allocator, all, sizeof *made->memory);
    made->lowest = sfi_alloc_array(&made->allocator, CELLS * CELLS, sizeof *made->lowest);
    if (made->memory == NULL || made->lowest == NULL) {
        return SF_ERR_MEMORY;
    }
    double *at = made->memory;
    made->by_body = sfi_cut(&at, 48 * handles);
    made->by_skin = sfi_cut(&at, 48 * handles);
    made->coefficients = sfi_cut(&at, 12 * handles);
    made->energy = sfi_cut(&at, sfi_energy_scratch(handles));
    made->functions = sfi_cut(&at, 4 * handles);
    made->rows.values = sfi_cut(&at, made->row_capacity);
    made->growth = sfi_cut(&at, made->place_count);
    made->rows.gradients = at;
    return SF_OK;
}

sf_status sfi_posture_scratch_make(const sfi_posture *posture, const sf_allocator *allocator,
                                   sfi_posture_scratch *scratch)
{
    sfi_posture_scratch made;
    memset(&made, 0, sizeof made);
    made.allocator = *allocator;
    sf_status status = take_numbers(posture, &made);
    for (size_t s = 0; s < posture->skin_count && status == SF_OK; s++) {
        made.vertex_counts[s] = posture->skins[s].basis.point_count;
        made.bent[s] = sfi_alloc_array(allocator, made.vertex_counts[s], 3 * sizeof(double));
        status = made.bent[s] == NULL ? SF_ERR_MEMORY : SF_OK;
    }
    if (status != SF_OK) {
        sfi_posture_scratch_free(&made);
        return status;
    }
    *scratch = made;
    return SF_OK;
}

void sfi_posture_scratch_free(sfi_posture_scratch *scratch)
{
    sf_allocator *a = &scratch->allocator;
    for (size_t s = 0; s < SFI_SKINS_MAX; s++) {
        sfi_free_array(a, scratch->bent[s], scratch->vertex_counts[s], 3 * sizeof(double));
    }
    sfi_free_array(a, scratch->memory, scratch->memory_count, sizeof *scratch->memory);
    sfi_free_array(a, scratch->lowest, CELLS * CELLS, sizeof *scratch->lowest);
    memset(scratch, 0, sizeof *scratch);
}

// --- Bending and weighing ------------------------------------------------------------------------

static void add_loose(const sfi_posture *posture, sfi_posture_scratch *scratch, sf_body *body)
{
    size_t functions = 4 * posture->energy->handle_count;
    body->mass += posture->loose_mass;
    for (size_t b = 0; b < functions && posture->loose_sums != NULL; b++) {
        for (size_t d = 0; d < 3; d++) {
            body->moment[d] += posture->loose_sums[b] * scratch->coefficients[3 * b + d];
            scratch->by_body[12 * b + 3 + 3 * d + d] += posture->loose_sums[b];
        }
    }
}

static sf_status weigh(const sfi_posture *posture, const sf_pose *poses, sf_task *task,
                       sfi_posture_scratch *scratch, sf_body *body)
{
    size_t numbers = 48 * posture->energy->handle_count;
    sf_body sum = {0, {0, 0, 0}};
    memset(scratch->by_body, 0, numbers * sizeof *scratch->by_body);
    for (size_t s = 0; s < posture->skin_count; s++) {
        const sfi_skin *skin = &posture->skins[s];
        sf_body one;
        SF_TRY(sf_blend_apply(skin->basis, poses, task, scratch->bent[s]));
        SF_TRY(sfi_bent_body(scratch->bent[s], skin->triangles, skin->incidence, &skin->basis,
                             scratch->bent[s], &scratch->allocator, task, &one, scratch->by_skin));
        sum = sf_body_add(sum, 1, one);
        for (size_t i = 0; i < numbers; i++) {
            scratch->by_body[i] += scratch->by_skin[i];
        }
    }
    add_loose(posture, scratch, &sum);
    *body = sum;
    return sum.mass > 0 ? SF_OK : SF_ERR_ARGUMENT;
}

// --- Rows ----------------------------------------------------------------------------------------

static double *new_row(const sfi_posture *posture, sfi_posture_rows *rows, double value)
{
    rows->values[rows->count] = value;
    return rows->gradients + 12 * posture->energy->handle_count * rows->count++;
}

static void add_safe(const sfi_posture *posture, const sf_halfspace *h, const sf_body *body,
                     sfi_posture_scratch *scratch, double *unsafe)
{
    double at = sfi_dot(h->normal, body->moment) / body->mass, factor = 1 / posture->size_mm;
    double value = (at - h->offset_mm) * factor;
    double *row = new_row(posture, &scratch->rows, value);
    *unsafe = -value > *unsafe ? -value : *unsafe;
    for (size_t b = 0; b < 4 * posture->energy->handle_count; b++) {
        const double *by = scratch->by_body + 12 * b;
        for (int d = 0; d < 3; d++) {
            double moved = h->normal[0] * by[3 + d] + h->normal[1] * by[6 + d] +
                           h->normal[2] * by[9 + d] - at * by[d];
            row[3 * b + (size_t)d] = factor * moved / body->mass;
        }
    }
}

static void add_low(const sfi_posture *posture, const sfi_standing *ground, uint32_t vertex,
                    double value, sfi_posture_scratch *scratch)
{
    double *row = new_row(posture, &scratch->rows, value), factor = 1 / posture->size_mm;
    sfi_basis_at(&posture->skins[0].basis, vertex, scratch->functions);
    for (size_t b = 0; b < 4 * posture->energy->handle_count; b++) {
        for (size_t d = 0; d < 3; d++) {
            row[3 * b + d] = factor * scratch->functions[b] * ground->up[d];
        }
    }
}

static size_t cell_along(double at)
{
    double cell = floor((at + 1) * (CELLS / 2));
    return cell < 0 ? 0 : cell > CELLS - 1 ? CELLS - 1 : (size_t)cell;
}

// How far a vertex lies above what ground g allows, over the size.
static double rise(const sfi_posture *posture, size_t g, size_t vertex, const double *bent)
{
    const sfi_standing *ground = &posture->standings[g];
    int may_be_close = posture->foot != NULL && (posture->foot[vertex] >> g & 1) != 0;
    double height = sfi_dot(ground->up, bent + 3 * vertex) - ground->height_mm;
    return (height - (may_be_close ? 0 : posture->clearance_mm)) / posture->size_mm;
}

static void add_ground(const sfi_posture *posture, size_t g, sfi_posture_scratch *scratch,
                       double *sunk)
{
    const sfi_standing *ground = &posture->standings[g];
    const double *bent = scratch->bent[0];
    double first[3], second[3], from[3];
    sfi_frame_around(ground->up, first, second);
    for (size_t i = 0; i < CELLS * CELLS; i++) {
        scratch->lowest[i] = NO_VERTEX;
    }
    for (size_t v = 0; v < posture->skins[0].basis.point_count; v++) {
        double above = rise(posture, g, v, bent);
        if (above >= LOW || (posture->held[v] >> g & 1) != 0) {
            continue;
        }
        *sunk = -above > *sunk ? -above : *sunk;
        sfi_subtract(bent + 3 * v, bent, from);
        size_t cell = cell_along(sfi_dot(first, from) / posture->size_mm) * CELLS +
                      cell_along(sfi_dot(second, from) / posture->size_mm);
        uint32_t was = scratch->lowest[cell];
        if (was == NO_VERTEX || above < rise(posture, g, was, bent)) {
            scratch->lowest[cell] = (uint32_t)v;
        }
    }
    for (size_t i = 0; i < CELLS * CELLS; i++) {
        uint32_t v = scratch->lowest[i];
        if (v != NO_VERTEX) {
            add_low(posture, ground, v, rise(posture, g, v, bent), scratch);
        }
    }
}

// Rows for the places where volume grows least, the worst first.
static void add_crushed(const sfi_posture *posture, sfi_posture_scratch *scratch, double *crushed)
{
    size_t first = places_of(posture, 0);
    for (size_t i = 0; i < scratch->place_count; i++) {
        int which = i >= first;
        scratch->growth[i] =
            sfi_stretch_at(posture->stretches[which], which ? i - first : i, scratch->coefficients);
    }
    for (int row = 0; row < CRUSHED_ROWS && scratch->place_count > 0; row++) {
        size_t worst = 0;
        for (size_t i = 1; i < scratch->place_count; i++) {
            worst = scratch->growth[i] < scratch->growth[worst] ? i : worst;
        }
        double value = scratch->growth[worst] - SFI_LEAST_GROWTH;
        *crushed = -value > *crushed ? -value : *crushed;
        if (scratch->growth[worst] >= NARROW) {
            return;
        }
        scratch->growth[worst] = NARROW;
        int which = worst >= first;
        sfi_stretch_gradient(posture->stretches[which], which ? worst - first : worst,
                             scratch->coefficients, new_row(posture, &scratch->rows, value));
    }
}

sf_status sfi_posture_look(const sfi_posture *posture, const sf_pose *poses, sf_task *task,
                           sfi_posture_scratch *scratch, sfi_posture_state *state)
{
    sfi_posture_state s;
    sfi_pose_coefficients(poses, posture->energy->centres, posture->energy->handle_count,
                          scratch->coefficients);
    SF_TRY(weigh(posture, poses, task, scratch, &s.body));
    sfi_energy_at(posture->energy, poses, scratch->energy, s.terms, NULL, NULL);
    s.energy = s.terms[0] + s.terms[1] + s.terms[2];
    s.unsafe = s.sunk = s.crushed = 0;
    scratch->rows.count = 0;
    for (size_t i = 0; i < posture->safe_count; i++) {
        add_safe(posture, &posture->safe[i], &s.body, scratch, &s.unsafe);
    }
    scratch->rows.safe_count = scratch->rows.count;
    for (size_t g = 0; g < posture->standing_count; g++) {
        add_ground(posture, g, scratch, &s.sunk);
    }
    add_crushed(posture, scratch, &s.crushed);
    *state = s;
    return SF_OK;
}
