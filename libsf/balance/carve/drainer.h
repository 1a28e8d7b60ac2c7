// SPDX-License-Identifier: MIT
// What draining a part works with.

#ifndef SF_BALANCE_DRAINER_H
#define SF_BALANCE_DRAINER_H

#include "balance/carve/outlet.h"

typedef struct sfi_drainer {
    const sf_drain_options *options;
    sf_grid *made, *trial, *hanging, *lost;
    sf_terms terms; // with what hung before as exempt, and the bed that it had
    int has_terms;
    sf_allocator allocator;
    sf_task *task;
    sfi_ground_plan plan;
    sfi_pieces pieces;
    uint8_t *is_open; // of each piece
    sfi_marks marks;  // what the holes of one void open
    double *levels;
    sfi_closed_void *voids;
    size_t void_count;
    double (*ups)[3];
    sfi_levers levers;
    sfi_outlets outlets;
    sf_slice slices[3];
    size_t slice_words;
    sf_drain *drains; // found
    size_t drain_capacity;
    sf_drain_report report;
} sfi_drainer;

// Find the voids, once there are pieces.
sf_status sfi_drainer_find(sfi_drainer *drainer);

// Drill, and fill what is not drained where that was asked for.
sf_status sfi_drainer_run(sfi_drainer *drainer);

#endif
