// SPDX-License-Identifier: MIT
// sf: the command line of libsf. Finds the verb, runs it, prints its report.

#include "cli.h"
#include "progress.h"
#include "verbs.h"

#include <stdio.h>
#include <string.h>

static void help(FILE *to)
{
    fputs("sf: shapes that print without supports\n\nusage: sf VERB [options] FILE\n\n", to);
    for (int i = 0; i < verbs_count; i++) {
        fprintf(to, "  %-9s %s\n", verbs_table[i].verb.name, verbs_table[i].verb.purpose);
    }
    fputs(
        "\n'sf VERB --help' says more, with examples; 'sf --version' says which version this is.\n",
        to);
}

static sf_status write_file(void *user, const void *data, size_t size)
{
    return fwrite(data, 1, size, user) == size ? SF_OK : SF_ERR_IO;
}

static sf_sink sink_of(FILE *file)
{
    sf_sink sink = {write_file, file};
    return sink;
}

// A failure as JSON on standard output, so that a program that reads it finds one object either
// way.
static void print_failure_json(const cli_job *job, exit_status status)
{
    report *r = report_create();
    if (r == NULL) {
        return;
    }
    report_begin(r, "error");
    report_count(r, "exit", (uint64_t)status);
    if (job->fault.status != SF_OK) {
        report_text(r, "status", sf_status_name(job->fault.status));
    }
    report_text(r, "message", job->message);
    report_count(r, "line", job->fault.line);
    report_count(r, "offset", job->fault.offset);
    report_end(r);
    if (job->culprits > 0) {
        job_report_culprits(job, r);
    }
    (void)!report_print_json(r, sink_of(stdout));
    report_destroy(r);
}

static void print_failure(const cli_job *job, exit_status status)
{
    fprintf(stderr, "sf: %s\n", job->message);
    if (job->options.json) {
        print_failure_json(job, status);
    }
}

// Whether JSON is asked for on a command line that makes no sense.
static int asks_for_json(int argc, char **argv)
{
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        if (strcmp(argv[i], "--json") == 0) {
            return 1;
        }
    }
    return 0;
}

static exit_status print_outcome(cli_job *job, exit_status status)
{
    sf_status printed = SF_OK;
    if (job->message[0] != '\0') {
        print_failure(job, status);
    } else {
        if (!job->options.json) {
            printed = report_print_warnings(job->report, sink_of(stderr));
        }
        if (printed == SF_OK) {
            printed = job->options.json ? report_print_json(job->report, sink_of(stdout))
                                        : report_print_text(job->report, sink_of(stdout));
        }
    }
    if (fflush(stdout) != 0 || printed != SF_OK) {
        fprintf(stderr, "sf: the report could not be written\n");
        return EXIT_RESOURCE;
    }
    return status;
}

static exit_status run_verb(int index, int argc, char **argv)
{
    cli_job job;
    memset(&job, 0, sizeof job);
    clock_gettime(CLOCK_MONOTONIC, &job.start);
    int parsed = options_parse(&verbs_table[index].verb, argc, argv, &job.options, job.message,
                               sizeof job.message);
    if (parsed > 0) {
        options_help(&verbs_table[index].verb, stdout);
        return EXIT_GOOD;
    }
    if (parsed < 0) {
        job.options.json = asks_for_json(argc, argv);
        return print_outcome(&job, EXIT_USAGE);
    }
    job.report = report_create();
    if (job.report == NULL) {
        fprintf(stderr, "sf: out of memory\n");
        return EXIT_RESOURCE;
    }
    job.task = sf_task_default();
    progress_attach(&job.task, job.options.quiet, job.options.threads);
    exit_status status = verbs_table[index].run(&job);
    progress_end();
    status = print_outcome(&job, status);
    report_destroy(job.report);
    return status;
}

static exit_status refuse_verb(const char *name, int json)
{
    cli_job job;
    memset(&job, 0, sizeof job);
    job.options.json = json;
    exit_status status = job_fail(&job, EXIT_USAGE, "there is no verb '%.200s'", name);
    status = print_outcome(&job, status);
    fputs("\n", stderr);
    help(stderr);
    return status;
}

int sf_cli_main(int argc, char **argv)
{
    const char *name = argc > 1 ? argv[1] : "--help";
    if (strcmp(name, "--version") == 0) {
        printf("sf %s\n", sf_version());
        return EXIT_GOOD;
    }
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 || strcmp(name, "help") == 0) {
        for (int i = 0; argc == 3 && i < verbs_count; i++) {
            if (strcmp(verbs_table[i].verb.name, argv[2]) == 0) {
                options_help(&verbs_table[i].verb, stdout);
                return EXIT_GOOD;
            }
        }
        help(argc > 1 ? stdout : stderr);
        return argc > 1 ? EXIT_GOOD : EXIT_USAGE;
    }
    for (int i = 0; i < verbs_count; i++) {
        if (strcmp(verbs_table[i].verb.name, name) == 0) {
            return (int)run_verb(i, argc - 1, argv + 1);
        }
    }
    return (int)refuse_verb(name, asks_for_json(argc, argv));
}
