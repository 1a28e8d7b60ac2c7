// SPDX-License-Identifier: MIT
// Why: TRUST 86: progress lies in [0, 1] and never falls, a cancel sticks, and a host's threads see
// each index exactly once.

#include "base/task.h"
#include "test.h"

static double seen[64];
static size_t seen_count;

static void remember(void *user, double fraction)
{
    (void)user;
    if (seen_count < 64) {
        seen[seen_count++] = fraction;
    }
}

static void progress_never_falls(void)
{
    sf_task task = sf_task_default();
    task.progress = remember;
    seen_count = 0;
    sfi_progress progress = sfi_progress_begin(&task);
    static const uint64_t done[] = {0, 3, 2, 5, 5, 20, 1};
    for (size_t i = 0; i < sizeof done / sizeof done[0]; i++) {
        sfi_progress_report(&progress, done[i], 10);
    }
    CHECK_EQ(seen_count, 4);
    CHECK_NEAR(seen[0], 0.0, 0.0);
    CHECK_NEAR(seen[1], 0.3, 1e-15);
    CHECK_NEAR(seen[2], 0.5, 1e-15);
    CHECK_NEAR(seen[3], 1.0, 0.0);
}

static sf_task *whole_task;

static void remember_and_cancel(void *user, double fraction)
{
    remember(user, fraction);
    if (fraction > 0.45) {
        sf_task_cancel(whole_task);
    }
}

static void count_index(void *context, size_t index)
{
    ((int *)context)[index]++;
}

// A part reports to its stretch of the whole, uses its threads and is cancelled with it.
static void parts_belong_to_the_whole(void)
{
    sf_task task = sf_task_default();
    int counts[5] = {0, 0, 0, 0, 0};
    sfi_part part;
    whole_task = &task;
    task.progress = remember_and_cancel;
    seen_count = 0;
    sfi_progress whole = sfi_progress_begin(&task);
    sfi_part_begin(&part, &whole, 0.25, 0.75);
    sfi_progress inner = sfi_progress_begin(&part.task);
    sfi_progress_report(&inner, 0, 2);
    CHECK(!sf_task_is_cancelled(&part.task));
    sfi_progress_report(&inner, 1, 2);
    CHECK(sf_task_is_cancelled(&part.task)); // by this very report
    sfi_progress_report(&inner, 2, 2);
    CHECK(sf_task_is_cancelled(&part.task));
    CHECK_EQ(seen_count, 3);
    CHECK_NEAR(seen[0], 0.25, 1e-6);
    CHECK_NEAR(seen[1], 0.5, 1e-6);
    CHECK_NEAR(seen[2], 0.75, 1e-6);
    sfi_task_for(&part.task, 5, count_index, counts);
    CHECK(counts[0] == 1 && counts[4] == 1);
    sfi_part_begin(&part, &whole, 0.75, 1.0);
    CHECK(sf_task_is_cancelled(&part.task));
}

static void cancel_sticks(void)
{
    sf_task task = sf_task_default();
    CHECK(!sf_task_is_cancelled(&task));
    sf_task_cancel(&task);
    CHECK(sf_task_is_cancelled(&task));
    sf_task_cancel(&task);
    CHECK(sf_task_is_cancelled(&task));
    sf_task_cancel(NULL);
    CHECK(!sf_task_is_cancelled(NULL));
}

static void count_call(void *context, size_t index)
{
    ((int *)context)[index]++;
}

static void backwards(void *user, size_t count, sf_task_body body, void *context)
{
    (*(int *)user)++;
    while (count > 0) {
        body(context, --count);
    }
}

static void every_index_runs_once(void)
{
    int calls[100] = {0}, hosted = 0;
    sfi_task_for(NULL, 100, count_call, calls);
    sf_task task = sf_task_default();
    task.parallel_for = backwards;
    task.user = &hosted;
    sfi_task_for(&task, 100, count_call, calls);
    for (int i = 0; i < 100; i++) {
        CHECK_EQ(calls[i], 2);
    }
    CHECK_EQ(hosted, 1);
}

int main(void)
{
    TEST(progress_never_falls);
    TEST(parts_belong_to_the_whole);
    TEST(cancel_sticks);
    TEST(every_index_runs_once);
    return test_finish();
}
