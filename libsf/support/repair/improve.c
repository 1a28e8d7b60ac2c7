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
// In the end the result is held against a grow of one path after the other (in_turn.c), in shapes
// of less than a million voxels in the air.
//
// Further starts are entered in `starts` below.

#include "support/repair/repair.h"

#include "base/status.h"
#include "support/check/row.h"
#include "support/repair/improve.h"
#include "support/rule/carry.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

// ---------------------------------------------------------------------------------------------
// What a result costs
// ---------------------------------------------------------------------------------------------

static uint64_t sum_costs(const uint8_t *costs, const uint64_t *bits, size_t words)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < words; i++) {
        for (uint64_t w = bits[i]; w != 0; w &= w - 1) {
            sum += costs == NULL ? 1 : costs[i * 64 + sfi_lowest_bit(w)];
        }
    }
    return sum;
}

// Voxels of row a without those of row b: their number is added to count, their costs to
// cost. Bits past the width have none: what the caller drew may hold some.
static void bill_row(const uint8_t *costs, const uint64_t *a, const uint64_t *b, uint32_t width,
                     uint64_t *count, uint64_t *cost)
{
    uint64_t rest[SFI_ROW_WORDS_MAX];
    size_t words = sfi_row_words(width);
    const sfi_kernels *kernels = sfi_kernels_get();
    kernels->subtract_words(rest, a, b, words);
    rest[words - 1] &= sfi_tail_mask(width);
    uint64_t number = kernels->popcount(rest, words);
    *count += number;
    *cost += costs == NULL || number == 0 ? number : sum_costs(costs, rest, words);
}

sfi_bill sfi_job_bill(const sfi_job *job, const sf_grid *result)
{
    sfi_bill bill = {0, 0, 0};
    uint32_t nx = job->lattice.nx, ny = job->lattice.ny;
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        sf_slice is = sf_grid_slice(result, k), was = sf_grid_slice(job->drawn, k);
        for (uint32_t y = 0; y < ny; y++) {
            size_t at = ((size_t)k * ny + y) * nx;
            const uint64_t *now = sfi_slice_row(is, y), *then = sfi_slice_row(was, y);
            const uint8_t *add = job->add != NULL ? job->add + at : NULL;
            const uint8_t *remove = job->remove != NULL ? job->remove + at : NULL;
            uint64_t cost = 0;
            bill_row(add, now, then, nx, &bill.added, &cost);
            bill.cost += cost * job->scale;
            bill_row(remove, then, now, nx, &bill.removed, &bill.cost);
        }
    }
    return bill;
}

// What giving up costs that the room has no place for, whatever is done.
static uint64_t cost_of_lost(const sfi_job *job)
{
    uint64_t count = 0, cost = 0;
    uint32_t nx = job->lattice.nx, ny = job->lattice.ny;
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        sf_slice drawn = sf_grid_slice(job->drawn, k), room = sf_grid_slice(job->room, k);
        for (uint32_t y = 0; y < ny; y++) {
            const uint8_t *remove =
                job->remove != NULL ? job->remove + ((size_t)k * ny + y) * nx : NULL;
            bill_row(remove, sfi_slice_row(drawn, y), sfi_slice_row(room, y), nx, &count, &cost);
        }
    }
    return cost;
}

// ---------------------------------------------------------------------------------------------
// Starts
// ---------------------------------------------------------------------------------------------

// The cheapest result yet, and one that is being tried.
typedef struct search {
    const sfi_job *job;
    const sf_grid *given; // a result to start from, or NULL
    sf_grid *best, *trial;
    uint64_t cost; // of best; SF_REPAIR_NO_COST while there is none
    uint64_t all;  // of keeping everything along the first forest
    int is_small;
    sfi_price price;
    sf_grid *free, *roots, *resting; // of a round
} search;

// A saving of one part in this many is worth another round.
#define WORTH 128

// Drawn voxels that do not stand by themselves, up to which every forest is tried.
#define SMALL 1000000u

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
    sfi_forest forest = {prefer_drawn, 0, 0};
    SF_TRY(sfi_forest_grow(job, &s->price, &forest, s->trial));
    if (s->all == SF_REPAIR_NO_COST && forest.all != UINT64_MAX) {
        s->all = forest.all + cost_of_lost(job);
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

static sf_status start_with_given(search *s)
{
    if (s->given == NULL) {
        return SF_OK;
    }
    SF_TRY(sfi_grid_copy(s->trial, s->given));
    offer(s);
    return SF_OK;
}

// Each leaves the cheapest result that it knows, if it is cheaper than what is there.
static sf_status (*const starts[])(search *s) = {start_with_trim, start_with_forests,
                                                 start_with_given};

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
    // The slower choice has its turn where it is not slow.
    if (s->cost == cleaned && s->is_small) {
        SF_TRY(reforest(s, s->job, 0));
    }
    return SF_OK;
}

static sf_status improve(search *s, uint32_t most, uint32_t *rounds)
{
    int is_light = sfi_rule_is_element(&s->job->rule);
    int is_better = 1;
    while (is_better && s->cost > 0) {
        uint64_t begun = s->cost, before;
        do {
            if (most != 0 && *rounds >= most) {
                return clean(s);
            }
            before = s->cost;
            SF_TRY(is_light ? light_round(s) : whole_round(s));
            (*rounds)++;
        } while (pays(before, s->cost));
        if (is_light && (most == 0 || *rounds < most)) {
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
    uint64_t lost = cost_of_lost(job);
    if (s->cost <= lost) {
        return SF_OK;
    }
    int is_done;
    sfi_price_terms terms = {job->room, job->drawn, job->drawn, job->roots};
    SF_TRY(sfi_price_make(job, &terms, &s->price));
    SF_TRY(sfi_grow_in_turn(job, &s->price, s->cost - lost, s->trial, &is_done));
    return is_done && offer(s) ? improve(s, most, rounds) : SF_OK;
}

static sf_status improve_from(search *s, uint32_t most, uint32_t *rounds)
{
    const sfi_job *job = s->job;
    uint64_t hanging = sf_grid_popcount(job->drawn) - sf_grid_popcount(job->roots);
    s->is_small = hanging < SMALL;
    SF_TRY(sf_grid_create(&job->lattice, job->allocator, &s->free));
    SF_TRY(sf_grid_create(&job->lattice, job->allocator, &s->roots));
    SF_TRY(sf_grid_create(&job->lattice, job->allocator, &s->resting));
    SF_TRY(improve(s, most, rounds));
    return compare_in_turn(s, most, rounds);
}

sf_status sfi_improve(const sfi_job *job, const sf_grid *given, uint32_t rounds, sf_grid **result,
                      sf_repair_report *report)
{
    search s = {.job = job,
                .given = given,
                .best = *result,
                .cost = SF_REPAIR_NO_COST,
                .all = SF_REPAIR_NO_COST};
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
    if (status == SF_OK && rounds != SF_REPAIR_FIRST && s.cost != SF_REPAIR_NO_COST) {
        status = improve_from(&s, rounds, &report->rounds);
    }
    report->cost = s.cost;
    sfi_price_destroy(job, &s.price);
    sf_grid_destroy(s.free);
    sf_grid_destroy(s.roots);
    sf_grid_destroy(s.resting);
    sf_grid_destroy(s.trial);
    *result = s.best;
    return status;
}
