// SPDX-License-Identifier: MIT
// Trimming the part, and looking again.

#ifndef DEMO_SF_TRIMMING_H
#define DEMO_SF_TRIMMING_H

#include "part.h"

// Trim the part's grid in place, check what is left, and report both: as an object of that name, or
// as the verb's own fields where `key` is NULL. `after` gets the check, `before` the grid as it
// was, the caller's to destroy whatever is returned.
exit_status trim_part(cli_job *job, part *p, const char *key, sf_check_report *after,
                      sf_grid **before);

#endif
