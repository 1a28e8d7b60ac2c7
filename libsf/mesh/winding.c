// SPDX-License-Identifier: MIT
// How far the patches over a mesh's holes wind around a point.
//
// An open mesh has no inside, but it has a winding number: the solid angle that it fills around a
// point, over 4 pi, which is 1 within a closed mesh, 0 outside, and falls off smoothly through a
// hole. To compute it, close every hole with a patch. Mesh and patches together are closed, and
// their winding number is an integer that crossings give exactly; the patches' own is subtracted.
// It does not matter which patch is taken, so each loop is halved, and its halves again: the
// triangle between both ends and the middle, and a smaller patch over each half.
//
// That makes a tree. Seen from afar a patch is a dipole: its vector area in place of its triangles
// is wrong by at most 2 S r / g^3, with S the area, r the radius, g the distance from the ball,
// since (x - q) / |x - q|^3 changes by at most 2 / |x - q|^3 a unit. The slivers along a smooth rim
// have next to no area, and so a point looks at few triangles however long the rim is.
//
// How fast the winding number changes depends on the rim alone: by Biot and Savart's law its
// gradient is the integral of dl / |x - q|^2 over the rim, at most, over 4 pi. (Along the patch
// itself the patches' number jumps by 1, and so does the crossings'.)
//
// Solid angles: A. van Oosterom, J. Strackee, "The solid angle of a plane triangle", 1983. Their
// tangent of half the angle is num / den, and the angles of many triangles are added by multiplying
// the complex numbers den + i num and counting turns, so a whole number of turns comes out without
// any arc tangent; num is an exact integer, so a patch that lies in one plane is judged exactly.
//
// Sources: A. Jacobson, L. Kavan, O. Sorkine-Hornung, "Robust inside-outside segmentation using
// generalized winding numbers", 2013; G. Barill, N. Dickson, R. Schmidt, D. Levin, A. Jacobson,
// "Fast winding numbers for soups and clouds", 2018 (dipoles); patches, halving and bounds are
// ours.

#include "mesh/winding.h"

#include "base/math.h"
#include "base/memory.h"
#include "base/size.h"

#include <math.h>
#include <string.h>

#define PI 0x1.921fb54442d18p+1

static void place(const sfi_winding *w, const sfi_point *p, double out[3])
{
    out[0] = p->x * w->scale[0];
    out[1] = p->y * w->scale[1];
    out[2] = p->z * w->scale[2];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static void subtract(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = a[i] - b[i];
    }
}

// ------------------------------------------------------------------------------------ the tree

typedef struct stretch {
    size_t edge0, edge1, loop0, loop1;
} stretch;

static uint32_t point_at(const sfi_loops *loops, size_t loop, size_t edge)
{
    return loops->points[edge == loops->starts[loop + 1] ? loops->starts[loop] : edge];
}

// Corners of the node over a stretch; returns where it is to be halved.
static stretch name_node(const sfi_loops *loops, stretch s, sfi_winding_node *node)
{
    stretch left = s;
    node->edges = (uint32_t)(s.edge1 - s.edge0);
    node->corner[0] = node->corner[1] = node->corner[2] = SFI_NOBODY;
    if (s.loop1 - s.loop0 > 1) {
        left.loop1 = s.loop0 + (s.loop1 - s.loop0) / 2;
        left.edge1 = loops->starts[left.loop1];
        return left;
    }
    left.edge1 = s.edge0 + (s.edge1 - s.edge0) / 2;
    node->corner[0] = point_at(loops, s.loop0, s.edge0);
    node->corner[1] = point_at(loops, s.loop0, node->edges > 1 ? left.edge1 : s.edge1);
    if (node->edges > 1 && s.edge1 - s.edge0 < loops->starts[s.loop1] - loops->starts[s.loop0]) {
        node->corner[2] = point_at(loops, s.loop0, s.edge1);
    }
    return left;
}

static void name_nodes(const sfi_loops *loops, sfi_winding *w)
{
    stretch stack[80]; // one waiting sibling for each halving of at most 2^32 edges, twice
    size_t depth = 0;
    stack[depth++] = (stretch){0, loops->edge_count, 0, loops->loop_count};
    for (size_t i = 0; i < w->node_count; i++) {
        stretch s = stack[--depth], left = name_node(loops, s, &w->nodes[i]);
        w->patch_count += w->nodes[i].corner[2] != SFI_NOBODY;
        if (w->nodes[i].edges > 1) {
            int apart = s.loop1 - s.loop0 > 1;
            stretch right = {left.edge1, s.edge1, apart ? left.loop1 : s.loop0, s.loop1};
            stack[depth++] = right;
            stack[depth++] = left;
        }
    }
}

typedef struct extent {
    double low[3], high[3];
} extent;

static void measure_edge(const sfi_winding *w, const sfi_point *points, sfi_winding_node *node,
                         extent *box)
{
    double a[3], b[3], ab[3];
    place(w, points + node->corner[0], a);
    place(w, points + node->corner[1], b);
    subtract(b, a, ab);
    node->length = sqrt(dot(ab, ab));
    for (int i = 0; i < 3; i++) {
        box->low[i] = a[i] < b[i] ? a[i] : b[i];
        box->high[i] = a[i] < b[i] ? b[i] : a[i];
        node->area[i] = 0.0;
    }
    node->area_sum = 0.0;
}

static void measure_patch(const sfi_winding *w, const sfi_point *points, sfi_winding_node *node,
                          extent *box)
{
    const sfi_winding_node *left = node + 1, *right = node + 2 * (size_t)left->edges;
    const extent *a = box + 1, *b = box + 2 * (size_t)left->edges;
    double half[3] = {0.0, 0.0, 0.0};
    if (node->corner[2] != SFI_NOBODY) {
        double p[3][3], u[3], v[3];
        for (int i = 0; i < 3; i++) {
            place(w, points + node->corner[i], p[i]);
        }
        subtract(p[1], p[0], u);
        subtract(p[2], p[0], v);
        cross(u, v, half);
    }
    node->length = left->length + right->length;
    node->area_sum = left->area_sum + right->area_sum + sqrt(dot(half, half)) / 2;
    for (int i = 0; i < 3; i++) {
        node->area[i] = left->area[i] + right->area[i] + half[i] / 2;
        box->low[i] = a->low[i] < b->low[i] ? a->low[i] : b->low[i];
        box->high[i] = a->high[i] > b->high[i] ? a->high[i] : b->high[i];
    }
}

// Children follow their parents, so the way back meets them first.
static void measure_nodes(const sfi_point *points, sfi_winding *w, extent *boxes)
{
    for (size_t i = w->node_count; i-- > 0;) {
        sfi_winding_node *node = w->nodes + i;
        if (node->edges == 1) {
            measure_edge(w, points, node, boxes + i);
        } else {
            measure_patch(w, points, node, boxes + i);
        }
        double diagonal[3];
        for (int c = 0; c < 3; c++) {
            node->center[c] = (boxes[i].low[c] + boxes[i].high[c]) / 2;
            diagonal[c] = (boxes[i].high[c] - boxes[i].low[c]) / 2;
        }
        node->radius = sqrt(dot(diagonal, diagonal));
    }
}

sf_status sfi_winding_create(const sfi_frame *frame, const sfi_point *points,
                             const sfi_loops *loops, const sf_allocator *allocator,
                             sfi_winding *winding)
{
    memset(winding, 0, sizeof *winding);
    for (int i = 0; i < 3; i++) {
        winding->scale[i] = frame->voxel_mm[i] / frame->voxel_mm[0];
    }
    if (loops->edge_count == 0) {
        return SF_OK;
    }
    size_t count;
    if (loops->edge_count > UINT32_MAX || !sfi_size_mul(loops->edge_count, 2, &count)) {
        return SF_ERR_OVERFLOW;
    }
    winding->node_count = count - 1;
    winding->nodes = sfi_alloc_array(allocator, winding->node_count, sizeof *winding->nodes);
    extent *boxes = sfi_alloc_array(allocator, winding->node_count, sizeof *boxes);
    int good = winding->nodes != NULL && boxes != NULL;
    if (good) {
        name_nodes(loops, winding);
        measure_nodes(points, winding, boxes);
    }
    sfi_free_array(allocator, boxes, winding->node_count, sizeof *boxes);
    if (!good) {
        sfi_winding_destroy(winding, allocator);
    }
    return good ? SF_OK : SF_ERR_MEMORY;
}

void sfi_winding_destroy(sfi_winding *winding, const sf_allocator *allocator)
{
    sfi_free_array(allocator, winding->nodes, winding->node_count, sizeof *winding->nodes);
    memset(winding, 0, sizeof *winding);
}

void sfi_winding_patches(const sfi_winding *winding, uint32_t *triangles)
{
    for (size_t i = 0; i < winding->node_count; i++) {
        const uint32_t *corner = winding->nodes[i].corner;
        if (corner[2] != SFI_NOBODY) {
            memcpy(triangles, corner, 3 * sizeof *triangles);
            triangles += 3;
        }
    }
}

void sfi_winding_flip(sfi_winding *winding)
{
    for (size_t i = 0; i < winding->node_count; i++) {
        sfi_winding_node *node = winding->nodes + i;
        uint32_t swap = node->corner[0];
        node->corner[0] = node->corner[1];
        node->corner[1] = swap;
        for (int c = 0; c < 3; c++) {
            node->area[c] = -node->area[c];
        }
    }
}

// -------------------------------------------------------------------------------------- angles

// Half a solid angle in (-pi, pi], as a direction, and whole turns beyond it.
typedef struct angle {
    double re, im;
    int64_t turns;
} angle;

static void add_angle(angle *sum, double re, double im)
{
    int up = sum->im > 0.0 || (sum->im == 0.0 && sum->re < 0.0), down = sum->im < 0.0;
    int step_up = im > 0.0 || (im == 0.0 && re < 0.0), step_down = im < 0.0;
    double x = sum->re * re - sum->im * im, y = sum->re * im + sum->im * re;
    int now_up = y > 0.0 || (y == 0.0 && x < 0.0);
    sum->turns += up && step_up && !now_up;
    sum->turns -= down && step_down && now_up;
    double size = fabs(x) > fabs(y) ? fabs(x) : fabs(y);
    double unit = size > 0x1p200 ? 0x1p-200 : size < 0x1p-200 ? 0x1p200 : 1.0;
    sum->re = x * unit;
    sum->im = y * unit;
}

// An angle of exactly half a turn, up or down.
static void add_half_turn(angle *sum, int up)
{
    add_angle(sum, -1.0, 0.0);
    sum->turns -= !up;
}

static double angle_turns(const angle *a)
{
    double part;
    if (a->re > 0.0) {
        part = sfi_atan(a->im / a->re);
    } else if (a->re < 0.0) {
        part = sfi_atan(a->im / a->re) + (a->im < 0.0 ? -PI : PI);
    } else {
        part = a->im < 0.0 ? -PI / 2 : PI / 2;
    }
    return (double)a->turns + part / (2 * PI);
}

static double denominator(const double v[3][3])
{
    double a = sqrt(dot(v[0], v[0])), b = sqrt(dot(v[1], v[1])), c = sqrt(dot(v[2], v[2]));
    return a * b * c + dot(v[0], v[1]) * c + dot(v[1], v[2]) * a + dot(v[2], v[0]) * b;
}

// Normal of an integer triangle. Exact while its edges stay below 2^30.
static void normal(const sfi_point *p[3], int64_t n[3])
{
    int64_t ux = (int64_t)p[1]->x - p[0]->x, vx = (int64_t)p[2]->x - p[0]->x;
    int64_t uy = (int64_t)p[1]->y - p[0]->y, vy = (int64_t)p[2]->y - p[0]->y;
    int64_t uz = (int64_t)p[1]->z - p[0]->z, vz = (int64_t)p[2]->z - p[0]->z;
    n[0] = uy * vz - uz * vy;
    n[1] = uz * vx - ux * vz;
    n[2] = ux * vy - uy * vx;
}

#define NARROW ((int64_t)1 << 20) // products of three numbers below it, six of them, fit 63 bits

// Six times the volume between q and the triangle: exact within 2^20 units (4096 voxels) of q.
static double height(const sfi_point *p[3], const int64_t n[3], sfi_point q)
{
    int64_t x = (int64_t)p[0]->x - q.x, y = (int64_t)p[0]->y - q.y, z = (int64_t)p[0]->z - q.z;
    const int64_t most = NARROW * NARROW;
    if (x > -NARROW && x < NARROW && y > -NARROW && y < NARROW && z > -NARROW && z < NARROW &&
        n[0] > -most && n[0] < most && n[1] > -most && n[1] < most && n[2] > -most && n[2] < most) {
        return (double)(x * n[0] + y * n[1] + z * n[2]);
    }
    return (double)x * (double)n[0] + (double)y * (double)n[1] + (double)z * (double)n[2];
}

// q lies in the triangle's plane, up to nothing: it is taken to lie just beyond, first in x.
static void add_flat(angle *sum, double v[3][3], const int64_t n[3], const double scale[3])
{
    int64_t first = n[0] != 0 ? n[0] : n[1] != 0 ? n[1] : n[2];
    if (first == 0) {
        return; // no area
    }
    double a = sqrt(dot(v[0], v[0])), b = sqrt(dot(v[1], v[1])), c = sqrt(dot(v[2], v[2]));
    double den = denominator((const double(*)[3])v), little = 1e-12 * a * b * c;
    if (den > little) {
        return; // beside the triangle
    }
    if (den < -little) {
        add_half_turn(sum, first < 0);
        return;
    }
    // On an edge or a corner, where it matters from which side the angle is seen.
    static const double aside[3] = {0x1p-2, 0x1p-4, 0x1p-6};
    double num = 0.0;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            v[j][i] -= aside[i] * scale[i];
        }
        num += aside[i] * (double)n[i];
    }
    num = fabs(num) * scale[0] * scale[1] * scale[2];
    add_angle(sum, denominator((const double(*)[3])v), first < 0 ? num : -num);
}

static void add_triangle(const sfi_winding *w, const sfi_point *points,
                         const sfi_winding_node *node, sfi_point q, angle *sum)
{
    const sfi_point *p[3];
    double v[3][3];
    int64_t n[3];
    for (int i = 0; i < 3; i++) {
        p[i] = points + node->corner[i];
        v[i][0] = (double)((int64_t)p[i]->x - q.x) * w->scale[0];
        v[i][1] = (double)((int64_t)p[i]->y - q.y) * w->scale[1];
        v[i][2] = (double)((int64_t)p[i]->z - q.z) * w->scale[2];
    }
    normal(p, n);
    double num = height(p, n, q);
    if (num == 0.0) {
        add_flat(sum, v, n, w->scale);
    } else {
        add_angle(sum, denominator((const double(*)[3])v),
                  num * w->scale[0] * w->scale[1] * w->scale[2]);
    }
}

double sfi_winding_estimate(const sfi_winding *winding, const sfi_point *points, sfi_point q,
                            double tolerance, double *error)
{
    angle sum = {1.0, 0.0, 0};
    double at[3], far = 0.0, wrong = 0.0;
    place(winding, &q, at);
    tolerance *= 4 * PI;
    for (size_t i = 0; i < winding->node_count;) {
        const sfi_winding_node *node = winding->nodes + i;
        double to[3];
        subtract(node->center, at, to);
        double square = dot(to, to), distance = sqrt(square), gap = distance - node->radius;
        double mistake = 2 * node->area_sum * node->radius;
        if (gap > 0.0 && mistake < tolerance * (gap * gap * gap)) {
            far += dot(node->area, to) / (square * distance);
            wrong += mistake / (gap * gap * gap);
            i += 2 * (size_t)node->edges - 1;
            continue;
        }
        if (node->corner[2] != SFI_NOBODY) {
            add_triangle(winding, points, node, q, &sum);
        }
        i++;
    }
    *error = wrong / (4 * PI) + 1e-9; // rounding, generously
    return angle_turns(&sum) + far / (4 * PI);
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
    angle sum = {1.0, 0.0, 0};
    for (size_t i = 0; i < winding->node_count; i++) {
        if (winding->nodes[i].corner[2] != SFI_NOBODY) {
            add_triangle(winding, points, winding->nodes + i, q, &sum);
        }
    }
    return sum.turns;
}

// Distance from a point to the edge of a leaf.
static double edge_distance(const sfi_winding *w, const sfi_point *points,
                            const sfi_winding_node *node, const double at[3])
{
    double a[3], b[3], ab[3], to[3];
    place(w, points + node->corner[0], a);
    place(w, points + node->corner[1], b);
    subtract(b, a, ab);
    subtract(at, a, to);
    double square = dot(ab, ab), along = dot(to, ab);
    double t = square > 0.0 ? along / square : 0.0;
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    for (int i = 0; i < 3; i++) {
        to[i] -= t * ab[i];
    }
    return sqrt(dot(to, to));
}

// The integral along a straight edge is at most length / distance^2, and at most pi / distance.
// A patch over whole loops also changes by no more than its area lets it: 2 S / g^3.
double sfi_winding_slope(const sfi_winding *winding, const sfi_point *points, sfi_point q,
                         double reach)
{
    double at[3], sum = 0.0, most = reach > 0.0 ? 2 * PI / reach : HUGE_VAL;
    place(winding, &q, at);
    for (size_t i = 0; i < winding->node_count && sum <= most;) {
        const sfi_winding_node *node = winding->nodes + i;
        double to[3], part;
        subtract(node->center, at, to);
        double gap = sqrt(dot(to, to)) - node->radius - reach;
        if (gap > node->radius) {
            part = node->length / (gap * gap);
            int whole = node->edges > 1 && node->corner[2] == SFI_NOBODY;
            if (whole && 2 * node->area_sum < node->length * gap) {
                part = 2 * node->area_sum / (gap * gap * gap);
            }
            i += 2 * (size_t)node->edges - 1;
        } else if (node->edges == 1) {
            gap = edge_distance(winding, points, node, at) - reach;
            if (gap <= 0.0) {
                return HUGE_VAL;
            }
            part = node->length < PI * gap ? node->length / (gap * gap) : PI / gap;
            i++;
        } else {
            part = 0.0;
            i++;
        }
        sum += part;
    }
    return sum <= most ? sum / (4 * PI) * (1 + 1e-9) : HUGE_VAL;
}
