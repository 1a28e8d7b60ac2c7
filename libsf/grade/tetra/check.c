// SPDX-License-Identifier: MIT
// What tetrahedra are like: volumes, and faces that two share.

#include "grade/tetra/faces.h"
#include "grade/tetra/tets.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

static double volume(const sf_tets *tets, size_t tet)
{
    const uint32_t *c = tets->corners + 4 * tet;
    const double *a = tets->seen + 3 * (size_t)c[0];
    double e[3][3];
    for (size_t i = 0; i < 3; i++) {
        const double *p = tets->seen + 3 * (size_t)c[i + 1];
        for (size_t axis = 0; axis < 3; axis++) {
            e[i][axis] = p[axis] - a[axis];
        }
    }
    return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
            e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
            e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
           6;
}

sf_status sf_tets_check(const sf_tets *tets, const sf_allocator *allocator, sf_tets_report *report)
{
    if (tets == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_tets_report r = {0, 0, tets->tets, 0, 0};
    sfi_faces faces;
    SF_TRY(sfi_faces_make(tets->corners, tets->tets, tets->points, &kept, &faces));
    r.boundary_faces = faces.count;
    r.crowded_faces = faces.crowded;
    sfi_faces_free(&faces);
    for (size_t i = 0; i < tets->tets; i++) {
        double v = volume(tets, i);
        r.volume_mm3 += v;
        if (!(v > 0)) {
            r.first_inverted = r.inverted == 0 ? i : r.first_inverted;
            r.inverted++;
        }
    }
    *report = r;
    return SF_OK;
}
