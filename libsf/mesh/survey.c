// SPDX-License-Identifier: MIT
// The patches' winding number, at a point and within a box of voxels.
//
// A walk through the tree of patches (winding.c) takes what is far as dipoles and the rest triangle
// by triangle. Points that lie together share most of that work. Within a box, what lies far off is
// a function to second order (jet.c), made once; only the few triangles near by are left over, and
// boxes within the box start from these.
//
// A near triangle's winding number jumps where the triangle is crossed, but the jump is a whole
// turn, and crossings count it. What is left is as smooth as the distance to the boundary lets it
// be: an edge that two near triangles share cancels, so that a box in the middle of a hole sees no
// edges at all, however many triangles span the hole. So a box knows how the winding number changes
// in it, but for whole turns, and with a proven bound.
//
// Sources: A. Jacobson, L. Kavan, O. Sorkine-Hornung, "Robust inside-outside segmentation using
// generalized winding numbers", 2013; G. Barill, N. Dickson, R. Schmidt, D. Levin, A. Jacobson,
// "Fast winding numbers for soups and clouds", 2018 (dipoles). Patches, boxes and bounds are ours.

#include "mesh/angle.h"
#include "mesh/vector.h"
#include "mesh/winding.h"

#include <math.h>
#include <string.h>

#define PI 0x1.921fb54442d18p+1
#define ROUNDING 0x1p-23   // of all sums, generously
#define FAR_DIPOLE 0x1p-13 // what a node may be off as a dipole, in turns
#define FAR_PATCH 0x1p-14  // a triangle to second order, four times as much with each box within
#define TORN 0.25          // a box that is further off than that is no use

static void add_patch(const sfi_winding *w, const sfi_point *points, uint32_t node, sfi_point q,
                      sfi_angle *sum)
{
    const uint32_t *corner = w->nodes[node].corner;
    const sfi_point *p[3] = {points + corner[0], points + corner[1], points + corner[2]};
    sfi_angle_add(sum, p, q, w->scale);
}

double sfi_winding_estimate(const sfi_winding *winding, const sfi_point *points, sfi_point q,
                            double tolerance, double *error)
{
    sfi_angle sum = {1.0, 0.0, 0};
    double at[3], far = 0.0, wrong = 0.0;
    sfi_winding_place(winding, &q, at);
    tolerance *= 4 * PI;
    for (size_t i = 0; i < winding->node_count;) {
        const sfi_winding_node *node = winding->nodes + i;
        double to[3];
        sfi_subtract(node->center, at, to);
        double square = sfi_dot(to, to), distance = sqrt(square), gap = distance - node->radius;
        double mistake = 2 * node->area_sum * node->radius;
        if (gap > 0.0 && mistake < tolerance * (gap * gap * gap)) {
            far += sfi_dot(node->area, to) / (square * distance);
            wrong += mistake / (gap * gap * gap);
            i += 2 * (size_t)node->edges - 1;
            continue;
        }
        if (node->corner[2] != SFI_NOBODY) {
            add_patch(winding, points, (uint32_t)i, q, &sum);
        }
        i++;
    }
    *error = wrong / (4 * PI) + 1e-9; // rounding, generously
    return sfi_angle_turns(&sum) + far / (4 * PI);
}

int64_t sfi_winding_round(const sfi_winding *winding, const sfi_point *points, sfi_point q)
{
    for (double tolerance = 0x1p-8; tolerance > 0x1p-24; tolerance *= 0x1p-6) {
        double error, value = sfi_winding_estimate(winding, points, q, tolerance, &error);
        double whole = floor(value + 0.5);
        if (fabs(value - whole) + error < 0.5) {
            return (int64_t)whole;
        }
    }
    sfi_angle sum = {1.0, 0.0, 0};
    for (size_t i = 0; i < winding->node_count; i++) {
        if (winding->nodes[i].corner[2] != SFI_NOBODY) {
            add_patch(winding, points, (uint32_t)i, q, &sum);
        }
    }
    return sum.turns;
}

// A triangle as the middle of a box sees it. Edge i runs from corner i to corner i + 1.
typedef struct patch {
    sfi_sight corner[3];
    double edge_length[3], edge_gap[3]; // gap: distance from the middle, less the box's reach
    int touches;                        // whether the triangle comes into the ball
} patch;

// The edge's length, and its distance from the middle squared.
static double look_at_edge(patch *p, int i)
{
    const sfi_sight *a = p->corner + i, *b = p->corner + (i < 2 ? i + 1 : 0);
    double ab[3];
    sfi_subtract(b->at, a->at, ab);
    double square = sfi_dot(ab, ab), along = -sfi_dot(a->at, ab);
    p->edge_length[i] = sqrt(square);
    if (along <= 0.0 || along >= square) {
        return along <= 0.0 ? a->length * a->length : b->length * b->length;
    }
    double off[3], t = along / square;
    for (int c = 0; c < 3; c++) {
        off[c] = a->at[c] + t * ab[c];
    }
    return sfi_dot(off, off);
}

// Whether the triangle's plane cuts the ball, and the point in the middle of the cut lies inside.
static int cuts(const patch *p, double reach)
{
    double edge[3][3], normal[3], out[3];
    for (int i = 0; i < 3; i++) {
        sfi_subtract(p->corner[i < 2 ? i + 1 : 0].at, p->corner[i].at, edge[i]);
    }
    sfi_cross(edge[0], edge[1], normal);
    double height = sfi_dot(normal, p->corner[0].at);
    if (height * height > reach * reach * sfi_dot(normal, normal) * (1.0 + ROUNDING)) {
        return 0;
    }
    for (int i = 0; i < 3; i++) {
        sfi_cross(normal, edge[i], out);
        if (sfi_dot(out, p->corner[i].at) > 0.0) {
            return 0;
        }
    }
    return 1;
}

static void look_at_patch(const sfi_winding *w, const sfi_point *points, const sfi_winding_box *box,
                          uint32_t node, patch *p)
{
    p->touches = 0;
    for (int i = 0; i < 3; i++) {
        sfi_sight *corner = p->corner + i;
        sfi_winding_place(w, points + w->nodes[node].corner[i], corner->at);
        sfi_subtract(corner->at, box->place, corner->at);
        corner->length = sqrt(sfi_dot(corner->at, corner->at));
        corner->inverse = 1.0 / corner->length;
    }
    for (int i = 0; i < 3; i++) {
        p->edge_gap[i] = sqrt(look_at_edge(p, i)) - box->reach;
        p->touches = p->touches || p->edge_gap[i] <= 0.0;
    }
    p->touches = p->touches || cuts(p, box->reach);
}

static double edge_rest(const patch *p, int i, double reach)
{
    return p->edge_gap[i] > 0.0 ? sfi_jet_edge_rest(p->edge_length[i], p->edge_gap[i], reach)
                                : HUGE_VAL;
}

// What a box of the survey adds up.
typedef struct survey {
    const sfi_winding *winding;
    const sfi_point *points;
    sfi_winding_box *box;
    sfi_angle far;    // triangles that are in the jet
    double far_patch; // what each may be off
    patch near[SFI_NEAR_MAX];
} survey;

// Take a triangle into the jet, or keep it. Returns 0 when there are too many to keep.
static int add_triangle(survey *s, uint32_t node)
{
    sfi_winding_box *box = s->box;
    patch spare, *p = box->near_count < SFI_NEAR_MAX ? s->near + box->near_count : &spare;
    look_at_patch(s->winding, s->points, box, node, p);
    double rest = 0.0;
    for (int i = 0; i < 3 && !p->touches; i++) {
        rest += edge_rest(p, i, box->reach);
    }
    if (!p->touches && rest < s->far_patch) {
        const double *corners[3] = {p->corner[0].at, p->corner[1].at, p->corner[2].at};
        double lengths[3] = {p->corner[0].length, p->corner[1].length, p->corner[2].length};
        sfi_angle_add_beside(&s->far, corners, lengths);
        sfi_jet_add_edges(&box->far, p->corner, 7);
        box->far.rest += rest;
        return 1;
    }
    if (box->near_count == SFI_NEAR_MAX) {
        return 0;
    }
    box->plain = box->plain && !p->touches;
    box->near[box->near_count++] = node;
    return 1;
}

static int add_dipole(survey *s, const sfi_winding_node *node)
{
    sfi_winding_box *box = s->box;
    double to[3];
    sfi_subtract(node->center, box->place, to);
    double gap = sqrt(sfi_dot(to, to)) - node->radius - box->reach;
    if (gap <= 0.0) {
        return 0;
    }
    double error = 2 * node->area_sum * node->radius / (gap * gap * gap) / (4 * PI);
    double rest = sfi_jet_dipole_rest(node->area_sum, gap, box->reach);
    if (error + rest >= FAR_DIPOLE) {
        return 0;
    }
    sfi_jet_add_dipole(&box->far, node->area, to);
    box->far.error += error;
    box->far.rest += rest;
    return 1;
}

static int add_tree(survey *s)
{
    for (size_t i = 0; i < s->winding->node_count;) {
        const sfi_winding_node *node = s->winding->nodes + i;
        if (node->area_sum == 0.0 || add_dipole(s, node)) {
            i += 2 * (size_t)node->edges - 1;
            continue;
        }
        if (node->corner[2] != SFI_NOBODY && !add_triangle(s, (uint32_t)i)) {
            return 0;
        }
        i++;
    }
    return 1;
}

// Begin where the box around it left off.
static int add_parent(survey *s, const sfi_winding_box *parent)
{
    double d[3];
    sfi_subtract(s->box->place, parent->place, d);
    s->box->far = parent->far;
    sfi_jet_move(&s->box->far, d, s->box->reach);
    for (uint32_t i = 0; i < parent->near_count; i++) {
        if (!add_triangle(s, parent->near[i])) {
            return 0;
        }
    }
    return 1;
}

// Where a node is in the box's list, or its length. The list rises.
static uint32_t find_near(const sfi_winding_box *box, size_t node)
{
    uint32_t low = 0, high = box->near_count;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (box->near[middle] < node) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low < box->near_count && box->near[low] == node ? low : box->near_count;
}

// Forget the edges that near triangles share: bit i of `live` is edge i. A node's own triangle has
// its left child's chord for edge 0, its right child's for edge 1, and its own for edge 2.
static void cancel_edges(const sfi_winding_box *box, const sfi_winding_node *nodes,
                         unsigned char *live)
{
    memset(live, 7, box->near_count);
    for (uint32_t n = 0; n < box->near_count; n++) {
        size_t node = box->near[n], left = node + 1;
        size_t right = left + 2 * (size_t)nodes[left].edges - 1;
        size_t beside = node + 2 * (size_t)nodes[node].edges - 1; // of a left child: its sibling
        const sfi_winding_node *over = nodes + node - 1;          // the root has no triangle
        uint32_t child = find_near(box, left);
        if (child < box->near_count) {
            live[n] &= 6;
            live[child] &= 3;
        }
        child = find_near(box, right);
        if (child < box->near_count) {
            live[n] &= 5;
            live[child] &= 3;
        }
        int halves = over->corner[0] != SFI_NOBODY && over->corner[2] == SFI_NOBODY;
        child = halves && over->edges > 1 ? find_near(box, beside) : box->near_count;
        if (child < box->near_count) { // both halves of a loop: one chord, there and back
            live[n] &= 3;
            live[child] &= 3;
        }
    }
}

// Far and near together, but for whole turns.
static void add_near(survey *s)
{
    sfi_winding_box *box = s->box;
    unsigned char live[SFI_NEAR_MAX];
    sfi_angle sum = {1.0, 0.0, 0};
    cancel_edges(box, s->winding->nodes, live);
    box->all = box->far;
    for (uint32_t n = 0; n < box->near_count; n++) {
        for (int i = 0; i < 3; i++) {
            box->all.rest += (live[n] >> i & 1) ? edge_rest(s->near + n, i, box->reach) : 0.0;
        }
    }
    box->smooth = box->all.error + box->all.rest < TORN;
    for (uint32_t n = 0; n < box->near_count && box->smooth; n++) {
        sfi_jet_add_edges(&box->all, s->near[n].corner, live[n]);
        add_patch(s->winding, s->points, box->near[n], box->middle, &sum);
    }
    box->all.value += box->near_count > 0 ? sfi_angle_turns(&sum) : 0.0;
}

// Where the box lies: its voxels' centres, and half a voxel beyond them along x.
static void place_box(const sfi_winding *w, sfi_point low, sfi_point high, sfi_winding_box *box)
{
    double from[3], to[3], half[3];
    box->middle.x = low.x + (high.x - low.x) / 2;
    box->middle.y = low.y + (high.y - low.y) / 2;
    box->middle.z = low.z + (high.z - low.z) / 2;
    low.x -= SFI_UNITS / 2;
    high.x += SFI_UNITS / 2;
    sfi_winding_place(w, &box->middle, box->place);
    sfi_winding_place(w, &low, from);
    sfi_winding_place(w, &high, to);
    for (int i = 0; i < 3; i++) {
        double before = box->place[i] - from[i], after = to[i] - box->place[i];
        half[i] = before > after ? before : after;
    }
    box->reach = sqrt(sfi_dot(half, half));
}

void sfi_winding_survey(const sfi_winding *winding, const sfi_point *points, sfi_point low,
                        sfi_point high, const sfi_winding_box *parent, sfi_winding_box *box)
{
    survey s;
    s.winding = winding;
    s.points = points;
    s.box = box;
    s.far = (sfi_angle){1.0, 0.0, 0};
    place_box(winding, low, high, box);
    memset(&box->far, 0, sizeof box->far);
    box->far.ball_inverse = 1.0 / (box->reach * box->reach);
    box->near_count = 0;
    box->plain = 1;
    box->smooth = 0;
    int within = parent != NULL && !parent->dense;
    box->depth = parent != NULL ? parent->depth + 1 : 0;
    s.far_patch = ldexp(FAR_PATCH, 2 * box->depth);
    box->dense = !(within ? add_parent(&s, parent) : add_tree(&s));
    if (box->dense) {
        return;
    }
    box->far.value += sfi_angle_turns(&s.far);
    box->far.error += ROUNDING;
    add_near(&s);
}

double sfi_winding_in(const sfi_winding *winding, const sfi_point *points,
                      const sfi_winding_box *box, sfi_point q, double *error)
{
    sfi_angle sum = {1.0, 0.0, 0};
    double at[3];
    for (uint32_t i = 0; i < box->near_count; i++) {
        add_patch(winding, points, box->near[i], q, &sum);
    }
    sfi_winding_place(winding, &q, at);
    sfi_subtract(at, box->place, at);
    *error = sfi_jet_error(&box->far, at);
    return sfi_angle_turns(&sum) + sfi_jet_at(&box->far, at);
}
