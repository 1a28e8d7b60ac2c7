// SPDX-License-Identifier: MIT
// The patches' winding number, at a point and within a box of voxels.
//
// A walk through the tree of patches (winding.c) takes what is far as dipoles and the rest triangle
// by triangle. Points that lie together share most of that work: within a box, triangles that do
// not come near it add up to a smooth function, which is taken as linear along each axis between
// its eight corners, and only the few near ones are looked at for each voxel. How far off the
// linear function is, is measured at the middle of the box and taken three times over; a voxel
// whose winding number is not clear of a half by that much is computed in full.
//
// Sources: A. Jacobson, L. Kavan, O. Sorkine-Hornung, "Robust inside-outside segmentation using
// generalized winding numbers", 2013; G. Barill, N. Dickson, R. Schmidt, D. Levin, A. Jacobson,
// "Fast winding numbers for soups and clouds", 2018 (dipoles). Patches and boxes are ours.

#include "mesh/angle.h"
#include "mesh/vector.h"
#include "mesh/winding.h"

#include <math.h>

#define PI 0x1.921fb54442d18p+1
#define LOOKS 9 // eight corners and the middle

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

// Square of the distance from a point to a triangle: the nearest point on the plane if it lies
// inside all three edges, else the nearest on an edge.
static double distance_square(const sfi_winding *w, const sfi_point *points,
                              const uint32_t corner[3], const double at[3])
{
    double p[3][3], edge[3][3], to[3][3], least = HUGE_VAL, normal[3];
    for (int i = 0; i < 3; i++) {
        sfi_winding_place(w, points + corner[i], p[i]);
    }
    for (int i = 0; i < 3; i++) {
        sfi_subtract(p[(i + 1) % 3], p[i], edge[i]);
        sfi_subtract(at, p[i], to[i]);
        double square = sfi_dot(edge[i], edge[i]), along = sfi_dot(to[i], edge[i]), off[3];
        double t = square > 0.0 ? along / square : 0.0;
        t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
        for (int c = 0; c < 3; c++) {
            off[c] = to[i][c] - t * edge[i][c];
        }
        least = sfi_dot(off, off) < least ? sfi_dot(off, off) : least;
    }
    sfi_cross(edge[0], edge[1], normal);
    int inside = 1;
    for (int i = 0; i < 3; i++) {
        double out[3];
        sfi_cross(normal, edge[i], out);
        inside = inside && sfi_dot(out, to[i]) >= 0.0;
    }
    double height = sfi_dot(normal, to[0]), size = sfi_dot(normal, normal);
    if (inside && size > 0.0 && height * height / size < least) {
        return height * height / size;
    }
    return least;
}

// What a survey adds up.
typedef struct view {
    const sfi_winding *winding;
    const sfi_point *points;
    sfi_point at[LOOKS];
    double place[LOOKS][3], far[LOOKS], wrong, reach; // reach: from the middle to the corners
    sfi_angle sum[LOOKS];
} view;

static void open_view(view *v, const sfi_winding *w, const sfi_point *points, sfi_point low,
                      sfi_point high)
{
    v->winding = w;
    v->points = points;
    v->wrong = 0.0;
    for (int i = 0; i < LOOKS; i++) {
        v->at[i].x = i & 1 ? high.x : low.x;
        v->at[i].y = i & 2 ? high.y : low.y;
        v->at[i].z = i & 4 ? high.z : low.z;
        if (i == LOOKS - 1) {
            v->at[i].x = low.x + (high.x - low.x) / 2;
            v->at[i].y = low.y + (high.y - low.y) / 2;
            v->at[i].z = low.z + (high.z - low.z) / 2;
        }
        sfi_winding_place(w, &v->at[i], v->place[i]);
        v->far[i] = 0.0;
        v->sum[i] = (sfi_angle){1.0, 0.0, 0};
    }
    double half[3];
    sfi_subtract(v->place[7], v->place[0], half);
    v->reach = sqrt(sfi_dot(half, half)) / 2;
}

// Take a node as a dipole if that is good enough everywhere in the box.
static int add_dipole(view *v, const sfi_winding_node *node)
{
    double to[3];
    sfi_subtract(node->center, v->place[LOOKS - 1], to);
    double gap = sqrt(sfi_dot(to, to)) - node->radius - v->reach;
    double mistake = 2 * node->area_sum * node->radius;
    if (!(gap > v->reach && mistake < 4 * PI * 0x1p-9 * (gap * gap * gap))) {
        return 0;
    }
    v->wrong += mistake / (4 * PI * gap * gap * gap);
    for (int i = 0; i < LOOKS; i++) {
        sfi_subtract(node->center, v->place[i], to);
        double square = sfi_dot(to, to);
        v->far[i] += sfi_dot(node->area, to) / (square * sqrt(square));
    }
    return 1;
}

static double linear(const double corner[8], double x, double y, double z)
{
    double along[4];
    for (int i = 0; i < 4; i++) {
        along[i] = corner[2 * i] + x * (corner[2 * i + 1] - corner[2 * i]);
    }
    double low = along[0] + y * (along[1] - along[0]), high = along[2] + y * (along[3] - along[2]);
    return low + z * (high - low);
}

static double share_of(double low, double at, double high)
{
    return high > low ? (at - low) / (high - low) : 0.0;
}

static void close_view(const view *v, sfi_winding_block *block)
{
    double value[LOOKS], low = HUGE_VAL, high = -HUGE_VAL, share[3];
    for (int i = 0; i < LOOKS; i++) {
        value[i] = sfi_angle_turns(&v->sum[i]) + v->far[i] / (4 * PI);
        low = value[i] < low ? value[i] : low;
        high = value[i] > high ? value[i] : high;
    }
    for (int i = 0; i < 8; i++) {
        block->corner[i] = value[i];
    }
    for (int i = 0; i < 3; i++) {
        share[i] = share_of(v->place[0][i], v->place[8][i], v->place[7][i]);
    }
    double bend = fabs(linear(value, share[0], share[1], share[2]) - value[8]);
    block->error = 3 * bend + v->wrong + 1e-3;
    double whole = floor(low - block->error + 0.5);
    block->whole = (int64_t)whole;
    block->uniform = block->near_count == 0 && high + block->error < whole + 0.5;
}

void sfi_winding_survey(const sfi_winding *winding, const sfi_point *points, sfi_point low,
                        sfi_point high, sfi_winding_block *block)
{
    view v;
    open_view(&v, winding, points, low, high);
    block->near_count = 0;
    block->dense = block->uniform = 0;
    double limit = 4 * v.reach * v.reach;
    for (size_t i = 0; i < winding->node_count;) {
        const sfi_winding_node *node = winding->nodes + i;
        if (node->area_sum == 0.0 || add_dipole(&v, node)) {
            i += 2 * (size_t)node->edges - 1;
            continue;
        }
        if (node->corner[2] == SFI_NOBODY) {
            i++;
            continue;
        }
        if (distance_square(winding, points, node->corner, v.place[LOOKS - 1]) > limit) {
            for (int n = 0; n < LOOKS; n++) {
                add_patch(winding, points, (uint32_t)i, v.at[n], &v.sum[n]);
            }
        } else if (block->near_count == SFI_NEAR_MAX) {
            block->dense = 1;
            return;
        } else {
            block->near[block->near_count++] = (uint32_t)i;
        }
        i++;
    }
    close_view(&v, block);
}

int64_t sfi_winding_round_in(const sfi_winding *winding, const sfi_point *points,
                             const sfi_winding_block *block, const double share[3], sfi_point q)
{
    if (!block->dense) {
        sfi_angle sum = {1.0, 0.0, 0};
        for (uint32_t i = 0; i < block->near_count; i++) {
            add_patch(winding, points, block->near[i], q, &sum);
        }
        double value = sfi_angle_turns(&sum) + linear(block->corner, share[0], share[1], share[2]);
        double whole = floor(value + 0.5);
        if (fabs(value - whole) + block->error < 0.5) {
            return (int64_t)whole;
        }
    }
    return sfi_winding_round(winding, points, q);
}
