// SPDX-License-Identifier: MIT
// Why: where a centre of mass is sent decides what is carved. Targets come from clipping polygons;
// here they are held against the corners, feet and centres that pairs and triples of half-planes
// make, whatever is nearest or deepest of those that hold. Half-spaces slant and lie at any height,
// and may leave nothing at all, a line, or a point.

#include "balance/stance/target.h"
#include "test.h"

#include <sf/base.h>

enum { MOST = 9 };

// A base whose up is z, so that half-planes are what is left of a half-space at a height.
typedef struct problem {
    sf_halfspace h[MOST];
    sfi_base base;
    double com[3];
    double a[MOST][2], b[MOST]; // a . x >= b, x from the centre of mass
} problem;

static void finish(problem *p, size_t count)
{
    p->base.up[0] = p->base.up[1] = 0;
    p->base.up[2] = 1;
    p->base.halfspaces = p->h;
    p->base.count = count;
    for (size_t i = 0; i < count; i++) {
        double across[2][3];
        sfi_base_across(&p->base, across);
        for (int j = 0; j < 2; j++) {
            p->a[i][j] = 0;
            for (int k = 0; k < 3; k++) {
                p->a[i][j] += p->h[i].normal[k] * across[j][k];
            }
        }
        p->b[i] = p->h[i].offset_mm;
        for (int k = 0; k < 3; k++) {
            p->b[i] -= p->h[i].normal[k] * p->com[k];
        }
    }
}

static void make(problem *p, size_t count, int around)
{
    for (int k = 0; k < 3; k++) {
        p->com[k] = 4 * test_random_unit() - 2;
    }
    for (size_t i = 0; i < count; i++) {
        double *n = p->h[i].normal, length = 0;
        double turn = 6.283185307179586 * (around ? (double)i / (double)count : test_random_unit());
        n[0] = cos(turn);
        n[1] = sin(turn);
        n[2] = -0.4 * test_random_unit();
        for (int k = 0; k < 3; k++) {
            length += n[k] * n[k];
        }
        for (int k = 0; k < 3; k++) {
            n[k] /= sqrt(length);
        }
        p->h[i].offset_mm = (around ? -1.5 : 1) * test_random_unit();
    }
    finish(p, count);
}

static double slack_at(const problem *p, const double x[2])
{
    double least = 1e300;
    for (size_t i = 0; i < p->base.count; i++) {
        least = fmin(least, p->a[i][0] * x[0] + p->a[i][1] * x[1] - p->b[i]);
    }
    return least;
}

static double length(const double x[2])
{
    return sqrt(x[0] * x[0] + x[1] * x[1]);
}

// Solve a 2 x 2 system; returns 0 where there is no one solution.
static int solve(const double a[2], double b, const double c[2], double d, double x[2])
{
    double det = a[0] * c[1] - a[1] * c[0];
    if (fabs(det) < 1e-9) {
        return 0;
    }
    x[0] = (b * c[1] - d * a[1]) / det;
    x[1] = (a[0] * d - c[0] * b) / det;
    return 1;
}

// Distance of the nearest place with a slack of at least `slack`, or 1e300: 0 itself, a foot on a
// border, or a corner of two borders.
static double nearest(const problem *p, double slack)
{
    double zero[2] = {0, 0}, best = slack_at(p, zero) >= slack - 1e-9 ? 0 : 1e300;
    for (size_t i = 0; i < p->base.count; i++) {
        double bi = p->b[i] + slack, x[2];
        double square = p->a[i][0] * p->a[i][0] + p->a[i][1] * p->a[i][1];
        x[0] = p->a[i][0] * bi / square;
        x[1] = p->a[i][1] * bi / square;
        if (slack_at(p, x) >= slack - 1e-9) {
            best = fmin(best, length(x));
        }
        for (size_t j = 0; j < i; j++) {
            if (solve(p->a[i], bi, p->a[j], p->b[j] + slack, x) && slack_at(p, x) >= slack - 1e-9) {
                best = fmin(best, length(x));
            }
        }
    }
    return best;
}

// The largest slack: of all places where three borders have the same, the one where it is largest
// and no border has less. (Half-planes from all around, so that it is bounded.)
static double largest(const problem *p)
{
    double best = -1e300;
    for (size_t i = 0; i < p->base.count; i++) {
        for (size_t j = 0; j < i; j++) {
            for (size_t k = 0; k < j; k++) {
                double u[2], v[2], x[2];
                for (int c = 0; c < 2; c++) {
                    u[c] = p->a[i][c] - p->a[j][c];
                    v[c] = p->a[j][c] - p->a[k][c];
                }
                if (solve(u, p->b[i] - p->b[j], v, p->b[j] - p->b[k], x)) {
                    best = fmax(best, slack_at(p, x));
                }
            }
        }
    }
    return best;
}

static void check_target(const problem *p, sfi_target which, double want_slack)
{
    static double scratch[200];
    CHECK(sfi_base_scratch(p->base.count) <= 200);
    sfi_offset to = sfi_base_target(&p->base, p->com, which, 100, scratch);
    CHECK(slack_at(p, to.along) >= want_slack - 1e-6);
    CHECK_NEAR(length(to.along), nearest(p, want_slack - 1e-7), 1e-5);
}

static void nearest_is_nearest(void)
{
    int outside = 0;
    for (int i = 0; i < 3000; i++) {
        problem p;
        make(&p, 1 + test_random_below(MOST), i % 2);
        double want = nearest(&p, 0), scratch[200];
        if (want < 50) {
            sfi_offset to = sfi_base_target(&p.base, p.com, SFI_TARGET_NEAREST, 1000, scratch);
            CHECK_NEAR(length(to.along), want, 1e-6 * (1 + want));
            CHECK(slack_at(&p, to.along) >= -1e-6);
            outside += want > 0;
        }
    }
    CHECK(outside > 1000);
}

// Also where nothing is safe, and then for whoever asks for the nearest place.
static void deepest_is_deepest(void)
{
    int impossible = 0;
    for (int i = 0; i < 2000; i++) {
        problem p;
        make(&p, 4 + test_random_below(MOST - 3), 1);
        for (size_t j = 0; i % 3 == 0 && j < p.base.count; j++) {
            p.h[j].offset_mm += 3; // the borders pass each other
        }
        finish(&p, p.base.count);
        double want = largest(&p);
        check_target(&p, SFI_TARGET_DEEPEST, want);
        if (want < -1e-6) {
            check_target(&p, SFI_TARGET_NEAREST, want);
            impossible++;
        }
    }
    CHECK(impossible > 300);
}

static void lines_and_points(void)
{
    problem p;
    double scratch[200];
    memset(&p, 0, sizeof p);
    p.h[0].normal[0] = 1;
    p.h[0].offset_mm = 2;
    p.h[1].normal[0] = -1;
    p.h[1].offset_mm = -2;
    finish(&p, 2); // x = 2
    CHECK_NEAR(length(sfi_base_target(&p.base, p.com, SFI_TARGET_NEAREST, 10, scratch).along), 2,
               1e-9);
    p.h[2].normal[1] = 1;
    p.h[2].offset_mm = 3;
    p.h[3].normal[1] = -1;
    p.h[3].offset_mm = -3;
    finish(&p, 4); // (2, 3)
    CHECK_NEAR(length(sfi_base_target(&p.base, p.com, SFI_TARGET_NEAREST, 10, scratch).along),
               sqrt(13), 1e-7);
    CHECK_NEAR(length(sfi_base_target(&p.base, p.com, SFI_TARGET_DEEPEST, 10, scratch).along),
               sqrt(13), 1e-7);
    p.h[0].normal[0] = 0;
    p.h[0].normal[2] = 1; // a height is nothing that moving across can mend
    finish(&p, 1);
    CHECK(length(sfi_base_target(&p.base, p.com, SFI_TARGET_NEAREST, 10, scratch).along) == 0);
    CHECK_NEAR(sfi_bases_slack(&p.base, 1, p.com), -2, 1e-12);
    p.base.count = 0;
    CHECK(length(sfi_base_target(&p.base, p.com, SFI_TARGET_NEAREST, 10, scratch).along) == 0);
    CHECK(sfi_bases_slack(&p.base, 1, p.com) == 0);
}

static void across_is_across(void)
{
    for (int i = 0; i < 300; i++) {
        double squared = 0, across[2][3];
        sfi_base base;
        memset(&base, 0, sizeof base);
        for (int k = 0; k < 3; k++) {
            base.up[k] = i < 6 ? (k == i / 2) * (i % 2 ? -1 : 1) : test_random_unit() - 0.5;
            squared += base.up[k] * base.up[k];
        }
        for (int k = 0; k < 3; k++) {
            base.up[k] /= sqrt(squared);
        }
        sfi_base_across(&base, across);
        double dots[3] = {0, 0, 0}, squares[2] = {0, 0};
        for (int k = 0; k < 3; k++) {
            dots[0] += base.up[k] * across[0][k];
            dots[1] += base.up[k] * across[1][k];
            dots[2] += across[0][k] * across[1][k];
            squares[0] += across[0][k] * across[0][k];
            squares[1] += across[1][k] * across[1][k];
        }
        CHECK(fabs(dots[0]) + fabs(dots[1]) + fabs(dots[2]) < 1e-14);
        CHECK(fabs(squares[0] - 1) + fabs(squares[1] - 1) < 1e-14);
    }
}

int main(void)
{
    TEST(nearest_is_nearest);
    TEST(deepest_is_deepest);
    TEST(lines_and_points);
    TEST(across_is_across);
    return test_finish();
}
