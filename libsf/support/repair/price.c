// SPDX-License-Identifier: MIT
// Price map: the least cost of a chain of matter that carries a voxel.
//
// Let a(v) be what it costs to fill v: 0 where it is solid, or counts as such. Then
//
//     E(v) = a(v) + min over u in N(v), below, of E(u),      E(v) = a(v) on the bed
//
// so E(v) is what the cheapest chain from v to the bed costs, v included. E is 0 just on what is
// support-free already, because every filling costs at least 1. Exempt voxels need no chain.
//
// One sweep from the bottom up. A row of the minimum is made by rows: for each half width of the
// element the rows that share it are merged first, then a running minimum of that width is made by
// doubling, log2 of the width steps; the 3x3 square is three rows, then three columns. All of it is
// minima and saturating sums of int16_t, eight or more in one instruction with any compiler; that
// is why prices are signed and moved down.
//
// Under slack a chain must also not run out of reach. There a voxel has a label: the least price,
// and among chains of that price the largest slack that is left. It is no shortest path (a dearer
// chain may leave more), but each label is one of a chain that stands.
//
// Only what is asked for is computed: the rectangle around the targets, grown by the reach with
// each layer on the way down. Nothing outside it can be asked by whoever walks from the targets.
//
// Source: the map of supporting paths is T. Reiner, S. Lefebvre, "Interactive Modeling of
// Support-free Shapes for Fabrication", Eurographics 2016, section 3.3; without the filled voxels'
// reset, because here what a chain passes through must itself be carried.

#include "support/repair/repair.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "support/repair/price_row.h"
#include "support/rule/carry.h"
#include "voxel/slice.h"

// ---------------------------------------------------------------------------------------------
// Which rectangles
// ---------------------------------------------------------------------------------------------

static sf_rect join(sf_rect a, sf_rect b)
{
    if (a.x1 == a.x0 || a.y1 == a.y0) {
        return b;
    }
    if (b.x1 == b.x0 || b.y1 == b.y0) {
        return a;
    }
    sf_rect r = {a.x0 < b.x0 ? a.x0 : b.x0, a.y0 < b.y0 ? a.y0 : b.y0, a.x1 > b.x1 ? a.x1 : b.x1,
                 a.y1 > b.y1 ? a.y1 : b.y1};
    return r;
}

static int is_same(sf_rect a, sf_rect b)
{
    return a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1;
}

static sf_rect widen(sf_rect r, const sf_element *e, const sf_lattice *lattice)
{
    uint32_t dx = sfi_element_reach_x(e), dy = e->reach_y;
    if (r.x1 == r.x0) {
        return r;
    }
    sf_rect w = {r.x0 > dx ? r.x0 - dx : 0, r.y0 > dy ? r.y0 - dy : 0,
                 lattice->nx - r.x1 > dx ? r.x1 + dx : lattice->nx,
                 lattice->ny - r.y1 > dy ? r.y1 + dy : lattice->ny};
    return w;
}

// The rectangle around the targets of a layer; `scratch` is a slice.
static sf_status target_rect(const sfi_price_terms *t, uint32_t k, sf_slice scratch, sf_rect *rect)
{
    sf_slice room = sf_grid_slice(t->room, k);
    if (t->targets == NULL) {
        *rect = sf_slice_bounds(room);
        return SF_OK;
    }
    SF_TRY(sf_slice_and(scratch, sf_grid_slice(t->targets, k), room));
    if (t->settled != NULL) {
        SF_TRY(sf_slice_subtract(scratch, scratch, sf_grid_slice(t->settled, k)));
    }
    *rect = sf_slice_bounds(scratch);
    return SF_OK;
}

static sf_status find_rects(const sfi_job *job, const sfi_price_terms *t, sfi_price *p,
                            sf_slice scratch)
{
    sf_rect need = {0, 0, 0, 0};
    for (uint32_t k = job->lattice.nz; k-- > job->bed;) {
        sf_rect own;
        sf_element element;
        SF_TRY(target_rect(t, k, scratch, &own));
        if (k + 1 < job->lattice.nz) {
            SF_TRY(sf_rule_element(&job->rule, k, &element));
            need = widen(need, &element, &job->lattice);
        }
        need = join(need, own);
        if (p->rooted != NULL && !is_same(p->rects[k], need)) {
            p->rooted = NULL; // codes of the roots are laid out as prices are
        }
        p->rects[k] = need;
        if (p->top == 0 && need.x1 > need.x0) {
            p->top = k + 1;
        }
    }
    for (uint32_t k = job->bed; k < p->top; k++) {
        size_t area;
        sf_rect r = p->rects[k];
        p->starts[k] = p->count;
        if (!sfi_size_mul(r.x1 - r.x0, r.y1 - r.y0, &area) ||
            !sfi_size_add(p->count, area, &p->count)) {
            return SF_ERR_OVERFLOW;
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The sweep
// ---------------------------------------------------------------------------------------------

typedef struct sweep {
    const sfi_job *job;
    const sfi_price_terms *terms;
    sfi_price *price;
    sfi_plane plane;
    int16_t *below, *here;      // planes
    int16_t *low_codes, *codes; // planes, under slack
    sfi_step *steps;            // the same, of the layer at work
    size_t step_count;
    sfi_price_lanes lanes; // rows
} sweep;

static sf_status sweep_create(sweep *s)
{
    const sfi_job *job = s->job;
    size_t count = s->plane.count;
    s->below = sfi_alloc_array(job->allocator, count, sizeof *s->below);
    s->here = sfi_alloc_array(job->allocator, count, sizeof *s->here);
    if (s->price->codes != NULL) {
        s->low_codes = sfi_alloc_array(job->allocator, count, sizeof *s->low_codes);
        s->codes = sfi_alloc_array(job->allocator, count, sizeof *s->codes);
        s->steps = sfi_alloc_array(job->allocator, sfi_steps_most(job), sizeof *s->steps);
    }
    int good =
        s->below != NULL && s->here != NULL &&
        (s->price->codes == NULL || (s->low_codes != NULL && s->codes != NULL && s->steps != NULL));
    SF_TRY(sfi_price_lanes_create(&s->lanes, &s->plane, job->allocator));
    for (size_t i = 0; good && i < count; i++) {
        s->below[i] = s->here[i] = SFI_PRICE_NONE;
    }
    for (size_t i = 0; good && s->codes != NULL && i < count; i++) {
        s->low_codes[i] = s->codes[i] = 0;
    }
    return good ? SF_OK : SF_ERR_MEMORY;
}

static void sweep_destroy(sweep *s)
{
    const sf_allocator *a = s->job->allocator;
    size_t count = s->plane.count;
    sfi_free_array(a, s->below, count, sizeof *s->below);
    sfi_free_array(a, s->here, count, sizeof *s->here);
    sfi_free_array(a, s->low_codes, count, sizeof *s->low_codes);
    sfi_free_array(a, s->codes, count, sizeof *s->codes);
    sfi_free_array(a, s->steps, sfi_steps_most(s->job), sizeof *s->steps);
    sfi_price_lanes_destroy(&s->lanes, a);
}

// What a row of voxels costs, and where it is in the room.
static sfi_price_voxels voxels_of(const sweep *s, uint32_t k, uint32_t y)
{
    const sfi_job *job = s->job;
    size_t row = ((size_t)k * job->lattice.ny + y) * job->lattice.nx;
    sfi_price_voxels v = {sfi_slice_row(sf_grid_slice(s->terms->room, k), y),
                          sfi_slice_row(sf_grid_slice(s->terms->free, k), y), NULL,
                          job->add != NULL ? job->add + row : NULL, (int16_t)job->scale};
    if (job->exempt != NULL) {
        v.exempt = sfi_slice_row(sf_grid_slice(job->exempt, k), y);
    }
    return v;
}

// What a row is made from under slack; `at` is its first element in the planes.
static sfi_price_labels labels_of(const sweep *s, uint32_t k, size_t at)
{
    const sf_rule *rule = &s->job->rule;
    sfi_price_labels labels = {.below = s->below + at,
                               .low_codes = s->low_codes + at,
                               .here = s->here + at,
                               .codes = s->codes + at,
                               .steps = s->steps,
                               .step_count = s->step_count,
                               .gain = k > s->job->bed ? sfi_slack_gain(rule, k - 1) : 0,
                               .top = (int16_t)(rule->slack_cap + 1)};
    return labels;
}

// Prices of layer k within its rectangle, from those below.
static void sweep_layer(sweep *s, uint32_t k, const sf_element *element)
{
    sf_rect r = s->price->rects[k];
    if (s->codes != NULL && k > s->job->bed) {
        s->step_count = sfi_steps_of(s->job, &s->plane, k - 1, s->steps);
    }
    for (uint32_t y = r.y0; y < r.y1; y++) {
        sfi_price_voxels v = voxels_of(s, k, y);
        size_t at = sfi_plane_at(&s->plane, 0, y);
        sfi_price_lanes_load(&s->lanes, &v, r.x0, r.x1);
        if (s->codes != NULL) {
            sfi_price_labels labels = labels_of(s, k, at);
            sfi_price_label_row(&s->lanes, &labels, k == s->job->bed, r.x0, r.x1);
            continue;
        }
        if (k == s->job->bed) {
            sfi_price_free_row(&s->lanes, r.x0, r.x1);
        } else {
            sfi_price_least_row(&s->lanes, &s->plane, s->below + at, element, r.x0, r.x1);
        }
        sfi_price_add_row(&s->lanes, s->here + at, r.x0, r.x1);
    }
}

static void keep_layer(const sweep *s, uint32_t k)
{
    sf_rect r = s->price->rects[k];
    for (uint32_t y = r.y0; y < r.y1; y++) {
        size_t at = sfi_plane_at(&s->plane, 0, y);
        int16_t *out = sfi_price_row(s->price, k, y);
        uint8_t *codes = NULL;
        for (uint32_t x = r.x0; x < r.x1; x++) {
            out[x] = s->here[at + x];
        }
        if (s->codes != NULL) {
            codes = sfi_price_codes(s->price, s->price->codes, k, y);
        }
        for (uint32_t x = r.x0; codes != NULL && x < r.x1; x++) {
            codes[x] = (uint8_t)s->codes[at + x];
        }
    }
}

static sf_status sweep_all(sweep *s)
{
    const sfi_job *job = s->job;
    sfi_sweep layers = sfi_sweep_begin(job->pace, s->price->top - job->bed);
    for (uint32_t k = job->bed; k < s->price->top; k++) {
        sf_element element = {0, {0}};
        SF_TRY(sfi_sweep_layer(&layers));
        if (k > job->bed) {
            SF_TRY(sf_rule_element(&job->rule, k - 1, &element));
        }
        sweep_layer(s, k, &element);
        keep_layer(s, k);
        int16_t *prices = s->below;
        s->below = s->here;
        s->here = prices;
        int16_t *codes = s->low_codes;
        s->low_codes = s->codes;
        s->codes = codes;
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Making one
// ---------------------------------------------------------------------------------------------

static sf_status make_rects(const sfi_job *job, const sfi_price_terms *terms, sfi_price *p)
{
    if (p->rects == NULL) {
        p->layers = job->lattice.nz;
        p->rects = sfi_alloc_array(job->allocator, p->layers, sizeof *p->rects);
        p->starts = sfi_alloc_array(job->allocator, p->layers, sizeof *p->starts);
    }
    sf_slice scratch = {NULL, job->lattice.nx, job->lattice.ny, sf_slice_stride(job->lattice.nx)};
    size_t row = scratch.stride * sizeof(uint64_t);
    scratch.words = sfi_alloc_array(job->allocator, scratch.height, row);
    sf_status status = SF_ERR_MEMORY;
    if (p->rects != NULL && p->starts != NULL && scratch.words != NULL) {
        p->count = 0;
        p->top = 0;
        status = find_rects(job, terms, p, scratch);
    }
    sfi_free_array(job->allocator, scratch.words, scratch.height, row);
    return status;
}

static void free_prices(const sfi_job *job, sfi_price *p)
{
    sfi_free_array(job->allocator, p->prices, p->capacity, sizeof *p->prices);
    sfi_free_array(job->allocator, p->codes, p->capacity, 1);
    sfi_free_array(job->allocator, p->root_codes, p->capacity, 1);
    p->prices = NULL;
    p->codes = p->root_codes = NULL;
    p->capacity = 0;
}

// Room for the prices: that of an earlier map, where it is large enough. A map is large, and fresh
// memory costs as much as filling it.
static sf_status reserve(const sfi_job *job, sfi_price *p)
{
    int is_slack = job->rule.kind == SF_RULE_SLACK;
    if (p->capacity >= p->count) {
        return SF_OK;
    }
    free_prices(job, p);
    p->capacity = p->count;
    p->prices = sfi_alloc_array(job->allocator, p->count, sizeof *p->prices);
    if (is_slack) {
        p->codes = sfi_alloc_array(job->allocator, p->count, 1);
        p->root_codes = sfi_alloc_array(job->allocator, p->count, 1);
    }
    int good = p->prices != NULL && (!is_slack || (p->codes != NULL && p->root_codes != NULL));
    return good ? SF_OK : SF_ERR_MEMORY;
}

static sf_status make(const sfi_job *job, const sfi_price_terms *terms, sfi_price *p)
{
    SF_TRY(sfi_pace_ask(job->pace));
    SF_TRY(make_rects(job, terms, p));
    if (p->count == 0) {
        return SF_OK;
    }
    SF_TRY(reserve(job, p));
    sweep s = {.job = job, .terms = terms, .price = p};
    SF_TRY(sfi_plane_make(job, &s.plane));
    sf_status status = sweep_create(&s);
    if (status == SF_OK) {
        status = sweep_all(&s);
    }
    sweep_destroy(&s);
    if (status == SF_OK && p->codes != NULL && p->rooted != job->roots) {
        status = sfi_price_field(job, p, job->roots, p->root_codes);
        p->rooted = job->roots;
    }
    return status;
}

sf_status sfi_price_make(const sfi_job *job, const sfi_price_terms *terms, sfi_price *price)
{
    sf_status status = make(job, terms, price);
    if (status != SF_OK) {
        sfi_price_destroy(job, price);
    }
    return status;
}

void sfi_price_destroy(const sfi_job *job, sfi_price *p)
{
    free_prices(job, p);
    sfi_free_array(job->allocator, p->rects, p->layers, sizeof *p->rects);
    sfi_free_array(job->allocator, p->starts, p->layers, sizeof *p->starts);
    *p = (sfi_price){0};
}
