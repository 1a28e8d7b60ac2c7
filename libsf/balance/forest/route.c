// SPDX-License-Identifier: MIT
// Route: the cheapest way down from every place, and what each place rests on.
//
// Let a(v) be what place v costs, its weight where that is above 0 and nothing where it is kept
// gladly, or forced anyway. Then
//
//     price(v) = a(v) where v is rooted, else a(v) + min over u in N(v), places below, of price(u)
//
// in one sweep from the bottom up, and next(v) is the u that has that minimum: of equals the one
// that is most straight below, so that a block that is kept gladly stands on itself, whatever
// weights do to its borders.
//
// Weights are shifted down so that the dearest way of all fits 32 bits; one that is above 0 costs 1
// at least, so that ways are short.
//
// A way that many use is charged to each of them as if it were alone. With a discount each pays its
// share of what used it the last time; and prices may be shaken, so that another try finds other
// ways.
//
// Source: the map of supporting paths is T. Reiner, S. Lefebvre, "Interactive Modeling of
// Support-free Shapes for Fabrication", Eurographics 2016, section 3.3.

#include "balance/forest/places.h"

#include "base/bits.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "voxel/slice.h"

#define NONE INT32_MAX

// Edge of the blocks of places of which half are shaken.
enum { BLOCK = 16 };

// What a place costs at most: 2^20, or less where a way of nz places could exceed 2^30.
static unsigned shift_of(uint32_t nz)
{
    unsigned shift = 10;
    while (shift < 30 && ((uint64_t)SFI_PLACE_WEIGHT >> shift) * nz > (uint64_t)SFI_PLACE_WEIGHT) {
        shift++;
    }
    return shift;
}

typedef struct step_offset {
    ptrdiff_t place;
    int32_t dx, dy;
} step_offset;

typedef struct route {
    sfi_places *places;
    const sfi_discount *discount; // or NULL
    unsigned shift;
    size_t stride, size;   // of a plane, with a border as wide as a step reaches
    int32_t *below, *here; // planes of prices
    step_offset *offsets;  // of the step, the nearest first
    size_t offset_count, offset_capacity;
} route;

static sf_status route_create(sfi_places *places, route *r)
{
    const sfi_interior *in = places->in;
    size_t nx = in->lattice.nx, ny = in->lattice.ny, height = ny + 2 * (size_t)in->reach_y;
    r->places = places;
    r->shift = shift_of(in->lattice.nz);
    r->stride = nx + 2 * (size_t)in->reach_x;
    r->offset_capacity = (2 * (size_t)in->reach_x + 1) * (2 * (size_t)in->reach_y + 1);
    if (!sfi_size_mul(r->stride, height, &r->size)) {
        return SF_ERR_OVERFLOW;
    }
    r->below = sfi_alloc_array(&in->allocator, r->size, sizeof *r->below);
    r->here = sfi_alloc_array(&in->allocator, r->size, sizeof *r->here);
    r->offsets = sfi_alloc_array(&in->allocator, r->offset_capacity, sizeof *r->offsets);
    if (r->below == NULL || r->here == NULL || r->offsets == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < r->size; i++) {
        r->below[i] = NONE;
    }
    return SF_OK;
}

static void route_destroy(route *r)
{
    const sf_allocator *a = &r->places->in->allocator;
    sfi_free_array(a, r->below, r->size, sizeof *r->below);
    sfi_free_array(a, r->here, r->size, sizeof *r->here);
    sfi_free_array(a, r->offsets, r->offset_capacity, sizeof *r->offsets);
}

static void add_offset(route *r, const sf_element *e, int32_t dx, int32_t dy)
{
    uint32_t ax = (uint32_t)(dx < 0 ? -dx : dx), ay = (uint32_t)(dy < 0 ? -dy : dy);
    if (ay <= e->reach_y && ax <= e->half_width[ay]) {
        step_offset o = {(ptrdiff_t)r->stride * dy + dx, dx, dy};
        r->offsets[r->offset_count++] = o;
    }
}

// The offsets of an element, ring by ring outwards; in a ring those along the axes first.
static void list_offsets(route *r, const sf_element *e)
{
    int32_t most = e->half_width[0] > e->reach_y ? e->half_width[0] : e->reach_y;
    r->offset_count = 0;
    add_offset(r, e, 0, 0);
    for (int32_t ring = 1; ring <= most; ring++) {
        for (int32_t side = 0; side <= ring; side++) {
            for (int32_t sign = -1; sign <= (side > 0 ? 1 : -1); sign += 2) {
                add_offset(r, e, sign * side, -ring);
                add_offset(r, e, sign * side, ring);
                if (side < ring) {
                    add_offset(r, e, -ring, sign * side);
                    add_offset(r, e, ring, sign * side);
                }
            }
        }
    }
}

// The least price that a place at `at` can rest on, and by which offset.
static int32_t cheapest(const route *r, size_t at, size_t *offset)
{
    int32_t least = NONE;
    for (size_t o = 0; o < r->offset_count && least > 0; o++) {
        int32_t price = r->below[(size_t)((ptrdiff_t)at + r->offsets[o].place)];
        if (price < least) {
            least = price;
            *offset = o;
        }
    }
    return least;
}

static uint32_t hash(uint32_t number, uint32_t seed)
{
    number = (number ^ seed * UINT32_C(2654435761)) * UINT32_C(2246822519);
    return (number ^ number >> 15) * UINT32_C(3266489917);
}

// 256 for what is not shaken, else 64 to 447, so that the dearest way stays below NONE.
static int64_t shaken(const route *r, uint32_t i, uint32_t k, uint32_t x, uint32_t y)
{
    uint32_t seed = r->discount->seed;
    uint32_t block = ((k / BLOCK) << 20) ^ ((y / BLOCK) << 10) ^ (x / BLOCK);
    return seed == 0 || hash(block, seed) >> 31 != 0 ? 256
                                                     : 64 + ((hash(i, seed) >> 16) * 384 >> 16);
}

// What place i, with its corner at (x, y) of layer k, costs by itself.
static int32_t own_price(const route *r, uint32_t i, uint32_t k, uint32_t x, uint32_t y)
{
    int32_t weight = r->places->weight[i], own = weight >> r->shift;
    if (weight <= 0) {
        return 0;
    }
    if (r->discount != NULL) {
        uint32_t load = r->discount->load[i];
        own = (int32_t)(own * shaken(r, i, k, x, y) / 256);
        own = load > 1 ? (int32_t)((uint32_t)own / load) : own;
    }
    return own > 0 ? own : 1;
}

static void find_place(const route *r, uint32_t i, uint32_t k, uint32_t x, uint32_t y,
                       int is_rooted)
{
    sfi_places *p = r->places;
    const sfi_interior *in = p->in;
    size_t at = (y + (size_t)in->reach_y) * r->stride + x + in->reach_x, offset = 0;
    int32_t own = own_price(r, i, k, x, y);
    p->next[i] = SFI_PLACE_ROOT;
    if (!is_rooted) {
        own += cheapest(r, at, &offset);
        const step_offset *o = &r->offsets[offset];
        p->next[i] =
            sfi_place_at(p, k - 1, (uint32_t)((int64_t)x + o->dx), (uint32_t)((int64_t)y + o->dy));
    }
    // What is forced is there, with all that it rests on.
    p->price[i] = (p->state[i] & SFI_PLACE_FORCED) != 0 ? 0 : own;
    r->here[at] = p->price[i];
}

static void find_layer(route *r, uint32_t k)
{
    const sfi_places *p = r->places;
    const sfi_interior *in = p->in;
    sf_slice places = sf_grid_slice(in->places, k), rooted = sf_grid_slice(in->rooted, k);
    uint32_t i = p->first[(size_t)k * in->lattice.ny];
    for (size_t j = 0; j < r->size; j++) {
        r->here[j] = NONE;
    }
    for (uint32_t y = 0; y < places.height; y++) {
        const uint64_t *row = sfi_slice_row(places, y), *roots = sfi_slice_row(rooted, y);
        for (size_t w = 0; w < sfi_row_words(places.width); w++) {
            for (uint64_t word = row[w]; word != 0; word &= word - 1) {
                uint32_t b = sfi_lowest_bit(word);
                find_place(r, i++, k, (uint32_t)w * 64 + b, y, (int)(roots[w] >> b & 1));
            }
        }
    }
    int32_t *plane = r->below;
    r->below = r->here;
    r->here = plane;
}

sf_status sfi_places_route(sfi_places *places, const sfi_discount *discount)
{
    route r = {.places = places, .discount = discount};
    const sfi_interior *in = places->in;
    sf_status status = route_create(places, &r);
    for (uint32_t k = 0; status == SF_OK && k < in->lattice.nz; k++) {
        sf_element element = {0, {0}};
        status = sf_task_is_cancelled(in->task) ? SF_ERR_CANCELLED : SF_OK;
        if (status == SF_OK && k > 0) {
            status = sf_rule_element(&in->plain, k - 1, &element);
        }
        if (status == SF_OK) {
            list_offsets(&r, &element);
            find_layer(&r, k);
        }
    }
    route_destroy(&r);
    return status;
}
