// SPDX-License-Identifier: MIT
// Tetrahedra and cages to files, by the names of these.

#ifndef DEMO_SF_TETS_WRITE_H
#define DEMO_SF_TETS_WRITE_H

#include "job.h"

// Refuse, before any work is done, a name that is neither .vtk nor, where tetrahedra are written,
// .h5.
exit_status tets_check_output(cli_job *job, int exchange_allowed);

// Write tetrahedra: an exchange file, with a .xdmf beside it for ParaView, or legacy VTK.
exit_status tets_write(cli_job *job, const sf_tets *tets, const char *path);

// Write a cage as legacy VTK.
exit_status tets_write_cage(cli_job *job, const sf_cage_view *view, const char *path);

#endif
