// SPDX-License-Identifier: MIT
// Planes: a layer with a border, so that whoever looks around a voxel needs to ask nothing first.
//
// The border is as wide as the rule's longest reach, and what is kept there never changes: no
// price, no node, no tally. A step to a voxel below is then one number to add.

#include "support/repair/repair.h"

#include "base/size.h"
#include "base/status.h"
#include "support/repair/price_row.h"
#include "support/rule/carry.h"

sf_status sfi_plane_make(const sfi_job *job, sfi_plane *plane)
{
    size_t rows, columns, count;
    plane->reach_x = job->reach_x;
    plane->reach_y = job->reach_y;
    if (!sfi_size_add(job->lattice.nx, (size_t)2 * job->reach_x, &columns) ||
        !sfi_size_add(job->lattice.ny, (size_t)2 * job->reach_y, &rows) ||
        !sfi_size_mul(columns, rows, &count) || count >= UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    plane->stride = columns;
    plane->count = count;
    return SF_OK;
}

size_t sfi_steps_most(const sfi_job *job)
{
    return ((size_t)2 * job->reach_x + 1) * ((size_t)2 * job->reach_y + 1);
}

static uint32_t distance(const sfi_step *s)
{
    return (uint32_t)(s->dx * s->dx + s->dy * s->dy);
}

// Nearest first, in an order that depends on nothing but the element.
static void sort_steps(sfi_step *steps, size_t count)
{
    for (size_t gap = count / 2; gap > 0; gap /= 2) {
        for (size_t i = gap; i < count; i++) {
            sfi_step step = steps[i];
            size_t j = i;
            for (; j >= gap && distance(&steps[j - gap]) > distance(&step); j -= gap) {
                steps[j] = steps[j - gap];
            }
            steps[j] = step;
        }
    }
}

size_t sfi_steps_of(const sfi_job *job, const sfi_plane *plane, uint32_t below, sfi_step *steps)
{
    sf_element e = {0, {0}};
    size_t count = 0;
    // The rule was found to serve all steps of the lattice.
    if (sf_rule_element(&job->rule, below, &e) != SF_OK) {
        return 0;
    }
    for (int32_t dy = -(int32_t)e.reach_y; dy <= (int32_t)e.reach_y; dy++) {
        uint32_t ay = (uint32_t)(dy < 0 ? -dy : dy);
        int32_t w = e.half_width[ay];
        for (int32_t dx = -w; dx <= w; dx++) {
            uint32_t ax = (uint32_t)(dx < 0 ? -dx : dx);
            ptrdiff_t offset = (ptrdiff_t)dy * (ptrdiff_t)plane->stride + dx;
            int is_slack = job->rule.kind == SF_RULE_SLACK;
            uint32_t cost = is_slack ? sfi_slack_cost(&job->rule, ax, ay) : 0;
            sfi_step step = {offset, (int16_t)dx, (int16_t)dy, cost};
            steps[count++] = step;
        }
    }
    sort_steps(steps, count);
    return count;
}
