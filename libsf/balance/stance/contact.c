// SPDX-License-Identifier: MIT
// Contacts: what of a mesh touches the ground, and the polygon that it stands on.
//
// Contacts are the vertices within a tolerance above the lowest one; vertices decide, because a
// triangle touches a plane from above in its corners or not at all. Their hull is found in the
// ground's plane, in whole numbers of 2^-40 of its extent. Corners that are one line in the model
// are then one line but for a unit, so that a corner which sticks out by no more than two units is
// left out: a square foot has four corners, whatever vertices lie along its sides and however it is
// turned. What is left out makes the polygon smaller, never larger.
//
// Source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand", 2013, section
// 3.

#include "balance/stance/stance.h"

#include "base/exact.h"
#include "base/memory.h"
#include "base/polygon.h"
#include "base/status.h"
#include "mesh/vector.h"

#include <math.h>
#include <string.h>

#define EXTENT_BITS 40
#define FLAT_UNITS 2

// ---------------------------------------------------------------------------------------------
// The polygon
// ---------------------------------------------------------------------------------------------

// Where a vertex lies on the ground, east and north of the box's corner.
static void drop(const sf_stance *s, const double *vertex, double at[2])
{
    double from_low[3];
    sfi_subtract(vertex, s->low, from_low);
    at[0] = sfi_dot(s->east, from_low);
    at[1] = sfi_dot(s->north, from_low);
}

static void snap(const sf_stance *s, sf_mesh_view mesh, sfi_corner *corners)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, at[2];
    for (size_t i = 0; i < s->contact_count; i++) {
        drop(s, mesh.vertices + 3 * (size_t)s->contacts[i], at);
        for (int axis = 0; axis < 2; axis++) {
            low[axis] = at[axis] < low[axis] ? at[axis] : low[axis];
            high[axis] = at[axis] > high[axis] ? at[axis] : high[axis];
        }
    }
    double wide = high[0] - low[0], deep = high[1] - low[1];
    double scale = sfi_exact_scale(wide > deep ? wide : deep, EXTENT_BITS);
    for (size_t i = 0; i < s->contact_count; i++) {
        drop(s, mesh.vertices + 3 * (size_t)s->contacts[i], at);
        corners[i].x = (int64_t)floor((at[0] - low[0]) * scale + 0.5);
        corners[i].y = (int64_t)floor((at[1] - low[1]) * scale + 0.5);
        corners[i].name = s->contacts[i];
    }
}

// Whether b sticks out of the line from a to c by no more than FLAT_UNITS.
static int is_flat(const sfi_corner *a, const sfi_corner *b, const sfi_corner *c)
{
    double x = (double)(c->x - a->x), y = (double)(c->y - a->y);
    double area = x * (double)(b->y - a->y) - y * (double)(b->x - a->x);
    return fabs(area) <= FLAT_UNITS * sqrt(x * x + y * y);
}

// Leave out corners that hardly are; returns how many stay, at least two of two or more.
static size_t thin_out(sfi_corner *corners, size_t count)
{
    size_t kept = 1;
    for (size_t i = 1; i < count; i++) {
        if (!is_flat(corners + kept - 1, corners + i, corners + (i + 1) % count)) {
            corners[kept++] = corners[i];
        }
    }
    if (count > 2 && kept > 2 && is_flat(corners + kept - 1, corners, corners + 1)) {
        memmove(corners, corners + 1, --kept * sizeof *corners);
    }
    return kept;
}

// The corner that is furthest from the first one.
static sfi_corner find_far(const sfi_corner *corners, size_t count)
{
    double most = -1;
    sfi_corner far = corners[0];
    for (size_t i = 1; i < count; i++) {
        double x = (double)(corners[i].x - corners[0].x), y = (double)(corners[i].y - corners[0].y);
        if (x * x + y * y > most) {
            most = x * x + y * y;
            far = corners[i];
        }
    }
    return far;
}

static sf_status make_polygon(sf_stance *s, sf_mesh_view mesh)
{
    sfi_corner *corners = sfi_alloc_array(&s->allocator, s->contact_count, sizeof *corners);
    if (corners == NULL) {
        return SF_ERR_MEMORY;
    }
    snap(s, mesh, corners);
    size_t count = sfi_polygon_hull(corners, s->contact_count);
    if (count > 2) {
        sfi_corner far = find_far(corners, count);
        count = thin_out(corners, count);
        if (count < 3) {
            corners[1] = far;
            count = 2;
        }
    }
    s->polygon = sfi_alloc_array(&s->allocator, count, 3 * sizeof(double));
    if (s->polygon != NULL) {
        s->polygon_count = s->polygon_capacity = count;
        for (size_t i = 0; i < count; i++) {
            double *p = s->polygon + 3 * i;
            memcpy(p, mesh.vertices + 3 * (size_t)corners[i].name, 3 * sizeof *p);
            double above = sfi_dot(s->options.up, p) - s->ground_mm;
            for (int d = 0; d < 3; d++) {
                p[d] -= above * s->options.up[d];
            }
        }
    }
    sfi_free_array(&s->allocator, corners, s->contact_count, sizeof *corners);
    return s->polygon != NULL ? SF_OK : SF_ERR_MEMORY;
}

size_t sfi_edge_count(const sf_stance *s)
{
    return s->polygon_count >= 3 ? s->polygon_count : 4;
}

sfi_edge sfi_edge_get(const sf_stance *s, size_t i)
{
    sfi_edge edge;
    // A segment a, b goes around as a-b, b-b, b-a, a-a; a point stays where it is.
    size_t n = s->polygon_count;
    size_t from = n >= 3 ? i : n == 2 ? i == 1 || i == 2 : 0;
    size_t to = n >= 3 ? (i + 1) % n : n == 2 ? i < 2 : 0;
    memcpy(edge.from, s->polygon + 3 * from, sizeof edge.from);
    memcpy(edge.to, s->polygon + 3 * to, sizeof edge.to);
    double along[3];
    if (n >= 2) {
        sfi_subtract(s->polygon + 3 * (n == 2 ? 1 : to), s->polygon + 3 * (n == 2 ? 0 : from),
                     along);
        sfi_normalize(along);
        sfi_cross(s->options.up, along, edge.inward);
    } else {
        memcpy(edge.inward, s->north, sizeof edge.inward);
    }
    // The further sides of a segment or a point are quarter turns of the first.
    for (size_t turn = 0; n < 3 && turn < i; turn++) {
        double turned[3];
        sfi_cross(s->options.up, edge.inward, turned);
        memcpy(edge.inward, turned, sizeof turned);
    }
    return edge;
}

// ---------------------------------------------------------------------------------------------
// Contacts
// ---------------------------------------------------------------------------------------------

// What a vertex is: used by no triangle, used but outside of a box, used and inside of it.
enum { MARK_NONE = 0, MARK_OUTSIDE = 1, MARK_INSIDE = 2 };

static void mark_vertices(sf_mesh_view mesh, const double low[3], const double high[3],
                          uint8_t *marks)
{
    memset(marks, MARK_NONE, mesh.vertex_count);
    for (size_t i = 0; i < 3 * mesh.triangle_count; i++) {
        const double *p = mesh.vertices + 3 * (size_t)mesh.triangles[i];
        int in = 1;
        for (int d = 0; d < 3; d++) {
            in = in && low[d] <= p[d] && p[d] <= high[d];
        }
        marks[mesh.triangles[i]] = in ? MARK_INSIDE : MARK_OUTSIDE;
    }
}

sf_status sfi_gather(sf_mesh_view mesh, const double low[3], const double high[3],
                     const sf_allocator *allocator, double **points, size_t *count)
{
    uint8_t *marks = sfi_alloc_array(allocator, mesh.vertex_count, sizeof *marks);
    double *made = NULL;
    size_t found = 0;
    if (marks == NULL) {
        return SF_ERR_MEMORY;
    }
    mark_vertices(mesh, low, high, marks);
    for (size_t i = 0; i < mesh.vertex_count; i++) {
        found += marks[i] == MARK_INSIDE;
    }
    made = sfi_alloc_array(allocator, found, 3 * sizeof *made);
    for (size_t i = 0, at = 0; made != NULL && i < mesh.vertex_count; i++) {
        if (marks[i] == MARK_INSIDE) {
            memcpy(made + 3 * at++, mesh.vertices + 3 * i, 3 * sizeof *made);
        }
    }
    sfi_free_array(allocator, marks, mesh.vertex_count, sizeof *marks);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    *points = made;
    *count = found;
    return SF_OK;
}

// Find the ground and the vertices that touch it.
static sf_status find_contacts(sf_stance *s, sf_mesh_view mesh, const uint8_t *marks,
                               sf_fault *fault)
{
    double lowest = INFINITY, bottom = INFINITY;
    size_t count = 0;
    for (size_t i = 0; i < mesh.vertex_count; i++) {
        double height = sfi_dot(s->options.up, mesh.vertices + 3 * i);
        bottom = marks[i] != MARK_NONE && height < bottom ? height : bottom;
        lowest = marks[i] == MARK_INSIDE && height < lowest ? height : lowest;
    }
    if (lowest == INFINITY) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "no vertex of the mesh lies in the region of contacts; make it "
                             "larger");
    }
    double limit = lowest + s->options.contact_mm;
    for (int pass = 0; pass < 2; pass++) {
        count = 0;
        for (size_t i = 0; i < mesh.vertex_count; i++) {
            if (marks[i] == MARK_INSIDE && sfi_dot(s->options.up, mesh.vertices + 3 * i) <= limit) {
                if (pass == 1) {
                    s->contacts[count] = (uint32_t)i;
                }
                count++;
            }
        }
        if (pass == 0) {
            s->contacts = sfi_alloc_array(&s->allocator, count, sizeof *s->contacts);
            if (s->contacts == NULL) {
                return SF_ERR_MEMORY;
            }
            s->contact_count = count;
        }
    }
    s->ground_mm = lowest;
    s->is_over_edge = bottom < lowest;
    return SF_OK;
}

// The point that it hangs from takes the place of a polygon.
static sf_status take_point(sf_stance *s)
{
    s->polygon = sfi_alloc_array(&s->allocator, 1, 3 * sizeof(double));
    if (s->polygon == NULL) {
        return SF_ERR_MEMORY;
    }
    s->polygon_count = s->polygon_capacity = 1;
    memcpy(s->polygon, s->options.point_mm, 3 * sizeof(double));
    s->ground_mm = sfi_dot(s->options.up, s->options.point_mm);
    return SF_OK;
}

sf_status sfi_stance_touch(sf_stance *s, sf_mesh_view mesh, sf_fault *fault)
{
    if (s->options.kind == SF_STANCE_HANG) {
        return take_point(s);
    }
    uint8_t *marks = sfi_alloc_array(&s->allocator, mesh.vertex_count, sizeof *marks);
    if (marks == NULL) {
        return SF_ERR_MEMORY;
    }
    mark_vertices(mesh, s->options.region_low_mm, s->options.region_high_mm, marks);
    sf_status status = find_contacts(s, mesh, marks, fault);
    sfi_free_array(&s->allocator, marks, mesh.vertex_count, sizeof *marks);
    return status == SF_OK ? make_polygon(s, mesh) : status;
}

sf_status sf_stance_flatten(const sf_stance *stance, double *vertices, size_t vertex_count)
{
    if (stance == NULL || vertices == NULL) {
        return SF_ERR_ARGUMENT;
    }
    if (vertex_count != stance->vertex_count) {
        return SF_ERR_SHAPE;
    }
    for (size_t i = 0; i < stance->contact_count; i++) {
        double *p = vertices + 3 * (size_t)stance->contacts[i];
        double above = sfi_dot(stance->options.up, p) - stance->ground_mm;
        for (int d = 0; d < 3; d++) {
            p[d] -= above * stance->options.up[d];
        }
    }
    return SF_OK;
}
