// SPDX-License-Identifier: MIT
// Why: what a body can rest on is its convex hull, and models are full of points in one plane, in
// one line and in one place. Hulls are held against the definition: a face is a plane through three
// points with all others on one side, a corner is where three of these meet. Large ones are held
// against Euler and against every point.

#include "mesh/hull.h"
#include "base/memory.h"
#include "failing_allocator.h"
#include "test.h"

enum { POINTS = 28, PLANES = 512 };

// ---------------------------------------------------------------------------------------------
// By definition
// ---------------------------------------------------------------------------------------------

typedef struct oracle {
    int count;           // planes that bound the points
    uint32_t on[PLANES]; // which points lie in each, one bit each
} oracle;

static long long side(const double *a, const double *b, const double *c, const double *p)
{
    long long u[3], v[3], w[3], n[3];
    for (int d = 0; d < 3; d++) {
        u[d] = (long long)(b[d] - a[d]);
        v[d] = (long long)(c[d] - a[d]);
        w[d] = (long long)(p[d] - a[d]);
    }
    for (int d = 0; d < 3; d++) {
        n[d] = u[(d + 1) % 3] * v[(d + 2) % 3] - u[(d + 2) % 3] * v[(d + 1) % 3];
    }
    return n[0] * w[0] + n[1] * w[1] + n[2] * w[2];
}

static int in_line(const double *a, const double *b, const double *c)
{
    double zero = 0;
    for (int d = 0; d < 3; d++) {
        int e = (d + 1) % 3;
        zero += fabs((b[d] - a[d]) * (c[e] - a[e]) - (b[e] - a[e]) * (c[d] - a[d]));
    }
    return zero == 0;
}

static void find_planes(const double *p, int n, oracle *o)
{
    o->count = 0;
    for (int a = 0; a < n; a++) {
        for (int b = a + 1; b < n; b++) {
            for (int c = b + 1; c < n; c++) {
                uint32_t on = 0;
                int above = 0, below = 0, known = 0;
                for (int i = 0; i < n; i++) {
                    long long s = side(p + 3 * a, p + 3 * b, p + 3 * c, p + 3 * i);
                    on |= s == 0 ? 1u << i : 0;
                    above += s > 0;
                    below += s < 0;
                }
                if ((above > 0 && below > 0) || in_line(p + 3 * a, p + 3 * b, p + 3 * c)) {
                    continue;
                }
                for (int i = 0; i < o->count; i++) {
                    known = known || o->on[i] == on;
                }
                if (!known) {
                    o->on[o->count++] = on;
                }
            }
        }
    }
}

// ---------------------------------------------------------------------------------------------
// What every hull is
// ---------------------------------------------------------------------------------------------

// Whether edge a to b of a face is edge b to a of the one across.
static int is_matched(const sfi_hull *h, uint32_t face, uint32_t a, uint32_t b, uint32_t across)
{
    int found = 0;
    for (size_t i = h->starts[across]; i < h->starts[across + 1]; i++) {
        size_t next = i + 1 < h->starts[across + 1] ? i + 1 : h->starts[across];
        found += h->loops[i] == b && h->loops[next] == a && h->across[i] == face;
    }
    return found == 1;
}

// Euler's formula, edges in pairs, and no point further outside of a face than `slack` of its size.
static void check_solid(const sfi_hull *h, const double *p, size_t n, double slack)
{
    size_t edges = h->starts[h->face_count];
    CHECK_EQ(h->corner_count + h->face_count, edges / 2 + 2);
    for (uint32_t f = 0; f < h->face_count; f++) {
        size_t first = h->starts[f], count = h->starts[f + 1] - first;
        const double *o = p + 3 * (size_t)h->corners[h->loops[first]];
        double normal[3] = {0, 0, 0};
        CHECK(count >= 3);
        for (size_t i = 0; i < count; i++) {
            uint32_t a = h->loops[first + i], b = h->loops[first + (i + 1) % count];
            const double *q = p + 3 * (size_t)h->corners[a], *r = p + 3 * (size_t)h->corners[b];
            CHECK(is_matched(h, f, a, b, h->across[first + i]));
            for (int d = 0; d < 3; d++) {
                int e = (d + 1) % 3, g = (d + 2) % 3;
                normal[d] += (q[e] - o[e]) * (r[g] - o[g]) - (q[g] - o[g]) * (r[e] - o[e]);
            }
        }
        double size = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        for (size_t i = 0; i < n && (n < 3000 || f % 50 == 0); i++) {
            double out = 0;
            for (int d = 0; d < 3; d++) {
                out += normal[d] / size * (p[3 * i + (size_t)d] - o[d]);
            }
            CHECK(out <= slack);
        }
    }
}

static int is_same_place(const double *p, const double *q)
{
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

// ---------------------------------------------------------------------------------------------
// Small ones
// ---------------------------------------------------------------------------------------------

static void compare(const double *p, int n)
{
    static oracle o;
    sf_allocator libc = sfi_allocator_or_default(NULL);
    sfi_hull h;
    find_planes(p, n, &o);
    CHECK_EQ(sfi_hull_create(p, (size_t)n, &libc, &h), SF_OK);
    int is_solid = o.count > 1;
    CHECK_EQ(h.dimension == 3, is_solid);
    CHECK_EQ(h.face_count, is_solid ? o.count : o.count == 1 ? 2 : 0);
    if (is_solid) {
        check_solid(&h, p, (size_t)n, 1e-9);
    }
    for (int i = 0; i < n && is_solid; i++) {
        int planes = 0, found = 0;
        for (int f = 0; f < o.count; f++) {
            planes += (int)(o.on[f] >> i & 1);
        }
        for (size_t c = 0; c < h.corner_count; c++) {
            found += is_same_place(p + 3 * i, p + 3 * (size_t)h.corners[c]);
        }
        CHECK_EQ(found, planes >= 3);
    }
    for (size_t f = 0; f < h.face_count && is_solid; f++) {
        uint32_t corners = 0;
        int known = 0;
        for (size_t i = h.starts[f]; i < h.starts[f + 1]; i++) {
            corners |= 1u << h.corners[h.loops[i]];
        }
        for (int i = 0; i < o.count; i++) {
            known += (o.on[i] & corners) == corners;
        }
        CHECK_EQ(known, 1);
    }
    sfi_hull_destroy(&h, &libc);
}

static void small_sets(void)
{
    double p[3 * POINTS];
    for (int i = 0; i < 4000; i++) {
        int n = 1 + (int)test_random_below(i % 40 == 0 ? POINTS : 14);
        uint32_t size = i % 4 == 0 ? 2 : i % 4 == 1 ? 4 : i % 4 == 2 ? 9 : 100000;
        for (int j = 0; j < n; j++) {
            for (int d = 0; d < 3; d++) {
                p[3 * j + d] = (double)test_random_below(size) - 7;
            }
            if (i % 11 == 0) {
                p[3 * j + 2] = p[3 * j] - 2 * p[3 * j + 1]; // all in one plane
            }
            if (i % 33 == 0) {
                p[3 * j + 1] = 3 * p[3 * j]; // all on one line
                p[3 * j + 2] = -p[3 * j];
            }
        }
        compare(p, n);
    }
}

static void fewer_dimensions(void)
{
    static const struct {
        double p[3 * 6];
        size_t count;
        int dimension;
        size_t corners;
    } cases[] = {
        {{5, 5, 5}, 1, 0, 1},
        {{5, 5, 5, 5, 5, 5}, 2, 0, 1},
        {{5, 5, 5, 5, 5, 6, 5, 5, 7, 5, 5, 5}, 4, 1, 2},
        {{0, 0, 0, 1, 2, 3, 2, 4, 6, -1, -2, -3}, 4, 1, 2},
        {{0, 0, 0, 4, 0, 4, 4, 4, 8, 0, 4, 4, 2, 2, 4, 2, 0, 2}, 6, 2, 4},
        {{0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0.5, 0.5}, 6, 2, 4},
    };
    sf_allocator libc = sfi_allocator_or_default(NULL);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        sfi_hull h;
        CHECK_EQ(sfi_hull_create(cases[i].p, cases[i].count, &libc, &h), SF_OK);
        CHECK_EQ(h.dimension, cases[i].dimension);
        CHECK_EQ(h.corner_count, cases[i].corners);
        CHECK_EQ(h.face_count, h.dimension == 2 ? 2 : 0);
        for (uint32_t f = 0; f < h.face_count; f++) {
            for (size_t c = h.starts[f]; c < h.starts[f + 1]; c++) {
                size_t next = c + 1 < h.starts[f + 1] ? c + 1 : h.starts[f];
                CHECK(is_matched(&h, f, h.loops[c], h.loops[next], h.across[c]));
            }
        }
        sfi_hull_destroy(&h, &libc);
    }
}

// ---------------------------------------------------------------------------------------------
// Large ones
// ---------------------------------------------------------------------------------------------

static void check_large(const double *p, size_t n, size_t corners, size_t faces, double slack)
{
    sf_allocator libc = sfi_allocator_or_default(NULL);
    sfi_hull h;
    CHECK_EQ(sfi_hull_create(p, n, &libc, &h), SF_OK);
    CHECK_EQ(h.dimension, 3);
    if (corners > 0) {
        CHECK_EQ(h.corner_count, corners);
        CHECK_EQ(h.face_count, faces);
    }
    check_solid(&h, p, n, slack);
    sfi_hull_destroy(&h, &libc);
}

// Points on a lattice, on a sphere, on a cone's rims, and the same turned, so that what was one
// plane is one but for rounding.
static void large_sets(void)
{
    static double p[3 * 20000];
    const double pi = 3.14159265358979323846;
    size_t n = 0;
    for (int x = 0; x < 20; x++) {
        for (int y = 0; y < 20; y++) {
            for (int z = 0; z < 20; z++, n++) {
                p[3 * n] = x;
                p[3 * n + 1] = y * 0.5 - 3;
                p[3 * n + 2] = z * 3 + 1000;
            }
        }
    }
    check_large(p, n, 8, 6, 1e-9);
    for (size_t i = 0; i < n; i++) {
        double x = p[3 * i], y = p[3 * i + 1];
        p[3 * i] = 0.6 * x - 0.8 * y;
        p[3 * i + 1] = 0.8 * x + 0.6 * y;
    }
    check_large(p, n, 0, 0, 1e-9);
    for (n = 0; n < 20000; n++) {
        double z = 2 * test_random_unit() - 1, t = 2 * pi * test_random_unit();
        p[3 * n] = sqrt(1 - z * z) * cos(t);
        p[3 * n + 1] = sqrt(1 - z * z) * sin(t);
        p[3 * n + 2] = z;
    }
    check_large(p, n, 20000, 2 * 20000 - 4, 1e-11);
    for (n = 0; n < 4000; n++) {
        double t = 2 * pi * (double)(n % 400) / 400, r = 1 + (double)(n / 400);
        p[3 * n] = r * cos(t);
        p[3 * n + 1] = r * sin(t);
        p[3 * n + 2] = 3 - 2 * r;
    }
    check_large(p, n, 0, 0, 1e-10);
    for (n = 0; n < 20000; n++) { // all inside of a simplex but for its corners
        double a = test_random_unit(), b = test_random_unit(), c = test_random_unit();
        double sum = 1 + a + b + c;
        p[3 * n] = n < 4 ? 3 * (n == 1) : 3 * a / sum;
        p[3 * n + 1] = n < 4 ? 3 * (n == 2) : 3 * b / sum;
        p[3 * n + 2] = n < 4 ? 3 * (n == 3) : 3 * c / sum;
    }
    check_large(p, n, 4, 4, 1e-9);
}

// The sizes of things do not matter, nor where they are.
static void scales_and_shifts(void)
{
    double p[3 * 8], q[3 * 8];
    static const double scales[] = {1e-90, 1e-12, 1, 1e11};
    for (int i = 0; i < 24; i++) {
        p[i] = (double)test_random_below(1000);
    }
    sf_allocator libc = sfi_allocator_or_default(NULL);
    sfi_hull h, other;
    CHECK_EQ(sfi_hull_create(p, 8, &libc, &h), SF_OK);
    for (size_t s = 0; s < sizeof scales / sizeof scales[0]; s++) {
        for (int i = 0; i < 24; i++) {
            q[i] = (p[i] - 500) * scales[s];
        }
        CHECK_EQ(sfi_hull_create(q, 8, &libc, &other), SF_OK);
        CHECK_EQ(other.corner_count, h.corner_count);
        CHECK_EQ(other.face_count, h.face_count);
        sfi_hull_destroy(&other, &libc);
    }
    sfi_hull_destroy(&h, &libc);
}

static void memory_that_ends(void)
{
    static double p[3 * 400];
    for (int flat = 0; flat < 3; flat++) {
        for (int i = 0; i < 1200; i++) {
            p[i] = i % 3 < 3 - flat ? test_random_unit() : 0;
        }
        sf_status status = SF_ERR_MEMORY;
        failing_allocator f;
        sfi_hull h;
        memset(&h, 0x5a, sizeof h);
        sfi_hull before = h;
        for (long k = 0; status == SF_ERR_MEMORY && k < 1000; k++) {
            CHECK(memcmp(&h, &before, sizeof h) == 0);
            failing_begin(&f, k);
            status = sfi_hull_create(p, 400, &f.allocator, &h);
            CHECK(status == SF_OK || (f.live == 0 && f.faults == 0));
        }
        CHECK_EQ(status, SF_OK);
        CHECK(f.requests >= 3);
        sfi_hull_destroy(&h, &f.allocator);
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
}

int main(void)
{
    TEST(small_sets);
    TEST(fewer_dimensions);
    TEST(large_sets);
    TEST(scales_and_shifts);
    TEST(memory_that_ends);
    return test_finish();
}
