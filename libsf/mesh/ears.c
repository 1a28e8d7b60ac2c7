// SPDX-License-Identifier: MIT
// Contours that cross, filled ear by ear.
//
// A sweep needs contours that do not cross, and one crossing spoils all that comes after it.
// Cutting off ears is slow, but what goes wrong stays where it happens: a spot whose two neighbours
// see each other past it makes a triangle and leaves, and where there is no such spot the next one
// that turns left goes all the same. Each hole is joined first to a spot to the left of it that it
// sees, over a bridge that is walked both ways. Bodies that run through each other are tours of
// their own, and have triangles of their own.
//
// Whatever is cut off, an ear's three sides are two of the tour and one that takes their place, so
// that the boundary of all triangles is that of the contours. Work is bounded: when a number of
// looks is spent that depends on nothing but the contours, ears are cut without looking.
//
// Source: D. Eberly, "Triangulation by ear clipping", 2002 (bridges to the left).

#include "mesh/ears.h"

#include "base/memory.h"
#include "mesh/heap.h"

#include <string.h>

#define NOBODY UINT32_MAX
#define LOOKS (UINT64_C(1) << 28) // a second or two
enum { TRIES = 48 };              // spots that a hole looks at

typedef struct ears {
    const sfi_contour *contour;
    const sfi_spot *spots;
    uint32_t *spot, *next, *prev; // of nodes; those of bridges come last
    uint32_t *tour;               // the first spot's node of each node's tour
    uint32_t *holes;              // first nodes of tours that are holes, from left to right
    size_t node_count, node_capacity, hole_count;
    uint64_t looks; // that are left
    uint32_t *triangles;
    size_t triangle_count;
} ears;

static int turn_at(const ears *e, uint32_t node)
{
    return sfi_spot_turn(e->spots, e->spot[e->prev[node]], e->spot[node], e->spot[e->next[node]]);
}

static uint64_t spend(ears *e, uint64_t looks)
{
    e->looks -= looks < e->looks ? looks : e->looks;
    return e->looks;
}

// ---------------------------------------------------------------------------------------------
// Bridges
// ---------------------------------------------------------------------------------------------

// Whether two segments have a place in common; those that share an end do not count.
static int meet(const sfi_spot *spots, uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
    if (a == c || a == d || b == c || b == d) {
        return 0;
    }
    int c_side = sfi_spot_turn(spots, a, b, c), d_side = sfi_spot_turn(spots, a, b, d);
    int a_side = sfi_spot_turn(spots, c, d, a), b_side = sfi_spot_turn(spots, c, d, b);
    if (c_side == 0 && d_side == 0) { // on one line, numbers tell where
        uint32_t low = a < b ? a : b, high = a < b ? b : a;
        return (c > low && c < high) || (d > low && d < high) || (c < low && d > high) ||
               (d < low && c > high);
    }
    return c_side * d_side <= 0 && a_side * b_side <= 0;
}

static int looks_inside(const ears *e, uint32_t node, uint32_t spot)
{
    return sfi_spot_sooner(e->spots, e->spot[node], e->spot[e->next[node]], spot,
                           e->spot[e->prev[node]], 1);
}

static int is_visible(ears *e, uint32_t from, uint32_t to)
{
    uint32_t a = e->spot[from], b = e->spot[to];
    if (!looks_inside(e, from, b) || !looks_inside(e, to, a)) {
        return 0;
    }
    spend(e, e->contour->count);
    for (uint32_t i = 0; i < e->contour->count; i++) {
        if (meet(e->spots, a, b, e->contour->from[i], e->contour->from[e->contour->next[i]])) {
            return 0;
        }
    }
    for (size_t i = e->contour->count; i < e->node_count; i += 2) { // bridges
        if (meet(e->spots, a, b, e->spot[i], e->spot[i + 1])) {
            return 0;
        }
    }
    return 1;
}

static double distance(const ears *e, uint32_t a, uint32_t b)
{
    const sfi_spot *p = e->spots + e->spot[a], *q = e->spots + e->spot[b];
    double x = (double)(q->x - p->x), y = (double)(q->y - p->y);
    return x * x + y * y;
}

// Of the nodes of other tours to the left, the nearest beyond a distance and a node, or NOBODY.
static uint32_t nearest(ears *e, uint32_t hole, double beyond, uint32_t last)
{
    uint32_t best = NOBODY;
    double least = 0;
    spend(e, e->node_count);
    for (uint32_t i = 0; i < e->node_count; i++) {
        if (e->tour[i] == hole || e->spot[i] >= e->spot[hole]) {
            continue;
        }
        double far = distance(e, hole, i);
        int is_new = last == NOBODY || far > beyond || (far >= beyond && i > last);
        if (is_new && (best == NOBODY || far < least)) {
            best = i;
            least = far;
        }
    }
    return best;
}

// Walk from one node to the other and back: both tours are one then.
static void build_bridge(ears *e, uint32_t hole, uint32_t to)
{
    uint32_t p = (uint32_t)e->node_count++, q = (uint32_t)e->node_count++;
    for (uint32_t i = e->next[hole]; i != hole; i = e->next[i]) {
        e->tour[i] = e->tour[to];
    }
    e->spot[p] = e->spot[hole];
    e->spot[q] = e->spot[to];
    e->tour[hole] = e->tour[p] = e->tour[q] = e->tour[to];
    e->next[q] = e->next[to];
    e->prev[e->next[to]] = q;
    e->next[p] = q;
    e->prev[q] = p;
    e->prev[p] = e->prev[hole];
    e->next[e->prev[hole]] = p;
    e->next[to] = hole;
    e->prev[hole] = to;
}

static void join_hole(ears *e, uint32_t hole)
{
    uint32_t to = NOBODY;
    double beyond = 0;
    for (int i = 0; i < TRIES && e->looks > 0; i++) {
        to = nearest(e, hole, beyond, to);
        if (to == NOBODY) {
            return;
        }
        if (is_visible(e, hole, to)) {
            build_bridge(e, hole, to);
            return;
        }
        beyond = distance(e, hole, to);
    }
}

// ---------------------------------------------------------------------------------------------
// Ears
// ---------------------------------------------------------------------------------------------

static int covers(const ears *e, const uint32_t t[3], uint32_t spot, int way)
{
    return spot != t[0] && spot != t[1] && spot != t[2] &&
           way * sfi_spot_turn(e->spots, t[0], t[1], spot) >= 0 &&
           way * sfi_spot_turn(e->spots, t[1], t[2], spot) >= 0 &&
           way * sfi_spot_turn(e->spots, t[2], t[0], spot) >= 0;
}

// Whether nothing of the tour lies in the ear at a node. What turns as the ear does cannot be the
// only thing that does.
static int is_ear(ears *e, uint32_t node, int way)
{
    const uint32_t t[3] = {e->spot[e->prev[node]], e->spot[node], e->spot[e->next[node]]};
    if (way * turn_at(e, node) <= 0) {
        return 0;
    }
    uint64_t looks = 0;
    for (uint32_t i = e->next[e->next[node]]; i != e->prev[node]; i = e->next[i], looks++) {
        if (covers(e, t, e->spot[i], way) && way * turn_at(e, i) <= 0) {
            spend(e, looks);
            return 0;
        }
    }
    spend(e, looks);
    return 1;
}

static void leave(ears *e, uint32_t node)
{
    e->next[e->prev[node]] = e->next[node];
    e->prev[e->next[node]] = e->prev[node];
}

static void cut_off(ears *e, uint32_t node)
{
    uint32_t *to = e->triangles + 3 * e->triangle_count++;
    to[0] = e->spot[e->prev[node]];
    to[1] = e->spot[node];
    to[2] = e->spot[e->next[node]];
    leave(e, node);
}

// A step that leads nowhere, or back where one came from, needs no triangle.
static int is_idle(const ears *e, uint32_t node)
{
    uint32_t before = e->spot[e->prev[node]], at = e->spot[node], after = e->spot[e->next[node]];
    return at == after || before == after;
}

// The next ear from a node on; where there is none the next node that turns so, or any.
static uint32_t find_ear(ears *e, uint32_t from, size_t count, int way)
{
    uint32_t second = NOBODY;
    for (size_t i = 0; i < count; i++, from = e->next[from]) {
        if (is_idle(e, from) || (e->looks > 0 && is_ear(e, from, way))) {
            return from;
        }
        if (second == NOBODY && way * turn_at(e, from) > 0) {
            second = from;
            if (e->looks == 0) {
                break;
            }
        }
    }
    return second != NOBODY ? second : from;
}

static void fill_tour(ears *e, uint32_t node, size_t count, int way)
{
    while (count > 2) {
        uint32_t ear = find_ear(e, node, count, way), after = e->next[ear];
        if (is_idle(e, ear)) {
            leave(e, ear);
        } else {
            cut_off(e, ear);
        }
        node = e->next[after]; // not the same spot over and over
        count--;
    }
}

// ---------------------------------------------------------------------------------------------
// Tours
// ---------------------------------------------------------------------------------------------

static int hole_before(const void *user, uint32_t a, uint32_t b)
{
    const ears *e = user;
    return e->spot[a] != e->spot[b] ? e->spot[a] < e->spot[b] : a < b;
}

// Name each tour by its first node, and find those that have their inside around them.
static void find_tours(ears *e)
{
    const sfi_contour *c = e->contour;
    memset(e->tour, 0xff, e->node_capacity * sizeof *e->tour);
    for (uint32_t i = 0; i < c->count; i++) {
        uint32_t first = i, node = i;
        if (e->tour[i] != NOBODY) {
            continue;
        }
        do {
            first = c->from[node] < c->from[first] ? node : first;
            node = c->next[node];
        } while (node != i);
        do {
            e->tour[node] = first;
            node = c->next[node];
        } while (node != i);
        if (sfi_contour_kind(c, first) == SFI_NODE_SPLIT) {
            e->holes[e->hole_count++] = first;
        }
    }
    sfi_heap_sort(e->holes, e->hole_count, hole_before, e);
}

static void fill(ears *e)
{
    for (size_t i = 0; i < e->hole_count; i++) {
        join_hole(e, e->holes[i]);
    }
    for (uint32_t i = 0; i < e->contour->count; i++) {
        size_t count = 0;
        uint32_t node = i;
        if (e->tour[i] != i) { // not the first of its tour, which was joined or is another
            continue;
        }
        do {
            count++;
            node = e->next[node];
        } while (node != i);
        fill_tour(e, i, count, sfi_contour_kind(e->contour, i) == SFI_NODE_SPLIT ? -1 : 1);
    }
}

sf_status sfi_ears_fill(const sfi_contour *c, const sf_allocator *allocator, uint32_t *triangles,
                        size_t *triangle_count)
{
    ears e = {.contour = c, .spots = c->spots, .triangles = triangles, .looks = LOOKS};
    if (!sfi_size_mul(c->count, 3, &e.node_capacity)) {
        return SF_ERR_OVERFLOW;
    }
    e.spot = sfi_alloc_array(allocator, e.node_capacity, sizeof *e.spot);
    e.next = sfi_alloc_array(allocator, e.node_capacity, sizeof *e.next);
    e.prev = sfi_alloc_array(allocator, e.node_capacity, sizeof *e.prev);
    e.tour = sfi_alloc_array(allocator, e.node_capacity, sizeof *e.tour);
    e.holes = sfi_alloc_array(allocator, c->count, sizeof *e.holes);
    int enough =
        e.spot != NULL && e.next != NULL && e.prev != NULL && e.tour != NULL && e.holes != NULL;
    if (enough) {
        e.node_count = c->count;
        memcpy(e.spot, c->from, c->count * sizeof *e.spot);
        memcpy(e.next, c->next, c->count * sizeof *e.next);
        memcpy(e.prev, c->prev, c->count * sizeof *e.prev);
        find_tours(&e);
        fill(&e);
        *triangle_count = e.triangle_count;
    }
    sfi_free_array(allocator, e.spot, e.node_capacity, sizeof *e.spot);
    sfi_free_array(allocator, e.next, e.node_capacity, sizeof *e.next);
    sfi_free_array(allocator, e.prev, e.node_capacity, sizeof *e.prev);
    sfi_free_array(allocator, e.tour, e.node_capacity, sizeof *e.tour);
    sfi_free_array(allocator, e.holes, c->count, sizeof *e.holes);
    return enough ? SF_OK : SF_ERR_MEMORY;
}
