// SPDX-License-Identifier: MIT
// Error diffusion of vectors through a stack.
//
// At each voxel the wanted vector is its tones plus what came from voxels before it; the material
// it lacks most is placed, and the difference goes on. With materials as the corners of a simplex
// that is the nearest corner, so what is carried stays bounded.
//
//          next in the row     1 / px                      z
//          next row            1 / py                      |  slice above: 1 / pz
//          next row, one back  1 / sqrt(px^2 + py^2)
//
// are the weights, scaled to a sum of one: what is nearer in mm gets more. Rows run to and fro, in
// every slice the other way round from the slice below, so that nothing drifts. A share for a voxel
// that is empty or outside goes up instead; what has gone up to an empty voxel is lost, and
// counted.
//
// Everything is integers in units of 2^-24: shares are rounded towards zero and the last one is
// what is left, so nothing is lost to rounding, and bytes are the same everywhere.
//
// Source: R. Floyd, L. Steinberg, "An adaptive algorithm for spatial greyscale", 1976; for vectors
// V. Ostromoukhov, R. D. Hersch, "Multi-color and artistic dithering", 1999; serpentine rows R.
// Ulichney, "Digital Halftoning", 1987.

#include <sf/halftone.h>

#include "base/memory.h"
#include "base/status.h"
#include "grade/tone/emit.h"
#include "grade/tone/tones.h"

#include <math.h>
#include <string.h>

#define UNIT 16777216
// Sum of the four weights.
#define WEIGHT_SUM 65536
#define PITCH_RATIO 64.0

typedef struct totals {
    int64_t asked, dropped;
    int64_t placed; // voxels
} totals;

struct sf_diffuser {
    uint32_t width, height, materials;
    uint32_t slices;      // so far
    int32_t weights[3];   // along the row, to the next row, to it and one back
    size_t row, size;     // numbers in a row, and in a slice
    int32_t *up;          // what came from below: [y][x][material]
    int32_t *here, *next; // what came within the slice, to this row and to the next
    uint8_t *placed;      // material + 1 of each voxel in a row
    totals totals[SF_MATERIAL_MAX];
    sf_allocator allocator;
};

static int pitches_are_good(const double pitch_mm[3])
{
    for (int n = 0; n < 3; n++) {
        if (!(pitch_mm[n] > 1e-12 && pitch_mm[n] < 1e12)) {
            return 0;
        }
    }
    for (int n = 0; n < 3; n++) {
        if (pitch_mm[n] > PITCH_RATIO * pitch_mm[(n + 1) % 3] ||
            pitch_mm[n] > PITCH_RATIO * pitch_mm[(n + 2) % 3]) {
            return 0;
        }
    }
    return 1;
}

static void set_weights(sf_diffuser *d, const double pitch_mm[3])
{
    double x = 1.0, y = pitch_mm[1] / pitch_mm[0], z = pitch_mm[2] / pitch_mm[0];
    double near[4] = {1.0 / x, 1.0 / y, 1.0 / sqrt(x * x + y * y), 1.0 / z};
    double sum = (near[0] + near[1]) + (near[2] + near[3]);
    for (int n = 0; n < 3; n++) {
        d->weights[n] = (int32_t)floor(WEIGHT_SUM * near[n] / sum + 0.5);
    }
}

sf_status sf_diffuser_create(uint32_t width, uint32_t height, uint32_t material_count,
                             const double pitch_mm[3], const sf_allocator *allocator,
                             sf_diffuser **diffuser)
{
    sf_allocator a = sfi_allocator_or_default(allocator);
    if (width < 1 || width > SF_EXTENT_MAX || height < 1 || height > SF_EXTENT_MAX ||
        material_count < 2 || material_count > SF_MATERIAL_MAX || pitch_mm == NULL ||
        diffuser == NULL || !pitches_are_good(pitch_mm)) {
        return SF_ERR_ARGUMENT;
    }
    size_t row = (size_t)width * material_count, size, bytes;
    if (!sfi_size_mul(row, height, &size) || !sfi_size_mul(size, sizeof(int32_t), &bytes)) {
        return SF_ERR_OVERFLOW;
    }
    sf_diffuser *d = sfi_alloc_array(&a, 1, sizeof *d);
    if (d == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(d, 0, sizeof *d);
    d->width = width;
    d->height = height;
    d->materials = material_count;
    d->row = row;
    d->size = size;
    d->allocator = a;
    set_weights(d, pitch_mm);
    d->up = sfi_alloc_array(&a, size, sizeof *d->up);
    d->here = sfi_alloc_array(&a, row, sizeof *d->here);
    d->next = sfi_alloc_array(&a, row, sizeof *d->next);
    d->placed = sfi_alloc_array(&a, width, sizeof *d->placed);
    if (d->up == NULL || d->here == NULL || d->next == NULL || d->placed == NULL) {
        sf_diffuser_destroy(d);
        return SF_ERR_MEMORY;
    }
    memset(d->up, 0, bytes);
    *diffuser = d;
    return SF_OK;
}

void sf_diffuser_destroy(sf_diffuser *diffuser)
{
    if (diffuser != NULL) {
        sf_allocator a = diffuser->allocator;
        sfi_free_array(&a, diffuser->up, diffuser->size, sizeof *diffuser->up);
        sfi_free_array(&a, diffuser->here, diffuser->row, sizeof *diffuser->here);
        sfi_free_array(&a, diffuser->next, diffuser->row, sizeof *diffuser->next);
        sfi_free_array(&a, diffuser->placed, diffuser->width, sizeof *diffuser->placed);
        sfi_free_array(&a, diffuser, 1, sizeof *diffuser);
    }
}

// ---------------------------------------------------------------------------------------------
// One voxel
// ---------------------------------------------------------------------------------------------

// What a voxel wants: its tones, and what came to it. Tones add up to a unit.
static void want(sf_diffuser *d, const sf_tones *t, uint32_t x, uint32_t y, int32_t *wanted)
{
    const size_t at = (size_t)x * d->materials;
    const int32_t *up = d->up + (size_t)y * d->row + at;
    int32_t left = UNIT;
    for (uint32_t j = 0; j < d->materials; j++) {
        int32_t tone = left;
        if (j + 1 < d->materials) {
            double f = sfi_tone_at(t, j, x, y) * UNIT + 0.5;
            tone = f < (double)left ? (int32_t)f : left;
        }
        left -= tone;
        wanted[j] = tone + up[j] + d->here[at + j];
        d->totals[j].asked += tone;
    }
}

static uint32_t most(const int32_t *wanted, uint32_t count)
{
    uint32_t best = 0;
    for (uint32_t j = 1; j < count; j++) {
        best = wanted[j] > wanted[best] ? j : best;
    }
    return best;
}

// The share of an error that a weight gives, towards zero.
static int32_t share(int32_t error, int32_t weight)
{
    return (int32_t)((int64_t)error * weight / WEIGHT_SUM);
}

static int solid_at(const sf_tones *t, int64_t x, uint32_t y)
{
    return x >= 0 && x < (int64_t)t->width && y < t->height &&
           (sfi_tones_solid(t, y, (size_t)x / 64) >> (unsigned)(x % 64) & 1) != 0;
}

// Pass on what the voxel wanted and did not get.
static void pass_on(sf_diffuser *d, const sf_tones *t, uint32_t x, uint32_t y, int step,
                    const int32_t *error)
{
    const size_t at = (size_t)x * d->materials;
    int64_t ahead = (int64_t)x + step, back = (int64_t)x - step;
    int32_t *to[3] = {NULL, NULL, NULL};
    if (solid_at(t, ahead, y)) {
        to[0] = d->here + (size_t)ahead * d->materials;
    }
    if (solid_at(t, x, y + 1)) {
        to[1] = d->next + at;
    }
    if (solid_at(t, back, y + 1)) {
        to[2] = d->next + (size_t)back * d->materials;
    }
    for (uint32_t j = 0; j < d->materials; j++) {
        int32_t left = error[j];
        for (int n = 0; n < 3; n++) {
            if (to[n] != NULL) {
                int32_t part = share(error[j], d->weights[n]);
                to[n][j] += part;
                left -= part;
            }
        }
        d->up[(size_t)y * d->row + at + j] = left;
    }
}

// An empty voxel takes what came from below with it.
static void drop(sf_diffuser *d, uint32_t x, uint32_t y)
{
    int32_t *up = d->up + (size_t)y * d->row + (size_t)x * d->materials;
    for (uint32_t j = 0; j < d->materials; j++) {
        d->totals[j].dropped += up[j];
        up[j] = 0;
    }
}

static void diffuse_row(sf_diffuser *d, const sf_tones *t, uint32_t y)
{
    int step = (y + d->slices) % 2 == 0 ? 1 : -1;
    int32_t wanted[SF_MATERIAL_MAX];
    memset(d->next, 0, d->row * sizeof *d->next);
    for (uint32_t i = 0; i < d->width; i++) {
        uint32_t x = step > 0 ? i : d->width - 1 - i;
        if (!solid_at(t, x, y)) {
            drop(d, x, y);
            d->placed[x] = 0;
            continue;
        }
        want(d, t, x, y, wanted);
        uint32_t j = most(wanted, d->materials);
        wanted[j] -= UNIT;
        d->totals[j].placed++;
        d->placed[x] = (uint8_t)(j + 1);
        pass_on(d, t, x, y, step, wanted);
    }
    int32_t *kept = d->here;
    d->here = d->next;
    d->next = kept;
}

// ---------------------------------------------------------------------------------------------
// One slice
// ---------------------------------------------------------------------------------------------

static void emit_row(const sf_diffuser *d, const sf_tones *t, const sf_materials *materials,
                     uint32_t y, uint64_t *counts)
{
    for (uint32_t x = 0; x < d->width; x += SFI_STRETCH) {
        uint32_t end = d->width - x < SFI_STRETCH ? d->width : x + SFI_STRETCH;
        uint64_t words[SF_MATERIAL_MAX][SFI_STRETCH_WORDS] = {{0}};
        for (uint32_t i = x; i < end; i++) {
            if (d->placed[i] > 0) {
                words[d->placed[i] - 1][(i - x) / 64] |= UINT64_C(1) << i % 64;
            }
        }
        sfi_emit(t, materials, d->materials, y, x / 64, sfi_row_words(end - x), words, counts);
    }
}

sf_status sf_diffuser_slice(sf_diffuser *diffuser, const sf_tones *tones,
                            const sf_materials *materials)
{
    sf_diffuser *d = diffuser;
    uint64_t counts[SF_MATERIAL_MAX] = {0};
    if (d == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_tones_validate(tones, materials, d->materials));
    if (tones->width != d->width || tones->height != d->height) {
        return SF_ERR_SHAPE;
    }
    if (!sfi_tones_good(tones, d->materials, 0, d->height)) {
        return SF_ERR_ARGUMENT;
    }
    memset(d->here, 0, d->row * sizeof *d->here);
    for (uint32_t y = 0; y < d->height; y++) {
        diffuse_row(d, tones, y);
        emit_row(d, tones, materials, y, counts);
    }
    d->slices++;
    if (materials->counts != NULL) {
        memcpy(materials->counts, counts, d->materials * sizeof *counts);
    }
    return SF_OK;
}

sf_status sf_diffuser_report(const sf_diffuser *diffuser, sf_diffusion *report)
{
    if (diffuser == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    for (uint32_t j = 0; j < diffuser->materials; j++) {
        int64_t carried = 0;
        for (size_t i = j; i < diffuser->size; i += diffuser->materials) {
            carried += diffuser->up[i];
        }
        report[j].asked = (double)diffuser->totals[j].asked / UNIT;
        report[j].placed = (double)diffuser->totals[j].placed;
        report[j].dropped = (double)diffuser->totals[j].dropped / UNIT;
        report[j].carried = (double)carried / UNIT;
    }
    return SF_OK;
}
