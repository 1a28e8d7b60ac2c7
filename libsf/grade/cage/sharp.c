// SPDX-License-Identifier: MIT
// Creases and sharp points, put where they belong.
//
// Inside of a solid nothing is sharp: there are rules for an edge of a surface that stays sharp,
// and none for one that cells go around.

#include "grade/cage/sharp.h"

#include "base/memory.h"
#include "base/status.h"

#include <math.h>
#include <string.h>

static uint32_t edges_at(const sfi_lists *around, uint32_t point)
{
    return around->starts[point + 1] - around->starts[point];
}

// The edge of two points, found by the edges of that one which has fewer, for where thousands meet
// in a point each of them may be a crease; SFI_NONE if they have none.
static uint32_t edge_of(const sfi_complex *c, const sfi_lists *around, const uint32_t points[2])
{
    uint32_t a = points[0], b = points[1];
    if (a >= c->points || b >= c->points || a == b) {
        return SFI_NONE;
    }
    if (edges_at(around, a) > edges_at(around, b)) {
        a = points[1];
        b = points[0];
    }
    for (uint32_t i = around->starts[a]; i < around->starts[a + 1]; i++) {
        const uint32_t *ends = c->edge_points + 2 * (size_t)around->items[i];
        if (ends[0] == b || ends[1] == b) {
            return around->items[i];
        }
    }
    return SFI_NONE;
}

static int is_sharpness(double sharpness)
{
    return sharpness >= 0 && !isnan(sharpness);
}

static sf_status set_creases(const sf_cage_view *v, const sfi_lists *around, uint8_t *seen,
                             sfi_complex *c, sf_fault *fault)
{
    memset(seen, 0, c->edges);
    for (size_t i = 0; i < v->crease_count; i++) {
        uint32_t edge = edge_of(c, around, v->creases[i].points);
        const char *what = edge == SFI_NONE ? "is no edge of a cell"
                           : seen[edge]     ? "is there twice"
                           : !is_sharpness(v->creases[i].sharpness)
                               ? "has a sharpness that is no number of 0 or more"
                               : NULL;
        if (what != NULL) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "crease %zu, of points %lu and %lu, %s", i,
                                 (unsigned long)v->creases[i].points[0],
                                 (unsigned long)v->creases[i].points[1], what);
        }
        if (c->dimension == 3 && !c->edge_outside[edge] && v->creases[i].sharpness > 0) {
            return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                                 "crease %zu, of points %lu and %lu, lies inside; edges of the "
                                 "boundary can be sharp",
                                 i, (unsigned long)v->creases[i].points[0],
                                 (unsigned long)v->creases[i].points[1]);
        }
        seen[edge] = 1;
        c->edge_sharpness[edge] = v->creases[i].sharpness;
    }
    return SF_OK;
}

static sf_status set_points(const sf_cage_view *v, uint8_t *seen, sfi_complex *c, sf_fault *fault)
{
    memset(seen, 0, c->points);
    for (size_t i = 0; i < v->sharp_count; i++) {
        uint32_t point = v->sharps[i].point;
        const char *what = point >= c->points ? "is none of the cage's"
                           : seen[point]      ? "is there twice"
                           : !is_sharpness(v->sharps[i].sharpness)
                               ? "has a sharpness that is no number of 0 or more"
                               : NULL;
        if (what != NULL) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "sharp point %zu, point %lu, %s", i,
                                 (unsigned long)point, what);
        }
        if (c->dimension == 3 && !c->point_outside[point] && v->sharps[i].sharpness > 0) {
            return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                                 "sharp point %zu, point %lu, lies inside; points of the boundary "
                                 "can be sharp",
                                 i, (unsigned long)point);
        }
        seen[point] = 1;
        c->point_sharpness[point] = v->sharps[i].sharpness;
    }
    return SF_OK;
}

sf_status sfi_sharp_set(const sf_cage_view *view, sfi_complex *complex, sf_fault *fault)
{
    const sf_allocator *allocator = &complex->allocator;
    size_t places = complex->edges > complex->points ? complex->edges : complex->points;
    sfi_lists around = {NULL, NULL};
    uint8_t *seen = sfi_alloc_array(allocator, places, 1);
    sf_status status = seen == NULL
                           ? SF_ERR_MEMORY
                           : sfi_pairs_turn(allocator, complex->edges, complex->edge_points,
                                            complex->points, &around);
    if (status == SF_OK) {
        status = set_creases(view, &around, seen, complex, fault);
    }
    if (status == SF_OK) {
        status = set_points(view, seen, complex, fault);
    }
    sfi_lists_free(allocator, complex->points, &around);
    sfi_free_array(allocator, seen, places, 1);
    return status;
}
