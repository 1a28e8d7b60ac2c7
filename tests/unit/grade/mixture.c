// SPDX-License-Identifier: MIT
// Why: a mixture decides what is printed for a set of wanted properties. Held against what does not
// look for simplices: linear properties must come back exactly, simplices must fill the space of
// fractions once (sum of determinants, points in one simplex only) and hold no other mixture in
// their circumscribed sphere, found mixtures must have what was wanted, and what cannot be had must
// be as near as the best of many thousand samples.

#include <sf/mixture.h>

#include "test.h"

enum { POINTS = 40, M = 4, P = 3 };

typedef struct measured {
    double fractions[POINTS * M], properties[POINTS * P];
    sf_mixture_samples samples;
} measured;

// The pure materials, then random mixtures; or all with fractions in steps.
static void fill(measured *t, size_t materials, size_t count, int steps)
{
    memset(t, 0, sizeof *t);
    t->samples.material_count = materials;
    t->samples.property_count = P;
    t->samples.fractions = t->fractions;
    t->samples.properties = t->properties;
    if (steps > 0) {
        count = 0;
        for (int a = 0; a <= steps; a++) {
            for (int b = 0; a + b <= steps; b++) {
                for (int c = 0; a + b + c <= steps; c++) {
                    int parts[4] = {a, b, c, steps - a - b - c};
                    if ((materials < 4 && c > 0) || (materials < 3 && b > 0)) {
                        continue;
                    }
                    for (size_t j = 0; j < materials; j++) {
                        int part = j + 1 == materials ? parts[3] : parts[j];
                        t->fractions[count * materials + j] = (double)part / steps;
                    }
                    count++;
                }
            }
        }
    } else {
        for (size_t i = 0; i < count; i++) {
            double sum = 0, apart = 1;
            for (size_t j = 0; j < materials; j++) {
                double *f = &t->fractions[i * materials + j];
                *f = i < materials ? i == j : -log(test_random_unit() + 1e-9);
                sum += *f;
            }
            for (size_t j = 0; j < materials; j++) {
                t->fractions[i * materials + j] /= sum;
            }
            for (size_t k = 0; k < i; k++) {
                double most = 0;
                for (size_t j = 0; j < materials; j++) {
                    most = fmax(most, fabs(t->fractions[i * materials + j] -
                                           t->fractions[k * materials + j]));
                }
                apart = fmin(apart, most);
            }
            i -= apart < 0.002; // once more
        }
    }
    t->samples.count = count;
}

static void give_properties(measured *t, const double of[M][P], double bend)
{
    for (size_t i = 0; i < t->samples.count; i++) {
        for (int p = 0; p < P; p++) {
            double sum = 0;
            for (size_t j = 0; j < t->samples.material_count; j++) {
                double f = t->fractions[i * t->samples.material_count + j];
                sum += f * of[j][p] + bend * f * f * of[(j + 1) % M][p];
            }
            t->properties[i * P + (size_t)p] = sum;
        }
    }
}

static sf_mixture *make(const measured *t)
{
    sf_mixture *mixture = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_mixture_create(&t->samples, NULL, &mixture, &fault);
    if (status != SF_OK) {
        printf("# %s\n", fault.message);
    }
    CHECK_EQ(status, SF_OK);
    return mixture;
}

static void random_fractions(double *f, size_t count)
{
    double sum = 0;
    for (size_t j = 0; j < count; j++) {
        f[j] = -log(test_random_unit() + 1e-12);
        sum += f[j];
    }
    for (size_t j = 0; j < count; j++) {
        f[j] /= sum;
    }
}

// Determinant of the rows of corners, by Laplace.
static double determinant(const measured *t, const uint32_t *corners, int n, const int *columns)
{
    double sum = 0;
    if (n == 0) {
        return 1;
    }
    for (int c = 0; c < n; c++) {
        int rest[M], used = 0;
        for (int k = 0; k < n; k++) {
            if (k != c) {
                rest[used++] = columns[k];
            }
        }
        double f = t->fractions[corners[0] * t->samples.material_count + (size_t)columns[c]];
        sum += (c % 2 ? -1 : 1) * f * determinant(t, corners + 1, n - 1, rest);
    }
    return sum;
}

static void simplices_fill_the_space(void)
{
    const int all[M] = {0, 1, 2, 3};
    for (int round = 0; round < 24; round++) {
        size_t materials = 2 + (size_t)(round % 3);
        measured t;
        fill(&t, materials, materials + test_random_below(22), round % 2 ? 1 + round % 4 : 0);
        sf_mixture *mixture = make(&t);
        double sum = 0;
        uint32_t corners[M];
        for (size_t i = 0; i < sf_mixture_simplex_count(mixture); i++) {
            CHECK_EQ(sf_mixture_simplex(mixture, i, corners), SF_OK);
            sum += fabs(determinant(&t, corners, (int)materials, all));
        }
        CHECK_NEAR(sum, 1, 1e-9); // that of the pure materials is 1
        sf_mixture_destroy(mixture);
    }
}

// Three materials: the circle through the corners of each triangle, by its centre, holds no point.
static void circles_are_empty(void)
{
    for (int round = 0; round < 20; round++) {
        measured t;
        fill(&t, 3, 30, 0);
        sf_mixture *mixture = make(&t);
        for (size_t i = 0; i < sf_mixture_simplex_count(mixture); i++) {
            uint32_t c[3];
            double p[3][3];
            CHECK_EQ(sf_mixture_simplex(mixture, i, c), SF_OK);
            for (int k = 0; k < 3; k++) {
                memcpy(p[k], t.fractions + c[k] * 3, sizeof p[k]);
            }
            // In the plane of sum 1 distances are those of space: weights a^2 (b^2 + c^2 - a^2).
            double side[3], weight[3], centre[3] = {0, 0, 0}, sum = 0, radius = 0;
            for (int k = 0; k < 3; k++) {
                side[k] = 0;
                for (int d = 0; d < 3; d++) {
                    side[k] += pow(p[(k + 1) % 3][d] - p[(k + 2) % 3][d], 2);
                }
            }
            for (int k = 0; k < 3; k++) {
                weight[k] = side[k] * (side[(k + 1) % 3] + side[(k + 2) % 3] - side[k]);
                sum += weight[k];
            }
            for (int d = 0; d < 3; d++) {
                for (int k = 0; k < 3; k++) {
                    centre[d] += weight[k] / sum * p[k][d];
                }
                radius += pow(p[0][d] - centre[d], 2);
            }
            for (size_t q = 0; q < t.samples.count; q++) {
                double away = 0;
                for (int d = 0; d < 3; d++) {
                    away += pow(t.fractions[q * 3 + (size_t)d] - centre[d], 2);
                }
                // Heights were raised by 1e-8.
                CHECK(away > radius - 1e-7 - 1e-6 * radius);
            }
        }
        sf_mixture_destroy(mixture);
    }
}

static const double pure[M][P] = {{1, 900, -3}, {5, 100, 2}, {2, 400, 8}, {9, 650, 1}};

static void linear_properties_are_exact(void)
{
    for (int round = 0; round < 30; round++) {
        size_t materials = 2 + (size_t)(round % 3);
        measured t;
        fill(&t, materials, materials + 10, round % 2 ? 3 : 0);
        give_properties(&t, pure, 0);
        sf_mixture *mixture = make(&t);
        for (int i = 0; i < 100; i++) {
            double f[M], got[P], miss, want[P] = {0, 0, 0}, back[M];
            random_fractions(f, materials);
            CHECK_EQ(sf_mixture_properties(mixture, f, got, &miss), SF_OK);
            CHECK(miss == 0);
            for (int p = 0; p < P; p++) {
                for (size_t j = 0; j < materials; j++) {
                    want[p] += f[j] * pure[j][p];
                }
                CHECK_NEAR(got[p], want[p], 1e-9 * 900);
            }
            // Three properties and up to four materials: there is one mixture that has them.
            CHECK_EQ(sf_mixture_fractions(mixture, want, NULL, back, got, &miss), SF_OK);
            CHECK_NEAR(miss, 0, 1e-9);
            for (size_t j = 0; j < materials; j++) {
                CHECK_NEAR(back[j], f[j], 1e-8);
            }
        }
        sf_mixture_destroy(mixture);
    }
}

static double scaled_distance(const double *a, const double *b, const double *scales)
{
    double sum = 0;
    for (int p = 0; p < P; p++) {
        sum += (a[p] - b[p]) / scales[p] * ((a[p] - b[p]) / scales[p]);
    }
    return sqrt(sum);
}

// Properties that bend, wanted ones anywhere: no sample of the mixtures comes nearer.
static void the_nearest_is_the_nearest(void)
{
    const double scales[P] = {2, 300, 1};
    double total = 0;
    for (int round = 0; round < 12; round++) {
        size_t materials = 2 + (size_t)(round % 3);
        measured t;
        fill(&t, materials, materials + 6, round % 2 ? 2 : 0);
        give_properties(&t, pure, 0.5);
        t.samples.scales = scales;
        sf_mixture *mixture = make(&t);
        for (int i = 0; i < 20; i++) {
            double wanted[P], f[M], got[P], again[P], miss, sum = 0, least = 1e9;
            for (int p = 0; p < P; p++) {
                wanted[p] = (20 * test_random_unit() - 5) * scales[p] / 2;
            }
            CHECK_EQ(sf_mixture_fractions(mixture, wanted, NULL, f, got, &miss), SF_OK);
            CHECK_NEAR(scaled_distance(got, wanted, scales), miss, 1e-9);
            for (size_t j = 0; j < materials; j++) {
                CHECK(f[j] >= 0);
                sum += f[j];
            }
            CHECK_NEAR(sum, 1, 1e-12);
            CHECK_EQ(sf_mixture_properties(mixture, f, again, NULL), SF_OK);
            CHECK_NEAR(scaled_distance(again, got, scales), 0, 1e-7);
            for (int k = 0; k < 3000; k++) {
                double other[M];
                random_fractions(other, materials);
                CHECK_EQ(sf_mixture_properties(mixture, other, again, NULL), SF_OK);
                least = fmin(least, scaled_distance(again, wanted, scales));
            }
            CHECK(miss <= least + 1e-9);
            total += least - miss;
        }
        sf_mixture_destroy(mixture);
    }
    printf("# the best of 3000 samples is off by %.4f more, on average\n", total / 240);
    CHECK(total / 240 < 0.1);
}

// One property and three materials: many mixtures have it. One is found, and the same with a hint.
static void a_choice_is_made(void)
{
    measured t;
    fill(&t, 3, 12, 0);
    give_properties(&t, pure, 0);
    for (size_t i = 0; i < 12; i++) {
        t.properties[i] = t.properties[i * P];
    }
    t.samples.property_count = 1;
    sf_mixture *mixture = make(&t);
    size_t hint = SIZE_MAX;
    for (int i = 0; i <= 100; i++) {
        double wanted = 1 + 0.04 * i, f[3], got, miss;
        CHECK_EQ(sf_mixture_fractions(mixture, &wanted, &hint, f, &got, &miss), SF_OK);
        CHECK(hint < sf_mixture_simplex_count(mixture));
        CHECK_NEAR(miss, 0, 1e-9);
        CHECK_NEAR(got, wanted, 1e-9);
        CHECK_NEAR(f[0] * 1 + f[1] * 5 + f[2] * 2, wanted, 1e-9);
    }
    sf_mixture_destroy(mixture);
}

int main(void)
{
    TEST(simplices_fill_the_space);
    TEST(circles_are_empty);
    TEST(linear_properties_are_exact);
    TEST(the_nearest_is_the_nearest);
    TEST(a_choice_is_made);
    return test_finish();
}
