// SPDX-License-Identifier: MIT
// What voxels of a limit are: a walk along their rows.
//
// Each slice begins anew, so that it does not depend on what was sliced before; within it, a row
// begins where the row before was. What does not arrive from a neighbour is searched for, and what
// is nowhere, in the crevice between the skin and the shape, gets what its neighbour in the row
// has.

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "grade/sample/sampler.h"
#include "grade/sample/skin.h"
#include "grade/sample/walk.h"
#include "voxel/slice.h"

#include <string.h>

// Further properties, up to four of one layout.
typedef struct others {
    sfi_tree tree;
    uint32_t layout, count;
    size_t planes[SFI_TREE_WIDTH]; // which of the slice's planes they are
} others;

typedef struct rows {
    sf_allocator allocator;
    sfi_skin skin;
    sf_locator *locator;
    sfi_walker walker;
    size_t first_plane; // the property that goes along with positions; channel_count: none
    size_t other_count, others_capacity;
    others *others;
    uint32_t width;
    sf_place *below; // of the row before
} rows;

static void destroy_rows(void *state)
{
    rows *r = state;
    sf_allocator allocator = r->allocator;
    for (size_t i = 0; i < r->other_count; i++) {
        sfi_tree_free(&r->others[i].tree);
    }
    sfi_free_array(&allocator, r->others, r->others_capacity, sizeof(others));
    sfi_tree_free(&r->walker.tree);
    sf_locator_destroy(r->locator);
    sfi_skin_free(&r->skin);
    sfi_free_array(&allocator, r->below, r->width, sizeof *r->below);
    sfi_free_array(&allocator, r, 1, sizeof *r);
}

// ---------------------------------------------------------------------------------------------
// Walking
// ---------------------------------------------------------------------------------------------

static const sf_place nowhere = {SF_NO_PIECE, {0, 0, 0}};

// One row: its planes' numbers, and where its voxels' centres lie.
typedef struct row {
    sf_sampler *s;
    rows *rows;
    const uint64_t *words;
    double *const *values; // planes
    size_t offset;         // of the row in them
    double y, z;
} row;

static int is_solid(const uint64_t *words, uint32_t x)
{
    return (int)(words[x / 64] >> x % 64 & 1);
}

static void read_others(rows *r, const sf_place *place, double *const *values, size_t at)
{
    for (size_t i = 0; i < r->other_count; i++) {
        others *o = &r->others[i];
        double found[SFI_TREE_WIDTH];
        sfi_tree_at(&o->tree, place, found);
        for (uint32_t j = 0; j < o->count; j++) {
            values[o->planes[j]][at] = found[j];
        }
    }
}

// Where the next voxel is likely to be: as far as this one was from the last, in the same piece.
static sf_place predict(const sf_place *last, const sf_place *here)
{
    sf_place next = *here;
    for (uint32_t axis = 0; last->piece == here->piece && axis < 3; axis++) {
        next.u[axis] += here->u[axis] - last->u[axis];
    }
    return next;
}

// Go to voxel x from a place. Returns 0 if it is nowhere.
static int step_to(const row *r, uint32_t x, sf_place *place)
{
    double point[3] = {sfi_middle(&r->s->lattice, 0, x), r->y, r->z}, value = 0;
    if (!sfi_walk_to(&r->rows->walker, point, place, &value)) {
        return 0;
    }
    if (r->rows->first_plane < r->s->channel_count) {
        r->values[r->rows->first_plane][r->offset + x] = value;
    }
    read_others(r->rows, place, r->values, r->offset + x);
    return 1;
}

// One run of solid voxels, from x on. Returns where it ends.
static uint32_t walk_run(const row *r, uint32_t x)
{
    sf_place last = nowhere, here = r->rows->below[x];
    uint32_t first = x;
    int found = 0; // any voxel of the run so far
    for (; x < r->s->lattice.nx && is_solid(r->words, x); x++) {
        sf_place next = predict(&last, &here);
        if (!step_to(r, x, &next)) {
            r->s->report.filled++;
            r->rows->below[x] = nowhere;
            if (found) {
                sfi_copy_values(r->s, r->values, r->offset + x - 1, r->offset + x);
            }
            continue;
        }
        for (uint32_t before = first; !found && before < x; before++) {
            sfi_copy_values(r->s, r->values, r->offset + x, r->offset + before);
        }
        found = 1;
        last = here;
        here = next;
        r->rows->below[x] = next;
    }
    return x;
}

static void walk_row(const row *r)
{
    for (uint32_t x = 0; x < r->s->lattice.nx;) {
        if (is_solid(r->words, x)) {
            x = walk_run(r, x);
        } else {
            r->rows->below[x++] = nowhere;
        }
    }
}

static sf_status tell(void *state, sf_sampler *s, uint32_t k, double z, sf_slice solid,
                      double *const *values)
{
    rows *r = state;
    (void)k;
    for (uint32_t x = 0; x < s->lattice.nx; x++) {
        r->below[x] = nowhere;
    }
    for (uint32_t y = 0; y < s->lattice.ny; y++) {
        row here = {s,
                    r,
                    sfi_slice_row(solid, y),
                    values,
                    (size_t)s->lattice.nx * y,
                    sfi_middle(&s->lattice, 1, y),
                    z};
        walk_row(&here);
    }
    s->report.located = r->walker.located;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Making
// ---------------------------------------------------------------------------------------------

static sf_status begin_walker(const sf_limit *limit, double speck, rows *r, size_t channel_count,
                              const size_t *channels)
{
    const sf_refinement *refined = limit->refined;
    sfi_tree_source sources[SFI_TREE_WIDTH];
    for (uint32_t axis = 0; axis < 3; axis++) {
        sfi_tree_source source = {refined->positions[1] + axis, 3};
        sources[axis] = source;
    }
    sources[3].values = NULL;
    sources[3].stride = 1;
    r->first_plane = channel_count;
    for (size_t i = 0; i < channel_count && r->first_plane == channel_count; i++) {
        if (refined->channels[channels[i]].layout == 0) {
            sources[3].values = refined->channels[channels[i]].values[1];
            r->first_plane = i;
        }
    }
    r->walker.corners = refined->layouts[0].corners[1];
    r->walker.locator = r->locator;
    return sfi_tree_begin(&limit->charts[0], sources, speck, &r->allocator, &r->walker.tree);
}

// Put the other properties together by their layouts.
static sf_status begin_others(const sf_limit *limit, double speck, rows *r, size_t channel_count,
                              const size_t *channels)
{
    uint8_t done[SF_PROPERTY_MAX] = {0};
    for (size_t i = 0; i < channel_count; i++) {
        if (done[i] || i == r->first_plane) {
            continue;
        }
        if (!sfi_grow_array(&r->allocator, (void **)&r->others, &r->others_capacity,
                            r->other_count + 1, sizeof *r->others)) {
            return SF_ERR_MEMORY;
        }
        others *o = &r->others[r->other_count];
        sfi_tree_source sources[SFI_TREE_WIDTH] = {{NULL, 1}, {NULL, 1}, {NULL, 1}, {NULL, 1}};
        memset(o, 0, sizeof *o);
        o->layout = limit->refined->channels[channels[i]].layout;
        for (size_t j = i; j < channel_count && o->count < SFI_TREE_WIDTH; j++) {
            const sfi_refined_channel *c = &limit->refined->channels[channels[j]];
            if (!done[j] && j != r->first_plane && c->layout == o->layout) {
                done[j] = 1;
                sources[o->count].values = c->values[1];
                o->planes[o->count++] = j;
            }
        }
        SF_TRY(sfi_tree_begin(&limit->charts[o->layout], sources, speck, &r->allocator, &o->tree));
        r->other_count++;
    }
    return SF_OK;
}

static sf_status fill(const sf_limit *limit, const sf_lattice *lattice, double tolerance,
                      const size_t *channels, sf_task *task, sf_sampler *s, rows *r,
                      sf_fault *fault)
{
    double pitch = sfi_smallest_pitch(lattice);
    r->width = lattice->nx;
    r->below = sfi_alloc_array(&r->allocator, lattice->nx, sizeof *r->below);
    if (r->below == NULL) {
        return SF_ERR_MEMORY;
    }
    SF_TRY(sfi_skin_make(limit, tolerance * pitch, &r->allocator, task, &r->skin));
    sf_mesh_view surface = {r->skin.vertices, r->skin.vertex_count, r->skin.triangles,
                            r->skin.triangle_count};
    SF_TRY(sfi_sampler_surface(s, lattice, surface, r->skin.error_mm, fault));
    SF_TRY(sf_locator_create(limit, &r->allocator, &r->locator));
    r->walker.reach = 2 * r->skin.error_mm + pitch;
    SF_TRY(begin_walker(limit, pitch / 64, r, s->channel_count, channels));
    return begin_others(limit, pitch / 64, r, s->channel_count, channels);
}

static sf_status check(const sf_limit *limit, const sf_sample_options *options,
                       size_t channel_count, const size_t *channels, sf_fault *fault)
{
    if (limit == NULL || options->struct_size != sizeof *options ||
        !(options->tolerance > 0 && options->tolerance <= 1) ||
        (channel_count > 0 && channels == NULL)) {
        return SF_ERR_ARGUMENT;
    }
    if (limit->refined->dimension != 3) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "the cage is a surface; a solid has cells of 4 corners or more");
    }
    for (size_t i = 0; i < channel_count; i++) {
        if (channels[i] >= limit->refined->channel_count) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "there is no property %zu",
                                 channels[i]);
        }
    }
    return SF_OK;
}

sf_status sf_sampler_create(const sf_limit *limit, const sf_lattice *lattice,
                            const sf_sample_options *options, size_t channel_count,
                            const size_t *channels, const sf_allocator *allocator, sf_task *task,
                            sf_sampler **sampler, sf_fault *fault)
{
    sf_sample_options given = options != NULL ? *options : sf_sample_options_default();
    if (sampler == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(check(limit, &given, channel_count, channels, fault));
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_sampler *made = NULL;
    SF_TRY(sfi_sampler_begin(lattice, channel_count, &kept, &made, fault));
    rows *r = sfi_alloc_array(&kept, 1, sizeof *r);
    if (r == NULL) {
        sf_sampler_destroy(made);
        return SF_ERR_MEMORY;
    }
    memset(r, 0, sizeof *r);
    r->allocator = kept;
    sfi_teller teller = {r, tell, destroy_rows};
    made->teller = teller;
    sf_status status = fill(limit, lattice, given.tolerance, channels, task, made, r, fault);
    if (status != SF_OK) {
        sf_sampler_destroy(made);
        return status;
    }
    *sampler = made;
    return SF_OK;
}
