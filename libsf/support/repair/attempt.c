// SPDX-License-Identifier: MIT
// Attempt: everything that a repair tries for one set that must stay, and the cheapest of it.
//
// Rounds (improve.c) climb out of no valley, so what they come to depends on where they start; and
// no start is always the best. These are tried:
//
//   - the first result: trim, forests, under slack also a whole repair by steps that use up no
//     reach;
//   - what sf_grid_grow() makes: long pillars are shared in it, where a forest sees one layer;
//   - what another attempt has found, which keeps more.
//
// Not every start is worth its rounds. One that costs FAR times another has not been seen to lead
// to the cheaper end, and takes longest: a roof's first forest is a wood of straight pillars. Where
// very much hangs, rounds are long; so FAR is less there, and a second start has rounds only where
// it is cheaper as it stands than what the first one came to.
//
// Grow is asked once for all attempts, when the first result is known; where it is not asked is
// told in against_grow.c.

#include "support/repair/attempt.h"

#include "base/status.h"
#include "support/repair/against_grow.h"
#include "support/repair/bridged.h"
#include "support/repair/improve.h"
#include "support/rule/carry.h"
#include "voxel/grid.h"

#define FAR 16
#define FAR_OF_MANY 8
// Voxels in the air below which the dearer of two first results has rounds too.
#define HANGING_LITTLE 65536u

void sfi_quest_destroy(sfi_quest *q)
{
    sf_grid_destroy(q->careful_room);
    sf_grid_destroy(q->careful_exempt);
    sf_grid_destroy(q->grown);
}

void sfi_attempt_destroy(sfi_attempt *a)
{
    sf_grid_destroy(a->plain);
    sf_grid_destroy(a->dearer);
    sf_grid_destroy(a->bridged);
}

static int is_few(const sfi_job *job)
{
    return sfi_job_hanging(job) < SFI_HANGING_FEW;
}

// Whether a cost is far from another; either may be none.
static int is_far(const sfi_job *job, uint64_t cost, uint64_t other)
{
    return cost / (is_few(job) ? FAR : FAR_OF_MANY) > other;
}

static int has_bridges(const sfi_quest *q)
{
    return sfi_bridge_any(&q->terms->rule.bridge);
}

// ---------------------------------------------------------------------------------------------
// By the rule without bridges
// ---------------------------------------------------------------------------------------------

// Under slack, a result by steps that use up none, into *start, which stays NULL where there is
// none: for them there is more that improves one.
static sf_status start_carefully(sfi_quest *q, const sf_grid *must, sf_grid **start)
{
    sf_repair_report report = {0};
    if (q->job->rule.kind != SF_RULE_SLACK) {
        return SF_OK;
    }
    if (!q->has_careful) {
        q->careful = *q->job;
        SF_TRY(sfi_job_set_aside(&q->careful, sfi_careful_rule(q->job), &q->careful_room,
                                 &q->careful_exempt));
        q->has_careful = 1;
    }
    sfi_job careful = q->careful;
    careful.must = must;
    SF_TRY(sf_grid_create(&careful.lattice, careful.allocator, start));
    SF_TRY(sfi_improve(&careful, q->rounds, start, &report));
    if (report.cost == SF_REPAIR_NO_COST) {
        sf_grid_destroy(*start);
        *start = NULL;
    }
    return SF_OK;
}

// The first result; under slack it is one of two, and the dearer goes to *second, else NULL.
static sf_status start(sfi_quest *q, const sfi_job *job, sfi_attempt *a, sf_grid **second)
{
    *second = NULL;
    SF_TRY(start_carefully(q, job->must, second));
    SF_TRY(sfi_start(job, &a->plain, &a->report));
    uint64_t careful = *second != NULL ? sfi_job_bill(job, *second).cost : SF_REPAIR_NO_COST;
    if (careful < a->report.cost) {
        sf_grid *grid = a->plain;
        a->plain = *second;
        *second = grid;
        if (a->report.cost == SF_REPAIR_NO_COST) {
            sf_grid_destroy(grid);
            *second = NULL;
        }
        a->report.first_cost = a->report.cost = careful;
    }
    a->plain_cost = a->report.cost;
    return SF_OK;
}

static sf_status ask_grow(sfi_quest *q, uint64_t first)
{
    if (q->grown != NULL || !q->is_grow_asked || !sfi_is_grow_asked(q->job, first)) {
        return SF_OK;
    }
    SF_TRY(sfi_grow_rest(q->job, q->terms, q->room, &q->grown));
    q->grown_cost = sfi_job_bill(q->job, q->grown).cost;
    return SF_OK;
}

// Rounds from a result, which is the attempt's where they make it the cheapest.
static sf_status rounds_from(const sfi_quest *q, const sfi_job *job, const sf_grid *from,
                             sfi_attempt *a)
{
    sf_grid *trial = NULL;
    sf_repair_report report = {0};
    SF_TRY(sf_grid_clone(from, job->allocator, &trial));
    sf_status status = sfi_rounds(job, q->rounds, 0, &trial, &report);
    a->report.rounds += report.rounds;
    if (status == SF_OK && report.cost < a->plain_cost) {
        sf_grid *grid = a->plain;
        a->plain = trial;
        trial = grid;
        a->plain_cost = report.cost;
    }
    sf_grid_destroy(a->dearer);
    a->dearer = trial;
    return status;
}

// Whether the first result has rounds: not where another start is the better one by far, nor, with
// very much in the air, where it is no more than a trim and another is cheaper.
static int is_first_worth_it(const sfi_quest *q, const sfi_job *job, const sfi_attempt *before,
                             const sfi_attempt *a)
{
    uint64_t other = before->plain_cost;
    if (a->plain_cost == SF_REPAIR_NO_COST) {
        return 0;
    }
    if (q->grown != NULL && !has_bridges(q) && q->grown_cost < other) {
        other = q->grown_cost;
    }
    int is_trim = a->plain_cost == a->report.trim_cost && a->plain_cost > other;
    return !is_far(job, a->plain_cost, other) && (is_few(job) || !is_trim);
}

// Whether what grow makes has rounds. It may stand on bridges; then it has none here.
static int is_grown_worth_it(const sfi_quest *q, const sfi_job *job, const sfi_attempt *a)
{
    if (q->grown == NULL || has_bridges(q)) {
        return 0;
    }
    int has_reroutes = sfi_rule_is_element(&job->rule);
    return is_few(job) && has_reroutes ? !is_far(job, q->grown_cost, a->plain_cost)
                                       : q->grown_cost < a->plain_cost;
}

static sf_status rounds_from_given(const sfi_quest *q, const sfi_job *job, const sf_grid *given,
                                   sfi_attempt *a)
{
    if (given == NULL) {
        return SF_OK;
    }
    uint64_t cost = sfi_job_bill(job, given).cost;
    int is_worth = is_few(job) ? !is_far(job, cost, a->plain_cost) : cost < a->plain_cost;
    return is_worth ? rounds_from(q, job, given, a) : SF_OK;
}

// Rounds from all starts that are worth them; `second` is the dearer first result, or NULL.
static sf_status try_starts(sfi_quest *q, const sfi_job *job, const sfi_attempt *before,
                            const sf_grid *second, sfi_attempt *a)
{
    SF_TRY(ask_grow(q, a->plain_cost));
    if (is_first_worth_it(q, job, before, a)) {
        SF_TRY(sfi_rounds(job, q->rounds, 1, &a->plain, &a->report));
        a->plain_cost = a->report.cost;
    }
    if (sfi_job_hanging(job) < HANGING_LITTLE) {
        SF_TRY(rounds_from_given(q, job, second, a));
    }
    if (before->plain_cost == SF_REPAIR_NO_COST) {
        return is_grown_worth_it(q, job, a) ? rounds_from(q, job, q->grown, a) : SF_OK;
    }
    SF_TRY(rounds_from_given(q, job, before->plain, a));
    return rounds_from_given(q, job, before->dearer, a);
}

static sf_status make_plain(sfi_quest *q, const sfi_job *job, const sfi_attempt *before,
                            sfi_attempt *a)
{
    sf_grid *second;
    sf_status status = start(q, job, a, &second);
    if (status == SF_OK && q->rounds != SF_REPAIR_FIRST) {
        status = try_starts(q, job, before, second, a);
    }
    sf_grid_destroy(second);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Under the whole rule
// ---------------------------------------------------------------------------------------------

// What bridges gain on the result, and on what grow makes, where that is cheaper as it stands.
static sf_status make_bridged(const sfi_quest *q, const sfi_job *job, sfi_attempt *a)
{
    sf_repair_report report = {0};
    SF_TRY(sf_grid_clone(a->plain, job->allocator, &a->bridged));
    a->report.cost = a->plain_cost;
    SF_TRY(sfi_bridged_improve(job, q->terms, q->room, a->bridged, &a->report));
    if (q->grown == NULL ||
        sfi_job_bill(job, q->grown).cost >= sfi_job_bill(job, a->bridged).cost) {
        return SF_OK;
    }
    SF_TRY(sfi_grid_copy(a->bridged, q->grown));
    return sfi_bridged_improve(job, q->terms, q->room, a->bridged, &report);
}

sf_status sfi_attempt_make(sfi_quest *q, const sf_grid *must, const sfi_attempt *before,
                           sfi_attempt *attempt)
{
    sfi_job job = *q->job;
    *attempt = (sfi_attempt){.plain_cost = SF_REPAIR_NO_COST};
    job.must = must;
    SF_TRY(sf_grid_create(&job.lattice, job.allocator, &attempt->plain));
    SF_TRY(make_plain(q, &job, before, attempt));
    job.scale = 1;
    if (has_bridges(q) &&
        (q->rounds != SF_REPAIR_FIRST || attempt->plain_cost == SF_REPAIR_NO_COST)) {
        SF_TRY(make_bridged(q, &job, attempt));
    }
    return SF_OK;
}
