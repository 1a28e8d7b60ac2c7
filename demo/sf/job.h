// SPDX-License-Identifier: MIT
// One run of the program: what was asked, what is under way, what became of it.
//
// Every step of every verb takes a job and returns an exit status; the first that is not EXIT_GOOD
// ends the run. A step that fails leaves one sentence in the job, which main() prints once.

#ifndef DEMO_SF_JOB_H
#define DEMO_SF_JOB_H

#include "options.h"
#include "report.h"

#include <sf/sf.h>

#include <time.h>

// Exit statuses mean the same in every verb.
typedef enum exit_status {
    EXIT_GOOD = 0, // done
    EXIT_PROPERTY =
        1,          // the asked property was not reached (check: not support-free, or it topples)
    EXIT_USAGE = 2, // the command line does not make sense
    EXIT_INPUT = 3, // the input cannot be read or is not what it should be
    EXIT_RESOURCE = 4,   // memory or disk
    EXIT_CANCELLED = 130 // stopped by the person
} exit_status;

typedef struct cli_job {
    cli_options options;
    report *report;
    sf_task task;
    struct timespec start;
    char message[640]; // why the run failed, or ""
    sf_fault fault;    // line and offset, where the library gave them
    uint64_t culprits; // voxels that must stay and cannot, where that is why; and where they are
    double culprit_low_mm[3], culprit_high_mm[3];
} cli_job;

// Leave a sentence and return `status`.
exit_status job_fail(cli_job *job, exit_status status, const char *format, ...)
#if defined(__GNUC__) && !defined(__MINGW32__) // whose printf is another
    __attribute__((format(printf, 3, 4)))
#endif
    ;

// The same for a call of the library that failed: its own sentence where it gave one. `subject` is
// what the call worked on (a path), `status_input` the exit status for bad data.
exit_status job_fail_call(cli_job *job, sf_status status, const sf_fault *fault,
                          const char *subject, exit_status status_input);

// Fields of the voxels that must stay and cannot: an object "culprits".
void job_report_culprits(const cli_job *job, report *r);

// A warning goes into the report, and to standard error at the end.
void job_warn(cli_job *job, const char *format, ...)
#if defined(__GNUC__) && !defined(__MINGW32__) // whose printf is another
    __attribute__((format(printf, 2, 3)))
#endif
    ;

// Seconds since the job began.
double job_seconds(const cli_job *job);

#endif
