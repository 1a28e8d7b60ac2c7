// SPDX-License-Identifier: MIT
// The whole test framework: checks that print, and a summary in TAP.
//
// A test program is one behaviour. Its main() calls TEST(f) for each case and ends with
// `return test_finish();`. A case uses CHECK(expression) or, to see both sides,
// CHECK_EQ(a, b) for integers, CHECK_NEAR(a, b, tolerance) for doubles, CHECK_STR(a, b). A failing
// check prints file, line, expression, both values and the seed, and the case goes on.
// SKIP("why") leaves the case and says so. Randomness comes from test_random(), whose seed is
// printed and can be set: TEST_SEED=123 build/tests/...

#ifndef SF_TEST_H
#define SF_TEST_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int test_count, test_failures, test_case_failures;
static const char *test_skip_reason;
static uint64_t test_seed = 20260101u, test_state = 20260101u;

static void test_reseed(uint64_t seed)
{
    test_seed = seed;
    test_state = seed;
}

// splitmix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", 2014).
static inline uint64_t test_random(void)
{
    uint64_t z = (test_state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static inline uint32_t test_random_below(uint32_t bound)
{
    return (uint32_t)((test_random() >> 32) * bound >> 32);
}

static inline double test_random_unit(void)
{
    return (double)(test_random() >> 11) * 0x1p-53;
}

static inline void test_run(const char *name, void (*body)(void))
{
    const char *seed = getenv("TEST_SEED");
    test_reseed(seed != NULL ? strtoull(seed, NULL, 10) : 20260101u);
    test_case_failures = 0;
    test_skip_reason = NULL;
    body();
    test_count++;
    if (test_case_failures > 0) {
        test_failures++;
        printf("not ok %d - %s\n", test_count, name);
    } else if (test_skip_reason != NULL) {
        printf("ok %d - %s # SKIP %s\n", test_count, name, test_skip_reason);
    } else {
        printf("ok %d - %s\n", test_count, name);
    }
    fflush(stdout);
}

static inline int test_finish(void)
{
    printf("1..%d\n", test_count);
    return test_failures > 0;
}

// Reported checks are limited, so that a broken kernel does not print a million lines.
static inline int test_report(const char *file, int line, const char *expression)
{
    if (test_case_failures++ >= 10) {
        return 0;
    }
    printf("# %s:%d: %s (seed %llu)\n", file, line, expression, (unsigned long long)test_seed);
    return 1;
}

static inline int test_equal(long long a, long long b, const char *file, int line, const char *text)
{
    if (a != b && test_report(file, line, text)) {
        printf("#   left %lld, right %lld\n", a, b);
    }
    return a == b;
}

static inline int test_near(double a, double b, double tolerance, const char *file, int line,
                            const char *text)
{
    int good = fabs(a - b) <= tolerance;
    if (!good && test_report(file, line, text)) {
        printf("#   left %.17g, right %.17g, tolerance %g\n", a, b, tolerance);
    }
    return good;
}

static inline int test_same_text(const char *a, const char *b, const char *file, int line,
                                 const char *text)
{
    int good = strcmp(a, b) == 0;
    if (!good && test_report(file, line, text)) {
        printf("#   left \"%s\", right \"%s\"\n", a, b);
    }
    return good;
}

#define TEST(body) test_run(#body, body)
#define CHECK(expression) ((void)((expression) ? 1 : test_report(__FILE__, __LINE__, #expression)))
#define CHECK_EQ(a, b)                                                                             \
    ((void)test_equal((long long)(a), (long long)(b), __FILE__, __LINE__, #a " == " #b))
#define CHECK_NEAR(a, b, tolerance)                                                                \
    ((void)test_near((a), (b), (tolerance), __FILE__, __LINE__, #a " ~ " #b))
#define CHECK_STR(a, b) ((void)test_same_text((a), (b), __FILE__, __LINE__, #a " == " #b))
#define SKIP(reason)                                                                               \
    do {                                                                                           \
        test_skip_reason = reason;                                                                 \
        return;                                                                                    \
    } while (0)

#endif
