// SPDX-License-Identifier: MIT
// What 1 mm3 of the part weighs: one number, or a file that says more.

#ifndef DEMO_SF_DENSITIES_H
#define DEMO_SF_DENSITIES_H

#include "part.h"

typedef struct densities {
    double all;         // of everything, where `each` is NULL
    float *each;        // of each voxel, or NULL
    float *kept;        // 2 for a voxel that must not be carved away, else 1; or NULL: none must
    sf_ballast *masses; // in points, in build axes
    size_t mass_count;
} densities;

// Read what --density names; 1 where it was not given. The format is docs/density.schema.json.
exit_status densities_read(cli_job *job, const part *p, densities *d);

// What a grid of the part's lattice weighs, with the masses in points.
exit_status densities_weigh(cli_job *job, const densities *d, const sf_grid *grid, sf_body *body);

// Add to a grid of the part's lattice the voxels that must not be carved away.
sf_status densities_keep(const densities *d, sf_grid *wall);

void densities_release(densities *d);

#endif
