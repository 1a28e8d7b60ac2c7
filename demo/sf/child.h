// SPDX-License-Identifier: MIT
// Work that is first tried by a child of this process, which may die of it.

#ifndef DEMO_SF_CHILD_H
#define DEMO_SF_CHILD_H

#include "job.h"

// Whether a child lives through the work, within a minute of its processor and 8 GiB, and finds it
// good: work() returns 0 then. Where there are no children, or none can be had, 1.
int child_survives(int (*work)(void *context), void *context);

// All bytes of the input file `path`, at most 2 GiB, for work that is done twice. Freed by the
// caller.
exit_status child_read_bytes(cli_job *job, const char *path, unsigned char **bytes, size_t *size);

#endif
