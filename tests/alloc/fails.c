// SPDX-License-Identifier: MIT
// Why: paths that fail are the ones that nobody walks. For every public function, arguments are
// looked for with which it succeeds; then the same call is made again and again from the same
// start: with its k-th request for memory refused, for every k, that one alone and all from there
// on; with its k-th read or write failing; and cancelled at its k-th report of progress. Each time
// it must say so or do without, and the world (fuzz/world.c) holds that no object and no output
// changed, that nothing leaks, and that what it says is of a kind that is documented.

#include "test.h"

#include <limits.h>

#include "world.h"

enum { BYTES = 1200, TRIES = 300, MOST = 200, CANCELS = 8 };

typedef struct start {
    uint8_t bytes[BYTES];
    long requests, transfers, ticks;
} start;

typedef enum way { REFUSE_ONCE, REFUSE_ALL, BREAK, CANCEL, WAYS } way;

static long calls_made, failures_made;
static const char *only; // a function, named on the command line

static void make_bytes(start *s, uint64_t seed)
{
    test_reseed(seed);
    for (size_t i = 0; i < BYTES; i++) {
        s->bytes[i] = (uint8_t)test_random();
    }
}

static sf_status run(const world_call *call, const start *s, way how, long k, world *w)
{
    world_begin(w, s->bytes, BYTES, 1);
    w->fail_once = how == REFUSE_ONCE;
    w->fail_at = how == REFUSE_ONCE || how == REFUSE_ALL ? k : -1;
    w->break_at = how == BREAK ? k : -1;
    w->cancel_wanted = how == CANCEL ? k : -1;
    calls_made++;
    return call->call(w);
}

// Arguments with which the call succeeds; those that take more memory are better.
static int find_start(const world_call *call, size_t index, uint64_t from, start *s)
{
    for (uint64_t i = 0; i < TRIES; i++) {
        world w;
        make_bytes(s, from + 1000003 * index + i);
        sf_status status = run(call, s, CANCEL, LONG_MAX - 1, &w);
        s->requests = w.requests;
        s->transfers = w.transfers;
        s->ticks = w.ticks;
        int called = w.called;
        world_end(&w);
        if (called && status == SF_OK) {
            return 1;
        }
    }
    return 0;
}

static void fail_in_every_place(const world_call *call, const start *s, way how, long places)
{
    static const sf_status expected[WAYS] = {SF_ERR_MEMORY, SF_ERR_MEMORY, SF_ERR_IO,
                                             SF_ERR_CANCELLED};
    long step = places > MOST ? places / MOST : 1;
    for (long k = 0; k < places; k += k < MOST / 2 ? 1 : step) {
        world w;
        sf_status status = run(call, s, how, k, &w);
        world_end(&w);
        failures_made += status != SF_OK;
        if (status != SF_OK && status != expected[how]) {
            printf("# %s: way %d, place %ld of %ld: %s\n", call->name, how, k, places,
                   sf_status_name(status));
            CHECK(status == expected[how]);
        }
    }
}

static void every_function_fails_as_promised(void)
{
    size_t succeeded = 0, statuses = 0;
    for (size_t i = 0; i < world_call_count; i++) {
        const world_call *call = &world_calls[i];
        if (!call->has_status || (only != NULL && strcmp(only, call->name) != 0)) {
            continue;
        }
        start s;
        statuses++;
        int found = find_start(call, i, 77, &s);
        if (found) {
            fail_in_every_place(call, &s, REFUSE_ONCE, s.requests);
            fail_in_every_place(call, &s, REFUSE_ALL, s.requests);
            fail_in_every_place(call, &s, BREAK, s.transfers);
            fail_in_every_place(call, &s, CANCEL, s.ticks < CANCELS ? s.ticks : CANCELS);
        }
        if (!found) {
            printf("# %s never succeeds\n", call->name);
            CHECK(found);
        }
        if (getenv("FUZZ_SAY") != NULL) {
            fprintf(stderr, "%s %ld %ld\n", call->name, calls_made, failures_made);
        }
        succeeded += (size_t)found;
    }
    printf("# %zu of %zu functions with a status succeed; %ld calls, of which %ld failed\n",
           succeeded, statuses, calls_made, failures_made);
    CHECK(only != NULL || failures_made > 1000);
}

int main(int argc, char **argv)
{
    only = argc > 1 ? argv[1] : NULL;
    TEST(every_function_fails_as_promised);
    return test_finish();
}
