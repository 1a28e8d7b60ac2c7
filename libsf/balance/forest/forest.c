// SPDX-License-Identifier: MIT
// Forest: carving that leaves nothing hanging, and balances.
//
// Which voxels of a solid may go, so that the rest prints without supports as the solid did, the
// wall stays, and the centre of mass lies where it must? The last is linear: a half-space holds
// just when its lever sums up to 0 or more over all matter (lever.h). So:
//
//     bound     the best that any carving can do, and the lever that does it         bound.c
//     interior  what the wall asks for, and which squares may carry what             interior.c
//     rounds    routes and struts for that lever: every place gets one that it rests
//               on, and what carries the wall is forced, the cheapest of many
//               tries                                        route.c, struts.c, scaffold.c
//               multipliers over the closed sets of that forest, each found exactly
//                                                                     lagrange.c, closure.c
//               polish: true voxels, true weights, until the half-spaces hold         polish.c
//     complete  what the plain rule could not carry, under the whole rule      (support/preserve)
//
// A round's multipliers give the next round its lever; the best result of all rounds is kept.
// Where not all half-spaces can hold the goal becomes the deepest: as near as can be, and the bound
// tells how near any carving could come.
//
// Without half-spaces the lever is the mass and there is nothing to search.
//
// Source: the library's own; of the paper it replaces the carving by planes (R. Prevost, E.
// Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing Shapes for 3D Fabrication",
// 2013, section 4), which leaves ceilings hanging.

#include "balance/forest/forest.h"

#include "balance/forest/bound.h"
#include "balance/forest/interior.h"
#include "balance/forest/loose.h"
#include "balance/forest/places.h"
#include "balance/forest/polish.h"
#include "balance/forest/question.h"
#include "base/status.h"
#include "base/task.h"
#include "support/preserve/complete.h"
#include "voxel/grid.h"
#include "voxel/slice.h"
#include "voxel/square.h"

enum { ROUNDS_MOST = 3, COMPLETIONS_MOST = 3 };

typedef struct carving {
    sfi_question q;
    sfi_interior in;
    sfi_places places;
    sfi_search search;
    sf_grid *kept, *shape, *best; // corners and voxels of what is tried; the best so far
    sf_grid *thin;                // what completion added last; NULL where it has no say
    sf_body best_body;
    uint64_t best_thin;     // thin voxels of the best
    sfi_forest_goal wanted; // the call's goal; search.goal may have become the deepest
    double mass_bound, depth_bound;
    uint32_t evaluations;
    sfi_progress progress;
} carving;

// ---------------------------------------------------------------------------------------------
// Shapes
// ---------------------------------------------------------------------------------------------

static sf_status measure(const carving *c, const sf_grid *shape, sf_body *body)
{
    sf_body own;
    SF_TRY(sf_grid_body(shape, c->q.options->density, NULL, &own));
    *body = sf_body_add(own, 1, c->q.options->rest);
    return SF_OK;
}

// shape = the wall and the squares of what is kept.
static sf_status build(const carving *c)
{
    for (uint32_t k = 0; k < c->in.lattice.nz; k++) {
        sf_slice kept = sf_grid_slice(c->kept, k), shape = sf_grid_slice(c->shape, k);
        sfi_places_read(&c->places, k, SFI_PLACE_KEPT, kept);
        SF_TRY(sf_slice_copy(shape, kept));
        sfi_square_fill(shape, c->in.width);
        SF_TRY(sf_slice_or(shape, shape, sf_grid_slice(c->in.wall, k)));
    }
    return SF_OK;
}

// The closed set of least weight, as sfi_search wants it.
static sf_status find_closed(void *context, const sfi_lever *weight, sf_body *body)
{
    carving *c = context;
    sfi_places *p = &c->places;
    if (sf_task_is_cancelled(c->q.task)) {
        return SF_ERR_CANCELLED;
    }
    sfi_places_weigh(p, weight);
    sfi_closure_least(p->count, p->next, p->weight, p->gain, p->state);
    SF_TRY(build(c));
    return measure(c, c->shape, body);
}

// Routes and struts by a lever.
static sf_status grow(carving *c, const sfi_lever *weight)
{
    sfi_places_weigh(&c->places, weight);
    return sfi_places_scaffold(&c->places);
}

// ---------------------------------------------------------------------------------------------
// Rounds
// ---------------------------------------------------------------------------------------------

// What weighs nothing balances nowhere.
static int holds(const carving *c, const sf_body *body)
{
    if (c->search.count > 0 && !(body->mass > 0)) {
        return 0;
    }
    for (size_t e = 0; e < c->search.count; e++) {
        if (sfi_lever_body(&c->search.levers[e], body) < 0) {
            return 0;
        }
    }
    return 1;
}

static int is_better(const carving *c, const sf_body *a, const sf_body *b)
{
    int does = holds(c, a), did = holds(c, b);
    if (does != did) {
        return does;
    }
    if (!does || c->wanted == SFI_FOREST_DEEPEST) {
        return sfi_depth_of(&c->search, a) > sfi_depth_of(&c->search, b);
    }
    return c->wanted == SFI_FOREST_MOST ? a->mass > b->mass : a->mass < b->mass;
}

// kept = the shape, completed under the whole rule.
static sf_status complete(const carving *c)
{
    sf_terms terms = sfi_interior_terms(&c->in);
    sfi_completion completion = {c->q.solid, c->shape, &terms, c->in.bed, 0};
    return sfi_complete_into(c->kept, &completion, &c->q.allocator, NULL);
}

// Take the shape, completed where it must be, if it is the best so far.
static sf_status take(carving *c)
{
    sf_body body;
    sf_grid *whole = c->shape;
    uint64_t thin = c->in.thin_voxels;
    if (c->thin != NULL) {
        SF_TRY(complete(c));
        whole = c->kept;
        for (uint32_t k = 0; k < c->in.lattice.nz; k++) {
            sf_slice added = sf_grid_slice(c->thin, k);
            SF_TRY(sf_slice_subtract(added, sf_grid_slice(whole, k), sf_grid_slice(c->shape, k)));
            thin += sf_slice_popcount(added);
        }
    }
    SF_TRY(sfi_drop_loose(&c->in, whole));
    SF_TRY(measure(c, whole, &body));
    if (is_better(c, &body, &c->best_body)) {
        SF_TRY(sfi_grid_copy(c->best, whole));
        c->best_body = body;
        c->best_thin = thin;
    }
    return SF_OK;
}

// What was found by going deep, and holds, is then made better by the goal that was wanted.
static sf_status polish(carving *c)
{
    sfi_search search = c->search;
    sfi_polish p = {.places = &c->places,
                    .search = &search,
                    .density = c->q.options->density,
                    .kept = c->kept,
                    .shape = c->shape};
    SF_TRY(measure(c, c->shape, &p.body));
    SF_TRY(sfi_polish_shape(&p));
    if (c->wanted == search.goal || !holds(c, &p.body)) {
        return SF_OK;
    }
    search.goal = c->wanted;
    return sfi_polish_shape(&p);
}

// One round: a forest by the lever, its best closed set, polished. The lever becomes the next one.
static sf_status make_round(carving *c, sfi_lever *weight)
{
    sf_body body;
    SF_TRY(grow(c, weight));
    if (c->search.count == 0) {
        c->evaluations++;
        SF_TRY(find_closed(c, weight, &body));
    } else {
        sfi_multipliers m;
        c->search.find = find_closed;
        c->search.context = c;
        SF_TRY(sfi_multipliers_find(&c->search, &m));
        c->evaluations += m.evaluations;
        *weight = m.weight;
    }
    SF_TRY(polish(c));
    return take(c);
}

// What the multipliers say where nothing needs to be carried: the lever to begin with, and the
// bound.
static sf_status ask_bound(carving *c, sfi_multipliers *m)
{
    sfi_fractional f = {c->q.solid,         c->in.given, c->q.options->density,
                        c->q.options->rest, c->q.task,   c->shape};
    sfi_search search = c->search;
    search.find = sfi_fractional_find;
    search.context = &f;
    SF_TRY(sfi_multipliers_find(&search, m));
    *(search.goal == SFI_FOREST_DEEPEST ? &c->depth_bound : &c->mass_bound) = m->bound;
    return SF_OK;
}

// Where all goes: by the goal, and where that is out of reach, as deep as can be.
static sf_status begin(carving *c, sfi_lever *weight)
{
    sfi_multipliers m;
    if (c->search.count == 0) {
        sf_body body;
        SF_TRY(measure(c, c->in.given, &body));
        c->search.goal = c->wanted = SFI_FOREST_LEAST;
        c->mass_bound = body.mass;
        *weight = (sfi_lever){{0, 0, 0}, 1 / c->search.mass_unit};
        return SF_OK;
    }
    SF_TRY(ask_bound(c, &m));
    if (c->search.goal != SFI_FOREST_DEEPEST && !m.holds) {
        // No carving holds, but one within rounding of it might.
        c->mass_bound = c->search.goal == SFI_FOREST_MOST ? c->q.whole.mass : 0;
        c->search.goal = SFI_FOREST_DEEPEST;
        SF_TRY(ask_bound(c, &m));
    }
    *weight = m.weight;
    return SF_OK;
}

static sf_status make_rounds(carving *c, sfi_lever weight)
{
    for (int round = 0; round < ROUNDS_MOST; round++) {
        sf_body before = c->best_body;
        SF_TRY(make_round(c, &weight));
        sfi_progress_report(&c->progress, (uint64_t)round + 1, ROUNDS_MOST + 1);
        if (c->search.count == 0 || (round > 0 && !is_better(c, &c->best_body, &before))) {
            break;
        }
    }
    return SF_OK;
}

static sf_status carve(carving *c)
{
    sfi_lever weight;
    if (c->search.count > 0 && c->search.goal == SFI_FOREST_MOST && holds(c, &c->q.whole)) {
        c->mass_bound = c->q.whole.mass; // all may stay
        return SF_OK;
    }
    SF_TRY(begin(c, &weight));
    SF_TRY(make_rounds(c, weight));
    if (c->search.goal != SFI_FOREST_DEEPEST && !holds(c, &c->best_body)) {
        c->search.goal = SFI_FOREST_DEEPEST;
        SF_TRY(begin(c, &weight));
        SF_TRY(make_rounds(c, weight));
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The call
// ---------------------------------------------------------------------------------------------

// Whether the best holds the wall, lies in the solid, and is supported as the solid was.
static sf_status prove(const carving *c)
{
    sf_terms terms = sfi_interior_terms(&c->in);
    SF_TRY(sfi_trim_into(c->shape, c->best, &terms, c->in.bed, &c->q.allocator, NULL));
    int good = sf_grid_equal(c->shape, c->best) && sfi_grid_within(c->in.given, c->best) &&
               sfi_grid_within(c->best, c->q.solid);
    return good ? SF_OK : SF_ERR_INTERNAL;
}

static void report_to(const carving *c, sfi_forest_report *report)
{
    uint64_t left = sf_grid_popcount(c->best);
    double depth = sfi_depth_of(&c->search, &c->best_body);
    int did = holds(c, &c->best_body);
    sfi_forest_goal goal = did ? c->wanted : SFI_FOREST_DEEPEST;
    sfi_forest_report r = {.goal = goal,
                           .holds = did,
                           .body = c->best_body,
                           .depth = c->best_body.mass > 0 ? depth : 0,
                           .bound = goal == SFI_FOREST_DEEPEST ? c->depth_bound : c->mass_bound,
                           .removed_voxels = sf_grid_popcount(c->q.solid) - left,
                           .kept_voxels = left - sf_grid_popcount(c->in.given),
                           .thin_voxels = c->best_thin,
                           .asked_voxels = c->in.asked_voxels,
                           .evaluations = c->evaluations};
    *report = r;
}

static sf_status create_grids(carving *c)
{
    sf_grid **grids[4] = {&c->kept, &c->shape, &c->best, &c->thin};
    for (int i = 0; i < (c->in.is_open ? 4 : 3); i++) {
        SF_TRY(sf_grid_create(&c->q.lattice, &c->q.allocator, grids[i]));
    }
    return SF_OK;
}

static sf_status work(carving *c)
{
    SF_TRY(sfi_interior_create(c->q.solid, c->q.wall, c->q.terms, c->q.bed, c->q.width,
                               &c->q.allocator, c->q.task, &c->in));
    SF_TRY(create_grids(c));
    SF_TRY(sfi_grid_copy(c->best, c->q.solid)); // which is a result too, if a poor one
    c->best_body = c->q.whole;
    c->wanted = c->q.options->goal;
    for (int i = 0;; i++) {
        SF_TRY(sfi_places_create(&c->in, c->q.options->density, &c->places));
        c->search = sfi_question_search(&c->q, c->wanted);
        SF_TRY(carve(c));
        if (c->thin == NULL || holds(c, &c->best_body) || i == COMPLETIONS_MOST) {
            break;
        }
        // What completion added weighs too: let it be wall, and balance again.
        sfi_places_destroy(&c->places);
        SF_TRY(sfi_interior_thicken(&c->in, c->thin));
    }
    return prove(c);
}

sf_status sfi_carve_forest(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                           const sfi_forest_options *options, const sf_allocator *allocator,
                           sf_task *task, sf_grid *result, sfi_forest_report *report)
{
    if (terms == NULL || result == NULL || result == solid || result == wall) {
        return SF_ERR_ARGUMENT;
    }
    carving c = {.progress = sfi_progress_begin(task)};
    SF_TRY(sfi_question_create(solid, wall, terms, options, allocator, task, &c.q));
    sf_status status =
        sfi_terms_mask(terms, result) ? SF_ERR_ARGUMENT : sfi_terms_match(&c.q.lattice, result);
    if (status == SF_OK) {
        status = work(&c);
    }
    if (status == SF_OK) {
        status = sfi_grid_copy(result, c.best);
        sfi_progress_report(&c.progress, 1, 1);
        if (report != NULL) {
            report_to(&c, report);
        }
    }
    sfi_places_destroy(&c.places);
    sfi_interior_destroy(&c.in);
    sf_grid_destroy(c.kept);
    sf_grid_destroy(c.shape);
    sf_grid_destroy(c.best);
    sf_grid_destroy(c.thin);
    sfi_question_destroy(&c.q);
    return status;
}
