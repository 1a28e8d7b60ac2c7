// SPDX-License-Identifier: MIT
// Why: width * height * depth is where voxel libraries overflow (TRUST B1); the helpers must refuse
// exactly when the true result does not fit.

#include "base/size.h"
#include "test.h"

// The true product fits iff b == 0 or a <= SIZE_MAX / b, decided here by schoolbook halves instead.
static int product_fits(size_t a, size_t b)
{
    const size_t half = sizeof(size_t) * 4, mask = ((size_t)1 << half) - 1;
    size_t a1 = a >> half, a0 = a & mask, b1 = b >> half, b0 = b & mask;
    if (a1 != 0 && b1 != 0) {
        return 0;
    }
    size_t cross = a1 * b0 + a0 * b1; // one of the two terms is zero
    if (cross > mask) {
        return 0;
    }
    return a0 * b0 <= SIZE_MAX - (cross << half);
}

static void powers_of_two_and_their_neighbours(void)
{
    for (int i = 0; i < (int)(8 * sizeof(size_t)); i++) {
        for (int j = 0; j < (int)(8 * sizeof(size_t)); j++) {
            for (int d = 0; d < 9; d++) {
                size_t a = ((size_t)1 << i) + (size_t)(d / 3) - 1,
                       b = ((size_t)1 << j) + (size_t)(d % 3) - 1;
                size_t result = 12345;
                CHECK_EQ(sfi_size_mul(a, b, &result), product_fits(a, b));
                CHECK(result == (product_fits(a, b) ? a * b : 12345));
                result = 12345;
                CHECK_EQ(sfi_size_add(a, b, &result), a + b >= a);
                CHECK(result == (a + b >= a ? a + b : 12345));
            }
        }
    }
}

static void alignment_rounds_up_or_refuses(void)
{
    size_t result = 7;
    CHECK(sfi_size_align(0, 64, &result) && result == 0);
    CHECK(sfi_size_align(1, 64, &result) && result == 64);
    CHECK(sfi_size_align(64, 64, &result) && result == 64);
    CHECK(sfi_size_align(SIZE_MAX - 63, 64, &result) && result == SIZE_MAX - 63);
    CHECK(!sfi_size_align(SIZE_MAX - 62, 64, &result) && result == SIZE_MAX - 63);
}

int main(void)
{
    TEST(powers_of_two_and_their_neighbours);
    TEST(alignment_rounds_up_or_refuses);
    return test_finish();
}
