// SPDX-License-Identifier: MIT
// A brush that takes matter away, and the ways to do it.

#ifndef SF_SUPPORT_REMOVAL_H
#define SF_SUPPORT_REMOVAL_H

#include <sf/preserve.h>

// A removal that has been checked. What counts as the brush is in the brush, in the box, where the
// terms let one act, and not to be kept.
typedef struct sfi_removal {
    sf_grid *grid;        // V, as it is before the edit
    const sf_grid *shape; // V, or the part of it without what must go
    const sf_grid *brush;
    const sf_terms *terms;
    sf_box box; // around the brush; empty: no brush
    uint32_t bed;
    const sf_preserve_options *options;
    const sf_allocator *allocator;
    sf_task *task;
} sfi_removal;

// What of layer k of `from`, in a rectangle that begins with a word, is in the brush, and what is
// not. Either may be SFI_NO_SLICE; both have the rectangle's size.
void sfi_removal_split(const sfi_removal *removal, const sf_grid *from, uint32_t k, sf_rect part,
                       sf_slice taken, sf_slice rest);

// Modes with a file of their own: each does the edit, or fails and leaves the grid as it was.
sf_status sfi_preserve_fast(const sfi_removal *removal, sf_preserve_report *report);
sf_status sfi_preserve_paper(const sfi_removal *removal, sf_preserve_report *report);

// A task for a part of the work, which heeds the host's cancel and reports nothing, so that
// progress runs once from 0 to 1. The result lives in `quiet`; NULL for NULL.
typedef struct sfi_quiet {
    sf_task task;
    const sf_task *host;
} sfi_quiet;
sf_task *sfi_quiet_begin(sfi_quiet *quiet, const sf_task *host);

// removal->grid = `after`, with the counts of what that changes.
void sfi_removal_commit(const sfi_removal *removal, const sf_grid *after,
                        sf_preserve_report *report);

#endif
