// SPDX-License-Identifier: MIT
// sf: the command line of libsf. Finds the verb, runs it, prints its report.

#include "progress.h"
#include "verbs.h"

#include <stdio.h>
#include <string.h>

#define INPUT_OPTIONS                                                                              \
    (OPTION_RESOLUTION | OPTION_PITCH | OPTION_UP | OPTION_UNITS | OPTION_SCALE | OPTION_SIZE |    \
     OPTION_FILL | OPTION_MEMORY)
#define RULE_OPTIONS (OPTION_ANGLE | OPTION_RULE | OPTION_BED | OPTION_BRIDGE)
#define HOST_OPTIONS (OPTION_THREADS | OPTION_JSON | OPTION_QUIET)

typedef exit_status (*verb_function)(cli_job *job);

static const struct {
    cli_verb verb;
    verb_function run;
} verbs[] = {
    {{"run", "check a part, make it printable, write a folder", "FILE", 1,
      INPUT_OPTIONS | RULE_OPTIONS | HOST_OPTIONS | OPTION_OUTPUT | OPTION_SMOOTH | OPTION_VIEW |
          OPTION_PIXELS,
      "  sf run\n  sf run part.stl --angle 50 -o printable\n",
      "folder for the results (default out)"},
     verb_run},
    {{"info", "what a part is: size, volume, mass, holes, orientation", "FILE", 0,
      HOST_OPTIONS | OPTION_UP | OPTION_UNITS | OPTION_SCALE | OPTION_SIZE,
      "  sf info part.stl\n  sf info part.obj --units in --up +y --json\n  sf info layers\n", NULL},
     verb_info},
    {{"check", "does it print without supports, and where not?", "FILE", 0,
      INPUT_OPTIONS | RULE_OPTIONS | HOST_OPTIONS,
      "  sf check part.stl\n  sf check part.stl --pitch 0.1,0.1,0.05 --angle 50\n"
      "  sf check scene:garden --rule box3 --json\n",
      NULL},
     verb_check},
    {{"trim", "take away what cannot print without supports", "FILE", 0,
      INPUT_OPTIONS | RULE_OPTIONS | HOST_OPTIONS | OPTION_OUTPUT | OPTION_SMOOTH |
          OPTION_CERTIFICATE,
      "  sf trim part.stl -o printable.stl\n  sf trim part.stl --resolution 512 -o layers\n"
      "  sf trim layers -o printable.ply\n"
      "  sf trim part.stl -o layers --certificate layers.json\n",
      "a mesh (.stl .obj .ply), or a folder for layers"},
     verb_trim},
    {{"slice", "the part as a stack of pictures, as it is", "FILE", 0,
      INPUT_OPTIONS | RULE_OPTIONS | HOST_OPTIONS | OPTION_OUTPUT,
      "  sf slice part.stl --pitch 0.05 -o layers\n", "folder for the layers"},
     verb_slice},
    {{"orient", "which way up does it print best, and why?", "FILE", 0,
      OPTION_RESOLUTION | OPTION_UP | OPTION_UNITS | OPTION_SCALE | OPTION_SIZE | OPTION_FILL |
          OPTION_ANGLE | OPTION_RULE | HOST_OPTIONS | OPTION_OUTPUT | OPTION_COUNT,
      "  sf orient part.stl\n  sf orient part.stl --angle 50 --count 3 -o turned.stl\n",
      "the mesh, turned the best way (.stl .obj .ply)"},
     verb_orient},
    {{"render", "a picture of the part, what cannot print in red", "FILE", 0,
      INPUT_OPTIONS | RULE_OPTIONS | HOST_OPTIONS | OPTION_OUTPUT | OPTION_VIEW | OPTION_PIXELS,
      "  sf render part.stl -o part.png\n  sf render part.stl --view below --pixels 800,600\n",
      "the picture (default render.png)"},
     verb_render},
};
enum { VERB_COUNT = sizeof verbs / sizeof verbs[0] };

static void help(FILE *to)
{
    fputs("sf: shapes that print without supports\n\nusage: sf VERB [options] FILE\n\n", to);
    for (int i = 0; i < VERB_COUNT; i++) {
        fprintf(to, "  %-8s %s\n", verbs[i].verb.name, verbs[i].verb.purpose);
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
    (void)!report_print_json(r, sink_of(stdout));
    report_destroy(r);
}

static exit_status print_outcome(cli_job *job, exit_status status)
{
    sf_status printed = SF_OK;
    if (job->message[0] != '\0') {
        fprintf(stderr, "sf: %s\n", job->message);
        if (job->options.json) {
            print_failure_json(job, status);
        }
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
    char message[512];
    memset(&job, 0, sizeof job);
    clock_gettime(CLOCK_MONOTONIC, &job.start);
    int parsed =
        options_parse(&verbs[index].verb, argc, argv, &job.options, message, sizeof message);
    if (parsed > 0) {
        options_help(&verbs[index].verb, stdout);
        return EXIT_GOOD;
    }
    if (parsed < 0) {
        fprintf(stderr, "sf: %s\n", message);
        return EXIT_USAGE;
    }
    job.report = report_create();
    if (job.report == NULL) {
        fprintf(stderr, "sf: out of memory\n");
        return EXIT_RESOURCE;
    }
    job.task = sf_task_default();
    progress_attach(&job.task, job.options.quiet, job.options.threads);
    exit_status status = verbs[index].run(&job);
    progress_end();
    status = print_outcome(&job, status);
    report_destroy(job.report);
    return status;
}

int main(int argc, char **argv)
{
    const char *name = argc > 1 ? argv[1] : "--help";
    if (strcmp(name, "--version") == 0) {
        printf("sf %s\n", sf_version());
        return EXIT_GOOD;
    }
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 || strcmp(name, "help") == 0) {
        help(argc > 1 ? stdout : stderr);
        return argc > 1 ? EXIT_GOOD : EXIT_USAGE;
    }
    for (int i = 0; i < VERB_COUNT; i++) {
        if (strcmp(verbs[i].verb.name, name) == 0) {
            return (int)run_verb(i, argc - 1, argv + 1);
        }
    }
    fprintf(stderr, "sf: there is no verb '%s'\n\n", name);
    help(stderr);
    return EXIT_USAGE;
}
