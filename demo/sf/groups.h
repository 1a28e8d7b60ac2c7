// SPDX-License-Identifier: MIT
// Findings that belong together: one that nothing else causes, and all that follow from it.

#ifndef DEMO_SF_GROUPS_H
#define DEMO_SF_GROUPS_H

#include "job.h"

#include <sf/finding.h>

// Groups, each as a finding that stands for all of its own: the kind and the layer of the first,
// the box around all, areas and volumes added up; and so the costs.
typedef struct groups {
    sf_finding *heads;
    sf_finding_cost *costs;
    uint32_t *order; // the dearest first
    size_t count;
    uint32_t crumb_most;   // in voxels
    size_t crumbs[2];      // groups that lose no more, by kind
    uint64_t crumb_voxels; // what these lose
} groups;

// Group findings of a check, in its order, with their costs.
exit_status groups_make(cli_job *job, const sf_finding *findings, const sf_finding_cost *costs,
                        size_t count, groups *g);

// Whether a group loses so little that it is only counted.
int groups_is_crumb(const groups *g, size_t index);

// How many groups of a kind are no crumbs.
size_t groups_count(const groups *g, sf_finding_kind kind);

void groups_release(groups *g);

#endif
