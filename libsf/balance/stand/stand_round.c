// SPDX-License-Identifier: MIT
// A round: bend the shape, carve what it is then, and see how it stands.
//
// With the cavity of the last round fixed, handles move until the centre of mass lies where every
// stance wants it; then the bent shape is carved anew. While there is something to bend, carving
// goes as far into the safe set as it can, because what carving gives need not be bent. Bending is
// least for its cavity, and the cavity the best for its shape, so rounds go on until neither gains
// anything; the best round is then taken up again, and carved once more, this time with as much
// matter left in it as its stances allow.
//
// Everything is made aside, and changes places with what there was when all is known; where the
// carving at the end fails after that, or is cancelled, both change places again. So a round that
// fails has changed nothing.
//
// Source: R. Prevost and others, "Make It Stand", SIGGRAPH 2013, section 3.2.

#include "balance/stand/stand.h"

#include "balance/blend/blend_fold.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "mesh/vector.h"

#include <math.h>
#include <string.h>

#define DEGREE_RAD 0.017453292519943295

// Steps of the solver in a round; the paper carves after each of its own.
enum { STEPS = 12, STEPS_OF_DESCENT = 1 };
// Folded places of a try that the next ones watch.
enum { FOLDS = 128 };
// Rounds without a gain after which it ends, once it is safe and before.
enum { IDLE_SAFE = 2, IDLE_UNSAFE = 8 };
// A gain: this share of the energy, this much of a margin.
#define GAIN_ENERGY 0.01
#define GAIN_MARGIN (0.01 * DEGREE_RAD)
// How far below its clearance a vertex may lie, as a share of the size, and count as clear.
#define SUNK_NONE 1e-4

// What a round makes.
typedef struct attempt {
    sf_pose *poses;
    double *bent;
    sfi_stances stances; // of rocking shapes; else empty, and those of before stay
    sfi_carved carved;
    sfi_descent descent;
    sfi_record best;
    sfi_stretch watched; // the stand's own, with as many places as there are now
    uint32_t steps;
    double sunk;
    int remade; // 1: the stances are its own
} attempt;

static sf_status begin(const sf_stand *s, attempt *a)
{
    memset(a, 0, sizeof *a);
    a->descent = s->descent;
    a->best = s->best;
    a->best.poses = NULL;
    a->watched = s->watched;
    a->bent = sfi_alloc_array(&s->allocator, s->surface.point_count, 3 * sizeof *a->bent);
    if (a->bent == NULL) {
        return SF_ERR_MEMORY;
    }
    if (!sfi_stand_bends(s)) {
        memcpy(a->bent, s->surface.points, 3 * s->surface.point_count * sizeof *a->bent);
        return SF_OK;
    }
    a->poses = sfi_alloc_array(&s->allocator, s->handle_count, sizeof *a->poses);
    a->best.poses = sfi_alloc_array(&s->allocator, s->handle_count, sizeof *a->poses);
    if (a->poses == NULL || a->best.poses == NULL) {
        return SF_ERR_MEMORY;
    }
    memcpy(a->poses, s->poses, s->handle_count * sizeof *a->poses);
    memcpy(a->best.poses, s->best.poses, s->handle_count * sizeof *a->poses);
    return SF_OK;
}

static void drop(const sf_stand *s, attempt *a)
{
    sfi_free_array(&s->allocator, a->bent, s->surface.point_count, 3 * sizeof *a->bent);
    sfi_free_array(&s->allocator, a->poses, s->handle_count, sizeof *a->poses);
    sfi_free_array(&s->allocator, a->best.poses, s->handle_count, sizeof *a->poses);
    sfi_stances_free(s, &a->stances);
    sfi_carved_free(s, &a->carved);
}

// --- Bending -------------------------------------------------------------------------------------

// What the solver sees: the outside and the cavity of the last round.
typedef struct scene {
    sfi_skin skins[2];
    sfi_posture posture;
} scene;

static void make_scene(const sf_stand *s, scene *made)
{
    const sfi_carved *c = &s->carved;
    const double *centres = sf_weights_centers(s->field);
    sf_mesh_view cavity = sf_mesh_get_view(c->cavity);
    sf_blend outside = {s->surface.points, s->weights, s->surface.point_count, centres,
                        s->handle_count};
    sf_blend inside = {c->rest, c->weights, c->point_count, centres, s->handle_count};
    sfi_skin skins[2] = {{outside, s->surface.triangles, &s->surface.incidence},
                         {inside, cavity.triangles, &c->incidence}};
    memcpy(made->skins, skins, sizeof skins);
    sfi_posture posture = {.energy = &s->energy,
                           .skins = made->skins,
                           .skin_count = c->point_count > 0 ? 2 : 1,
                           .loose_mass = c->loose_mass,
                           .loose_sums = c->loose_sums,
                           .safe = s->stances.safe,
                           .safe_count = s->stances.safe_count,
                           .standings = s->stances.standings,
                           .standing_count = s->stance_count,
                           .held = s->held,
                           .foot = s->foot,
                           .stretches = {&s->stretch, NULL},
                           .clearance_mm = s->options.clearance_mm,
                           .size_mm = s->size_mm};
    made->posture = posture;
}

// Steps from the poses of before, none of an unknown longer than `longest`.
static sf_status solve(const sf_stand *s, const sfi_posture *posture, uint32_t steps,
                       double longest, sf_task *task, attempt *a)
{
    sfi_freedom freedom = {s->free, s->options.scale_low, s->options.scale_high,
                           s->options.shift_max_mm, longest};
    sfi_sqp_report report;
    memcpy(a->poses, s->poses, s->handle_count * sizeof *a->poses);
    SF_TRY(sfi_sqp_run(posture, &freedom, steps, &s->allocator, task, a->poses, &report));
    a->steps += report.steps;
    return SF_OK;
}

// Steps watch some places of the solid, and may fold it between them. Then those that were folded
// are watched as well, from now on, and the steps taken anew; the last tries are shorter ones.
// Where all of them fold, nothing moves.
static sf_status solve_unfolded(const sf_stand *s, sfi_posture *posture, sf_task *task, attempt *a)
{
    static const struct {
        uint32_t steps;
        double longest;
    } tries[] = {{STEPS, 0.3}, {STEPS, 0.3}, {STEPS, 0.3}, {STEPS, 0.3},
                 {6, 0.3},     {3, 0.3},     {3, 0.1},     {3, 0.03}};
    posture->stretches[1] = &a->watched;
    for (size_t i = 0; i < sizeof tries / sizeof *tries; i++) {
        sf_fold fold;
        sfi_spot spots[FOLDS];
        size_t count, taken = 0;
        SF_TRY(solve(s, posture, tries[i].steps, tries[i].longest, task, a));
        SF_TRY(sfi_weights_folds(s->field, a->poses, task, FOLDS, &fold, spots, &count));
        if (fold.folded == 0 || s->report.folded > 0) {
            return SF_OK;
        }
        while (taken < count && sfi_stretch_add(s->field, &spots[taken], &a->watched) == SF_OK) {
            taken++;
        }
    }
    memcpy(a->poses, s->poses, s->handle_count * sizeof *a->poses);
    return SF_OK;
}

static sf_status move_handles(const sf_stand *s, sf_task *task, attempt *a)
{
    scene made;
    make_scene(s, &made);
    if (s->options.solver == SF_STAND_DESCENT) {
        sfi_posture_state state;
        a->steps = STEPS_OF_DESCENT;
        return sfi_descent_step(&made.posture, s->free, &s->allocator, task, &a->descent, a->poses,
                                &state);
    }
    return solve_unfolded(s, &made.posture, task, a);
}

// How far the lowest of the vertices that must stay clear of the ground lies too low.
static double find_sunk(const sf_stand *s, const double *bent)
{
    double most = 0;
    for (size_t i = 0; i < s->stance_count; i++) {
        const sfi_standing *ground = &s->stances.standings[i];
        for (size_t v = 0; v < s->surface.point_count && isfinite(ground->height_mm); v++) {
            double height = sfi_dot(ground->up, bent + 3 * v) - ground->height_mm;
            double sunk = ((s->foot[v] >> i & 1) != 0 ? 0 : s->options.clearance_mm) - height;
            if ((s->held[v] >> i & 1) == 0 && sunk > most) {
                most = sunk;
            }
        }
    }
    return most;
}

static sf_status bend(const sf_stand *s, sf_task *task, attempt *a)
{
    sf_blend blend = {s->surface.points, s->weights, s->surface.point_count,
                      sf_weights_centers(s->field), s->handle_count};
    SF_TRY(sf_blend_apply(blend, a->poses, NULL, a->bent));
    a->sunk = find_sunk(s, a->bent);
    for (size_t i = 0; i < s->stance_count; i++) {
        a->remade = a->remade || s->asked[i].kind == SF_STANCE_ROCK;
    }
    (void)task;
    return a->remade ? sfi_stances_make(s, a->bent, &a->stances, NULL) : SF_OK;
}

static sf_status carve(const sf_stand *s, sf_carve_goal goal, sf_task *task, attempt *a)
{
    const sfi_stances *stances = a->remade ? &a->stances : &s->stances;
    return sfi_carved_make(s, a->bent, a->poses, stances->aimed, goal, task, &a->carved);
}

static sf_carve_goal goal_of(const sf_stand *s)
{
    if (!sfi_stand_bends(s)) {
        return SF_CARVE_ENOUGH;
    }
    return s->options.solver == SF_STAND_DESCENT ? SF_CARVE_NEAREST : SF_CARVE_DEEPEST;
}

// --- Judging -------------------------------------------------------------------------------------

// The verdict of all stances about a body: what the least of them says.
static sf_status judge(const sf_stand *s, const sfi_stances *stances, const sf_body *body,
                       double *margin, int *stands, int *safe, double com[3])
{
    *margin = INFINITY;
    *stands = *safe = 1;
    SF_TRY(sf_body_com(*body, com));
    for (size_t i = 0; i < s->stance_count; i++) {
        sf_stance_verdict v;
        SF_TRY(sf_stance_judge(stances->asked[i], com, &v));
        *margin = v.margin_rad < *margin ? v.margin_rad : *margin;
        *stands = *stands && v.stands;
        *safe = *safe && v.safe;
    }
    return SF_OK;
}

static double furthest(const sf_stand *s, const double *bent)
{
    double most = 0;
    for (size_t v = 0; v < s->surface.point_count; v++) {
        double move[3];
        sfi_subtract(bent + 3 * v, s->surface.points + 3 * v, move);
        double square = sfi_dot(move, move);
        most = square > most ? square : most;
    }
    return sqrt(most);
}

static sf_status describe(const sf_stand *s, sf_task *task, const attempt *a,
                          sf_stand_report *report)
{
    sf_stand_report r = s->report;
    const sfi_stances *stances = a->remade ? &a->stances : &s->stances;
    r.rounds++;
    r.steps += a->steps;
    SF_TRY(judge(s, stances, &a->carved.body, &r.margin_rad, &r.stands, &r.safe, r.com_mm));
    r.mass = a->carved.body.mass;
    sf_mass cavity = {0};
    sf_mesh_view inside = sf_mesh_get_view(a->carved.cavity);
    if (inside.triangle_count > 0) {
        SF_TRY(sf_mesh_measure(inside, &cavity));
    }
    r.carved_mm3 = 0 - cavity.volume_mm3; // of no cavity 0, and not -0
    r.sunk_mm = a->sunk;
    r.overlap_voxels = a->carved.overlap_voxels;
    r.hanging_voxels = a->carved.hanging_voxels;
    r.bound_rad = a->carved.has_bound ? a->carved.bound_rad : r.bound_rad;
    if (sfi_stand_bends(s)) {
        sf_fold fold;
        SF_TRY(sf_weights_fold(s->field, a->poses, task, &fold));
        r.least_det = fold.least_det;
        r.folded = fold.folded;
        r.displacement_mm = furthest(s, a->bent);
        r.energy = sfi_stand_energy(s, a->poses);
    }
    r.succeeded =
        r.safe && (!sfi_stand_bends(s) || (r.folded == 0 && r.sunk_mm <= SUNK_NONE * s->size_mm));
    *report = r;
    return SF_OK;
}

// --- The end of rounds ---------------------------------------------------------------------------

// What is folded over is worse than what falls: it is no solid.
static int rank_of(const sf_stand_report *r)
{
    return r->succeeded ? 2 : r->folded == 0;
}

// Whether this round is the best so far.
static int is_better(const sf_stand *s, const sf_stand_report *r)
{
    int rank = rank_of(r), is_first = r->rounds == s->first_round + 1;
    if (rank != s->best.rank || is_first) {
        return rank > s->best.rank || is_first;
    }
    return r->succeeded ? r->energy < (1 - GAIN_ENERGY) * s->best.energy
                        : r->margin_rad > s->best.margin_rad + GAIN_MARGIN;
}

static int is_over(const sf_stand *s, const sf_stand_report *r)
{
    if (!sfi_stand_bends(s) || r->rounds - s->first_round >= s->options.rounds_max) {
        return 1;
    }
    if (s->options.solver == SF_STAND_DESCENT) {
        return r->succeeded || s->descent.ended;
    }
    return (r->succeeded && r->energy < 1e-12) ||
           s->best.idle >= (s->best.rank == 2 ? IDLE_SAFE : IDLE_UNSAFE);
}

// Whether handles stayed where the last round had carved for them: then so would the next.
static int is_still(const sf_stand *s, const attempt *a)
{
    return a->poses != NULL && s->options.solver == SF_STAND_PROGRAMS &&
           s->report.rounds > s->first_round &&
           memcmp(a->poses, s->poses, s->handle_count * sizeof *a->poses) == 0;
}

// The shape and what was made change places; called again, they change back.
static void change_places(sf_stand *s, attempt *a, sf_stand_report *report)
{
    attempt old = {.poses = s->poses,
                   .bent = s->bent,
                   .stances = s->stances,
                   .carved = s->carved,
                   .descent = s->descent,
                   .best = s->best,
                   .watched = s->watched,
                   .remade = a->remade};
    sf_stand_report was = s->report;
    s->poses = a->poses;
    s->bent = a->bent;
    s->stances = a->remade ? a->stances : s->stances;
    s->carved = a->carved;
    s->descent = a->descent;
    s->best = a->best;
    s->watched = a->watched;
    s->report = *report;
    if (!a->remade) {
        memset(&old.stances, 0, sizeof old.stances);
    }
    *a = old;
    *report = was;
    sfi_stand_surface_spread(&s->surface, s->bent, s->vertices);
}

// Keep a round in mind if it is the best so far.
static void remember(const sf_stand *s, const sf_stand_report *r, attempt *a)
{
    if (!is_better(s, r)) {
        a->best.idle++;
        return;
    }
    a->best.idle = 0;
    a->best.rank = rank_of(r);
    a->best.energy = r->energy;
    a->best.margin_rad = r->margin_rad;
    if (a->poses != NULL) {
        memcpy(a->best.poses, a->poses, s->handle_count * sizeof *a->poses);
    }
}

// What a round takes its time for, after its handles have moved: shares of its progress.
static const double moved = 0.3, carved = 0.9;

// A shape with its poses is bent, carved and looked at; progress goes on from `moved`.
static sf_status realize(const sf_stand *s, sf_carve_goal goal, sfi_progress *progress, attempt *a,
                         sf_stand_report *report)
{
    sfi_part carving, looking;
    sfi_part_begin(&carving, progress, moved, carved);
    sfi_part_begin(&looking, progress, carved, 1);
    if (sfi_stand_bends(s)) {
        SF_TRY(bend(s, &carving.task, a));
    }
    SF_TRY(carve(s, goal, &carving.task, a));
    return describe(s, &looking.task, a, report);
}

// The best round again. As was asked, it is carved with as much matter left as can be; if that
// should not do, as before.
static sf_status finish(sf_stand *s, sf_task *task)
{
    sf_carve_goal goals[2] = {s->best.rank == 2 ? SF_CARVE_ENOUGH : goal_of(s), goal_of(s)};
    if (!sfi_stand_bends(s)) {
        return SF_OK;
    }
    sfi_progress progress = sfi_progress_begin(task);
    for (int i = 0; i < 2; i++) {
        attempt a;
        sf_stand_report report;
        sfi_part half;
        sfi_part_begin(&half, &progress, i / 2.0, (i + 1) / 2.0);
        sfi_progress within = sfi_progress_begin(&half.task);
        sf_status status = begin(s, &a);
        if (status == SF_OK) {
            memcpy(a.poses, s->best.poses, s->handle_count * sizeof *a.poses);
            status = realize(s, goals[i], &within, &a, &report);
        }
        if (status == SF_OK) {
            report.rounds--; // it is no new one
            change_places(s, &a, &report);
        }
        drop(s, &a);
        if (status != SF_OK || rank_of(&s->report) == s->best.rank) {
            return status;
        }
    }
    return SF_OK;
}

static sf_status make_round(const sf_stand *s, sf_task *task, attempt *a, sf_stand_report *report)
{
    sfi_progress progress = sfi_progress_begin(task);
    sfi_part moving;
    sfi_part_begin(&moving, &progress, 0, moved);
    SF_TRY(begin(s, a));
    if (sfi_stand_bends(s) && s->report.rounds > 0) {
        SF_TRY(move_handles(s, &moving.task, a));
    }
    SF_TRY(realize(s, goal_of(s), &progress, a, report));
    remember(s, report, a);
    return SF_OK;
}

// A round, and the end where it is the last.
static sf_status go_round(sf_stand *s, sf_task *task)
{
    attempt a;
    sf_stand_report report;
    sfi_progress progress = sfi_progress_begin(task);
    sfi_part first, last;
    sfi_part_begin(&first, &progress, 0, 0.7);
    sfi_part_begin(&last, &progress, 0.7, 1);
    sf_status status = make_round(s, &first.task, &a, &report);
    int still = status == SF_OK && is_still(s, &a);
    if (status == SF_OK) {
        change_places(s, &a, &report);
        if (still || is_over(s, &s->report)) {
            status = finish(s, &last.task);
            s->report.ended = 1;
        }
        if (status != SF_OK) {
            change_places(s, &a, &report);
        }
    }
    drop(s, &a);
    return status;
}

sf_status sf_stand_round(sf_stand *stand, sf_task *task, sf_stand_report *report)
{
    if (stand == NULL) {
        return SF_ERR_ARGUMENT;
    }
    if (sf_task_is_cancelled(task)) {
        return SF_ERR_CANCELLED;
    }
    if (!stand->report.ended) {
        SF_TRY(go_round(stand, task));
    }
    if (report != NULL) {
        *report = stand->report;
    }
    return SF_OK;
}

sf_status sf_stand_run(sf_stand *stand, sf_task *task, sf_stand_report *report)
{
    if (stand == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sfi_progress progress = sfi_progress_begin(task);
    while (!stand->report.ended) {
        sfi_part part;
        double from = 1 - ldexp(1, -(int)stand->report.rounds),
               to = 1 - ldexp(1, -(int)stand->report.rounds - 1);
        sfi_part_begin(&part, &progress, from, to);
        SF_TRY(sf_stand_round(stand, &part.task, NULL));
    }
    if (report != NULL) {
        *report = stand->report;
    }
    return SF_OK;
}
