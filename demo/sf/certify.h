// SPDX-License-Identifier: MIT
// A certificate of what a verb made, where --certificate asks for one.

#ifndef DEMO_SF_CERTIFY_H
#define DEMO_SF_CERTIFY_H

#include "change.h"

// Certify what a change made of the part's grid, under the part's rule and but for the matter that
// was accepted, and save that. Nothing is done where no certificate was asked for.
exit_status certify(cli_job *job, const part *p, const change *done);

#endif
