// SPDX-License-Identifier: MIT
// Bridged: what a repair gains when gaps may be spanned.
//
// It begins with a result whose additions stand by the plain rule (repair.c). Under the full rule
//
//   - more of what was drawn may be carried: the trim of R and V, put back whole;
//   - an addition may be needless: it goes if the shape stands without it. From the top down, so
//   that
//     the chain below a voxel that a bridge holds goes with it; all of a layer at once if that will
//     do, else by halves;
//   - a beam may be cheaper than a pillar: for an addition, the gap around it along one of four
//     directions, between two ends of one layer, is filled, and what then is needless below it
//     goes. Kept only where the total falls.
//
// Whether the shape stands is asked of the rule itself (carry.c): of two layers, the one that was
// changed and the next, or under slack of all. That is exact for any rule, and slow; so there is a
// budget, in voxels that are looked at, that small shapes never use up. Large ones are then left as
// good as they are.
//
// Where nothing was found without bridges, because what must stay needs one in matter that is only
// allowed, it begins with all that is allowed. Every such R lies in the room, so this finds one
// whenever there is one.

#include "support/repair/bridged.h"

#include "base/memory.h"
#include "base/status.h"
#include "support/check/row.h"
#include "support/repair/improve.h"
#include "support/rule/carry.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

#define BUDGET (INT64_C(1) << 30)

typedef struct place {
    uint32_t k, x, y;
} place;

typedef struct probe {
    const sfi_job *job;
    const sf_terms *full;
    const sf_grid *room;
    sf_grid *result;
    sfi_carrier carrier;
    sfi_front fronts[2];
    int64_t budget;
    sfi_sweep sweep;
    place *places; // additions of a layer, or what a beam has changed
    size_t count, capacity;
} probe;

// ---------------------------------------------------------------------------------------------
// Does it stand
// ---------------------------------------------------------------------------------------------

// Carry layer k and see whether all of it is alive.
static int layer_stands(probe *p, uint32_t k)
{
    sf_slice solid = sf_grid_slice(p->result, k);
    sfi_front below = p->fronts[(k + 1) % 2], front = p->fronts[k % 2];
    p->budget -= (int64_t)solid.width * solid.height;
    return sfi_carry_layer(&p->carrier, k, p->job->bed, &below, solid,
                           sfi_mask_slice(p->full->exempt, k), front, SFI_NO_SLICE) == SF_OK &&
           sf_slice_equal(front.alive, solid);
}

// Whether the result stands after a change of layer k. A cancel uses the budget up, and is found
// out about before the next layer, or by the last trim.
static int stands(probe *p, uint32_t k)
{
    uint32_t top = p->job->lattice.nz, from = k, to = top - k > 2 ? k + 2 : top;
    if (sfi_sweep_pause(&p->sweep) != SF_OK) {
        p->budget = 0;
        return 0;
    }
    if (p->job->rule.kind == SF_RULE_SLACK) {
        from = p->job->bed;
        to = top;
    } else if (k > p->job->bed) {
        (void)!sf_slice_copy(p->fronts[(k + 1) % 2].alive, sf_grid_slice(p->result, k - 1));
    }
    for (uint32_t i = from; i < to; i++) {
        if (!layer_stands(p, i)) {
            return 0;
        }
    }
    return 1;
}

static int is_set(const sf_grid *grid, uint32_t k, int64_t x, int64_t y)
{
    return x >= 0 && y >= 0 && sf_slice_get(sf_grid_slice(grid, k), (uint32_t)x, (uint32_t)y);
}

static void flip(const probe *p, const place *at)
{
    sfi_slice_row(sf_grid_slice(p->result, at->k), at->y)[at->x / 64] ^= UINT64_C(1)
                                                                         << (at->x % 64);
}

static sf_status note(probe *p, uint32_t k, uint32_t x, uint32_t y)
{
    void *memory = p->places;
    int good =
        sfi_grow_array(p->job->allocator, &memory, &p->capacity, p->count + 1, sizeof *p->places);
    p->places = memory;
    if (good) {
        place at = {k, x, y};
        p->places[p->count++] = at;
    }
    return good ? SF_OK : SF_ERR_MEMORY;
}

// places = the additions of layer k.
static sf_status find_additions(probe *p, uint32_t k)
{
    sf_slice slice = sf_grid_slice(p->result, k), drawn = sf_grid_slice(p->job->drawn, k);
    p->count = 0;
    for (uint32_t y = 0; y < slice.height; y++) {
        const uint64_t *row = sfi_slice_row(slice, y), *given = sfi_slice_row(drawn, y);
        for (size_t i = 0; i < sfi_row_words(slice.width); i++) {
            for (uint64_t w = row[i] & ~given[i]; w != 0; w &= w - 1) {
                SF_TRY(note(p, k, (uint32_t)i * 64 + sfi_lowest_bit(w), y));
            }
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Taking away
// ---------------------------------------------------------------------------------------------

static void flip_all(const probe *p, size_t from, size_t to)
{
    for (size_t i = from; i < to; i++) {
        flip(p, &p->places[i]);
    }
}

// Take away what can be of the noted additions of layer k, by halves.
static void thin_places(probe *p, uint32_t k)
{
    size_t ends[66], depth = 1, from = 0; // ranges still to do lie one after the other
    ends[0] = p->count;
    while (depth > 0 && p->budget > 0) {
        size_t to = ends[depth - 1];
        flip_all(p, from, to);
        if (from == to || stands(p, k)) {
            from = to;
            depth--;
            continue;
        }
        flip_all(p, from, to);
        if (to - from == 1) {
            from = to;
            depth--;
        } else {
            ends[depth++] = from + (to - from) / 2;
        }
    }
}

static sf_status thin(probe *p)
{
    p->sweep = sfi_sweep_begin(p->job->pace, p->job->lattice.nz - p->job->bed);
    for (uint32_t k = p->job->lattice.nz; k-- > p->job->bed && p->budget > 0;) {
        SF_TRY(sfi_sweep_layer(&p->sweep));
        SF_TRY(find_additions(p, k));
        if (p->count > 0) {
            thin_places(p, k);
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Beams
// ---------------------------------------------------------------------------------------------

// Fill the gap around an addition along a direction. Returns 0, with nothing changed, where there
// is no gap of at most `span` between two ends.
static sf_status add_beam(probe *p, const place *at, int dx, int dy, uint32_t span, int *is_there)
{
    int64_t from = -1, to = 1;
    *is_there = 0;
    while (-from <= span && !is_set(p->result, at->k, at->x + from * dx, at->y + from * dy)) {
        from--;
    }
    while (to <= span && !is_set(p->result, at->k, at->x + to * dx, at->y + to * dy)) {
        to++;
    }
    if (to - from - 1 > span || !is_set(p->result, at->k, at->x + from * dx, at->y + from * dy) ||
        !is_set(p->result, at->k, at->x + to * dx, at->y + to * dy)) {
        return SF_OK;
    }
    p->count = 0;
    for (int64_t i = from + 1; i < to; i++) {
        int64_t x = at->x + i * dx, y = at->y + i * dy;
        if (i != 0 && !is_set(p->room, at->k, x, y)) {
            p->count = 0;
            return SF_OK;
        }
        if (i != 0) {
            SF_TRY(note(p, at->k, (uint32_t)x, (uint32_t)y));
        }
    }
    flip_all(p, 0, p->count);
    *is_there = 1;
    return SF_OK;
}

// Take away additions below `above` that are needless now, and note them.
static sf_status thin_below(probe *p, const place *above)
{
    const sfi_job *job = p->job;
    sf_element e;
    if (above->k <= job->bed) {
        return SF_OK;
    }
    SF_TRY(sf_rule_element(&job->rule, above->k - 1, &e));
    for (int dy = -(int)e.reach_y; dy <= (int)e.reach_y; dy++) {
        int w = e.half_width[dy < 0 ? -dy : dy];
        for (int dx = -w; dx <= w && p->budget > 0; dx++) {
            int64_t x = (int64_t)above->x + dx, y = (int64_t)above->y + dy;
            if (!is_set(p->result, above->k - 1, x, y) || is_set(job->drawn, above->k - 1, x, y)) {
                continue;
            }
            place below = {above->k - 1, (uint32_t)x, (uint32_t)y};
            flip(p, &below);
            if (stands(p, below.k)) {
                SF_TRY(note(p, below.k, below.x, below.y));
            } else {
                flip(p, &below);
            }
        }
    }
    return SF_OK;
}

// What the noted changes cost, all told.
static int64_t cost_of_changes(const probe *p)
{
    int64_t cost = 0;
    for (size_t i = 0; i < p->count; i++) {
        const place *at = &p->places[i];
        int64_t one = sfi_job_add(p->job, at->k, at->x, at->y);
        cost += is_set(p->result, at->k, at->x, at->y) ? one : -one;
    }
    return cost;
}

// Try a beam through an addition along a direction. Returns whether it was kept.
static sf_status try_beam(probe *p, const place *at, int dx, int dy, uint32_t span, int *is_kept)
{
    SF_TRY(add_beam(p, at, dx, dy, span, is_kept));
    if (!*is_kept) {
        return SF_OK;
    }
    size_t beam = p->count;
    // What carried the voxel itself and the beam is asked first, then what carried that.
    SF_TRY(thin_below(p, at));
    for (size_t i = beam; i < p->count; i++) {
        place next = p->places[i];
        SF_TRY(thin_below(p, &next));
    }
    if (cost_of_changes(p) >= 0 || p->budget <= 0) {
        flip_all(p, 0, p->count);
        *is_kept = 0;
    }
    return SF_OK;
}

static sf_status try_beams(probe *p, const place *at)
{
    const sf_bridge *b = &p->full->rule.bridge;
    const int directions[4][2] = {{1, 0}, {0, 1}, {1, 1}, {-1, 1}};
    const uint32_t spans[4] = {b->span_x, b->span_y, b->span_diagonal, b->span_diagonal};
    uint32_t height = at->k - p->job->bed;
    for (int i = 0; i < 4 && p->budget > 0; i++) {
        int is_kept = 0;
        // A beam longer than what hangs on it could save is not worth asking, nor one that a budget
        // for two layers a voxel would not try to the end.
        uint32_t span = spans[i] < 4 * height + 4 ? spans[i] : 4 * height + 4;
        if (span > 0) {
            SF_TRY(try_beam(p, at, directions[i][0], directions[i][1], span, &is_kept));
        }
        if (is_kept) {
            break;
        }
    }
    return SF_OK;
}

static sf_status beams(probe *p)
{
    p->sweep = sfi_sweep_begin(p->job->pace, p->job->lattice.nz - p->job->bed);
    for (uint32_t k = p->job->lattice.nz; k-- > p->job->bed + 1 && p->budget > 0;) {
        SF_TRY(sfi_sweep_layer(&p->sweep));
        sf_slice slice = sf_grid_slice(p->result, k), drawn = sf_grid_slice(p->job->drawn, k);
        for (uint32_t y = 0; y < slice.height; y++) {
            for (uint32_t x = 0; x < slice.width && p->budget > 0; x++) {
                uint64_t word = sfi_slice_row(slice, y)[x / 64] & ~sfi_slice_row(drawn, y)[x / 64];
                if (word == 0) {
                    x |= 63;
                } else if (word >> (x % 64) & 1) {
                    place at = {k, x, y};
                    SF_TRY(try_beams(p, &at));
                }
            }
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Together
// ---------------------------------------------------------------------------------------------

static sf_status put_back(probe *p)
{
    const sfi_job *job = p->job;
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(p->result, k);
        SF_TRY(sf_slice_or(slice, slice, sf_grid_slice(job->drawn, k)));
    }
    return sfi_trim_into(p->result, p->result, p->full, job->bed, job->allocator,
                         sfi_pace_next(job->pace));
}

static sf_status probe_work(probe *p)
{
    const sfi_job *job = p->job;
    const sf_rule *rule = &p->full->rule;
    uint32_t nx = job->lattice.nx, ny = job->lattice.ny;
    SF_TRY(sfi_carrier_create(rule, nx, ny, job->allocator, &p->carrier));
    SF_TRY(sfi_front_create(rule, nx, ny, job->allocator, &p->fronts[0]));
    SF_TRY(sfi_front_create(rule, nx, ny, job->allocator, &p->fronts[1]));
    SF_TRY(put_back(p));
    SF_TRY(thin(p));
    SF_TRY(beams(p));
    return put_back(p);
}

sf_status sfi_bridged_improve(const sfi_job *job, const sf_terms *full, const sf_grid *room,
                              sf_grid *result, sf_repair_report *report)
{
    probe p = {.job = job, .full = full, .room = room, .result = result, .budget = BUDGET};
    if (report->cost == SF_REPAIR_NO_COST) {
        SF_TRY(sfi_grid_copy(result, room));
        report->first_cost = sfi_job_bill(job, result).cost;
    }
    sf_status status = probe_work(&p);
    sfi_front_destroy(&p.fronts[0], &full->rule, job->allocator);
    sfi_front_destroy(&p.fronts[1], &full->rule, job->allocator);
    sfi_carrier_destroy(&p.carrier, job->allocator);
    sfi_free_array(job->allocator, p.places, p.capacity, sizeof *p.places);
    return status;
}
