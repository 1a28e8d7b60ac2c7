// SPDX-License-Identifier: MIT
// The pointer at the Balance desk: handles are found in the picture, faces by a ray.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "app/event.h"
#include "balance.h"
#include "desk/ray.h"

// How near a handle the pointer must be, in pixels.
#define REACH_PX 12.0

// ---------------------------------------------------------------------------------------------
// Handles
// ---------------------------------------------------------------------------------------------

void balance_handle_place(const balance *b, size_t handle, double at_mm[3])
{
    sf_pose pose = balance_pose_of(b, handle);
    for (int i = 0; i < 3; i++) {
        at_mm[i] = b->state.plan.handles[handle].at_mm[i] + pose.shift_mm[i];
    }
}

static int find_handle(const balance *b, const desk_pointer *p)
{
    int best = -1;
    double least = REACH_PX;
    for (size_t i = 0; i < b->state.plan.handle_count; i++) {
        double at[3], px;
        balance_handle_place(b, i, at);
        px = ray_away_px(p, at);
        if (px < least) {
            least = px;
            best = (int)i;
        }
    }
    return best;
}

// ---------------------------------------------------------------------------------------------
// Faces
// ---------------------------------------------------------------------------------------------

static int find_face(const balance *b, const desk_pointer *p, ray_hit *found)
{
    sf_mesh_view m = sf_mesh_get_view(b->placed);
    *found = ray_none();
    for (size_t i = 0; i < m.triangle_count; i++) {
        const uint32_t *t = m.triangles + 3 * i;
        ray_meet(p, m.vertices + 3 * (size_t)t[0], m.vertices + 3 * (size_t)t[1],
                 m.vertices + 3 * (size_t)t[2], i, found);
    }
    return isfinite(found->t);
}

// The rotation by the shortest way that brings n to -z, row after row.
static void turn_down(const double n[3], double matrix[9])
{
    // B. O. Rodrigues' formula with axis n x (0, 0, -1) and cosine -n_z.
    double c = -n[2], x = -n[1], y = n[0];
    double k = c > -1 + 1e-12 ? 1 / (1 + c) : 0;
    const double rows[9] = {c + k * x * x, k * x * y, y, k * x * y, c + k * y * y, -x, -y, x, c};
    static const double over[9] = {1, 0, 0, 0, -1, 0, 0, 0, -1};
    memcpy(matrix, k > 0 ? rows : over, 9 * sizeof *matrix);
}

static void turn_after(sf_transform *t, const double matrix[9])
{
    sf_transform was = *t;
    for (int i = 0; i < 3; i++) {
        t->shift_mm[i] = ray_dot(matrix + 3 * i, was.shift_mm);
        for (int j = 0; j < 3; j++) {
            t->matrix[3 * i + j] = matrix[3 * i] * was.matrix[j] +
                                   matrix[3 * i + 1] * was.matrix[3 + j] +
                                   matrix[3 * i + 2] * was.matrix[6 + j];
        }
    }
}

// Put it down again: the lowest place at height 0, the middle over the origin.
static void put_down(balance *b)
{
    double low[3], high[3];
    sf_transform *t = &b->state.plan.turn;
    if (!balance_place(b) || sf_mesh_bounds(sf_mesh_get_view(b->placed), low, high) != SF_OK) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        t->shift_mm[i] -= i < 2 ? 0.5 * (low[i] + high[i]) : low[i];
    }
    (void)balance_place(b);
}

// On the face, alone or as well. Handles lie elsewhere then, so those of one stance go.
static void stand_on(balance *b, const ray_hit *h, int as_well)
{
    balance_plan *p = &b->state.plan;
    sf_stance_options asked = sf_stance_options_default();
    if (as_well) {
        for (int i = 0; i < 3; i++) {
            asked.up[i] = -h->normal[i];
        }
        p->stances[p->stance_count++] = asked;
        (void)balance_place(b);
        return;
    }
    double matrix[9];
    turn_down(h->normal, matrix);
    turn_after(&p->turn, matrix);
    p->stances[0] = asked;
    p->stance_count = 1;
    p->handle_count = 0;
    b->state.selected = b->state.hovered = -1;
    put_down(b);
}

static void hang_from(balance *b, const ray_hit *h, int as_well)
{
    balance_plan *p = &b->state.plan;
    sf_stance_options asked = sf_stance_options_default();
    asked.kind = SF_STANCE_HANG;
    memcpy(asked.point_mm, h->at_mm, sizeof asked.point_mm);
    p->stance_count = as_well ? p->stance_count : 0;
    p->stances[p->stance_count++] = asked;
    (void)balance_place(b);
}

static void rest_on(balance *b, const desk_pointer *p)
{
    ray_hit h;
    int as_well = (p->mods & MOD_SHIFT) != 0;
    if (!find_face(b, p, &h)) {
        return;
    }
    if (as_well && b->state.plan.stance_count == BALANCE_STANCES_MAX) {
        snprintf(b->base.said, sizeof b->base.said, "There are %d stances, which is the most.",
                 BALANCE_STANCES_MAX);
        return;
    }
    balance_remember(b, -1);
    balance_drop(b);
    if (b->state.tool == BALANCE_STAND) {
        stand_on(b, &h, as_well);
    } else {
        hang_from(b, &h, as_well);
    }
}

// ---------------------------------------------------------------------------------------------
// Calls
// ---------------------------------------------------------------------------------------------

void balance_hover(desk *d, const desk_pointer *p)
{
    balance *b = (balance *)d;
    int over = find_handle(b, p);
    if (over != b->state.hovered) {
        b->state.hovered = over;
        d->is_stale = 1;
    }
}

static void grip(balance *b, const desk_pointer *p, int handle)
{
    double at[3];
    b->state.selected = handle;
    b->base.is_stale = 1;
    if (handle < 0) {
        return;
    }
    b->mods = p->mods;
    balance_handle_place(b, (size_t)handle, at);
    b->is_dragging = ray_at_depth(p, at, b->grip_mm);
}

void balance_press(desk *d, const desk_pointer *p)
{
    balance *b = (balance *)d;
    int over = find_handle(b, p);
    d->said[0] = '\0';
    if (b->state.tool == BALANCE_HANDLES || over >= 0) {
        grip(b, p, over);
    } else if (b->state.tool == BALANCE_PUT) {
        balance_plan before = b->state.plan;
        if (balance_put_handle(b, p->eye_mm, p->along)) {
            balance_plan after = b->state.plan;
            b->state.plan = before;
            balance_remember(b, -1);
            b->state.plan = after;
            b->state.selected = (int)after.handle_count - 1;
            balance_drop(b);
        }
    } else {
        rest_on(b, p);
    }
}

// In the plane of the picture; with shift up and down alone; with control it grows and shrinks.
void balance_drag(desk *d, const desk_pointer *p)
{
    balance *b = (balance *)d;
    double at[3], now[3];
    if (!b->is_dragging || b->state.selected < 0) {
        return;
    }
    size_t handle = (size_t)b->state.selected;
    balance_handle_place(b, handle, at);
    if (!ray_at_depth(p, at, now)) {
        return;
    }
    if (b->is_dragging == 1) { // it begins to move
        balance_remember(b, -1);
        b->is_dragging = 2;
    }
    sf_pose pose = balance_pose_of(b, handle);
    double moved[3];
    for (int i = 0; i < 3; i++) {
        moved[i] = now[i] - b->grip_mm[i];
    }
    if ((b->mods & MOD_CONTROL) != 0) {
        double factor = exp(2 * ray_dot(moved, p->up) / b->state.size_mm);
        pose.scale = fmax(0.3, fmin(3, pose.scale * factor));
    } else {
        for (int i = (b->mods & MOD_SHIFT) != 0 ? 2 : 0; i < 3; i++) {
            pose.shift_mm[i] += moved[i];
        }
    }
    memcpy(b->grip_mm, now, sizeof now);
    balance_set_pose(b, handle, &pose);
}

void balance_release(desk *d)
{
    ((balance *)d)->is_dragging = 0;
}
