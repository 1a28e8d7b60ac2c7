// SPDX-License-Identifier: MIT
// What may not come near the surface of a graded solid: --shell and --keep-out.

#ifndef DEMO_SF_SHELLS_H
#define DEMO_SF_SHELLS_H

#include "materials.h"

typedef struct shells {
    double distance_mm;              // from the surface; of no use where there are no keep-outs
    size_t count;                    // keep-outs; 0: none was asked for
    sf_keep_out outs[MATERIALS_MAX]; // without places so far
} shells;

// Which materials are meant by the names on the command line.
exit_status shells_choose(cli_job *job, const materials *m, shells *made);

#endif
