// SPDX-License-Identifier: MIT
// The middle of a solid behind a point, by rays that somebody else casts.
//
// A ray enters the solid where it first meets its surface from outside, and the stretch that is
// meant ends where it has left as often as it entered: shells that overlap count as one solid. If
// the first hit is a leaving one, the ray began inside, and so does the stretch.

#include <sf/handles.h>

#include "base/status.h"

#include <math.h>

enum { HITS_MAX = 100000 };

static int is_finite(const double v[3])
{
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

static sf_status no_stretch(sf_fault *fault)
{
    return sfi_fault_set(fault, SF_ERR_INFEASIBLE, 0, 0,
                         "the ray does not go through the surface, in and out again; point at the "
                         "solid");
}

// The stretch from `range[0]` to `range[1]`, in lengths of the direction.
static sf_status find_stretch(const sf_ray_caster *caster, const double from[3],
                              const double direction[3], double range[2], sf_fault *fault)
{
    double beyond = 0;
    int depth = 0, is_begun = 0;
    for (int i = 0; i < HITS_MAX; i++) {
        sf_ray_hit hit = {0, 0, 0};
        int found = 0;
        SF_TRY(caster->next(caster->user, from, direction, beyond, &hit, &found));
        if (!found) {
            return no_stretch(fault);
        }
        if (!(hit.along > beyond && isfinite(hit.along))) {
            return sfi_fault_set(fault, SF_ERR_INTERNAL, 0, 0, "the caster of rays goes backwards");
        }
        beyond = hit.along;
        if (!is_begun) {
            is_begun = 1;
            range[0] = hit.leaves ? 0 : hit.along;
            depth = hit.leaves ? 1 : 0;
        }
        depth += hit.leaves ? -1 : 1;
        if (depth <= 0) {
            range[1] = hit.along;
            return SF_OK;
        }
    }
    return no_stretch(fault);
}

sf_status sf_handle_center_by_rays(sf_ray_caster caster, const double from_mm[3],
                                   const double direction[3], double center_mm[3], sf_fault *fault)
{
    double range[2] = {0, 0};
    if (caster.next == NULL || from_mm == NULL || direction == NULL || center_mm == NULL ||
        !is_finite(from_mm) || !is_finite(direction) ||
        (direction[0] == 0 && direction[1] == 0 && direction[2] == 0)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "no caster, no place for the answer, or a ray that is not finite or "
                             "has no direction");
    }
    SF_TRY(find_stretch(&caster, from_mm, direction, range, fault));
    for (int i = 0; i < 3; i++) {
        center_mm[i] = from_mm[i] + (range[0] + range[1]) / 2 * direction[i];
    }
    return SF_OK;
}
