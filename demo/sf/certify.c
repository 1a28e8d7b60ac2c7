// SPDX-License-Identifier: MIT
// A certificate of what a verb made.
//
// It speaks of the grid, not of a mesh: a mesh that is written from it, smoothed or not, becomes
// other voxels in somebody else's hands. So the report says which files belong together only where
// a stack was written.
//
// It is written before the result and gets its name after it: a disk that has no room for both has
// neither.

#include "certify.h"

#include "output.h"
#include "progress.h"

static sf_status make(cli_job *job, const part *p, const change *done, sf_certificate **certificate,
                      sf_fault *fault)
{
    sf_terms terms = part_terms(p);
    terms.exempt = done->accepted;
    sf_claim claim = sf_claim_default();
    claim.terms = &terms;
    claim.angle_rad = job->options.angle_rad;
    claim.bridge_span_mm = job->options.bridge_mm[0];
    claim.bridge_anchor_mm = job->options.bridge_mm[1];
    claim.operation = done->operation;
    claim.before = p->grid;
    return sf_certificate_make(done->after, &claim, NULL, &job->task, certificate, fault);
}

static exit_status fail(cli_job *job, sf_status status, const sf_fault *fault)
{
    return job_fail_call(job, status, fault, job->options.certificate, EXIT_RESOURCE);
}

exit_status certify_begin(cli_job *job, const part *p, const change *done, sf_save **file)
{
    sf_certificate *certificate = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    *file = NULL;
    if (job->options.certificate == NULL) {
        return EXIT_GOOD;
    }
    progress_phase("certifying");
    sf_status status = make(job, p, done, &certificate, &fault);
    if (status != SF_OK) {
        return job_fail_call(job, status, &fault, "the certificate", EXIT_PROPERTY);
    }
    status = sf_save_begin(job->options.certificate, NULL, file, &fault);
    if (status == SF_OK) {
        status = sf_certificate_write(certificate, sf_save_sink(*file));
    }
    sf_certificate_destroy(certificate);
    if (status != SF_OK) {
        sf_save_abort(*file);
        *file = NULL;
        return fail(job, status, &fault);
    }
    return EXIT_GOOD;
}

exit_status certify_commit(cli_job *job, sf_save *file)
{
    const char *path = job->options.certificate, *output = job->options.output;
    sf_fault fault = {SF_OK, 0, 0, ""};
    if (path == NULL) {
        return EXIT_GOOD;
    }
    sf_status status = sf_save_commit(file, &fault);
    if (status != SF_OK) {
        return fail(job, status, &fault);
    }
    report_text(job->report, "certificate", path);
    if (output != NULL && output_kind_of(output) == OUTPUT_STACK) {
        report_say(job->report, "Certified: see 'sf-verify %s %s'.", output, path);
    } else {
        report_say(job->report,
                   "The certificate %s is of the voxels; it takes a stack to check it.", path);
    }
    return EXIT_GOOD;
}
