// SPDX-License-Identifier: MIT
// Random solids to carve, and what a carving is held against: everything counted a voxel at a time.

#ifndef SF_TEST_CARVING_H
#define SF_TEST_CARVING_H

#include "balance/forest/forest.h"

#include "law/alive.h"

#define CARVING_HALFSPACES 5

typedef struct carving_scene {
    stack s, wall, exempt, keep, act, given, result;
    sf_grid *solid, *stays, *masks[3], *out;
    sf_terms terms;
    sfi_forest_options options;
    sf_halfspace halfspaces[CARVING_HALFSPACES], slopes[CARVING_HALFSPACES];
    float density[4096];
    alive_rule alive;
    int bed;
} carving_scene;

// Whether a voxel of s has one of the 26 around it, or the outside, empty.
static inline int is_skin(const stack *s, int x, int y, int z)
{
    for (int i = 0; i < 27; i++) {
        if (!stack_get(s, x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1)) {
            return 1;
        }
    }
    return 0;
}

static inline void make_wall(const stack *s, stack *wall)
{
    int with_skin = test_random_below(3) > 0;
    double noise = test_random_below(2) * 0.4 * test_random_unit();
    stack_clear(wall, s->nx, s->ny, s->nz);
    for (int i = 0; i < stack_count(s); i++) {
        int x = i % s->nx, y = i / s->nx % s->ny, z = i / (s->nx * s->ny);
        wall->solid[i] =
            s->solid[i] && ((with_skin && is_skin(s, x, y, z)) || test_random_unit() < noise);
    }
}

static inline sf_body naive_body(const stack *s, const float *density, sf_body rest)
{
    sf_body sum = rest;
    for (int i = 0; i < stack_count(s); i++) {
        int x = i % s->nx, y = i / s->nx % s->ny, z = i / (s->nx * s->ny);
        double m = s->solid[i] ? 0.001 * (density != NULL ? density[i] : 1) : 0;
        sum.mass += m;
        sum.moment[0] += m * 0.1 * (x + 0.5);
        sum.moment[1] += m * 0.1 * (y + 0.5);
        sum.moment[2] += m * 0.1 * (z + 0.5);
    }
    return sum;
}

// Depth of a body in half-space e.
static inline double naive_depth(const carving_scene *c, const sf_body *body, size_t e)
{
    const sf_halfspace *h = &c->halfspaces[e], *g = &c->slopes[e];
    double gain = -h->offset_mm * body->mass, slope = -g->offset_mm * body->mass;
    for (int i = 0; i < 3; i++) {
        gain += h->normal[i] * body->moment[i];
        slope += g->normal[i] * body->moment[i];
    }
    return gain / (c->options.slopes != NULL ? slope : body->mass);
}

static inline double naive_least_depth(const carving_scene *c, const sf_body *body)
{
    double least = c->options.count > 0 && body->mass > 1e-15 ? INFINITY : 0;
    for (size_t e = 0; e < c->options.count && body->mass > 1e-15; e++) {
        double depth = naive_depth(c, body, e);
        least = depth < least ? depth : least;
    }
    return least;
}

// Half-spaces around where the centre of mass is, some of which it lies outside of.
static inline void make_halfspaces(carving_scene *c)
{
    sf_body body = naive_body(&c->s, c->options.density, c->options.rest);
    c->options.count = body.mass > 0 ? test_random_below(CARVING_HALFSPACES + 1) : 0;
    c->options.slopes = test_random_below(3) == 0 ? c->slopes : NULL;
    for (size_t e = 0; e < c->options.count; e++) {
        sf_halfspace *h = &c->halfspaces[e], *g = &c->slopes[e];
        double offset = 0, length = 0;
        for (int i = 0; i < 3; i++) {
            h->normal[i] = (2 * test_random_unit() - 1) * (i < 2 ? 1 : 0.2);
            length += h->normal[i] * h->normal[i];
        }
        for (int i = 0; i < 3; i++) {
            h->normal[i] /= sqrt(length);
            offset += h->normal[i] * body.moment[i] / body.mass;
        }
        h->offset_mm = offset + 0.1 * (test_random_unit() - 0.5);
        // Height above a ground that is below everything.
        sf_halfspace up = {{0, 0, 1}, -1};
        *g = up;
    }
}

static inline const sf_grid *maybe_mask(const stack *content, sf_grid *grid, uint32_t one_in)
{
    stack_write(content, grid);
    return test_random_below(one_in) == 0 ? grid : NULL;
}

static inline void make_masks(carving_scene *c)
{
    int nx = c->s.nx, ny = c->s.ny, nz = c->s.nz;
    stack_random(&c->exempt, nx, ny, nz, 0.2 * test_random_unit());
    stack_random(&c->keep, nx, ny, nz, 0.2 * test_random_unit());
    stack_random(&c->act, nx, ny, nz, 1 - 0.2 * test_random_unit());
    for (int i = 0; i < 3; i++) {
        c->masks[i] = stack_grid(&c->s);
    }
    c->terms.exempt = maybe_mask(&c->exempt, c->masks[0], 4);
    c->terms.keep = maybe_mask(&c->keep, c->masks[1], 5);
    c->terms.act = maybe_mask(&c->act, c->masks[2], 5);
    c->given = c->wall;
    for (int i = 0; i < stack_count(&c->s); i++) {
        int stays = (c->terms.keep != NULL && c->keep.solid[i]) ||
                    (c->terms.act != NULL && !c->act.solid[i]);
        c->given.solid[i] |= (uint8_t)(stays && c->s.solid[i]);
    }
}

static inline void carving_begin(carving_scene *c, int rule, int nx, int ny, int nz)
{
    if (test_random_below(3) == 0) {
        stack_random(&c->s, nx, ny, nz, 0.4 + 0.6 * test_random_unit());
    } else {
        stack_random_boxes(&c->s, nx, ny, nz, 3 + (int)test_random_below(8));
    }
    make_wall(&c->s, &c->wall);
    c->terms = sf_terms_default();
    c->terms.rule = alive_rule_by_number(rule);
    c->terms.bed_layer = test_random_below(4) == 0 && nz > 1 ? test_random_below(2) : SF_BED_AUTO;
    c->bed = stack_bed(&c->s, c->terms.bed_layer);
    alive_prepare(&c->alive, &c->terms.rule, nz);
    make_masks(c);
    sfi_forest_options none = {.goal = (sfi_forest_goal)test_random_below(3)};
    c->options = none;
    c->options.strut_width = test_random_below(4);
    for (int i = 0; i < stack_count(&c->s); i++) {
        c->density[i] = test_random_below(9) == 0 ? 0 : (float)(0.5 + test_random_unit());
    }
    c->options.density = test_random_below(3) == 0 ? c->density : NULL;
    if (test_random_below(3) == 0) {
        double m = 0.01 * test_random_unit();
        sf_body rest = {m,
                        {m * test_random_unit(), m * test_random_unit(), m * test_random_unit()}};
        c->options.rest = rest;
    }
    c->options.halfspaces = c->halfspaces;
    make_halfspaces(c);
    c->solid = stack_grid(&c->s);
    c->stays = stack_grid(&c->wall);
    c->out = stack_grid(&c->s);
}

static inline void carving_end(carving_scene *c)
{
    sf_grid *all[6] = {c->solid, c->stays, c->out, c->masks[0], c->masks[1], c->masks[2]};
    for (int i = 0; i < 6; i++) {
        sf_grid_destroy(all[i]);
    }
}

// exempt = voxels of the solid that are exempt, or not carried by the layer below as it is.
static inline void carving_exempt(const carving_scene *c, stack *exempt)
{
    static int field[STACK_VOXELS];
    const stack *s = &c->s;
    const sf_bridge *b = &c->alive.rule.bridge;
    int area = s->nx * s->ny;
    stack_clear(exempt, s->nx, s->ny, s->nz);
    for (int i = 0; i < stack_count(s); i++) {
        exempt->solid[i] = s->solid[i] && c->terms.exempt != NULL && c->exempt.solid[i];
    }
    for (int z = 0; z < s->nz; z++) {
        uint8_t own[4096];
        for (int i = 0; i < area; i++) {
            int at = z * area + i, x = i % s->nx, y = i / s->nx, reach = -1;
            if (s->solid[at] && z >= c->bed) {
                reach = z == c->bed ? c->alive.rule.slack_cap
                                    : alive_reach(&c->alive, field, s, x, y, z);
            }
            field[at] = s->solid[at] ? max_int(reach, exempt->solid[at] ? 0 : -1) : -1;
            own[i] = field[at] >= 0;
        }
        for (int i = 0; i < area; i++) {
            int at = z * area + i, x = i % s->nx, y = i / s->nx;
            if (!s->solid[at] || field[at] >= 0) {
                continue;
            }
            int is_bridged =
                z > c->bed &&
                (alive_in_gap(s, own, x, y, z, 1, 0, b->span_x, b->anchor_x) ||
                 alive_in_gap(s, own, x, y, z, 0, 1, b->span_y, b->anchor_y) ||
                 alive_in_gap(s, own, x, y, z, 1, 1, b->span_diagonal, b->anchor_diagonal) ||
                 alive_in_gap(s, own, x, y, z, -1, 1, b->span_diagonal, b->anchor_diagonal));
            exempt->solid[at] |= (uint8_t)!is_bridged;
            field[at] = 0; // either way it counts as carried for what lies above
        }
    }
}

// Added voxels that lie in no square of the width in the result.
static inline uint64_t carving_thin(const carving_scene *c)
{
    const stack *r = &c->result;
    int width = c->options.strut_width > 0 ? (int)c->options.strut_width : 1;
    uint64_t thin = 0;
    for (int i = 0; i < stack_count(r); i++) {
        int x = i % r->nx, y = i / r->nx % r->ny, z = i / (r->nx * r->ny), found = 0;
        if (!r->solid[i] || c->given.solid[i]) {
            continue;
        }
        for (int corner = 0; corner < width * width && !found; corner++) {
            int x0 = x - corner % width, y0 = y - corner / width, all = 1;
            for (int j = 0; j < width * width && all; j++) {
                all = stack_get(r, x0 + j % width, y0 + j / width, z);
            }
            found = all;
        }
        thin += (uint64_t)!found;
    }
    return thin;
}

// held = the voxels of s that are connected, through faces, edges and corners, with the wall.
static inline void carving_held(const carving_scene *c, const stack *s, stack *held)
{
    int changed = 1;
    stack_combine(held, s, &c->given, STACK_AND);
    while (changed) {
        changed = 0;
        for (int i = 0; i < stack_count(s); i++) {
            int x = i % s->nx, y = i / s->nx % s->ny, z = i / (s->nx * s->ny);
            for (int j = 0; s->solid[i] && !held->solid[i] && j < 27; j++) {
                if (stack_get(held, x + j % 3 - 1, y + j / 3 % 3 - 1, z + j / 9 - 1)) {
                    held->solid[i] = 1;
                    changed = 1;
                }
            }
        }
    }
}

#endif
