// SPDX-License-Identifier: MIT
// What closes a half of a mesh that was cut.
//
// Edges in the plane that the half's triangles run as often one way as the other need nothing. The
// others are the contours, run the wrong way, and the lid is what they enclose (cap.h). It is laid
// out in whole numbers of 60 bits of its extent, so that signs are exact; corners keep their
// coordinates.
//
// An edge of the half's own that only touches the plane, the ridge of a tunnel say, may have both
// its ends on contours, and then the lid may have a diagonal there: two sheets, and one edge of
// four triangles. Such a diagonal gets a corner in its middle, so that every edge has two.

#include "mesh/cut.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "mesh/cap.h"
#include "mesh/heap.h"

#include <math.h>
#include <string.h>

#define NOBODY UINT32_MAX
#define LID_BITS 60

// The contours of a half, and what touches.
typedef struct lid {
    size_t edge_count;     // of the half's edges in the plane
    uint32_t *touching;    // edges, one of each pair of ends, that the half runs both ways alike
    size_t touching_count; // in the order of their ends
    size_t kept;           // how many edges the contours have
    uint32_t *edges;       // numbers of spots, two each
    uint32_t *corners;     // who the spots are
    sfi_spot *spots;
    size_t spot_count;
    uint32_t *numbers;   // which spot a corner is, or NOBODY
    size_t number_count; // of corners, without those of this lid
} lid;

static int is_in_plane(const sfi_cutting *c, uint32_t corner)
{
    return corner >= c->mesh.vertex_count || c->sides[corner] == SFI_ON;
}

void sfi_cut_corner(const sfi_cutting *c, uint32_t corner, double p[3])
{
    size_t count = c->mesh.vertex_count;
    const double *at =
        corner < count ? c->mesh.vertices + 3 * (size_t)corner : c->crossings[corner - count].at;
    memcpy(p, at, 3 * sizeof *p);
    if (is_in_plane(c, corner)) {
        p[c->axis] = c->at_mm;
    }
}

// ---------------------------------------------------------------------------------------------
// Edges in the plane
// ---------------------------------------------------------------------------------------------

static uint32_t lower_end(const uint32_t *edge)
{
    return edge[0] < edge[1] ? edge[0] : edge[1];
}

static uint32_t upper_end(const uint32_t *edge)
{
    return edge[0] < edge[1] ? edge[1] : edge[0];
}

// Negative, 0 or positive, by the ends.
static int compare_ends(const uint32_t *p, const uint32_t *q)
{
    uint32_t a = lower_end(p), b = lower_end(q);
    if (a == b) {
        a = upper_end(p);
        b = upper_end(q);
    }
    return (a > b) - (a < b);
}

static int edge_before(const void *user, uint32_t a, uint32_t b)
{
    const uint32_t *edges = user;
    int order = compare_ends(edges + 2 * (size_t)a, edges + 2 * (size_t)b);
    return order != 0 ? order < 0 : a < b;
}

// Turned around: what runs one way around the half runs the other around its lid.
static void collect_edges(const sfi_cutting *c, sfi_half *h)
{
    for (size_t t = 0; t < h->count; t++) {
        const uint32_t *corner = h->triangles + 3 * t;
        for (int i = 0; i < 3; i++) {
            uint32_t a = corner[i], b = corner[(i + 1) % 3];
            if (is_in_plane(c, a) && is_in_plane(c, b)) {
                h->edges[2 * h->edge_count] = b;
                h->edges[2 * h->edge_count + 1] = a;
                h->order[h->edge_count] = (uint32_t)h->edge_count;
                h->edge_count++;
            }
        }
    }
}

// One pair of ends: of the edges order[first..end), leave in `order` those that nothing runs back.
static void settle(sfi_half *h, lid *l, size_t first, size_t end)
{
    size_t rising = 0, count = end - first;
    for (size_t i = first; i < end; i++) {
        const uint32_t *edge = h->edges + 2 * (size_t)h->order[i];
        rising += edge[0] < edge[1];
    }
    size_t falling = count - rising, left = rising > falling ? rising - falling : falling - rising;
    if (left == 0) {
        l->touching[l->touching_count++] = h->order[first];
    }
    for (size_t i = first; left > 0 && i < end; i++) {
        const uint32_t *edge = h->edges + 2 * (size_t)h->order[i];
        if ((edge[0] < edge[1]) == (rising > falling)) {
            h->order[l->kept++] = h->order[i];
            left--;
        }
    }
}

static void find_contours(sfi_half *h, lid *l)
{
    sfi_heap_sort(h->order, h->edge_count, edge_before, h->edges);
    for (size_t first = 0, end; first < h->edge_count; first = end) {
        const uint32_t *edge = h->edges + 2 * (size_t)h->order[first];
        for (end = first + 1; end < h->edge_count; end++) {
            if (compare_ends(edge, h->edges + 2 * (size_t)h->order[end]) != 0) {
                break;
            }
        }
        settle(h, l, first, end);
    }
}

// ---------------------------------------------------------------------------------------------
// Spots
// ---------------------------------------------------------------------------------------------

// Number the corners of the contours in the order of their edges.
static void number_spots(const sfi_half *h, lid *l)
{
    memset(l->numbers, 0xff, l->number_count * sizeof *l->numbers);
    for (size_t i = 0; i < 2 * l->kept; i++) {
        uint32_t corner = h->edges[2 * (size_t)h->order[i / 2] + i % 2];
        if (l->numbers[corner] == NOBODY) {
            l->numbers[corner] = (uint32_t)l->spot_count;
            l->corners[l->spot_count++] = corner;
        }
        l->edges[i] = l->numbers[corner];
    }
}

// The lid as it is seen from outside, in whole numbers.
static void place_spots(const sfi_cutting *c, lid *l, int is_high)
{
    const int axes[2] = {(c->axis + (is_high ? 2 : 1)) % 3, (c->axis + (is_high ? 1 : 2)) % 3};
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, p[3];
    for (size_t i = 0; i < l->spot_count; i++) {
        sfi_cut_corner(c, l->corners[i], p);
        for (int d = 0; d < 2; d++) {
            low[d] = p[axes[d]] < low[d] ? p[axes[d]] : low[d];
            high[d] = p[axes[d]] > high[d] ? p[axes[d]] : high[d];
        }
    }
    double wide = high[0] - low[0], tall = high[1] - low[1];
    double scale = sfi_exact_scale(wide > tall ? wide : tall, LID_BITS);
    for (size_t i = 0; i < l->spot_count; i++) {
        sfi_cut_corner(c, l->corners[i], p);
        l->spots[i].x = (int64_t)floor((p[axes[0]] - low[0]) * scale + 0.5);
        l->spots[i].y = (int64_t)floor((p[axes[1]] - low[1]) * scale + 0.5);
    }
}

// ---------------------------------------------------------------------------------------------
// Diagonals over edges that touch
// ---------------------------------------------------------------------------------------------

// The corner in the middle of an edge that touches, or NOBODY for one that does not.
static uint32_t middle_of(const sfi_half *h, const lid *l, uint32_t a, uint32_t b)
{
    const uint32_t edge[2] = {a, b};
    size_t low = 0, high = l->touching_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        int order = compare_ends(h->edges + 2 * (size_t)l->touching[middle], edge);
        if (order == 0) {
            return (uint32_t)(l->number_count + middle);
        }
        *(order < 0 ? &low : &high) = order < 0 ? middle + 1 : middle;
    }
    return NOBODY;
}

// Halve triangles at middles until no edge of the lid is one of those that touch. The second half
// goes to the end, where it is looked at later.
static void halve(sfi_half *h, const lid *l)
{
    for (size_t t = 0; t < h->cap_count; t++) {
        for (int i = 0; i < 3; i++) {
            uint32_t *corner = h->caps + 3 * t;
            uint32_t a = corner[i], b = corner[(i + 1) % 3], d = corner[(i + 2) % 3];
            uint32_t middle = middle_of(h, l, a, b);
            if (middle != NOBODY) {
                uint32_t *other = h->caps + 3 * h->cap_count++;
                corner[(i + 1) % 3] = middle;
                other[0] = middle;
                other[1] = b;
                other[2] = d;
            }
        }
    }
}

static sf_status add_middles(sfi_cutting *c, const sfi_half *h, const lid *l)
{
    void *memory = c->crossings;
    size_t need;
    if (!sfi_size_add(c->crossing_count, l->touching_count, &need) ||
        need > UINT32_MAX - c->mesh.vertex_count) {
        return SF_ERR_OVERFLOW;
    }
    if (!sfi_grow_array(&c->allocator, &memory, &c->crossing_capacity, need,
                        sizeof *c->crossings)) {
        return SF_ERR_MEMORY;
    }
    c->crossings = memory;
    for (size_t i = 0; i < l->touching_count; i++) {
        const uint32_t *edge = h->edges + 2 * (size_t)l->touching[i];
        sfi_crossing middle = {lower_end(edge), upper_end(edge), {0, 0, 0}};
        double p[3], q[3];
        sfi_cut_corner(c, middle.low, p);
        sfi_cut_corner(c, middle.high, q);
        for (int d = 0; d < 3; d++) {
            middle.at[d] = 0.5 * p[d] + 0.5 * q[d];
        }
        c->crossings[c->crossing_count++] = middle;
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The lid
// ---------------------------------------------------------------------------------------------

static sf_status fill(sfi_cutting *c, sfi_half *h, lid *l, int is_high)
{
    number_spots(h, l);
    place_spots(c, l, is_high);
    SF_TRY(sfi_cap_fill(l->spots, l->spot_count, l->edges, l->kept, &c->allocator, h->caps,
                        &h->cap_count));
    for (size_t i = 0; i < 3 * h->cap_count; i++) {
        h->caps[i] = l->corners[h->caps[i]];
    }
    if (l->touching_count > 0) {
        SF_TRY(add_middles(c, h, l));
        halve(h, l);
    }
    return SF_OK;
}

// A diagonal that touches makes two triangles more.
static int reserve(const sfi_cutting *c, sfi_half *h, lid *l)
{
    const sf_allocator *from = &c->allocator;
    size_t halved;
    if (!sfi_size_mul(l->kept, SFI_CAP_TRIANGLES_PER_EDGE, &h->cap_capacity) ||
        !sfi_size_mul(l->touching_count, 2, &halved) ||
        !sfi_size_add(h->cap_capacity, halved, &h->cap_capacity)) {
        h->cap_capacity = 0;
        return 0;
    }
    h->caps = sfi_alloc_array(from, h->cap_capacity, 3 * sizeof *h->caps);
    l->edges = sfi_alloc_array(from, l->kept, 2 * sizeof *l->edges);
    l->corners = sfi_alloc_array(from, l->kept, 2 * sizeof *l->corners);
    l->spots = sfi_alloc_array(from, l->kept, 2 * sizeof *l->spots);
    l->numbers = sfi_alloc_array(from, l->number_count, sizeof *l->numbers);
    return h->caps != NULL && l->edges != NULL && l->corners != NULL && l->spots != NULL &&
           l->numbers != NULL;
}

static void release(const sfi_cutting *c, lid *l)
{
    const sf_allocator *from = &c->allocator;
    sfi_free_array(from, l->touching, l->edge_count, sizeof *l->touching);
    sfi_free_array(from, l->edges, l->kept, 2 * sizeof *l->edges);
    sfi_free_array(from, l->corners, l->kept, 2 * sizeof *l->corners);
    sfi_free_array(from, l->spots, l->kept, 2 * sizeof *l->spots);
    sfi_free_array(from, l->numbers, l->number_count, sizeof *l->numbers);
}

sf_status sfi_lid_make(sfi_cutting *c, sfi_half *h, int is_high)
{
    lid l = {.number_count = c->mesh.vertex_count + c->crossing_count};
    collect_edges(c, h);
    if (h->edge_count == 0) {
        return SF_OK;
    }
    l.edge_count = h->edge_count;
    l.touching = sfi_alloc_array(&c->allocator, l.edge_count, sizeof *l.touching);
    if (l.touching == NULL) {
        return SF_ERR_MEMORY;
    }
    find_contours(h, &l);
    sf_status status = SF_OK;
    if (l.kept > 0) {
        status = reserve(c, h, &l) ? fill(c, h, &l, is_high) : SF_ERR_MEMORY;
    }
    release(c, &l);
    return status;
}
