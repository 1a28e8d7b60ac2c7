// SPDX-License-Identifier: MIT
// From a solid to layers of materials.

#ifndef DEMO_SF_GRADED_H
#define DEMO_SF_GRADED_H

#include "materials.h"
#include "shells.h"
#include "solids.h"

// What became of it.
typedef struct graded {
    sf_lattice lattice;
    sf_sample_report voxels;
    double surface_error_mm;
    double asked[MATERIALS_MAX]; // sums of tones over solid voxels
    sf_material_use uses[MATERIALS_MAX];
    double worst_miss; // the farthest that a mixture is from what was wanted
    uint64_t missed;   // voxels whose mixture is farther off than rounding
    uint64_t shell;    // voxels near the surface, where a shell was asked for
} graded;

// Slice a solid, mix, halftone, and write a folder of layers. `channels` are the properties that
// the materials know, in their order.
exit_status graded_write(cli_job *job, const solid_input *in, const size_t *channels, materials *m,
                         const shells *shell, const char *path, graded *made);

#endif
