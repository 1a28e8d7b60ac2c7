// SPDX-License-Identifier: MIT
// sf trim: take away what cannot print without supports, and as little as that.

#include "certify.h"
#include "describe.h"
#include "output.h"
#include "progress.h"
#include "trimming.h"
#include "verbs.h"

static exit_status trim(cli_job *job, part *p)
{
    sf_check_report after;
    sf_grid *before;
    exit_status status = part_voxelize(job, p);
    if (status == EXIT_GOOD) {
        status = part_make_rule(job, p);
    }
    if (status != EXIT_GOOD) {
        return status;
    }
    describe_part(job, p, "trim");
    status = trim_part(job, p, NULL, &after, &before);
    sf_grid_destroy(before);
    if (status == EXIT_GOOD && job->options.output != NULL) {
        status = output_save(job, p, job->options.output);
    }
    if (status == EXIT_GOOD) {
        status = certify(job, p, SF_OPERATION_TRIM, NULL);
    }
    if (status != EXIT_GOOD) {
        return status;
    }
    report_number(job->report, "seconds", job_seconds(job));
    if (job->options.output != NULL) {
        report_text(job->report, "output", job->options.output);
        report_say(job->report, "Written to %s.", job->options.output);
    } else {
        report_say(job->report, "Nothing was written; -o OUT says where to.");
    }
    return after.support_free ? EXIT_GOOD : EXIT_PROPERTY;
}

exit_status verb_trim(cli_job *job)
{
    part p;
    exit_status status = output_check(job, 1);
    if (status != EXIT_GOOD) {
        return status;
    }
    status = part_read(job, &p);
    if (status == EXIT_GOOD) {
        status = trim(job, &p);
    }
    part_release(&p);
    return status;
}
