// SPDX-License-Identifier: MIT
// Trimming the part, and looking again.

#ifndef DEMO_SF_TRIMMING_H
#define DEMO_SF_TRIMMING_H

#include "part.h"

// Trim the part's grid in place, check what is left, and report both. `after` gets the check.
exit_status trim_part(cli_job *job, part *p, sf_check_report *after);

#endif
