// SPDX-License-Identifier: MIT
// Triangles that fill contours in a plane.
//
// Diagonals (sweep.c) cut the inside into pieces. A piece is walked by going on, at each node, with
// the edge or diagonal that comes next to the right of where one came from within the node's own
// sector. So whatever the diagonals are, each side of each of them, and each edge, is walked once:
// pieces are closed, and triangles that fill each piece fill the whole, with the edges for their
// boundary. That is what keeps a cut mesh closed, and it needs no geometry at all. Geometry decides
// only whether the triangles lie side by side: they do where all of them turn to the left, and that
// is looked at. Where one does not, contours cross, as those of solids that run through each other
// do, or all is inside out; then all is filled again, turned, or in another way (ears.c).
//
// Source: M. R. Garey, D. S. Johnson, F. P. Preparata, R. E. Tarjan, "Triangulating a simple
// polygon", 1978 (monotone pieces). That no triangle is flat: a vertex that is seen along the line
// of two on the stack would lie behind an edge that it is joined by.

#include "mesh/cap.h"

#include "base/memory.h"
#include "base/status.h"
#include "mesh/ears.h"
#include "mesh/heap.h"
#include "mesh/sweep.h"

#include <string.h>

// What one filling needs. Ways are edges, then diagonals there and back.
typedef struct cap {
    const sf_allocator *allocator;
    const sfi_contour *contour;
    sfi_diagonal *diagonals;
    size_t diagonal_count, diagonal_capacity, way_capacity;
    uint32_t *ends;   // of each node's diagonals in `fan`
    uint32_t *fan;    // ways out of nodes over diagonals, those of a node turning left
    uint32_t *onward; // the way after each way, NOBODY once it was walked
    uint32_t *piece;  // spots of one piece
    uint32_t *sorted; // its places from left to right
    uint32_t *stack;  // scratch
    uint32_t *triangles;
    size_t triangle_count, turned_count;
} cap;

#define NOBODY UINT32_MAX

// ---------------------------------------------------------------------------------------------
// Pieces
// ---------------------------------------------------------------------------------------------

static uint32_t way_from(const cap *c, uint32_t way)
{
    if (way < c->contour->count) {
        return way;
    }
    size_t i = way - c->contour->count;
    return i % 2 == 0 ? c->diagonals[i / 2].a : c->diagonals[i / 2].b;
}

// Diagonals are paired: a way there has an even number, its way back the next.
static uint32_t way_back(const cap *c, uint32_t way)
{
    uint32_t count = (uint32_t)c->contour->count;
    return count + ((way - count) ^ 1);
}

static uint32_t way_spot(const cap *c, uint32_t way)
{
    return c->contour->from[way_from(c, way)];
}

static uint32_t way_end(const cap *c, uint32_t way)
{
    return way < c->contour->count ? c->contour->from[c->contour->next[way]]
                                   : way_spot(c, way_back(c, way));
}

// Put the diagonals of a node in the order in which they are met when turning left from its edge.
static void order_fan(cap *c, uint32_t node)
{
    uint32_t first = node == 0 ? 0 : c->ends[node - 1], end = c->ends[node];
    uint32_t at = c->contour->from[node], edge = c->contour->from[c->contour->next[node]];
    for (uint32_t i = first + 1; i < end; i++) {
        uint32_t way = c->fan[i], j = i;
        while (j > first && sfi_spot_sooner(c->contour->spots, at, edge, way_end(c, way),
                                            way_end(c, c->fan[j - 1]), 1)) {
            c->fan[j] = c->fan[j - 1];
            j--;
        }
        c->fan[j] = way;
    }
}

static void collect_fans(cap *c)
{
    size_t nodes = c->contour->count, ways = nodes + 2 * c->diagonal_count;
    uint32_t sum = 0;
    memset(c->ends, 0, nodes * sizeof *c->ends);
    for (size_t way = nodes; way < ways; way++) {
        c->ends[way_from(c, (uint32_t)way)]++;
    }
    for (size_t node = 0; node < nodes; node++) {
        uint32_t count = c->ends[node];
        c->ends[node] = sum;
        sum += count;
    }
    for (size_t way = nodes; way < ways; way++) {
        c->fan[c->ends[way_from(c, (uint32_t)way)]++] = (uint32_t)way;
    }
}

static void link_ways(cap *c)
{
    collect_fans(c);
    for (uint32_t node = 0; node < c->contour->count; node++) {
        uint32_t last = node; // the way out that is to the right of the next way in
        order_fan(c, node);
        for (uint32_t i = node == 0 ? 0 : c->ends[node - 1]; i < c->ends[node]; i++) {
            c->onward[way_back(c, c->fan[i])] = last;
            last = c->fan[i];
        }
        c->onward[c->contour->prev[node]] = last;
    }
}

// Walk a piece once. Steps that lead nowhere are left out.
static size_t walk(cap *c, uint32_t way)
{
    size_t count = 0;
    while (c->onward[way] != NOBODY) {
        uint32_t spot = way_spot(c, way), next = c->onward[way];
        if (count == 0 || c->piece[count - 1] != spot) {
            c->piece[count++] = spot;
        }
        c->onward[way] = NOBODY;
        way = next;
    }
    while (count > 1 && c->piece[0] == c->piece[count - 1]) {
        count--;
    }
    return count;
}

// ---------------------------------------------------------------------------------------------
// Triangles
// ---------------------------------------------------------------------------------------------

static void put_triangle(cap *c, uint32_t a, uint32_t b, uint32_t d)
{
    uint32_t *to = c->triangles + 3 * c->triangle_count++;
    to[0] = a;
    to[1] = b;
    to[2] = d;
    c->turned_count += sfi_spot_turn(c->contour->spots, a, b, d) < 0;
}

// Places of a piece from left to right, `sorted`, those of its upper side with their top bit set.
// Returns 0 where the piece is not monotone.
#define UPPER (UINT32_C(1) << 31)
static int sort_piece(cap *c, size_t count)
{
    size_t low = 0, high = 0, below, above, made = 0;
    for (size_t i = 1; i < count; i++) {
        low = c->piece[i] < c->piece[low] ? i : low;
        high = c->piece[i] > c->piece[high] ? i : high;
    }
    below = (low + 1) % count;
    above = (low + count - 1) % count;
    c->sorted[made++] = (uint32_t)low;
    while (below != high || above != high) {
        int is_upper = below == high || (above != high && c->piece[above] < c->piece[below]);
        size_t *from = is_upper ? &above : &below;
        if (c->piece[*from] <= c->piece[c->sorted[made - 1] & ~UPPER]) {
            return 0;
        }
        c->sorted[made++] = (uint32_t)*from | (is_upper ? UPPER : 0);
        *from = (*from + (is_upper ? count - 1 : 1)) % count;
    }
    c->sorted[made++] = (uint32_t)high;
    return made == count;
}

static uint32_t spot_of(const cap *c, uint32_t sorted)
{
    return c->piece[sorted & ~UPPER];
}

// Triangles between a place and two of the stack, the older first.
static void put_seen(cap *c, uint32_t older, uint32_t newer, uint32_t seer, int is_upper)
{
    uint32_t a = spot_of(c, older), b = spot_of(c, newer), v = spot_of(c, seer);
    if (is_upper) {
        put_triangle(c, a, b, v);
    } else {
        put_triangle(c, a, v, b);
    }
}

// What stands on the stack is a chain that bends away from the inside, seen whole from the other
// side, and from its own only where it bends towards it.
static void fill_monotone(cap *c, size_t count)
{
    size_t height = 2;
    c->stack[0] = c->sorted[0];
    c->stack[1] = c->sorted[1];
    for (size_t i = 2; i < count; i++) {
        uint32_t seer = c->sorted[i], top = c->stack[height - 1];
        int stack_upper = (top & UPPER) != 0, last = i + 1 == count;
        int is_upper = last ? !stack_upper : (seer & UPPER) != 0;
        if (is_upper != stack_upper) {
            for (size_t k = 0; k + 1 < height; k++) {
                put_seen(c, c->stack[k], c->stack[k + 1], seer, is_upper);
            }
            c->stack[0] = top;
            height = 1;
        } else {
            while (height > 1) {
                uint32_t older = c->stack[height - 2];
                int turn = sfi_spot_turn(c->contour->spots, spot_of(c, older),
                                         spot_of(c, c->stack[height - 1]), spot_of(c, seer));
                if (is_upper ? turn >= 0 : turn <= 0) {
                    break;
                }
                put_seen(c, older, c->stack[--height], seer, !is_upper);
            }
        }
        c->stack[height++] = seer;
    }
}

static void fill_piece(cap *c, size_t count)
{
    if (count > 3 && sort_piece(c, count)) {
        fill_monotone(c, count);
        return;
    }
    for (size_t i = 2; i < count; i++) { // where contours cross, or one triangle
        put_triangle(c, c->piece[0], c->piece[i - 1], c->piece[i]);
    }
}

// ---------------------------------------------------------------------------------------------
// Fillings
// ---------------------------------------------------------------------------------------------

static void release(cap *c)
{
    const sf_allocator *from = c->allocator;
    size_t nodes = c->contour->count, ways = c->way_capacity;
    sfi_free_array(from, c->diagonals, c->diagonal_capacity, sizeof *c->diagonals);
    sfi_free_array(from, c->ends, nodes, sizeof *c->ends);
    sfi_free_array(from, c->fan, ways, sizeof *c->fan);
    sfi_free_array(from, c->onward, ways, sizeof *c->onward);
    sfi_free_array(from, c->piece, ways, sizeof *c->piece);
    sfi_free_array(from, c->sorted, ways, sizeof *c->sorted);
    sfi_free_array(from, c->stack, ways, sizeof *c->stack);
}

static int reserve(cap *c)
{
    const sf_allocator *from = c->allocator;
    size_t nodes = c->contour->count;
    if (!sfi_size_mul(nodes, SFI_DIAGONALS_PER_NODE, &c->diagonal_capacity) ||
        !sfi_size_mul(nodes, SFI_CAP_TRIANGLES_PER_EDGE, &c->way_capacity) ||
        c->way_capacity >= UPPER) {
        return 0;
    }
    size_t ways = c->way_capacity;
    c->diagonals = sfi_alloc_array(from, c->diagonal_capacity, sizeof *c->diagonals);
    c->ends = sfi_alloc_array(from, nodes, sizeof *c->ends);
    c->fan = sfi_alloc_array(from, ways, sizeof *c->fan);
    c->onward = sfi_alloc_array(from, ways, sizeof *c->onward);
    c->piece = sfi_alloc_array(from, ways, sizeof *c->piece);
    c->sorted = sfi_alloc_array(from, ways, sizeof *c->sorted);
    c->stack = sfi_alloc_array(from, ways, sizeof *c->stack);
    return c->diagonals != NULL && c->ends != NULL && c->fan != NULL && c->onward != NULL &&
           c->piece != NULL && c->sorted != NULL && c->stack != NULL;
}

// Append the triangles that fill linked contours; how many turn to the right.
static sf_status fill(const sfi_contour *contour, const sf_allocator *allocator,
                      uint32_t *triangles, size_t *count, size_t *turned)
{
    cap c = {.allocator = allocator, .contour = contour, .triangles = triangles};
    sf_status status = reserve(&c) ? SF_OK : SF_ERR_MEMORY;
    if (status == SF_OK) {
        status = sfi_sweep_diagonals(contour, allocator, c.diagonals, &c.diagonal_count);
    }
    if (status == SF_OK) {
        link_ways(&c);
        for (uint32_t way = 0; way < contour->count + 2 * c.diagonal_count; way++) {
            fill_piece(&c, walk(&c, way));
        }
        *count = c.triangle_count;
        *turned = c.turned_count;
    }
    release(&c);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Spots from left to right
// ---------------------------------------------------------------------------------------------

static int lies_before(const void *user, uint32_t a, uint32_t b)
{
    const sfi_spot *p = (const sfi_spot *)user + a, *q = (const sfi_spot *)user + b;
    if (p->x != q->x) {
        return p->x < q->x;
    }
    return p->y != q->y ? p->y < q->y : a < b;
}

// What stands where, in the order of the sweep.
typedef struct table {
    sfi_spot *spots;
    uint32_t *order, *rank, *edges;
} table;

static void sort_spots(const sfi_spot *spots, size_t spot_count, const uint32_t *edges,
                       size_t edge_count, table *t)
{
    for (size_t i = 0; i < spot_count; i++) {
        t->order[i] = (uint32_t)i;
    }
    sfi_heap_sort(t->order, spot_count, lies_before, spots);
    for (size_t i = 0; i < spot_count; i++) {
        t->spots[i] = spots[t->order[i]];
        t->rank[t->order[i]] = (uint32_t)i;
    }
    for (size_t i = 0; i < 2 * edge_count; i++) {
        t->edges[i] = t->rank[edges[i]];
    }
}

// The other way around: what is inside out has its triangles as it should have, turned.
static sf_status fill_turned(const table *t, size_t spot_count, size_t edge_count,
                             const sf_allocator *allocator, uint32_t *triangles, size_t *count,
                             size_t *turned)
{
    sfi_contour contour;
    for (size_t i = 0; i < edge_count; i++) {
        uint32_t kept = t->edges[2 * i];
        t->edges[2 * i] = t->edges[2 * i + 1];
        t->edges[2 * i + 1] = kept;
    }
    SF_TRY(sfi_contour_create(t->spots, spot_count, t->edges, edge_count, allocator, &contour));
    sf_status status = fill(&contour, allocator, triangles, count, turned);
    sfi_contour_destroy(&contour, allocator);
    for (size_t i = 0; status == SF_OK && i < *count; i++) {
        uint32_t kept = triangles[3 * i + 1];
        triangles[3 * i + 1] = triangles[3 * i + 2];
        triangles[3 * i + 2] = kept;
    }
    return status;
}

static sf_status fill_table(const table *t, size_t spot_count, size_t edge_count,
                            const sf_allocator *allocator, uint32_t *triangles, size_t *count)
{
    sfi_contour contour;
    size_t turned = 0;
    SF_TRY(sfi_contour_create(t->spots, spot_count, t->edges, edge_count, allocator, &contour));
    sf_status status = fill(&contour, allocator, triangles, count, &turned);
    if (status == SF_OK && turned > 0) {
        status = fill_turned(t, spot_count, edge_count, allocator, triangles, count, &turned);
    }
    if (status == SF_OK && turned > 0) {
        status = sfi_ears_fill(&contour, allocator, triangles, count);
    }
    sfi_contour_destroy(&contour, allocator);
    for (size_t i = 0; status == SF_OK && i < 3 * *count; i++) {
        triangles[i] = t->order[triangles[i]];
    }
    return status;
}

sf_status sfi_cap_fill(const sfi_spot *spots, size_t spot_count, const uint32_t *edges,
                       size_t edge_count, const sf_allocator *allocator, uint32_t *triangles,
                       size_t *triangle_count)
{
    *triangle_count = 0;
    if (edge_count == 0) {
        return SF_OK;
    }
    table t;
    t.spots = sfi_alloc_array(allocator, spot_count, sizeof *t.spots);
    t.order = sfi_alloc_array(allocator, spot_count, sizeof *t.order);
    t.rank = sfi_alloc_array(allocator, spot_count, sizeof *t.rank);
    t.edges = sfi_alloc_array(allocator, edge_count, 2 * sizeof *t.edges);
    sf_status status = SF_ERR_MEMORY;
    if (t.spots != NULL && t.order != NULL && t.rank != NULL && t.edges != NULL) {
        sort_spots(spots, spot_count, edges, edge_count, &t);
        status = fill_table(&t, spot_count, edge_count, allocator, triangles, triangle_count);
    }
    sfi_free_array(allocator, t.spots, spot_count, sizeof *t.spots);
    sfi_free_array(allocator, t.order, spot_count, sizeof *t.order);
    sfi_free_array(allocator, t.rank, spot_count, sizeof *t.rank);
    sfi_free_array(allocator, t.edges, edge_count, 2 * sizeof *t.edges);
    return status;
}
