// SPDX-License-Identifier: MIT
// Masks: blocks of ranks, made or given.
//
// A period along x is a power of two, so that every 64 voxels of a row, which become a word, meet
// the same levels or those of a few words: a comparison then runs over plain arrays. Ranks are kept
// in 16 bits where they fit, which those of 32^3 voxels do with a bit to spare.

#include "grade/tone/mask.h"

#include "base/memory.h"
#include "base/status.h"
#include "grade/tone/void_cluster.h"

#include <string.h>

#define PERIOD_MAX 256u
#define PITCH_RATIO 64.0

sf_mask_options sf_mask_options_default(void)
{
    sf_mask_options options = {.struct_size = sizeof options,
                               .kind = SF_MASK_SLICE,
                               .nx = 32,
                               .ny = 32,
                               .nz = 32,
                               .pitch_mm = {1.0, 1.0, 1.0},
                               .spread = 1.5,
                               .seed = 0};
    return options;
}

static sf_status check_period(uint32_t nx, uint32_t ny, uint32_t nz)
{
    if (nx < 4 || nx > PERIOD_MAX || (nx & (nx - 1)) != 0 || ny < 1 || ny > PERIOD_MAX || nz < 1 ||
        nz > PERIOD_MAX) {
        return SF_ERR_ARGUMENT;
    }
    return nx * ny * nz <= SF_MASK_SIZE_MAX ? SF_OK : SF_ERR_OVERFLOW;
}

static sf_status check_options(const sf_mask_options *o)
{
    if (o->struct_size < sizeof *o || (o->kind != SF_MASK_SLICE && o->kind != SF_MASK_ISOTROPIC) ||
        !(o->spread >= 0.5 && o->spread <= 4.0)) {
        return SF_ERR_ARGUMENT;
    }
    for (int n = 0; n < 3; n++) {
        if (!(o->pitch_mm[n] > 1e-12 && o->pitch_mm[n] < 1e12)) {
            return SF_ERR_ARGUMENT;
        }
    }
    for (int n = 0; n < 3; n++) {
        if (o->pitch_mm[n] > PITCH_RATIO * o->pitch_mm[(n + 1) % 3] ||
            o->pitch_mm[n] > PITCH_RATIO * o->pitch_mm[(n + 2) % 3]) {
            return SF_ERR_ARGUMENT;
        }
    }
    return check_period(o->nx, o->ny, o->nz);
}

// A mask whose ranks are yet to be filled in: 32 bits each, at `owned`.
static sf_mask *mask_allocate(const uint32_t n[3], const sf_allocator *allocator)
{
    size_t count = (size_t)n[0] * n[1] * n[2];
    size_t width = count <= 65536 ? sizeof(uint16_t) : sizeof(uint32_t);
    sf_mask *mask = sfi_alloc_array(allocator, 1, sizeof *mask);
    if (mask == NULL) {
        return NULL;
    }
    memset(mask, 0, sizeof *mask);
    mask->owned = sfi_alloc_array(allocator, count, width);
    if (mask->owned == NULL) {
        sfi_free_array(allocator, mask, 1, sizeof *mask);
        return NULL;
    }
    memcpy(mask->n, n, sizeof mask->n);
    mask->owned_size = count * width;
    mask->allocator = *allocator;
    return mask;
}

static void mask_fill(sf_mask *mask, const uint32_t *ranks)
{
    uint32_t count = sfi_mask_count(mask);
    if (count > 65536) {
        memcpy(mask->owned, ranks, mask->owned_size);
        mask->large = mask->owned;
        return;
    }
    uint16_t *small = mask->owned;
    for (uint32_t i = 0; i < count; i++) {
        small[i] = (uint16_t)ranks[i];
    }
    mask->small = small;
}

sf_status sf_mask_create(const sf_mask_options *options, const sf_allocator *allocator,
                         sf_task *task, sf_mask **mask)
{
    sf_mask_options o = options != NULL ? *options : sf_mask_options_default();
    sf_allocator a = sfi_allocator_or_default(allocator);
    if (mask == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(check_options(&o));
    const uint32_t n[3] = {o.nx, o.ny, o.nz};
    size_t count = (size_t)o.nx * o.ny * o.nz;
    uint32_t *ranks = sfi_alloc_array(&a, count, sizeof *ranks);
    if (ranks == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = sfi_void_and_cluster(&o, &a, task, ranks);
    if (status == SF_OK) {
        sf_mask *made = mask_allocate(n, &a);
        status = made != NULL ? SF_OK : SF_ERR_MEMORY;
        if (made != NULL) {
            mask_fill(made, ranks);
            *mask = made;
        }
    }
    sfi_free_array(&a, ranks, count, sizeof *ranks);
    return status;
}

// Whether each rank occurs once: `seen` has a bit for each.
static int is_permutation(const uint32_t *ranks, size_t count, uint64_t *seen)
{
    memset(seen, 0, (count + 63) / 64 * sizeof *seen);
    for (size_t i = 0; i < count; i++) {
        if (ranks[i] >= count || (seen[ranks[i] / 64] >> ranks[i] % 64 & 1) != 0) {
            return 0;
        }
        seen[ranks[i] / 64] |= UINT64_C(1) << ranks[i] % 64;
    }
    return 1;
}

sf_status sf_mask_from_ranks(uint32_t nx, uint32_t ny, uint32_t nz, const uint32_t *ranks,
                             const sf_allocator *allocator, sf_mask **mask)
{
    sf_allocator a = sfi_allocator_or_default(allocator);
    if (ranks == NULL || mask == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(check_period(nx, ny, nz));
    const uint32_t n[3] = {nx, ny, nz};
    size_t count = (size_t)nx * ny * nz, words = (count + 63) / 64;
    uint64_t *seen = sfi_alloc_array(&a, words, sizeof *seen);
    if (seen == NULL) {
        return SF_ERR_MEMORY;
    }
    int good = is_permutation(ranks, count, seen);
    sfi_free_array(&a, seen, words, sizeof *seen);
    if (!good) {
        return SF_ERR_FORMAT;
    }
    sf_mask *made = mask_allocate(n, &a);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    mask_fill(made, ranks);
    *mask = made;
    return SF_OK;
}

void sf_mask_destroy(sf_mask *mask)
{
    if (mask == NULL || mask->owned == NULL) {
        return;
    }
    sf_allocator a = mask->allocator;
    sfi_free_array(&a, mask->owned, mask->owned_size, 1);
    sfi_free_array(&a, mask, 1, sizeof *mask);
}

void sf_mask_size(const sf_mask *mask, uint32_t size[3])
{
    for (int n = 0; n < 3; n++) {
        size[n] = mask != NULL ? mask->n[n] : 0;
    }
}

uint32_t sf_mask_rank(const sf_mask *mask, uint32_t x, uint32_t y, uint32_t z)
{
    if (mask == NULL) {
        return 0;
    }
    size_t row = (size_t)(z % mask->n[2]) * mask->n[1] + y % mask->n[1];
    return sfi_mask_at(mask, row * mask->n[0] + x % mask->n[0]);
}
