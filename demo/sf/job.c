// SPDX-License-Identifier: MIT
// One run of the program: how it fails, warns and tells the time.

#include "job.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

exit_status job_fail(cli_job *job, exit_status status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(job->message, sizeof job->message, format, arguments);
    va_end(arguments);
    return status;
}

static exit_status exit_of(sf_status status, exit_status status_input)
{
    switch (status) {
    case SF_ERR_CANCELLED:
        return EXIT_CANCELLED;
    case SF_ERR_MEMORY:
    case SF_ERR_OVERFLOW:
        return EXIT_RESOURCE;
    default:
        return status_input;
    }
}

exit_status job_fail_call(cli_job *job, sf_status status, const sf_fault *fault,
                          const char *subject, exit_status status_input)
{
    const char *why = fault != NULL && fault->status == status ? fault->message : "";
    if (status == SF_ERR_CANCELLED) {
        return job_fail(job, EXIT_CANCELLED, "Cancelled; nothing was changed.");
    }
    if (fault != NULL) {
        job->fault = *fault;
    }
    job->fault.status = status;
    char place[48] = "";
    if (why[0] != '\0' && fault->line > 0) {
        snprintf(place, sizeof place, ", line %lu", (unsigned long)fault->line);
    } else if (why[0] != '\0' && fault->offset > 0) {
        snprintf(place, sizeof place, ", byte %llu", (unsigned long long)fault->offset);
    }
    if (why[0] == '\0' && status == SF_ERR_IO && status_input == EXIT_RESOURCE) {
        why = "it could not be written whole; is there room on the disk?";
    }
    if (strstr(why, subject) != NULL) { // the sentence names it already
        return job_fail(job, exit_of(status, status_input), "%s", why);
    }
    return job_fail(job, exit_of(status, status_input), "%s%s: %s", subject, place,
                    why[0] != '\0' ? why : sf_status_message(status));
}

void job_report_culprits(const cli_job *job, report *r)
{
    report_begin(r, "culprits");
    report_count(r, "count", job->culprits);
    report_begin(r, "box_mm");
    report_numbers(r, "low", job->culprit_low_mm, 3);
    report_numbers(r, "high", job->culprit_high_mm, 3);
    report_end(r);
    report_end(r);
}

void job_warn(cli_job *job, const char *format, ...)
{
    char line[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    report_warn(job->report, line);
}

double job_seconds(const cli_job *job)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - job->start.tv_sec) +
           1e-9 * (double)(now.tv_nsec - job->start.tv_nsec);
}
