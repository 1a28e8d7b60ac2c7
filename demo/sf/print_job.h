// SPDX-License-Identifier: MIT
// Jobs of printers and files of contours: layers that a slicer made, read as parts.

#ifndef DEMO_SF_PRINT_JOB_H
#define DEMO_SF_PRINT_JOB_H

#include "judgement.h"

// Whether a name is that of a job (.sl1, .sl1s, .photon), or of a file of contours (.cli).
int print_job_is_named(const char *path);
int print_job_is_contours(const char *path);

// Open the input, a job: its lattice is known afterwards, its layers are not read.
exit_status print_job_open(cli_job *job, part *p);

// Read all layers of an open job into a grid.
exit_status print_job_load(cli_job *job, part *p);

// Read the input, a file of contours, into a grid.
exit_status print_job_read_contours(cli_job *job, part *p);

// Judge an open job without ever holding more than a few of its layers.
exit_status print_job_judge(cli_job *job, part *p, judgement *j);

// Write a grid to a job: the one that was read with other layers, or a new one.
exit_status print_job_save(cli_job *job, const part *p, const sf_grid *grid, const char *path);

void print_job_close(part *p);

#endif
