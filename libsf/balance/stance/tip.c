// SPDX-License-Identifier: MIT
// Standing: when a body tips over.
//
// Tilt the ground by an angle around a horizontal axis. The body stays as long as the vertical
// through its centre of mass c meets the support polygon. The direction that is worst for an edge
// is the one straight across it; there, with c at distance d inside of the edge's line and at
// height h above the ground, the vertical passes over the edge at the angle t with tan t = d / h.
// So a tilt of gamma in every direction is survived if and only if, for every edge with inward
// normal n through p,
//
//     n . (c - p) - h tan(gamma) >= 0,      h = up . c - ground,
//
// a half-space, linear in c, with the height of c as it is (the paper freezes it). All of them
// together are a hip roof over the polygon, whose faces rise by 90 degrees less gamma.
//
// A segment is the limit of thin rectangles, a point that of small squares: half-spaces that
// contradict each other for every h > 0 as soon as gamma is more than 0. The margin over a point is
// the same in every direction, so it is measured to the point itself.
//
// Where the body reaches below the ground, off the table's edge, c may do so too, and h is
// negative: then it must also lie above the ground, which is a half-space of its own. (Elsewhere no
// centre of mass can be there; one that is asked about is not safe.) A toy that balances on a point
// with c below it is one that hangs.
//
// Source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand", 2013, section
// 3; the height included.

#include "balance/stance/stance.h"

#include "base/math.h"
#include "base/status.h"
#include "mesh/vector.h"

#include <math.h>
#include <string.h>

sf_status sfi_stand_bound(sf_stance *s)
{
    size_t count = sfi_edge_count(s);
    double slope = sfi_tan(s->options.gamma_rad);
    SF_TRY(sfi_stance_reserve(s, count + (size_t)s->is_over_edge));
    for (size_t i = 0; i < count; i++) {
        sfi_edge edge = sfi_edge_get(s, i);
        double normal[3];
        for (int d = 0; d < 3; d++) {
            normal[d] = edge.inward[d] - slope * s->options.up[d];
        }
        sfi_stance_bound(s, normal, edge.from, 0);
    }
    if (s->is_over_edge) {
        sfi_stance_bound(s, s->options.up, s->polygon, 0);
    }
    return SF_OK;
}

double sfi_tipping(double inside, double height)
{
    if (height > 0) {
        return sfi_atan(inside / height);
    }
    return inside >= 0 ? SFI_HALF_PI : -SFI_HALF_PI;
}

void sfi_stand_judge(const sf_stance *s, const double com[3], sf_stance_verdict *verdict)
{
    double height = sfi_dot(s->options.up, com) - s->ground_mm;
    verdict->margin_rad = INFINITY;
    for (size_t i = 0; i < sfi_edge_count(s); i++) {
        sfi_edge edge = sfi_edge_get(s, i);
        double from[3];
        sfi_subtract(com, edge.from, from);
        double inside = sfi_dot(edge.inward, from);
        if (s->polygon_count == 1) {
            double east = sfi_dot(s->east, from), north = sfi_dot(s->north, from);
            inside = -sqrt(east * east + north * north);
        }
        double margin = sfi_tipping(inside, height);
        if (margin < verdict->margin_rad) {
            verdict->margin_rad = margin;
            memcpy(verdict->edge_mm[0], edge.from, sizeof edge.from);
            memcpy(verdict->edge_mm[1], edge.to, sizeof edge.to);
        }
    }
    verdict->stands = verdict->margin_rad >= 0;
    verdict->safe = verdict->safe && height >= 0;
}
