// SPDX-License-Identifier: MIT
// Why: what is left out of a stance's half-spaces must be implied by what stays, or a body that
// falls is called safe; and what stays must be needed, or solvers drown in it. Held against points
// all over the cube, and against the corners of what stays, found from all triples of planes.

#include "balance/stance/reduce.h"
#include "base/memory.h"
#include "failing_allocator.h"
#include "turn.h"

enum { MOST = 700 };

static double value(const sf_halfspace *h, const double p[3])
{
    return dot3(h->normal, p) - h->offset_mm;
}

static int is_inside(const sf_halfspace *list, size_t count, const double p[3], double slack)
{
    for (size_t i = 0; i < count; i++) {
        if (value(&list[i], p) < slack) {
            return 0;
        }
    }
    return 1;
}

static int same(const sf_halfspace *a, const sf_halfspace *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

// Planes around a ball that is squeezed, so that some are far out; some twice.
static void make(sf_halfspace *list, size_t count, const double middle[3])
{
    for (size_t i = 0; i < count; i++) {
        double n[3];
        random_direction(n);
        n[2] *= 0.3;
        double length = sqrt(dot3(n, n));
        for (int d = 0; d < 3; d++) {
            list[i].normal[d] = n[d] / length;
        }
        list[i].offset_mm =
            dot3(list[i].normal, middle) - 4 - (i % 3 ? 8 : 0.5) * test_random_unit();
        if (i > 0 && i % 7 == 0) {
            list[i] = list[i - 1];
        }
    }
}

static void what_is_left_out_is_implied(void)
{
    static sf_halfspace all[MOST], kept[MOST];
    sf_allocator libc = sfi_allocator_or_default(NULL);
    const double middle[3] = {30, -10, 5};
    size_t out = 0;
    for (int i = 0; i < 60; i++) {
        size_t count = i < 50 ? 1 + test_random_below(60) : 200 + test_random_below(500), stay = 0;
        make(all, count, middle);
        memcpy(kept, all, count * sizeof *all);
        CHECK_EQ(sfi_halfspaces_reduce(kept, count, middle, 20, &libc, &stay), SF_OK);
        CHECK(stay >= 1 && stay <= count);
        out += count - stay;
        size_t at = 0; // what stays is in its order
        for (size_t k = 0; k < stay; k++) {
            while (at < count && !same(&all[at], &kept[k])) {
                at++;
            }
            CHECK(at++ < count);
            CHECK(k == 0 || !same(&kept[k], &kept[k - 1]));
        }
        for (int k = 0; k < 3000; k++) {
            double p[3];
            for (int d = 0; d < 3; d++) {
                p[d] = middle[d] + (k % 2 ? 40 : 16) * (test_random_unit() - 0.5);
            }
            CHECK_EQ(is_inside(kept, stay, p, 0), is_inside(all, count, p, 0));
        }
    }
    CHECK(out > 1000);
}

// Where three planes meet; returns 0 where they do not.
static int meet(const sf_halfspace *a, const sf_halfspace *b, const sf_halfspace *c, double p[3])
{
    const double *u = a->normal, *v = b->normal, *w = c->normal;
    double vw[3], wu[3], uv[3];
    for (int d = 0; d < 3; d++) {
        int e = (d + 1) % 3, f = (d + 2) % 3;
        vw[d] = v[e] * w[f] - v[f] * w[e];
        wu[d] = w[e] * u[f] - w[f] * u[e];
        uv[d] = u[e] * v[f] - u[f] * v[e];
    }
    double det = dot3(u, vw);
    for (int d = 0; d < 3 && fabs(det) > 1e-9; d++) {
        p[d] = (a->offset_mm * vw[d] + b->offset_mm * wu[d] + c->offset_mm * uv[d]) / det;
    }
    return fabs(det) > 1e-9;
}

// Without one of those that stay, there is a corner that it cuts off.
static void what_stays_is_needed(void)
{
    static sf_halfspace list[MOST];
    sf_allocator libc = sfi_allocator_or_default(NULL);
    const double middle[3] = {30, -10, 5};
    for (int i = 0; i < 40; i++) {
        size_t count = 4 + test_random_below(16), stay = 0;
        make(list, count, middle);
        CHECK_EQ(sfi_halfspaces_reduce(list, count, middle, 20, &libc, &stay), SF_OK);
        for (int d = 0; d < 6; d++) { // the cube
            sf_halfspace side = {{0, 0, 0}, -20};
            side.normal[d / 2] = d % 2 ? -1 : 1;
            side.offset_mm += dot3(side.normal, middle);
            list[stay + (size_t)d] = side;
        }
        size_t planes = stay + 6;
        for (size_t k = 0; k < stay; k++) {
            double least = INFINITY;
            sf_halfspace asked = list[k];
            list[k] = list[stay + 5]; // twice, then
            for (size_t a = 0; a < planes; a++) {
                for (size_t b = a + 1; b < planes; b++) {
                    for (size_t c = b + 1; c < planes; c++) {
                        double p[3] = {0, 0, 0};
                        if (meet(&list[a], &list[b], &list[c], p) &&
                            is_inside(list, planes, p, -1e-9)) {
                            least = fmin(least, value(&asked, p));
                        }
                    }
                }
            }
            list[k] = asked;
            CHECK(least < 2e-8);
        }
    }
}

static void nothing_is_in_all(void)
{
    sf_halfspace list[] = {{{1, 0, 0}, 5}, {{-1, 0, 0}, 5}, {{0, 1, 0}, -30}, {{0, 0, 1}, 0}};
    sf_allocator libc = sfi_allocator_or_default(NULL);
    const double middle[3] = {0, 0, 0};
    size_t stay = 0;
    CHECK_EQ(sfi_halfspaces_reduce(list, 4, middle, 20, &libc, &stay), SF_OK);
    int left = 0, right = 0;
    for (size_t i = 0; i < stay; i++) {
        left += list[i].normal[0] < 0;
        right += list[i].normal[0] > 0;
    }
    CHECK(left == 1 && right == 1);
}

static void memory_that_ends(void)
{
    static sf_halfspace list[MOST], before[MOST];
    const double middle[3] = {0, 0, 0};
    sf_status status = SF_ERR_MEMORY;
    failing_allocator f;
    size_t stay = 77;
    make(list, 100, middle);
    memcpy(before, list, sizeof before);
    for (long k = 0; status == SF_ERR_MEMORY && k < 100; k++) {
        CHECK(memcmp(before, list, sizeof before) == 0 && stay == 77);
        failing_begin(&f, k);
        status = sfi_halfspaces_reduce(list, 100, middle, 20, &f.allocator, &stay);
        CHECK(f.live == 0 && f.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
}

int main(void)
{
    TEST(what_is_left_out_is_implied);
    TEST(what_stays_is_needed);
    TEST(nothing_is_in_all);
    TEST(memory_that_ends);
    return test_finish();
}
