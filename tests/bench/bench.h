// SPDX-License-Identifier: MIT
// Timing of one job beside the limit that memory sets to it, in the same rounds.

#ifndef SF_BENCH_H
#define SF_BENCH_H

#include <sf/mesh.h>
#include <sf/support.h>

// What is timed. `prepare` is not timed and is called before each of the two others; it may be
// NULL. The limit reads and writes the bytes that the job cannot do without, and does nothing else.
typedef struct bench_work {
    void (*prepare)(void *user);
    void (*job)(void *user);
    void (*limit)(void *user);
    void *user;
} bench_work;

// Whether a job of this name was asked for on the command line.
int bench_wants(const char *job);

// Time the job, print a line of the table and keep the figures. `goal` is the ratio to stay under,
// 0 where none is set; `amount` is what one job handles, in `unit`s, for a rate.
void bench_measure(const char *job, const char *size, double goal, double amount, const char *unit,
                   const bench_work *work);

// Print and keep the median and the 99th percentile of times that were taken one by one, which are
// put in order. `goal_ms` is what the percentile should stay under.
void bench_spread(const char *job, const char *size, double goal_ms, double *times_ms, int count);

// Leave the program when a call of the library fails.
void bench_must(sf_status status);
void *bench_memory(size_t size);

// The processor's time on this thread.
double bench_now_ms(void);

// The jobs, by file.
void bench_trim(void);
void bench_trim_box(void);
void bench_morphology(void);
void bench_preserve(void);
void bench_sums(void);
void bench_meshes(void);
void bench_repair(void);
void bench_grow(void);
void bench_balance(void);
void bench_carve(void);
void bench_handles(void);
void bench_halftone(void);
void bench_grade(void);
void bench_sculpt(void);
void bench_jobs(void);

#endif
