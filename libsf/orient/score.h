// SPDX-License-Identifier: MIT
// What a direction looks like from the triangles alone.

#ifndef SF_ORIENT_SCORE_H
#define SF_ORIENT_SCORE_H

#include "orient/direction.h"

// A mesh, its facets, and what faces may do.
typedef struct sfi_facing {
    sf_mesh_view mesh;
    const sfi_facet *facets;
    double area_mm2;     // of all facets
    double diagonal_mm;  // of the box around the mesh
    double steepest_sin; // sine of the overhang that still prints
    double bed_mm;       // faces that lie so close to the lowest vertex lie on the bed
    double weight_height;
} sfi_facing;

typedef struct sfi_cheap {
    double unsupported_mm2, height_mm, score;
} sfi_cheap;

// For all directions, on the task's threads; O(vertices + triangles) for each.
void sfi_score_all(const sfi_facing *facing, const double (*up)[3], size_t count, sf_task *task,
                   sfi_cheap *scores);

#endif
