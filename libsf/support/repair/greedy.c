// SPDX-License-Identifier: MIT
// Greedy choice: which voxels below carry the nodes of a layer, few of them and all the cheapest.
//
// Each node v may rest on any u below it in the room, and only those of the least price are asked
// (under slack: of those with slack enough). That alone fixes what a node costs; which of the tied
// ones are taken fixes how much is shared, and decides the quality of the whole repair: always the
// place that carries most nodes that still wait, until none waits. Set cover by the greedy rule is
// within 1 + 1/2 + ... + 1/|N| of the least number of supporters; taking any tied one is not.
//
// With prefer_drawn, a node that can rest on drawn matter at no higher price does, on the nearest:
// that matter is a node of the forest anyway, and costs nothing to keep. It is also what makes
// large solids cheap, where nearly every voxel rests on the one below it.
//
// Places are kept in lists by tally. A tally only falls, so a place found in a list too high is
// moved down when it comes up; each place is moved at most as often as its tally has values.
// Order decides ties: places in the order in which the nodes found them.
//
// Source: greedy set cover, V. Chvatal, "A Greedy Heuristic for the Set-Covering Problem", 1979.

#include "support/repair/forest.h"

#include "base/memory.h"
#include "base/status.h"
#include "support/rule/carry.h"

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

sf_status sfi_chooser_create(const sfi_job *job, int prefer_drawn, sfi_chooser *c)
{
    const sf_allocator *a = job->allocator;
    *c = (sfi_chooser){.job = job, .prefer_drawn = prefer_drawn};
    SF_TRY(sfi_plane_make(job, &c->plane));
    size_t count = c->plane.count;
    c->steps_most = sfi_steps_most(job);
    c->prices = sfi_alloc_array(a, count, sizeof *c->prices);
    c->slot = sfi_alloc_array(a, count, sizeof *c->slot);
    c->due = sfi_alloc_array(a, count, sizeof *c->due);
    c->tally = sfi_alloc_array(a, count, sizeof *c->tally);
    c->steps = sfi_alloc_array(a, c->steps_most, sizeof *c->steps);
    c->heads = sfi_alloc_array(a, c->steps_most + 1, sizeof *c->heads);
    int is_slack = job->rule.kind == SF_RULE_SLACK;
    c->codes = is_slack ? sfi_alloc_array(a, count, 1) : NULL;
    c->roots = is_slack ? sfi_alloc_array(a, count, 1) : NULL;
    if (c->prices == NULL || c->slot == NULL || c->due == NULL || c->tally == NULL ||
        c->steps == NULL || c->heads == NULL ||
        (is_slack && (c->codes == NULL || c->roots == NULL))) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        c->prices[i] = SFI_PRICE_NONE;
        c->slot[i] = c->due[i] = c->tally[i] = 0;
    }
    for (size_t i = 0; is_slack && i < count; i++) {
        c->codes[i] = c->roots[i] = 0;
    }
    return SF_OK;
}

void sfi_chooser_destroy(sfi_chooser *c)
{
    if (c->job == NULL) {
        return;
    }
    const sf_allocator *a = c->job->allocator;
    size_t count = c->plane.count;
    sfi_free_array(a, c->prices, count, sizeof *c->prices);
    sfi_free_array(a, c->codes, count, 1);
    sfi_free_array(a, c->roots, count, 1);
    sfi_free_array(a, c->slot, count, sizeof *c->slot);
    sfi_free_array(a, c->due, count, sizeof *c->due);
    sfi_free_array(a, c->tally, count, sizeof *c->tally);
    sfi_free_array(a, c->steps, c->steps_most, sizeof *c->steps);
    sfi_free_array(a, c->heads, c->steps_most + 1, sizeof *c->heads);
    sfi_free_array(a, c->candidates, c->candidate_capacity, sizeof *c->candidates);
    *c = (sfi_chooser){0};
}

void sfi_chooser_load(sfi_chooser *c, const sfi_price *price, uint32_t below)
{
    sf_rect r = price->rects[below];
    c->step_count = sfi_steps_of(c->job, &c->plane, below, c->steps);
    for (uint32_t y = r.y0; y < r.y1; y++) {
        size_t at = sfi_plane_at(&c->plane, 0, y);
        const int16_t *row = sfi_price_row(price, below, y);
        for (uint32_t x = r.x0; x < r.x1; x++) {
            c->prices[at + x] = row[x];
        }
        if (c->codes != NULL) {
            const uint8_t *codes = sfi_price_codes(price, price->codes, below, y);
            const uint8_t *roots = sfi_price_codes(price, price->root_codes, below, y);
            for (uint32_t x = r.x0; x < r.x1; x++) {
                c->codes[at + x] = codes[x];
                c->roots[at + x] = roots[x];
            }
        }
    }
    c->gain = c->codes != NULL ? sfi_slack_gain(&c->job->rule, below) : 0;
}

static sf_status add_candidate(sfi_chooser *c, uint32_t place)
{
    void *memory = c->candidates;
    int good = sfi_grow_array(c->job->allocator, &memory, &c->candidate_capacity,
                              c->candidate_count + 1, sizeof *c->candidates);
    c->candidates = memory;
    if (!good) {
        return SF_ERR_MEMORY;
    }
    c->candidates[c->candidate_count++].place = place;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The choice
// ---------------------------------------------------------------------------------------------

// Whether a place can carry a node with this demand, over this step.
static inline int is_able(const sfi_chooser *c, uint32_t demand, const sfi_step *step, size_t place)
{
    return c->codes == NULL || c->codes[place] > sfi_step_demand(c, demand, step);
}

static inline int is_drawn(const sfi_chooser *c, const sfi_layer *low, size_t place)
{
    return c->slot[place] - 1u < low->drawn; // 0 - 1 is more than any number of nodes
}

// Whether a place is among those that a node may rest on.
static inline int suits(const sfi_chooser *c, const sfi_node *node, const sfi_step *step,
                        size_t place)
{
    return c->prices[place] == node->least && is_able(c, node->demand, step, place);
}

// Let a node rest on node `index` of the layer below.
static inline void rest(const sfi_chooser *c, sfi_node *node, sfi_node *below, uint32_t index,
                        const sfi_step *step)
{
    uint32_t demand = c->codes != NULL ? sfi_step_demand(c, node->demand, step) : 0;
    below->demand = demand > below->demand ? (uint8_t)demand : below->demand;
    node->next = SFI_NEXT_NODE + index;
}

// The least price that a node can rest on.
static int16_t find_least(const sfi_chooser *c, const sfi_node *node)
{
    int16_t least = SFI_PRICE_NONE;
    for (size_t s = 0; s < c->step_count; s++) {
        size_t place = (size_t)((ptrdiff_t)node->at + c->steps[s].offset);
        if (c->prices[place] < least && is_able(c, node->demand, &c->steps[s], place)) {
            least = c->prices[place];
        }
    }
    return least;
}

// Let a node rest on the drawn voxel straight below it, if that is free and able: nothing is
// cheaper or nearer. Returns whether it was. Most of a large solid is settled so, without a look
// around.
static int rest_straight_down(const sfi_chooser *c, sfi_node *node, sfi_layer *low)
{
    size_t place = (size_t)((ptrdiff_t)node->at + c->steps[0].offset);
    if (c->prices[place] != SFI_PRICE_FREE || !is_drawn(c, low, place) ||
        !is_able(c, node->demand, &c->steps[0], place)) {
        return 0;
    }
    uint32_t index = c->slot[place] - 1;
    rest(c, node, &low->nodes[index], index, &c->steps[0]);
    return 1;
}

// Let a node rest on drawn matter of the least price, the nearest. Returns whether there is any.
static int rest_on_drawn(const sfi_chooser *c, sfi_node *node, sfi_layer *low)
{
    for (size_t s = 0; s < c->step_count; s++) {
        size_t place = (size_t)((ptrdiff_t)node->at + c->steps[s].offset);
        if (c->prices[place] == node->least && is_drawn(c, low, place) &&
            is_able(c, node->demand, &c->steps[s], place)) {
            uint32_t index = c->slot[place] - 1;
            rest(c, node, &low->nodes[index], index, &c->steps[s]);
            return 1;
        }
    }
    return 0;
}

// Let node i wait, and count it at all places that it may rest on.
static sf_status enter(sfi_chooser *c, const sfi_node *node, uint32_t i)
{
    c->due[node->at] = i + 1;
    for (size_t s = 0; s < c->step_count; s++) {
        size_t place = (size_t)((ptrdiff_t)node->at + c->steps[s].offset);
        if (suits(c, node, &c->steps[s], place) && c->tally[place]++ == 0) {
            SF_TRY(add_candidate(c, (uint32_t)place));
        }
    }
    return SF_OK;
}

static void leave(sfi_chooser *c, const sfi_node *node)
{
    c->due[node->at] = 0;
    for (size_t s = 0; s < c->step_count; s++) {
        size_t place = (size_t)((ptrdiff_t)node->at + c->steps[s].offset);
        c->tally[place] -= (uint32_t)suits(c, node, &c->steps[s], place);
    }
}

// The node at a place below, made if there is none. Returns its index.
static sf_status node_at(sfi_chooser *c, sfi_layer *low, uint32_t place, uint64_t *all,
                         uint32_t *index)
{
    if (c->slot[place] == 0) {
        uint32_t y = (uint32_t)(place / c->plane.stride) - c->plane.reach_y;
        uint32_t x = (uint32_t)(place % c->plane.stride) - c->plane.reach_x;
        int is_free = sf_slice_get(sf_grid_slice(c->job->drawn, low->k), x, y);
        uint32_t cost = is_free ? 0 : sfi_job_add(c->job, low->k, x, y);
        SF_TRY(sfi_layer_add(c->job, low, place, -(int64_t)cost, SFI_PRICE_NONE, 0));
        c->slot[place] = low->count;
        *all += cost;
    }
    *index = c->slot[place] - 1;
    return SF_OK;
}

// Let a place carry all that wait for it.
static sf_status take(sfi_chooser *c, sfi_layer *here, sfi_layer *low, uint32_t place,
                      uint64_t *all)
{
    uint32_t index;
    SF_TRY(node_at(c, low, place, all, &index));
    sfi_node *below = &low->nodes[index];
    for (size_t s = 0; s < c->step_count; s++) {
        uint32_t i = c->due[(size_t)((ptrdiff_t)place - c->steps[s].offset)] - 1u;
        if (i == UINT32_MAX || !suits(c, &here->nodes[i], &c->steps[s], place)) {
            continue;
        }
        rest(c, &here->nodes[i], below, index, &c->steps[s]);
        leave(c, &here->nodes[i]);
    }
    return SF_OK;
}

static void push(sfi_chooser *c, uint32_t candidate)
{
    uint32_t tally = c->tally[c->candidates[candidate].place];
    c->candidates[candidate].link = c->heads[tally];
    c->heads[tally] = candidate + 1;
}

static sf_status choose_by_tally(sfi_chooser *c, sfi_layer *here, sfi_layer *low, uint64_t *all)
{
    for (size_t t = 0; t <= c->step_count; t++) {
        c->heads[t] = 0;
    }
    for (size_t i = c->candidate_count; i-- > 0;) {
        push(c, (uint32_t)i);
    }
    for (size_t t = c->step_count; t > 0; t--) {
        while (c->heads[t] != 0) {
            uint32_t candidate = c->heads[t] - 1, place = c->candidates[candidate].place;
            c->heads[t] = c->candidates[candidate].link;
            if (c->tally[place] == t) {
                SF_TRY(take(c, here, low, place, all));
            } else if (c->tally[place] > 0) {
                push(c, candidate);
            }
        }
    }
    return SF_OK;
}

sf_status sfi_choose(sfi_chooser *c, sfi_layer *here, sfi_layer *low, uint64_t *all)
{
    for (uint32_t i = 0; i < low->count; i++) {
        c->slot[low->nodes[i].at] = i + 1;
    }
    c->candidate_count = 0;
    for (uint32_t i = 0; i < here->count; i++) {
        sfi_node *node = &here->nodes[i];
        if (node->next != SFI_NEXT_WANTED ||
            (c->prefer_drawn && rest_straight_down(c, node, low))) {
            continue;
        }
        if (node->least == SFI_PRICE_NONE) {
            node->least = find_least(c, node);
        }
        if (node->least == SFI_PRICE_NONE) {
            node->next = SFI_NEXT_NONE;
        } else if (!c->prefer_drawn || !rest_on_drawn(c, node, low)) {
            SF_TRY(enter(c, node, i));
        }
    }
    SF_TRY(choose_by_tally(c, here, low, all));
    for (uint32_t i = 0; i < low->count; i++) {
        c->slot[low->nodes[i].at] = 0;
    }
    return SF_OK;
}
