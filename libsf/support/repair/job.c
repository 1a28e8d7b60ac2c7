// SPDX-License-Identifier: MIT
// Job: one repair under one rule, and how it comes to work under another.
//
// Rules with bridges, and slack where steps may use it up, are too rich for some of what a repair
// does. A job under a weaker rule counts the roots as exempt: they stand under the whole rule, and
// what is added stands on them by the weaker one. As rules are monotone, what comes out stands
// under the whole rule too.

#include "support/repair/repair.h"

#include "base/status.h"
#include "support/repair/price_row.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

sf_terms sfi_job_terms(const sfi_job *job)
{
    sf_terms terms = sf_terms_default();
    terms.rule = job->rule;
    terms.bed_layer = job->bed;
    terms.exempt = job->exempt;
    return terms;
}

sf_status sfi_job_find_reach(sfi_job *job)
{
    job->reach_x = job->reach_y = 0;
    for (uint32_t k = 0; k + 1 < job->lattice.nz; k++) {
        sf_element e = {0, {0}};
        SF_TRY(sf_rule_element(&job->rule, k, &e));
        uint32_t x = sfi_element_reach_x(&e);
        job->reach_x = job->reach_x > x ? job->reach_x : x;
        job->reach_y = job->reach_y > e.reach_y ? job->reach_y : e.reach_y;
    }
    return SF_OK;
}

sf_status sfi_job_set_aside(sfi_job *job, sf_rule rule, sf_grid **room, sf_grid **exempt)
{
    const sf_grid *given = job->exempt;
    SF_TRY(sf_grid_create(&job->lattice, job->allocator, room));
    SF_TRY(sf_grid_create(&job->lattice, job->allocator, exempt));
    SF_TRY(sfi_grid_copy(*exempt, job->roots));
    for (uint32_t k = 0; given != NULL && k < job->lattice.nz; k++) {
        sf_slice out = sf_grid_slice(*exempt, k);
        SF_TRY(sf_slice_or(out, out, sf_grid_slice(given, k)));
    }
    const sf_grid *allowed = job->room;
    job->rule = rule;
    job->exempt = *exempt;
    job->room = *room;
    SF_TRY(sfi_job_find_reach(job));
    sf_terms terms = sfi_job_terms(job);
    return sfi_trim_into(*room, allowed, &terms, job->bed, job->allocator,
                         sfi_pace_next(job->pace));
}
