// SPDX-License-Identifier: MIT
// A part changed so that it prints, and looked at again.

#ifndef DEMO_SF_CHANGE_H
#define DEMO_SF_CHANGE_H

#include "masks.h"

// What became of a part.
typedef struct change {
    sf_operation operation;
    sf_grid *after;           // the part's grid, changed
    sf_grid *accepted;        // what hung before and may hang on, or NULL
    uint64_t accepted_voxels; // how much of that is left
    uint64_t hanging_voxels;  // what a trim would take of the result; 0 where it is support-free
    uint64_t kept_voxels;     // solid before and after
    uint64_t removed_voxels, added_voxels;
    uint64_t cost; // voxels changed, or what the operator says
    double before_mm3, after_mm3, removed_mm3, added_mm3;
    double seconds;
    int support_free; // under the whole rule, nothing accepted
    int holds;        // the same but for what was accepted
} change;

// Make one, leaving the part as it is. Where what must stay cannot, the status is EXIT_PROPERTY,
// and the job knows how much of it, and where.
exit_status change_make(cli_job *job, const part *p, const masks *m, sf_operation operation,
                        change *made);

// The same for whoever changes the part by other means. Begin: `after` is a copy of the part's
// grid, to be changed, and what nothing carries in the part is accepted, and exempt in the terms.
// End: it is looked at again, and `start`, in seconds of the job, is when that began.
exit_status change_begin(cli_job *job, const part *p, sf_terms *terms, change *made);
exit_status change_end(cli_job *job, const part *p, const sf_terms *terms, double start,
                       change *made);

// --min-feature, which was given, in voxels.
exit_status change_width(cli_job *job, const part *p, uint32_t *width);

// Whether it took away all there was.
int change_is_empty(const change *made);

// Fields of a change: an object of that name, or the verb's own fields where `key` is NULL.
void change_report(report *r, const char *key, const change *made);

// One sentence: what it did and what it costs.
void change_say(report *r, const change *made);

void change_release(change *made);

#endif
