// SPDX-License-Identifier: MIT
// Ordered dither with one mask for all materials.
//
// Material j lies where T_{j-1} <= rank < T_j: what lies below T_j, less what lies below T_{j-1}.
// So each boundary between materials is a comparison of its own, 64 voxels to a word, and all of
// them use the same ranks. What lies between two thresholds of one blue mask is blue as well; of
// materials that each had a mask of their own the middle ones would clump.
//
// For a comparison the mask is turned round: instead of a threshold for each voxel there is a level
// for each rank, the least tone that reaches it. For bytes that is the least of 0 .. 255 whose
// threshold is above the rank, so the comparison of two bytes decides just what the exact
// thresholds decide. All other tones become thresholds, 32-bit numbers, and the level of a rank is
// rank + 1. Rows of levels are repeated to 64 entries and one period more, so that a row that
// starts anywhere in a period finds its levels in one piece.
//
// Source: R. Ulichney, "Digital Halftoning", 1987, chapter 5.

#include <sf/halftone.h>

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "grade/tone/emit.h"
#include "grade/tone/mask.h"
#include "grade/tone/tones.h"

#include <string.h>

struct sf_halftone {
    uint32_t n[3];
    uint32_t material_count;
    uint32_t rank_count;
    size_t turn; // words after which levels come again
    size_t row;  // entries in a row of levels
    size_t size; // of all levels
    uint8_t *bytes;
    int32_t *numbers;
    sf_allocator allocator;
};

// floor(t N + 1/2) for any t; what is no number counts as 0.
static inline int32_t threshold_of(double tone, double count)
{
    double t = tone > 0.0 ? tone : 0.0;
    t = t < 1.0 ? t : 1.0;
    return (int32_t)(t * count + 0.5);
}

// ---------------------------------------------------------------------------------------------
// Making and freeing
// ---------------------------------------------------------------------------------------------

static void fill_row(sf_halftone *h, const sf_mask *mask, size_t row, const int32_t thresholds[256])
{
    for (size_t i = 0; i < h->row; i++) {
        int32_t rank = (int32_t)sfi_mask_at(mask, row * h->n[0] + i % h->n[0]);
        // The least byte of a threshold above the rank, by halving.
        unsigned low = 0, high = 255;
        while (high - low > 1) {
            unsigned middle = (low + high) / 2;
            if (thresholds[middle] > rank) {
                high = middle;
            } else {
                low = middle;
            }
        }
        h->bytes[row * h->row + i] = (uint8_t)high;
        h->numbers[row * h->row + i] = rank + 1;
    }
}

static void fill_levels(sf_halftone *h, const sf_mask *mask)
{
    int32_t thresholds[256];
    for (unsigned v = 0; v < 256; v++) {
        thresholds[v] = threshold_of(v / 255.0, (double)h->rank_count);
    }
    for (size_t row = 0; row < (size_t)h->n[1] * h->n[2]; row++) {
        fill_row(h, mask, row, thresholds);
    }
}

sf_status sf_halftone_create(const sf_mask *mask, uint32_t material_count,
                             const sf_allocator *allocator, sf_halftone **halftone)
{
    sf_allocator a = sfi_allocator_or_default(allocator);
    if (mask == NULL || halftone == NULL || material_count < 2 ||
        material_count > SF_MATERIAL_MAX) {
        return SF_ERR_ARGUMENT;
    }
    size_t wide = mask->n[0] > 64 ? mask->n[0] : 64, row, size;
    if (!sfi_size_add(wide, mask->n[0], &row) ||
        !sfi_size_mul(row, (size_t)mask->n[1] * mask->n[2], &size)) {
        return SF_ERR_OVERFLOW;
    }
    sf_halftone *h = sfi_alloc_array(&a, 1, sizeof *h);
    if (h == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(h, 0, sizeof *h);
    memcpy(h->n, mask->n, sizeof h->n);
    h->material_count = material_count;
    h->rank_count = sfi_mask_count(mask);
    h->turn = wide / 64;
    h->row = row;
    h->size = size;
    h->allocator = a;
    h->bytes = sfi_alloc_array(&a, size, sizeof *h->bytes);
    h->numbers = sfi_alloc_array(&a, size, sizeof *h->numbers);
    if (h->bytes == NULL || h->numbers == NULL) {
        sf_halftone_destroy(h);
        return SF_ERR_MEMORY;
    }
    fill_levels(h, mask);
    *halftone = h;
    return SF_OK;
}

void sf_halftone_destroy(sf_halftone *halftone)
{
    if (halftone != NULL) {
        sf_allocator a = halftone->allocator;
        sfi_free_array(&a, halftone->bytes, halftone->size, sizeof *halftone->bytes);
        sfi_free_array(&a, halftone->numbers, halftone->size, sizeof *halftone->numbers);
        sfi_free_array(&a, halftone, 1, sizeof *halftone);
    }
}

// ---------------------------------------------------------------------------------------------
// Slices
// ---------------------------------------------------------------------------------------------

typedef struct job {
    const sf_halftone *halftone;
    const sf_tones *tones;
    const sf_materials *materials;
    const sfi_kernels *kernels;
    size_t layer;    // where the levels of the layer begin,
    uint32_t across; // of its rows where the rectangle does,
    uint32_t down;   // and in which row
    int bad[SFI_BANDS];
    uint64_t counts[SFI_BANDS][SF_MATERIAL_MAX];
} job;

// Where the levels of a row begin.
static size_t first_level(const job *work, uint32_t y)
{
    return work->layer + (work->down + y) % work->halftone->n[1] * work->halftone->row +
           work->across;
}

// Bytes against levels, of which those past the end of a row are nobody's to read.
static void compare_bytes(const sfi_kernels *kernels, uint64_t *bits, const uint8_t *tones,
                          const uint8_t *levels, size_t turn, uint32_t count)
{
    uint8_t last[64] = {0};
    size_t whole = count / 64;
    if (whole > 0) {
        kernels->at_least_8(bits, tones, levels, turn, whole);
    }
    if (count % 64 != 0) {
        memcpy(last, tones + 64 * whole, count % 64);
        kernels->at_least_8(bits + whole, last, levels + 64 * (whole % turn), turn, 1);
    }
}

// below[j]: what lies below T_j, for voxels x to x + count of row y.
static void compare_stretch(const job *work, uint32_t x, uint32_t y, uint32_t count,
                            uint64_t below[][SFI_STRETCH_WORDS])
{
    const sf_halftone *h = work->halftone;
    const sf_tones *t = work->tones;
    size_t first = first_level(work, y), words = sfi_row_words(count);
    double sums[SFI_STRETCH] = {0};
    int32_t thresholds[SFI_STRETCH] = {0};
    for (uint32_t j = 0; j + 1 < h->material_count; j++) {
        sfi_tones_add(t, j, x, y, count, sums);
        for (uint32_t i = 0; i < count; i++) {
            thresholds[i] = threshold_of(sums[i], (double)h->rank_count);
        }
        work->kernels->at_least_32(below[j], thresholds, h->numbers + first, h->turn, words);
    }
}

static void compare_stretch_of_bytes(const job *work, uint32_t x, uint32_t y, uint32_t count,
                                     uint64_t below[][SFI_STRETCH_WORDS])
{
    const sf_halftone *h = work->halftone;
    size_t first = first_level(work, y);
    uint8_t sums[SFI_STRETCH] = {0};
    for (uint32_t j = 0; j + 1 < h->material_count; j++) {
        sfi_tones_add_bytes(work->tones, j, x, y, count, sums);
        compare_bytes(work->kernels, below[j], sums, h->bytes + first, h->turn, count);
    }
}

// What lies below each threshold becomes what lies between two, within the solid.
static void part(const sf_tones *t, uint32_t material_count, uint32_t y, size_t i, size_t count,
                 uint64_t words[][SFI_STRETCH_WORDS])
{
    for (size_t w = 0; w < count; w++) {
        uint64_t left = sfi_tones_solid(t, y, i + w);
        for (uint32_t j = 0; j + 1 < material_count; j++) {
            uint64_t here = words[j][w] & left;
            words[j][w] = here;
            left ^= here;
        }
        words[material_count - 1][w] = left;
    }
}

static void halftone_row(const job *work, uint32_t y, uint64_t *counts)
{
    const sf_tones *t = work->tones;
    uint64_t words[SF_MATERIAL_MAX][SFI_STRETCH_WORDS];
    for (uint32_t x = 0; x < t->width; x += SFI_STRETCH) {
        uint32_t count = t->width - x < SFI_STRETCH ? t->width - x : SFI_STRETCH;
        if (t->type == SF_TONE_U8) {
            compare_stretch_of_bytes(work, x, y, count, words);
        } else {
            compare_stretch(work, x, y, count, words);
        }
        part(t, work->halftone->material_count, y, x / 64, sfi_row_words(count), words);
        sfi_emit(t, work->materials, work->halftone->material_count, y, x / 64,
                 sfi_row_words(count), words, counts);
    }
}

// Bytes of two materials straight into the slice of the first: what the time of a large stack is.
static void halftone_row_of_bytes(const job *work, uint32_t y, uint64_t *counts)
{
    const sf_halftone *h = work->halftone;
    const sf_tones *t = work->tones;
    const sf_slice *slices = work->materials->slices;
    const uint8_t *tones = (const uint8_t *)t->planes[0].values + (size_t)y * t->planes[0].stride;
    uint64_t *first = sfi_slice_row(slices[0], y);
    size_t words = sfi_row_words(t->width);
    compare_bytes(work->kernels, first, tones, h->bytes + first_level(work, y), h->turn, t->width);
    if (t->solid.words != NULL) {
        work->kernels->and_words(first, first, sfi_slice_row(t->solid, y), words);
    }
    first[words - 1] &= sfi_tail_mask(t->width);
    if (slices[1].words != NULL || work->materials->counts != NULL) {
        uint64_t rest[SFI_STRETCH_WORDS];
        for (size_t i = 0; i < words; i += SFI_STRETCH_WORDS) {
            size_t count = words - i < SFI_STRETCH_WORDS ? words - i : SFI_STRETCH_WORDS;
            for (size_t w = 0; w < count; w++) {
                rest[w] = sfi_tones_solid(t, y, i + w) & ~first[i + w];
            }
            if (slices[1].words != NULL) {
                memcpy(sfi_slice_row(slices[1], y) + i, rest, 8 * count);
            }
            counts[0] += work->kernels->popcount(first + i, count);
            counts[1] += work->kernels->popcount(rest, count);
        }
    }
}

static void judge_band(void *context, size_t band)
{
    job *work = context;
    uint32_t height = work->tones->height;
    work->bad[band] = !sfi_tones_good(work->tones, work->halftone->material_count,
                                      sfi_band_row(height, band), sfi_band_row(height, band + 1));
}

static void halftone_band(void *context, size_t band)
{
    job *work = context;
    const sf_tones *t = work->tones;
    const sf_materials *m = work->materials;
    int plain = t->type == SF_TONE_U8 && work->halftone->material_count == 2 &&
                t->keep_out_count == 0 && m->ids == NULL && m->slices != NULL &&
                m->slices[0].words != NULL;
    uint64_t counts[SF_MATERIAL_MAX] = {0};
    for (uint32_t y = sfi_band_row(t->height, band); y < sfi_band_row(t->height, band + 1); y++) {
        if (plain) {
            halftone_row_of_bytes(work, y, counts);
        } else {
            halftone_row(work, y, counts);
        }
    }
    memcpy(work->counts[band], counts, sizeof counts);
}

sf_status sf_halftone_slice(const sf_halftone *halftone, const sf_tones *tones,
                            const sf_materials *materials, sf_task *task)
{
    if (halftone == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_tones_validate(tones, materials, halftone->material_count));
    if (sf_task_is_cancelled(task)) {
        return SF_ERR_CANCELLED;
    }
    job work = {.halftone = halftone,
                .tones = tones,
                .materials = materials,
                .kernels = sfi_kernels_get(),
                .layer = tones->layer % halftone->n[2] * halftone->n[1] * halftone->row,
                .across = tones->x0 % halftone->n[0],
                .down = tones->y0 % halftone->n[1]};
    if (tones->type != SF_TONE_U8 || halftone->material_count > 2) {
        sfi_task_for(task, SFI_BANDS, judge_band, &work);
        for (size_t band = 0; band < SFI_BANDS; band++) {
            if (work.bad[band]) {
                return SF_ERR_ARGUMENT;
            }
        }
    }
    sfi_task_for(task, SFI_BANDS, halftone_band, &work);
    for (uint32_t j = 0; materials->counts != NULL && j < halftone->material_count; j++) {
        materials->counts[j] = 0;
        for (size_t band = 0; band < SFI_BANDS; band++) {
            materials->counts[j] += work.counts[band][j];
        }
    }
    return SF_OK;
}
