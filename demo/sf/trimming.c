// SPDX-License-Identifier: MIT
// Trimming the part, and looking again.
//
// What is reported as support-free is what a check of the result found, not what the trim promised.

#include "trimming.h"

#include "describe.h"
#include "judgement.h"
#include "progress.h"

exit_status trim_part(cli_job *job, part *p, sf_check_report *after)
{
    report *r = job->report;
    sf_trim_report done;
    double before_mm3 = describe_volume(p->grid);
    progress_phase("trimming");
    sf_status status = sf_grid_trim(p->grid, &p->rule, p->bed_layer, &job->task, &done);
    if (status == SF_OK) {
        progress_phase("checking");
        status = count_unsupported(job, p, p->grid, after);
    }
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "the trim", EXIT_INPUT);
    }
    double after_mm3 = describe_volume(p->grid);
    report_begin(r, "trim");
    report_count(r, "kept_voxels", done.kept_voxels);
    report_count(r, "removed_voxels", done.removed_voxels);
    report_count(r, "added_voxels", 0);
    report_number(r, "volume_mm3", after_mm3);
    report_flag(r, "support_free", after->support_free);
    report_end(r);
    if (done.removed_voxels == 0) {
        report_say(r, "It prints without supports as it is; nothing was taken away.");
    } else {
        char taken[DESCRIBE_MM3_SIZE], left[DESCRIBE_MM3_SIZE];
        report_say(r,
                   "Trimming took %s away (%.3g %%) and left %s, which print without "
                   "supports.",
                   describe_mm3(before_mm3 - after_mm3, taken),
                   100 * (before_mm3 - after_mm3) / before_mm3, describe_mm3(after_mm3, left));
    }
    return EXIT_GOOD;
}
