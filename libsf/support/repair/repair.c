// SPDX-License-Identifier: MIT
// Repair: what may be done, what must be kept, and the proof before the first write.
//
// Names, here and in all parts of a repair:
//
//     V   what is drawn
//     P   what of it must stay: the voxels of `keep`, and those outside `act`
//     A   what may be solid: V, and what `act` and `forbid` allow to be added from the bed up
//     G   room: trim(A). Every support-free result lies in it, and P must (terms.c)
//     T   roots: trim(V). There is a cheapest result that holds it: if R is one, so is R with T
//
// All are taken under the full rule. With bridges, the forest and the rounds then work with the
// rule without them, and count T as exempt: what stands on its own stays, bridges and all, and
// everything that is added stands by the plain rule on that. Such a result stands under the full
// rule, which is monotone, and is never dearer than T. Afterwards the full rule has its say
// (bridged.c).
//
// What is tried within these sets is an attempt (attempt.c). There is one for what must stay, and
// before it one for all that can be kept: it is what a caller gets who keeps everything, and a
// repair is to cost no more than that.
//
// Working memory goes through a meter, so that a caller learns what a repair took at most.

#include <sf/repair.h>

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "support/repair/attempt.h"
#include "support/repair/strut.h"
#include "support/rule/carry.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

sf_repair_options sf_repair_options_default(void)
{
    sf_repair_options options = {sizeof options, sf_terms_default(), NULL, NULL, 1, 0};
    return options;
}

// Most that a cost is multiplied by: times 255 it still is a price.
#define SCALE_MOST 128u
// Voxels in the air up to which it is tried to keep all of them.
#define HANGING_MOST 4000000u
#define ATTEMPTS 3

// ---------------------------------------------------------------------------------------------
// The meter
// ---------------------------------------------------------------------------------------------

typedef struct meter {
    sf_allocator below;
    uint64_t live, peak;
} meter;

static void *meter_alloc(void *user, size_t size, size_t align)
{
    meter *m = user;
    void *memory = m->below.alloc(m->below.user, size, align);
    if (memory != NULL) {
        m->live += size;
        m->peak = m->peak > m->live ? m->peak : m->live;
    }
    return memory;
}

static void meter_free(void *user, void *memory, size_t size)
{
    meter *m = user;
    m->live -= size;
    m->below.free(m->below.user, memory, size);
}

// ---------------------------------------------------------------------------------------------
// Sets
// ---------------------------------------------------------------------------------------------

// One call: what was asked, and the sets that it comes down to.
typedef struct call {
    sf_grid *grid;
    const sf_repair_options *options;
    sfi_ground ground;
    sf_terms terms; // the caller's, with the bed that they came to
    const sf_allocator *allocator;
    sfi_pace pace;
    sf_grid *must, *room, *roots, *result;
    sf_grid *plain_room, *plain_exempt; // with bridges
    sfi_quest quest;
    sfi_attempt attempts[ATTEMPTS]; // to keep all, with bridges even more; and what must stay
    sf_repair_report report;
} call;

// allowed = A, layer k.
static sf_status find_allowed(const call *c, uint32_t k, sf_slice allowed)
{
    const sf_terms *terms = &c->options->terms;
    sf_slice drawn = sf_grid_slice(c->grid, k);
    if (k < c->ground.bed) {
        return sf_slice_copy(allowed, drawn);
    }
    sf_rect all = {0, 0, drawn.width, drawn.height};
    SF_TRY(terms->act != NULL ? sf_slice_copy(allowed, sf_grid_slice(terms->act, k))
                              : sf_slice_fill(allowed, all, 1));
    if (terms->forbid != NULL) {
        SF_TRY(sf_slice_subtract(allowed, allowed, sf_grid_slice(terms->forbid, k)));
    }
    return sf_slice_or(allowed, allowed, drawn);
}

// must = P, layer k.
static sf_status find_must(const call *c, uint32_t k, sf_slice must)
{
    const sf_terms *terms = &c->options->terms;
    sf_slice drawn = sf_grid_slice(c->grid, k);
    if (terms->keep == NULL) {
        return sf_slice_subtract(must, drawn, sf_grid_slice(terms->act, k));
    }
    if (terms->act == NULL) {
        return sf_slice_and(must, drawn, sf_grid_slice(terms->keep, k));
    }
    // V and (keep or not act) = V without (act without keep).
    SF_TRY(sf_slice_subtract(must, sf_grid_slice(terms->act, k), sf_grid_slice(terms->keep, k)));
    return sf_slice_subtract(must, drawn, must);
}

static sf_status new_grid(const call *c, sf_grid **grid)
{
    return sf_grid_create(&c->ground.lattice, c->allocator, grid);
}

static sf_status trim_full(call *c, sf_grid *to, const sf_grid *from)
{
    return sfi_trim_into(to, from, &c->terms, c->ground.bed, c->allocator, sfi_pace_next(&c->pace));
}

static sf_status find_sets(call *c)
{
    const sf_terms *terms = &c->options->terms;
    SF_TRY(new_grid(c, &c->room));
    SF_TRY(new_grid(c, &c->roots));
    SF_TRY(new_grid(c, &c->result));
    if (terms->keep != NULL || terms->act != NULL) {
        SF_TRY(new_grid(c, &c->must));
    }
    for (uint32_t k = 0; k < c->ground.lattice.nz; k++) {
        SF_TRY(find_allowed(c, k, sf_grid_slice(c->room, k)));
        if (c->must != NULL) {
            SF_TRY(find_must(c, k, sf_grid_slice(c->must, k)));
        }
    }
    SF_TRY(trim_full(c, c->room, c->room));
    return trim_full(c, c->roots, c->grid);
}

// P without G, into `missing`; their number.
static uint64_t find_culprits(const call *c, sf_grid *missing)
{
    uint64_t count = 0;
    for (uint32_t k = 0; c->must != NULL && k < c->ground.lattice.nz; k++) {
        sf_slice out = sf_grid_slice(missing, k);
        (void)!sf_slice_subtract(out, sf_grid_slice(c->must, k), sf_grid_slice(c->room, k));
        count += sf_slice_popcount(out);
    }
    return count;
}

// ---------------------------------------------------------------------------------------------
// The job
// ---------------------------------------------------------------------------------------------

static sf_status make_job(call *c, sfi_job *job)
{
    const sf_repair_options *o = c->options;
    *job = (sfi_job){.rule = o->terms.rule,
                     .lattice = c->ground.lattice,
                     .bed = c->ground.bed,
                     .add = o->add_cost,
                     .remove = o->remove_cost,
                     .allocator = c->allocator,
                     .pace = &c->pace,
                     .drawn = c->grid,
                     .must = c->must,
                     .exempt = o->terms.exempt,
                     .room = c->room,
                     .roots = c->roots};
    // An addition stands for a square of them, as far as prices can count.
    uint32_t width = o->min_feature_vx;
    job->scale = width * width < SCALE_MOST ? width * width : SCALE_MOST;
    if (!sfi_bridge_any(&job->rule.bridge)) {
        return sfi_job_find_reach(job);
    }
    static const sf_bridge none = {0, 0, 0, 0, 0, 0};
    sf_rule rule = job->rule;
    rule.bridge = none;
    return sfi_job_set_aside(job, rule, &c->plain_room, &c->plain_exempt);
}

// Whether the result is support-free under the full rule, holds P and lies in G.
static sf_status prove(call *c)
{
    sf_grid *again;
    SF_TRY(new_grid(c, &again));
    sf_status status = trim_full(c, again, c->result);
    if (status == SF_OK) {
        int good = sf_grid_equal(again, c->result) && sfi_grid_within(c->result, c->room) &&
                   (c->must == NULL || sfi_grid_within(c->must, c->result));
        status = good ? SF_OK : SF_ERR_INTERNAL;
    }
    sf_grid_destroy(again);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Attempts
// ---------------------------------------------------------------------------------------------

// Try to keep all that can be kept in `room`, where that is more than what must stay.
static sf_status attempt_adding(call *c, const sf_grid *room, sfi_attempt *adding)
{
    const sfi_attempt no_attempt = {.plain_cost = SF_REPAIR_NO_COST};
    sf_grid *whole = NULL;
    SF_TRY(new_grid(c, &whole));
    sf_status status = SF_OK;
    for (uint32_t k = 0; status == SF_OK && k < c->ground.lattice.nz; k++) {
        status = sf_slice_and(sf_grid_slice(whole, k), sf_grid_slice(c->grid, k),
                              sf_grid_slice(room, k));
    }
    // What must stay may stand on bridges, of which the room knows nothing.
    int is_more =
        c->must == NULL || (sfi_grid_within(c->must, whole) && !sfi_grid_within(whole, c->must));
    if (status == SF_OK && is_more) {
        status = sfi_attempt_make(&c->quest, whole, &no_attempt, adding);
    }
    sf_grid_destroy(whole);
    return status;
}

// No dearer than what only adds: giving up early what is dear at first leaves the rounds in a
// valley that they do not climb out of. So all is tried for that too, to the end, and the call
// would have come to the same with `keep` the whole shape. With bridges what can be kept by them
// may be more. Shapes with very much in the air are spared that.
static sf_status attempt_all(call *c, const sfi_job *job)
{
    uint64_t hanging = sfi_job_hanging(job);
    if (c->options->rounds != SF_REPAIR_FIRST && hanging > 0 && hanging <= HANGING_MOST) {
        SF_TRY(attempt_adding(c, job->room, &c->attempts[0]));
        if (job->room != c->room && !sf_grid_equal(job->room, c->room)) {
            SF_TRY(attempt_adding(c, c->room, &c->attempts[1]));
        }
    }
    sfi_attempt *last = &c->attempts[2];
    SF_TRY(sfi_attempt_make(&c->quest, c->must, &c->attempts[0], last));
    for (int i = 0; i < 2; i++) {
        last->report.rounds += c->attempts[i].report.rounds;
    }
    c->report = last->report;
    return SF_OK;
}

// The result of each attempt on struts, where they are asked for, and the cheapest of all.
static sf_status choose(call *c, const sfi_job *job)
{
    uint64_t least = SF_REPAIR_NO_COST;
    uint32_t width = c->options->min_feature_vx;
    for (int i = ATTEMPTS; i-- > 0;) {
        sf_grid *result = sfi_attempt_result(&c->attempts[i]);
        sf_repair_report report = c->report;
        if (result == NULL) {
            continue;
        }
        if (width > 1) {
            SF_TRY(sfi_strut_widen(job, &c->terms, width, result,
                                   i == ATTEMPTS - 1 ? &c->report : &report));
        }
        uint64_t cost = sfi_job_bill(job, result).cost;
        if (cost < least) {
            least = cost;
            SF_TRY(sfi_grid_copy(c->result, result));
        }
    }
    return SF_OK;
}

static sf_status work(call *c)
{
    sfi_job job;
    SF_TRY(make_job(c, &job));
    c->quest = (sfi_quest){.job = &job,
                           .terms = &c->terms,
                           .room = c->room,
                           .rounds = c->options->rounds,
                           .is_grow_asked = c->options->min_feature_vx == 1};
    sf_status status = attempt_all(c, &job);
    job.scale = 1;
    status = status == SF_OK ? choose(c, &job) : status;
    sfi_quest_destroy(&c->quest);
    return status == SF_OK ? prove(c) : status;
}

// Everything up to the first write.
static sf_status solve(call *c, sf_grid *culprits)
{
    SF_TRY(find_sets(c));
    c->report.culprit_count = find_culprits(c, c->result);
    if (c->report.culprit_count == 0) {
        return work(c);
    }
    if (culprits != NULL) {
        (void)!sfi_grid_copy(culprits, c->result);
    }
    return SF_ERR_INFEASIBLE;
}

static void finish(call *c)
{
    sfi_job job = {.lattice = c->ground.lattice,
                   .scale = 1,
                   .add = c->options->add_cost,
                   .remove = c->options->remove_cost,
                   .drawn = c->grid};
    sfi_bill bill = sfi_job_bill(&job, c->result);
    c->report.added_voxels = bill.added;
    c->report.removed_voxels = bill.removed;
    c->report.cost = bill.cost;
    (void)!sfi_grid_copy(c->grid, c->result);
}

static void call_destroy(call *c)
{
    sf_grid_destroy(c->must);
    sf_grid_destroy(c->room);
    sf_grid_destroy(c->roots);
    sf_grid_destroy(c->result);
    sf_grid_destroy(c->plain_room);
    sf_grid_destroy(c->plain_exempt);
    for (int i = 0; i < ATTEMPTS; i++) {
        sfi_attempt_destroy(&c->attempts[i]);
    }
}

// ---------------------------------------------------------------------------------------------
// Arguments
// ---------------------------------------------------------------------------------------------

// Whether no cost is 0.
static int are_costs_good(const uint8_t *costs, const sf_lattice *lattice)
{
    size_t row = lattice->nx, rows = (size_t)lattice->ny * lattice->nz;
    for (size_t y = 0; costs != NULL && y < rows; y++) {
        uint8_t zeros = 0;
        for (size_t x = 0; x < row; x++) {
            zeros |= (uint8_t)(costs[y * row + x] == 0);
        }
        if (zeros) {
            return 0;
        }
    }
    return 1;
}

static sf_status check_arguments(const sf_grid *grid, const sf_repair_options *o,
                                 const sf_grid *culprits, sfi_ground *ground)
{
    if (grid == NULL || o == NULL || o->struct_size < sizeof *o || o->min_feature_vx < 1 ||
        o->min_feature_vx > SF_REACH_MAX) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_terms_check(&o->terms, grid, ground));
    const sf_grid *masks[4] = {o->terms.exempt, o->terms.keep, o->terms.forbid, o->terms.act};
    for (int i = 0; i < 4; i++) {
        if (masks[i] == grid || (masks[i] != NULL && masks[i] == culprits)) {
            return SF_ERR_ARGUMENT;
        }
    }
    if (culprits == grid || !are_costs_good(o->add_cost, &ground->lattice) ||
        !are_costs_good(o->remove_cost, &ground->lattice)) {
        return SF_ERR_ARGUMENT;
    }
    return culprits != NULL ? sfi_terms_match(&ground->lattice, culprits) : SF_OK;
}

sf_status sf_grid_repair(sf_grid *grid, const sf_repair_options *options,
                         const sf_allocator *allocator, sf_task *task, sf_grid *culprits,
                         sf_repair_report *report)
{
    meter m = {sfi_allocator_or_default(allocator), 0, 0};
    const sf_allocator metered = {meter_alloc, meter_free, &m};
    call c = {.grid = grid, .options = options, .allocator = &metered};
    sfi_pace_begin(&c.pace, task);
    SF_TRY(check_arguments(grid, options, culprits, &c.ground));
    c.terms = options->terms;
    c.terms.bed_layer = c.ground.bed;
    for (int i = 0; i < ATTEMPTS; i++) {
        c.attempts[i].plain_cost = SF_REPAIR_NO_COST;
    }
    sf_status status = solve(&c, culprits);
    if (status == SF_OK) {
        finish(&c);
        sfi_progress_report(&c.pace.whole, 1, 1);
    }
    call_destroy(&c);
    if (report != NULL && (status == SF_OK || status == SF_ERR_INFEASIBLE)) {
        c.report.peak_memory = m.peak;
        c.report.bed_layer = c.ground.bed < c.ground.lattice.nz ? c.ground.bed : SF_BED_AUTO;
        *report = c.report;
    }
    return status;
}
