// SPDX-License-Identifier: MIT
// Why: a part that falls over does not print. The margin of standing is held against every line
// through two corners that has all others on one side, and against boxes whose angle is known.

#include "orient/stand.h"
#include "base/memory.h"
#include "law/stack.h"

static double margin_of(const stack *s)
{
    sf_grid *grid = stack_grid(s);
    double margin = 9;
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    CHECK_EQ(sfi_stand_margin(grid, &allocator, &margin), SF_OK);
    sf_grid_destroy(grid);
    return margin;
}

// The least distance from the centre to a line through two corners of squares of the lowest layer
// that has all corners on one side.
static double naive(const stack *s)
{
    static int xs[4096], ys[4096];
    int count = 0, layer = s->nx * s->ny, bed = stack_bed(s, SF_BED_AUTO);
    double sum[3] = {0, 0, 0}, volume = 0, least = 1e9;
    for (int i = 0; i < stack_count(s); i++) {
        int x = i % s->nx, y = i % layer / s->nx, z = i / layer;
        if (s->solid[i]) {
            sum[0] += x + 0.5;
            sum[1] += y + 0.5;
            sum[2] += z + 0.5;
            volume++;
        }
        for (int c = 0; c < 4 && s->solid[i] && z == bed; c++) {
            xs[count] = x + c % 2;
            ys[count++] = y + c / 2;
        }
    }
    for (int a = 0; a < count; a++) {
        for (int b = 0; b < count; b++) {
            int dx = xs[b] - xs[a], dy = ys[b] - ys[a], all = dx != 0 || dy != 0;
            for (int c = 0; c < count && all; c++) {
                all = dx * (ys[c] - ys[a]) - dy * (xs[c] - xs[a]) >= 0;
            }
            if (all) {
                double d = (dx * (sum[1] / volume - ys[a]) - dy * (sum[0] / volume - xs[a])) /
                           sqrt((double)(dx * dx + dy * dy));
                least = d < least ? d : least;
            }
        }
    }
    return atan(least / (sum[2] / volume - bed));
}

static void random_feet(void)
{
    static stack s;
    for (int i = 0; i < 400; i++) {
        int nx = 1 + (int)test_random_below(i % 20 == 0 ? 80 : 7),
            ny = 1 + (int)test_random_below(6);
        stack_random(&s, nx, ny, 4, i % 20 == 0 ? 0.05 : 0.25);
        if (stack_volume(&s) > 0) {
            CHECK_NEAR(margin_of(&s), naive(&s), 1e-12);
        }
    }
}

static void known_angles(void)
{
    static stack s;
    stack_parse(&s, "...|##.|##.");
    CHECK_NEAR(margin_of(&s), atan(0.5), 1e-12);
    stack_parse(&s, "#....|#####");
    // The centre lies at (13/6, 8/6), beyond the foot's edge at 1: it falls.
    CHECK_NEAR(margin_of(&s), atan((1 - 13.0 / 6) / (8.0 / 6)), 1e-12);
    stack_parse(&s, "...|...");
    CHECK_NEAR(margin_of(&s), 0, 0);
}

int main(void)
{
    TEST(random_feet);
    TEST(known_angles);
    return test_finish();
}
