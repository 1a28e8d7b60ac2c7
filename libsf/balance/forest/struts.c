// SPDX-License-Identifier: MIT
// Struts: which places carry the ceilings, and what carries those.
//
// From the top down: a layer's asked voxels, and the places that were chosen in it and are not
// rooted, must be carried by places of the layer below. Which, is a set cover, and greedy: taken is
// the place that carries most of what is still open for its price, the price being that of the
// cheapest way from it to the wall (route.c). So struts go to where they end soon, or where they
// are not minded, and one that many can share goes before many. The heap is lazy: a key is what an
// offer was once worth, which only falls. Then from the dearest on, what others carry as well is
// left out.
//
// A place carries the voxels that its square meets the element of, and the places within the
// element. Rows of bits are counted, so an offer costs a few words for each row.
//
// All that is chosen is forced: for the multipliers it is no choice, whatever it weighs.
//
// Source: greedy cover by price, V. Chvatal, "A greedy heuristic for the set-covering problem",
// 1979; the lazy heap, M. Minoux, "Accelerated greedy algorithms for maximizing submodular set
// functions", 1978.

#include "balance/forest/places.h"

#include "base/bits.h"
#include "base/memory.h"
#include "base/status.h"
#include "voxel/slice.h"

typedef struct offer {
    uint64_t worth;
    uint32_t x, y;
} offer;

typedef struct heap {
    offer *offers;
    size_t count, capacity;
} heap;

// Slices of the layer that is to be carried, and of the one below that carries.
enum { ASKED, HANGING, OPEN_ASKED, OPEN_HANGING, OFFERED, CHOSEN, SLICES };

typedef struct strutter {
    sfi_places *places;
    uint64_t *words;
    sf_slice s[SLICES];
    sf_element element; // of the step
    uint32_t k;         // layer that carries
    heap heap, taken;
} strutter;

// ---------------------------------------------------------------------------------------------
// Windows
// ---------------------------------------------------------------------------------------------

// A rectangle of rows of changing width: around a square of `size` voxels, or the corners of
// squares of `size` that meet the element around a voxel.
typedef struct window {
    int64_t x, y;        // of the square's corner
    int64_t low, high;   // rows from y + low to y + high
    int64_t left, right; // how far rows go on either side, besides the element's half width
} window;

static window around_square(uint32_t x, uint32_t y, uint32_t size, const sf_element *e)
{
    int64_t more = (int64_t)size - 1;
    window w = {x, y, -(int64_t)e->reach_y, more + e->reach_y, 0, more};
    return w;
}

static window corners_for(uint32_t x, uint32_t y, uint32_t size, const sf_element *e)
{
    int64_t more = (int64_t)size - 1;
    window w = {x, y, -more - e->reach_y, e->reach_y, more, 0};
    return w;
}

// The part of row `dy` of a window that lies in a slice: x0 <= x < x1. Returns 0 where there is
// none.
static int window_row(const window *w, const sf_element *e, sf_slice s, int64_t dy, uint32_t *x0,
                      uint32_t *x1)
{
    int64_t inner_low = w->low + e->reach_y, inner_high = w->high - e->reach_y;
    int64_t away = dy < inner_low ? inner_low - dy : dy > inner_high ? dy - inner_high : 0;
    int64_t half = e->half_width[away], y = w->y + dy;
    int64_t from = w->x - w->left - half, to = w->x + w->right + half + 1;
    from = from > 0 ? from : 0;
    to = to < (int64_t)s.width ? to : (int64_t)s.width;
    if (y < 0 || y >= (int64_t)s.height || from >= to) {
        return 0;
    }
    *x0 = (uint32_t)from;
    *x1 = (uint32_t)to;
    return 1;
}

// Bits x0 <= x < x1 of word i of a row, as a mask.
static uint64_t part_mask(uint32_t x0, uint32_t x1, size_t i)
{
    uint64_t mask = i == x0 / 64 ? ~UINT64_C(0) << (x0 % 64) : ~UINT64_C(0);
    return i == (x1 - 1) / 64 ? mask & sfi_tail_mask(x1) : mask;
}

static uint32_t count_in(const window *w, const sf_element *e, sf_slice s)
{
    const sfi_kernels *kernels = sfi_kernels_get();
    uint32_t count = 0, x0, x1;
    for (int64_t dy = w->low; dy <= w->high; dy++) {
        if (!window_row(w, e, s, dy, &x0, &x1)) {
            continue;
        }
        const uint64_t *row = sfi_slice_row(s, (uint32_t)(w->y + dy));
        for (size_t i = x0 / 64; i <= (x1 - 1) / 64; i++) {
            uint64_t word = row[i] & part_mask(x0, x1, i);
            count += word != 0 ? (uint32_t)kernels->popcount(&word, 1) : 0;
        }
    }
    return count;
}

// Within a window: to |= from, or where `from` has no words, to = empty.
static void paint(const window *w, const sf_element *e, sf_slice to, sf_slice from)
{
    uint32_t x0, x1;
    for (int64_t dy = w->low; dy <= w->high; dy++) {
        if (!window_row(w, e, to, dy, &x0, &x1)) {
            continue;
        }
        uint32_t y = (uint32_t)(w->y + dy);
        uint64_t *row = sfi_slice_row(to, y);
        const uint64_t *in = from.words != NULL ? sfi_slice_row(from, y) : NULL;
        for (size_t i = x0 / 64; i <= (x1 - 1) / 64; i++) {
            uint64_t mask = part_mask(x0, x1, i);
            row[i] = in != NULL ? row[i] | (in[i] & mask) : row[i] & ~mask;
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Heap
// ---------------------------------------------------------------------------------------------

// Of equals the lowest row goes first, and in it the lowest x.
static int is_before(const offer *a, const offer *b)
{
    if (a->worth != b->worth) {
        return a->worth > b->worth;
    }
    return a->y != b->y ? a->y < b->y : a->x < b->x;
}

static void sink(heap *h, size_t i)
{
    offer o = h->offers[i];
    for (size_t child; (child = 2 * i + 1) < h->count; i = child) {
        child += child + 1 < h->count && is_before(&h->offers[child + 1], &h->offers[child]);
        if (!is_before(&h->offers[child], &o)) {
            break;
        }
        h->offers[i] = h->offers[child];
    }
    h->offers[i] = o;
}

static void drop_first(heap *h)
{
    h->offers[0] = h->offers[--h->count];
    if (h->count > 0) {
        sink(h, 0);
    }
}

static sf_status append(const strutter *t, heap *h, offer o)
{
    void *memory = h->offers;
    if (!sfi_grow_array(&t->places->in->allocator, &memory, &h->capacity, h->count + 1,
                        sizeof *h->offers)) {
        return SF_ERR_MEMORY;
    }
    h->offers = memory;
    h->offers[h->count++] = o;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// One layer
// ---------------------------------------------------------------------------------------------

static uint32_t carried_by(const strutter *t, uint32_t x, uint32_t y)
{
    window voxels = around_square(x, y, t->places->in->width, &t->element);
    window places = around_square(x, y, 1, &t->element);
    return count_in(&voxels, &t->element, t->s[OPEN_ASKED]) +
           count_in(&places, &t->element, t->s[OPEN_HANGING]);
}

// How much a place carries of what is open, for its price.
static offer offer_of(const strutter *t, uint32_t x, uint32_t y)
{
    uint64_t price = (uint64_t)t->places->price[sfi_place_at(t->places, t->k, x, y)];
    offer o = {((uint64_t)carried_by(t, x, y) << 44) / (price + 1), x, y};
    return o;
}

// Do something for each voxel of a slice.
static sf_status for_each(strutter *t, int of, sf_status (*act)(strutter *, uint32_t, uint32_t))
{
    sf_slice s = t->s[of];
    for (uint32_t y = 0; y < s.height; y++) {
        for (size_t i = 0; i < sfi_row_words(s.width); i++) {
            for (uint64_t word = sfi_slice_row(s, y)[i]; word != 0; word &= word - 1) {
                SF_TRY(act(t, (uint32_t)i * 64 + sfi_lowest_bit(word), y));
            }
        }
    }
    return SF_OK;
}

static sf_status offer_for_voxel(strutter *t, uint32_t x, uint32_t y)
{
    window w = corners_for(x, y, t->places->in->width, &t->element);
    paint(&w, &t->element, t->s[OFFERED], sf_grid_slice(t->places->in->places, t->k));
    return SF_OK;
}

static sf_status offer_for_place(strutter *t, uint32_t x, uint32_t y)
{
    window w = corners_for(x, y, 1, &t->element);
    paint(&w, &t->element, t->s[OFFERED], sf_grid_slice(t->places->in->places, t->k));
    return SF_OK;
}

static sf_status make_offer(strutter *t, uint32_t x, uint32_t y)
{
    return append(t, &t->heap, offer_of(t, x, y));
}

static void put(sf_slice s, uint32_t x, uint32_t y, int value)
{
    uint64_t bit = UINT64_C(1) << (x % 64), *word = &sfi_slice_row(s, y)[x / 64];
    *word = value ? *word | bit : *word & ~bit;
}

// Take offers, the best first, until nothing is open.
static sf_status take_offers(strutter *t)
{
    while (t->heap.count > 0) {
        offer top = t->heap.offers[0], now = offer_of(t, top.x, top.y);
        if (now.worth > 0 && now.worth < top.worth) {
            t->heap.offers[0] = now;
            sink(&t->heap, 0);
            continue;
        }
        drop_first(&t->heap);
        if (now.worth == 0) {
            continue;
        }
        window voxels = around_square(top.x, top.y, t->places->in->width, &t->element);
        window places = around_square(top.x, top.y, 1, &t->element);
        paint(&voxels, &t->element, t->s[OPEN_ASKED], (sf_slice){NULL, 0, 0, 0});
        paint(&places, &t->element, t->s[OPEN_HANGING], (sf_slice){NULL, 0, 0, 0});
        put(t->s[CHOSEN], top.x, top.y, 1);
        now.worth = (uint64_t)t->places->price[sfi_place_at(t->places, t->k, top.x, top.y)];
        SF_TRY(append(t, &t->taken, now));
    }
    int is_left = sfi_slice_any(t->s[OPEN_ASKED]) || sfi_slice_any(t->s[OPEN_HANGING]);
    return is_left ? SF_ERR_INTERNAL : SF_OK;
}

// Whether everything of a kind that a chosen place carries is carried by another one too.
static int is_spare_for(const strutter *t, const offer *o, int kind, uint32_t size)
{
    window w = around_square(o->x, o->y, size, &t->element);
    for (int64_t dy = w.low; dy <= w.high; dy++) {
        uint32_t x0, x1;
        if (!window_row(&w, &t->element, t->s[kind], dy, &x0, &x1)) {
            continue;
        }
        uint32_t y = (uint32_t)(w.y + dy);
        for (uint32_t x = x0; x < x1; x++) {
            if ((sfi_slice_row(t->s[kind], y)[x / 64] >> (x % 64) & 1) == 0) {
                continue;
            }
            window by = corners_for(x, y, size, &t->element);
            if (count_in(&by, &t->element, t->s[CHOSEN]) < 2) {
                return 0;
            }
        }
    }
    return 1;
}

// From the dearest on, leave out what is not needed.
static void spare(strutter *t)
{
    heap *h = &t->taken;
    for (size_t i = h->count / 2; i-- > 0;) {
        sink(h, i);
    }
    for (; h->count > 0; drop_first(h)) {
        const offer *o = &h->offers[0];
        if (is_spare_for(t, o, ASKED, t->places->in->width) && is_spare_for(t, o, HANGING, 1)) {
            put(t->s[CHOSEN], o->x, o->y, 0);
        }
    }
}

static sf_status force(strutter *t, uint32_t x, uint32_t y)
{
    t->places->state[sfi_place_at(t->places, t->k, x, y)] |= SFI_PLACE_FORCED;
    return SF_OK;
}

// Choose the places of layer t->k that carry what layer k + 1 asks.
static sf_status carry_layer(strutter *t)
{
    const sfi_interior *in = t->places->in;
    SF_TRY(sf_slice_subtract(t->s[ASKED], sf_grid_slice(in->wall, t->k + 1),
                             sf_grid_slice(in->held, t->k + 1)));
    SF_TRY(sf_slice_subtract(t->s[HANGING], t->s[CHOSEN], sf_grid_slice(in->rooted, t->k + 1)));
    SF_TRY(sf_slice_copy(t->s[OPEN_ASKED], t->s[ASKED]));
    SF_TRY(sf_slice_copy(t->s[OPEN_HANGING], t->s[HANGING]));
    sfi_slice_clear(t->s[OFFERED]);
    sfi_slice_clear(t->s[CHOSEN]);
    t->heap.count = t->taken.count = 0;
    SF_TRY(sf_rule_element(&in->plain, t->k, &t->element));
    SF_TRY(for_each(t, ASKED, offer_for_voxel));
    SF_TRY(for_each(t, HANGING, offer_for_place));
    SF_TRY(for_each(t, OFFERED, make_offer));
    for (size_t i = t->heap.count / 2; i-- > 0;) {
        sink(&t->heap, i);
    }
    SF_TRY(take_offers(t));
    spare(t);
    return for_each(t, CHOSEN, force);
}

static sf_status carry_all(strutter *t)
{
    const sfi_interior *in = t->places->in;
    for (uint32_t i = 0; i < t->places->count; i++) {
        t->places->state[i] = 0;
    }
    for (int i = 0; i < SLICES; i++) {
        sfi_slice_clear(t->s[i]);
    }
    for (t->k = in->lattice.nz - 1; t->k-- > in->bed;) {
        if (sf_task_is_cancelled(in->task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(carry_layer(t));
    }
    return SF_OK;
}

sf_status sfi_places_force(sfi_places *places)
{
    const sfi_interior *in = places->in;
    strutter t = {.places = places};
    size_t height = in->lattice.ny, stride = sf_slice_stride(in->lattice.nx);
    t.words = sfi_alloc_array(&in->allocator, SLICES * height, stride * sizeof(uint64_t));
    for (int i = 0; i < SLICES; i++) {
        t.s[i] = (sf_slice){t.words + (size_t)i * height * stride, in->lattice.nx, in->lattice.ny,
                            stride};
    }
    sf_status status = t.words != NULL ? carry_all(&t) : SF_ERR_MEMORY;
    sfi_free_array(&in->allocator, t.words, SLICES * height, stride * sizeof(uint64_t));
    sfi_free_array(&in->allocator, t.heap.offers, t.heap.capacity, sizeof *t.heap.offers);
    sfi_free_array(&in->allocator, t.taken.offers, t.taken.capacity, sizeof *t.taken.offers);
    return status;
}
