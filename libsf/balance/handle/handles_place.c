// SPDX-License-Identifier: MIT
// Handles placed by themselves: deep in the solid, far from the base and from each other.
//
// A hand or a head is where the solid ends, and there a handle does most; so each one takes the
// place that is furthest from all that is taken, on the way through the solid: a hand that rests on
// the hip is far from it. Places are the cells that lie at least as deep as the 26 around them; so
// a handle sits in the middle of the hand and not in the tip of a finger. The depth is added to the
// distance, which favours a head over a horn. A shape without limbs has few such places, an egg
// one; when they are used up, whatever lies at least half as deep as the deepest place will do.
//
// Pieces that neither the base nor the deepest cell belongs to are left alone: their weights follow
// the rest.
//
// Source: T. F. Gonzalez, "Clustering to Minimize the Maximum Intercluster Distance", 1985.

#include "balance/handle/handles_depth.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"

#include <sf/handles.h>

#include <math.h>
#include <string.h>

// Cells that lie between two handles at least, less one.
enum { APART = 3 };

typedef struct place {
    sf_allocator allocator;
    const sf_grid *solid;
    sf_place_options options;
    sfi_domain domain;
    double *depth, *distance;
    uint32_t *base; // its cells
    size_t base_count;
    sfi_spread spread;
    uint32_t taken[SF_HANDLE_MAX];
    double radius[SF_HANDLE_MAX]; // 0 for points
    size_t count;
} place;

sf_place_options sf_place_options_default(void)
{
    sf_place_options options = {sizeof options, 5, NULL, 0, 32768};
    return options;
}

// ---------------------------------------------------------------------------------------------
// Candidates
// ---------------------------------------------------------------------------------------------

static int is_deep(const place *p, uint32_t cell)
{
    const sfi_domain *d = &p->domain;
    const uint32_t *at = d->place + 3 * (size_t)cell;
    for (int n = 0; n < 27; n++) {
        int64_t i = (int64_t)at[0] + n % 3 - 1, j = (int64_t)at[1] + n / 3 % 3 - 1,
                k = (int64_t)at[2] + n / 9 - 1;
        if (i < 0 || j < 0 || k < 0 || i >= d->cells[0] || j >= d->cells[1] || k >= d->cells[2]) {
            continue;
        }
        uint32_t other = d->cell_at[sfi_domain_box_index(d, (uint32_t)i, (uint32_t)j, (uint32_t)k)];
        if (other != SFI_NO_CELL && p->depth[other] > p->depth[cell]) {
            return 0;
        }
    }
    return 1;
}

// Whether balls of these radii (0 for single cells) around the middles of two cells leave room
// between them.
static int are_apart(const sfi_domain *d, uint32_t a, uint32_t b, double radius)
{
    double p[3], q[3], square = 0, edge = 0;
    uint32_t steps = 0;
    sfi_domain_middle(d, a, p);
    sfi_domain_middle(d, b, q);
    for (int axis = 0; axis < 3; axis++) {
        uint32_t i = d->place[3 * (size_t)a + (size_t)axis],
                 j = d->place[3 * (size_t)b + (size_t)axis];
        const double *plane = d->planes[axis] + i;
        steps = (i > j ? i - j : j - i) > steps ? (i > j ? i - j : j - i) : steps;
        edge += (plane[1] - plane[0]) * (plane[1] - plane[0]);
        square += (p[axis] - q[axis]) * (p[axis] - q[axis]);
    }
    double least = radius > 0 ? radius + 2 * sqrt(edge) : 0;
    return steps >= APART && square > least * least;
}

static int has_room(const place *p, uint32_t cell, double radius)
{
    for (size_t i = 0; i < p->count; i++) {
        if (!are_apart(&p->domain, cell, p->taken[i], radius + p->radius[i])) {
            return 0;
        }
    }
    for (size_t i = 0; i < p->base_count; i++) {
        if (!are_apart(&p->domain, cell, p->base[i], radius)) {
            return 0;
        }
    }
    return 1;
}

// The best cell, or SFI_NO_CELL: of those that lie deep among their neighbours, or with `enough` of
// those at least that deep. With nothing taken it is the deepest.
static uint32_t choose(const place *p, double enough)
{
    uint32_t best = SFI_NO_CELL;
    double best_score = 0;
    int first = p->count == 0 && p->base_count == 0;
    for (uint32_t cell = 0; cell < p->domain.cell_count; cell++) {
        double score = p->depth[cell] + (first ? 0 : p->distance[cell]);
        if (isfinite(score) && score > best_score &&
            (enough > 0 ? p->depth[cell] >= enough : is_deep(p, cell)) &&
            has_room(p, cell, p->options.ball * p->depth[cell])) {
            best = cell;
            best_score = score;
        }
    }
    return best;
}

// ---------------------------------------------------------------------------------------------
// Taking them
// ---------------------------------------------------------------------------------------------

// The middle of the solid voxel of a cell's block that lies closest to the middle of the block.
static void settle(const place *p, uint32_t cell, double at[3])
{
    const sfi_domain *d = &p->domain;
    const uint32_t *box = d->place + 3 * (size_t)cell;
    sf_lattice l = sf_grid_lattice(p->solid);
    double least = INFINITY, middle[3];
    uint32_t from[3];
    sfi_domain_middle(d, cell, middle);
    for (int axis = 0; axis < 3; axis++) {
        from[axis] = d->first[axis] + box[axis] * d->block[axis];
    }
    double bottom = sf_lattice_layer_bottom(&l, from[2]);
    for (uint32_t z = from[2]; z < from[2] + d->block[2] && z < l.nz; z++) {
        double height = sf_lattice_layer_height(&l, z);
        for (uint32_t n = 0; n < d->block[0] * d->block[1]; n++) {
            uint32_t x = from[0] + n % d->block[0], y = from[1] + n / d->block[0];
            double q[3] = {l.origin_mm[0] + (x + 0.5) * l.pitch_x_mm,
                           l.origin_mm[1] + (y + 0.5) * l.pitch_y_mm, bottom + 0.5 * height};
            double by[3] = {q[0] - middle[0], q[1] - middle[1], q[2] - middle[2]};
            double square = (by[0] * by[0] + by[1] * by[1]) + by[2] * by[2];
            if (square < least && sf_slice_get(sf_grid_slice(p->solid, z), x, y)) {
                least = square;
                memcpy(at, q, sizeof q);
            }
        }
        bottom += height;
    }
}

static sf_status take_all(place *p, sf_task *task, sf_handle *handles)
{
    sfi_progress progress = sfi_progress_begin(task);
    double deepest = 0;
    for (size_t i = 0; i < p->domain.cell_count; i++) {
        p->distance[i] = INFINITY;
        deepest = p->depth[i] > deepest ? p->depth[i] : deepest;
    }
    sfi_domain_spread(&p->domain, p->base, p->base_count, &p->spread, p->distance);
    while (p->count < p->options.count) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        uint32_t cell = choose(p, 0);
        cell = cell != SFI_NO_CELL ? cell : choose(p, 0.5 * deepest);
        if (cell == SFI_NO_CELL) {
            break;
        }
        double radius = p->options.ball * p->depth[cell];
        sf_handle made = {
            radius > 0 ? SF_HANDLE_BALL : SF_HANDLE_POINT, {0, 0, 0}, radius, NULL, 0};
        settle(p, cell, made.at_mm);
        handles[p->count] = made;
        p->radius[p->count] = radius;
        p->taken[p->count++] = cell;
        sfi_domain_spread(&p->domain, &cell, 1, &p->spread, p->distance);
        sfi_progress_report(&progress, p->count, p->options.count);
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The call
// ---------------------------------------------------------------------------------------------

// The cells that hold a voxel of the base.
static void find_base(place *p)
{
    const sfi_domain *d = &p->domain;
    sf_lattice l = sf_grid_lattice(p->solid);
    for (uint32_t cell = 0; p->options.base != NULL && cell < d->cell_count; cell++) {
        uint32_t from[3], found = 0;
        for (int axis = 0; axis < 3; axis++) {
            from[axis] =
                d->first[axis] + d->place[3 * (size_t)cell + (size_t)axis] * d->block[axis];
        }
        for (uint32_t z = from[2]; z < from[2] + d->block[2] && z < l.nz && !found; z++) {
            sf_slice slice = sf_grid_slice(p->options.base, z);
            for (uint32_t n = 0; n < d->block[0] * d->block[1] && !found; n++) {
                found =
                    sf_slice_get(slice, from[0] + n % d->block[0], from[1] + n / d->block[0]) != 0;
            }
        }
        if (found) {
            p->base[p->base_count++] = cell;
        }
    }
}

static sf_status prepare(place *p)
{
    SF_TRY(sfi_domain_create(p->solid, 0, p->options.most_cells, &p->allocator, &p->domain));
    size_t cells = p->domain.cell_count;
    p->depth = sfi_alloc_array(&p->allocator, cells, sizeof *p->depth);
    p->distance = sfi_alloc_array(&p->allocator, cells, sizeof *p->distance);
    p->base = sfi_alloc_array(&p->allocator, cells, sizeof *p->base);
    p->spread.heap = sfi_alloc_array(&p->allocator, cells, sizeof *p->spread.heap);
    p->spread.where = sfi_alloc_array(&p->allocator, cells, sizeof *p->spread.where);
    if (p->depth == NULL || p->distance == NULL || p->base == NULL || p->spread.heap == NULL ||
        p->spread.where == NULL) {
        return SF_ERR_MEMORY;
    }
    find_base(p);
    return sfi_domain_depth(&p->domain, &p->allocator, p->depth);
}

static void release(place *p)
{
    size_t cells = p->domain.cell_count;
    sfi_free_array(&p->allocator, p->depth, cells, sizeof *p->depth);
    sfi_free_array(&p->allocator, p->distance, cells, sizeof *p->distance);
    sfi_free_array(&p->allocator, p->base, cells, sizeof *p->base);
    sfi_free_array(&p->allocator, p->spread.heap, cells, sizeof *p->spread.heap);
    sfi_free_array(&p->allocator, p->spread.where, cells, sizeof *p->spread.where);
    if (p->domain.box_count > 0) {
        sfi_domain_destroy(&p->domain);
    }
}

static sf_status check(const sf_grid *solid, const sf_place_options *o, sf_fault *fault)
{
    if (o->struct_size < sizeof *o || o->count < 1 || o->count > SF_HANDLE_MAX ||
        !(o->ball >= 0 && o->ball <= 1) || o->most_cells < 64) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "1 to %u handles can be placed, with options within their ranges",
                             SF_HANDLE_MAX);
    }
    if (sf_grid_popcount(solid) == 0) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "the solid has no voxels: there is no place for a handle");
    }
    if (o->base != NULL) {
        sf_lattice l = sf_grid_lattice(solid), b = sf_grid_lattice(o->base);
        if (l.nx != b.nx || l.ny != b.ny || l.nz != b.nz) {
            return sfi_fault_set(fault, SF_ERR_SHAPE, 0, 0,
                                 "the base is not on the solid's lattice");
        }
    }
    return SF_OK;
}

sf_status sf_handles_place(const sf_grid *solid, const sf_place_options *options,
                           const sf_allocator *allocator, sf_task *task, sf_handle *handles,
                           size_t capacity, size_t *count, sf_fault *fault)
{
    sf_handle found[SF_HANDLE_MAX];
    place p = {.allocator = sfi_allocator_or_default(allocator), .solid = solid};
    p.options = options != NULL ? *options : sf_place_options_default();
    if (solid == NULL || count == NULL || (handles == NULL && capacity > 0)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "a pointer is missing");
    }
    SF_TRY(check(solid, &p.options, fault));
    if (capacity < p.options.count) {
        *count = p.options.count;
        return sfi_fault_set(fault, SF_ERR_CAPACITY, 0, 0, "there are too few places for handles");
    }
    sf_status status = prepare(&p);
    if (status == SF_OK) {
        status = take_all(&p, task, found);
    }
    release(&p);
    if (status != SF_OK) {
        return sfi_fault_set(fault, status, 0, 0, "%s", sf_status_message(status));
    }
    if (p.count == 0) {
        return sfi_fault_set(fault, SF_ERR_INFEASIBLE, 0, 0,
                             "no place is three cells away from the base: give a smaller base");
    }
    memcpy(handles, found, p.count * sizeof *found);
    *count = p.count;
    return SF_OK;
}
