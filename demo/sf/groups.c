// SPDX-License-Identifier: MIT
// Findings that belong together: one that nothing else causes, and all that follow from it.
//
// A check names every region of every layer. A belly that grows outwards is a region in each of its
// layers, though a person sees one overhang; what lies above the first region touches nothing but
// matter that is lost already, so the check names the first as its cause. Following causes gives
// the overhangs that a person sees: in a model of a cow 981 findings come from 75 such places.
//
// On the stairs of a voxelised slope a rule finds places that lose a voxel or two, by rounding and
// not by design; they would drown the others. What loses at most --crumbs voxels is a crumb: summed
// up, not named. It is as unsupported as anything else, and shares and exit statuses include it.

#include "groups.h"

#include <stdlib.h>
#include <string.h>

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static uint32_t most(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

static void add(groups *g, size_t index, const sf_finding *finding, const sf_finding_cost *cost)
{
    sf_finding *head = &g->heads[index];
    sf_finding_cost *sum = &g->costs[index];
    head->area += finding->area;
    head->volume += finding->volume;
    sf_box both = {least(head->box.x0, finding->box.x0), least(head->box.y0, finding->box.y0),
                   least(head->box.z0, finding->box.z0), most(head->box.x1, finding->box.x1),
                   most(head->box.y1, finding->box.y1),  most(head->box.z1, finding->box.z1)};
    head->box = both;
    sum->trim_voxels += cost->trim_voxels;
    sum->grow_voxels = sum->grow_voxels == SF_COST_NONE || cost->grow_voxels == SF_COST_NONE
                           ? SF_COST_NONE
                           : sum->grow_voxels + cost->grow_voxels;
}

int groups_is_crumb(const groups *g, size_t index)
{
    return g->heads[index].volume <= g->crumb_most;
}

size_t groups_count(const groups *g, sf_finding_kind kind)
{
    size_t count = 0;
    for (size_t i = 0; i < g->count; i++) {
        count += g->heads[i].kind == kind;
    }
    return count - g->crumbs[kind];
}

static void count_crumbs(groups *g)
{
    for (size_t i = 0; i < g->count; i++) {
        if (groups_is_crumb(g, i)) {
            g->crumbs[g->heads[i].kind]++;
            g->crumb_voxels += g->heads[i].volume;
        }
    }
}

exit_status groups_make(cli_job *job, const sf_finding *findings, const sf_finding_cost *costs,
                        size_t count, groups *g)
{
    size_t places = count > 0 ? count : 1;
    memset(g, 0, sizeof *g);
    g->heads = malloc(places * sizeof *g->heads);
    g->costs = malloc(places * sizeof *g->costs);
    g->order = malloc(places * sizeof *g->order);
    uint32_t *of = malloc(places * sizeof *of); // the group of each finding
    if (g->heads == NULL || g->costs == NULL || g->order == NULL || of == NULL) {
        free(of);
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the findings.");
    }
    for (size_t i = 0; i < count; i++) {
        uint32_t cause = findings[i].cause; // an earlier one
        if (cause == SF_FINDING_ROOT) {
            of[i] = (uint32_t)g->count;
            g->heads[g->count] = findings[i];
            g->costs[g->count++] = costs[i];
        } else {
            of[i] = of[cause];
            add(g, of[i], &findings[i], &costs[i]);
        }
    }
    free(of);
    g->crumb_most = job->options.crumbs;
    count_crumbs(g);
    sf_status status = sf_findings_rank(g->heads, g->costs, g->count, g->order);
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, NULL, "the costs", EXIT_INPUT);
}

void groups_release(groups *g)
{
    free(g->heads);
    free(g->costs);
    free(g->order);
    memset(g, 0, sizeof *g);
}
