// SPDX-License-Identifier: MIT
// Halftones of 1024^3 voxels. The limit reads the tones and writes the slices, and does nothing
// else: that is what memory alone would take.

#include "bench.h"

#include <sf/halftone.h>

#include <stdlib.h>
#include <string.h>

enum { SIDE = 1024 };

typedef struct halftone_work {
    sf_halftone *halftone;
    sf_tone_type type;
    uint32_t side;
    size_t size;     // bytes of all tones
    uint8_t *tones;  // (layer, y, x)
    uint64_t *words; // a bit a voxel
} halftone_work;

static void halftone_all(void *user)
{
    halftone_work *w = user;
    size_t row = w->side / 64, slice = row * w->side;
    for (uint32_t k = 0; k < w->side; k++) {
        sf_tone_plane plane = {w->tones + w->size / w->side * k, w->side};
        sf_slice slices[2] = {{w->words + slice * k, w->side, w->side, row}, {NULL, 0, 0, 0}};
        sf_tones tones = {.struct_size = sizeof tones, .width = w->side, .height = w->side};
        sf_materials out = {.slices = slices};
        tones.layer = k;
        tones.type = w->type;
        tones.planes = &plane;
        bench_must(sf_halftone_slice(w->halftone, &tones, &out, NULL));
    }
}

// Eight words of tones are read for each word of bits that is written, or 32 and more.
#define FOLD(suffix, target)                                                                       \
    target static void fold##suffix(uint64_t *to, const uint64_t *from, size_t count, size_t each) \
    {                                                                                              \
        for (size_t i = 0; i + 8 <= count; i += 8) {                                               \
            uint64_t lanes[8] = {0};                                                               \
            for (size_t k = 0; k < each; k++) {                                                    \
                for (size_t n = 0; n < 8; n++) {                                                   \
                    lanes[n] ^= from[each * i + 8 * k + n];                                        \
                }                                                                                  \
            }                                                                                      \
            for (size_t n = 0; n < 8; n++) {                                                       \
                to[i + n] = lanes[n];                                                              \
            }                                                                                      \
        }                                                                                          \
    }

FOLD(_plain, )
#if defined(__GNUC__) && defined(__x86_64__)
FOLD(_avx2, __attribute__((target("avx2"))))
#define HAS_AVX2 __builtin_cpu_supports("avx2")
#else
#define fold_avx2 fold_plain
#define HAS_AVX2 0
#endif

typedef void (*fold)(uint64_t *to, const uint64_t *from, size_t count, size_t each);

static void read_and_write(void *user)
{
    halftone_work *w = user;
    fold pass = HAS_AVX2 ? fold_avx2 : fold_plain;
    size_t count = (size_t)w->side * w->side / 64 * w->side, each = w->size / 8 / count;
    pass(w->words, (const uint64_t *)(const void *)w->tones, count, each);
}

static void fill(halftone_work *w)
{
    size_t voxels = (size_t)w->side * w->side * w->side;
    for (size_t i = 0; i < voxels; i++) {
        uint32_t x = (uint32_t)(i % w->side), z = (uint32_t)(i / w->side / w->side);
        double tone = 0.5 * (x + z) / w->side;
        if (w->type == SF_TONE_U8) {
            w->tones[i] = (uint8_t)(255 * tone);
        } else {
            ((float *)(void *)w->tones)[i] = (float)tone;
        }
    }
}

static void bench_one(const char *job, const char *size, uint32_t side, sf_tone_type type,
                      double goal)
{
    if (!bench_wants(job)) {
        return;
    }
    size_t voxels = (size_t)side * side * side;
    halftone_work w = {NULL, type, side, voxels * (type == SF_TONE_U8 ? 1 : 4), NULL, NULL};
    bench_must(sf_halftone_create(sf_mask_builtin(), 2, NULL, &w.halftone));
    w.tones = bench_memory(w.size);
    w.words = bench_memory(voxels / 8);
    memset(w.words, 0, voxels / 8);
    fill(&w);
    bench_work work = {NULL, halftone_all, read_and_write, &w};
    bench_measure(job, size, goal, (double)voxels * 1e-9, "Gvoxel", &work);
    sf_halftone_destroy(w.halftone);
    free(w.tones);
    free(w.words);
}

static void make_mask(void *user)
{
    sf_mask_options options = sf_mask_options_default();
    sf_mask *mask;
    options.nx = options.ny = options.nz = *(const uint32_t *)user;
    bench_must(sf_mask_create(&options, NULL, NULL, &mask));
    sf_mask_destroy(mask);
}

// What a mask cannot be made without: each rank is written once.
static void write_ranks(void *user)
{
    uint32_t side = *(const uint32_t *)user;
    uint32_t *ranks = bench_memory(sizeof *ranks * side * side * side);
    for (uint32_t i = 0; i < side * side * side; i++) {
        ranks[i] = i;
    }
    volatile uint32_t seen = ranks[side];
    (void)seen;
    free(ranks);
}

static void bench_mask(const char *size, uint32_t side)
{
    if (bench_wants("mask")) {
        bench_work work = {NULL, make_mask, write_ranks, &side};
        bench_measure("mask", size, 0, (double)side * side * side * 1e-6, "Mvoxel", &work);
    }
}

void bench_halftone(void)
{
    bench_one("halftone bytes", "1024^3", SIDE, SF_TONE_U8, 1.2);
    bench_one("halftone floats", "512^3", SIDE / 2, SF_TONE_F32, 0);
    bench_mask("32^3", 32);
    bench_mask("64^3", 64);
}
