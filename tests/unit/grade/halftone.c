// SPDX-License-Identifier: MIT
// Why: what goes to the printer is what sf_halftone_slice() says. Held against the rule of
// <sf/halftone.h>, applied one voxel at a time: for bytes, floats and doubles, two to five
// materials, masks of other sizes, any place, empty voxels, keep-outs, every width around a word
// and a stretch, and every instruction set. Promises: tones are exact over whole periods; brighter
// tones are supersets (TRUST 72); rows and tiles are what the whole slice is; the same bytes for 1,
// 2 and 16 threads.

#include "backwards.h"
#include "scene.h"
#include "threads.h"

static sf_mask *other; // 8 x 5 x 3, whose number of voxels is no power of two
static sf_mask *wide;  // 128 x 4 x 2

static sf_halftone *ready(const sf_mask *mask, uint32_t materials)
{
    sf_halftone *halftone = NULL;
    CHECK_EQ(sf_halftone_create(mask, materials, NULL, &halftone), SF_OK);
    return halftone;
}

// Compare everything that was asked for with the rule.
static void judge(const scene *s, const sf_mask *mask)
{
    uint64_t counts[MATERIALS + 1] = {0}, wrong = 0;
    for (uint32_t y = 0; y < s->tones.height; y++) {
        for (uint32_t x = 0; x < s->tones.width; x++) {
            uint32_t id = scene_rule(s, mask, x, y);
            counts[id]++;
            wrong += s->out.ids != NULL && s->out.ids[y * s->out.ids_stride + x] != id;
            for (uint32_t j = 0; s->out.slices != NULL && j < s->materials; j++) {
                wrong += sf_slice_get(s->slices[j], x, y) != (id == j + 1);
            }
        }
        for (uint32_t j = 0; s->out.slices != NULL && j < s->materials; j++) {
            uint32_t width = s->tones.width;
            uint64_t last = s->slices[j].words[y * s->slices[j].stride + (width - 1) / 64];
            wrong += width % 64 != 0 && last >> width % 64 != 0;
        }
    }
    CHECK_EQ(wrong, 0);
    for (uint32_t j = 0; s->out.counts != NULL && j < s->materials; j++) {
        CHECK_EQ(s->counts[j], counts[j + 1]);
    }
}

static void it_is_the_rule(void)
{
    const sf_mask *masks[3] = {sf_mask_builtin(), other, wide};
    for (unsigned i = 0; i < 400; i++) {
        const sf_mask *mask = masks[i % 3];
        uint32_t materials = 2 + test_random_below(MATERIALS - 1);
        uint32_t width = i % 20 == 0 ? 1000 + test_random_below(1200) : 1 + test_random_below(200);
        scene s;
        scene_begin(&s, width, 1 + test_random_below(40), materials,
                    (sf_tone_type)test_random_below(3), i % 4 == 0 ? 24 : test_random_below(32));
        sf_halftone *halftone = ready(mask, materials);
        sf_isa_limit((sf_isa)(i % SF_ISA_COUNT));
        CHECK_EQ(sf_halftone_slice(halftone, &s.tones, &s.out, NULL), SF_OK);
        judge(&s, mask);
        sf_halftone_destroy(halftone);
        scene_end(&s);
    }
    sf_isa_limit(SF_ISA_COUNT);
}

// Two materials in bytes without more: the way that has a loop of its own.
static void so_is_the_short_way(void)
{
    const sf_mask *masks[3] = {sf_mask_builtin(), other, wide};
    for (unsigned i = 0; i < 120; i++) {
        scene s;
        scene_begin(&s, 1 + test_random_below(1400), 1 + test_random_below(20), 2, SF_TONE_U8,
                    8 | (i % 2) | (i % 3 == 0 ? 16 : 0));
        sf_slice second = s.slices[1];
        if (i % 5 == 0) {
            s.slices[1].words = NULL;
        }
        sf_halftone *halftone = ready(masks[i % 3], 2);
        CHECK_EQ(sf_halftone_slice(halftone, &s.tones, &s.out, NULL), SF_OK);
        if (i % 5 == 0) {
            s.slices[1] = second;
            uint64_t wrong = 0;
            for (uint32_t y = 0; y < s.tones.height; y++) {
                for (uint32_t x = 0; x < s.tones.width; x++) {
                    int want = scene_rule(&s, masks[i % 3], x, y) == 1;
                    wrong += sf_slice_get(s.slices[0], x, y) != want;
                }
            }
            CHECK_EQ(wrong, 0);
        } else {
            judge(&s, masks[i % 3]);
        }
        sf_halftone_destroy(halftone);
        scene_end(&s);
    }
}

// One call for the whole, and one for each tile of it, in another order.
static void tiles_are_the_whole(void)
{
    scene s;
    scene_begin(&s, 300, 70, 3, SF_TONE_F32, 4);
    sf_halftone *halftone = ready(sf_mask_builtin(), 3);
    uint8_t *tiled = calloc(s.out.ids_stride, 70);
    CHECK_EQ(sf_halftone_slice(halftone, &s.tones, &s.out, NULL), SF_OK);
    for (uint32_t i = 100; i-- > 0;) {
        uint32_t x = i % 10 * 30, y = i / 10 * 7;
        sf_tones tile = s.tones;
        sf_tone_plane planes[2];
        for (int j = 0; j < 2; j++) {
            planes[j] = s.planes[j];
            planes[j].values = (const float *)s.planes[j].values + y * planes[j].stride + x;
        }
        tile.planes = planes;
        tile.x0 += x;
        tile.y0 += y;
        tile.width = 30;
        tile.height = 7;
        sf_materials out = {NULL, tiled + y * s.out.ids_stride + x, s.out.ids_stride, NULL};
        CHECK_EQ(sf_halftone_slice(halftone, &tile, &out, NULL), SF_OK);
    }
    for (uint32_t y = 0; y < 70; y++) {
        CHECK(memcmp(tiled + y * s.out.ids_stride, s.out.ids + y * s.out.ids_stride, 300) == 0);
    }
    free(tiled);
    sf_halftone_destroy(halftone);
    scene_end(&s);
}

static void any_number_of_threads(void)
{
    scene s;
    scene_begin(&s, 700, 333, 4, SF_TONE_F64, 31);
    sf_halftone *halftone = ready(sf_mask_builtin(), 4);
    size_t size = s.out.ids_stride * 333;
    uint8_t *first = malloc(size);
    int threads[3] = {1, 2, 16};
    CHECK_EQ(sf_halftone_slice(halftone, &s.tones, &s.out, NULL), SF_OK);
    memcpy(first, s.out.ids, size);
    for (int i = 0; i < 4; i++) {
        sf_task task = i < 3 ? crowd_task(&threads[i]) : sf_task_default();
        task.parallel_for = i < 3 ? crowd_for : backwards;
        uint64_t before[MATERIALS];
        memcpy(before, s.counts, sizeof before);
        memset(s.out.ids, 0xdb, size);
        CHECK_EQ(sf_halftone_slice(halftone, &s.tones, &s.out, &task), SF_OK);
        for (uint32_t y = 0; y < 333; y++) {
            CHECK(memcmp(first + y * s.out.ids_stride, s.out.ids + y * s.out.ids_stride, 700) == 0);
        }
        CHECK(memcmp(before, s.counts, sizeof before) == 0);
    }
    judge(&s, sf_mask_builtin());
    free(first);
    sf_halftone_destroy(halftone);
    scene_end(&s);
}

// Constant tones over a whole period: round(t N) voxels, neither more nor less.
static void tones_are_exact(void)
{
    const sf_mask *masks[3] = {sf_mask_builtin(), other, wide};
    for (int i = 0; i < 60; i++) {
        uint32_t n[3];
        const sf_mask *mask = masks[i % 3];
        sf_mask_size(mask, n);
        double share[2] = {test_random_unit(), 0};
        share[1] = (1 - share[0]) * test_random_unit();
        double *values = malloc(2 * sizeof(double) * n[0] * n[1]);
        for (uint32_t v = 0; v < 2 * n[0] * n[1]; v++) {
            values[v] = share[v / (n[0] * n[1])];
        }
        sf_tone_plane planes[2] = {{values, n[0]}, {values + n[0] * n[1], n[0]}};
        sf_tones tones = {.struct_size = sizeof tones, .width = n[0], .height = n[1]};
        uint64_t counts[3], sums[3] = {0, 0, 0};
        sf_materials out = {.counts = counts};
        sf_halftone *halftone = ready(mask, 3);
        tones.type = SF_TONE_F64;
        tones.planes = planes;
        for (uint32_t z = 0; z < n[2]; z++) {
            tones.layer = z + 7;
            CHECK_EQ(sf_halftone_slice(halftone, &tones, &out, NULL), SF_OK);
            for (int j = 0; j < 3; j++) {
                sums[j] += counts[j];
            }
        }
        double all = (double)n[0] * n[1] * n[2];
        uint64_t first = (uint64_t)floor(share[0] * all + 0.5);
        uint64_t second = (uint64_t)floor((share[0] + share[1]) * all + 0.5);
        CHECK_EQ(sums[0], first);
        CHECK_EQ(sums[1], second - first);
        CHECK_EQ(sums[2], (uint64_t)all - second);
        free(values);
        sf_halftone_destroy(halftone);
    }
}

// Law 72: more of the first material everywhere, and its voxels are a superset.
static void brighter_is_a_superset(void)
{
    sf_halftone *halftone = ready(sf_mask_builtin(), 2);
    for (int i = 0; i < 100; i++) {
        uint8_t dark[64 * 32], bright[64 * 32];
        uint64_t a[32], b[32];
        for (int v = 0; v < 64 * 32; v++) {
            dark[v] = (uint8_t)test_random();
            bright[v] = (uint8_t)(dark[v] + test_random_below(256u - dark[v]));
        }
        sf_tone_plane plane = {dark, 64};
        sf_slice slices[2] = {{a, 64, 32, 1}, {NULL, 0, 0, 0}};
        sf_tones tones = {.struct_size = sizeof tones, .width = 64, .height = 32, .layer = 3};
        sf_materials out = {.slices = slices};
        tones.planes = &plane;
        CHECK_EQ(sf_halftone_slice(halftone, &tones, &out, NULL), SF_OK);
        plane.values = bright;
        slices[0].words = b;
        CHECK_EQ(sf_halftone_slice(halftone, &tones, &out, NULL), SF_OK);
        for (int y = 0; y < 32; y++) {
            CHECK((a[y] & ~b[y]) == 0);
        }
    }
    sf_halftone_destroy(halftone);
}

int main(void)
{
    sf_mask_options options = sf_mask_options_default();
    options.nx = 8;
    options.ny = 5;
    options.nz = 3;
    int made = sf_mask_create(&options, NULL, NULL, &other) == SF_OK;
    options.nx = 128;
    options.ny = 4;
    options.nz = 2;
    made = made && sf_mask_create(&options, NULL, NULL, &wide) == SF_OK;
    if (!made) {
        printf("Bail out! no masks\n");
        return 1;
    }
    TEST(it_is_the_rule);
    TEST(so_is_the_short_way);
    TEST(tiles_are_the_whole);
    TEST(any_number_of_threads);
    TEST(tones_are_exact);
    TEST(brighter_is_a_superset);
    sf_mask_destroy(other);
    sf_mask_destroy(wide);
    return test_finish();
}
