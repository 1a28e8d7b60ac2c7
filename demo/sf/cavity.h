// SPDX-License-Identifier: MIT
// A part made hollow, its voids drained, and looked at again.

#ifndef DEMO_SF_CAVITY_H
#define DEMO_SF_CAVITY_H

#include "change.h"
#include "densities.h"

enum { CAVITY_DRAINS_MAX = 4096 };

typedef struct cavity {
    change done;
    sf_grid *wall;   // what had to stay around the inside
    sf_grid *carved; // what is empty now inside the wall; holes are no part of it
    int is_closed;   // whether the part is a mesh that is closed and looks outwards
    uint64_t wall_voxels, carved_voxels;
    double carved_mm3, kept_mm3;      // of what is not wall
    double wall_min_mm;               // measured; infinite where nothing is carved
    uint64_t void_count, void_voxels; // that are closed, or were before they were drained
    sf_drain_report drained;          // all zero without --drain
    sf_drain *drains;
    size_t drain_count;
    sf_body before, after;
} cavity;

// Make it, leaving the part as it is. Where nothing can be carved the status is EXIT_PROPERTY.
exit_status cavity_make(cli_job *job, const part *p, const masks *m, const densities *d, cavity *c);

// Fields and sentences.
void cavity_report(cli_job *job, const part *p, const cavity *c);

// Whether all that was asked for was reached.
int cavity_holds(const cli_job *job, const cavity *c);

void cavity_release(cavity *c);

#endif
