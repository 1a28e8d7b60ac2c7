// SPDX-License-Identifier: MIT
// Struts: the same repair out of things that print.
//
// The cheapest supports are hairs, one voxel thick. Here each addition is a square of w x w voxels,
// named by its corner, its "centre". A chain of centres c_k, c_{k-1} in N(c_k), ... is
// support-free, because voxel c_k + o of one square stands on c_{k-1} + o of the next; so a chain
// of squares is looked for in the plane of centres just as one of voxels is in the grid:
//
//     where a centre may be    G eroded by the square, and on a chain itself
//     where chains may end     the bed, and K eroded by the square: squares of what is kept
//
// To end on the edge of something thinner than the square would leave voxels in the air, so that is
// not done. A voxel v of K that nothing carries takes a centre whose square meets N(v); there are
// (w + 2)^2 of them under the 3x3, the cheapest is taken, and among those the one that lies
// farthest on, where the next such voxels are. Where there is none, v takes a single voxel, and
// that one looks for a centre in the layer below.
//
// Where hairs already run is free for centres, so that struts follow them: hairs were drawn
// together by everything that a repair knows (improve.c), and there is no need to find that anew.
//
// Which K is kept was decided at a price of w^2 for each addition (repair.c), which is what a strut
// costs where it stands alone. Keeping all that can be kept, and the trim, are tried too.
//
// Under slack, chains take only steps that use up no reach, the disk of what every layer gains; so
// all of a square has the slack to carry what it carries. What cannot be reached so is not kept,
// and where it must be, the hairs stay.
//
// Source: the library's own; of the squares' centres it uses what morphology calls an erosion.

#include "support/repair/strut.h"

#include "base/status.h"
#include "support/check/row.h"
#include "support/repair/improve.h"
#include "support/repair/price_row.h"
#include "support/rule/carry.h"
#include "voxel/grid.h"
#include "voxel/slice.h"
#include "voxel/square.h"

// One result that is being built.
typedef struct builder {
    const sfi_job *job; // of struts: a rule that is an element, roots exempt
    uint32_t width;
    const sf_grid *kept;                   // K
    const sf_grid *hairs;                  // a result out of single voxels
    sf_grid *ends, *room, *thin, *centres; // K eroded; where centres may be; K and single voxels
    sf_grid *result;
    sfi_price square_price, voxel_price;
} builder;

// ---------------------------------------------------------------------------------------------
// Looking around
// ---------------------------------------------------------------------------------------------

static int price_at(const sfi_price *p, uint32_t k, int64_t x, int64_t y)
{
    sf_rect r = p->rects[k];
    if (k >= p->top || x < r.x0 || x >= r.x1 || y < r.y0 || y >= r.y1) {
        return SFI_PRICE_NONE;
    }
    return sfi_price_row(p, k, (uint32_t)y)[x];
}

// Half width of the element `dy` rows away, as a square of `size` sees it from its corner: rows
// -size
// + 1 .. 0 all see the element's middle. Negative: nothing is seen from there.
static int64_t half_width(const sf_element *e, int64_t dy, uint32_t size)
{
    int64_t away = dy > 0 ? dy : dy < 1 - (int64_t)size ? 1 - (int64_t)size - dy : 0;
    return away <= e->reach_y ? e->half_width[away] : -1;
}

// The corner of the cheapest square of `size` that meets the element around (x, y) in layer k; of
// those at one price the last in order. Returns 0 where there is none.
static int find_corner(const sfi_price *price, const sf_element *e, uint32_t size, uint32_t k,
                       uint32_t x, uint32_t y, uint32_t corner[2])
{
    int least = SFI_PRICE_NONE;
    int64_t reach = e->reach_y, last = 1 - (int64_t)size;
    for (int64_t dy = last - reach; dy <= reach; dy++) {
        int64_t w = half_width(e, dy, size);
        for (int64_t dx = last - w; w >= 0 && dx <= w; dx++) {
            int here = price_at(price, k, (int64_t)x + dx, (int64_t)y + dy);
            if (here != SFI_PRICE_NONE && here <= least) {
                least = here;
                corner[0] = (uint32_t)(x + dx);
                corner[1] = (uint32_t)(y + dy);
            }
        }
    }
    return least != SFI_PRICE_NONE;
}

// Whether a slice has a voxel in the element around (x, y).
static int is_carried(sf_slice below, const sf_element *e, uint32_t x, uint32_t y)
{
    for (uint32_t row = y > e->reach_y ? y - e->reach_y : 0;
         row < below.height && row <= y + e->reach_y; row++) {
        uint32_t w = e->half_width[row > y ? row - y : y - row];
        if (sfi_row_any(sfi_slice_row(below, row), below.width, x > w ? x - w : 0, x + w + 1)) {
            return 1;
        }
    }
    return 0;
}

// ---------------------------------------------------------------------------------------------
// From the top down
// ---------------------------------------------------------------------------------------------

static void set(sf_grid *grid, uint32_t k, uint32_t x, uint32_t y)
{
    sfi_slice_row(sf_grid_slice(grid, k), y)[x / 64] |= UINT64_C(1) << (x % 64);
}

static sf_status place(const builder *b, uint32_t k, const uint32_t corner[2])
{
    sf_rect square = {corner[0], corner[1], corner[0] + b->width, corner[1] + b->width};
    set(b->centres, k, corner[0], corner[1]);
    return sf_slice_fill(sf_grid_slice(b->result, k), square, 1);
}

// Give a centre of layer k one to stand on, unless it stands.
static sf_status hold_centre(const builder *b, const sf_element *e, uint32_t k, uint32_t x,
                             uint32_t y)
{
    uint32_t corner[2] = {0, 0};
    if (is_carried(sf_grid_slice(b->centres, k - 1), e, x, y) ||
        is_carried(sf_grid_slice(b->ends, k - 1), e, x, y)) {
        return SF_OK;
    }
    // It lies on a chain, or it would not have been a place for a centre.
    return find_corner(&b->square_price, e, 1, k - 1, x, y, corner) ? place(b, k - 1, corner)
                                                                    : SF_ERR_INTERNAL;
}

// Give a voxel of layer k a square to stand on, or a single voxel, unless it stands.
static sf_status hold_voxel(const builder *b, const sf_element *e, uint32_t k, uint32_t x,
                            uint32_t y)
{
    uint32_t corner[2] = {0, 0};
    if (is_carried(sf_grid_slice(b->result, k - 1), e, x, y)) {
        return SF_OK;
    }
    if (find_corner(&b->square_price, e, b->width, k - 1, x, y, corner)) {
        return place(b, k - 1, corner);
    }
    if (!find_corner(&b->voxel_price, e, 1, k - 1, x, y, corner)) {
        return SF_ERR_INTERNAL;
    }
    set(b->thin, k - 1, corner[0], corner[1]);
    set(b->result, k - 1, corner[0], corner[1]);
    return SF_OK;
}

// Hold the voxels of a layer of `what` that are not in `free` (or SFI_NO_SLICE).
static sf_status
hold_all(const builder *b, uint32_t k, sf_slice what, sf_slice free, const sf_element *e,
         sf_status (*hold)(const builder *, const sf_element *, uint32_t, uint32_t, uint32_t))
{
    for (uint32_t y = 0; y < what.height; y++) {
        const uint64_t *row = sfi_slice_row(what, y);
        const uint64_t *spared = free.words != NULL ? sfi_slice_row(free, y) : NULL;
        for (size_t i = 0; i < sfi_row_words(what.width); i++) {
            uint64_t w = spared != NULL ? row[i] & ~spared[i] : row[i];
            for (; w != 0; w &= w - 1) {
                SF_TRY(hold(b, e, k, (uint32_t)i * 64 + sfi_lowest_bit(w), y));
            }
        }
    }
    return SF_OK;
}

static sf_status build_down(const builder *b)
{
    const sfi_job *job = b->job;
    sfi_sweep sweep = sfi_sweep_begin(job->pace, job->lattice.nz - job->bed);
    for (uint32_t k = job->lattice.nz; k-- > job->bed + 1;) {
        sf_element e;
        SF_TRY(sfi_sweep_layer(&sweep));
        SF_TRY(sf_rule_element(&job->rule, k - 1, &e));
        SF_TRY(hold_all(b, k, sf_grid_slice(b->centres, k), SFI_NO_SLICE, &e, hold_centre));
        SF_TRY(hold_all(b, k, sf_grid_slice(b->thin, k), sfi_mask_slice(job->exempt, k), &e,
                        hold_voxel));
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// One result
// ---------------------------------------------------------------------------------------------

// Where centres may be: corners of squares in the room that stand on a chain of such, or lie in K.
static sf_status find_places(builder *b)
{
    const sfi_job *job = b->job;
    SF_TRY(sfi_grid_copy(b->ends, b->kept));
    SF_TRY(sfi_grid_copy(b->room, job->room));
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        sfi_square_corners(sf_grid_slice(b->ends, k), b->width);
        sfi_square_corners(sf_grid_slice(b->room, k), b->width);
    }
    sf_terms terms = sfi_job_terms(job);
    terms.exempt = b->ends;
    return sfi_trim_into(b->room, b->room, &terms, job->bed, job->allocator,
                         sfi_pace_next(job->pace));
}

static sf_status find_prices(builder *b)
{
    const sfi_job *job = b->job;
    sf_grid *track = b->thin; // used for that first
    for (uint32_t k = 0; k < job->lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(track, k);
        SF_TRY(sf_slice_subtract(slice, sf_grid_slice(b->hairs, k), sf_grid_slice(job->drawn, k)));
        SF_TRY(sf_slice_or(slice, slice, sf_grid_slice(b->ends, k)));
    }
    sfi_job squares = *job;
    squares.exempt = b->ends;
    squares.add = NULL;
    sfi_price_terms places = {b->room, track, NULL, NULL};
    sfi_price_terms voxels = {job->room, b->kept, NULL, NULL};
    SF_TRY(sfi_price_make(&squares, &places, &b->square_price));
    return sfi_price_make(job, &voxels, &b->voxel_price);
}

static sf_status build_with(builder *b)
{
    const sfi_job *job = b->job;
    sf_grid **grids[4] = {&b->ends, &b->room, &b->thin, &b->centres};
    for (int i = 0; i < 4; i++) {
        SF_TRY(sf_grid_create(&job->lattice, job->allocator, grids[i]));
    }
    SF_TRY(find_places(b));
    SF_TRY(find_prices(b));
    SF_TRY(sfi_grid_copy(b->thin, b->kept));
    SF_TRY(sfi_grid_copy(b->result, b->kept));
    return build_down(b);
}

// result = K on struts.
static sf_status build(const sfi_job *job, uint32_t width, const sf_grid *kept,
                       const sf_grid *hairs, sf_grid *result)
{
    builder b = {.job = job, .width = width, .kept = kept, .hairs = hairs, .result = result};
    sf_status status = build_with(&b);
    sfi_price_destroy(job, &b.square_price);
    sfi_price_destroy(job, &b.voxel_price);
    sf_grid_destroy(b.ends);
    sf_grid_destroy(b.room);
    sf_grid_destroy(b.thin);
    sf_grid_destroy(b.centres);
    return status;
}

// ---------------------------------------------------------------------------------------------
// The cheapest of three
// ---------------------------------------------------------------------------------------------

typedef struct choice {
    sfi_job job; // of struts
    sf_grid *exempt, *room, *kept, *trial;
    uint32_t width;
    const sf_grid *hairs;
    const sfi_job *whole;
    const sf_terms *full;
    sf_grid *best;
    uint64_t cost;
} choice;

// Try to keep what of `wanted` can be carried; put back what of V then is carried too.
static sf_status try_to_keep(choice *c, const sf_grid *wanted, uint64_t *cost)
{
    const sfi_job *whole = c->whole;
    for (uint32_t k = 0; k < whole->lattice.nz; k++) {
        sf_slice kept = sf_grid_slice(c->kept, k);
        SF_TRY(sf_slice_and(kept, sf_grid_slice(wanted, k), sf_grid_slice(whole->drawn, k)));
        SF_TRY(sf_slice_and(kept, kept, sf_grid_slice(c->room, k)));
    }
    *cost = SF_REPAIR_NO_COST;
    if (whole->must != NULL && !sfi_grid_within(whole->must, c->kept)) {
        return SF_OK;
    }
    SF_TRY(build(&c->job, c->width, c->kept, c->hairs, c->trial));
    for (uint32_t k = 0; k < whole->lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(c->trial, k);
        SF_TRY(sf_slice_or(slice, slice, sf_grid_slice(whole->drawn, k)));
    }
    SF_TRY(sfi_trim_into(c->trial, c->trial, c->full, whole->bed, whole->allocator,
                         sfi_pace_next(whole->pace)));
    *cost = sfi_job_bill(whole, c->trial).cost;
    if (*cost < c->cost) {
        c->cost = *cost;
        SF_TRY(sfi_grid_copy(c->best, c->trial));
    }
    return SF_OK;
}

static sf_status choose(choice *c, sf_repair_report *report)
{
    const sfi_job *whole = c->whole;
    c->cost = SF_REPAIR_NO_COST;
    if (whole->must == NULL || sfi_grid_within(whole->must, whole->roots)) {
        SF_TRY(sfi_grid_copy(c->best, whole->roots));
        c->cost = sfi_job_bill(whole, whole->roots).cost;
    }
    SF_TRY(try_to_keep(c, c->hairs, &report->first_cost));
    report->first_cost = c->cost < report->first_cost ? c->cost : report->first_cost;
    return try_to_keep(c, whole->drawn, &report->grow_cost);
}

// Roots stand by themselves; struts stand on the bed, on them and on what is exempt.
static sf_status prepare(choice *c)
{
    const sfi_job *whole = c->whole;
    sf_grid **grids[5] = {&c->exempt, &c->room, &c->kept, &c->trial, &c->best};
    for (int i = 0; i < 5; i++) {
        SF_TRY(sf_grid_create(&whole->lattice, whole->allocator, grids[i]));
    }
    SF_TRY(sfi_grid_copy(c->exempt, whole->roots));
    for (uint32_t k = 0; whole->exempt != NULL && k < whole->lattice.nz; k++) {
        sf_slice exempt = sf_grid_slice(c->exempt, k);
        SF_TRY(sf_slice_or(exempt, exempt, sf_grid_slice(whole->exempt, k)));
    }
    c->job = *whole;
    c->job.rule = sfi_careful_rule(whole);
    c->job.exempt = c->exempt;
    c->job.room = c->room;
    sf_terms terms = sfi_job_terms(&c->job);
    return sfi_trim_into(c->room, whole->room, &terms, whole->bed, whole->allocator,
                         sfi_pace_next(whole->pace));
}

sf_status sfi_strut_widen(const sfi_job *job, const sf_terms *full, uint32_t width, sf_grid *result,
                          sf_repair_report *report)
{
    choice c = {.whole = job, .full = full, .hairs = result, .width = width};
    sf_status status = prepare(&c);
    if (status == SF_OK) {
        status = choose(&c, report);
    }
    // Nothing was found that holds what must stay: the hairs remain.
    if (status == SF_OK && c.cost != SF_REPAIR_NO_COST) {
        status = sfi_grid_copy(result, c.best);
    } else if (status == SF_OK) {
        report->first_cost = sfi_job_bill(job, result).cost;
    }
    sf_grid_destroy(c.exempt);
    sf_grid_destroy(c.room);
    sf_grid_destroy(c.kept);
    sf_grid_destroy(c.trial);
    sf_grid_destroy(c.best);
    return status;
}
