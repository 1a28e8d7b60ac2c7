// SPDX-License-Identifier: MIT
// A random rectangle of tones for halftones, with everything that a caller may ask for, and the
// rule of <sf/halftone.h> applied to it one voxel at a time.

#ifndef SF_TEST_GRADE_SCENE_H
#define SF_TEST_GRADE_SCENE_H

#include <sf/halftone.h>

#include "test.h"

enum { SIDE_MAX = 2200, MATERIALS = 5 };

typedef struct scene {
    sf_tones tones;
    sf_materials out;
    uint32_t materials;
    sf_tone_plane planes[MATERIALS];
    sf_keep_out keep_outs[2];
    sf_slice slices[MATERIALS];
    uint64_t counts[MATERIALS];
} scene;

static inline sf_slice scene_slice(uint32_t width, uint32_t height, uint64_t fill)
{
    size_t stride = (width + 63) / 64 + test_random_below(2);
    sf_slice s = {malloc(8 * stride * height), width, height, stride};
    for (size_t i = 0; i < stride * height; i++) {
        s.words[i] = fill != 0 ? fill : test_random() | test_random();
    }
    return s;
}

// Tones of all materials but the last: each takes a share of what is left. Where a voxel is empty
// they are rubbish.
static inline void scene_fill(scene *s)
{
    for (uint32_t y = 0; y < s->tones.height; y++) {
        for (uint32_t x = 0; x < s->tones.width; x++) {
            double left = 1;
            unsigned left8 = 255;
            int solid = s->tones.solid.words == NULL || sf_slice_get(s->tones.solid, x, y);
            for (uint32_t j = 0; j + 1 < s->materials; j++) {
                size_t at = y * s->planes[j].stride + x;
                void *to = (void *)(uintptr_t)s->planes[j].values;
                double share =
                    test_random_below(8) == 0 ? 0.5 * test_random_below(3) : test_random_unit();
                double tone = solid ? left * share : NAN;
                unsigned tone8 = solid ? (unsigned)(left8 * share) : 200;
                left -= left * share;
                left8 -= solid ? tone8 : 0;
                if (s->tones.type == SF_TONE_U8) {
                    ((uint8_t *)to)[at] = (uint8_t)tone8;
                } else if (s->tones.type == SF_TONE_F32) {
                    ((float *)to)[at] = (float)tone;
                } else {
                    ((double *)to)[at] = tone;
                }
            }
        }
    }
}

// options: bit 0 a solid slice, 1 keep-outs, 2 bytes, 3 slices, 4 counts.
static inline void scene_begin(scene *s, uint32_t width, uint32_t height, uint32_t materials,
                               sf_tone_type type, unsigned options)
{
    memset(s, 0, sizeof *s);
    s->materials = materials;
    s->tones.struct_size = sizeof s->tones;
    s->tones.width = width;
    s->tones.height = height;
    s->tones.x0 = test_random_below(1000);
    s->tones.y0 = test_random_below(1000);
    s->tones.layer = test_random_below(1000);
    s->tones.type = type;
    for (uint32_t j = 0; j + 1 < materials; j++) {
        size_t size = type == SF_TONE_U8 ? 1 : type == SF_TONE_F32 ? 4 : 8;
        s->planes[j].stride = width + test_random_below(3);
        s->planes[j].values = malloc(size * s->planes[j].stride * height);
    }
    s->tones.planes = s->planes;
    if (options & 1) {
        s->tones.solid = scene_slice(width, height, 0);
    }
    for (uint32_t i = 0; (options & 2) && i < 2; i++) {
        s->keep_outs[i].where = scene_slice(width, height, 0);
        s->keep_outs[i].material = i;
        s->keep_outs[i].instead = (i + 1) % materials;
    }
    s->tones.keep_outs = s->keep_outs;
    s->tones.keep_out_count = options & 2 ? 2 : 0;
    if (options & 4) {
        s->out.ids_stride = width + test_random_below(3);
        s->out.ids = malloc(s->out.ids_stride * height);
        memset(s->out.ids, 0xdb, s->out.ids_stride * height);
    }
    for (uint32_t j = 0; (options & 8) && j < materials; j++) {
        s->slices[j] = scene_slice(width, height, UINT64_C(0xdbdbdbdbdbdbdbdb));
    }
    s->out.slices = options & 8 ? s->slices : NULL;
    s->out.counts = options & 16 ? s->counts : NULL;
    scene_fill(s);
}

static inline void scene_end(scene *s)
{
    for (uint32_t j = 0; j < MATERIALS; j++) {
        free((void *)(uintptr_t)s->planes[j].values);
        free(s->slices[j].words);
    }
    free(s->tones.solid.words);
    free(s->keep_outs[0].where.words);
    free(s->keep_outs[1].where.words);
    free(s->out.ids);
}

// The tones of material j up to and with it, at a voxel: as a number of ranks.
static inline uint32_t scene_threshold(const scene *s, uint32_t j, uint32_t x, uint32_t y,
                                       uint32_t count)
{
    double sum = 0;
    unsigned sum8 = 0;
    for (uint32_t i = 0; i <= j; i++) {
        size_t at = y * s->planes[i].stride + x;
        if (s->tones.type == SF_TONE_U8) {
            sum8 += ((const uint8_t *)s->planes[i].values)[at];
        } else if (s->tones.type == SF_TONE_F32) {
            sum += ((const float *)s->planes[i].values)[at];
        } else {
            sum += ((const double *)s->planes[i].values)[at];
        }
    }
    double tone = s->tones.type == SF_TONE_U8 ? sum8 / 255.0 : sum;
    return (uint32_t)floor((tone > 1 ? 1 : tone) * count + 0.5);
}

// Material + 1 of a voxel by the rule, or 0.
static inline uint32_t scene_rule(const scene *s, const sf_mask *mask, uint32_t x, uint32_t y)
{
    uint32_t n[3], j = 0;
    sf_mask_size(mask, n);
    if (s->tones.solid.words != NULL && !sf_slice_get(s->tones.solid, x, y)) {
        return 0;
    }
    uint32_t rank = sf_mask_rank(mask, s->tones.x0 + x, s->tones.y0 + y, s->tones.layer);
    while (j + 1 < s->materials && rank >= scene_threshold(s, j, x, y, n[0] * n[1] * n[2])) {
        j++;
    }
    for (size_t i = 0; i < s->tones.keep_out_count; i++) {
        if (s->keep_outs[i].material == j && sf_slice_get(s->keep_outs[i].where, x, y)) {
            j = s->keep_outs[i].instead;
        }
    }
    return j + 1;
}

#endif
