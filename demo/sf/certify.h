// SPDX-License-Identifier: MIT
// A certificate of what a verb made, where --certificate asks for one.

#ifndef DEMO_SF_CERTIFY_H
#define DEMO_SF_CERTIFY_H

#include "part.h"

// Certify the part's grid as what `operation` made of the grid that part_make_rule() saw, under the
// part's rule and but for the voxels of `exempt` (or NULL), and save that. Nothing is done where no
// certificate was asked for.
exit_status certify(cli_job *job, const part *p, sf_operation operation, const sf_grid *exempt);

#endif
