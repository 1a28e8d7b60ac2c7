// SPDX-License-Identifier: MIT
// Rounds: every round prepares and times the limit, then prepares and times the job. What the
// neighbours of a shared machine do falls on both, so the median of the ratios within rounds is the
// figure to compare; milliseconds alone come and go by a third. Time is that of the processor on
// this thread, where the system tells it.

#if !defined(_WIN32)
#define _POSIX_C_SOURCE 199309L
#endif

#include "rounds.h"

#include <stdlib.h>
#include <time.h>

double bench_now_ms(void)
{
#if defined(CLOCK_THREAD_CPUTIME_ID) && !defined(_WIN32)
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
#else
    return (double)clock() * 1e3 / CLOCKS_PER_SEC;
#endif
}

static double time_ms(const bench_work *work, void (*what)(void *))
{
    if (work->prepare != NULL) {
        work->prepare(work->user);
    }
    double start = bench_now_ms();
    what(work->user);
    return bench_now_ms() - start;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, ascending);
    return (values[count / 2] + values[(count - 1) / 2]) / 2;
}

bench_times bench_rounds(const bench_work *work, int least, double budget_ms)
{
    double jobs[ROUNDS_MAX], limits[ROUNDS_MAX], ratios[ROUNDS_MAX], spent = 0;
    int count = 0;
    (void)time_ms(work, work->limit); // the first touch of memory is nobody's
    (void)time_ms(work, work->job);
    while (count < least || (spent < budget_ms && count < ROUNDS_MAX)) {
        limits[count] = time_ms(work, work->limit);
        jobs[count] = time_ms(work, work->job);
        ratios[count] = jobs[count] / (limits[count] > 1e-6 ? limits[count] : 1e-6);
        spent += limits[count] + jobs[count];
        count++;
    }
    bench_times times = {median(jobs, count), median(limits, count), median(ratios, count), count};
    return times;
}
