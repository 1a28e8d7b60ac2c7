// SPDX-License-Identifier: MIT
// Forest: the best repair among those that rest on one supporter each.
//
// Fix for each voxel v that cannot stay by itself one voxel next(v) below that is to carry it. What
// is kept is then a set that with v holds next(v), and among all such sets the cheapest is found
// exactly: from the top down,
//
//     profit(v) = remove(v) - add(v) + sum over those that rest on v of max(0, profit)
//
// is what having v saves, all told (remove(v) where it is drawn, add(v) where it is not); from the
// bottom up, v is kept when its profit is positive and next(v) is kept. A voxel that must stay
// makes everything below it stay.
//
// Roots T are drawn and stand by themselves, and end each chain at no cost. So the result is never
// worse than T alone, which is a closed set, nor than keeping everything drawn along the same
// forest, which is another.
//
// A job may also take for roots what stands only with additions: then the roots that rest on no
// root are nodes that must stay, and the forest looks for what carries them and for nothing else.
//
// Nothing is stored for voxels that are never asked: nodes are the drawn voxels outside T, and the
// supporters that were chosen for them. The choice (greedy.c) goes from the top down, where a layer
// knows all that it has to carry; profits go along, so that all that is left of a node is eight
// bytes: where it is, and where it leads.
//
// Under slack a node also carries a demand, the slack that it must have for what rests on it; it
// may rest on what has that and what the step costs. A demand that each layer meets for the next is
// a proof that the result stands, because the rule is monotone (carry.c).
//
// Source: closed sets of least cost are J.-C. Picard's (Management Science 22, 1976), who needs
// flows for them; on a forest two sweeps do.

#include "support/repair/forest.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "support/check/row.h"
#include "support/rule/carry.h"
#include "voxel/slice.h"

#define NODES_MOST 0x7ffffff0u

sf_status sfi_layer_add(const sfi_job *job, sfi_layer *layer, uint32_t at, int64_t profit,
                        int16_t least, int forced)
{
    void *memory = layer->nodes;
    if (layer->count >= NODES_MOST) {
        return SF_ERR_OVERFLOW;
    }
    int good = sfi_grow_array(job->allocator, &memory, &layer->capacity, (size_t)layer->count + 1,
                              sizeof *layer->nodes);
    layer->nodes = memory;
    if (!good) {
        return SF_ERR_MEMORY;
    }
    sfi_node node = {profit, at, SFI_NEXT_WANTED, least, 0, (uint8_t)forced};
    layer->nodes[layer->count++] = node;
    return SF_OK;
}

static void destroy_layer(const sfi_job *job, sfi_layer *layer)
{
    sfi_free_array(job->allocator, layer->nodes, layer->capacity, sizeof *layer->nodes);
    *layer = (sfi_layer){0};
}

// What is left of a node.
typedef struct record {
    uint32_t at, next;
} record;

typedef struct forest {
    const sfi_job *job;
    const sfi_price *price;
    sfi_forest *options;
    sfi_chooser chooser;
    sfi_layer here, low;
    sf_slice wanting, carried; // scratch
    record *records;
    size_t count, capacity;
    size_t *first; // of each layer
} forest;

// ---------------------------------------------------------------------------------------------
// From the top down
// ---------------------------------------------------------------------------------------------

// Add a node for each voxel of a word of drawn matter.
static sf_status begin_word(forest *f, sfi_layer *layer, uint32_t y, size_t i, uint64_t w)
{
    const sfi_job *job = f->job;
    uint32_t k = layer->k;
    // A root that is no settled one stays.
    uint64_t must = sfi_slice_row(sf_grid_slice(job->roots, k), y)[i];
    if (job->must != NULL) {
        must |= sfi_slice_row(sf_grid_slice(job->must, k), y)[i];
    }
    // A drawn voxel costs nothing itself, so its price is that of the best below it. Under slack
    // that depends on what is demanded of it, which nobody knows yet.
    const int16_t *prices = f->chooser.codes == NULL ? sfi_price_row(f->price, k, y) : NULL;
    for (; w != 0; w &= w - 1) {
        uint32_t b = sfi_lowest_bit(w), x = (uint32_t)i * 64 + b;
        uint32_t at = (uint32_t)sfi_plane_at(&f->chooser.plane, x, y);
        int16_t least = prices != NULL ? prices[x] : SFI_PRICE_NONE;
        SF_TRY(sfi_layer_add(job, layer, at, sfi_job_remove(job, k, x, y), least,
                             (int)(must >> b & 1)));
    }
    return SF_OK;
}

// layer = nodes for the drawn voxels of layer k that are in the room and not settled.
static sf_status begin_layer(forest *f, sfi_layer *layer, uint32_t k)
{
    const sfi_job *job = f->job;
    layer->k = k;
    layer->count = 0;
    SF_TRY(sf_slice_and(f->wanting, sf_grid_slice(job->drawn, k), sf_grid_slice(job->room, k)));
    SF_TRY(sf_slice_subtract(f->wanting, f->wanting, sf_grid_slice(sfi_job_settled(job), k)));
    for (uint32_t y = 0; y < job->lattice.ny; y++) {
        const uint64_t *row = sfi_slice_row(f->wanting, y);
        for (size_t i = 0; i < sfi_row_words(job->lattice.nx); i++) {
            if (row[i] != 0) {
                SF_TRY(begin_word(f, layer, y, i, row[i]));
            }
        }
    }
    layer->drawn = layer->count;
    return SF_OK;
}

// Whether a root below carries a node, with all the slack that it demands.
static int is_on_root(const forest *f, const sfi_node *node, uint32_t x, uint32_t y)
{
    const sfi_chooser *c = &f->chooser;
    int is_near = (int)(sfi_slice_row(f->carried, y)[x / 64] >> (x % 64) & 1);
    if (c->codes == NULL || !is_near) {
        return is_near;
    }
    for (size_t s = 0; s < c->step_count; s++) {
        size_t place = (size_t)((ptrdiff_t)node->at + c->steps[s].offset);
        if (c->roots[place] > sfi_step_demand(c, node->demand, &c->steps[s])) {
            return 1;
        }
    }
    return 0;
}

// Nodes that need nothing but what is there become roots of the forest.
static sf_status find_rooted(forest *f)
{
    const sfi_job *job = f->job;
    uint32_t k = f->here.k;
    if (k > job->bed) {
        sf_element element;
        SF_TRY(sf_rule_element(&job->rule, k - 1, &element));
        SF_TRY(sf_slice_dilate(f->carried, sf_grid_slice(job->roots, k - 1), &element,
                               SF_BORDER_EMPTY));
    }
    for (uint32_t i = 0; i < f->here.count; i++) {
        sfi_node *node = &f->here.nodes[i];
        uint32_t stride = (uint32_t)f->chooser.plane.stride;
        uint32_t x = node->at % stride - job->reach_x, y = node->at / stride - job->reach_y;
        if (k == job->bed || is_on_root(f, node, x, y) ||
            (job->exempt != NULL && node->demand == 0 &&
             sf_slice_get(sf_grid_slice(job->exempt, k), x, y))) {
            node->next = SFI_NEXT_ROOT;
        }
    }
    return SF_OK;
}

// Hand a node's profit down, and note what is to be remembered of it.
static record settle(forest *f, const sfi_node *node)
{
    record r = {node->at, node->next};
    if (node->next == SFI_NEXT_NONE) {
        f->options->is_feasible &= !node->forced;
        f->options->all = UINT64_MAX;
        return r;
    }
    if (node->next >= SFI_NEXT_NODE) {
        sfi_node *below = &f->low.nodes[node->next - SFI_NEXT_NODE];
        below->forced |= node->forced;
        below->profit += node->profit > 0 ? node->profit : 0;
    }
    if (node->forced || node->profit > 0) {
        r.next |= SFI_NEXT_WANTED;
    }
    return r;
}

static sf_status settle_layer(forest *f)
{
    void *memory = f->records;
    size_t need;
    if (!sfi_size_add(f->count, f->here.count, &need)) {
        return SF_ERR_OVERFLOW;
    }
    int good = sfi_grow_array(f->job->allocator, &memory, &f->capacity, need, sizeof *f->records);
    f->records = memory;
    if (!good) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < f->here.count; i++) {
        f->records[f->count++] = settle(f, &f->here.nodes[i]);
    }
    return SF_OK;
}

static sf_status go_down(forest *f)
{
    const sfi_job *job = f->job;
    uint64_t added = 0;
    if (f->price->top == 0) {
        return SF_OK;
    }
    SF_TRY(begin_layer(f, &f->here, f->price->top - 1));
    sfi_sweep sweep = sfi_sweep_begin(job->pace, f->price->top - job->bed);
    for (;;) {
        uint32_t k = f->here.k;
        SF_TRY(sfi_sweep_layer(&sweep));
        f->low.count = f->low.drawn = 0;
        if (k > job->bed) {
            sfi_chooser_load(&f->chooser, f->price, k - 1);
            SF_TRY(begin_layer(f, &f->low, k - 1));
        }
        SF_TRY(find_rooted(f));
        if (k > job->bed) {
            SF_TRY(sfi_choose(&f->chooser, &f->here, &f->low, &added));
        }
        f->first[k] = f->count;
        SF_TRY(settle_layer(f));
        if (k == job->bed) {
            break;
        }
        sfi_layer layer = f->here;
        f->here = f->low;
        f->low = layer;
    }
    if (f->options->all != UINT64_MAX) {
        f->options->all += added;
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// From the bottom up
// ---------------------------------------------------------------------------------------------

// result = roots, and the nodes that are wanted and rest on one that is kept.
static sf_status go_up(forest *f, sf_grid *result)
{
    const sfi_job *job = f->job;
    uint32_t stride = (uint32_t)f->chooser.plane.stride;
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        SF_TRY(sf_slice_copy(sf_grid_slice(result, k), sf_grid_slice(job->roots, k)));
    }
    sfi_sweep sweep = sfi_sweep_begin(job->pace, f->price->top);
    for (uint32_t k = job->bed; k < f->price->top; k++) {
        sf_slice out = sf_grid_slice(result, k);
        SF_TRY(sfi_sweep_layer(&sweep));
        const record *below = k > job->bed ? f->records + f->first[k - 1] : NULL;
        // Records run from the top down, so a layer ends where the one below begins.
        size_t end = k > job->bed ? f->first[k - 1] : f->count;
        for (size_t i = f->first[k]; i < end; i++) {
            record *r = &f->records[i];
            uint32_t next = r->next & ~SFI_NEXT_WANTED;
            int keep = (r->next & SFI_NEXT_WANTED) != 0 &&
                       (next == SFI_NEXT_ROOT || below[next - SFI_NEXT_NODE].next != 0);
            r->next = (uint32_t)keep;
            if (keep) {
                uint32_t x = r->at % stride - job->reach_x, y = r->at / stride - job->reach_y;
                sfi_slice_row(out, y)[x / 64] |= UINT64_C(1) << (x % 64);
            }
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Both
// ---------------------------------------------------------------------------------------------

// Room for a record of each drawn voxel that is asked about; what else there is grows it.
static sf_status reserve_records(forest *f)
{
    uint64_t drawn = sf_grid_popcount(f->job->drawn);
    uint64_t settled = sf_grid_popcount(sfi_job_settled(f->job));
    uint64_t need = drawn > settled ? drawn - settled : 0;
    if (need > SIZE_MAX) {
        return SF_ERR_OVERFLOW;
    }
    void *memory = NULL;
    int good =
        sfi_grow_array(f->job->allocator, &memory, &f->capacity, (size_t)need, sizeof *f->records);
    f->records = memory;
    return good ? SF_OK : SF_ERR_MEMORY;
}

static sf_status forest_create(forest *f)
{
    const sfi_job *job = f->job;
    SF_TRY(reserve_records(f));
    uint32_t nx = job->lattice.nx, ny = job->lattice.ny;
    size_t stride = sf_slice_stride(nx);
    f->wanting = (sf_slice){NULL, nx, ny, stride};
    f->carried = f->wanting;
    f->wanting.words = sfi_alloc_array(job->allocator, ny, stride * sizeof(uint64_t));
    f->carried.words = sfi_alloc_array(job->allocator, ny, stride * sizeof(uint64_t));
    f->first = sfi_alloc_array(job->allocator, job->lattice.nz, sizeof *f->first);
    if (f->wanting.words == NULL || f->carried.words == NULL || f->first == NULL) {
        return SF_ERR_MEMORY;
    }
    return sfi_chooser_create(job, f->options->prefer_drawn, &f->chooser);
}

static void forest_destroy(forest *f)
{
    const sfi_job *job = f->job;
    size_t row = f->wanting.stride * sizeof(uint64_t);
    sfi_free_array(job->allocator, f->wanting.words, f->wanting.height, row);
    sfi_free_array(job->allocator, f->carried.words, f->carried.height, row);
    sfi_free_array(job->allocator, f->first, job->lattice.nz, sizeof *f->first);
    sfi_free_array(job->allocator, f->records, f->capacity, sizeof *f->records);
    destroy_layer(job, &f->here);
    destroy_layer(job, &f->low);
    sfi_chooser_destroy(&f->chooser);
}

sf_status sfi_forest_grow(const sfi_job *job, const sfi_price *price, sfi_forest *options,
                          sf_grid *result)
{
    forest f = {.job = job, .price = price, .options = options};
    options->all = 0;
    options->is_feasible = 1;
    options->nodes = 0;
    sf_status status = forest_create(&f);
    if (status == SF_OK) {
        status = go_down(&f);
    }
    if (status == SF_OK) {
        status = go_up(&f, result);
    }
    options->nodes = f.count;
    forest_destroy(&f);
    return status;
}
