// SPDX-License-Identifier: MIT
// A 3MF file, whose parts may bring the slices that they will be printed from.

#ifndef DEMO_SF_SLICED_H
#define DEMO_SF_SLICED_H

#include "part.h"

#include <sf/threemf.h>

// Read a file whole.
exit_status sliced_open(cli_job *job, const char *path, sf_threemf **document);

// Draw the slices of all that is built into the part's grid: a layer for each of them, pixels as
// --pitch or --resolution say.
exit_status sliced_draw(cli_job *job, const sf_threemf *document, part *p);

#endif
