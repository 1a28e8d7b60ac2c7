// SPDX-License-Identifier: MIT
// A model that is made to stand: what it is to rest on, what bends it, and how far it came.

#ifndef DEMO_SF_STAND_MODEL_H
#define DEMO_SF_STAND_MODEL_H

#include "densities.h"
#include "handles_read.h"

#include <sf/stand.h>

enum { DRAINS_MAX = 256 };

// Holes, so that what is in the cavity can leave.
typedef struct drilled {
    sf_drain_report report;
    sf_drain drains[DRAINS_MAX];
    sf_grid *after;    // the carved shape with its holes
    double com_mm[3];  // with them
    double margin_rad; // the least over all stances
    int safe;          // in every stance
} drilled;

typedef struct model {
    part part; // in build axes, closed and turned outwards, with voxels
    axis up;   // of the input, against gravity
    stances stances;
    handles handles;
    densities densities;
    sf_lattice lattice; // of the part's voxels
    sf_stand_options options;
    sf_stand *stand;
    sf_stand_report report;
    sf_grid *solid, *cavity; // voxels of the shape as it came out; NULL where nothing is carved
    double size_mm;          // longest side
    double wall_min_mm;      // measured; infinite where nothing is carved
    double modelled_rad;     // margin on the corners that touch the ground as they were modelled
    double flattened_mm;     // the furthest that a vertex went to put feet flat
    double moved_mm;         // the furthest that a vertex went, feet put flat included
    drilled drilled;         // all zero without --drain
} model;

// Read the mesh, and refuse one that is open; one that is inside out is turned. With voxels, and
// what they weigh.
exit_status model_read(cli_job *job, model *m);

// Prepare it, and go rounds until it stands or nothing improves.
exit_status model_run(cli_job *job, model *m);

// Whether all that was asked for was reached.
int model_holds(const model *m);

void model_release(model *m);

#endif
