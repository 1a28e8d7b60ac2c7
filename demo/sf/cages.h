// SPDX-License-Identifier: MIT
// The cage that a verb works on.

#ifndef DEMO_SF_CAGES_H
#define DEMO_SF_CAGES_H

#include "job.h"

// Read the input as a cage, in the units and size that the options say, and refuse it where a cell
// is inverted. The caller frees it, whatever is returned.
exit_status cages_read(cli_job *job, sf_cage **cage);

// Whether a file begins as cages and exchange files do, whatever its name is.
int cages_look_like(const char *path);

// Fields of a cage: an object "cage".
void cages_report(cli_job *job, const sf_cage *cage);

#endif
