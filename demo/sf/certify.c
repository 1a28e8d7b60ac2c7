// SPDX-License-Identifier: MIT
// A certificate of what a verb made.
//
// It speaks of the grid, not of a mesh: a mesh that is written from it, smoothed or not, becomes
// other voxels in somebody else's hands. So the report says which files belong together only where
// a stack was written.

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

static sf_status save(const sf_certificate *certificate, const char *path, sf_fault *fault)
{
    sf_save *file = NULL;
    sf_status status = sf_save_begin(path, NULL, &file, fault);
    if (status != SF_OK) {
        return status;
    }
    status = sf_certificate_write(certificate, sf_save_sink(file));
    if (status == SF_OK) {
        return sf_save_commit(file, fault);
    }
    sf_save_abort(file);
    return status;
}

exit_status certify(cli_job *job, const part *p, const change *done)
{
    const char *path = job->options.certificate, *output = job->options.output;
    sf_certificate *certificate = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    if (path == NULL) {
        return EXIT_GOOD;
    }
    progress_phase("certifying");
    sf_status status = make(job, p, done, &certificate, &fault);
    if (status != SF_OK) {
        return job_fail_call(job, status, &fault, "the certificate", EXIT_PROPERTY);
    }
    status = save(certificate, path, &fault);
    sf_certificate_destroy(certificate);
    if (status != SF_OK) {
        return job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
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
