// SPDX-License-Identifier: MIT
// Samplers: a skin tells which voxels are solid, a walk along rows what they are.
//
// Each slice begins anew, so that it does not depend on what was sliced before; within it, a row
// begins where the row before was. What does not arrive from a neighbour is searched for, and what
// is nowhere, in the crevice between the skin and the shape, gets what its neighbour in the row
// has.

#include <sf/sample.h>

#include "base/bits.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "grade/sample/skin.h"
#include "grade/sample/walk.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

// Further properties, up to four of one layout.
typedef struct others {
    sfi_tree tree;
    uint32_t layout, count;
    size_t planes[SFI_TREE_WIDTH]; // which of the slice's planes they are
} others;

struct sf_sampler {
    sf_allocator allocator;
    sf_lattice lattice; // without heights of its own: bottoms[] holds them
    double *bottoms;    // of layers, and the top
    sfi_skin skin;
    sf_voxelizer *voxelizer;
    sf_locator *locator;
    sfi_walker walker;
    size_t channel_count;
    size_t first_plane; // the property that goes along with positions; channel_count: none
    size_t other_count;
    others *others;
    size_t others_capacity;
    sf_place *below; // of the row before
    sf_sample_report report;
};

sf_sample_options sf_sample_options_default(void)
{
    sf_sample_options options = {sizeof options, 0.05};
    return options;
}

void sf_sampler_destroy(sf_sampler *sampler)
{
    if (sampler == NULL) {
        return;
    }
    sf_allocator allocator = sampler->allocator;
    for (size_t i = 0; i < sampler->other_count; i++) {
        sfi_tree_free(&sampler->others[i].tree);
    }
    sfi_free_array(&allocator, sampler->others, sampler->others_capacity, sizeof(others));
    sfi_tree_free(&sampler->walker.tree);
    sf_voxelizer_destroy(sampler->voxelizer);
    sf_locator_destroy(sampler->locator);
    sfi_skin_free(&sampler->skin);
    sfi_free_array(&allocator, sampler->below, sampler->lattice.nx, sizeof *sampler->below);
    sfi_free_array(&allocator, sampler->bottoms, (size_t)sampler->lattice.nz + 1, sizeof(double));
    sfi_free_array(&allocator, sampler, 1, sizeof *sampler);
}

// ---------------------------------------------------------------------------------------------
// Making
// ---------------------------------------------------------------------------------------------

static double smallest_pitch(const sf_lattice *l)
{
    double least = l->pitch_x_mm < l->pitch_y_mm ? l->pitch_x_mm : l->pitch_y_mm;
    for (uint32_t k = 0; k < l->nz; k++) {
        double height = sf_lattice_layer_height(l, k);
        least = height < least ? height : least;
    }
    return least;
}

static sf_status check(const sf_limit *limit, const sf_lattice *lattice,
                       const sf_sample_options *options, size_t channel_count,
                       const size_t *channels, sf_fault *fault)
{
    if (limit == NULL || lattice == NULL || options->struct_size != sizeof *options ||
        !(options->tolerance > 0 && options->tolerance <= 1) || channel_count > SF_PROPERTY_MAX ||
        (channel_count > 0 && channels == NULL)) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_lattice_validate(lattice));
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
    uint64_t plane = (uint64_t)lattice->nx * lattice->ny;
    if (plane > SF_SAMPLE_VOXEL_MAX / lattice->nz) {
        return sfi_fault_set(
            fault, SF_ERR_OVERFLOW, 0, 0,
            "the lattice has %lu x %lu x %lu voxels, more than 2^40; make the pitch "
            "larger",
            (unsigned long)lattice->nx, (unsigned long)lattice->ny, (unsigned long)lattice->nz);
    }
    return SF_OK;
}

static sf_status begin_walker(const sf_limit *limit, double speck, sf_sampler *s,
                              const size_t *channels)
{
    const sf_refinement *r = limit->refined;
    sfi_tree_source sources[SFI_TREE_WIDTH];
    for (uint32_t axis = 0; axis < 3; axis++) {
        sfi_tree_source source = {r->positions[1] + axis, 3};
        sources[axis] = source;
    }
    sources[3].values = NULL;
    sources[3].stride = 1;
    s->first_plane = s->channel_count;
    for (size_t i = 0; i < s->channel_count && s->first_plane == s->channel_count; i++) {
        if (r->channels[channels[i]].layout == 0) {
            sources[3].values = r->channels[channels[i]].values[1];
            s->first_plane = i;
        }
    }
    s->walker.corners = r->layouts[0].corners[1];
    s->walker.locator = s->locator;
    return sfi_tree_begin(&limit->charts[0], sources, speck, &s->allocator, &s->walker.tree);
}

// Put the other properties together by their layouts.
static sf_status begin_others(const sf_limit *limit, double speck, sf_sampler *s,
                              const size_t *channels)
{
    uint8_t done[SF_PROPERTY_MAX] = {0};
    for (size_t i = 0; i < s->channel_count; i++) {
        if (done[i] || i == s->first_plane) {
            continue;
        }
        if (!sfi_grow_array(&s->allocator, (void **)&s->others, &s->others_capacity,
                            s->other_count + 1, sizeof *s->others)) {
            return SF_ERR_MEMORY;
        }
        others *o = &s->others[s->other_count];
        sfi_tree_source sources[SFI_TREE_WIDTH] = {{NULL, 1}, {NULL, 1}, {NULL, 1}, {NULL, 1}};
        memset(o, 0, sizeof *o);
        o->layout = limit->refined->channels[channels[i]].layout;
        for (size_t j = i; j < s->channel_count && o->count < SFI_TREE_WIDTH; j++) {
            const sfi_refined_channel *c = &limit->refined->channels[channels[j]];
            if (!done[j] && j != s->first_plane && c->layout == o->layout) {
                done[j] = 1;
                sources[o->count].values = c->values[1];
                o->planes[o->count++] = j;
            }
        }
        SF_TRY(sfi_tree_begin(&limit->charts[o->layout], sources, speck, &s->allocator, &o->tree));
        s->other_count++;
    }
    return SF_OK;
}

static sf_status fill(const sf_limit *limit, const sf_lattice *lattice,
                      const sf_sample_options *options, const size_t *channels, sf_task *task,
                      sf_sampler *s, sf_fault *fault)
{
    const sf_allocator *allocator = &s->allocator;
    double pitch = smallest_pitch(lattice);
    s->bottoms = sfi_alloc_array(allocator, (size_t)lattice->nz + 1, sizeof *s->bottoms);
    s->below = sfi_alloc_array(allocator, lattice->nx, sizeof *s->below);
    if (s->bottoms == NULL || s->below == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t k = 0; k <= lattice->nz; k++) {
        s->bottoms[k] = k == 0 ? lattice->origin_mm[2]
                               : s->bottoms[k - 1] + sf_lattice_layer_height(lattice, k - 1);
    }
    SF_TRY(sfi_skin_make(limit, options->tolerance * pitch, allocator, task, &s->skin));
    sf_mesh_view surface = sf_sampler_surface(s, NULL);
    SF_TRY(sf_voxelizer_create(surface, lattice, NULL, allocator, &s->voxelizer, fault));
    SF_TRY(sf_locator_create(limit, allocator, &s->locator));
    s->walker.reach = 2 * s->skin.error_mm + pitch;
    SF_TRY(begin_walker(limit, pitch / 64, s, channels));
    return begin_others(limit, pitch / 64, s, channels);
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
    SF_TRY(check(limit, lattice, &given, channel_count, channels, fault));
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_sampler *made = sfi_alloc_array(&kept, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = kept;
    made->lattice = *lattice;
    made->lattice.heights_mm = NULL;
    made->channel_count = channel_count;
    sf_status status = fill(limit, lattice, &given, channels, task, made, fault);
    if (status != SF_OK) {
        sf_sampler_destroy(made);
        return status;
    }
    *sampler = made;
    return SF_OK;
}

sf_mesh_view sf_sampler_surface(const sf_sampler *sampler, double *error_mm)
{
    sf_mesh_view view = {NULL, 0, NULL, 0};
    if (sampler != NULL) {
        view.vertices = sampler->skin.vertices;
        view.vertex_count = sampler->skin.vertex_count;
        view.triangles = sampler->skin.triangles;
        view.triangle_count = sampler->skin.triangle_count;
        if (error_mm != NULL) {
            *error_mm = sampler->skin.error_mm;
        }
    }
    return view;
}

sf_status sf_sampler_report(const sf_sampler *sampler, sf_sample_report *report)
{
    if (sampler == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    *report = sampler->report;
    report->located = sampler->walker.located;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Slices
// ---------------------------------------------------------------------------------------------

// One row: its planes' numbers, and where its voxels' centres lie.
typedef struct row {
    sf_sampler *s;
    const uint64_t *words;
    double *const *values; // planes
    size_t offset;         // of the row in them
    double y, z;
} row;

static int is_solid(const uint64_t *words, uint32_t x)
{
    return (int)(words[x / 64] >> x % 64 & 1);
}

static void read_others(sf_sampler *s, const sf_place *place, double *const *values, size_t at)
{
    for (size_t i = 0; i < s->other_count; i++) {
        others *o = &s->others[i];
        double local[3], found[SFI_TREE_WIDTH];
        const sfi_leaf *leaf = sfi_tree_leaf(&o->tree, place->piece, place->u);
        for (uint32_t axis = 0; axis < 3; axis++) {
            local[axis] = (place->u[axis] - leaf->origin[axis]) / leaf->size;
        }
        sfi_leaf_at(leaf, local, found, NULL);
        for (uint32_t j = 0; j < o->count; j++) {
            values[o->planes[j]][at] = found[j];
        }
    }
}

static void copy_values(const sf_sampler *s, double *const *values, size_t from, size_t to)
{
    for (size_t i = 0; i < s->channel_count; i++) {
        values[i][to] = values[i][from];
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

// Voxels at the begin of a run that are nowhere get what the first that is somewhere has.
static void fill_back(const row *r, uint32_t from, uint32_t to)
{
    for (uint32_t x = from; x < to; x++) {
        copy_values(r->s, r->values, r->offset + to, r->offset + x);
    }
}

// One run of solid voxels, from x on. Returns where it ends.
static uint32_t walk_run(const row *r, uint32_t x)
{
    static const sf_place nowhere = {SF_NO_PIECE, {0, 0, 0}};
    sf_sampler *s = r->s;
    sf_place last = nowhere, here = s->below[x];
    uint32_t first = x;
    int found = 0; // any voxel of the run so far
    for (; x < s->lattice.nx && is_solid(r->words, x); x++) {
        double point[3] = {s->lattice.origin_mm[0] + (x + 0.5) * s->lattice.pitch_x_mm, r->y, r->z};
        double value = 0;
        sf_place next = predict(&last, &here);
        s->report.solid++;
        if (!sfi_walk_to(&s->walker, point, &next, &value)) {
            s->report.filled++;
            s->below[x] = nowhere;
            if (found) {
                copy_values(s, r->values, r->offset + x - 1, r->offset + x);
            }
            continue;
        }
        if (s->first_plane < s->channel_count) {
            r->values[s->first_plane][r->offset + x] = value;
        }
        read_others(s, &next, r->values, r->offset + x);
        if (!found) {
            fill_back(r, first, x);
        }
        found = 1;
        last = here;
        here = next;
        s->below[x] = next;
    }
    return x;
}

static void walk_row(const row *r)
{
    uint32_t nx = r->s->lattice.nx;
    for (uint32_t x = 0; x < nx;) {
        if (is_solid(r->words, x)) {
            x = walk_run(r, x);
        } else {
            r->s->below[x++].piece = SF_NO_PIECE;
        }
    }
}

sf_status sf_sampler_slice(sf_sampler *sampler, uint32_t k, sf_slice solid, double *const *values)
{
    if (sampler == NULL || k >= sampler->lattice.nz ||
        (sampler->channel_count > 0 && values == NULL)) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < sampler->channel_count; i++) {
        if (values[i] == NULL) {
            return SF_ERR_ARGUMENT;
        }
    }
    SF_TRY(sf_voxelizer_slice(sampler->voxelizer, k, solid));
    const sf_lattice *l = &sampler->lattice;
    size_t plane = (size_t)l->nx * l->ny;
    for (size_t i = 0; i < sampler->channel_count; i++) {
        memset(values[i], 0, plane * sizeof *values[i]);
    }
    memset(sampler->below, 0xff, l->nx * sizeof *sampler->below); // nowhere
    for (uint32_t y = 0; sampler->channel_count > 0 && y < l->ny; y++) {
        row r = {sampler,
                 sfi_slice_row(solid, y),
                 values,
                 (size_t)l->nx * y,
                 l->origin_mm[1] + (y + 0.5) * l->pitch_y_mm,
                 (sampler->bottoms[k] + sampler->bottoms[k + 1]) / 2};
        walk_row(&r);
    }
    return SF_OK;
}
