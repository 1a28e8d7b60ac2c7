// SPDX-License-Identifier: MIT
// Orientation: many directions cheaply, some of them as voxels, few of them closely.
//
// The three rounds cost about the same: a thousand sums over triangles, some eighty grids of 64^3,
// six grids at the resolution that was asked for. Every round ranks by what cannot print first and
// by height; the last two know how safely the part stands, and what is lost for what it is, by
// trimming. The mesh as it is given takes part in the last round whatever the others say.
//
// All orientations have one voxel size, made from the mesh as it is given; else a direction would
// win by being looked at less closely. Coordinates are turned into an array of their own, so the
// mesh is never copied whole.
//
// Ranks are total orders (score, unsupported area, index of the direction), the sums behind them
// are in a fixed order, and voxels are exact: the result does not depend on threads. Grids are made
// one after the other, because memory comes from the calling thread; inside, voxelisation uses the
// task's threads.
//
// Source of the cheap score: C. Schranz, "Tweaker - Auto Rotation Module for FDM 3D Printing",
// 2016.

#include <sf/orient.h>

#include "base/math.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"
#include "orient/score.h"
#include "orient/stand.h"

#include <math.h>
#include <string.h>

#define HALF_PI 1.5707963267948966

// What a step of each round weighs in the progress that the host sees; the first report comes when
// the first round has said how long the second one is.
enum { CHEAP_WORK = 10, COARSE_WORK = 1, FINE_WORK = 8 };

// A direction in the running.
typedef struct runner {
    size_t index, at;      // the direction; where its figures are, once it was looked at closely
    double score, hanging; // smaller is better
} runner;

typedef struct hunt {
    sf_mesh_view mesh;
    sf_orient_options options;
    sf_allocator allocator;
    sf_task *task;
    sf_task silent; // the same threads, without progress
    sfi_progress progress;
    uint64_t done, total;
    double longest_mm;
    sfi_facing facing;
    sfi_facet *facets;
    double *turned; // coordinates of all vertices, turned
    double (*up)[3];
    sfi_cheap *cheap;
    runner *runners;
    size_t most, count; // room for directions; directions
    sf_orientation *found;
    runner *finals;
    size_t found_count;
} hunt;

// ---------------------------------------------------------------------------------------------
// One direction, as voxels
// ---------------------------------------------------------------------------------------------

// Turn all vertices that triangles use, and find the box around them.
static void turn(hunt *h, const double matrix[9], double low[3], double high[3])
{
    for (size_t i = 0; i < h->mesh.vertex_count; i++) {
        const double *p = h->mesh.vertices + 3 * i;
        for (int d = 0; d < 3; d++) {
            const double *row = matrix + 3 * d;
            h->turned[3 * i + (size_t)d] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2];
        }
    }
    for (int d = 0; d < 3; d++) {
        low[d] = INFINITY;
        high[d] = -INFINITY;
    }
    for (size_t i = 0; i < 3 * h->mesh.triangle_count; i++) {
        const double *p = h->turned + 3 * (size_t)h->mesh.triangles[i];
        for (int d = 0; d < 3; d++) {
            low[d] = p[d] < low[d] ? p[d] : low[d];
            high[d] = p[d] > high[d] ? p[d] : high[d];
        }
    }
}

static sf_status make_lattice(double pitch_mm, const double low[3], const double high[3],
                              sf_lattice *lattice)
{
    uint32_t counts[3];
    for (int d = 0; d < 3; d++) {
        // What sticks out by a millionth of a voxel is rounding.
        double count = -floor(1e-6 - (high[d] - low[d]) / pitch_mm);
        counts[d] = count < 1 ? 1 : (uint32_t)count; // at most sqrt(3) * 16384 + 1
    }
    sf_lattice made = {
        counts[0] + 2, counts[1] + 2, counts[2], pitch_mm,
        pitch_mm,      pitch_mm,      NULL,      {low[0] - pitch_mm, low[1] - pitch_mm, low[2]}};
    *lattice = made;
    return sf_lattice_validate(lattice);
}

// Fill the grid, and find what a trim takes and how it stands.
static sf_status measure(hunt *h, sf_grid *grid, sf_orientation *o)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    sf_mesh_view turned = {h->turned, h->mesh.vertex_count, h->mesh.triangles,
                           h->mesh.triangle_count};
    sf_voxelize_options fill = sf_voxelize_options_default();
    sf_trim_report trimmed;
    sf_rule rule;
    fill.fill = h->options.fill;
    SF_TRY(sf_rule_make(h->options.rule, h->options.angle_rad, &lattice, NULL, &rule, NULL));
    SF_TRY(sf_grid_voxelize(grid, turned, &fill, &h->allocator, &h->silent, NULL));
    SF_TRY(sfi_stand_margin(grid, &h->allocator, &o->margin_rad));
    SF_TRY(sf_grid_trim(grid, &rule, SF_BED_AUTO, &h->silent, &trimmed));
    o->solid_voxels = trimmed.kept_voxels + trimmed.removed_voxels;
    o->trimmed_voxels = trimmed.removed_voxels;
    o->trimmed_mm3 =
        (double)trimmed.removed_voxels * lattice.layer_mm * lattice.layer_mm * lattice.layer_mm;
    return SF_OK;
}

static double score_of(const hunt *h, const sf_orientation *o)
{
    double lost = o->solid_voxels > 0 ? (double)o->trimmed_voxels / (double)o->solid_voxels : 1;
    return lost + h->options.weight_height * o->height_mm / h->facing.diagonal_mm +
           h->options.weight_margin * (1 - o->margin_rad / HALF_PI);
}

// All figures of a direction, with this many voxels on the longest side of the mesh as given.
static sf_status look(hunt *h, size_t index, uint32_t resolution, sf_orientation *o)
{
    double low[3], high[3];
    sf_lattice lattice;
    sf_grid *grid;
    if (sf_task_is_cancelled(h->task)) {
        return SF_ERR_CANCELLED;
    }
    memset(o, 0, sizeof *o);
    memcpy(o->up, h->up[index], sizeof o->up);
    sfi_direction_turn(o->up, o->turn.matrix);
    turn(h, o->turn.matrix, low, high);
    o->turn.shift_mm[2] = 0 - low[2];
    o->height_mm = high[2] - low[2];
    o->unsupported_mm2 = h->cheap[index].unsupported_mm2;
    SF_TRY(make_lattice(h->longest_mm / resolution, low, high, &lattice));
    SF_TRY(sf_grid_create(&lattice, &h->allocator, &grid));
    sf_status status = measure(h, grid, o);
    sf_grid_destroy(grid);
    o->score = score_of(h, o);
    return status;
}

static void step(hunt *h, uint64_t work)
{
    h->done += work;
    sfi_progress_report(&h->progress, h->done, h->total);
}

// ---------------------------------------------------------------------------------------------
// Rounds
// ---------------------------------------------------------------------------------------------

static int is_better(const runner *a, const runner *b)
{
    if (a->score != b->score) {
        return a->score < b->score;
    }
    return a->hanging != b->hanging ? a->hanging < b->hanging : a->index < b->index;
}

// Put the best `wanted` runners first, in order; returns how many there are. Each is inserted where
// it belongs: `wanted` is small.
static size_t choose(runner *runners, size_t count, size_t wanted)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        runner moving = runners[i];
        size_t at = kept < wanted ? kept++ : wanted;
        while (at > 0 && is_better(&moving, &runners[at - 1])) {
            if (at < wanted) {
                runners[at] = runners[at - 1];
            }
            at--;
        }
        if (at < wanted) {
            runners[at] = moving;
        }
    }
    return kept;
}

// The axes and the flat faces stay in the running whatever their score, and come first; of the
// spread the best do.
static sf_status first_round(hunt *h)
{
    size_t spread = h->options.direction_count;
    SF_TRY(
        sfi_directions(h->facets, h->mesh.triangle_count, spread, &h->allocator, h->up, &h->count));
    sfi_score_all(&h->facing, (const double(*)[3])h->up, h->count, &h->silent, h->cheap);
    for (size_t i = 0; i < h->count; i++) {
        runner r = {i, 0, h->cheap[i].score, h->cheap[i].unsupported_mm2};
        h->runners[i] = r;
    }
    size_t known = h->count - spread;
    h->count = known + choose(h->runners + known, spread, h->options.coarse_count);
    h->total += h->count * COARSE_WORK;
    step(h, CHEAP_WORK);
    return SF_OK;
}

static sf_status second_round(hunt *h)
{
    for (size_t i = 0; i < h->count; i++) {
        sf_orientation o;
        SF_TRY(look(h, h->runners[i].index, h->options.coarse_resolution, &o));
        h->runners[i].score = o.score;
        step(h, COARSE_WORK);
    }
    h->count = choose(h->runners, h->count, h->options.fine_count);
    return SF_OK;
}

static sf_status look_closely(hunt *h, size_t index)
{
    sf_orientation *o = &h->found[h->found_count];
    SF_TRY(look(h, index, h->options.resolution, o));
    runner r = {index, h->found_count, o->score, o->unsupported_mm2};
    h->finals[h->found_count++] = r;
    step(h, FINE_WORK);
    return SF_OK;
}

// The mesh as it is given, direction 0, comes first, whether or not it is still in the running.
static sf_status third_round(hunt *h)
{
    SF_TRY(look_closely(h, 0));
    for (size_t i = 0; i < h->count; i++) {
        if (h->runners[i].index != 0) {
            SF_TRY(look_closely(h, h->runners[i].index));
        }
    }
    return SF_OK;
}

// The best of what was found, into the caller's array; returns how many.
static size_t rank(const hunt *h, sf_orientation *orientations)
{
    size_t count = choose(h->finals, h->found_count, h->options.fine_count);
    for (size_t i = 0; i < count; i++) {
        orientations[i] = h->found[h->finals[i].at];
    }
    return count;
}

// ---------------------------------------------------------------------------------------------
// The call
// ---------------------------------------------------------------------------------------------

sf_orient_options sf_orient_options_default(void)
{
    sf_orient_options options = {sizeof options,
                                 SF_RULE_OCTAGON,
                                 0.78539816339744831,
                                 SF_FILL_AUTO,
                                 1000,
                                 50,
                                 5,
                                 64,
                                 256,
                                 0.02,
                                 0.02};
    return options;
}

static int is_weight(double weight)
{
    return weight >= 0 && weight <= 1000;
}

static sf_status check_options(const sf_orient_options *o)
{
    const sf_lattice cubes = {1, 1, 1, 1, 1, 1, NULL, {0, 0, 0}};
    sf_rule rule;
    int good = o->struct_size >= sizeof *o && o->direction_count <= 100000 &&
               o->coarse_count >= 1 && o->coarse_count <= 10000 && o->fine_count >= 1 &&
               o->fine_count <= 1000 && o->coarse_resolution >= 1 &&
               o->coarse_resolution <= 16384 && o->resolution >= 1 && o->resolution <= 16384 &&
               is_weight(o->weight_height) && is_weight(o->weight_margin) &&
               o->fill >= SF_FILL_AUTO && o->fill <= SF_FILL_SURFACE;
    return good ? sf_rule_make(o->rule, o->angle_rad, &cubes, NULL, &rule, NULL) : SF_ERR_ARGUMENT;
}

// What the cheap score needs to know of the mesh. One with a negative volume is inside out, and the
// voxeliser will turn it.
static sf_status prepare_facing(hunt *h)
{
    double low[3], high[3], square = 0;
    double tangent = h->options.rule == SF_RULE_BOX3 ? 1 : sfi_tan(h->options.angle_rad);
    sf_mass mass;
    SF_TRY(sf_mesh_bounds(h->mesh, low, high));
    SF_TRY(sf_mesh_measure(h->mesh, &mass));
    for (int d = 0; d < 3; d++) {
        double side = high[d] - low[d];
        square += side * side;
        h->longest_mm = side > h->longest_mm ? side : h->longest_mm;
    }
    sfi_facing facing = {h->mesh,
                         h->facets,
                         mass.area_mm2,
                         sqrt(square),
                         tangent / sqrt(1 + tangent * tangent),
                         h->longest_mm / h->options.coarse_resolution / 2,
                         h->options.weight_height};
    h->facing = facing;
    sfi_facets(h->mesh, h->options.fill == SF_FILL_AUTO && mass.volume_mm3 < 0, h->facets);
    return square > 0 && isfinite(square) ? SF_OK : SF_ERR_ARGUMENT;
}

static sf_status reserve(hunt *h)
{
    const sf_allocator *a = &h->allocator;
    size_t coordinates;
    if (!sfi_size_mul(h->mesh.vertex_count, 3, &coordinates)) {
        return SF_ERR_OVERFLOW;
    }
    h->most = (size_t)SFI_AXES + SFI_FLATS_MAX + h->options.direction_count;
    h->facets = sfi_alloc_array(a, h->mesh.triangle_count, sizeof *h->facets);
    h->turned = sfi_alloc_array(a, coordinates, sizeof *h->turned);
    h->up = sfi_alloc_array(a, h->most, sizeof *h->up);
    h->cheap = sfi_alloc_array(a, h->most, sizeof *h->cheap);
    h->runners = sfi_alloc_array(a, h->most, sizeof *h->runners);
    h->found = sfi_alloc_array(a, h->options.fine_count + 1u, sizeof *h->found);
    h->finals = sfi_alloc_array(a, h->options.fine_count + 1u, sizeof *h->finals);
    int all = h->facets != NULL && h->turned != NULL && h->up != NULL && h->cheap != NULL &&
              h->runners != NULL && h->found != NULL && h->finals != NULL;
    return all ? SF_OK : SF_ERR_MEMORY;
}

static void release(hunt *h)
{
    const sf_allocator *a = &h->allocator;
    sfi_free_array(a, h->facets, h->mesh.triangle_count, sizeof *h->facets);
    sfi_free_array(a, h->turned, 3 * h->mesh.vertex_count, sizeof *h->turned);
    sfi_free_array(a, h->up, h->most, sizeof *h->up);
    sfi_free_array(a, h->cheap, h->most, sizeof *h->cheap);
    sfi_free_array(a, h->runners, h->most, sizeof *h->runners);
    sfi_free_array(a, h->found, h->options.fine_count + 1u, sizeof *h->found);
    sfi_free_array(a, h->finals, h->options.fine_count + 1u, sizeof *h->finals);
}

static sf_status run(hunt *h)
{
    SF_TRY(reserve(h));
    SF_TRY(prepare_facing(h));
    if (sf_task_is_cancelled(h->task)) {
        return SF_ERR_CANCELLED;
    }
    SF_TRY(first_round(h));
    SF_TRY(second_round(h));
    SF_TRY(third_round(h));
    step(h, h->total);
    return SF_OK;
}

static void prepare_task(hunt *h, sf_task *task)
{
    h->task = task;
    h->silent = sf_task_default();
    if (task != NULL) {
        h->silent.parallel_for = task->parallel_for;
        h->silent.user = task->user;
    }
    h->progress = sfi_progress_begin(task);
    h->total = CHEAP_WORK + ((uint64_t)h->options.fine_count + 1) * FINE_WORK;
}

sf_status sf_mesh_orient(sf_mesh_view mesh, const sf_orient_options *options,
                         const sf_allocator *allocator, sf_task *task, sf_orientation *orientations,
                         size_t capacity, size_t *count, sf_orientation *given)
{
    hunt h = {.mesh = mesh, .allocator = sfi_allocator_or_default(allocator)};
    h.options = options != NULL ? *options : sf_orient_options_default();
    if (count == NULL || (orientations == NULL && capacity > 0)) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(check_options(&h.options));
    SF_TRY(sf_mesh_validate(mesh, NULL));
    if (mesh.triangle_count == 0) {
        return SF_ERR_ARGUMENT;
    }
    if (capacity < h.options.fine_count) {
        *count = h.options.fine_count;
        return SF_ERR_CAPACITY;
    }
    prepare_task(&h, task);
    sf_status status = run(&h);
    if (status == SF_OK) {
        *count = rank(&h, orientations);
        if (given != NULL) {
            *given = h.found[0];
        }
    }
    release(&h);
    return status;
}
