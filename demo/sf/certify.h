// SPDX-License-Identifier: MIT
// A certificate of what a verb made, where --certificate asks for one.

#ifndef DEMO_SF_CERTIFY_H
#define DEMO_SF_CERTIFY_H

#include "change.h"

// Certify what a change made of the part's grid, under the part's rule and but for the matter that
// was accepted, into a file that has no name yet. It is NULL where no certificate was asked for.
exit_status certify_begin(cli_job *job, const part *p, const change *done, sf_save **file);

// Give it its name; sf_save_abort() forgets it.
exit_status certify_commit(cli_job *job, sf_save *file);

#endif
