// SPDX-License-Identifier: MIT
// Why: a rule made from an angle must be the same integers on every machine (promise P4), so the
// library has its own tangent, inverse tangent and exponential. Held here against the C library's,
// whose error is below one ulp, over the whole domain, and against values that must come out
// exactly.

#include "base/math.h"
#include "test.h"

// |a - b| in units of the last place of b.
static double ulps(double a, double b)
{
    int exponent;
    frexp(b, &exponent);
    return fabs(a - b) / ldexp(1.0, exponent - 53);
}

static void tangent_is_within_two_ulp(void)
{
    double worst = 0.0;
    for (int i = 0; i < 200000; i++) {
        double x = test_random_unit() * 1.5707;
        double error = ulps(sfi_tan(x), tan(x));
        worst = error > worst ? error : worst;
    }
    for (int i = 1; i < 900; i++) {
        double x = i * 0.1 * 3.14159265358979323846 / 180.0;
        double error = ulps(sfi_tan(x), tan(x));
        worst = error > worst ? error : worst;
    }
    printf("# tan: at most %.2f units in the last place from the C library's\n", worst);
    CHECK(worst <= 2.0);
}

static void inverse_tangent_is_within_two_ulp(void)
{
    double worst = 0.0;
    for (int i = 0; i < 200000; i++) {
        double x = ldexp(test_random_unit(), (int)test_random_below(40) - 20);
        double error = ulps(sfi_atan(x), atan(x));
        worst = error > worst ? error : worst;
    }
    printf("# atan: at most %.2f units in the last place from the C library's\n", worst);
    CHECK(worst <= 2.0);
}

static void exponential_is_within_two_ulp(void)
{
    double worst = 0.0;
    for (int i = 0; i < 200000; i++) {
        double x = test_random_unit() * 1400.0 - 700.0;
        double error = ulps(sfi_exp(x), exp(x));
        worst = error > worst ? error : worst;
    }
    for (int i = 0; i < 200000; i++) {
        double x = ldexp(test_random_unit() - 0.5, -(int)test_random_below(30));
        double error = ulps(sfi_exp(x), exp(x));
        worst = error > worst ? error : worst;
    }
    printf("# exp: at most %.2f units in the last place from the C library's\n", worst);
    CHECK(worst <= 2.0);
    double nan = sfi_tan(2.0);
    CHECK(sfi_exp(0.0) == 1.0 && sfi_exp(-0.0) == 1.0);
    CHECK(sfi_exp(HUGE_VAL) == HUGE_VAL && sfi_exp(-HUGE_VAL) == 0.0 && sfi_exp(800.0) == HUGE_VAL);
    CHECK(sfi_exp(-745.0) == exp(-745.0) && sfi_exp(-800.0) == 0.0);
    CHECK(sfi_exp(nan) != sfi_exp(nan));
}

static void odd_and_known(void)
{
    double quarter = 0.78539816339744830962;
    CHECK(sfi_tan(0.0) == 0.0);
    CHECK(sfi_atan(0.0) == 0.0);
    CHECK(sfi_atan(1.0) == quarter);
    CHECK_NEAR(sfi_tan(quarter), 1.0, 2e-16);
    CHECK_NEAR(sfi_atan(HUGE_VAL), 1.57079632679489661923, 0.0);
    for (int i = 0; i < 1000; i++) {
        double x = test_random_unit() * 1.57;
        CHECK(sfi_tan(-x) == -sfi_tan(x));
        CHECK(sfi_atan(-x) == -sfi_atan(x));
    }
}

static void outside_the_domain_is_no_number(void)
{
    double nan = sfi_tan(2.0);
    CHECK(nan != nan);
    CHECK(sfi_tan(nan) != sfi_tan(nan));
    CHECK(sfi_atan(nan) != sfi_atan(nan));
    CHECK(sfi_tan(-1.5707963267948966) != sfi_tan(-1.5707963267948966));
}

// The bytes themselves: a machine or compiler that rounds differently fails here.
static void bytes_are_pinned(void)
{
    uint64_t hash = 14695981039346656037u;
    for (int i = 0; i < 4000; i++) {
        double values[2] = {sfi_tan(i * 0x1p-12 * 1.5), sfi_atan(i * 0x1p-6)};
        for (int j = 0; j < 2; j++) {
            uint64_t bits;
            memcpy(&bits, &values[j], sizeof bits);
            hash = (hash ^ bits) * 1099511628211u;
        }
    }
    printf("# hash %016llx\n", (unsigned long long)hash);
    CHECK(hash == 0x88ebc3240e4617a2u);
}

int main(void)
{
    TEST(tangent_is_within_two_ulp);
    TEST(inverse_tangent_is_within_two_ulp);
    TEST(exponential_is_within_two_ulp);
    TEST(odd_and_known);
    TEST(outside_the_domain_is_no_number);
    TEST(bytes_are_pinned);
    return test_finish();
}
