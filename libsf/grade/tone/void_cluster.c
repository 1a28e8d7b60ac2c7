// SPDX-License-Identifier: MIT
// Void and cluster on a torus.
//
// The energy of a voxel is the sum of the pushes that it gets from the voxels that are set. The
// tightest cluster is the set voxel of the most energy, the largest void the unset one of the
// least.
//
//   1. Set a tenth of the voxels at random. Take the tightest cluster out and set the largest void,
//      until these are one.
//   2. From that pattern take out tightest clusters, one after the other: they get the ranks below
//      its number, from the top down.
//   3. From that pattern again, set largest voids, until all are set: they get the ranks above.
//
// Ulichney's third phase, from half on, looks for the tightest cluster of unset voxels by the
// energy that these give each other. All pushes that a voxel gets add up to one sum, so that energy
// is the sum less the other: it is the same voxel, and phases two and three of his are one here.
//
// Equal energies are told apart by the place of a voxel in a random order, of which the first tenth
// is what is set at the start. Between clusters the last place wins, between voids the first. So
// phase 1 ends: a step lowers the energy of the set voxels among each other, or leaves it and
// lowers the sum of their places.
//
// Source: R. Ulichney, "The void-and-cluster method for dither array generation", 1993.

#include "grade/tone/void_cluster.h"

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "grade/tone/tournament.h"

#include <string.h>

// Places take the low bits of a key, energies those above.
#define PLACE_BITS 24
#define PLACE_MASK ((UINT64_C(1) << PLACE_BITS) - 1)
// Voxels between two looks at the task.
enum { STRETCH = 1024 };

typedef struct pattern {
    uint32_t n[3];
    uint32_t count; // voxels
    sfi_spread spread;
    uint32_t *energy;
    uint32_t *place; // in the random order
    uint8_t *set;
    sfi_tournament voids, clusters;
} pattern;

static void pattern_destroy(pattern *p, const sf_allocator *allocator)
{
    sfi_spread_destroy(&p->spread, allocator);
    sfi_free_array(allocator, p->energy, p->count, sizeof *p->energy);
    sfi_free_array(allocator, p->place, p->count, sizeof *p->place);
    sfi_free_array(allocator, p->set, p->count, sizeof *p->set);
    sfi_tournament_destroy(&p->voids, allocator);
    sfi_tournament_destroy(&p->clusters, allocator);
}

static sf_status pattern_allocate(pattern *p, const sf_mask_options *options,
                                  const sf_allocator *allocator)
{
    SF_TRY(sfi_spread_create(options, allocator, &p->spread));
    p->energy = sfi_alloc_array(allocator, p->count, sizeof *p->energy);
    p->place = sfi_alloc_array(allocator, p->count, sizeof *p->place);
    p->set = sfi_alloc_array(allocator, p->count, sizeof *p->set);
    if (p->energy == NULL || p->place == NULL || p->set == NULL) {
        return SF_ERR_MEMORY;
    }
    SF_TRY(sfi_tournament_create(&p->voids, p->count, allocator));
    return sfi_tournament_create(&p->clusters, p->count, allocator);
}

// G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", 2014.
static uint64_t next_random(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

// R. Durstenfeld, "Algorithm 235: Random permutation", 1964.
static void shuffle(uint32_t *place, uint32_t count, uint64_t seed)
{
    for (uint32_t i = 0; i < count; i++) {
        place[i] = i;
    }
    for (uint32_t i = count; i > 1; i--) {
        uint32_t j = (uint32_t)(next_random(&seed) % i), kept = place[j];
        place[j] = place[i - 1];
        place[i - 1] = kept;
    }
}

// Enter a voxel among the voids or the clusters, by what it is.
static void enter(pattern *p, uint32_t v)
{
    uint64_t key = (uint64_t)p->energy[v] << PLACE_BITS | p->place[v];
    uint64_t top = (UINT64_C(1) << (32 + PLACE_BITS)) - 1;
    sfi_tournament_set(&p->voids, v, p->set[v] ? SFI_NO_KEY : key);
    sfi_tournament_set(&p->clusters, v, p->set[v] ? top - key : SFI_NO_KEY);
}

static uint32_t wrapped(uint32_t at, uint32_t by, uint32_t period)
{
    uint32_t sum = at + by;
    return sum < period ? sum : sum - period;
}

// Set an unset voxel, or the other way round.
static void toggle(pattern *p, uint32_t v)
{
    uint32_t x = v % p->n[0], y = v / p->n[0] % p->n[1], z = v / p->n[0] / p->n[1];
    p->set[v] ^= 1;
    for (size_t i = 0; i < p->spread.count; i++) {
        const sfi_push *push = &p->spread.pushes[i];
        uint32_t row = wrapped(z, push->dz, p->n[2]) * p->n[1] + wrapped(y, push->dy, p->n[1]);
        uint32_t u = row * p->n[0] + wrapped(x, push->dx, p->n[0]);
        p->energy[u] += p->set[v] ? push->weight : 0 - push->weight;
        enter(p, u); // and v itself, which every spread holds
    }
}

// Phase 1. Returns how many are set.
static sf_status spread_out(pattern *p, sf_task *task, uint32_t *ones)
{
    *ones = p->count / 10 > 0 ? p->count / 10 : 1;
    for (uint32_t v = 0; v < p->count; v++) {
        enter(p, v);
    }
    for (uint32_t v = 0; v < p->count; v++) {
        if (p->place[v] < *ones) {
            toggle(p, v);
        }
    }
    for (uint64_t step = 0;; step++) {
        if (step % STRETCH == 0 && sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        uint32_t out = sfi_tournament_least(&p->clusters);
        toggle(p, out);
        uint32_t in = sfi_tournament_least(&p->voids);
        toggle(p, in);
        if (in == out) {
            return SF_OK;
        }
    }
}

// Phases 2 and 3.
static sf_status rank_all(pattern *p, uint32_t ones, sf_task *task, uint32_t *ranks)
{
    sfi_progress progress = sfi_progress_begin(task);
    for (uint32_t r = ones; r-- > 0;) {
        uint32_t v = sfi_tournament_least(&p->clusters);
        ranks[v] = r;
        toggle(p, v);
    }
    for (uint32_t v = 0; v < p->count; v++) {
        if (ranks[v] < ones) {
            toggle(p, v);
        }
    }
    for (uint32_t r = ones; r < p->count; r++) {
        if (r % STRETCH == 0) {
            if (sf_task_is_cancelled(task)) {
                return SF_ERR_CANCELLED;
            }
            sfi_progress_report(&progress, r, p->count);
        }
        uint32_t v = sfi_tournament_least(&p->voids);
        ranks[v] = r;
        toggle(p, v);
    }
    sfi_progress_report(&progress, 1, 1);
    return SF_OK;
}

sf_status sfi_void_and_cluster(const sf_mask_options *options, const sf_allocator *allocator,
                               sf_task *task, uint32_t *ranks)
{
    pattern p;
    memset(&p, 0, sizeof p);
    p.n[0] = options->nx;
    p.n[1] = options->ny;
    p.n[2] = options->nz;
    p.count = options->nx * options->ny * options->nz;
    sf_status status = pattern_allocate(&p, options, allocator);
    if (status == SF_OK) {
        uint32_t ones;
        memset(p.energy, 0, p.count * sizeof *p.energy);
        memset(p.set, 0, p.count);
        memset(ranks, 0xff, p.count * sizeof *ranks);
        shuffle(p.place, p.count, options->seed);
        status = spread_out(&p, task, &ones);
        if (status == SF_OK) {
            status = rank_all(&p, ones, task, ranks);
        }
    }
    pattern_destroy(&p, allocator);
    return status;
}
