// SPDX-License-Identifier: MIT
// The shape: what was opened, where the plan puts it, and how it rests there.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "balance.h"

#define DEGREE (3.14159265358979323846 / 180)
// Of the height: corners so close to the ground become a flat foot, where it would not rest
// without.
#define FOOT_PART 0.01

// ---------------------------------------------------------------------------------------------
// Placing
// ---------------------------------------------------------------------------------------------

static sf_status copy_mesh(sf_mesh_view from, sf_mesh **to)
{
    sf_mesh *made = NULL;
    sf_status status = sf_mesh_create(NULL, &made);
    if (status == SF_OK) {
        status = sf_mesh_add_vertices(made, from.vertices, from.vertex_count);
    }
    if (status == SF_OK) {
        status = sf_mesh_add_triangles(made, from.triangles, from.triangle_count);
    }
    if (status != SF_OK) {
        sf_mesh_destroy(made);
        return status;
    }
    *to = made;
    return SF_OK;
}

static void drop_stances(balance *b)
{
    for (int i = 0; i < BALANCE_STANCES_MAX; i++) {
        sf_stance_destroy(b->stances[i]);
        b->stances[i] = NULL;
    }
}

static sf_status make_stances(balance *b, double foot_mm)
{
    balance_plan *p = &b->state.plan;
    drop_stances(b);
    for (size_t i = 0; i < p->stance_count; i++) {
        p->stances[i].contact_mm = foot_mm;
        p->stances[i].gamma_rad = p->gamma_deg * DEGREE;
        sf_status status = sf_stance_create(sf_mesh_get_view(b->placed), &p->stances[i], NULL,
                                            &b->stances[i], NULL);
        if (status != SF_OK) {
            return status;
        }
    }
    return SF_OK;
}

// On the corners that touch the ground as they are; where it is not safe so and may bend, on feet
// that are put flat.
static sf_status judge_placed(balance *b)
{
    balance_state *s = &b->state;
    sf_mesh_view mesh = sf_mesh_get_view(b->placed);
    sf_body body;
    double low[3], high[3], com[3];
    sf_status status = sf_mesh_bounds(mesh, low, high);
    if (status == SF_OK) {
        status = sf_mesh_body(mesh, 1, &body);
    }
    if (status == SF_OK) {
        status = sf_body_com(body, com);
    }
    if (status == SF_OK) {
        status = make_stances(b, 0);
    }
    if (status == SF_OK) {
        balance_judge(b, com);
        if (!s->safe && s->plan.bends) {
            status = make_stances(b, FOOT_PART * (high[2] - low[2]));
            balance_judge(b, com);
        }
    }
    s->before_rad = s->margin_rad;
    return status;
}

int balance_place(balance *b)
{
    sf_mesh *moved = NULL, *was = b->placed;
    sf_stance *stances[BALANCE_STANCES_MAX];
    memcpy(stances, b->stances, sizeof stances);
    memset(b->stances, 0, sizeof b->stances);
    sf_status status = copy_mesh(sf_mesh_get_view(b->given), &moved);
    if (status == SF_OK) {
        status = sf_mesh_transform(moved, &b->state.plan.turn);
    }
    if (status == SF_OK) {
        b->placed = moved;
        status = judge_placed(b);
    }
    if (status == SF_OK) {
        sf_mesh_destroy(was);
        for (int i = 0; i < BALANCE_STANCES_MAX; i++) {
            sf_stance_destroy(stances[i]);
        }
    } else {
        drop_stances(b);
        memcpy(b->stances, stances, sizeof stances);
        b->placed = was;
        sf_mesh_destroy(moved);
        snprintf(b->base.said, sizeof b->base.said, "%s", sf_status_message(status));
    }
    b->base.is_stale = 1;
    return status == SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Taking
// ---------------------------------------------------------------------------------------------

// Centred over the origin, its lowest point at height 0.
static sf_transform rest_as_it_lies(const double low[3], const double high[3])
{
    sf_transform t = {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
    for (int i = 0; i < 3; i++) {
        t.shift_mm[i] = i < 2 ? -0.5 * (low[i] + high[i]) : -low[i];
    }
    return t;
}

static int is_solid(sf_mesh_view mesh, char why[DESK_WHY_SIZE])
{
    sf_topology t;
    sf_mass mass;
    if (mesh.triangle_count == 0 || sf_mesh_analyze(mesh, NULL, &t) != SF_OK || !t.closed) {
        snprintf(why, DESK_WHY_SIZE,
                 "The mesh is not closed, so it is not known what is inside "
                 "and what it weighs.");
        return 0;
    }
    if (sf_mesh_measure(mesh, &mass) != SF_OK || !(mass.volume_mm3 > 0)) {
        snprintf(why, DESK_WHY_SIZE, "The mesh is inside out, or holds nothing.");
        return 0;
    }
    return 1;
}

static balance_plan first_plan(const double low[3], const double high[3], double size_mm)
{
    balance_plan p;
    memset(&p, 0, sizeof p);
    p.turn = rest_as_it_lies(low, high);
    p.stances[0] = sf_stance_options_default();
    p.stance_count = 1;
    p.gamma_deg = 4;
    p.wall_mm = 0.015 * size_mm;
    p.carving = BALANCE_SUPPORT_FREE;
    p.bends = 1;
    p.resolution = 56;
    return p;
}

int balance_take_mesh(balance *b, sf_mesh *mesh, char why[DESK_WHY_SIZE])
{
    double low[3], high[3], size = 0;
    if (!is_solid(sf_mesh_get_view(mesh), why) ||
        sf_mesh_bounds(sf_mesh_get_view(mesh), low, high) != SF_OK) {
        return 0;
    }
    for (int i = 0; i < 3; i++) {
        size = fmax(size, high[i] - low[i]);
    }
    balance_state was = b->state;
    sf_mesh *given = b->given;
    sf_stand *stand = b->stand; // which must not be asked how another shape rests
    b->stand = NULL;
    b->given = mesh;
    b->state.plan = first_plan(low, high, size);
    if (!balance_place(b)) {
        snprintf(why, DESK_WHY_SIZE, "%s", b->base.said);
        b->given = given;
        b->stand = stand;
        b->state = was;
        return 0;
    }
    sf_mesh_destroy(given);
    sf_stand_destroy(stand);
    b->state.size_mm = size;
    b->state.triangle_count = sf_mesh_get_view(mesh).triangle_count;
    b->state.selected = b->state.hovered = -1;
    b->state.is_running = 0;
    b->is_dragging = 0;
    balance_drop(b);
    balance_forget(b);
    b->base.said[0] = '\0';
    return 1;
}

// ---------------------------------------------------------------------------------------------
// The first shape
// ---------------------------------------------------------------------------------------------

typedef struct ball {
    double at[3], radius;
} ball;

static int is_in(const ball *balls, int count, const double p[3])
{
    for (int i = 0; i < count; i++) {
        double x = p[0] - balls[i].at[0], y = p[1] - balls[i].at[1], z = p[2] - balls[i].at[2];
        if (x * x + y * y + z * z <= balls[i].radius * balls[i].radius) {
            return 1;
        }
    }
    return p[2] > 2 && p[2] < 7 &&
           (p[0] - 18) * (p[0] - 18) + (p[1] - 20) * (p[1] - 20) < 100; // the foot
}

sf_mesh *balance_first_mesh(void)
{
    static const ball balls[] = {{{18, 20, 12}, 8},
                                 {{23, 20, 23}, 10},
                                 {{33, 20, 35}, 9},
                                 {{45, 20, 44}, 8},
                                 {{56, 20, 48}, 6}};
    const sf_lattice l = {72, 40, 60, 1, 1, 1, NULL, {0, 0, 0}};
    sf_surface_options smooth = sf_surface_options_default();
    sf_grid *grid = NULL;
    sf_mesh *mesh = NULL;
    smooth.smooth_passes = 24;
    if (sf_grid_create(&l, NULL, &grid) != SF_OK) {
        return NULL;
    }
    for (uint32_t k = 0; k < l.nz; k++) {
        for (uint32_t y = 0; y < l.ny; y++) {
            for (uint32_t x = 0; x < l.nx; x++) {
                const double p[3] = {x + 0.5, y + 0.5, k + 0.5};
                if (is_in(balls, (int)(sizeof balls / sizeof *balls), p)) {
                    (void)!sf_slice_set(sf_grid_slice(grid, k), x, y, 1);
                }
            }
        }
    }
    sf_status status = sf_grid_surface(grid, &smooth, NULL, NULL, &mesh);
    sf_grid_destroy(grid);
    return status == SF_OK ? mesh : NULL;
}
