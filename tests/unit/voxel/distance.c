// SPDX-License-Identifier: MIT
// Why: what a path costs on the bed, and its cost by nearness, are distances that must be exact, or
// ties would fall otherwise on other machines. Compared with the least over all solid voxels.

#include "voxel/distance.h"
#include "law/stack.h"

static void distances_are_exact(void)
{
    static stack s;
    static uint32_t square[4096], scratch[3 * 256];
    for (int i = 0; i < 400; i++) {
        int nx = 1 + (int)test_random_below(i % 10 == 0 ? 130 : 20);
        int ny = 1 + (int)test_random_below(20);
        stack_random(&s, nx, ny, 1, i % 3 == 0 ? 0.005 : 0.3 * test_random_unit());
        sf_grid *grid = stack_grid(&s);
        sfi_slice_distance(sf_grid_slice(grid, 0), square, scratch);
        for (int j = 0; j < nx * ny; j++) {
            int64_t least = SFI_DISTANCE_NONE;
            for (int k = 0; k < nx * ny; k++) {
                int64_t dx = j % nx - k % nx, dy = j / nx - k / nx;
                if (s.solid[k] && dx * dx + dy * dy < least) {
                    least = dx * dx + dy * dy;
                }
            }
            CHECK_EQ(square[j], least);
        }
        sf_grid_destroy(grid);
    }
    for (uint32_t n = 0; n < 3000; n++) {
        uint32_t root = sfi_distance_steps(n);
        CHECK(root * root >= n && (n == 0 || (root - 1) * (root - 1) < n));
    }
    CHECK_EQ(sfi_distance_steps(SFI_DISTANCE_NONE - 1), 65536);
    CHECK_EQ(sfi_distance_steps(SFI_DISTANCE_NONE), 1);
}

int main(void)
{
    TEST(distances_are_exact);
    return test_finish();
}
