// SPDX-License-Identifier: MIT
// Job and limit in turns.

#ifndef SF_BENCH_ROUNDS_H
#define SF_BENCH_ROUNDS_H

#include "bench.h"

#define ROUNDS_MAX 51

typedef struct bench_times {
    double job_ms, limit_ms; // medians
    double ratio;            // median of the ratios within rounds
    int rounds;
} bench_times;

// At least `least` rounds (up to ROUNDS_MAX), and more while the budget lasts.
bench_times bench_rounds(const bench_work *work, int least, double budget_ms);

#endif
