// SPDX-License-Identifier: MIT
// Carving in the order of the distance to a plane, after the paper.
//
// With c the centre of mass and c* a base's target at its height, carving beyond the plane through
// c* that is perpendicular to g = c - c* can bring c closer; carving on this side of it only takes
// it away. So voxels are sorted by d = g . (r - c*), those with d > 0 are removed one by one, the
// farthest first, and the true energy, sum |c - c*|^2 over the bases, is followed through all of
// them: two that lie across from each other can mend together what each spoils. The best prefix is
// kept, and with the new c there is a new plane, until too little is removed. Several bases: the
// sum of their positive d.
//
// A round is one pass to find the largest d, one to write a record for each voxel, a radix sort on
// 32 bits of d, and a walk. The sort is stable and records are written in order, so equal voxels go
// in the order of layers, rows and x, and the result is the same everywhere. All is measured from
// the centre of mass at the round's beginning, where the sums are small; the next round starts from
// a body that was summed anew, so that rounding does not add up.
//
// Source: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand", SIGGRAPH 2013,
// section 4. The choice of the prefix by the half-spaces themselves is the library's own: the least
// energy lies on the border of what is safe, and as often just outside as inside.

#include "balance/carve/plane.h"

#include "balance/wall/levels.h"
#include "base/bits.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "voxel/slice.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define LEAST_SHARE 1000 // a round that removes less than one part in so many is the last
#define INSIDE 1e-11     // of the lattice's length: what a safe prefix has to spare for rounding
#define STEPS_AT_ONCE 65536

// A voxel that may be removed. The key falls as d grows.
typedef struct candidate {
    uint32_t key, k;
    uint16_t x, y;
} candidate;

// A base as a round sees it: everything relative to the centre of mass at its beginning.
typedef struct aim {
    double across[2][3];
    double target[2];           // in the directions across
    double gradient[3], offset; // d = gradient . r - offset
} aim;

typedef struct carver {
    const sfi_carving *task;
    sf_grid *made;
    sf_body body; // of what is made
    double com[3];
    aim *aims;
    double *scratch; // for targets
    size_t scratch_count;
    double *levels; // bottoms of the layers, and the top
    candidate *records, *spare;
    size_t capacity, count;
    double largest; // d
    double reach;   // length of the lattice's diagonal
    sfi_progress progress;
} carver;

// ---------------------------------------------------------------------------------------------
// Aiming
// ---------------------------------------------------------------------------------------------

static void take_aim(carver *c)
{
    const sfi_carving *t = c->task;
    sfi_target which =
        t->options->goal == SF_CARVE_DEEPEST ? SFI_TARGET_DEEPEST : SFI_TARGET_NEAREST;
    for (size_t i = 0; i < t->base_count; i++) {
        aim *a = &c->aims[i];
        sfi_base_across(&t->bases[i], a->across);
        sfi_offset to = sfi_base_target(&t->bases[i], c->com, which, c->reach, c->scratch);
        memcpy(a->target, to.along, sizeof a->target);
        a->offset = 0;
        for (int j = 0; j < 3; j++) {
            a->gradient[j] = -(a->target[0] * a->across[0][j] + a->target[1] * a->across[1][j]);
        }
        a->offset = -(a->target[0] * a->target[0] + a->target[1] * a->target[1]);
    }
}

// Sum of the squared distances from a place, relative to the round's centre of mass, to the
// targets.
static double energy(const carver *c, const double at[3])
{
    double sum = 0;
    for (size_t i = 0; i < c->task->base_count; i++) {
        const aim *a = &c->aims[i];
        for (int j = 0; j < 2; j++) {
            const double *e = a->across[j];
            double d = e[0] * at[0] + e[1] * at[1] + e[2] * at[2] - a->target[j];
            sum += d * d;
        }
    }
    return sum;
}

static double slack(const carver *c, const double at[3])
{
    double place[3] = {c->com[0] + at[0], c->com[1] + at[1], c->com[2] + at[2]};
    return sfi_bases_slack(c->task->bases, c->task->base_count, place);
}

// ---------------------------------------------------------------------------------------------
// Sorting
// ---------------------------------------------------------------------------------------------

// Where a voxel lies, relative to the centre of mass.
static void locate(const carver *c, uint32_t x, uint32_t y, uint32_t k, double at[3])
{
    const sf_lattice *l = &c->task->lattice;
    at[0] = l->origin_mm[0] + (x + 0.5) * l->pitch_x_mm - c->com[0];
    at[1] = l->origin_mm[1] + (y + 0.5) * l->pitch_y_mm - c->com[1];
    at[2] = 0.5 * (c->levels[k] + c->levels[k + 1]) - c->com[2];
}

static double depth(const carver *c, const double at[3])
{
    double sum = 0;
    for (size_t i = 0; i < c->task->base_count; i++) {
        const aim *a = &c->aims[i];
        double d =
            a->gradient[0] * at[0] + a->gradient[1] * at[1] + a->gradient[2] * at[2] - a->offset;
        sum += d > 0 ? d : 0;
    }
    return sum;
}

static uint64_t free_word(const carver *c, uint32_t k, uint32_t y, size_t i)
{
    sf_slice made = sf_grid_slice(c->made, k), needed = sf_grid_slice(c->task->needed, k);
    return sfi_row_word(sfi_slice_row(made, y), i, made.width) &
           ~sfi_row_word(sfi_slice_row(needed, y), i, made.width);
}

// First pass: how many voxels lie beyond the planes, and the largest d. Second pass, with records
// to write to: their keys.
static void visit_layer(carver *c, uint32_t k, int second)
{
    const sf_lattice *l = &c->task->lattice;
    for (uint32_t y = 0; y < l->ny; y++) {
        for (size_t i = 0; i < sfi_row_words(l->nx); i++) {
            for (uint64_t word = free_word(c, k, y, i); word != 0; word &= word - 1) {
                uint32_t x = (uint32_t)(64 * i) + sfi_lowest_bit(word);
                double at[3];
                locate(c, x, y, k, at);
                double d = depth(c, at);
                if (!(d > 0)) {
                    continue;
                }
                if (second) {
                    // Rounded to the nearest, so that what ties with the largest does tie.
                    uint32_t key = ~(uint32_t)(d / c->largest * 4294967294.0 + 0.5);
                    candidate made = {key, k, (uint16_t)x, (uint16_t)y};
                    c->records[c->count] = made;
                }
                c->largest = d > c->largest ? d : c->largest;
                c->count++;
            }
        }
    }
}

static sf_status visit(carver *c, int second)
{
    c->count = 0;
    for (uint32_t k = 0; k < c->task->lattice.nz; k++) {
        if (sf_task_is_cancelled(c->task->task)) {
            return SF_ERR_CANCELLED;
        }
        visit_layer(c, k, second);
    }
    return SF_OK;
}

// One pass of a radix sort, stable, by 11 bits from `shift` on.
static void sort_pass(const candidate *from, candidate *to, size_t count, unsigned shift)
{
    size_t place[2049] = {0};
    for (size_t i = 0; i < count; i++) {
        place[(from[i].key >> shift & 2047) + 1]++;
    }
    for (size_t b = 0; b < 2048; b++) {
        place[b + 1] += place[b];
    }
    for (size_t i = 0; i < count; i++) {
        to[place[from[i].key >> shift & 2047]++] = from[i];
    }
}

static sf_status collect(carver *c)
{
    const sf_allocator *a = &c->task->allocator;
    c->largest = 0;
    SF_TRY(visit(c, 0));
    if (c->count == 0) {
        return SF_OK;
    }
    if (c->count > c->capacity) { // the first round has the most, but for what the planes cut off
        sfi_free_array(a, c->records, c->capacity, 2 * sizeof *c->records);
        c->capacity = c->count;
        c->records = sfi_alloc_array(a, c->capacity, 2 * sizeof *c->records);
        if (c->records == NULL) {
            return SF_ERR_MEMORY;
        }
        c->spare = c->records + c->capacity;
    }
    SF_TRY(visit(c, 1));
    sort_pass(c->records, c->spare, c->count, 0);
    sort_pass(c->spare, c->records, c->count, 11);
    sort_pass(c->records, c->spare, c->count, 22);
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Walking
// ---------------------------------------------------------------------------------------------

static double weigh(const carver *c, const candidate *v)
{
    const sf_lattice *l = &c->task->lattice;
    const float *density = c->task->options->density;
    double volume = l->pitch_x_mm * l->pitch_y_mm * (c->levels[v->k + 1] - c->levels[v->k]);
    size_t i = ((size_t)v->k * l->ny + v->y) * l->nx + v->x;
    return density == NULL ? volume : volume * density[i];
}

// How many of the sorted voxels make the best prefix.
static sf_status best_prefix(const carver *c, size_t *best)
{
    sf_carve_goal goal = c->task->options->goal;
    double at[3] = {0, 0, 0}, moment[3] = {0, 0, 0}, mass = c->body.mass;
    double least = goal == SF_CARVE_DEEPEST ? -slack(c, at) : energy(c, at);
    *best = 0;
    for (size_t i = 0; i < c->count; i++) {
        const candidate *v = &c->spare[i];
        double r[3], m = weigh(c, v);
        if (i % STEPS_AT_ONCE == 0 && sf_task_is_cancelled(c->task->task)) {
            return SF_ERR_CANCELLED;
        }
        mass -= m;
        if (!(mass > 1e-9 * c->body.mass)) {
            break; // what is left weighs nothing, and lies nowhere
        }
        locate(c, v->x, v->y, v->k, r);
        for (int j = 0; j < 3; j++) {
            moment[j] -= m * r[j];
            at[j] = moment[j] / mass;
        }
        if (goal == SF_CARVE_ENOUGH && slack(c, at) >= INSIDE * c->reach) {
            *best = i + 1;
            break;
        }
        double here = goal == SF_CARVE_DEEPEST ? -slack(c, at) : energy(c, at);
        if (here < least) {
            least = here;
            *best = i + 1;
        }
    }
    return SF_OK;
}

static void take_out(const carver *c, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const candidate *v = &c->spare[i];
        sf_slice slice = sf_grid_slice(c->made, v->k);
        sfi_slice_row(slice, v->y)[v->x / 64] &= ~(UINT64_C(1) << (v->x % 64));
    }
}

// What is made, summed anew.
static sf_status weigh_all(carver *c)
{
    SF_TRY(sf_grid_body(c->made, c->task->options->density, NULL, &c->body));
    c->body = sf_body_add(c->body, 1, c->task->options->rest);
    return sf_body_com(c->body, c->com);
}

static sf_status carve(carver *c, uint32_t *rounds)
{
    const double here[3] = {0, 0, 0};
    size_t first_count = 0;
    *rounds = 0;
    for (uint32_t round = 0; round < c->task->options->rounds_max; round++) {
        size_t taken = 0;
        SF_TRY(weigh_all(c));
        if (c->task->options->goal == SF_CARVE_ENOUGH && slack(c, here) >= 0) {
            break;
        }
        take_aim(c);
        SF_TRY(collect(c));
        first_count = first_count == 0 ? c->count : first_count;
        SF_TRY(best_prefix(c, &taken));
        take_out(c, taken);
        *rounds += taken > 0;
        sfi_progress_report(&c->progress, round + 1, c->task->options->rounds_max);
        if (taken == 0 || taken < first_count / LEAST_SHARE) {
            break;
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

static sf_status create(carver *c, const sfi_carving *task, sf_grid *made)
{
    size_t most = 0;
    memset(c, 0, sizeof *c);
    c->task = task;
    c->made = made;
    c->progress = sfi_progress_begin(task->task);
    for (size_t i = 0; i < task->base_count; i++) {
        most = task->bases[i].count > most ? task->bases[i].count : most;
    }
    c->scratch_count = sfi_base_scratch(most);
    c->aims = sfi_alloc_array(&task->allocator, task->base_count, sizeof *c->aims);
    c->scratch = sfi_alloc_array(&task->allocator, c->scratch_count, sizeof *c->scratch);
    c->levels = sfi_levels_create(&task->lattice, &task->allocator);
    if (c->aims == NULL || c->scratch == NULL || c->levels == NULL) {
        return SF_ERR_MEMORY;
    }
    c->reach = sfi_levels_diagonal(&task->lattice, c->levels);
    return SF_OK;
}

static void destroy(carver *c)
{
    const sf_allocator *a = &c->task->allocator;
    sfi_free_array(a, c->aims, c->task->base_count, sizeof *c->aims);
    sfi_free_array(a, c->scratch, c->scratch_count, sizeof *c->scratch);
    sfi_levels_destroy(c->levels, &c->task->lattice, a);
    sfi_free_array(a, c->records, c->capacity, 2 * sizeof *c->records);
}

sf_status sfi_carve_plane(const sfi_carving *carving, sf_grid *made, uint32_t *rounds)
{
    carver c;
    *rounds = 0;
    if (carving->base_count == 0) {
        return SF_OK;
    }
    sf_status status = create(&c, carving, made);
    if (status == SF_OK) {
        status = carve(&c, rounds);
    }
    destroy(&c);
    return status;
}
