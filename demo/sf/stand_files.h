// SPDX-License-Identifier: MIT
// The files that `sf stand` writes, all under one prefix.

#ifndef DEMO_SF_STAND_FILES_H
#define DEMO_SF_STAND_FILES_H

#include "stand_model.h"

// Refuse, before any work is done, a prefix under which nothing can be written.
exit_status stand_files_check(cli_job *job);

// Write PREFIX_outer.stl, PREFIX_inner.stl, with holes PREFIX_cut.stl, with --cut PREFIX_low.stl
// and PREFIX_high.stl, PREFIX.png and PREFIX.json, whose report is then complete. EXIT_PROPERTY
// where all was written, but the plane of --cut missed the model. None of them changes before all
// are written aside.
exit_status stand_files_save(cli_job *job, const model *m);

#endif
