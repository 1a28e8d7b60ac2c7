// SPDX-License-Identifier: MIT
// Voxels out of a mesh: slices one at a time, or a whole grid side by side.
//
// A skin (the snapped mesh, mended) and buckets (its triangles by slab) are prepared once and then
// only read. Lanes hold what changes, one for each piece that runs at the same time. Everything is
// taken before the first voxel is written.
//
// Slices do not depend on each other, and all counts are integers: threads share the read-only part
// and own a lane each, and the result is the same bytes however the work is divided.

#include <sf/mesh.h>

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "mesh/fill.h"
#include "mesh/shell.h"
#include "simd/kernels.h"

#include <string.h>

#define LANES 16u // pieces that run side by side

sf_voxelize_options sf_voxelize_options_default(void)
{
    sf_voxelize_options options = {sizeof(sf_voxelize_options), SF_FILL_AUTO};
    return options;
}

static sf_status check_arguments(sf_mesh_view mesh, const sf_lattice *lattice,
                                 const sf_voxelize_options *options, sf_fault *fault)
{
    if (lattice == NULL || (mesh.vertex_count > 0 && mesh.vertices == NULL) ||
        (mesh.triangle_count > 0 && mesh.triangles == NULL)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "The mesh or the lattice is missing.");
    }
    if (options != NULL && (options->struct_size < sizeof(sf_voxelize_options) ||
                            (unsigned)options->fill > SF_FILL_SURFACE)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "The options do not hold a known fill.");
    }
    if (mesh.vertex_count > UINT32_MAX || mesh.triangle_count > UINT32_MAX) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "The mesh has more than 4294967295 vertices or triangles.");
    }
    sf_status status = sf_lattice_validate(lattice);
    return status == SF_OK
               ? SF_OK
               : sfi_fault_set(fault, status, 0, 0,
                               "The lattice needs counts within limits and positive pitches.");
}

static void release(sf_voxelizer *v)
{
    sfi_buckets_destroy(&v->buckets, &v->allocator);
    sfi_skin_destroy(&v->skin, &v->allocator);
    sfi_frame_destroy(&v->frame, &v->allocator);
}

// Everything but the lanes.
static sf_status prepare(sf_voxelizer *v, sf_mesh_view mesh, const sf_lattice *lattice,
                         const sf_voxelize_options *options, const sf_allocator *allocator,
                         sf_fault *fault)
{
    memset(v, 0, sizeof *v);
    SF_TRY(check_arguments(mesh, lattice, options, fault));
    v->allocator = sfi_allocator_or_default(allocator);
    v->fill = options != NULL ? options->fill : SF_FILL_AUTO;
    SF_TRY(sfi_frame_create(lattice, &v->allocator, &v->frame, fault));
    sf_status status = sfi_skin_create(mesh, &v->frame, v->fill, &v->allocator, &v->skin, fault);
    if (status == SF_OK) {
        status = sfi_buckets_create(&v->frame, &v->skin,
                                    v->fill == SF_FILL_SURFACE ? sfi_shell_reach : sfi_fill_reach,
                                    &v->allocator, &v->buckets);
        if (status != SF_OK) {
            sfi_fault_set(fault, status, 0, 0, "%s", sf_status_message(status));
        }
    }
    if (status != SF_OK) {
        release(v);
    }
    return status;
}

sf_status sf_voxelizer_create(sf_mesh_view mesh, const sf_lattice *lattice,
                              const sf_voxelize_options *options, const sf_allocator *allocator,
                              sf_voxelizer **voxelizer, sf_fault *fault)
{
    if (voxelizer == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_voxelizer made;
    SF_TRY(prepare(&made, mesh, lattice, options, allocator, fault));
    sf_voxelizer *v = sfi_alloc_array(&made.allocator, 1, sizeof *v);
    if (v == NULL || sfi_fill_lane_create(&made, &made.lane) != SF_OK) {
        sfi_free_array(&made.allocator, v, 1, sizeof *v);
        release(&made);
        return sfi_fault_set(fault, SF_ERR_MEMORY, 0, 0, "%s", sf_status_message(SF_ERR_MEMORY));
    }
    *v = made;
    *voxelizer = v;
    return SF_OK;
}

void sf_voxelizer_destroy(sf_voxelizer *voxelizer)
{
    if (voxelizer != NULL) {
        sf_allocator allocator = voxelizer->allocator;
        sfi_fill_lane_destroy(&voxelizer->lane, &allocator);
        release(voxelizer);
        sfi_free_array(&allocator, voxelizer, 1, sizeof *voxelizer);
    }
}

sf_status sf_voxelizer_slice(sf_voxelizer *voxelizer, uint32_t k, sf_slice slice)
{
    if (voxelizer == NULL || slice.words == NULL || k >= voxelizer->frame.nz ||
        slice.stride < sfi_row_words(slice.width)) {
        return SF_ERR_ARGUMENT;
    }
    if (slice.width != voxelizer->frame.nx || slice.height != voxelizer->frame.ny) {
        return SF_ERR_SHAPE;
    }
    sfi_target to = {NULL, slice, NULL};
    sfi_fill_layers(voxelizer, &voxelizer->lane, k, k + 1, &to);
    return SF_OK;
}

static void report_lane(const sf_voxelizer *v, const sfi_fill_lane *lane,
                        sf_voxelize_report *report)
{
    report->fill = v->fill == SF_FILL_AUTO ? SF_FILL_WINDING : v->fill;
    report->boundary_edges = v->skin.boundary_edges;
    report->flipped = v->skin.flipped;
    report->odd_rows += lane->rows.odd_rows;
    report->solid_voxels += lane->rows.solid_voxels;
}

sf_status sf_voxelizer_report(const sf_voxelizer *voxelizer, sf_voxelize_report *report)
{
    if (voxelizer == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    memset(report, 0, sizeof *report);
    report_lane(voxelizer, &voxelizer->lane, report);
    return SF_OK;
}

// A round of slabs, one a lane.
typedef struct slabs {
    const sf_voxelizer *voxelizer;
    sfi_fill_lane *lanes;
    sfi_target to;
    uint32_t first_slab;
} slabs;

static void fill_slab(void *context, size_t index)
{
    const slabs *r = context;
    const sf_voxelizer *v = r->voxelizer;
    uint32_t layers = v->buckets.layers, k0 = (r->first_slab + (uint32_t)index) * layers;
    uint32_t k1 = layers < v->frame.nz - k0 ? k0 + layers : v->frame.nz;
    sfi_fill_layers(v, &r->lanes[index], k0, k1, &r->to);
}

static void copy_layers(sf_grid *to, const sf_grid *from, uint32_t nz)
{
    for (uint32_t k = 0; k < nz; k++) {
        sf_slice target = sf_grid_slice(to, k), source = sf_grid_slice(from, k);
        for (uint32_t y = 0; y < target.height; y++) {
            memcpy(target.words + (size_t)y * target.stride,
                   source.words + (size_t)y * source.stride, sfi_row_words(target.width) * 8);
        }
    }
}

static void clear_layers(sf_grid *grid, uint32_t nz)
{
    for (uint32_t k = 0; k < nz; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        for (uint32_t y = 0; y < slice.height; y++) {
            memset(slice.words + (size_t)y * slice.stride, 0, sfi_row_words(slice.width) * 8);
        }
    }
}

// Fill slab after slab, until the end or a cancel.
static sf_status fill_slabs(const sf_voxelizer *v, sfi_fill_lane *lanes, uint32_t lane_count,
                            sf_grid *grid, sf_task *task)
{
    sfi_progress progress = sfi_progress_begin(task);
    slabs r = {v, lanes, {grid, {NULL, 0, 0, 0}, task}, 0};
    while (r.first_slab < v->buckets.slab_count) {
        uint32_t left = v->buckets.slab_count - r.first_slab;
        sfi_task_for(task, left < lane_count ? left : lane_count, fill_slab, &r);
        if (sf_task_is_cancelled(task)) { // the slabs saw it, too, and may have left early
            return SF_ERR_CANCELLED;
        }
        r.first_slab += left < lane_count ? left : lane_count;
        sfi_progress_report(&progress, r.first_slab, v->buckets.slab_count);
    }
    return SF_OK;
}

// A cancel must leave the grid as it was. An empty one is cleared again; one that holds something
// is filled aside and copied when nothing can stop it any more. Without a task there is no cancel.
static sf_status fill_grid(const sf_voxelizer *v, sfi_fill_lane *lanes, uint32_t lane_count,
                           sf_grid *grid, sf_task *task)
{
    if (task == NULL || sf_grid_popcount(grid) == 0) {
        sf_status status = fill_slabs(v, lanes, lane_count, grid, task);
        if (status != SF_OK) {
            clear_layers(grid, v->frame.nz);
        }
        return status;
    }
    sf_grid *aside = NULL;
    sf_lattice lattice = sf_grid_lattice(grid);
    SF_TRY(sf_grid_create(&lattice, &v->allocator, &aside));
    sf_status status = fill_slabs(v, lanes, lane_count, aside, task);
    if (status == SF_OK) {
        copy_layers(grid, aside, v->frame.nz);
    }
    sf_grid_destroy(aside);
    return status;
}

static sf_status fill_with_lanes(const sf_voxelizer *v, sf_grid *grid, sf_task *task,
                                 sf_voxelize_report *report)
{
    sfi_fill_lane lanes[LANES];
    uint32_t lane_count = task != NULL && task->parallel_for != NULL ? LANES : 1, made = 0;
    lane_count = lane_count < v->buckets.slab_count ? lane_count : v->buckets.slab_count;
    sf_status status = SF_OK;
    while (made < lane_count && status == SF_OK) {
        status = sfi_fill_lane_create(v, &lanes[made]);
        made += status == SF_OK;
    }
    if (status == SF_OK) {
        status = fill_grid(v, lanes, lane_count, grid, task);
    }
    if (status == SF_OK && report != NULL) {
        memset(report, 0, sizeof *report);
        for (uint32_t i = 0; i < made; i++) {
            report_lane(v, &lanes[i], report);
        }
    }
    while (made > 0) {
        sfi_fill_lane_destroy(&lanes[--made], &v->allocator);
    }
    return status;
}

sf_status sf_grid_voxelize(sf_grid *grid, sf_mesh_view mesh, const sf_voxelize_options *options,
                           const sf_allocator *allocator, sf_task *task, sf_voxelize_report *report)
{
    if (grid == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_voxelizer v;
    sf_lattice lattice = sf_grid_lattice(grid);
    SF_TRY(prepare(&v, mesh, &lattice, options, allocator, NULL));
    sf_status status = fill_with_lanes(&v, grid, task, report);
    release(&v);
    return status;
}
