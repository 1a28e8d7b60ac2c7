// SPDX-License-Identifier: MIT
// Rounds, in pieces: first what they need (voxels, weights, energy), then one round at a time.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "balance.h"

#define DEGREE (3.14159265358979323846 / 180)

// ---------------------------------------------------------------------------------------------
// Judging
// ---------------------------------------------------------------------------------------------

// A stance as it has become, or as it was asked for.
static const sf_stance *stance_of(const balance *b, size_t i)
{
    const sf_stance *now = sf_stand_stance(b->stand, i);
    return now != NULL ? now : b->stances[i];
}

void balance_judge(balance *b, const double com_mm[3])
{
    balance_state *s = &b->state;
    memcpy(s->com_mm, com_mm, sizeof s->com_mm);
    s->margin_rad = INFINITY;
    s->stands = s->safe = 1;
    for (size_t i = 0; i < s->plan.stance_count; i++) {
        sf_stance_verdict *v = &s->verdicts[i];
        if (stance_of(b, i) == NULL || sf_stance_judge(stance_of(b, i), com_mm, v) != SF_OK) {
            continue;
        }
        s->margin_rad = v->margin_rad < s->margin_rad ? v->margin_rad : s->margin_rad;
        s->stands = s->stands && v->stands;
        s->safe = s->safe && v->safe;
    }
}

// ---------------------------------------------------------------------------------------------
// Voxels and handles
// ---------------------------------------------------------------------------------------------

static uint32_t count_of(double low, double high, double pitch)
{
    return (uint32_t)ceil((high - low) / pitch) + 2;
}

static sf_status make_voxels(const balance *b, sf_grid **solid)
{
    sf_mesh_view mesh = sf_mesh_get_view(b->placed);
    double pitch = b->state.size_mm / b->state.plan.resolution, low[3], high[3];
    sf_status status = sf_mesh_bounds(mesh, low, high);
    if (status != SF_OK) {
        return status;
    }
    const sf_lattice l = {count_of(low[0], high[0], pitch),
                          count_of(low[1], high[1], pitch),
                          count_of(low[2], high[2], pitch),
                          pitch,
                          pitch,
                          pitch,
                          NULL,
                          {low[0] - pitch, low[1] - pitch, low[2] - pitch}};
    status = sf_grid_create(&l, NULL, solid);
    return status == SF_OK ? sf_grid_voxelize(*solid, mesh, NULL, NULL, NULL, NULL) : status;
}

static void add_handle(balance_plan *p, const double at_mm[3])
{
    balance_handle *h = &p->handles[p->handle_count++];
    memcpy(h->at_mm, at_mm, sizeof h->at_mm);
    h->pose = sf_pose_identity();
    h->locked = 0;
}

static int say(balance *b, sf_status status, const sf_fault *fault)
{
    if (status != SF_OK) {
        snprintf(b->base.said, sizeof b->base.said, "%s",
                 fault->message[0] != '\0' ? fault->message : sf_status_message(status));
    }
    return status == SF_OK;
}

int balance_put_handles(balance *b)
{
    balance_plan *p = &b->state.plan;
    sf_handle found[BALANCE_HANDLES_MAX];
    sf_place_options o = sf_place_options_default();
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_grid *solid = NULL, *foot = NULL;
    size_t count = 0;
    o.count = b->state.wanted;
    sf_status status = make_voxels(b, &solid);
    if (status == SF_OK) {
        status = sf_grid_foot(solid, p->stances[0].up, 0, NULL, &foot);
    }
    if (status == SF_OK) {
        o.base = foot;
        status =
            sf_handles_place(solid, &o, NULL, NULL, found, BALANCE_HANDLES_MAX, &count, &fault);
    }
    sf_grid_destroy(solid);
    sf_grid_destroy(foot);
    if (!say(b, status, &fault)) {
        return 0;
    }
    p->handle_count = 0;
    for (size_t i = 0; i < count; i++) {
        add_handle(p, found[i].at_mm);
    }
    return 1;
}

int balance_put_handle(balance *b, const double eye_mm[3], const double along[3])
{
    balance_plan *p = &b->state.plan;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_grid *solid = NULL;
    double at[3];
    if (p->handle_count == BALANCE_HANDLES_MAX) {
        snprintf(b->base.said, sizeof b->base.said, "There are %d handles, which is the most.",
                 BALANCE_HANDLES_MAX);
        return 0;
    }
    sf_status status = make_voxels(b, &solid);
    if (status == SF_OK) {
        status = sf_handle_center(solid, eye_mm, along, at, &fault);
    }
    sf_grid_destroy(solid);
    if (!say(b, status, &fault)) {
        return 0;
    }
    add_handle(p, at);
    return 1;
}

sf_pose balance_pose_of(const balance *b, size_t handle)
{
    const balance_handle *h = &b->state.plan.handles[handle];
    return h->locked || b->stand == NULL ? h->pose : sf_stand_get_pose(b->stand, handle);
}

static void tell_pose(balance *b, size_t handle)
{
    const balance_handle *h = &b->state.plan.handles[handle];
    if (b->stand != NULL) {
        (void)!sf_stand_set_pose(b->stand, handle, &h->pose, h->locked);
    }
    b->is_pending = 1;
    b->base.is_stale = 1;
}

void balance_set_pose(balance *b, size_t handle, const sf_pose *pose)
{
    balance_handle *h = &b->state.plan.handles[handle];
    h->pose = *pose;
    h->locked = 1;
    tell_pose(b, handle);
}

void balance_lock(balance *b, size_t handle, int lock)
{
    balance_handle *h = &b->state.plan.handles[handle];
    h->pose = balance_pose_of(b, handle);
    h->locked = lock;
    tell_pose(b, handle);
}

// ---------------------------------------------------------------------------------------------
// Rounds
// ---------------------------------------------------------------------------------------------

void balance_drop(balance *b)
{
    sf_stand_destroy(b->stand);
    b->stand = NULL;
    b->left_out = 0;
    b->state.has_report = 0;
    b->base.is_stale = 1;
}

static sf_stand_options options_of(const balance_state *s)
{
    sf_stand_options o = sf_stand_options_default();
    o.pitch_mm = s->size_mm / s->plan.resolution;
    o.wall_mm = s->plan.wall_mm;
    o.carve = s->plan.carving != BALANCE_SOLID;
    o.carve_mode = s->plan.carving == BALANCE_PLANES ? SF_CARVE_PLANE : SF_CARVE_SUPPORT_FREE;
    o.deform = s->plan.bends;
    return o;
}

// A handle goes: nothing may point at it any more.
static void leave_out_last(balance *b)
{
    int last = (int)--b->state.plan.handle_count;
    b->left_out++;
    if (b->state.selected == last) {
        b->state.selected = -1;
        b->is_dragging = 0;
    }
    b->state.hovered = b->state.hovered == last ? -1 : b->state.hovered;
}

// Handles that were found on voxels may be too close to what holds still: the last ones, which were
// the worst, go then.
static sf_status create(balance *b, sf_fault *fault)
{
    balance_plan *p = &b->state.plan;
    sf_stand_options o = options_of(&b->state);
    for (;;) {
        sf_handle handles[BALANCE_HANDLES_MAX];
        size_t count = p->bends ? p->handle_count : 0;
        for (size_t i = 0; i < count; i++) {
            const balance_handle *h = &p->handles[i];
            const sf_handle handle = {
                SF_HANDLE_POINT, {h->at_mm[0], h->at_mm[1], h->at_mm[2]}, 0, NULL, h->locked};
            handles[i] = handle;
        }
        sf_status status = sf_stand_create(sf_mesh_get_view(b->placed), p->stances, p->stance_count,
                                           handles, count, &o, NULL, NULL, &b->stand, fault);
        if (status != SF_ERR_INFEASIBLE || count == 0) {
            return status;
        }
        leave_out_last(b);
    }
}

// Nothing, or that handles are gone which a person may have put.
static void say_left_out(balance *b)
{
    b->base.said[0] = '\0';
    if (b->left_out > 0) {
        snprintf(b->base.said, sizeof b->base.said,
                 "%d handle%s left out, too close to what holds still or to another: more voxels "
                 "may tell them apart.",
                 b->left_out, b->left_out == 1 ? " is" : "s are");
    }
}

static void prepare(balance *b)
{
    balance_plan *p = &b->state.plan;
    sf_fault fault = {SF_OK, 0, 0, ""};
    if (p->bends && p->handle_count == 0 && !balance_put_handles(b)) {
        b->state.is_running = b->is_pending = 0;
        return;
    }
    if (!say(b, create(b, &fault), &fault)) {
        b->state.is_running = b->is_pending = 0;
        return;
    }
    say_left_out(b);
    for (size_t i = 0; i < p->handle_count; i++) {
        if (p->handles[i].locked) {
            (void)!sf_stand_set_pose(b->stand, i, &p->handles[i].pose, 1);
        }
    }
}

static void say_end(balance *b)
{
    const balance_state *s = &b->state;
    char *said = b->base.said;
    if (s->report.folded > 0) {
        snprintf(said, DESK_WHY_SIZE, "It is folded over in %llu places, which nobody can print.",
                 (unsigned long long)s->report.folded);
    } else if (s->report.ended && !s->report.succeeded) {
        snprintf(said, DESK_WHY_SIZE,
                 "That is the best that was found, %.1f degrees. Try a thinner wall, more handles, "
                 "a smaller tilt, or move a handle.",
                 s->margin_rad / DEGREE);
    } else {
        say_left_out(b);
    }
}

void balance_step(balance *b)
{
    balance_state *s = &b->state;
    b->base.is_stale = 1;
    if (b->stand == NULL) {
        prepare(b);
        return;
    }
    sf_stand_report report;
    sf_fault none = {SF_OK, 0, 0, ""};
    sf_status status = sf_stand_round(b->stand, NULL, &report);
    b->is_pending = 0;
    if (!say(b, status, &none)) {
        s->is_running = 0;
        return;
    }
    s->report = report;
    s->has_report = 1;
    balance_judge(b, report.com_mm);
    if (report.ended) {
        s->is_running = 0;
    }
    say_end(b);
}

sf_mesh_view balance_outer(const balance *b)
{
    return b->state.has_report ? sf_stand_outer(b->stand) : sf_mesh_get_view(b->placed);
}

sf_mesh_view balance_cavity(const balance *b)
{
    return sf_stand_cavity(b->state.has_report ? b->stand : NULL);
}
