// SPDX-License-Identifier: MIT
// Rocking: when a body rolls back to the pose asked for.
//
// A tilt from the pose by the angle phi in the direction d is written as a place in a plane, tau =
// tan(phi) d: the pose lies at 0, the orientations in which one corner v of the hull touches fill a
// convex polygon Q_v, whose corners are the faces around v and whose sides are its edges. In Q_v
// the body turns about v by steepest descent (roll.c), and its tilt shrinks where
//
//     |tau|^2 (c - v)_z - tau . (c - v)_xy < 0
//
// with z along the pose's up: c lies inside of the vertical plane through v across the fall. To
// have it roll back from a range within a tolerance, this is asked of all tau between two circles.
// For a given c that is not below v the left side is convex in tau, and, divided by |tau|, it grows
// along every ray from 0. So it is greatest where a ray leaves Q_v or the outer circle, and there
// in an end of a stretch of edge: it is enough to ask in finitely many places,
//
//     faces within the ring, edges where they cross its circles, and the corners of a polygon of 32
//     sides that stands in for the outer circle, around it,
//
// each time of all corners v that touch there; and each place asks for a half-space
//
//     d . (c - v)_xy >= tan(phi) (c - v)_z,
//
// linear in c. On an edge or a face the way of steepest descent is a mixture of those of its
// corners, and keeps what they keep. So once inside the inner circle the body stays there, and it
// comes to rest in a minimum within.
//
// An equality would leave it undecided, so the floor is let lean by a tenth of a degree, away from
// the pose, but by no more than half the tolerance: phi becomes phi + lean, which keeps what was
// said above (x (x + g) / (1 - x g) is convex and grows). That it does not shrink along with the
// tolerance makes what is safe for a smaller tolerance safe for a larger. Where c may lie below v,
// the convex term is left out instead: d . (c - v)_xy >= 0 is asked for as well. Corners that touch
// within the inner circle are spared that: c is asked to lie above all of them.
//
// The conditions hold together for every c straight above the contact and close to it: low enough
// is always good. They are sufficient; a body may come back by a detour that they forbid.
//
// Source: the rocking toy of R. Prevost and others, "Make It Stand", 2013, table 1; the conditions
// are our own.

#include "balance/stance/reduce.h"
#include "balance/stance/roll.h"
#include "balance/stance/stance.h"
#include "base/math.h"
#include "base/memory.h"
#include "base/status.h"
#include "mesh/vector.h"

#include <math.h>
#include <string.h>

enum { SIDES = 32, STARTS = 16 };
#define FLOOR_RAD 1.7453292519943295e-3 // a tenth of a degree
#define FLOOR_SHARE 0.5                 // of the tolerance, at most
#define FOLDED -0.5 // cosine between normals from which an edge is looked at in two halves
#define COS_PI_16 0.98078528040323044913

typedef struct ring {
    sf_stance *s;
    const sfi_hull *hull;
    const double *points;
    double *normals;           // of the hull's faces
    double inner, outer, lean; // tangents of tolerance, range, and how the floor leans
    double crest;              // the highest of the corners that touch within the inner circle
} ring;

// A direction as east, north, up of the pose.
static void in_frame(const sf_stance *s, const double v[3], double w[3])
{
    w[0] = sfi_dot(s->east, v);
    w[1] = sfi_dot(s->north, v);
    w[2] = sfi_dot(s->options.up, v);
}

static const double *corner(const ring *r, uint32_t place)
{
    return r->points + 3 * (size_t)r->hull->corners[place];
}

// ---------------------------------------------------------------------------------------------
// Half-spaces
// ---------------------------------------------------------------------------------------------

static sf_status add(sf_stance *s, const double normal[3], const double through[3])
{
    void *list = s->halfspaces;
    if (!sfi_grow_array(&s->allocator, &list, &s->halfspace_capacity, s->halfspace_count + 1,
                        sizeof *s->halfspaces)) {
        return SF_ERR_MEMORY;
    }
    s->halfspaces = list;
    sfi_stance_bound(s, normal, through, 0);
    return SF_OK;
}

// The corner that is furthest along a normal.
static const double *furthest(const ring *r, const uint32_t *corners, size_t count,
                              const double normal[3])
{
    const double *best = corner(r, corners[0]);
    for (size_t i = 1; i < count; i++) {
        const double *p = corner(r, corners[i]);
        best = sfi_dot(normal, p) > sfi_dot(normal, best) ? p : best;
    }
    return best;
}

// What the orientation w (in the pose's frame, w[2] > 0) asks for, in which these corners touch.
static sf_status ask(ring *r, const double w[3], const uint32_t *corners, size_t count)
{
    sf_stance *s = r->s;
    double across[3], normal[3], flat = sqrt(w[0] * w[0] + w[1] * w[1]), slope = flat / w[2];
    if (slope < r->inner * (1 - 1e-9)) {
        return SF_OK;
    }
    double steep = (slope + r->lean) / (1 - slope * r->lean);
    for (int d = 0; d < 3; d++) {
        across[d] = (w[0] * s->east[d] + w[1] * s->north[d]) / flat;
        normal[d] = across[d] - steep * s->options.up[d];
    }
    SF_TRY(add(s, normal, furthest(r, corners, count, normal)));
    const double *high = furthest(r, corners, count, s->options.up);
    if (sfi_dot(s->options.up, high) > r->crest) {
        return add(s, across, furthest(r, corners, count, across));
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Edges
// ---------------------------------------------------------------------------------------------

// The orientations from face a to face b, in which an edge touches: a + t (b - a).
typedef struct arc {
    double a[3], b[3];
    uint32_t ends[2];
} arc;

static void at(const arc *e, double t, double w[3])
{
    for (int d = 0; d < 3; d++) {
        w[d] = e->a[d] + t * (e->b[d] - e->a[d]);
    }
}

// The stretch of an arc within the outer polygon; returns 0 where there is none.
static int clip(const ring *r, const arc *e, double *from, double *to)
{
    *from = 0;
    *to = 1;
    for (int i = 0; i < SIDES; i++) {
        double x = sfi_cosine(i), y = sfi_cosine(i - SIDES / 4);
        double a = r->outer * e->a[2] - x * e->a[0] - y * e->a[1];
        double b = r->outer * e->b[2] - x * e->b[0] - y * e->b[1];
        if (a < 0 && b < 0) {
            return 0;
        }
        if (a < 0) {
            *from = a / (a - b) > *from ? a / (a - b) : *from;
        } else if (b < 0) {
            *to = a / (a - b) < *to ? a / (a - b) : *to;
        }
    }
    return *from <= *to;
}

// Where an arc crosses the inner circle; returns how often, 0 to 2, between 0 and 1.
static int cross_inner(const ring *r, const arc *e, double t[2])
{
    double d[3], rr = r->inner * r->inner;
    sfi_subtract(e->b, e->a, d);
    double a = d[0] * d[0] + d[1] * d[1] - rr * d[2] * d[2];
    double b = d[0] * e->a[0] + d[1] * e->a[1] - rr * d[2] * e->a[2];
    double c = e->a[0] * e->a[0] + e->a[1] * e->a[1] - rr * e->a[2] * e->a[2];
    double root = b * b - a * c;
    int count = 0;
    if (!(root >= 0) || a == 0) {
        return 0;
    }
    double q = -(b + (b < 0 ? -sqrt(root) : sqrt(root)));
    double found[2] = {q / a, q != 0 ? c / q : 0};
    for (int i = 0; i < 2; i++) {
        if (found[i] >= 0 && found[i] <= 1 && e->a[2] + found[i] * d[2] > 0) {
            t[count++] = found[i];
        }
    }
    return count;
}

// Whether an orientation lies within the inner circle.
static int is_inner(const ring *r, const double w[3])
{
    return w[2] > 0 && w[0] * w[0] + w[1] * w[1] <= r->inner * r->inner * w[2] * w[2];
}

// Raise the crest by an edge that touches within the inner circle.
static void raise(ring *r, const arc *e)
{
    double t[2];
    if (is_inner(r, e->a) || is_inner(r, e->b) || cross_inner(r, e, t) > 0) {
        for (int i = 0; i < 2; i++) {
            double height = sfi_dot(r->s->options.up, corner(r, e->ends[i]));
            r->crest = height > r->crest ? height : r->crest;
        }
    }
}

// What an edge asks for, where it crosses the circles.
static sf_status ask_edge(ring *r, const arc *e)
{
    double from, to, t[2], w[3];
    if (!clip(r, e, &from, &to)) {
        return SF_OK;
    }
    int count = cross_inner(r, e, t);
    for (int i = 0; i < count; i++) {
        if (t[i] > from && t[i] < to) {
            at(e, t[i], w);
            SF_TRY(ask(r, w, e->ends, 2));
        }
    }
    if (from > 0) {
        at(e, from, w);
        SF_TRY(ask(r, w, e->ends, 2));
    }
    if (to < 1) {
        at(e, to, w);
        SF_TRY(ask(r, w, e->ends, 2));
    }
    return SF_OK;
}

// The arcs of one edge of a face: one, or two where it is folded, with the middle between them.
static int find_arcs(const ring *r, size_t face, size_t index, arc arcs[2])
{
    const sfi_hull *h = r->hull;
    size_t first = h->starts[face], next = index + 1 < h->starts[face + 1] ? index + 1 : first;
    const double *here = r->normals + 3 * face, *there = r->normals + 3 * (size_t)h->across[index];
    double along[3], out[3];
    for (int i = 0; i < 2; i++) {
        arcs[i].ends[0] = h->loops[index];
        arcs[i].ends[1] = h->loops[next];
    }
    int count = sfi_dot(here, there) < FOLDED ? 2 : 1;
    sfi_subtract(corner(r, h->loops[next]), corner(r, h->loops[index]), along);
    sfi_cross(along, here, out);
    sfi_normalize(out);
    in_frame(r->s, here, arcs[0].a);
    in_frame(r->s, there, arcs[count - 1].b);
    if (count == 2) {
        in_frame(r->s, out, arcs[0].b);
        in_frame(r->s, out, arcs[1].a);
    }
    for (int d = 0; d < 3; d++) { // what touches lies opposite to up
        for (int i = 0; i < count; i++) {
            arcs[i].a[d] = -arcs[i].a[d];
            arcs[i].b[d] = -arcs[i].b[d];
        }
    }
    return count;
}

// ---------------------------------------------------------------------------------------------
// Faces, edges, the outer circle
// ---------------------------------------------------------------------------------------------

static int is_outside(const ring *r, const double w[3])
{
    int out = !(w[2] > 0);
    for (int i = 0; i < SIDES; i++) {
        out = out || sfi_cosine(i) * w[0] + sfi_cosine(i - SIDES / 4) * w[1] > r->outer * w[2];
    }
    return out;
}

static sf_status ask_face(ring *r, size_t face)
{
    double w[3];
    const sfi_hull *h = r->hull;
    in_frame(r->s, r->normals + 3 * face, w);
    for (int d = 0; d < 3; d++) {
        w[d] = -w[d];
    }
    return is_outside(r, w)
               ? SF_OK
               : ask(r, w, h->loops + h->starts[face], h->starts[face + 1] - h->starts[face]);
}

// All edges, each once: to raise the crest, or to ask.
static sf_status go_over_edges(ring *r, int is_asking)
{
    const sfi_hull *h = r->hull;
    for (size_t f = 0; f < h->face_count; f++) {
        for (size_t i = h->starts[f]; i < h->starts[f + 1]; i++) {
            arc arcs[2];
            int count = h->across[i] > f ? find_arcs(r, f, i, arcs) : 0;
            for (int j = 0; j < count; j++) {
                if (!is_asking) {
                    raise(r, &arcs[j]);
                } else {
                    SF_TRY(ask_edge(r, &arcs[j]));
                }
            }
            if (is_asking && count == 2 && !is_outside(r, arcs[0].b)) {
                SF_TRY(ask(r, arcs[0].b, arcs[0].ends, 2));
            }
        }
    }
    return SF_OK;
}

static sf_status ask_outer(ring *r)
{
    for (int i = 0; i < SIDES; i++) {
        double share = r->outer / (1 + COS_PI_16), v[3];
        double w[3] = {share * (sfi_cosine(i) + sfi_cosine(i + 1)),
                       share * (sfi_cosine(i - SIDES / 4) + sfi_cosine(i + 1 - SIDES / 4)), 1};
        uint32_t lowest = 0;
        for (int d = 0; d < 3; d++) {
            v[d] = w[0] * r->s->east[d] + w[1] * r->s->north[d] + r->s->options.up[d];
        }
        for (uint32_t p = 1; p < r->hull->corner_count; p++) {
            lowest = sfi_dot(v, corner(r, p)) < sfi_dot(v, corner(r, lowest)) ? p : lowest;
        }
        SF_TRY(ask(r, w, &lowest, 1));
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// All of it
// ---------------------------------------------------------------------------------------------

static sf_status ask_all(ring *r)
{
    double low[3];
    for (size_t f = 0; f < r->hull->face_count; f++) {
        sfi_hull_normal(r->hull, r->points, f, r->normals + 3 * f);
    }
    SF_TRY(go_over_edges(r, 0));
    for (size_t f = 0; f < r->hull->face_count; f++) {
        SF_TRY(ask_face(r, f));
    }
    SF_TRY(go_over_edges(r, 1));
    SF_TRY(ask_outer(r));
    for (int d = 0; d < 3; d++) {
        low[d] = r->crest * r->s->options.up[d];
    }
    return add(r->s, r->s->options.up, low);
}

static sf_status bound(sf_stance *s, const sfi_hull *hull, const double *points)
{
    double most = FLOOR_SHARE * s->options.tolerance_rad;
    ring r = {s,
              hull,
              points,
              NULL,
              sfi_tan(s->options.tolerance_rad),
              sfi_tan(s->options.range_rad),
              sfi_tan(FLOOR_RAD < most ? FLOOR_RAD : most),
              s->ground_mm};
    double middle[3];
    r.normals = sfi_alloc_array(&s->allocator, hull->face_count, 3 * sizeof *r.normals);
    if (r.normals == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = ask_all(&r);
    sfi_free_array(&s->allocator, r.normals, hull->face_count, 3 * sizeof *r.normals);
    for (int d = 0; d < 3; d++) {
        middle[d] = s->low[d] + 0.5 * s->extent[d];
    }
    return status != SF_OK
               ? status
               : sfi_halfspaces_reduce(s->halfspaces, s->halfspace_count, middle, s->diagonal_mm,
                                       &s->allocator, &s->halfspace_count);
}

sf_status sfi_rock_bound(sf_stance *s, sf_mesh_view mesh, sf_fault *fault)
{
    double *points = NULL;
    size_t count = 0;
    sfi_hull hull;
    SF_TRY(sfi_gather(mesh, s->options.region_low_mm, s->options.region_high_mm, &s->allocator,
                      &points, &count));
    sf_status status = sfi_hull_create(points, count, &s->allocator, &hull);
    if (status == SF_OK) {
        status = hull.dimension < 2
                     ? sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                     "what would rock has no width: all its vertices lie on a line")
                     : sfi_hull_corners(&hull, points, &s->allocator, &s->corners);
        s->corner_count = s->corners != NULL ? hull.corner_count : 0;
        if (status == SF_OK) {
            status = bound(s, &hull, points);
        }
        sfi_hull_destroy(&hull, &s->allocator);
    }
    sfi_free_array(&s->allocator, points, count, 3 * sizeof *points);
    return status;
}

// Let it go in the pose asked for, and from all around at the end of the range.
sf_status sfi_rock_judge(const sf_stance *s, const double com[3], sf_stance_verdict *verdict)
{
    sfi_roller roller;
    double reach = sfi_tan(s->options.range_rad), start[3], edge[2][3];
    sf_rest rest;
    SF_TRY(sfi_roller_create(s->corners, s->corner_count, s->diagonal_mm,
                             SFI_CONTACT_SHARE * s->diagonal_mm, &s->allocator, &roller));
    verdict->margin_rad = INFINITY;
    for (int i = -1; i < STARTS; i++) {
        for (int d = 0; d < 3; d++) {
            double away = sfi_cosine(2 * i) * s->east[d] + sfi_cosine(2 * i - 8) * s->north[d];
            start[d] = s->options.up[d] + (i >= 0 ? reach * away : 0);
        }
        sfi_normalize(start);
        sfi_roll(&roller, com, start, &rest, edge);
        double margin = -sfi_tilt(s->options.up, rest.up);
        if (margin < verdict->margin_rad) {
            verdict->margin_rad = margin;
            memcpy(verdict->edge_mm, edge, sizeof edge);
        }
    }
    verdict->stands = -verdict->margin_rad <= s->options.tolerance_rad;
    sfi_roller_destroy(&roller, &s->allocator);
    return SF_OK;
}
