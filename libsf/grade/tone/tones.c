// SPDX-License-Identifier: MIT
// Tones are read twice: once to see that all of them are tones, once to use them. So a call that
// refuses one has written nothing. Where the slice is empty nobody promises anything of them.

#include "grade/tone/tones.h"

#include "base/status.h"

#include <string.h>

// How far above 1 rounding may carry a sum of fractions.
#define SLACK 1e-6

static sf_status check_shape(sf_slice slice, const sf_tones *t)
{
    SF_TRY(sfi_slice_validate(slice));
    return slice.width == t->width && slice.height == t->height ? SF_OK : SF_ERR_SHAPE;
}

static sf_status check_input(const sf_tones *t, uint32_t material_count)
{
    if (t->struct_size < sizeof *t || t->width < 1 || t->width > SF_EXTENT_MAX || t->height < 1 ||
        t->height > SF_EXTENT_MAX || (unsigned)t->type > (unsigned)SF_TONE_F64 ||
        t->planes == NULL || (t->keep_outs == NULL && t->keep_out_count > 0)) {
        return SF_ERR_ARGUMENT;
    }
    for (uint32_t j = 0; j + 1 < material_count; j++) {
        if (t->planes[j].values == NULL || t->planes[j].stride < t->width) {
            return SF_ERR_ARGUMENT;
        }
    }
    if (t->solid.words != NULL) {
        SF_TRY(check_shape(t->solid, t));
    }
    for (size_t i = 0; i < t->keep_out_count; i++) {
        const sf_keep_out *k = &t->keep_outs[i];
        if (k->material >= material_count || k->instead >= material_count ||
            k->material == k->instead) {
            return SF_ERR_ARGUMENT;
        }
        SF_TRY(check_shape(k->where, t));
    }
    return SF_OK;
}

// A slice that is written lies across none that is read and none of those before it.
static int slice_is_apart(const sf_tones *t, const sf_slice *slices, uint32_t j)
{
    int apart = t->solid.words == NULL || !sfi_slice_overlap(slices[j], t->solid);
    for (size_t i = 0; i < t->keep_out_count; i++) {
        apart = apart && !sfi_slice_overlap(slices[j], t->keep_outs[i].where);
    }
    for (uint32_t i = 0; i < j; i++) {
        apart = apart && (slices[i].words == NULL || !sfi_slice_overlap(slices[j], slices[i]));
    }
    return apart;
}

sf_status sfi_tones_validate(const sf_tones *tones, const sf_materials *materials,
                             uint32_t material_count)
{
    if (tones == NULL || materials == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(check_input(tones, material_count));
    if (materials->ids != NULL && materials->ids_stride < tones->width) {
        return SF_ERR_ARGUMENT;
    }
    for (uint32_t j = 0; materials->slices != NULL && j < material_count; j++) {
        if (materials->slices[j].words != NULL) {
            SF_TRY(check_shape(materials->slices[j], tones));
            if (!slice_is_apart(tones, materials->slices, j)) {
                return SF_ERR_ARGUMENT;
            }
        }
    }
    return SF_OK;
}

void sfi_tones_add(const sf_tones *t, uint32_t j, uint32_t x, uint32_t y, uint32_t count,
                   double *sums)
{
    size_t at = (size_t)y * t->planes[j].stride + x;
    if (t->type == SF_TONE_F64) {
        const double *from = (const double *)t->planes[j].values + at;
        for (uint32_t i = 0; i < count; i++) {
            sums[i] += from[i];
        }
    } else if (t->type == SF_TONE_F32) {
        const float *from = (const float *)t->planes[j].values + at;
        for (uint32_t i = 0; i < count; i++) {
            sums[i] += (double)from[i];
        }
    } else {
        const uint8_t *from = (const uint8_t *)t->planes[j].values + at;
        for (uint32_t i = 0; i < count; i++) {
            sums[i] += from[i] / 255.0;
        }
    }
}

void sfi_tones_add_bytes(const sf_tones *t, uint32_t j, uint32_t x, uint32_t y, uint32_t count,
                         uint8_t *sums)
{
    const uint8_t *from = (const uint8_t *)t->planes[j].values + (size_t)y * t->planes[j].stride;
    for (uint32_t i = 0; i < count; i++) {
        unsigned sum = (unsigned)sums[i] + from[x + i];
        sums[i] = (uint8_t)(sum < 255 ? sum : 255);
    }
}

// One stretch: which voxels are bad, a byte each.
static void judge_stretch(const sf_tones *t, uint32_t material_count, uint32_t x, uint32_t y,
                          uint32_t count, uint8_t *bad)
{
    double sums[SFI_STRETCH], before[SFI_STRETCH];
    memset(sums, 0, sizeof sums);
    memset(bad, 0, SFI_STRETCH);
    for (uint32_t j = 0; j + 1 < material_count; j++) {
        memcpy(before, sums, sizeof before);
        sfi_tones_add(t, j, x, y, count, sums);
        for (uint32_t i = 0; i < count; i++) {
            bad[i] |= !(sums[i] >= before[i]);
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        bad[i] |= !(sums[i] <= 1.0 + SLACK);
    }
}

static int stretch_is_good(const sf_tones *t, uint32_t x, uint32_t y, uint32_t count,
                           const uint8_t *bad)
{
    uint8_t any = 0;
    for (uint32_t i = 0; i < count; i++) {
        any |= bad[i];
    }
    if (!any) {
        return 1;
    }
    for (uint32_t i = 0; i < count; i++) {
        if (bad[i] && (sfi_tones_solid(t, y, (x + i) / 64) >> (x + i) % 64 & 1) != 0) {
            return 0;
        }
    }
    return 1;
}

int sfi_tones_good(const sf_tones *t, uint32_t material_count, uint32_t y0, uint32_t y1)
{
    uint8_t bad[SFI_STRETCH];
    if (t->type == SF_TONE_U8 && material_count == 2) {
        return 1; // no byte is wrong
    }
    for (uint32_t y = y0; y < y1; y++) {
        for (uint32_t x = 0; x < t->width; x += SFI_STRETCH) {
            uint32_t count = t->width - x < SFI_STRETCH ? t->width - x : SFI_STRETCH;
            judge_stretch(t, material_count, x, y, count, bad);
            if (!stretch_is_good(t, x, y, count, bad)) {
                return 0;
            }
        }
    }
    return 1;
}
