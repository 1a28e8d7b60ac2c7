// SPDX-License-Identifier: MIT
// sf check: does it print without supports, and where not?

#include "describe.h"
#include "judgement.h"
#include "verbs.h"

static exit_status check(cli_job *job, part *p)
{
    judgement j;
    exit_status status = part_voxelize(job, p);
    if (status == EXIT_GOOD) {
        status = part_make_rule(job, p);
    }
    if (status != EXIT_GOOD) {
        return status;
    }
    describe_part(job, p, "check");
    status = judge(job, p, &j);
    if (status == EXIT_GOOD) {
        judgement_report(job, p, &j);
        report_number(job->report, "seconds", job_seconds(job));
        status = j.counts.support_free ? EXIT_GOOD : EXIT_PROPERTY;
    }
    judgement_release(&j);
    return status;
}

exit_status verb_check(cli_job *job)
{
    part p;
    exit_status status = part_read(job, &p);
    if (status == EXIT_GOOD) {
        status = check(job, &p);
    }
    part_release(&p);
    return status;
}
