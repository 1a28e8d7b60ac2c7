// SPDX-License-Identifier: MIT
// A closed mesh, cut by a plane across an axis into two closed halves.
//
// Vertices of equal position are one (merge.c), and one that is nearer to the plane than vertices
// are told apart lies on it. So each vertex is low, high or on the plane, each edge from low to
// high crosses it in one point, made once for all its triangles, and a triangle is whole, or two or
// three pieces. Triangles within the plane belong to neither half: caps take their place.
//
// What the pieces of a half lack to be closed is its lid (lid.c). Its corners are those of edges in
// the plane, so the half is closed without a vertex that only one side of an edge knows; and as
// both lids lie in the plane, and enclose the same place but for triangles within the plane, the
// halves' volumes add up to the whole's. Positions along the plane are rounded once, where an edge
// crosses it. Where that makes contours cross that did not, which takes edges as close as that,
// some of the lid is folded; closed it is in any case.

#include "mesh/cut.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <math.h>
#include <string.h>

#define NOBODY UINT32_MAX
#define FAR_MM 1e12

// ---------------------------------------------------------------------------------------------
// Crossings
// ---------------------------------------------------------------------------------------------

static void cross(const sfi_cutting *c, sfi_crossing *x)
{
    const double *p = c->mesh.vertices + 3 * (size_t)x->low;
    const double *q = c->mesh.vertices + 3 * (size_t)x->high;
    double part = (c->at_mm - p[c->axis]) / (q[c->axis] - p[c->axis]);
    for (int i = 0; i < 3; i++) {
        x->at[i] = p[i] + part * (q[i] - p[i]);
    }
}

// The corner where an edge crosses; its ends in either order.
static uint32_t crossing_of(sfi_cutting *c, uint32_t a, uint32_t b)
{
    sfi_crossing x = {c->sides[a] == SFI_LOW ? a : b, c->sides[a] == SFI_LOW ? b : a, {0, 0, 0}};
    uint64_t hash = ((uint64_t)x.low << 32 | x.high) * UINT64_C(0x9e3779b97f4a7c15);
    size_t slot = (size_t)((hash ^ hash >> 29) >> 3) & (c->slot_count - 1);
    for (; c->table[slot] != NOBODY; slot = (slot + 1) & (c->slot_count - 1)) {
        const sfi_crossing *there = &c->crossings[c->table[slot]];
        if (there->low == x.low && there->high == x.high) {
            return (uint32_t)c->mesh.vertex_count + c->table[slot];
        }
    }
    cross(c, &x);
    c->table[slot] = (uint32_t)c->crossing_count;
    c->crossings[c->crossing_count] = x;
    return (uint32_t)c->mesh.vertex_count + (uint32_t)c->crossing_count++;
}

// ---------------------------------------------------------------------------------------------
// Pieces
// ---------------------------------------------------------------------------------------------

static void put(sfi_half *h, uint32_t a, uint32_t b, uint32_t d)
{
    uint32_t *to = h->triangles + 3 * h->count++;
    to[0] = a;
    to[1] = b;
    to[2] = d;
}

// The triangle's corner `apex` is alone on its side.
static void split(sfi_cutting *c, sfi_half halves[2], const uint32_t *t, int apex)
{
    uint32_t a = t[apex], b = t[(apex + 1) % 3], d = t[(apex + 2) % 3];
    sfi_half *near = &halves[c->sides[a]], *far = &halves[1 - c->sides[a]];
    if (c->sides[b] == SFI_ON || c->sides[d] == SFI_ON) {
        int turned = c->sides[d] == SFI_ON;
        uint32_t x = turned ? crossing_of(c, a, b) : crossing_of(c, a, d);
        put(near, a, turned ? x : b, turned ? d : x);
        put(far, turned ? x : b, turned ? b : d, turned ? d : x);
        return;
    }
    uint32_t x = crossing_of(c, a, b), y = crossing_of(c, a, d);
    put(near, a, x, y);
    put(far, x, b, d);
    put(far, x, d, y);
}

static void sort_out(sfi_cutting *c, sfi_half halves[2], const uint32_t *t)
{
    int counts[3] = {0, 0, 0}, apex = 0;
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
        return; // no area, and edges that cancel
    }
    for (int i = 0; i < 3; i++) {
        counts[c->sides[t[i]]]++;
    }
    if (counts[SFI_ON] == 3) {
        return;
    }
    if (counts[SFI_LOW] == 0 || counts[SFI_HIGH] == 0) {
        put(&halves[counts[SFI_LOW] == 0 ? SFI_HIGH : SFI_LOW], t[0], t[1], t[2]);
        return;
    }
    int alone = counts[SFI_LOW] == 1 ? SFI_LOW : SFI_HIGH;
    while (c->sides[t[apex]] != alone) {
        apex++;
    }
    split(c, halves, t, apex);
}

// ---------------------------------------------------------------------------------------------
// Halves
// ---------------------------------------------------------------------------------------------

static uint32_t triangle_corner(const sfi_half *h, size_t i)
{
    return i < 3 * h->count ? h->triangles[i] : h->caps[i - 3 * h->count];
}

// Number the corners that the half uses, in their order, and return how many.
static size_t number_corners(const sfi_half *h, size_t corners, uint32_t *numbers)
{
    size_t used = 0;
    memset(numbers, 0xff, corners * sizeof *numbers);
    for (size_t i = 0; i < 3 * (h->count + h->cap_count); i++) {
        numbers[triangle_corner(h, i)] = 0;
    }
    for (size_t i = 0; i < corners; i++) {
        numbers[i] = numbers[i] == 0 ? (uint32_t)used++ : NOBODY;
    }
    return used;
}

// The half as a mesh: vertices in the order in which they are numbered, triangles, then the cap.
static sf_status make_mesh(const sfi_cutting *c, const sfi_half *h, sf_mesh **made)
{
    size_t corners = c->mesh.vertex_count + c->crossing_count, triangles = h->count + h->cap_count;
    double *vertices;
    uint32_t *indices, *numbers = sfi_alloc_array(&c->allocator, corners, sizeof *numbers);
    if (numbers == NULL) {
        return SF_ERR_MEMORY;
    }
    size_t used = number_corners(h, corners, numbers);
    sf_status status = sfi_mesh_make(&c->allocator, used, triangles, made, &vertices, &indices);
    for (size_t i = 0; status == SF_OK && i < corners; i++) {
        if (numbers[i] != NOBODY) {
            sfi_cut_corner(c, (uint32_t)i, vertices + 3 * (size_t)numbers[i]);
        }
    }
    for (size_t i = 0; status == SF_OK && i < 3 * triangles; i++) {
        indices[i] = numbers[triangle_corner(h, i)];
    }
    sfi_free_array(&c->allocator, numbers, corners, sizeof *numbers);
    return status;
}

static sf_status make_meshes(sfi_cutting *c, sfi_half halves[2], sf_mesh *made[2])
{
    sf_status status = SF_OK;
    for (int i = 0; status == SF_OK && i < 2; i++) {
        status = sfi_lid_make(c, &halves[i], i == SFI_HIGH);
        if (status == SF_OK) {
            status = make_mesh(c, &halves[i], &made[i]);
        }
    }
    return status;
}

static int reserve_half(const sfi_cutting *c, size_t pieces, sfi_half *h)
{
    const sf_allocator *from = &c->allocator;
    h->capacity = pieces;
    h->triangles = sfi_alloc_array(from, pieces, 3 * sizeof *h->triangles);
    h->edges = sfi_alloc_array(from, pieces, 2 * sizeof *h->edges);
    h->order = sfi_alloc_array(from, pieces, sizeof *h->order);
    return h->triangles != NULL && h->edges != NULL && h->order != NULL;
}

static void release_half(const sfi_cutting *c, sfi_half *h)
{
    const sf_allocator *from = &c->allocator;
    sfi_free_array(from, h->triangles, h->capacity, 3 * sizeof *h->triangles);
    sfi_free_array(from, h->edges, h->capacity, 2 * sizeof *h->edges);
    sfi_free_array(from, h->order, h->capacity, sizeof *h->order);
    sfi_free_array(from, h->caps, h->cap_capacity, 3 * sizeof *h->caps);
}

// A triangle that crosses leaves at most two pieces in a half, and two crossings.
static sf_status divide(sfi_cutting *c, size_t crossed, sf_mesh *made[2])
{
    sfi_half halves[2];
    size_t pieces;
    memset(halves, 0, sizeof halves);
    if (!sfi_size_add(c->mesh.triangle_count, crossed, &pieces)) {
        return SF_ERR_OVERFLOW;
    }
    int enough =
        reserve_half(c, pieces, &halves[SFI_LOW]) && reserve_half(c, pieces, &halves[SFI_HIGH]);
    sf_status status = enough ? SF_OK : SF_ERR_MEMORY;
    for (size_t t = 0; status == SF_OK && t < c->mesh.triangle_count; t++) {
        sort_out(c, halves, c->mesh.triangles + 3 * t);
    }
    if (status == SF_OK && (halves[SFI_LOW].count == 0 || halves[SFI_HIGH].count == 0)) {
        status = SF_ERR_INFEASIBLE;
    }
    if (status == SF_OK) {
        status = make_meshes(c, halves, made);
    }
    release_half(c, &halves[SFI_LOW]);
    release_half(c, &halves[SFI_HIGH]);
    return status;
}

// Which side each vertex lies on; returns how many triangles cross the plane.
static size_t find_sides(sfi_cutting *c)
{
    double near = sfi_mesh_grain(c->mesh);
    size_t crossed = 0;
    for (size_t v = 0; v < c->mesh.vertex_count; v++) {
        double off = c->mesh.vertices[3 * v + (size_t)c->axis] - c->at_mm;
        c->sides[v] = fabs(off) <= near ? SFI_ON : off < 0 ? SFI_LOW : SFI_HIGH;
    }
    for (size_t t = 0; t < c->mesh.triangle_count; t++) {
        int sides = 0;
        for (size_t i = 0; i < 3; i++) {
            sides |= 1 << c->sides[c->mesh.triangles[3 * t + i]];
        }
        crossed += (sides & 3) == 3;
    }
    return crossed;
}

static int reserve_crossings(sfi_cutting *c, size_t crossed)
{
    size_t slots = 16, need;
    if (!sfi_size_mul(crossed, 2, &c->crossing_capacity) || !sfi_size_mul(crossed, 4, &need)) {
        return 0;
    }
    while (slots < need) {
        if (!sfi_size_mul(slots, 2, &slots)) {
            return 0;
        }
    }
    c->slot_count = slots;
    c->table = sfi_alloc_array(&c->allocator, slots, sizeof *c->table);
    c->crossing_capacity += c->crossing_capacity == 0;
    c->crossings = sfi_alloc_array(&c->allocator, c->crossing_capacity, sizeof *c->crossings);
    if (c->table == NULL || c->crossings == NULL) {
        return 0;
    }
    memset(c->table, 0xff, slots * sizeof *c->table);
    return 1;
}

static sf_status work(sfi_cutting *c, sf_mesh *made[2])
{
    c->mesh = sf_mesh_get_view(c->merged);
    c->sides = sfi_alloc_array(&c->allocator, c->mesh.vertex_count, 1);
    if (c->sides == NULL) {
        return SF_ERR_MEMORY;
    }
    size_t crossed = find_sides(c);
    if (crossed > (UINT32_MAX - c->mesh.vertex_count) / 2) {
        return SF_ERR_OVERFLOW;
    }
    return reserve_crossings(c, crossed) ? divide(c, crossed, made) : SF_ERR_MEMORY;
}

// Beyond that, differences and products of coordinates may be none.
static int is_near(sf_mesh_view mesh)
{
    for (size_t i = 0; i < 3 * mesh.vertex_count; i++) {
        if (!(fabs(mesh.vertices[i]) <= FAR_MM)) {
            return 0;
        }
    }
    return 1;
}

// Where the mesh is that the plane misses.
static sf_status miss(sf_mesh_view mesh, int axis, double at_mm, sf_fault *fault)
{
    double low[3], high[3];
    SF_TRY(sf_mesh_bounds(mesh, low, high));
    return sfi_fault_set(fault, SF_ERR_INFEASIBLE, 0, 0,
                         "The plane %c = %.9g mm leaves nothing on one side: the mesh goes from "
                         "%.9g to %.9g mm along %c.",
                         "xyz"[axis], at_mm, low[axis], high[axis], "xyz"[axis]);
}

static sf_status check(sf_mesh_view mesh, const sf_allocator *allocator, sf_fault *fault)
{
    sf_topology topology;
    SF_TRY(sf_mesh_analyze(mesh, allocator, &topology));
    if (!topology.closed) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "The mesh is open: %zu edges have one triangle only.",
                             topology.boundary_edges);
    }
    if (!topology.oriented) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "Of the mesh %zu edges join triangles that face opposite ways.",
                             topology.misoriented_edges);
    }
    return is_near(mesh) ? SF_OK
                         : sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                                         "A coordinate of the mesh lies beyond %g mm.", FAR_MM);
}

static sf_status cut(sf_mesh_view mesh, int axis, double at_mm, const sf_allocator *allocator,
                     sf_mesh *made[2])
{
    sfi_cutting c = {
        .allocator = sfi_allocator_or_default(allocator), .axis = axis, .at_mm = at_mm};
    SF_TRY(sf_mesh_merge(mesh, allocator, &c.merged));
    sf_status status = work(&c, made);
    sfi_free_array(&c.allocator, c.sides, c.mesh.vertex_count, 1);
    sfi_free_array(&c.allocator, c.table, c.slot_count, sizeof *c.table);
    sfi_free_array(&c.allocator, c.crossings, c.crossing_capacity, sizeof *c.crossings);
    sf_mesh_destroy(c.merged);
    return status;
}

sf_status sf_mesh_cut(sf_mesh_view mesh, int axis, double at_mm, const sf_allocator *allocator,
                      sf_mesh **low, sf_mesh **high, sf_fault *fault)
{
    sf_fault found = {SF_OK, 0, 0, ""};
    sf_mesh *made[2] = {NULL, NULL};
    if (low == NULL || high == NULL || low == high || axis < 0 || axis > 2 || !isfinite(at_mm)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "A plane crosses axis 0, 1 or 2 at a finite place, and each half "
                             "wants a pointer of its own.");
    }
    sf_status status = check(mesh, allocator, &found);
    if (status == SF_OK) {
        status = cut(mesh, axis, at_mm, allocator, made);
    }
    if (status == SF_ERR_INFEASIBLE) {
        status = miss(mesh, axis, at_mm, &found);
    }
    if (status != SF_OK) {
        sf_mesh_destroy(made[SFI_LOW]);
        sf_mesh_destroy(made[SFI_HIGH]);
        return sfi_fault_set(fault, status, 0, 0, "%s",
                             found.status == status ? found.message : sf_status_message(status));
    }
    *low = made[SFI_LOW];
    *high = made[SFI_HIGH];
    return SF_OK;
}
