// SPDX-License-Identifier: MIT
// What bends a model: handles of a file, or places found by themselves.

#ifndef DEMO_SF_HANDLES_READ_H
#define DEMO_SF_HANDLES_READ_H

#include "stances_read.h"

typedef struct handles {
    sf_handle each[SF_HANDLE_MAX]; // in build axes and mm
    sf_pose poses[SF_HANDLE_MAX];
    int posed[SF_HANDLE_MAX]; // whether the file poses it
    size_t count;
    int are_placed; // whether they were found and not asked for
} handles;

// Read the file of --handles (docs/handles.schema.json), or find auto:N places away from what the
// stances touch. The part has its voxels.
exit_status handles_read(cli_job *job, const part *p, const stances *s, handles *h);

#endif
