// SPDX-License-Identifier: MIT
// Struts of a least width.

#ifndef SF_SUPPORT_STRUT_H
#define SF_SUPPORT_STRUT_H

#include "support/repair/repair.h"

// Of a result, keep what it keeps of V but carry it on squares of `width` voxels, where there is
// room for them. `full` are the terms of the whole rule; the costs of the job are those of single
// voxels.
sf_status sfi_strut_widen(const sfi_job *job, const sf_terms *full, uint32_t width, sf_grid *result,
                          sf_repair_report *report);

#endif
