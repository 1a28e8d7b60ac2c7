// SPDX-License-Identifier: MIT
// The cheap score: how much of a surface hangs over.
//
// A face with outward unit normal n, area a, under a direction u that points up: where n . u < 0 it
// looks down, and its overhang from the vertical is the angle whose sine is -n . u. It needs
// support where that is more than the sine of the allowed angle, and then over the area that it
// casts straight down, a (-n . u). Faces on the bed need none: those whose corners all lie within
// half a coarse voxel of the lowest vertex, which is what the first layer makes of them.
//
// It knows nothing of what stands in the way below a face, nor of how far the overhang reaches; so
// it only chooses whom to look at more closely. Height is added with the weight that it has in the
// score, for without it all directions of a shape that hangs over nowhere would be equal.
//
// Each direction is a sum of its own in the order of the triangles: the same bytes on any threads.

#include "orient/score.h"

#include "base/task.h"

#include <math.h>

enum { DIRECTIONS_A_PIECE = 16 };

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void find_span(sf_mesh_view mesh, const double up[3], double *low, double *high)
{
    *low = INFINITY;
    *high = -INFINITY;
    for (size_t i = 0; i < 3 * mesh.triangle_count; i++) {
        double z = dot(mesh.vertices + 3 * (size_t)mesh.triangles[i], up);
        *low = z < *low ? z : *low;
        *high = z > *high ? z : *high;
    }
}

static int lies_below(sf_mesh_view mesh, const uint32_t *triangle, const double up[3], double top)
{
    for (int i = 0; i < 3; i++) {
        if (dot(mesh.vertices + 3 * (size_t)triangle[i], up) > top) {
            return 0;
        }
    }
    return 1;
}

static sfi_cheap score(const sfi_facing *facing, const double up[3])
{
    sf_mesh_view mesh = facing->mesh;
    double low, high, sum = 0;
    find_span(mesh, up, &low, &high);
    for (size_t i = 0; i < mesh.triangle_count; i++) {
        const double *n = facing->facets[i].normal;
        double down = -dot(n, up);
        if (down > 0 && down * down > facing->steepest_sin * facing->steepest_sin * dot(n, n) &&
            !lies_below(mesh, mesh.triangles + 3 * i, up, low + facing->bed_mm)) {
            sum += down;
        }
    }
    double share = facing->area_mm2 > 0 ? sum / facing->area_mm2 : 0;
    sfi_cheap made = {sum, high - low, 0};
    made.score = share + facing->weight_height * made.height_mm / facing->diagonal_mm;
    return made;
}

typedef struct piece {
    const sfi_facing *facing;
    const double (*up)[3];
    size_t count;
    sfi_cheap *scores;
} piece;

static void score_piece(void *context, size_t index)
{
    const piece *p = context;
    size_t end = (index + 1) * DIRECTIONS_A_PIECE;
    for (size_t i = index * DIRECTIONS_A_PIECE; i < end && i < p->count; i++) {
        p->scores[i] = score(p->facing, p->up[i]);
    }
}

void sfi_score_all(const sfi_facing *facing, const double (*up)[3], size_t count, sf_task *task,
                   sfi_cheap *scores)
{
    piece all = {facing, up, count, scores};
    sfi_task_for(task, (count + DIRECTIONS_A_PIECE - 1) / DIRECTIONS_A_PIECE, score_piece, &all);
}
