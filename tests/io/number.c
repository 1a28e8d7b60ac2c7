// SPDX-License-Identifier: MIT
// Every coordinate of every text file passes through these few functions, so they are compared with
// the C library's (in the C locale), which is slow but right: nearest double for any text, and a
// text that reads back as the same double. Guards: the number parser of issue 2, part 4; TRUST B3
// (locale).

#include "io/number.h"

#include "test.h"

#include <float.h>
#include <inttypes.h>

static uint64_t bits_of(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

static int agree(const char *text)
{
    double ours = -1.0, theirs = strtod(text, NULL);
    int good = sfi_number_parse(text, &ours) && bits_of(ours) == bits_of(theirs);
    if (!good) {
        printf("# \"%s\": ours %a, strtod %a\n", text, ours, theirs);
    }
    return good;
}

static double any_double(void)
{
    double value;
    do {
        uint64_t bits = test_random();
        memcpy(&value, &bits, sizeof value);
    } while (!isfinite(value));
    return value;
}

// 1 to 40 digits, a point anywhere or nowhere, an exponent or none.
static void any_text(char *text)
{
    char *out = text;
    uint32_t digits = 1 + test_random_below(40), point = test_random_below(50);
    if (test_random_below(2)) {
        *out++ = test_random_below(2) ? '-' : '+';
    }
    for (uint32_t i = 0; i < digits; i++) {
        if (i == point) {
            *out++ = '.';
        }
        *out++ = (char)('0' + test_random_below(10));
    }
    if (test_random_below(3) == 0) {
        out += sprintf(out, "%c%d", test_random_below(2) ? 'e' : 'E',
                       (int)test_random_below(700) - 350);
    }
    *out = '\0';
}

static void reads_like_strtod(void)
{
    char text[128];
    for (int i = 0; i < 100000; i++) {
        any_text(text);
        CHECK(agree(text));
    }
    for (int i = 0; i < 50000; i++) {
        double value = i % 2 ? any_double() : (test_random_unit() - 0.5) * 400.0;
        snprintf(text, sizeof text, "%.*g", 1 + (int)test_random_below(20), value);
        CHECK(agree(text));
    }
}

// A decimal that stands exactly half-way between two doubles, and its neighbours in the last place.
static void reads_ties(void)
{
    static char text[1200];
    for (int i = 0; i < 3000; i++) {
        int exponent = (int)test_random_below(160) - 60;
        uint64_t odd = (UINT64_C(1) << 53) | (test_random() >> 11) | 1; // 54 bits, so a tie
        long double tie = ldexpl((long double)odd, exponent);
        int length = snprintf(text, sizeof text, "%.*Lf", exponent < 0 ? -exponent : 1, tie);
        CHECK(agree(text));
        text[length - 1]++; // a little above
        CHECK(agree(text));
        strcat(text, "00000000000000000000000000000000000000001");
        CHECK(agree(text));
    }
}

static void reads_hard_cases(void)
{
    static const char *const hard[] = {
        "0",
        "-0",
        "0.0e-999999999999",
        "1e999999999999999999999",
        "1e-999999999999999999999",
        "2.2250738585072011e-308",
        "2.2250738585072012e-308",
        "2.2250738585072014e-308",
        "4.9406564584124654e-324",
        "2.4703282292062327e-324",
        "2.4703282292062328e-324",
        "1.7976931348623157e308",
        "1.7976931348623158e308",
        "1.7976931348623159e308",
        "9007199254740991",
        "9007199254740992",
        "9007199254740993",
        "9007199254740993.00000000000000000000000000000000001",
        "9007199254740995",
        "18446744073709551615",
        "18446744073709551616",
        "9999999999999999999e19",
        "9999999999999999999e-19",
        "1e23",
        "8.5e22",
        "123456789012345678901234567890",
        ".5",
        "5.",
        "00000000000000000000000000000000000000000000000000000000001.5",
        "0.000000000000000000000000000000000000000000000000000000000015",
        "6.631236846766476e-316",
        "3.237883913302901e-319",
    };
    for (size_t i = 0; i < sizeof hard / sizeof hard[0]; i++) {
        CHECK(agree(hard[i]));
    }
    static char text[5000];
    memset(text, '7', 3000);
    strcpy(text + 3000, "e-2990");
    CHECK(agree(text));
    memcpy(text, "0.", 2);
    memset(text + 2, '0', 2000);
    strcpy(text + 2002, "123e2002");
    CHECK(agree(text));
    for (int digits = 760; digits < 830; digits++) { // around what is kept of a long number
        memset(text, '0', 4000);
        memcpy(text, "9007199254740993", 16); // a tie, if nothing follows
        text[16] = '.';
        text[digits] = '1';
        text[digits + 1] = '\0';
        CHECK(agree(text));
    }
}

static void refuses_what_is_no_number(void)
{
    static const char *const wrong[] = {"",      "-",       "+",     ".",      "e5",   "1e",
                                        "1e+",   "--1",     "1.2.3", "1,5",    "0x10", "1f",
                                        "1 ",    "infinit", "nanx",  "1e5.5",  "in",   "+-1",
                                        "1e--5", "1_0",     "1d5",   "NaN(1)", "½"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        double value = 42.0;
        CHECK(!sfi_number_parse(wrong[i], &value));
        CHECK(value == 42.0);
    }
    double value;
    CHECK(sfi_number_parse("-Inf", &value) && isinf(value) && value < 0);
    CHECK(sfi_number_parse("INFINITY", &value) && isinf(value));
    CHECK(sfi_number_parse("-nan", &value) && isnan(value));
}

static void reads_whole_numbers(void)
{
    int64_t value = 0;
    CHECK(sfi_integer_parse("9223372036854775807", &value) && value == INT64_MAX);
    CHECK(sfi_integer_parse("-9223372036854775807", &value) && value == -INT64_MAX);
    CHECK(sfi_integer_parse("+007", &value) && value == 7);
    static const char *const wrong[] = {
        "9223372036854775808", "", "-", "1.0", "1e3", " 1", "1 ", "0x1"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        CHECK(!sfi_integer_parse(wrong[i], &value));
    }
}

// What is written reads back, is no longer than printf's shortest %g, and is %.15g where that will
// do.
static int written_well(double value)
{
    char ours[SFI_NUMBER_SIZE], theirs[64];
    size_t length = sfi_number_format(value, ours);
    int good = length == strlen(ours) && length < SFI_NUMBER_SIZE && strtod(ours, NULL) == value;
    for (int digits = 15; good && digits <= 17; digits++) {
        snprintf(theirs, sizeof theirs, "%.*e", digits - 1, value);
        if (strtod(theirs, NULL) == value) {
            // the same digits, wherever the point stands
            char a[64] = "", b[64] = "";
            size_t na = 0, nb = 0;
            for (const char *c = ours; *c && *c != 'e'; c++) {
                if (*c >= '0' && *c <= '9' && (na > 0 || *c != '0')) {
                    a[na++] = *c;
                }
            }
            for (const char *c = theirs; *c && *c != 'e'; c++) {
                if (*c >= '0' && *c <= '9' && (nb > 0 || *c != '0')) {
                    b[nb++] = *c;
                }
            }
            for (; na > 0 && a[na - 1] == '0'; na--) {
            }
            for (; nb > 0 && b[nb - 1] == '0'; nb--) {
            }
            // printf rounds exact ties to even, we round them up: then only the last digit differs
            good = na == nb && memcmp(a, b, na > 0 ? na - 1 : 0) == 0;
            break;
        }
    }
    if (!good) {
        printf("# wrote \"%s\" for %.17g\n", ours, value);
    }
    return good;
}

static void writes_what_reads_back(void)
{
    for (int i = 0; i < 10000; i++) {
        CHECK(written_well(any_double()));
    }
    for (int i = 0; i < 30000; i++) {
        double size = ldexp(1.0, (int)test_random_below(80) - 40);
        CHECK(written_well((test_random_unit() - 0.5) * size));
    }
    for (int i = 0; i < 20000; i++) { // what files hold: tenths, hundredths, floats
        CHECK(written_well((double)i / 1000.0));
        CHECK(written_well((double)(float)((float)i * 0.05f)));
        CHECK(written_well(i * 0.1));
    }
    static const double hard[] = {DBL_MAX,
                                  DBL_MIN,
                                  4.9406564584124654e-324,
                                  1e23,
                                  9.5e-3,
                                  1e15,
                                  1e16,
                                  1e17,
                                  1e18,
                                  0.001,
                                  0.01,
                                  0.1,
                                  0.00001,
                                  123456,
                                  1.0,
                                  9.999999999999999e22,
                                  9007199254740993.0,
                                  0.3};
    for (size_t i = 0; i < sizeof hard / sizeof hard[0]; i++) {
        CHECK(written_well(hard[i]));
        CHECK(written_well(-hard[i]));
    }
    for (int power = -320; power <= 308; power++) {
        char text[16];
        snprintf(text, sizeof text, "1e%d", power);
        double value = strtod(text, NULL);
        CHECK(written_well(value));
        CHECK(written_well(nextafter(value, 0.0)));
        CHECK(written_well(nextafter(value, DBL_MAX)));
    }
}

static void writes_plainly(void)
{
    static const struct {
        double value;
        const char *text;
    } known[] = {{0.0, "0"},
                 {-0.0, "0"},
                 {1.0, "1"},
                 {-0.05, "-0.05"},
                 {100.0, "100"},
                 {0.001, "0.001"},
                 {12345.678, "12345.678"},
                 {1e20, "1e+20"},
                 {1.5e-7, "1.5e-07"},
                 {-2.5e120, "-2.5e+120"},
                 {1.0 / 3.0, "0.3333333333333333"}};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        char text[SFI_NUMBER_SIZE];
        sfi_number_format(known[i].value, text);
        CHECK_STR(text, known[i].text);
    }
}

int main(void)
{
    TEST(reads_like_strtod);
    TEST(reads_ties);
    TEST(reads_hard_cases);
    TEST(refuses_what_is_no_number);
    TEST(reads_whole_numbers);
    TEST(writes_what_reads_back);
    TEST(writes_plainly);
    return test_finish();
}
