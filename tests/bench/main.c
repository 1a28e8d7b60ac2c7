// SPDX-License-Identifier: MIT
// sf-bench: the heavy jobs, each beside what memory alone would take in the same rounds.
//
//     sf-bench [--json FILE] [--rounds N] [--isa NAME] [JOB]
//
// JOB picks the jobs whose names begin with it. --rounds sets the least number of rounds (7), --isa
// the best instruction set to use: reference, word, sse2, neon, avx2 or avx512. Nothing here passes
// or fails by its time; goals are printed beside the figures.

#include "rounds.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FIGURES_MAX 128
#define BUDGET_MS 1500.0 // of rounds, for one job

typedef struct figure {
    char job[32], size[32];
    bench_times times;
    double p99_ms; // of single times; 0 where rounds were taken
} figure;

static figure figures[FIGURES_MAX];
static int figure_count;
static const char *wanted = "";
static int least_rounds = 7;

int bench_wants(const char *job)
{
    size_t a = strlen(job), b = strlen(wanted);
    return strncmp(job, wanted, a < b ? a : b) == 0;
}

void bench_must(sf_status status)
{
    if (status != SF_OK) {
        fprintf(stderr, "sf-bench: %s\n", sf_status_message(status));
        exit(1);
    }
}

void *bench_memory(size_t size)
{
    void *memory = malloc(size > 0 ? size : 1);
    if (memory == NULL) {
        bench_must(SF_ERR_MEMORY);
    }
    return memory;
}

static void print_line(const figure *f, double goal, double amount, const char *unit)
{
    char bound[16] = "";
    if (goal > 0) {
        snprintf(bound, sizeof bound, "<= %.1f", goal);
    }
    printf("%-20s %-10s %10.3f %10.3f %8.2f %8s %10.3g %s/s\n", f->job, f->size, f->times.job_ms,
           f->times.limit_ms, f->times.ratio, bound, amount / f->times.job_ms * 1e3, unit);
    fflush(stdout);
}

void bench_measure(const char *job, const char *size, double goal, double amount, const char *unit,
                   const bench_work *work)
{
    if (strncmp(job, wanted, strlen(wanted)) != 0 || figure_count == FIGURES_MAX) {
        return;
    }
    figure *f = &figures[figure_count++];
    snprintf(f->job, sizeof f->job, "%s", job);
    snprintf(f->size, sizeof f->size, "%s", size);
    f->times = bench_rounds(work, least_rounds, BUDGET_MS);
    print_line(f, goal, amount, unit);
}

static int compare_times(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void bench_spread(const char *job, const char *size, double goal_ms, double *times_ms, int count)
{
    if (figure_count == FIGURES_MAX) {
        return;
    }
    figure *f = &figures[figure_count++];
    snprintf(f->job, sizeof f->job, "%s", job);
    snprintf(f->size, sizeof f->size, "%s", size);
    qsort(times_ms, (size_t)count, sizeof *times_ms, compare_times);
    f->times.job_ms = times_ms[count / 2];
    f->p99_ms = times_ms[count * 99 / 100];
    printf("%-20s %-10s %10.3f 99th of a hundred %.3f ms, goal <= %.1f ms\n", f->job, f->size,
           f->times.job_ms, f->p99_ms, goal_ms);
    fflush(stdout);
}

static int write_json(const char *path)
{
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        fprintf(stderr, "sf-bench: cannot write %s\n", path);
        return 0;
    }
    fputs("[", file);
    for (int i = 0; i < figure_count; i++) {
        const figure *f = &figures[i];
        fprintf(file,
                "%s\n  {\"job\": \"%s\", \"size\": \"%s\", \"median_ms\": %.6f, "
                "\"limit_ms\": %.6f, \"ratio\": %.4f",
                i > 0 ? "," : "", f->job, f->size, f->times.job_ms, f->times.limit_ms,
                f->times.ratio);
        if (f->p99_ms > 0) {
            fprintf(file, ", \"p99_ms\": %.6f", f->p99_ms);
        }
        fputs("}", file);
    }
    fputs("\n]\n", file);
    int good = ferror(file) == 0;
    return fclose(file) == 0 && good;
}

// Returns 0 for a name that no instruction set has.
static int limit_isa(const char *name)
{
    static const char *const names[SF_ISA_COUNT] = {"reference", "word", "sse2",
                                                    "neon",      "avx2", "avx512"};
    for (int isa = 0; isa < SF_ISA_COUNT; isa++) {
        if (strcmp(names[isa], name) == 0) {
            sf_isa_limit((sf_isa)isa);
            return 1;
        }
    }
    return 0;
}

static int usage(void)
{
    fputs("usage: sf-bench [--json FILE] [--rounds N] [--isa NAME] [JOB]\n", stderr);
    return 2;
}

int main(int argc, char **argv)
{
    const char *json = NULL;
    for (int i = 1; i < argc; i++) {
        const char *value = i + 1 < argc ? argv[i + 1] : "";
        if (strcmp(argv[i], "--json") == 0 && *value != '\0') {
            json = argv[++i];
        } else if (strcmp(argv[i], "--rounds") == 0 && atoi(value) >= 1 &&
                   atoi(value) <= ROUNDS_MAX) {
            least_rounds = atoi(argv[++i]);
        } else if (strcmp(argv[i], "--isa") == 0 && limit_isa(value)) {
            i++;
        } else if (argv[i][0] != '-') {
            wanted = argv[i];
        } else {
            return usage();
        }
    }
    printf("%-20s %-10s %10s %10s %8s %8s %s\n", "job", "size", "median ms", "limit ms", "ratio",
           "goal", "      rate");
    bench_trim();
    bench_trim_box();
    bench_morphology();
    bench_preserve();
    bench_meshes();
    bench_grow();
    bench_balance();
    bench_carve();
    bench_handles();
    bench_halftone();
    bench_grade();
    bench_jobs();
    bench_sculpt();
    bench_sums();
    bench_repair();
    if (figure_count == 0) {
        fprintf(stderr, "sf-bench: no job begins with '%s'\n", wanted);
        return 2;
    }
    return json == NULL || write_json(json) ? 0 : 1;
}
