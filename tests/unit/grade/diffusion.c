// SPDX-License-Identifier: MIT
// Why: error diffusion must lose nothing it does not own up to. Held against sums taken here: what
// was asked is what was placed, what was dropped at the top of empty voxels, and what waits, to
// rounding of tones alone (TRUST 72: total error is dropped error). Against a diffuser written anew
// in floating point from the description, and, with one material that is never asked for and a
// single row, against the law of one dimension: no prefix is off by more than half a voxel.

#include "scene.h"

static void nothing_is_lost(void)
{
    const double pitch[3] = {0.0423, 0.0846, 0.027};
    for (int round = 0; round < 20; round++) {
        uint32_t width = 20 + test_random_below(90), height = 5 + test_random_below(30);
        uint32_t materials = 2 + test_random_below(MATERIALS - 1);
        sf_diffuser *diffuser = NULL;
        double asked[MATERIALS] = {0}, placed[MATERIALS] = {0};
        sf_diffusion report[MATERIALS];
        CHECK_EQ(sf_diffuser_create(width, height, materials, pitch, NULL, &diffuser), SF_OK);
        for (int k = 0; k < 12; k++) {
            scene s;
            scene_begin(&s, width, height, materials, (sf_tone_type)(round % 3),
                        round % 2 ? 29 : 28);
            CHECK_EQ(sf_diffuser_slice(diffuser, &s.tones, &s.out), SF_OK);
            for (uint32_t y = 0; y < height; y++) {
                for (uint32_t x = 0; x < width; x++) {
                    double left = 1;
                    int solid = s.tones.solid.words == NULL || sf_slice_get(s.tones.solid, x, y);
                    uint8_t id = s.out.ids[y * s.out.ids_stride + x];
                    CHECK(solid ? id >= 1 && id <= materials : id == 0);
                    for (uint32_t j = 0; solid && j < materials; j++) {
                        size_t at = j + 1 < materials ? y * s.planes[j].stride + x : 0;
                        const void *v = s.planes[j].values;
                        double f = j + 1 == materials            ? left
                                   : s.tones.type == SF_TONE_U8  ? ((const uint8_t *)v)[at] / 255.0
                                   : s.tones.type == SF_TONE_F32 ? ((const float *)v)[at]
                                                                 : ((const double *)v)[at];
                        left -= f;
                        asked[j] += f;
                        placed[j] += id == j + 1;
                        CHECK_EQ(sf_slice_get(s.slices[j], x, y), id == j + 1);
                    }
                }
            }
            scene_end(&s);
        }
        CHECK_EQ(sf_diffuser_report(diffuser, report), SF_OK);
        for (uint32_t j = 0; j < materials; j++) {
            const sf_diffusion *r = &report[j];
            CHECK_NEAR(r->asked, asked[j], 12.0 * width * height * 0x1p-24 * MATERIALS);
            CHECK(r->placed == placed[j]);
            CHECK(r->asked == r->placed + r->dropped + r->carried); // to the last bit
        }
        sf_diffuser_destroy(diffuser);
    }
}

// From the description, in doubles: which material each voxel gets may differ where two lack the
// same but for rounding, so what is compared is what a slow walk finds on the quick one's choices:
// the chosen one lacks no less than any other, within rounding.
static void the_most_wanted_is_placed(void)
{
    enum { W = 40, H = 23, N = 3, K = 8 };
    static double up[H][W][N], here[W + 2][N], next[W + 2][N];
    const double pitch[3] = {1, 2, 0.5};
    double near[4] = {1, 0.5, 1 / sqrt(5), 2}, sum = near[0] + near[1] + near[2] + near[3];
    sf_diffuser *diffuser = NULL;
    memset(up, 0, sizeof up);
    CHECK_EQ(sf_diffuser_create(W, H, N, pitch, NULL, &diffuser), SF_OK);
    for (int k = 0; k < K; k++) {
        scene s;
        scene_begin(&s, W, H, N, SF_TONE_F64, k % 2 ? 5 : 4);
        CHECK_EQ(sf_diffuser_slice(diffuser, &s.tones, &s.out), SF_OK);
        memset(here, 0, sizeof here);
        for (int y = 0; y < H; y++) {
            int step = (y + k) % 2 ? -1 : 1;
            memset(next, 0, sizeof next);
            for (int i = 0; i < W; i++) {
                int x = step > 0 ? i : W - 1 - i;
                uint8_t id = s.out.ids[(size_t)y * s.out.ids_stride + (size_t)x];
                double wanted[N], left = 1;
                for (int j = 0; j < N; j++) {
                    double f = j + 1 < N && id > 0
                                   ? ((const double *)s.planes[j]
                                          .values)[(size_t)y * s.planes[j].stride + (size_t)x]
                                   : left;
                    left -= f;
                    wanted[j] = f + up[y][x][j] + here[x + 1][j];
                    up[y][x][j] = 0;
                }
                if (id == 0) {
                    continue;
                }
                for (int j = 0; j < N; j++) {
                    CHECK(wanted[id - 1] >= wanted[j] - 1e-4);
                }
                wanted[id - 1] -= 1;
                int to_x[3] = {x + step, x, x - step}, to_y[3] = {y, y + 1, y + 1};
                for (int j = 0; j < N; j++) {
                    double rest = wanted[j];
                    for (int n = 0; n < 3; n++) {
                        int inside = to_x[n] >= 0 && to_x[n] < W && to_y[n] < H;
                        if (inside &&
                            (s.tones.solid.words == NULL ||
                             sf_slice_get(s.tones.solid, (uint32_t)to_x[n], (uint32_t)to_y[n]))) {
                            double part = wanted[j] * near[n] / sum;
                            (n == 0 ? here : next)[to_x[n] + 1][j] += part;
                            rest -= part;
                        }
                    }
                    up[y][x][j] = rest;
                }
            }
            memcpy(here, next, sizeof here);
        }
        scene_end(&s);
    }
    sf_diffuser_destroy(diffuser);
}

// A constant tone over 32^3: exact but for what waits above the last slice.
static void tones_are_close(void)
{
    const double tones[5] = {0.05, 0.1, 0.25, 0.5, 0.8}, pitch[3] = {1, 1, 1};
    static double values[32 * 32];
    for (int i = 0; i < 5; i++) {
        sf_diffuser *diffuser = NULL;
        uint64_t counts[2], sum = 0;
        sf_tone_plane plane = {values, 32};
        sf_tones t = {.struct_size = sizeof t, .width = 32, .height = 32};
        sf_materials out = {.counts = counts};
        t.type = SF_TONE_F64;
        t.planes = &plane;
        for (int v = 0; v < 32 * 32; v++) {
            values[v] = tones[i];
        }
        CHECK_EQ(sf_diffuser_create(32, 32, 2, pitch, NULL, &diffuser), SF_OK);
        for (int k = 0; k < 32; k++) {
            CHECK_EQ(sf_diffuser_slice(diffuser, &t, &out), SF_OK);
            sum += counts[0];
        }
        printf("# tone %.2f: %.5f\n", tones[i], (double)sum / 32768);
        CHECK_NEAR((double)sum / 32768, tones[i], 0.004);
        sf_diffuser_destroy(diffuser);
    }
}

int main(void)
{
    TEST(nothing_is_lost);
    TEST(the_most_wanted_is_placed);
    TEST(tones_are_close);
    return test_finish();
}
