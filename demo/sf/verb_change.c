// SPDX-License-Identifier: MIT
// sf trim, grow, repair, preserve: the part changed so that it prints without supports. They differ
// in what may be taken away and what may be added; everything else is one path.

#include "certify.h"
#include "change.h"
#include "describe.h"
#include "output.h"
#include "verbs.h"

static exit_status save(cli_job *job, const part *p, const change *done)
{
    const char *path = job->options.output;
    sf_save *certificate;
    exit_status status = certify_begin(job, p, done, &certificate);
    if (status == EXIT_GOOD && path != NULL) {
        status = output_save(job, p, done->after, path);
    }
    if (status != EXIT_GOOD) {
        sf_save_abort(certificate);
        return status;
    }
    status = certify_commit(job, certificate);
    if (status != EXIT_GOOD) {
        return status;
    }
    report_number(job->report, "seconds", job_seconds(job));
    if (path != NULL) {
        report_text(job->report, "output", path);
        report_say(job->report, "Written to %s.", path);
    } else {
        report_say(job->report, "Nothing was written; -o OUT says where to.");
    }
    return done->holds ? EXIT_GOOD : EXIT_PROPERTY;
}

static exit_status change_part(cli_job *job, const part *p, sf_operation operation)
{
    masks m;
    change done;
    exit_status status = masks_read(job, p, &m);
    if (status == EXIT_GOOD) {
        status = change_make(job, p, &m, operation, &done);
        if (status == EXIT_GOOD && change_is_empty(&done)) {
            status = job_fail(job, EXIT_PROPERTY, "Nothing is left: %s. Nothing was written.",
                              operation == SF_OPERATION_PRESERVE ? "--remove takes all of it"
                                                                 : "all of it hangs in the air");
        }
        if (status == EXIT_GOOD) {
            change_report(job->report, NULL, &done);
            change_say(job->report, &done);
            status = save(job, p, &done);
        }
        change_release(&done);
    }
    masks_release(&m);
    return status;
}

static exit_status work(cli_job *job, part *p, sf_operation operation)
{
    exit_status status = part_read(job, p);
    if (status == EXIT_GOOD) {
        status = part_voxelize(job, p);
    }
    if (status == EXIT_GOOD) {
        status = part_make_rule(job, p);
    }
    if (status != EXIT_GOOD) {
        return status;
    }
    describe_part(job, p, sf_operation_name(operation));
    return change_part(job, p, operation);
}

static exit_status run(cli_job *job, sf_operation operation)
{
    part p;
    exit_status status = output_check(job, 1);
    if (status == EXIT_GOOD) {
        status = output_probe(job, job->options.certificate, OUTPUT_MESH);
    }
    if (status == EXIT_GOOD) {
        status = work(job, &p, operation);
        part_release(&p);
    }
    return status;
}

exit_status verb_trim(cli_job *job)
{
    return run(job, SF_OPERATION_TRIM);
}

exit_status verb_grow(cli_job *job)
{
    return run(job, SF_OPERATION_GROW);
}

exit_status verb_repair(cli_job *job)
{
    return run(job, SF_OPERATION_REPAIR);
}

exit_status verb_preserve(cli_job *job)
{
    if (job->options.remove == NULL) {
        return job_fail(job, EXIT_USAGE,
                        "'sf preserve' needs --remove MESH, which says what is to go.");
    }
    return run(job, SF_OPERATION_PRESERVE);
}
