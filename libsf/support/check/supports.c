// SPDX-License-Identifier: MIT
// Supports: a set of voxels that carries a region, small and found fast.
//
// From the region downwards, layer by layer: what needs to be carried is covered by places of the
// layer below; those places that nothing carries yet are what needs to be carried next. It ends
// because every place that is taken has a price, so one below it has a lower one. Chains that meet
// are one from there on: that is why a set is found for the region as a whole, and not a path for
// each voxel.
//
// The least cover is a hard problem (ALGORITHMS 1.5), and the least set over all layers is harder.
// Greedy: take the place with the lowest price for each voxel that it carries. For a set of one
// voxel that is the lowest price, so a region of one voxel costs exactly its closest supporting
// path. Of equal places the one that carries more goes first, then the one closer to the middle of
// the region, so that chains far above everything run towards each other instead of side by side;
// then the first in row order. The order is total, so the result is one and the same everywhere.
//
// What a place carries only shrinks while others are taken. So places lie in a heap under the
// number that they had when they were last counted; the first is counted again, and is taken if
// that changed nothing.
//
// What needs to be carried is kept twice: as bits, which are asked, and as runs, which are walked.
// Places are looked for around the runs, a word at a time, so that a long thin region costs what it
// is long, and not the rectangle around it.
//
// Source: V. Chvatal, "A Greedy Heuristic for the Set-Covering Problem", 1979; counting late is M.
// Minoux, "Accelerated greedy algorithms for maximizing submodular set functions", 1978.

#include "support/check/supports.h"

#include "base/bits.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

#include <sf/finding.h>

// ---------------------------------------------------------------------------------------------
// Windows of bits
// ---------------------------------------------------------------------------------------------

static uint32_t grown(uint32_t at, uint32_t by, uint32_t end)
{
    return end - at > by ? at + by : end;
}

static uint32_t shrunk(uint32_t at, uint32_t by)
{
    return at > by ? at - by : 0;
}

// The rows of `slice` that an element around (x, y) meets, and in row `row` its columns.
static sf_rect window(sf_slice slice, uint32_t x, uint32_t y, const sf_element *e)
{
    sf_rect rect = {x, shrunk(y, e->reach_y), x, grown(y, e->reach_y + 1u, slice.height)};
    return rect;
}

static void columns(sf_slice slice, uint32_t x, uint32_t y, uint32_t row, const sf_element *e,
                    uint32_t *x0, uint32_t *x1)
{
    uint32_t w = e->half_width[row > y ? row - y : y - row];
    *x0 = shrunk(x, w);
    *x1 = grown(x, w + 1u, slice.width);
}

// The bits of word i that lie in x0 <= x < x1.
static uint64_t within(size_t i, uint32_t x0, uint32_t x1)
{
    uint32_t first = (uint32_t)(64 * i);
    uint64_t mask = ~UINT64_C(0);
    if (x0 > first) {
        mask &= mask << (x0 - first);
    }
    return x1 < first + 64 ? mask & (((uint64_t)1 << (x1 - first)) - 1) : mask;
}

static uint32_t count_bits(uint64_t w)
{
    uint32_t count = 0;
    for (; w != 0; w &= w - 1) {
        count++;
    }
    return count;
}

// Voxels of `need` that (x, y) carries; `take` clears them.
static uint32_t carried_by(sf_slice need, uint32_t x, uint32_t y, const sf_element *e, int take)
{
    sf_rect rect = window(need, x, y, e);
    uint32_t sum = 0;
    for (uint32_t row = rect.y0; row < rect.y1; row++) {
        uint32_t x0, x1;
        uint64_t *words = sfi_slice_row(need, row);
        columns(need, x, y, row, e, &x0, &x1);
        for (size_t i = x0 / 64; i <= (x1 - 1) / 64; i++) {
            uint64_t mask = within(i, x0, x1);
            sum += count_bits(words[i] & mask);
            words[i] &= take ? ~mask : ~UINT64_C(0);
        }
    }
    return sum;
}

// ---------------------------------------------------------------------------------------------
// Places
// ---------------------------------------------------------------------------------------------

static int is_better(const sfi_support_place *a, const sfi_support_place *b)
{
    uint64_t p = (uint64_t)a->price * b->covers, q = (uint64_t)b->price * a->covers;
    if (p != q) {
        return p < q;
    }
    if (a->covers != b->covers) {
        return a->covers > b->covers;
    }
    if (a->away != b->away) {
        return a->away < b->away;
    }
    return a->y != b->y ? a->y < b->y : a->x < b->x;
}

// Let place i sink to where it belongs.
static void sink(sfi_support_place *places, size_t count, size_t i)
{
    sfi_support_place moving = places[i];
    for (;;) {
        size_t child = 2 * i + 1;
        if (child >= count) {
            break;
        }
        if (child + 1 < count && is_better(&places[child + 1], &places[child])) {
            child++;
        }
        if (!is_better(&places[child], &moving)) {
            break;
        }
        places[i] = places[child];
        i = child;
    }
    places[i] = moving;
}

// Distance of a place to the middle of a rectangle, in half voxels, the longer axis first.
static uint32_t away_from(const sf_rect *region, uint32_t x, uint32_t y)
{
    uint32_t mx = region->x0 + region->x1 - 1, my = region->y0 + region->y1 - 1;
    uint32_t dx = 2 * x > mx ? 2 * x - mx : mx - 2 * x, dy = 2 * y > my ? 2 * y - my : my - 2 * y;
    return dx > dy ? dx : dy;
}

static int grow(sfi_supports *s, void **memory, size_t *capacity, size_t need, size_t size)
{
    return sfi_grow_array(&s->allocator, memory, capacity, need, size);
}

// The places of word i of row y of layer k whose bits are given.
static sf_status add_places(sfi_supports *s, uint32_t k, uint32_t y, size_t i, uint64_t bits,
                            const sf_element *e, const sf_rect *region)
{
    const uint16_t *prices = sfi_price_map_row(s->prices, k, y);
    for (; bits != 0; bits &= bits - 1) {
        uint32_t x = (uint32_t)(64 * i) + sfi_lowest_bit(bits);
        if (prices[x] == SFI_PRICE_MAP_NONE) {
            continue;
        }
        if (!grow(s, (void **)&s->places, &s->capacity, s->count + 1, sizeof *s->places)) {
            return SF_ERR_MEMORY;
        }
        sfi_support_place place = {x, y, prices[x], carried_by(s->need, x, y, e, 0),
                                   away_from(region, x, y)};
        s->places[s->count++] = place;
    }
    return SF_OK;
}

// The places around a run that are not marked as seen; `see`: mark them, else take the mark away.
static sf_status look_around(sfi_supports *s, uint32_t k, const sf_run *run, const sf_element *e,
                             const sf_rect *region, int see)
{
    sf_rect rows = window(s->seen, run->x0, run->y, e);
    for (uint32_t y = rows.y0; y < rows.y1; y++) {
        uint32_t w = e->half_width[y > run->y ? y - run->y : run->y - y];
        uint32_t x0 = shrunk(run->x0, w), x1 = grown(run->x1, w, s->seen.width);
        uint64_t *seen = sfi_slice_row(s->seen, y);
        for (size_t i = x0 / 64; i <= (x1 - 1) / 64; i++) {
            uint64_t mask = within(i, x0, x1);
            if (see) {
                SF_TRY(add_places(s, k, y, i, mask & ~seen[i], e, region));
                seen[i] |= mask;
            } else {
                seen[i] &= ~mask;
            }
        }
    }
    return SF_OK;
}

// All places of layer k that carry something of what is asked for, as a heap.
static sf_status find_places(sfi_supports *s, uint32_t k, const sf_element *e,
                             const sf_rect *region)
{
    const sfi_support_runs *asked = &s->asked;
    s->count = 0;
    for (size_t i = 0; i < asked->count; i++) {
        SF_TRY(look_around(s, k, &asked->runs[i], e, region, 1));
    }
    for (size_t i = 0; i < asked->count; i++) {
        SF_TRY(look_around(s, k, &asked->runs[i], e, region, 0));
    }
    for (size_t i = s->count / 2; i-- > 0;) {
        sink(s->places, s->count, i);
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Layers
// ---------------------------------------------------------------------------------------------

// Ask for a run of the layer below.
static sf_status ask(sfi_supports *s, sfi_support_runs *list, sf_slice slice, const sf_run *run)
{
    if (!grow(s, (void **)&list->runs, &list->capacity, list->count + 1, sizeof *list->runs)) {
        return SF_ERR_MEMORY;
    }
    list->runs[list->count++] = *run;
    for (size_t i = run->x0 / 64; i <= (run->x1 - 1) / 64; i++) {
        sfi_slice_row(slice, run->y)[i] |= within(i, run->x0, run->x1);
    }
    return SF_OK;
}

// Take a place of layer k.
static sf_status take_place(sfi_supports *s, uint32_t k, const sf_element *e,
                            const sfi_support_place *place)
{
    sf_run run = {place->x, place->x + 1, place->y, 0};
    (void)carried_by(s->need, place->x, place->y, e, 1);
    if (s->added != NULL) {
        SF_TRY(sf_slice_set(sf_grid_slice(s->added, k), place->x, place->y, 1));
    }
    return place->price > 1 ? ask(s, &s->next_asked, s->next, &run) : SF_OK;
}

// Take places of layer k until all is carried, and ask for what nothing carries of them. *taken is
// how many.
static sf_status take_places(sfi_supports *s, uint32_t k, const sf_element *e, uint64_t *taken)
{
    *taken = 0;
    while (s->count > 0) {
        sfi_support_place *best = &s->places[0];
        uint32_t covers = carried_by(s->need, best->x, best->y, e, 0);
        if (covers == best->covers) {
            SF_TRY(take_place(s, k, e, best));
            ++*taken;
            covers = 0;
        }
        best->covers = covers;
        if (covers == 0) {
            *best = s->places[--s->count];
        }
        if (s->count > 0) {
            sink(s->places, s->count, 0);
        }
    }
    return SF_OK;
}

// Whether each voxel of a run has a place below it that can be had.
static int can_carry(const sfi_supports *s, uint32_t k, const sf_run *run, const sf_element *e)
{
    for (uint32_t x = run->x0; x < run->x1; x++) {
        sf_rect rect = window(s->need, x, run->y, e);
        int found = 0;
        for (uint32_t row = rect.y0; row < rect.y1 && !found; row++) {
            const uint16_t *prices = sfi_price_map_row(s->prices, k, row);
            uint32_t x0, x1;
            for (columns(s->need, x, run->y, row, e, &x0, &x1); x0 < x1 && !found; x0++) {
                found = prices[x0] != SFI_PRICE_MAP_NONE;
            }
        }
        if (!found) {
            return 0;
        }
    }
    return 1;
}

static int can_carry_all(const sfi_supports *s, uint32_t k, const sf_run *runs, size_t count,
                         const sf_element *e)
{
    for (size_t i = 0; i < count; i++) {
        if (!can_carry(s, k, &runs[i], e)) {
            return 0;
        }
    }
    return 1;
}

// What the layer below is asked for becomes what is asked for.
static void turn(sfi_supports *s)
{
    sf_slice need = s->need;
    sfi_support_runs asked = s->asked;
    s->need = s->next;
    s->next = need;
    s->asked = s->next_asked;
    s->next_asked = asked;
    s->next_asked.count = 0;
}

// Cover what is asked for, from layer k down.
static sf_status descend(sfi_supports *s, uint32_t k, const sf_rect *region, uint64_t *cost)
{
    sf_element element;
    uint64_t sum = 0, taken;
    for (uint32_t layer = k; s->asked.count > 0; layer--) {
        SF_TRY(sfi_price_map_element(s->rule, layer, &element));
        SF_TRY(find_places(s, layer, &element, region));
        SF_TRY(take_places(s, layer, &element, &taken));
        turn(s);
        sum += taken;
    }
    *cost = sum;
    return SF_OK;
}

sf_status sfi_supports_find(sfi_supports *s, uint32_t k, const sf_run *runs, size_t count,
                            uint64_t *cost)
{
    sf_rect region = {0, 0, 0, 0};
    sf_element element;
    *cost = SF_COST_NONE;
    if (k <= s->prices->bed) {
        return SF_OK;
    }
    SF_TRY(sfi_price_map_element(s->rule, k - 1, &element));
    if (!can_carry_all(s, k - 1, runs, count, &element)) {
        return SF_OK;
    }
    for (size_t i = 0; i < count; i++) {
        sf_rect run = {runs[i].x0, runs[i].y, runs[i].x1, runs[i].y + 1};
        region = sfi_rect_union(region, run);
        SF_TRY(ask(s, &s->asked, s->need, &runs[i]));
    }
    return descend(s, k - 1, &region, cost);
}

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

static sf_slice make_slice(const sf_lattice *lattice, const sf_allocator *allocator)
{
    sf_slice slice = {NULL, lattice->nx, lattice->ny, sfi_row_words(lattice->nx)};
    size_t count;
    if (sfi_size_mul(slice.stride, slice.height, &count)) {
        slice.words = sfi_alloc_array(allocator, count, sizeof *slice.words);
    }
    for (size_t i = 0; slice.words != NULL && i < count; i++) {
        slice.words[i] = 0;
    }
    return slice;
}

sf_status sfi_supports_create(sfi_supports *s, const sf_rule *rule, const sfi_price_map *prices,
                              const sf_lattice *lattice, const sf_allocator *allocator,
                              sf_grid *added)
{
    sfi_supports made = {.rule = rule, .prices = prices, .allocator = *allocator, .added = added};
    made.need = make_slice(lattice, allocator);
    made.next = make_slice(lattice, allocator);
    made.seen = make_slice(lattice, allocator);
    *s = made;
    if (made.need.words == NULL || made.next.words == NULL || made.seen.words == NULL) {
        sfi_supports_destroy(s);
        return SF_ERR_MEMORY;
    }
    return SF_OK;
}

static void free_slice(const sf_allocator *allocator, sf_slice *slice)
{
    sfi_free_array(allocator, slice->words, slice->stride * slice->height, sizeof *slice->words);
    slice->words = NULL;
}

static void free_runs(const sf_allocator *allocator, sfi_support_runs *list)
{
    sfi_free_array(allocator, list->runs, list->capacity, sizeof *list->runs);
    list->runs = NULL;
    list->capacity = list->count = 0;
}

void sfi_supports_destroy(sfi_supports *s)
{
    const sf_allocator *a = &s->allocator;
    free_slice(a, &s->need);
    free_slice(a, &s->next);
    free_slice(a, &s->seen);
    free_runs(a, &s->asked);
    free_runs(a, &s->next_asked);
    sfi_free_array(a, s->places, s->capacity, sizeof *s->places);
    s->places = NULL;
    s->capacity = 0;
}
