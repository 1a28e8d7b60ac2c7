// SPDX-License-Identifier: MIT
// Why: what is cut for a print are scans, sculptures and parts, with triangles of any shape; their
// halves must be closed and add up as those of boxes do (TRUST B8). The models are those of
// SF_DATA.

#include "data_file.h"
#include "halves.h"

// The horse comes inside out; the others are one solid, whose caps lie flat.
static void real_models_are_cut(void)
{
    static const char *const names[] = {"characters/horse.ply",
                                        "characters/spot_low_resolution.obj",
                                        "characters/armadillo.obj", "parts/ksr_fdmtest_v4.stl"};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA names no folder");
    }
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        sf_mesh *mesh = data_mesh(names[i]);
        double low[3], high[3];
        if (mesh == NULL || sf_mesh_bounds(sf_mesh_get_view(mesh), low, high) != SF_OK) {
            continue;
        }
        for (int n = 0; n < 9; n++) {
            int axis = n % 3;
            double at = low[axis] + (high[axis] - low[axis]) * (n / 3 == 0 ? 0.5 : 0.3 * (n / 3));
            halves h = cut_view(sf_mesh_get_view(mesh), axis, at);
            double turned, area = cap_area(h.view[0], axis, at, 0, &turned);
            CHECK(fabs(area) > 0);
            CHECK(turned <= 1e-15 * area || turned + area <= 1e-14 * turned);
            end(&h);
        }
        sf_mesh_destroy(mesh);
    }
}

int main(void)
{
    TEST(real_models_are_cut);
    return test_finish();
}
