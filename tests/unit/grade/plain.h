// SPDX-License-Identifier: MIT
// The limit of a place the plain way: cut the cells around it out, refine them by one step as a
// cage of their own, and so on, until what is left is a point.

#ifndef SF_TEST_PLAIN_H
#define SF_TEST_PLAIN_H

#include "cages.h"

#include <sf/limit.h>

// Cells of a cage around one of them, two deep, as a cage that owns its arrays.
typedef struct cutout {
    test_cage cage;
    size_t middle;
} cutout;

static inline void mark_touching(const sf_cage_view *v, const unsigned char *cells,
                                 unsigned char *points)
{
    for (size_t i = 0; i < v->cell_count; i++) {
        for (uint32_t j = v->starts[i]; cells[i] && j < v->starts[i + 1]; j++) {
            points[v->corners[j]] = 1;
        }
    }
}

static inline cutout cut_out(const sf_cage_view *v, size_t cell, const sf_channel *values)
{
    unsigned char *cells = calloc(v->cell_count, 1), *points = calloc(v->point_count, 1);
    uint32_t *numbers = calloc(v->point_count, sizeof *numbers);
    cells[cell] = 1;
    for (int ring = 0; ring < 2; ring++) {
        mark_touching(v, cells, points);
        for (size_t i = 0; i < v->cell_count; i++) {
            for (uint32_t j = v->starts[i]; j < v->starts[i + 1]; j++) {
                cells[i] |= points[v->corners[j]];
            }
        }
    }
    mark_touching(v, cells, points);
    size_t cell_count = 0, point_count = 0;
    for (size_t i = 0; i < v->cell_count; i++) {
        cell_count += cells[i];
    }
    for (size_t i = 0; i < v->point_count; i++) {
        numbers[i] = (uint32_t)point_count;
        point_count += points[i];
    }
    size_t corners = v->starts[cell + 1] - v->starts[cell];
    cutout c = {test_cage_begin(v->dimension, point_count, cell_count, corners), 0};
    c.cage.values = calloc(point_count, sizeof(double));
    for (size_t i = 0; i < v->point_count; i++) {
        if (points[i]) {
            memcpy(c.cage.positions + 3 * (size_t)numbers[i], v->positions + 3 * i, 24);
            c.cage.values[numbers[i]] = values->values[i];
        }
    }
    size_t at = 0;
    for (size_t i = 0; i < v->cell_count; i++) {
        for (size_t j = 0; cells[i] && j < corners; j++) {
            c.cage.corners[corners * at + j] = numbers[v->corners[v->starts[i] + j]];
        }
        c.middle = i == cell ? at : c.middle;
        at += cells[i];
    }
    for (size_t i = 0; i < v->crease_count; i++) {
        const sf_crease *s = &v->creases[i];
        if (points[s->points[0]] && points[s->points[1]]) {
            sf_crease moved = {{numbers[s->points[0]], numbers[s->points[1]]}, s->sharpness};
            c.cage.crease[c.cage.creases++] = moved;
        }
    }
    for (size_t i = 0; i < v->sharp_count; i++) {
        if (points[v->sharps[i].point]) {
            sf_sharp_point moved = {numbers[v->sharps[i].point], v->sharps[i].sharpness};
            c.cage.sharp[c.cage.sharps++] = moved;
        }
    }
    free(cells);
    free(points);
    free(numbers);
    return c;
}

// Refine around a place, and give the middle of what is left: a position and a value.
static inline void plain(const sf_cage *start, sf_refine_rules rules, sf_place place, int depth,
                         double found[4])
{
    sf_cage *cage = NULL;
    size_t cell = place.piece;
    uint32_t dimension = sf_cage_get_view(start).dimension, corners = 1u << dimension;
    for (int step = 0; step <= depth; step++) {
        sf_refine_options options = sf_refine_options_default();
        options.rules = rules;
        sf_refinement *r = NULL;
        sf_cage_view v;
        CHECK_EQ(sf_refine(step == 0 ? start : cage, &options, NULL, NULL, &r), SF_OK);
        CHECK_EQ(sf_refinement_get_view(r, 1, &v), SF_OK);
        sf_cage_destroy(cage);
        if (step > 0) { // the first step makes pieces, the others cut one
            uint32_t bits = 0;
            for (uint32_t axis = 0; axis < dimension; axis++) {
                uint32_t high = place.u[axis] >= 0.5;
                place.u[axis] = 2 * place.u[axis] - high;
                bits |= high << axis;
            }
            cell = corners * cell + (bits ^ (bits >> 1 & 1));
        }
        cutout c = cut_out(&v, cell, &v.channels[0]);
        sf_refinement_destroy(r);
        cage = test_cage_make(&c.cage);
        cell = c.middle;
        memset(found, 0, 4 * sizeof *found);
        for (uint32_t i = 0; i < corners; i++) {
            uint32_t point = c.cage.corners[corners * cell + i];
            for (int axis = 0; axis < 3; axis++) {
                found[axis] += c.cage.positions[3 * point + (uint32_t)axis] / corners;
            }
            found[3] += c.cage.values[point] / corners;
        }
        test_cage_free(&c.cage);
    }
    sf_cage_destroy(cage);
}

#endif
