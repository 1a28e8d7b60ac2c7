// SPDX-License-Identifier: MIT
// Rolling: how a body comes to rest on level ground.
//
// Let w be the direction of the body that points up, and let it touch with the corners K of its
// hull that lie lowest along w. Seen from above, the centre of mass lies over the polygon of K, and
// the body rests; or beside it, and the body tips about the polygon's point q that is nearest:
// about the edge that q lies on, or about the corner that q is, straight away from it. It turns
// until another corner meets the ground, and so on. Whatever it does, its centre of mass sinks:
//
//     height(w) = max over corners v of (c - v) . w
//
// is the largest of linear functions, and the way that it takes is the steepest descent of this
// function on the sphere of directions: the gradients at w are c - v for v in K, and the one that
// is followed is that of their convex hull that is nearest to none at all, which is c - q seen from
// above. It ends where the height has a local minimum. This is a body that tips slowly, neither
// slides nor gains momentum; it passes over edges, from face to face, or over corners.
//
// Turned by an angle a about q towards the direction t, up becomes cos(a) w - sin(a) t, and a
// corner that lies at height h over the ground and at distance s from q along t meets it when
// tan(a) = h / s. So the first to meet it is the one with the largest s / h, and no angle is ever
// worked out.
//
// Corners touch when they lie within a tolerance above the lowest one: faces that are one in the
// model are then one here, though their hull has several. A balance that nothing holds, on an edge
// or a corner, falls to one side, always the same. Every turn lowers the centre of mass, or is the
// last.
//
// Source: polyhedra that roll from face to face are those of M. Goldberg, R. K. Guy, "Stability of
// Polyhedra (J. H. Conway and R. K. Guy)", SIAM Review 11, 1969; the nearest gradient is that of
// steepest descent on convex functions (R. T. Rockafellar, "Convex Analysis", 1970).

#include "balance/stance/roll.h"

#include "balance/stance/stance.h"
#include "base/exact.h"
#include "base/math.h"
#include "base/memory.h"
#include "base/status.h"
#include "mesh/vector.h"

#include <math.h>
#include <string.h>

#define POLYGON_BITS 40
#define HAIR 1e-12 // of the diagonal: what is no distance
#define THIN 1e-9  // of the diagonal: what is no width

sf_status sfi_hull_corners(const sfi_hull *hull, const double *points,
                           const sf_allocator *allocator, double **corners)
{
    double *made = sfi_alloc_array(allocator, hull->corner_count, 3 * sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < hull->corner_count; i++) {
        memcpy(made + 3 * i, points + 3 * (size_t)hull->corners[i], 3 * sizeof *made);
    }
    *corners = made;
    return SF_OK;
}

sf_status sfi_roller_create(const double *corners, size_t count, double diagonal_mm,
                            double contact_mm, const sf_allocator *allocator, sfi_roller *roller)
{
    sfi_roller made = {corners, count, diagonal_mm, contact_mm, NULL, NULL};
    made.touching = sfi_alloc_array(allocator, count, sizeof *made.touching);
    made.polygon = sfi_alloc_array(allocator, count, sizeof *made.polygon);
    if (made.touching == NULL || made.polygon == NULL) {
        sfi_roller_destroy(&made, allocator);
        return SF_ERR_MEMORY;
    }
    *roller = made;
    return SF_OK;
}

void sfi_roller_destroy(sfi_roller *r, const sf_allocator *allocator)
{
    sfi_free_array(allocator, r->touching, r->count, sizeof *r->touching);
    sfi_free_array(allocator, r->polygon, r->count, sizeof *r->polygon);
}

// ---------------------------------------------------------------------------------------------
// What touches
// ---------------------------------------------------------------------------------------------

// A body in one position.
typedef struct pose {
    const sfi_roller *roller;
    const double *com;
    double up[3], east[3], north[3];
    double ground, height;    // of the lowest corner, and of the centre of mass above it
    size_t touching, corners; // how many corners touch; how many of them the polygon has
} pose;

// Where a corner lies on the ground, seen from below the centre of mass.
static void place(const pose *p, uint32_t corner, double at[2])
{
    double from[3];
    sfi_subtract(p->roller->corners + 3 * (size_t)corner, p->com, from);
    at[0] = sfi_dot(p->east, from);
    at[1] = sfi_dot(p->north, from);
}

static void find_ground(pose *p)
{
    p->ground = INFINITY;
    for (size_t i = 0; i < p->roller->count; i++) {
        double height = sfi_dot(p->up, p->roller->corners + 3 * i);
        p->ground = height < p->ground ? height : p->ground;
    }
    p->height = sfi_dot(p->up, p->com) - p->ground;
    p->touching = 0;
    for (size_t i = 0; i < p->roller->count; i++) {
        if (sfi_dot(p->up, p->roller->corners + 3 * i) <= p->ground + p->roller->contact_mm) {
            p->roller->touching[p->touching++] = (uint32_t)i;
        }
    }
}

// The hull of what touches, in whole numbers.
static void find_polygon(pose *p)
{
    double low[2] = {INFINITY, INFINITY}, extent = 0, at[2];
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < p->touching; i++) {
            place(p, p->roller->touching[i], at);
            for (int d = 0; d < 2; d++) {
                low[d] = at[d] < low[d] ? at[d] : low[d];
                extent = pass == 1 && at[d] - low[d] > extent ? at[d] - low[d] : extent;
            }
        }
    }
    double scale = sfi_exact_scale(extent, POLYGON_BITS);
    for (size_t i = 0; i < p->touching; i++) {
        sfi_corner *c = &p->roller->polygon[i];
        place(p, p->roller->touching[i], at);
        c->x = (int64_t)floor((at[0] - low[0]) * scale + 0.5);
        c->y = (int64_t)floor((at[1] - low[1]) * scale + 0.5);
        c->name = p->roller->touching[i];
    }
    p->corners = sfi_polygon_hull(p->roller->polygon, p->touching);
}

// A polygon without width is the segment from its first corner, an end, to the furthest one.
static void find_segment(pose *p)
{
    double a[2], b[2], at[2], most = 0, area = 0;
    size_t furthest = 0;
    place(p, p->roller->polygon[0].name, a);
    for (size_t i = 1; i < p->corners; i++) {
        place(p, p->roller->polygon[i].name, at);
        double x = at[0] - a[0], y = at[1] - a[1], far = sqrt(x * x + y * y);
        if (i > 1) {
            area += (b[0] - a[0]) * y - (b[1] - a[1]) * x;
        }
        furthest = far > most ? i : furthest;
        most = far > most ? far : most;
        memcpy(b, at, sizeof b);
    }
    if (p->corners > 2 && area <= THIN * p->roller->diagonal_mm * most) {
        p->roller->polygon[1] = p->roller->polygon[furthest];
        p->corners = 2;
    }
}

static void take_up(pose *p, const double up[3])
{
    memmove(p->up, up, sizeof p->up);
    sfi_normalize(p->up);
    sfi_frame_around(p->up, p->east, p->north);
    find_ground(p);
    find_polygon(p);
    find_segment(p);
}

// ---------------------------------------------------------------------------------------------
// Where it tips
// ---------------------------------------------------------------------------------------------

// Where the body leaves the ground: a point below it, and the direction in which it tips.
typedef struct pivot {
    double at[2], towards[2];
} pivot;

// The point of the edge a-b nearest to the place below the centre of mass, the origin, and how far
// it is. Off an edge's middle it tips straight across it, off a corner straight away from it; over
// either itself, to the right of the edge.
static double approach(const double a[2], const double b[2], double hair, pivot *p)
{
    double along[2] = {b[0] - a[0], b[1] - a[1]};
    double length = sqrt(along[0] * along[0] + along[1] * along[1]);
    double share = -(a[0] * along[0] + a[1] * along[1]) / (length * length);
    double side = (along[1] * -a[0] - along[0] * -a[1]) / length; // how far right of the edge
    if (share > 0 && share < 1) {
        double sign = side < 0 ? -1 : 1;
        for (int d = 0; d < 2; d++) {
            p->at[d] = a[d] + share * along[d];
        }
        p->towards[0] = sign * along[1] / length;
        p->towards[1] = sign * -along[0] / length;
        return fabs(side);
    }
    const double *q = share > 0 ? b : a;
    double far = sqrt(q[0] * q[0] + q[1] * q[1]);
    memcpy(p->at, q, sizeof p->at);
    p->towards[0] = far > hair ? -q[0] / far : along[1] / length;
    p->towards[1] = far > hair ? -q[1] / far : -along[0] / length;
    return far;
}

// The least distance of the origin inside of an edge of the polygon, and that edge.
static double find_inside(const pose *p, size_t *edge)
{
    double least = INFINITY;
    for (size_t i = 0; i < p->corners; i++) {
        double a[2], b[2];
        place(p, p->roller->polygon[i].name, a);
        place(p, p->roller->polygon[(i + 1) % p->corners].name, b);
        double x = b[0] - a[0], y = b[1] - a[1];
        double inside = (y * a[0] - x * a[1]) / sqrt(x * x + y * y);
        if (inside < least) {
            least = inside;
            *edge = i;
        }
    }
    return least;
}

// Where it tips; returns 0 where it rests.
static int find_pivot(const pose *p, pivot *best)
{
    double hair = HAIR * p->roller->diagonal_mm, least = INFINITY;
    size_t edge;
    if (p->corners > 2 && find_inside(p, &edge) >= -hair) {
        return 0;
    }
    if (p->corners == 1) {
        place(p, p->roller->polygon[0].name, best->at);
        double far = sqrt(best->at[0] * best->at[0] + best->at[1] * best->at[1]);
        best->towards[0] = far > hair ? -best->at[0] / far : 1;
        best->towards[1] = far > hair ? -best->at[1] / far : 0;
        return 1;
    }
    for (size_t i = 0; i < (p->corners == 2 ? 1 : p->corners); i++) {
        double a[2], b[2];
        pivot found;
        place(p, p->roller->polygon[i].name, a);
        place(p, p->roller->polygon[(i + 1) % p->corners].name, b);
        double far = approach(a, b, hair, &found);
        if (far < least) {
            least = far;
            *best = found;
        }
    }
    return 1;
}

// Turn about a pivot until another corner meets the ground; returns 0 where none does.
static int tip(const pose *p, const pivot *about, double up[3])
{
    double most = -INFINITY, s = 0, h = 0;
    size_t next = 0; // of those that touch
    for (uint32_t i = 0; i < p->roller->count; i++) {
        if (next < p->touching && p->roller->touching[next] == i) {
            next++;
            continue;
        }
        double at[2], height = sfi_dot(p->up, p->roller->corners + 3 * (size_t)i) - p->ground;
        place(p, i, at);
        double along =
            (at[0] - about->at[0]) * about->towards[0] + (at[1] - about->at[1]) * about->towards[1];
        if (along / height > most) {
            most = along / height;
            s = along;
            h = height;
        }
    }
    double reach = sqrt(s * s + h * h);
    if (!(reach > 0)) {
        return 0;
    }
    for (int d = 0; d < 3; d++) {
        double towards = about->towards[0] * p->east[d] + about->towards[1] * p->north[d];
        up[d] = s / reach * p->up[d] - h / reach * towards;
    }
    sfi_normalize(up);
    return 1;
}

// ---------------------------------------------------------------------------------------------
// Until it rests
// ---------------------------------------------------------------------------------------------

// The normal of the polygon that it rests on, up.
static void find_normal(const pose *p, double normal[3])
{
    const double *o = p->roller->corners + 3 * (size_t)p->roller->polygon[0].name;
    double u[3], v[3], n[3];
    memset(normal, 0, 3 * sizeof *normal);
    for (size_t i = 1; i + 1 < p->corners; i++) {
        sfi_subtract(p->roller->corners + 3 * (size_t)p->roller->polygon[i].name, o, u);
        sfi_subtract(p->roller->corners + 3 * (size_t)p->roller->polygon[i + 1].name, o, v);
        sfi_cross(u, v, n);
        for (int d = 0; d < 3; d++) {
            normal[d] += n[d];
        }
    }
    sfi_normalize(normal);
}

// Corners that touch are a tolerance off; where the face itself is rested on as well, that is the
// pose.
static void settle(pose *p)
{
    pose flat = *p;
    pivot none;
    double normal[3];
    if (p->corners > 2) {
        find_normal(p, normal);
        take_up(&flat, normal);
        if (flat.corners > 2 && flat.touching >= p->touching && find_pivot(&flat, &none) == 0) {
            *p = flat;
        } else {
            take_up(p, p->up);
        }
    }
}

static void describe(const pose *p, const double start[3], uint64_t turns, sf_rest *rest,
                     double edge[2][3])
{
    size_t from = 0, to = p->corners == 2;
    double margin = 0; // on a segment or a point it rolls
    if (p->corners > 2) {
        margin = sfi_tipping(find_inside(p, &from), p->height);
        to = (from + 1) % p->corners;
    }
    memcpy(rest->up, p->up, sizeof rest->up);
    rest->tilt_rad = sfi_tilt(start, p->up);
    rest->height_mm = p->height;
    rest->margin_rad = margin;
    rest->turn_count = turns;
    rest->contact_count = p->touching;
    for (int d = 0; d < 3; d++) {
        edge[0][d] = p->roller->corners[3 * (size_t)p->roller->polygon[from].name + (size_t)d];
        edge[1][d] = p->roller->corners[3 * (size_t)p->roller->polygon[to].name + (size_t)d];
    }
}

void sfi_roll(const sfi_roller *roller, const double com[3], const double start[3], sf_rest *rest,
              double edge[2][3])
{
    pose here = {.roller = roller, .com = com}, next;
    pivot about;
    double up[3];
    uint64_t turns = 0, most = 1000 + 4 * (uint64_t)roller->count;
    take_up(&here, start);
    while (turns < most && find_pivot(&here, &about) && tip(&here, &about, up)) {
        next = here;
        take_up(&next, up);
        if (!(next.height < here.height)) {
            take_up(&here, here.up); // the lists of what touches are those of `next`
            break;
        }
        here = next;
        turns++;
    }
    settle(&here);
    describe(&here, start, turns, rest, edge);
}
