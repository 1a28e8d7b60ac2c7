// SPDX-License-Identifier: MIT
// What the layers of a graded solid go through, whatever is made of them.

#ifndef DEMO_SF_PRESS_H
#define DEMO_SF_PRESS_H

#include "grade_picture.h"
#include "graded.h"

// Everything that one layer after the other goes through.
typedef struct press {
    cli_job *job;
    materials *m;
    graded *made;
    sf_limit *limit;
    sf_sampler *sampler;
    shells keep;     // what is kept away from the surface
    sf_shell *shell; // where that is; NULL: nothing is
    sf_mask *mask;   // NULL: the built-in one
    sf_halftone *halftone;
    sf_diffuser *diffuser;
    sf_directory *directory;
    sf_layers *layers;
    sf_grid *grid; // of a layer: what is solid, and what is near the surface
    double *values[MATERIALS_PROPERTIES_MAX];
    double *tones[MATERIALS_MAX];
    uint8_t *ids;
    grade_picture picture; // of zeros where none is asked for
} press;

// Find the lattice and cut the surface.
exit_status press_shape(press *p, const solid_input *in, const size_t *channels);

// Memory for a layer; 0 where there is none.
int press_planes(press *p);

// From the values of a layer's solid voxels to their tones.
void press_mix(press *p, sf_slice solid);

// Refuse, when all layers were sampled, a solid that none of them met.
exit_status press_look_for_solid(press *p);

#endif
