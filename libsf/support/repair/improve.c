// SPDX-License-Identifier: MIT
// Improve: from the cheapest start, rounds that can only make a repair cheaper.
//
// Starts are the trim, keeping everything along the forest, and the best along the forest; the last
// is never dearer than the other two. Under slack there are two forests, by label and by demand
// (neither is always better); the one by demand carries whatever can be carried at all, and so all
// that must stay.
//
// A round cleans up, then makes a new forest in which what the result R added is free. The trim of
// V and R is R after a cleanup, so the voxels of price 0 are just R's: each voxel of R finds its
// supporter in R, and R is a closed set of the new forest. The best of that forest can therefore
// not be dearer than R, and what R deleted may now hang on what R added. Two forests are tried,
// with and without preference for drawn supporters; rounds end when neither is cheaper.
//
// In the end the result can be held against a grow of one path after the other (in_turn.c), in
// shapes of less than a million voxels in the air.
//
// Rounds are made while one saves a part in 128 at least. Where more than a million voxels hang
// they also end when their forests have had 2^26 nodes together: a forest over a whole roof takes
// seconds.
//
// Further starts are entered in `starts` below; starts that a caller brings along have rounds of
// their own (attempt.c).

#include "support/repair/repair.h"

#include "base/status.h"
#include "support/repair/improve.h"
#include "support/rule/carry.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

// ---------------------------------------------------------------------------------------------
// Starts
// ---------------------------------------------------------------------------------------------

// The cheapest result yet, and one that is being tried.
typedef struct search {
    const sfi_job *job;
    sf_grid *best, *trial;
    uint64_t cost; // of best; SF_REPAIR_NO_COST while there is none
    uint64_t all;  // of keeping everything along the first forest
    int is_small;
    uint64_t nodes; // of all forests until now
    sfi_price price;
    sf_grid *free, *roots, *resting; // of a round
} search;

// A saving of one part in this many is worth another round.
#define WORTH 128

// Where very much hangs, nodes of all forests after which there is no further round; a few tens of
// millions take a second or two.
#define NODES_MOST (UINT64_C(1) << 26)

// Take the trial as the best where it is cheaper. Returns whether it was.
static int offer(search *s)
{
    uint64_t cost = sfi_job_bill(s->job, s->trial).cost;
    if (cost >= s->cost) {
        return 0;
    }
    sf_grid *grid = s->best;
    s->best = s->trial;
    s->trial = grid;
    s->cost = cost;
    return 1;
}

static sf_status start_with_trim(search *s)
{
    if (s->job->must != NULL && !sfi_grid_within(s->job->must, s->job->roots)) {
        return SF_OK;
    }
    SF_TRY(sfi_grid_copy(s->trial, s->job->roots));
    offer(s);
    return SF_OK;
}

static sf_status try_forest(search *s, const sfi_job *job, int prefer_drawn)
{
    sfi_forest forest = {prefer_drawn, 0, 0, 0};
    SF_TRY(sfi_forest_grow(job, &s->price, &forest, s->trial));
    s->nodes += forest.nodes;
    if (s->all == SF_REPAIR_NO_COST && forest.all != UINT64_MAX) {
        s->all = forest.all + sfi_job_cost_of_lost(job);
    }
    if (forest.is_feasible) {
        offer(s);
    }
    return SF_OK;
}

static sf_status try_forests(search *s)
{
    SF_TRY(try_forest(s, s->job, 1));
    if (s->job->rule.kind == SF_RULE_SLACK) {
        SF_TRY(sfi_price_by_demand(s->job, &s->price));
        SF_TRY(try_forest(s, s->job, 1));
    }
    return SF_OK;
}

static sf_status start_with_forests(search *s)
{
    sfi_price_terms terms = {s->job->room, s->job->drawn, s->job->drawn, s->job->roots};
    SF_TRY(sfi_price_make(s->job, &terms, &s->price));
    return try_forests(s);
}

// Each leaves the cheapest result that it knows, if it is cheaper than what is there.
static sf_status (*const starts[])(search *s) = {start_with_trim, start_with_forests};

// ---------------------------------------------------------------------------------------------
// Rounds
// ---------------------------------------------------------------------------------------------

static sf_status clean(search *s)
{
    SF_TRY(sfi_grid_copy(s->trial, s->best));
    SF_TRY(sfi_cleanup(s->job, s->trial));
    offer(s);
    return SF_OK;
}

// A new forest in which what the best result added is free.
static sf_status reforest(search *s, const sfi_job *job, int prefer_drawn)
{
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        SF_TRY(sf_slice_or(sf_grid_slice(s->free, k), sf_grid_slice(s->best, k),
                           sf_grid_slice(job->drawn, k)));
    }
    sfi_price_terms terms = {job->room, s->free, job->drawn, sfi_job_settled(job)};
    SF_TRY(sfi_price_make(job, &terms, &s->price));
    SF_TRY(try_forest(s, job, prefer_drawn));
    return SF_OK;
}

// roots = the drawn part of the best result, resting = what of it rests on it.
static sf_status find_resting(search *s)
{
    const sfi_job *job = s->job;
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        sf_slice roots = sf_grid_slice(s->roots, k), resting = sf_grid_slice(s->resting, k);
        SF_TRY(sf_slice_and(roots, sf_grid_slice(s->best, k), sf_grid_slice(job->drawn, k)));
        if (k <= job->bed) {
            SF_TRY(sf_slice_copy(resting, roots));
            continue;
        }
        sf_element element;
        SF_TRY(sf_rule_element(&job->rule, k - 1, &element));
        SF_TRY(sf_slice_and_dilate(resting, roots, sf_grid_slice(s->roots, k - 1), &element));
        for (uint32_t y = 0; job->exempt != NULL && y < job->lattice.ny; y++) {
            const uint64_t *exempt = sfi_slice_row(sf_grid_slice(job->exempt, k), y);
            for (size_t i = 0; i < sfi_row_words(job->lattice.nx); i++) {
                sfi_slice_row(resting, y)[i] |= exempt[i] & sfi_slice_row(roots, y)[i];
            }
        }
    }
    return SF_OK;
}

// Whether a saving is worth another round.
static int pays(uint64_t before, uint64_t after)
{
    return before - after > before / WORTH;
}

// Reroute branches while that pays.
static sf_status reroute(search *s)
{
    uint64_t before;
    do {
        before = s->cost;
        SF_TRY(sfi_grid_copy(s->trial, s->best));
        SF_TRY(sfi_reroute(s->job, s->trial));
        offer(s);
    } while (pays(before, s->cost));
    return SF_OK;
}

static sf_status light_round(search *s)
{
    SF_TRY(clean(s));
    SF_TRY(reroute(s));
    SF_TRY(find_resting(s));
    sfi_job job = *s->job;
    job.roots = s->roots;
    job.resting = s->resting;
    return reforest(s, &job, 0);
}

static sf_status whole_round(search *s)
{
    SF_TRY(clean(s));
    uint64_t cleaned = s->cost;
    SF_TRY(reforest(s, s->job, 1));
    // The slower choice has its turn where it is not slow. The prices are still those of the best.
    return s->cost == cleaned && s->is_small ? try_forest(s, s->job, 0) : SF_OK;
}

// Whether there were rounds enough, though each still paid.
static int is_long(const search *s)
{
    return !s->is_small && s->nodes > NODES_MOST;
}

static sf_status improve(search *s, uint32_t most, uint32_t *rounds)
{
    int is_light = sfi_rule_is_element(&s->job->rule);
    int is_better = 1;
    while (is_better && s->cost > 0) {
        uint64_t begun = s->cost, before;
        do {
            if ((most != 0 && *rounds >= most) || is_long(s)) {
                return clean(s);
            }
            before = s->cost;
            SF_TRY(is_light ? light_round(s) : whole_round(s));
            (*rounds)++;
        } while (pays(before, s->cost));
        if (is_light && (most == 0 || *rounds < most) && !is_long(s)) {
            before = s->cost;
            SF_TRY(whole_round(s));
            (*rounds)++;
        }
        is_better = is_light ? pays(before, s->cost) : pays(begun, s->cost);
    }
    return clean(s);
}

// A grow in turn is a good result and a poor start: what it drew together early stays so. So it is
// only asked for in the end, where it is quick, that no such grow be cheaper.
static sf_status compare_in_turn(search *s, uint32_t most, uint32_t *rounds)
{
    const sfi_job *job = s->job;
    if (!s->is_small || s->cost == 0 || !sfi_rule_is_element(&job->rule)) {
        return SF_OK;
    }
    // What the room has no place for is lost in either.
    uint64_t lost = sfi_job_cost_of_lost(job);
    if (s->cost <= lost) {
        return SF_OK;
    }
    int is_done;
    sfi_price_terms terms = {job->room, job->drawn, job->drawn, job->roots};
    SF_TRY(sfi_price_make(job, &terms, &s->price));
    SF_TRY(sfi_grow_in_turn(job, &s->price, s->cost - lost, s->trial, &is_done));
    return is_done && offer(s) ? improve(s, most, rounds) : SF_OK;
}

static void search_end(search *s, sf_grid **result, sf_repair_report *report)
{
    report->cost = s->cost;
    sfi_price_destroy(s->job, &s->price);
    sf_grid_destroy(s->free);
    sf_grid_destroy(s->roots);
    sf_grid_destroy(s->resting);
    sf_grid_destroy(s->trial);
    *result = s->best;
}

sf_status sfi_start(const sfi_job *job, sf_grid **result, sf_repair_report *report)
{
    search s = {.job = job, .best = *result, .cost = SF_REPAIR_NO_COST, .all = SF_REPAIR_NO_COST};
    report->trim_cost = report->grow_cost = report->first_cost = report->cost = SF_REPAIR_NO_COST;
    if (job->must != NULL && !sfi_grid_within(job->must, job->room)) {
        return SF_OK;
    }
    sf_status status = sf_grid_create(&job->lattice, job->allocator, &s.trial);
    for (size_t i = 0; status == SF_OK && i < sizeof starts / sizeof starts[0]; i++) {
        status = starts[i](&s);
        if (i == 0) {
            report->trim_cost = s.cost;
        }
    }
    report->first_cost = s.cost;
    report->grow_cost = s.all;
    search_end(&s, result, report);
    return status;
}

static sf_status rounds_from(search *s, uint32_t most, int is_in_turn, uint32_t *rounds)
{
    const sfi_job *job = s->job;
    SF_TRY(sf_grid_create(&job->lattice, job->allocator, &s->trial));
    SF_TRY(sf_grid_create(&job->lattice, job->allocator, &s->free));
    SF_TRY(sf_grid_create(&job->lattice, job->allocator, &s->roots));
    SF_TRY(sf_grid_create(&job->lattice, job->allocator, &s->resting));
    SF_TRY(improve(s, most, rounds));
    return is_in_turn ? compare_in_turn(s, most, rounds) : SF_OK;
}

sf_status sfi_rounds(const sfi_job *job, uint32_t rounds, int is_in_turn, sf_grid **result,
                     sf_repair_report *report)
{
    search s = {.job = job, .best = *result, .cost = sfi_job_bill(job, *result).cost};
    s.is_small = sfi_job_hanging(job) < SFI_HANGING_FEW;
    sf_status status = rounds_from(&s, rounds, is_in_turn, &report->rounds);
    search_end(&s, result, report);
    return status;
}

sf_status sfi_improve(const sfi_job *job, uint32_t rounds, sf_grid **result,
                      sf_repair_report *report)
{
    SF_TRY(sfi_start(job, result, report));
    return rounds == SF_REPAIR_FIRST || report->cost == SF_REPAIR_NO_COST
               ? SF_OK
               : sfi_rounds(job, rounds, 1, result, report);
}
