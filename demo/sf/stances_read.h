// SPDX-License-Identifier: MIT
// What a model is to rest on: by options, or a file with several stances.

#ifndef DEMO_SF_STANCES_READ_H
#define DEMO_SF_STANCES_READ_H

#include "part.h"

enum { STANCES_MAX = 32 };

typedef struct stances {
    sf_stance_options each[STANCES_MAX]; // in build axes and mm
    size_t count;
} stances;

// Read what --stance names (docs/stance.schema.json), or else make one stance of --up, --gamma,
// --contacts and --suspend. `up` is the axis of the input that points up.
exit_status stances_read(cli_job *job, const part *p, axis up, stances *s);

#endif
