// SPDX-License-Identifier: MIT
// Where a body comes to rest: the hull of a mesh, rolled from one start after the other.

#include "balance/stance/roll.h"
#include "balance/stance/stance.h"
#include "base/memory.h"
#include "base/status.h"
#include "mesh/vector.h"

#include <math.h>
#include <string.h>

#define OUTSIDE_SHARE 1e-6

typedef struct releases { // of one body, from many starts
    const double *com, *ups;
    size_t count;
    double diagonal;
} releases;

static sf_status roll_all(const releases *all, const double *corners, size_t corner_count,
                          const sf_allocator *allocator, sf_rest *rests)
{
    sfi_roller roller;
    double edge[2][3], up[3];
    SF_TRY(sfi_roller_create(corners, corner_count, all->diagonal,
                             SFI_CONTACT_SHARE * all->diagonal, allocator, &roller));
    for (size_t i = 0; i < all->count; i++) {
        memcpy(up, all->ups + 3 * i, sizeof up);
        sfi_normalize(up);
        sfi_roll(&roller, all->com, up, &rests[i], edge);
    }
    sfi_roller_destroy(&roller, allocator);
    return SF_OK;
}

// The same from points that are gathered.
static sf_status make_hull_and_roll(const releases *all, const double *points, size_t point_count,
                                    const sf_allocator *allocator, sf_rest *rests, sf_fault *fault)
{
    sfi_hull hull;
    double *corners = NULL;
    SF_TRY(sfi_hull_create(points, point_count, allocator, &hull));
    sf_status status =
        sfi_hull_outside(&hull, points, all->com) > OUTSIDE_SHARE * all->diagonal
            ? sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                            "the centre of mass lies outside of the body's convex hull, where none "
                            "can be")
            : sfi_hull_corners(&hull, points, allocator, &corners);
    if (status == SF_OK) {
        status = roll_all(all, corners, hull.corner_count, allocator, rests);
        sfi_free_array(allocator, corners, hull.corner_count, 3 * sizeof *corners);
    }
    sfi_hull_destroy(&hull, allocator);
    return status;
}

static sf_status check(const double com[3], const double *ups, size_t count, sf_fault *fault)
{
    if (!sfi_is_place(com)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "the centre of mass is no place within 1e12 mm");
    }
    for (size_t i = 0; i < count; i++) {
        if (!sfi_is_direction(ups + 3 * i)) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "start %zu is no direction: it has no length, or one that is no "
                                 "number",
                                 i);
        }
    }
    return SF_OK;
}

sf_status sf_mesh_rest(sf_mesh_view mesh, const double com_mm[3], const double *ups, size_t count,
                       const sf_allocator *allocator, sf_rest *rests, sf_fault *fault)
{
    const double low[3] = {-INFINITY, -INFINITY, -INFINITY};
    const double high[3] = {INFINITY, INFINITY, INFINITY};
    releases all = {com_mm, ups, count, 0};
    double corner[3], extent[3], *points;
    size_t point_count;
    if (com_mm == NULL || ((ups == NULL || rests == NULL) && count > 0)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "a pointer is missing");
    }
    SF_TRY(check(com_mm, ups, count, fault));
    SF_TRY(sfi_mesh_box(mesh, corner, extent, fault));
    all.diagonal = sfi_length(extent);
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_status status = sfi_gather(mesh, low, high, &from, &points, &point_count);
    if (status == SF_OK) {
        status = make_hull_and_roll(&all, points, point_count, &from, rests, fault);
        sfi_free_array(&from, points, point_count, 3 * sizeof *points);
    }
    if (status == SF_ERR_MEMORY || status == SF_ERR_OVERFLOW) {
        return sfi_fault_set(fault, status, 0, 0, "%s",
                             status == SF_ERR_MEMORY ? "there is not enough memory to roll the body"
                                                     : "the mesh has more than 2^30 vertices");
    }
    return status;
}
