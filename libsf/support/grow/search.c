// SPDX-License-Identifier: MIT
// Descent: the closest supporting path by a search layer by layer, for every rule and all masks.
//
// A front is what t steps down reach, and it goes down by the same step that carries matter upwards
// (carry.c): elements are symmetric, so "u can carry v" read from v is a dilation as well. Let P be
// the voxels that a path may go through. For rules that are an element for each step
//
//     R_0 = { v },   R_t = P and dilate(R_{t-1}),
//
// and the path ends in the first layer where R_t meets matter to land on.
//
// Under slack the front holds demands: d(u) is the least slack that a voxel at u must have for some
// chain from it up to v to stand, with d(v) = 0 and
//
//     d(u) = min over v' in N(u) above: max(0, d(v') - rho + |v' - u|),   unreachable above cap.
//
// With the code c = cap + 1 - d this is c(u) = max over v' of min(cap + 1, c(v') + rho - |v' - u|),
// and unreachable below 1: word for word the step of slack codes from a layer to the next, here
// from a layer to the one below it. So sfi_carry() takes both. A path may end on matter with slack
// s, of code s + 1, where s >= d: where the two codes sum up to at least cap + 2. On the bed s =
// cap, so every voxel reached will do. Matter with too little slack is no obstacle: the path goes
// through it and gives it what it lacks.
//
// Where all voxels may be passed the windows of a cone (fringe.c) say the same, and much faster; so
// a path finder comes here only where its masks are in the way of what the cone offers.
//
// An exempt voxel that may be filled ends a path where d is 0 (it has no slack of its own).
//
// The path is read off from below: of the voxels above that gave the front its value, the one
// closest to the straight line to v. Fronts live in a rectangle around the cone down to some depth;
// where that is not deep enough the search begins again with twice the depth, which costs an eighth
// more.

#include "support/grow/search.h"
#include "base/bits.h"
#include "base/memory.h"
#include "base/status.h"

#define FIRST_DEPTH 16

typedef struct descent {
    const sfi_site *site;
    sfi_bed *bed;
    sf_voxel from;
    sfi_carrier carrier;
    sf_rect rect;     // of the fronts, in the grid; x0 is a multiple of 64
    uint32_t reach_y; // of the newest front: rows beyond are empty
    uint32_t depth, made;
    sfi_front *fronts; // depth + 1 of them, the first `made` with memory
    sfi_front passable;
    sf_rule bits; // rule of `passable`: no codes
} descent;

// Reach of `depth` steps down from the voxel, not beyond `most`.
static sf_status measure_reach(const descent *d, uint32_t depth, uint32_t *x, uint32_t *y)
{
    *x = *y = 0;
    for (uint32_t t = 1; t <= depth; t++) {
        sf_element e;
        SF_TRY(sf_rule_element(&d->site->plain, d->from.z - t, &e));
        *x = *x < SF_EXTENT_MAX ? *x + e.half_width[0] : *x;
        *y = *y < SF_EXTENT_MAX ? *y + e.reach_y : *y;
    }
    return SF_OK;
}

static sf_status place_rect(descent *d)
{
    uint32_t rx, ry, nx = d->site->lattice.nx, ny = d->site->lattice.ny;
    SF_TRY(measure_reach(d, d->depth, &rx, &ry));
    d->rect.x0 = (d->from.x > rx ? d->from.x - rx : 0) & ~UINT32_C(63);
    d->rect.x1 = rx < nx - d->from.x ? d->from.x + rx + 1 : nx;
    d->rect.y0 = d->from.y > ry ? d->from.y - ry : 0;
    d->rect.y1 = ry < ny - d->from.y ? d->from.y + ry + 1 : ny;
    return SF_OK;
}

static void descent_clear(descent *d)
{
    for (uint32_t t = 0; t < d->made; t++) {
        sfi_front_destroy(&d->fronts[t], &d->site->plain, &d->site->allocator);
    }
    sfi_front_destroy(&d->passable, &d->bits, &d->site->allocator);
    sfi_free_array(&d->site->allocator, d->fronts, (size_t)d->depth + 1, sizeof *d->fronts);
    d->fronts = NULL;
    d->made = 0;
}

// The next front, empty.
static sf_status add_front(descent *d)
{
    sf_status status =
        sfi_front_create(&d->site->plain, d->rect.x1 - d->rect.x0, d->rect.y1 - d->rect.y0,
                         &d->site->allocator, &d->fronts[d->made]);
    d->made += status == SF_OK;
    return status;
}

// Rectangle, memory and the front of the voxel itself, for a search down to d->depth.
static sf_status descent_begin(descent *d)
{
    SF_TRY(place_rect(d));
    uint32_t width = d->rect.x1 - d->rect.x0, height = d->rect.y1 - d->rect.y0;
    d->fronts = sfi_alloc_array(&d->site->allocator, (size_t)d->depth + 1, sizeof *d->fronts);
    if (d->fronts == NULL) {
        return SF_ERR_MEMORY;
    }
    d->bits = sf_rule_box3();
    SF_TRY(sfi_front_create(&d->bits, width, height, &d->site->allocator, &d->passable));
    d->carrier = sfi_carrier_place(&d->site->plain, width, height, NULL);
    SF_TRY(add_front(d));
    SF_TRY(sf_slice_set(d->passable.alive, d->from.x - d->rect.x0, d->from.y - d->rect.y0, 1));
    return sfi_carry_bed(&d->carrier, d->passable.alive, d->fronts[0]);
}

// The part of a slice of the grid that lies in the rectangle, as a view.
static sf_slice view(const descent *d, sf_slice whole)
{
    if (whole.words == NULL) {
        return SFI_NO_SLICE;
    }
    sf_slice part = {sfi_slice_row(whole, d->rect.y0) + d->rect.x0 / 64, d->rect.x1 - d->rect.x0,
                     d->rect.y1 - d->rect.y0, whole.stride};
    return part;
}

// The rows of the rectangle that the newest front can reach.
static void find_band(const descent *d, uint32_t *y0, uint32_t *y1)
{
    uint32_t middle = d->from.y - d->rect.y0, height = d->rect.y1 - d->rect.y0;
    *y0 = middle > d->reach_y ? middle - d->reach_y : 0;
    *y1 = d->reach_y < height - middle ? middle + d->reach_y + 1 : height;
}

// These rows of a front.
static sfi_front band(const descent *d, sfi_front front)
{
    uint32_t y0, y1;
    find_band(d, &y0, &y1);
    front.slack =
        front.slack != NULL ? front.slack + y0 * sfi_slack_stride(front.alive.width) : NULL;
    front.alive.words = sfi_slice_row(front.alive, y0);
    front.alive.height = y1 - y0;
    return front;
}

static void find_passable(descent *d, uint32_t z)
{
    sf_slice out = d->passable.alive, solid = view(d, sf_grid_slice(d->site->grid, z));
    size_t words = sfi_row_words(out.width), first = d->rect.x0 / 64;
    uint32_t y0, y1;
    find_band(d, &y0, &y1);
    for (uint32_t y = y0; y < y1; y++) {
        uint64_t *row = sfi_slice_row(out, y);
        for (size_t i = 0; i < words; i++) {
            row[i] = sfi_slice_row(solid, y)[i] |
                     sfi_site_free_word(d->site, z, d->rect.y0 + y, first + i);
        }
        row[words - 1] &= sfi_tail_mask(out.width);
    }
}

static uint8_t code_at(sfi_front front, uint32_t x, uint32_t y)
{
    return front.slack[y * sfi_slack_stride(front.alive.width) + x];
}

// What of `reached` a path may end on: code is that of the front. For exempt voxels `roots` is the
// mask, and they have no slack.
typedef struct goal {
    sf_slice roots; // in the rectangle
    uint32_t z;
    int is_held;
} goal;

// Whether the reach is enough for a path to end at voxel (x, y) of the rectangle.
static int is_enough(const descent *d, sfi_front front, const goal *g, uint32_t x, uint32_t y)
{
    if (front.slack == NULL) {
        return 1;
    }
    sf_voxel at = {d->rect.x0 + x, d->rect.y0 + y, g->z};
    uint32_t slack = g->is_held ? 0 : sfi_site_slack(d->site, at);
    return slack + code_at(front, x, y) >= d->site->plain.slack_cap + 1u;
}

static sfi_spot choose_goal(const descent *d, sfi_front front, const goal *g)
{
    sfi_spot spot = {0, 0, 0, 0, 0};
    size_t words = sfi_row_words(front.alive.width);
    uint32_t y0, y1;
    find_band(d, &y0, &y1);
    for (uint32_t y = y0; g->roots.words != NULL && y < y1; y++) {
        for (size_t i = 0; i < words; i++) {
            uint64_t w = sfi_slice_row(front.alive, y)[i] & sfi_slice_row(g->roots, y)[i];
            for (; w != 0; w &= w - 1) {
                uint32_t x = (uint32_t)i * 64 + sfi_lowest_bit(w);
                if (is_enough(d, front, g, x, y)) {
                    sfi_spot_offer(&spot, 0, d->from, d->rect.x0 + x, d->rect.y0 + y);
                }
            }
        }
    }
    return spot;
}

static sfi_spot choose_on_bed(const descent *d, sfi_front front)
{
    sfi_spot spot = {0, 0, 0, 0, 0};
    size_t words = sfi_row_words(front.alive.width);
    for (uint32_t y = 0; y < front.alive.height; y++) {
        const uint32_t *square =
            d->bed->square + (size_t)(d->rect.y0 + y) * d->site->lattice.nx + d->rect.x0;
        for (size_t i = 0; i < words; i++) {
            for (uint64_t w = sfi_slice_row(front.alive, y)[i]; w != 0; w &= w - 1) {
                uint32_t x = (uint32_t)i * 64 + sfi_lowest_bit(w);
                sfi_spot_offer(&spot, square[x], d->from, d->rect.x0 + x, d->rect.y0 + y);
            }
        }
    }
    return spot;
}

// ---------------------------------------------------------------------------------------------
// Reading off the path
// ---------------------------------------------------------------------------------------------

// Distance of a step's end from the straight line up to the voxel, times the layers left, squared.
static uint64_t stray(int64_t step_x, int64_t step_y, int64_t all_x, int64_t all_y, int64_t layers)
{
    int64_t x = step_x * layers - all_x, y = step_y * layers - all_y;
    return (uint64_t)(x * x + y * y);
}

// Whether voxel (x, y) of the rectangle in front t - 1 gives voxel `at` of front t its value.
static int is_giver(const descent *d, uint32_t t, uint32_t x, uint32_t y, uint32_t ax, uint32_t ay)
{
    const sf_rule *rule = &d->site->plain;
    if (!sf_slice_get(d->fronts[t - 1].alive, x, y)) {
        return 0;
    }
    if (rule->kind != SF_RULE_SLACK) {
        return 1;
    }
    uint32_t cost = sfi_slack_cost(rule, x > ax ? x - ax : ax - x, y > ay ? y - ay : ay - y);
    uint32_t gain = sfi_slack_gain(rule, d->from.z - t), top = rule->slack_cap + 1u;
    uint32_t code = code_at(d->fronts[t - 1], x, y) + gain;
    code = code > cost ? code - cost : 0;
    return (code < top ? code : top) == code_at(d->fronts[t], ax, ay);
}

// The voxel of front t - 1 that the chain goes on with above voxel `at` of front t.
static sf_voxel choose_above(const descent *d, uint32_t t, sf_voxel at)
{
    uint32_t nx = d->site->lattice.nx, ny = d->site->lattice.ny;
    int64_t all_x = (int64_t)d->from.x - at.x, all_y = (int64_t)d->from.y - at.y;
    uint64_t least = UINT64_MAX;
    sf_voxel best = at;
    sf_element e;
    (void)!sf_rule_element(&d->site->plain, at.z, &e); // it has served this step already
    for (int64_t dy = -(int64_t)e.reach_y; dy <= e.reach_y; dy++) {
        int64_t half = e.half_width[dy < 0 ? -dy : dy], y = at.y + dy;
        for (int64_t dx = -half; dx <= half; dx++) {
            int64_t x = at.x + dx;
            uint64_t off = stray(dx, dy, all_x, all_y, t);
            if (x < d->rect.x0 || x >= d->rect.x1 || y < d->rect.y0 || y >= d->rect.y1 || x >= nx ||
                y >= ny || off >= least ||
                !is_giver(d, t, (uint32_t)x - d->rect.x0, (uint32_t)y - d->rect.y0,
                          at.x - d->rect.x0, at.y - d->rect.y0)) {
                continue;
            }
            least = off;
            best.x = (uint32_t)x;
            best.y = (uint32_t)y;
        }
    }
    best.z = at.z + 1;
    return best;
}

static void read_path(const descent *d, uint32_t t, const sfi_spot *spot, sf_path_end end,
                      sf_voxel *chain, sf_path *found)
{
    sf_voxel to = {spot->x, spot->y, d->from.z - t};
    size_t count = t - (end == SF_PATH_END_MATTER ? 1 : 0);
    if (end != SF_PATH_END_MATTER) {
        chain[t - 1] = to;
    }
    for (sf_voxel at = to; t > 1; t--) {
        at = choose_above(d, t, at);
        chain[t - 2] = at;
    }
    *found = sfi_path_make(count, end, to, (uint32_t)spot->first);
}

// ---------------------------------------------------------------------------------------------
// Search
// ---------------------------------------------------------------------------------------------

// Look for an end in the newest front; *is_end says whether there is one.
static sf_status try_to_end(descent *d, uint32_t t, sf_voxel *chain, sf_path *found, int *is_end)
{
    uint32_t z = d->from.z - t;
    sfi_front front = d->fronts[t];
    goal matter = {view(d, sf_grid_slice(d->site->roots, z)), z, 0};
    goal held = {view(d, sfi_mask_slice(d->site->terms.exempt, z)), z, 1};
    sf_path_end end = SF_PATH_END_MATTER;
    sfi_spot spot = choose_goal(d, front, &matter);
    if (!spot.is_found) {
        end = SF_PATH_END_HELD;
        spot = choose_goal(d, front, &held);
    }
    if (!spot.is_found && z == d->site->bed) {
        SF_TRY(sfi_bed_update(d->bed, d->site));
        end = SF_PATH_END_BED;
        spot = choose_on_bed(d, front);
    }
    *is_end = spot.is_found;
    if (spot.is_found) {
        read_path(d, t, &spot, end, chain, found);
    }
    return SF_OK;
}

// Search down to d->depth. *is_end: a path was found; else *is_dead: there is none at any depth.
static sf_status search_to_depth(descent *d, sf_voxel *chain, sf_path *found, int *is_end,
                                 int *is_dead)
{
    SF_TRY(descent_begin(d));
    for (uint32_t t = 1; t <= d->depth; t++) {
        uint32_t z = d->from.z - t;
        sf_element e;
        SF_TRY(sf_rule_element(&d->site->plain, z, &e));
        d->reach_y = d->reach_y < SF_EXTENT_MAX ? d->reach_y + e.reach_y : d->reach_y;
        find_passable(d, z);
        SF_TRY(add_front(d));
        sfi_front above = band(d, d->fronts[t - 1]);
        SF_TRY(sfi_carry(&d->carrier, z + 1, &above, band(d, d->passable).alive, SFI_NO_SLICE,
                         band(d, d->fronts[t]), SFI_NO_SLICE));
        SF_TRY(try_to_end(d, t, chain, found, is_end));
        *is_dead = !*is_end && !sfi_slice_any(d->fronts[t].alive);
        if (*is_end || *is_dead) {
            break;
        }
    }
    return SF_OK;
}

sf_status sfi_descend(const sfi_site *site, sfi_bed *bed, sf_voxel from, sf_voxel *chain,
                      sf_path *found)
{
    uint32_t whole = from.z - site->bed;
    int is_end = 0, is_dead = 0;
    sf_status status = SF_OK;
    for (uint32_t depth = FIRST_DEPTH; status == SF_OK && !is_end && !is_dead; depth *= 2) {
        descent d = {.site = site, .bed = bed, .from = from};
        d.depth = depth < whole ? depth : whole;
        status = search_to_depth(&d, chain, found, &is_end, &is_dead);
        is_dead |= d.depth == whole;
        descent_clear(&d);
    }
    return status != SF_OK || is_end ? status : SF_ERR_INFEASIBLE;
}
