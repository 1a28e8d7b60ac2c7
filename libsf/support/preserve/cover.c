// SPDX-License-Identifier: MIT
// Greedy cover: the fewest voxels below, as nearly as greed finds them, that carry what hangs.
//
// Each pending voxel v must be carried by one of the voxels u of the layer below that reach it: u
// within the element around v, and under slack with
//
//     slack(u) >= need(v) - gain + |v - u|     (the demand of v on u)
//
// That is set cover by equal windows, which is hard. Greedy takes the u that serves most of what is
// still open; for windows of n voxels that is within H_n of the least (2.83 for 3x3), and measured
// within 1.2. Voxels that stay anyway are asked before all others. The heap is lazy: a key is what
// an offer was once worth, which only falls, so the top is worth its key or is put back with less.
// Of equals the one that is most straight below goes first, so that what is kept hangs straight
// down and does not drift, then the lowest row and the lowest x: the outcome is fixed.
//
// Then reverse delete: from the last chosen to the first, whoever serves only what others serve as
// well is left out. What remains serves something alone, so none of it can be spared in this layer.
//
// The key of an offer: bit 63 for one that stays anyway, then 31 bits of worth, then the complement
// of its place, so that the largest key is what to take.
//
// Source: greedy set cover, D. S. Johnson, "Approximation algorithms for combinatorial problems",
// 1974; the lazy heap, M. Minoux, "Accelerated greedy algorithms for maximizing submodular set
// functions", 1978.

#include "support/preserve/cover.h"

#include "base/bits.h"
#include "base/bytes.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "voxel/slice.h"

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

static sf_status create_slice(sf_slice *slice, uint32_t width, uint32_t height,
                              const sf_allocator *allocator)
{
    sf_slice made = {NULL, width, height, sf_slice_stride(width)};
    made.words = sfi_alloc_array(allocator, height, made.stride * sizeof(uint64_t));
    if (made.words == NULL) {
        return SF_ERR_MEMORY;
    }
    *slice = made;
    return SF_OK;
}

static void destroy_slice(sf_slice slice, const sf_allocator *allocator)
{
    sfi_free_array(allocator, slice.words, slice.height, slice.stride * sizeof(uint64_t));
}

// Costs of all offsets that any step has.
static sf_status create_costs(const sf_rule *rule, uint32_t layer_count, sfi_cover *c)
{
    uint32_t reach = 0;
    for (uint32_t k = 0; k + 1 < layer_count; k++) {
        sf_element e;
        SF_TRY(sf_rule_element(rule, k, &e));
        reach = e.half_width[0] > reach ? e.half_width[0] : reach;
        reach = e.reach_y > reach ? e.reach_y : reach;
    }
    c->cost_stride = reach + 1u;
    uint32_t *costs =
        sfi_alloc_array(&c->allocator, c->cost_stride, c->cost_stride * sizeof *costs);
    if (costs == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t dy = 0; dy <= reach; dy++) {
        for (uint32_t dx = 0; dx <= reach; dx++) {
            costs[dy * c->cost_stride + dx] = sfi_slack_cost(rule, dx, dy);
        }
    }
    c->costs = costs;
    return SF_OK;
}

sf_status sfi_cover_create(const sf_rule *rule, uint32_t width, uint32_t height,
                           uint32_t layer_count, const sf_allocator *allocator, sfi_cover *c)
{
    *c = (sfi_cover){.width = width, .height = height};
    c->allocator = sfi_allocator_or_default(allocator);
    SF_TRY(create_slice(&c->chosen, width, height, &c->allocator));
    SF_TRY(create_slice(&c->open, width, height, &c->allocator));
    SF_TRY(create_slice(&c->offered, width, height, &c->allocator));
    c->counts = sfi_alloc_array(&c->allocator, height, width * sizeof *c->counts);
    if (c->counts == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(c->counts, 0, (size_t)width * height * sizeof *c->counts);
    return rule->kind == SF_RULE_SLACK ? create_costs(rule, layer_count, c) : SF_OK;
}

void sfi_cover_destroy(sfi_cover *c)
{
    const sf_allocator *a = &c->allocator;
    if (c->allocator.alloc == NULL) {
        return;
    }
    destroy_slice(c->chosen, a);
    destroy_slice(c->open, a);
    destroy_slice(c->offered, a);
    sfi_free_array(a, c->counts, c->height, c->width * sizeof *c->counts);
    sfi_free_array(a, (void *)(uintptr_t)c->costs, c->cost_stride,
                   c->cost_stride * sizeof *c->costs);
    sfi_free_array(a, c->heap.keys, c->heap.capacity, sizeof *c->heap.keys);
    sfi_free_array(a, c->order.keys, c->order.capacity, sizeof *c->order.keys);
    sfi_free_array(a, c->served, c->served_capacity, sizeof *c->served);
}

// ---------------------------------------------------------------------------------------------
// Who serves whom
// ---------------------------------------------------------------------------------------------

static inline int has(sf_slice s, uint32_t x, uint32_t y)
{
    return (sfi_slice_row(s, y)[x / 64] >> (x % 64) & 1) != 0;
}

static inline void put(sf_slice s, uint32_t x, uint32_t y, int value)
{
    uint64_t bit = UINT64_C(1) << (x % 64), *word = &sfi_slice_row(s, y)[x / 64];
    *word = value ? *word | bit : *word & ~bit;
}

static inline uint32_t apart(uint32_t a, uint32_t b)
{
    return a > b ? a - b : b - a;
}

// The code that a carrier must have to serve v, dx and dy away. Without slack: any.
static inline uint32_t demand(const sfi_cover *c, uint32_t x, uint32_t y, uint32_t dx, uint32_t dy)
{
    if (c->need == NULL) {
        return 1;
    }
    uint32_t need = c->need[y * sfi_slack_stride(c->width) + x];
    uint32_t cost = c->costs[dy * c->cost_stride + dx];
    return need + cost > c->gain + 1 ? need + cost - c->gain : 1;
}

static inline uint32_t code_of(const sfi_cover *c, uint32_t x, uint32_t y)
{
    return c->slack == NULL ? 1 : c->slack[y * sfi_slack_stride(c->width) + x];
}

// Voxels of a row of `set` that carrier (ux, uy) serves, to the end of c->served.
static sf_status gather_row(sfi_cover *c, sf_slice set, uint32_t ux, uint32_t uy, uint32_t y,
                            size_t *count)
{
    uint32_t dy = apart(y, uy), w = c->element.half_width[dy], code = code_of(c, ux, uy);
    uint32_t x0 = ux > w ? ux - w : 0, x1 = c->width - ux > w ? ux + w + 1 : c->width;
    const uint64_t *row = sfi_slice_row(set, y);
    for (size_t i = x0 / 64; i <= (x1 - 1) / 64; i++) {
        uint64_t word = row[i];
        word &= i == x0 / 64 ? ~UINT64_C(0) << (x0 % 64) : ~UINT64_C(0);
        word &= i == (x1 - 1) / 64 ? sfi_tail_mask(x1) : ~UINT64_C(0);
        for (; word != 0; word &= word - 1) {
            uint32_t x = (uint32_t)i * 64 + sfi_lowest_bit(word);
            if (code < demand(c, x, y, apart(x, ux), dy)) {
                continue;
            }
            void *memory = c->served;
            if (!sfi_grow_array(&c->allocator, &memory, &c->served_capacity, *count + 1,
                                sizeof *c->served)) {
                return SF_ERR_MEMORY;
            }
            c->served = memory;
            c->served[(*count)++] = y * c->width + x;
        }
    }
    return SF_OK;
}

// c->served = the voxels of `set` that carrier (ux, uy) serves.
static sf_status gather(sfi_cover *c, sf_slice set, uint32_t ux, uint32_t uy, size_t *count)
{
    uint32_t reach = c->element.reach_y;
    uint32_t y0 = uy > reach ? uy - reach : 0;
    uint32_t y1 = c->height - uy > reach ? uy + reach + 1 : c->height;
    *count = 0;
    for (uint32_t y = y0; y < y1; y++) {
        SF_TRY(gather_row(c, set, ux, uy, y, count));
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Heap
// ---------------------------------------------------------------------------------------------

static sf_status offers_append(sfi_cover *c, sfi_offers *o, uint64_t key)
{
    void *memory = o->keys;
    if (!sfi_grow_array(&c->allocator, &memory, &o->capacity, o->count + 1, sizeof *o->keys)) {
        return SF_ERR_MEMORY;
    }
    o->keys = memory;
    o->keys[o->count++] = key;
    return SF_OK;
}

// Let the key at `i` sink to its place.
static void heap_sink(sfi_offers *h, size_t i)
{
    uint64_t key = h->keys[i];
    for (size_t child; (child = 2 * i + 1) < h->count; i = child) {
        child += child + 1 < h->count && h->keys[child + 1] > h->keys[child];
        if (h->keys[child] <= key) {
            break;
        }
        h->keys[i] = h->keys[child];
    }
    h->keys[i] = key;
}

static uint64_t key_of(const sfi_cover *c, size_t worth, uint32_t x, uint32_t y)
{
    uint64_t stays = (uint64_t)has(c->first, x, y) << 63;
    return stays | (uint64_t)worth << 32 | (uint32_t) ~(y * c->width + x);
}

static void place_of(const sfi_cover *c, uint64_t key, uint32_t *x, uint32_t *y)
{
    uint32_t place = ~(uint32_t)key;
    *x = place % c->width;
    *y = place / c->width;
}

static sf_status make_offers(sfi_cover *c)
{
    c->heap.count = c->order.count = 0;
    SF_TRY(sf_slice_and_dilate(c->offered, c->carriers, c->pending, &c->element));
    for (uint32_t y = 0; y < c->height; y++) {
        const uint64_t *row = sfi_slice_row(c->offered, y);
        for (size_t i = 0; i < sfi_row_words(c->width); i++) {
            for (uint64_t word = row[i]; word != 0; word &= word - 1) {
                uint32_t x = (uint32_t)i * 64 + sfi_lowest_bit(word);
                size_t worth;
                SF_TRY(gather(c, c->pending, x, y, &worth));
                if (worth > 0) {
                    SF_TRY(offers_append(c, &c->heap, key_of(c, worth, x, y)));
                }
            }
        }
    }
    for (size_t i = c->heap.count / 2; i-- > 0;) {
        heap_sink(&c->heap, i);
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Greedy, reverse delete, assignment
// ---------------------------------------------------------------------------------------------

static sf_status choose(sfi_cover *c)
{
    uint64_t left = sf_slice_popcount(c->open);
    while (left > 0 && c->heap.count > 0) {
        uint32_t x, y;
        size_t worth;
        place_of(c, c->heap.keys[0], &x, &y);
        SF_TRY(gather(c, c->open, x, y, &worth));
        uint64_t key = key_of(c, worth, x, y);
        if (worth > 0 && key < c->heap.keys[0]) {
            c->heap.keys[0] = key;
            heap_sink(&c->heap, 0);
            continue;
        }
        c->heap.keys[0] = c->heap.keys[--c->heap.count];
        if (c->heap.count > 0) {
            heap_sink(&c->heap, 0);
        }
        if (worth == 0) {
            continue;
        }
        for (size_t i = 0; i < worth; i++) {
            put(c->open, c->served[i] % c->width, c->served[i] / c->width, 0);
        }
        left -= worth;
        put(c->chosen, x, y, 1);
        SF_TRY(offers_append(c, &c->order, key));
    }
    return left == 0 ? SF_OK : SF_ERR_INTERNAL;
}

static sf_status count_servers(sfi_cover *c)
{
    for (size_t i = 0; i < c->order.count; i++) {
        uint32_t x, y;
        size_t n;
        place_of(c, c->order.keys[i], &x, &y);
        SF_TRY(gather(c, c->pending, x, y, &n));
        while (n-- > 0) {
            c->counts[c->served[n]]++;
        }
    }
    return SF_OK;
}

// Only pending voxels have been counted.
static void clear_counts(sfi_cover *c)
{
    for (uint32_t y = 0; y < c->height; y++) {
        const uint64_t *row = sfi_slice_row(c->pending, y);
        for (size_t i = 0; i < sfi_row_words(c->width); i++) {
            for (uint64_t word = row[i]; word != 0; word &= word - 1) {
                c->counts[(size_t)y * c->width + i * 64 + sfi_lowest_bit(word)] = 0;
            }
        }
    }
}

static sf_status reverse_delete(sfi_cover *c)
{
    for (size_t i = c->order.count; i-- > 0;) {
        uint32_t x, y;
        size_t n, spared = 0;
        place_of(c, c->order.keys[i], &x, &y);
        if (has(c->first, x, y)) {
            continue;
        }
        SF_TRY(gather(c, c->pending, x, y, &n));
        while (spared < n && c->counts[c->served[spared]] >= 2) {
            spared++;
        }
        if (spared == n) {
            put(c->chosen, x, y, 0);
            while (n-- > 0) {
                c->counts[c->served[n]]--;
            }
        }
    }
    return SF_OK;
}

sf_status sfi_cover_greedy(sfi_cover *c)
{
    sf_rect all = {0, 0, c->width, c->height};
    SF_TRY(sf_slice_fill(c->chosen, all, 0));
    SF_TRY(sf_slice_copy(c->open, c->pending));
    SF_TRY(make_offers(c));
    SF_TRY(choose(c));
    sf_status status = count_servers(c);
    if (status == SF_OK) {
        status = reverse_delete(c);
    }
    clear_counts(c);
    return status;
}

// The chosen voxel that serves v with the least to raise, as a place; its demand is left in *code.
static uint32_t cheapest(const sfi_cover *c, const uint8_t *demands, uint32_t x, uint32_t y,
                         uint32_t *code)
{
    size_t stride = sfi_slack_stride(c->width);
    uint32_t least = UINT32_MAX, best = UINT32_MAX, reach = c->element.reach_y;
    for (uint32_t uy = y > reach ? y - reach : 0; uy < c->height && uy <= y + reach; uy++) {
        uint32_t dy = apart(uy, y), w = c->element.half_width[dy];
        for (uint32_t ux = x > w ? x - w : 0; ux < c->width && ux <= x + w; ux++) {
            if (!has(c->chosen, ux, uy)) {
                continue;
            }
            uint32_t ask = demand(c, x, y, apart(ux, x), dy), at = demands[uy * stride + ux];
            uint32_t more = ask > at ? ask - at : 0;
            if (ask <= code_of(c, ux, uy) && more < least) {
                least = more;
                best = uy * c->width + ux;
                *code = ask;
            }
        }
    }
    return best;
}

void sfi_cover_assign(sfi_cover *c, uint8_t *demands)
{
    size_t stride = sfi_slack_stride(c->width);
    for (uint32_t y = 0; y < c->height; y++) {
        const uint64_t *row = sfi_slice_row(c->pending, y);
        for (size_t i = 0; i < sfi_row_words(c->width); i++) {
            for (uint64_t word = row[i]; word != 0; word &= word - 1) {
                uint32_t x = (uint32_t)i * 64 + sfi_lowest_bit(word), code = 0;
                uint32_t place = cheapest(c, demands, x, y, &code);
                if (place != UINT32_MAX) {
                    uint8_t *at = &demands[place / c->width * stride + place % c->width];
                    *at = *at > code ? *at : (uint8_t)code;
                }
            }
        }
    }
}
