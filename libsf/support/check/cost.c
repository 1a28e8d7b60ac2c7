// SPDX-License-Identifier: MIT
// Costs: what each finding of a check takes to fix.
//
// A finding says where its region lies, not which voxels it is; so the layers are judged once more,
// as the check does it: what is not carried counts once, and what rests on it is judged as if it
// were (carry.h). The regions of a layer are met in the order in which the check numbered them, by
// last row and then from left to right in it. Regions that are not what the findings say are told
// apart by layer and area: then the findings are of another shape, or other terms.
//
// Why the sets of all findings together make the shape support-free: each voxel of a set stands on
// the bed, on another of the set or on matter as drawn; each region stands on its set; and what the
// check found carried, carried by matter as drawn, stays so, because every rule is monotone. From
// the bed up, all is alive.
//
// The price map (price_map.h) is made once, for all findings; what a finding costs is then found
// from its region down (supports.h).

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"
#include "support/check/supports.h"
#include "support/rule/carry.h"
#include "support/rule/terms.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

#include <sf/finding.h>

// One region of a layer: its runs are a list through next_run.
typedef struct region {
    uint32_t first_run, last_row;
    uint64_t area;
} region;

typedef struct costing {
    const sf_grid *grid;
    const sf_terms *terms;
    const sf_finding *findings;
    size_t finding_count, at; // at: the next finding to be met
    sf_finding_cost *costs;
    sf_allocator allocator;
    sf_lattice lattice;
    uint32_t bed, top; // layers from top on have no finding
    sf_task *task;
    sfi_carrier carrier;
    sfi_front below, front; // S as if it were carried; what of the layer is
    sfi_price_map prices;
    sfi_supports supports;
    sf_run *runs, *own; // of a layer; of one region
    uint32_t *next_run;
    region *regions;
    size_t run_capacity, own_capacity, next_capacity, region_capacity;
} costing;

// ---------------------------------------------------------------------------------------------
// Regions
// ---------------------------------------------------------------------------------------------

// front = what of layer k is carried by the layer below as drawn.
static sf_status judge_layer(costing *c, uint32_t k)
{
    sf_slice solid = sf_grid_slice(c->grid, k);
    if (k == c->bed) {
        return sfi_carry_bed(&c->carrier, solid, c->front);
    }
    if (k > 0) {
        return sfi_carry(&c->carrier, k, &c->below, solid, SFI_NO_SLICE, c->front, SFI_NO_SLICE);
    }
    sf_rect all = {0, 0, solid.width, solid.height};
    SF_TRY(sf_slice_fill(c->front.alive, all, 0));
    return sfi_carry_bed(&c->carrier, c->front.alive, c->front);
}

// The next layer rests on this one, whole.
static sf_status go_on(costing *c, uint32_t k)
{
    sfi_front swap = c->below;
    c->below = c->front;
    c->front = swap;
    return sfi_carry_anyway(&c->carrier, sf_grid_slice(c->grid, k), c->below);
}

static int grow(costing *c, void **memory, size_t *capacity, size_t need, size_t size)
{
    return sfi_grow_array(&c->allocator, memory, capacity, need, size);
}

// The regions of what nothing carries, which is in `hanging`.
static sf_status find_regions(costing *c, sf_slice hanging, size_t *run_count, uint32_t *count)
{
    size_t need;
    SF_TRY(sf_slice_run_count(hanging, &need));
    if (!grow(c, (void **)&c->runs, &c->run_capacity, need, sizeof *c->runs) ||
        !grow(c, (void **)&c->next_run, &c->next_capacity, need, sizeof *c->next_run)) {
        return SF_ERR_MEMORY;
    }
    SF_TRY(sf_slice_runs(hanging, c->runs, c->run_capacity, run_count));
    SF_TRY(sf_runs_label(c->runs, *run_count, SF_CONNECT_CORNERS, count));
    if (!grow(c, (void **)&c->regions, &c->region_capacity, *count, sizeof *c->regions)) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < *count; i++) {
        region none = {UINT32_MAX, 0, 0};
        c->regions[i] = none;
    }
    for (size_t i = *run_count; i-- > 0;) {
        region *r = &c->regions[c->runs[i].label];
        r->last_row = r->area == 0 ? c->runs[i].y : r->last_row;
        r->area += c->runs[i].x1 - c->runs[i].x0;
        c->next_run[i] = r->first_run;
        r->first_run = (uint32_t)i;
    }
    return SF_OK;
}

// What the next finding costs, which is this region.
static sf_status cost_region(costing *c, uint32_t k, const region *r)
{
    const sf_finding *finding = &c->findings[c->at];
    size_t count = 0;
    if (finding->layer != k || finding->area != r->area) {
        return SF_ERR_ARGUMENT;
    }
    for (uint32_t i = r->first_run; i != UINT32_MAX; i = c->next_run[i]) {
        if (!grow(c, (void **)&c->own, &c->own_capacity, count + 1, sizeof *c->own)) {
            return SF_ERR_MEMORY;
        }
        c->own[count++] = c->runs[i];
    }
    c->costs[c->at].trim_voxels = finding->volume;
    SF_TRY(sfi_supports_find(&c->supports, k, c->own, count, &c->costs[c->at].grow_voxels));
    c->at++;
    return SF_OK;
}

static sf_status cost_layer(costing *c, uint32_t k)
{
    size_t run_count;
    uint32_t region_count;
    SF_TRY(judge_layer(c, k));
    // The layer's own bits are in the grid, so the front's can go once they have been compared.
    SF_TRY(sf_slice_subtract(c->front.alive, sf_grid_slice(c->grid, k), c->front.alive));
    SF_TRY(find_regions(c, c->front.alive, &run_count, &region_count));
    for (size_t i = 0; i < run_count && c->at < c->finding_count; i++) {
        region *r = &c->regions[c->runs[i].label];
        if (r->area > 0 && c->runs[i].y == r->last_row) {
            SF_TRY(cost_region(c, k, r));
            r->area = 0; // done
        }
    }
    return go_on(c, k);
}

// ---------------------------------------------------------------------------------------------
// The call
// ---------------------------------------------------------------------------------------------

static sf_status prepare(costing *c, sf_grid *added)
{
    const sf_allocator *a = &c->allocator;
    const sf_rule *rule = &c->terms->rule;
    uint32_t nx = c->lattice.nx, ny = c->lattice.ny;
    SF_TRY(sfi_carrier_create(rule, nx, ny, a, &c->carrier));
    SF_TRY(sfi_front_create(rule, nx, ny, a, &c->below));
    SF_TRY(sfi_front_create(rule, nx, ny, a, &c->front));
    SF_TRY(sfi_price_map_create(c->grid, c->terms, c->bed, c->top > 0 ? c->top - 1 : 0, a, c->task,
                                &c->prices));
    return sfi_supports_create(&c->supports, rule, &c->prices, &c->lattice, a, added);
}

static sf_status cost_all(costing *c)
{
    sfi_progress progress = sfi_progress_begin(c->task);
    for (uint32_t k = 0; k < c->top; k++) {
        if (sf_task_is_cancelled(c->task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(cost_layer(c, k));
        sfi_progress_report(&progress, k + 1, c->top);
    }
    sfi_progress_report(&progress, 1, 1);
    return c->at == c->finding_count ? SF_OK : SF_ERR_ARGUMENT;
}

static void release(costing *c)
{
    const sf_allocator *a = &c->allocator;
    sfi_supports_destroy(&c->supports);
    sfi_price_map_destroy(&c->prices, a);
    sfi_front_destroy(&c->front, &c->terms->rule, a);
    sfi_front_destroy(&c->below, &c->terms->rule, a);
    sfi_carrier_destroy(&c->carrier, a);
    sfi_free_array(a, c->runs, c->run_capacity, sizeof *c->runs);
    sfi_free_array(a, c->own, c->own_capacity, sizeof *c->own);
    sfi_free_array(a, c->next_run, c->next_capacity, sizeof *c->next_run);
    sfi_free_array(a, c->regions, c->region_capacity, sizeof *c->regions);
}

static sf_status take_terms(costing *c, const sf_grid *added)
{
    sfi_ground ground;
    SF_TRY(sfi_terms_check(c->terms, c->grid, &ground));
    if ((c->findings == NULL || c->costs == NULL) && c->finding_count > 0) {
        return SF_ERR_ARGUMENT;
    }
    if (added != NULL) {
        const sf_terms *t = c->terms;
        if (added == c->grid || added == t->forbid || added == t->act || added == t->exempt ||
            added == t->keep) {
            return SF_ERR_ARGUMENT;
        }
        SF_TRY(sfi_terms_match(&ground.lattice, added));
    }
    c->lattice = ground.lattice;
    c->bed = ground.bed;
    if (c->finding_count > 0) {
        c->top = c->findings[c->finding_count - 1].layer + 1;
        return c->top <= ground.lattice.nz && c->top > 0 ? SF_OK : SF_ERR_ARGUMENT;
    }
    return SF_OK;
}

// Costs into c->costs, what is added into `drawn` or nowhere.
static sf_status find_costs(costing *c, sf_grid *drawn)
{
    sf_status status = prepare(c, drawn);
    if (status == SF_OK) {
        status = cost_all(c);
    }
    release(c);
    return status;
}

// An empty grid of the lattice, where one is asked for.
static sf_status make_drawn(const costing *c, const sf_grid *added, sf_grid **drawn)
{
    *drawn = NULL;
    return added != NULL ? sf_grid_create(&c->lattice, &c->allocator, drawn) : SF_OK;
}

static sf_status hand_over(const costing *c, sf_finding_cost *costs, const sf_grid *drawn,
                           sf_grid *added)
{
    for (size_t i = 0; i < c->finding_count; i++) {
        costs[i] = c->costs[i];
    }
    for (uint32_t k = 0; drawn != NULL && k < c->lattice.nz; k++) {
        SF_TRY(sf_slice_copy(sf_grid_slice(added, k), sf_grid_slice(drawn, k)));
    }
    return SF_OK;
}

sf_status sf_findings_cost(const sf_grid *grid, const sf_terms *terms, const sf_finding *findings,
                           size_t finding_count, const sf_allocator *allocator, sf_task *task,
                           sf_finding_cost *costs, sf_grid *added)
{
    costing c = {.grid = grid, .terms = terms, .findings = findings, .costs = costs};
    sf_grid *drawn;
    c.finding_count = finding_count;
    c.allocator = sfi_allocator_or_default(allocator);
    c.task = task;
    SF_TRY(take_terms(&c, added));
    SF_TRY(make_drawn(&c, added, &drawn));
    sf_status status = SF_OK;
    if (finding_count > 0) {
        c.costs = sfi_alloc_array(&c.allocator, finding_count, sizeof *costs);
        status = c.costs != NULL ? find_costs(&c, drawn) : SF_ERR_MEMORY;
    }
    if (status == SF_OK) {
        status = hand_over(&c, costs, drawn, added);
    }
    if (finding_count > 0) {
        sfi_free_array(&c.allocator, c.costs, finding_count, sizeof *costs);
    }
    sf_grid_destroy(drawn);
    return status;
}
