// SPDX-License-Identifier: MIT
// Blending: points that follow handles, how they move with poses, and what a gradient of theirs
// says about poses.
//
// A blend is linear in the affine maps A_j p + b_j of the handles: each point mixes them by its
// weights and applies the mixture, twelve products a handle and nine a point. A change of poses is
// a change of maps,
//
//     dA = ds R + s [spin] R,   db = dt - dA c,
//
// and so is applied in the same way. Its transpose sums over the points, for each handle, w g and
// w g p^T (g the gradient at the point); with F the first and B the second, less F c^T,
//
//     d/dt = F,   d/ds = R : B,   d/dspin = the axis of s B R^T, that is sum of w s R (p - c) x g.
//
// So neither needs to know more than the weights, whatever the poses, and no matrix of points times
// parameters is made. Sums run over stretches of a fixed length, which are added in their order.

#include "balance/blend/blend.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"

#include <string.h>

enum { STRETCH = 4096 };

static size_t stretches(size_t points)
{
    return points / STRETCH + (points % STRETCH != 0);
}

static size_t stretch_end(size_t index, size_t points)
{
    return points - index * STRETCH > STRETCH ? (index + 1) * STRETCH : points;
}

static int is_blend(const sf_blend *b, const sf_pose *poses)
{
    return poses != NULL && b->centers_mm != NULL && b->handle_count >= 1 &&
           b->handle_count <= SF_HANDLE_MAX &&
           (b->point_count == 0 || (b->rest_mm != NULL && b->weights != NULL));
}

// ---------------------------------------------------------------------------------------------
// Forwards
// ---------------------------------------------------------------------------------------------

typedef struct apply {
    sf_blend blend;
    double *out;
    sfi_map maps[SF_HANDLE_MAX];
} apply;

static void apply_stretch(void *context, size_t index)
{
    const apply *a = context;
    size_t count = a->blend.handle_count;
    for (size_t i = index * STRETCH; i < stretch_end(index, a->blend.point_count); i++) {
        double moved[3];
        sfi_map mix;
        sfi_maps_mix(a->maps, a->blend.weights + i * count, count, &mix);
        sfi_map_turn(mix.matrix, a->blend.rest_mm + 3 * i, moved);
        for (size_t n = 0; n < 3; n++) {
            a->out[3 * i + n] = moved[n] + mix.shift[n];
        }
    }
}

static sf_status apply_all(apply *a, sf_task *task)
{
    if (sf_task_is_cancelled(task)) {
        return SF_ERR_CANCELLED;
    }
    sfi_task_for(task, stretches(a->blend.point_count), apply_stretch, a);
    return SF_OK;
}

sf_status sf_blend_apply(sf_blend blend, const sf_pose *poses, sf_task *task, double *xyz_mm)
{
    apply a = {.blend = blend, .out = xyz_mm};
    if (!is_blend(&blend, poses) || (blend.point_count > 0 && xyz_mm == NULL) ||
        !sfi_maps_make(poses, blend.centers_mm, blend.handle_count, a.maps)) {
        return SF_ERR_ARGUMENT;
    }
    return apply_all(&a, task);
}

// The change of a map that a change of its pose is.
static void change_map(const sf_pose *pose, const double center[3], const sf_pose_change *change,
                       sfi_map *map)
{
    const double *w = change->spin_rad;
    const double spin[9] = {0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0};
    double turned[3];
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++) {
            double spun = (spin[3 * r] * pose->turn[c] + spin[3 * r + 1] * pose->turn[3 + c]) +
                          spin[3 * r + 2] * pose->turn[6 + c];
            map->matrix[3 * r + c] = change->scale * pose->turn[3 * r + c] + pose->scale * spun;
        }
    }
    sfi_map_turn(map->matrix, center, turned);
    for (int n = 0; n < 3; n++) {
        map->shift[n] = change->shift_mm[n] - turned[n];
    }
}

sf_status sf_blend_push(sf_blend blend, const sf_pose *poses, const sf_pose_change *changes,
                        sf_task *task, double *moves)
{
    apply a = {.blend = blend, .out = moves};
    if (!is_blend(&blend, poses) || changes == NULL || (blend.point_count > 0 && moves == NULL) ||
        !sfi_maps_make(poses, blend.centers_mm, blend.handle_count, a.maps)) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t j = 0; j < blend.handle_count; j++) {
        change_map(&poses[j], blend.centers_mm + 3 * j, &changes[j], &a.maps[j]);
    }
    return apply_all(&a, task);
}

// ---------------------------------------------------------------------------------------------
// Backwards
// ---------------------------------------------------------------------------------------------

typedef struct pull {
    sf_blend blend;
    const double *gradient;
    double *sums; // 12 numbers for each stretch and handle: w g p^T row after row, then w g
} pull;

static void pull_stretch(void *context, size_t index)
{
    const pull *p = context;
    size_t count = p->blend.handle_count;
    double *sums = p->sums + 12 * count * index;
    memset(sums, 0, 12 * count * sizeof *sums);
    for (size_t i = index * STRETCH; i < stretch_end(index, p->blend.point_count); i++) {
        const double *g = p->gradient + 3 * i, *q = p->blend.rest_mm + 3 * i;
        const double *w = p->blend.weights + i * count;
        double outer[12];
        for (int n = 0; n < 9; n++) {
            outer[n] = g[n / 3] * q[n % 3];
        }
        memcpy(outer + 9, g, 3 * sizeof *g);
        for (size_t j = 0; j < count; j++) {
            for (size_t n = 0; n < 12; n++) {
                sums[12 * j + n] += w[j] * outer[n];
            }
        }
    }
}

// What the sums of a handle say about its pose.
static void change_pose(const sf_pose *pose, const double center[3], const double sums[12],
                        sf_pose_change *change)
{
    double scale = 0, moved[9];
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++) {
            moved[3 * r + c] = sums[3 * r + c] - sums[9 + r] * center[c];
            scale += moved[3 * r + c] * pose->turn[3 * r + c];
        }
        change->shift_mm[r] = sums[9 + r];
    }
    change->scale = scale;
    // Row r of s B R^T has s w g_r R (p - c); its axis is R (p - c) x g.
    for (int n = 0; n < 3; n++) {
        int a = (n + 1) % 3, b = (n + 2) % 3;
        double up = 0, down = 0;
        for (int c = 0; c < 3; c++) {
            up += moved[3 * b + c] * pose->turn[3 * a + c];
            down += moved[3 * a + c] * pose->turn[3 * b + c];
        }
        change->spin_rad[n] = pose->scale * (up - down);
    }
}

sf_status sf_blend_pull(sf_blend blend, const sf_pose *poses, const double *gradient,
                        const sf_allocator *allocator, sf_task *task, sf_pose_change *changes)
{
    sfi_map maps[SF_HANDLE_MAX];
    sf_allocator from = sfi_allocator_or_default(allocator);
    size_t pieces = stretches(blend.point_count), numbers = 0;
    if (!is_blend(&blend, poses) || changes == NULL ||
        (blend.point_count > 0 && gradient == NULL) ||
        !sfi_maps_make(poses, blend.centers_mm, blend.handle_count, maps)) {
        return SF_ERR_ARGUMENT;
    }
    if (sf_task_is_cancelled(task)) {
        return SF_ERR_CANCELLED;
    }
    if (!sfi_size_mul(pieces + 1, 12 * blend.handle_count, &numbers)) {
        return SF_ERR_OVERFLOW;
    }
    pull p = {blend, gradient, sfi_alloc_array(&from, numbers, sizeof(double))};
    if (p.sums == NULL) {
        return SF_ERR_MEMORY;
    }
    sfi_task_for(task, pieces, pull_stretch, &p);
    double *total = p.sums + 12 * blend.handle_count * pieces;
    memset(total, 0, 12 * blend.handle_count * sizeof *total);
    for (size_t i = 0; i < pieces; i++) {
        for (size_t n = 0; n < 12 * blend.handle_count; n++) {
            total[n] += p.sums[12 * blend.handle_count * i + n];
        }
    }
    for (size_t j = 0; j < blend.handle_count; j++) {
        change_pose(&poses[j], blend.centers_mm + 3 * j, total + 12 * j, &changes[j]);
    }
    sfi_free_array(&from, p.sums, numbers, sizeof *p.sums);
    return SF_OK;
}
