// SPDX-License-Identifier: MIT
// Hanging: which way a body turns on a string.
//
// A body that is free to turn about a point p has its least energy with the centre of mass c
// straight below p, and no other minimum. So it comes to rest turned by the angle between c - p and
// straight down, and within a tolerance t of the pose asked for if and only if c lies in the cone
// of half-angle t below p. A cone is round; sixteen planes bound a pyramid inside it, whose faces
// lie at tan(t) cos(pi / 16) of the depth. The cone's tip is the point itself, where the body
// hangs as it is left; how clear of it c must be is the lever.
//
// Source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand", 2013, section 3
// ("suspension mode"), where c is aimed at the line below p, and its depth is left to the user.

#include "balance/stance/stance.h"

#include "base/math.h"
#include "base/status.h"
#include "mesh/vector.h"

#include <math.h>
#include <string.h>

enum { SIDES = 16 };
#define COS_PI_16 0.98078528040323044913

sf_status sfi_hang_bound(sf_stance *s)
{
    const double *p = s->options.point_mm;
    double slope = sfi_tan(s->options.tolerance_rad) * COS_PI_16, normal[3];
    SF_TRY(sfi_stance_reserve(s, SIDES + 1));
    for (int i = 0; i < SIDES; i++) {
        for (int d = 0; d < 3; d++) {
            normal[d] = -sfi_cosine(2 * i) * s->east[d] - sfi_cosine(2 * i - 8) * s->north[d] -
                        slope * s->options.up[d];
        }
        sfi_stance_bound(s, normal, p, 0);
    }
    for (int d = 0; d < 3; d++) {
        normal[d] = -s->options.up[d];
    }
    sfi_stance_bound(s, normal, p, s->options.lever_mm);
    return SF_OK;
}

void sfi_hang_judge(const sf_stance *s, const double com[3], sf_stance_verdict *verdict)
{
    double arm[3], down[3];
    sfi_subtract(com, s->options.point_mm, arm);
    for (int d = 0; d < 3; d++) {
        down[d] = -s->options.up[d];
    }
    int is_free = sfi_length(arm) > 0;
    verdict->margin_rad = is_free ? -sfi_tilt(arm, down) : 0;
    verdict->stands = is_free && -verdict->margin_rad <= s->options.tolerance_rad;
    memcpy(verdict->edge_mm[0], s->options.point_mm, sizeof verdict->edge_mm[0]);
    memcpy(verdict->edge_mm[1], s->options.point_mm, sizeof verdict->edge_mm[1]);
}
