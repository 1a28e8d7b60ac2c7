// SPDX-License-Identifier: MIT
// Whether a model that was made to stand prints without supports.
//
// Carving leaves nothing hanging inside, but it does not mend the outside, and bending may make
// that worse. So the carved voxels, holes and all, are looked at as `sf check` looks at any part.

#include "stand_prints.h"

#include "advice.h"
#include "describe.h"
#include "judgement.h"
#include "place.h"
#include "progress.h"

#include <stdlib.h>
#include <string.h>

// The voxels that are printed, as a part; they are the model's.
static exit_status make_part(cli_job *job, const model *m, sf_grid **copy, part *p)
{
    const sf_grid *grid = m->drilled.after != NULL ? m->drilled.after : sf_stand_grid(m->stand);
    memset(p, 0, sizeof *p);
    p->bed_layer = SF_BED_AUTO;
    sf_status status = sf_grid_clone(grid, NULL, copy);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "the voxels", EXIT_RESOURCE);
    }
    p->grid = *copy;
    return part_make_rule(job, p);
}

static void say(cli_job *job, const model *m, const part *p, const sf_check_report *counts)
{
    report *r = job->report;
    double voxel_mm3 = place_voxel_mm3(p->grid);
    char hangs[DESCRIBE_MM3_SIZE], inside[DESCRIBE_MM3_SIZE];
    report_count(r, "unsupported_voxels", counts->unsupported_voxels);
    report_count(r, "trimmed_voxels", counts->trimmed_voxels);
    report_flag(r, "support_free", counts->support_free);
    if (counts->support_free) {
        report_say(r, "It prints without supports.");
        return;
    }
    describe_mm3((double)counts->unsupported_voxels * voxel_mm3, hangs);
    describe_mm3((double)m->report.hanging_voxels * voxel_mm3, inside);
    if (m->report.hanging_voxels > 0) {
        report_say(r, "%s hang in the air and need supports, %s of that because of the carving.",
                   hangs, inside);
    } else {
        report_say(r, "%s hang in the air and need supports; carving adds nothing that does.",
                   hangs);
    }
}

exit_status stand_prints(cli_job *job, const model *m)
{
    sf_grid *copy = NULL;
    sf_check_report counts;
    part p;
    progress_phase("checking");
    exit_status status = make_part(job, m, &copy, &p);
    if (status == EXIT_GOOD) {
        sf_status counted = count_unsupported(job, &p, p.grid, &counts);
        status = counted == SF_OK ? EXIT_GOOD
                                  : job_fail_call(job, counted, NULL, "the check", EXIT_RESOURCE);
    }
    if (status == EXIT_GOOD) {
        say(job, m, &p, &counts);
    }
    part_release(&p);
    return status;
}

exit_status stand_prints_advise(cli_job *job, const model *m, const char *outer, const char *inner,
                                const char *layers)
{
    sf_grid *copy = NULL;
    part p;
    exit_status status = make_part(job, m, &copy, &p);
    if (status == EXIT_GOOD) {
        advice_check(job, &p, layers != NULL ? layers : outer, inner);
    }
    part_release(&p);
    return status;
}
