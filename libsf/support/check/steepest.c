// SPDX-License-Identifier: MIT
// The steepest overhang of a shape: the least angle for which it is support-free.
//
// One layer alone cannot tell: on voxels every overhang is a stair, and a step of one voxel is 45
// degrees whether it comes in every layer or in every tenth. Slack adds the steps up, so the least
// angle under which slack finds nothing is the angle of the steepest chain that the shape cannot do
// without, over as many layers as it runs. Its cap is the one thing that it forgives: an overhang
// over a height H may be said flatter by cap / H in its tangent, and one that ends within the cap
// is none.
//
// Found by halving in tenths of a degree, with ten checks.

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/rule.h"
#include "support/rule/terms.h"

#define DEGREE_RAD 0.017453292519943295
#define LEAST_TENTHS 50u
#define MOST_TENTHS 850u
#define TRIALS_MAX 11 // one, and halvings of 800

// Room for a rule's table, and what a check at one angle says.
typedef struct trial {
    const sf_grid *grid;
    sfi_progress progress;
    uint32_t count; // of trials so far
    const sf_allocator *allocator;
    sf_check_options options;
    sf_lattice lattice;
    uint64_t *table;
    sf_finding first; // the lowest finding of the last trial that had one
} trial;

static sf_status try_angle(trial *t, uint32_t tenths, int *is_free)
{
    sf_finding finding;
    sfi_part part;
    double share = 1.0 / TRIALS_MAX;
    sfi_part_begin(&part, &t->progress, t->count * share, (t->count + 1) * share);
    t->count++;
    sf_check_report report;
    size_t count = 0;
    t->options.findings = &finding;
    t->options.finding_capacity = 1;
    t->options.run_capacity = 1; // its region is all that is asked for
    SF_TRY(sf_rule_make(SF_RULE_SLACK, tenths * 0.1 * DEGREE_RAD, &t->lattice, t->table,
                        &t->options.rule, NULL));
    SF_TRY(sf_grid_check(t->grid, &t->options, t->allocator, &part.task, &report, &count));
    *is_free = report.support_free;
    if (count > 0) {
        t->first = finding;
    }
    return SF_OK;
}

// The largest tenth of a degree, up to MOST_TENTHS, whose rule the lattice can be given.
static uint32_t largest_served(const trial *t)
{
    uint32_t low = LEAST_TENTHS, high = MOST_TENTHS + 1;
    while (high - low > 1) {
        uint32_t middle = (low + high) / 2;
        sf_rule rule;
        int served = sf_rule_make(SF_RULE_SLACK, middle * 0.1 * DEGREE_RAD, &t->lattice, t->table,
                                  &rule, NULL) == SF_OK;
        *(served ? &low : &high) = middle;
    }
    return low;
}

static sf_status search(trial *t, sf_steepest *found)
{
    uint32_t low = LEAST_TENTHS, high = largest_served(t);
    int is_free;
    SF_TRY(try_angle(t, high, &is_free));
    int is_bounded = is_free;
    while (is_bounded && low < high) {
        uint32_t middle = (low + high) / 2;
        SF_TRY(try_angle(t, middle, &is_free));
        *(is_free ? &high : &low) = is_free ? middle : middle + 1;
    }
    sfi_progress_report(&t->progress, 1, 1);
    sf_steepest result = {0.1 * DEGREE_RAD * high, is_bounded, t->first.layer, t->first.box};
    *found = result;
    return SF_OK;
}

sf_status sf_grid_steepest(const sf_grid *grid, uint32_t bed_layer, const sf_allocator *allocator,
                           sf_task *task, sf_steepest *steepest)
{
    if (grid == NULL || steepest == NULL) {
        return SF_ERR_ARGUMENT;
    }
    trial t = {.grid = grid, .allocator = allocator, .lattice = sf_grid_lattice(grid)};
    if (bed_layer != SF_BED_AUTO && bed_layer >= t.lattice.nz) {
        return SF_ERR_ARGUMENT;
    }
    t.options = sf_check_options_default();
    t.options.bed_layer = bed_layer;
    size_t count = sf_rule_table_count(&t.lattice);
    sf_allocator from = sfi_allocator_or_default(allocator);
    if (count > 0) {
        t.table = sfi_alloc_array(&from, count, sizeof *t.table);
        if (t.table == NULL) {
            return SF_ERR_MEMORY;
        }
    }
    t.progress = sfi_progress_begin(task);
    t.first.layer = SF_BED_AUTO;
    sf_status status = search(&t, steepest);
    if (t.table != NULL) {
        sfi_free_array(&from, t.table, count, sizeof *t.table);
    }
    return status;
}
