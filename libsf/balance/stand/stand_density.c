// SPDX-License-Identifier: MIT
// What the voxels of a bent shape weigh, and what that does to bending.
//
// Densities are a matter of the shape as it was handed in: of each voxel of the bent one, the
// centre is followed back to where it was, and the density is that of there. Following back has a
// price of its own for each call (balance/blend/blend_inverse.c sorts all cells by where they are
// bent to), so voxels go in batches of some thousands, in their order.
//
// What bends next are surfaces that bound matter of density 1. What a voxel weighs beside that is
// carried along with the place that it was at.

#include "balance/stand/stand.h"

#include "base/bits.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

enum { BATCH = 32768 };
// How near a bent centre must be to its own, in voxels.
#define UNBEND_VX 1e-6

// Voxels on their way back, and what is done with them there.
typedef struct batch {
    const sf_stand *stand;
    const sf_pose *poses;
    sf_lattice lattice;
    sf_task *task;
    size_t room, count;
    double *bent, *rest; // the centres
    size_t *voxel;       // and which these are
    float *density;      // of all voxels, as it is found
    const float *known;  // or as it was
    double *scratch;     // of sfi_stand_carry()
    sf_grid *kept;
    sfi_carved *carved;
} batch;

// What is done with voxel number i of a batch.
typedef sf_status (*action)(batch *b, size_t i);

static sf_status follow_back(const batch *b)
{
    memcpy(b->rest, b->bent, 3 * b->count * sizeof *b->rest);
    return sfi_stand_bends(b->stand)
               ? sf_weights_unbend(b->stand->field, b->poses, b->bent, b->count,
                                   UNBEND_VX * b->stand->options.pitch_mm, &b->stand->allocator,
                                   b->task, b->rest, NULL, NULL)
               : SF_OK;
}

static sf_status empty(batch *b, action act)
{
    if (b->count > 0) {
        SF_TRY(follow_back(b));
    }
    for (size_t i = 0; i < b->count; i++) {
        SF_TRY(act(b, i));
    }
    b->count = 0;
    return SF_OK;
}

static sf_status put(batch *b, uint32_t x, uint32_t y, uint32_t k, action act)
{
    const sf_lattice *l = &b->lattice;
    double *p = b->bent + 3 * b->count;
    p[0] = l->origin_mm[0] + (x + 0.5) * l->pitch_x_mm;
    p[1] = l->origin_mm[1] + (y + 0.5) * l->pitch_y_mm;
    p[2] = l->origin_mm[2] + (k + 0.5) * l->layer_mm;
    b->voxel[b->count++] = ((size_t)k * l->ny + y) * l->nx + x;
    return b->count == b->room ? empty(b, act) : SF_OK;
}

// Every solid voxel of a grid.
static sf_status visit(batch *b, const sf_grid *grid, action act)
{
    for (uint32_t k = 0; k < b->lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        for (uint32_t y = 0; y < slice.height; y++) {
            const uint64_t *row = sfi_slice_row(slice, y);
            for (size_t i = 0; i < sfi_row_words(slice.width); i++) {
                for (uint64_t word = row[i]; word != 0; word &= word - 1) {
                    SF_TRY(put(b, (uint32_t)(64 * i) + sfi_lowest_bit(word), y, k, act));
                }
            }
        }
    }
    return empty(b, act);
}

static sf_status visit_all(batch *b, const sf_grid *grid, action act)
{
    const sf_allocator *a = &b->stand->allocator;
    uint64_t solid = sf_grid_popcount(grid);
    b->room = solid < 1 ? 1 : solid < BATCH ? (size_t)solid : BATCH;
    b->bent = sfi_alloc_array(a, b->room, 6 * sizeof *b->bent);
    b->voxel = sfi_alloc_array(a, b->room, sizeof *b->voxel);
    sf_status status = SF_ERR_MEMORY;
    if (b->bent != NULL && b->voxel != NULL) {
        b->rest = b->bent + 3 * b->room;
        status = visit(b, grid, act);
    }
    sfi_free_array(a, b->bent, b->room, 6 * sizeof *b->bent);
    sfi_free_array(a, b->voxel, b->room, sizeof *b->voxel);
    return status;
}

// --- Densities -----------------------------------------------------------------------------------

static sf_status ask(batch *b, size_t i)
{
    const sf_stand_options *o = &b->stand->options;
    float density = (float)o->density(o->density_user, b->rest + 3 * i);
    b->density[b->voxel[i]] = density;
    return density > 0 && isfinite(density) ? SF_OK : SF_ERR_ARGUMENT;
}

sf_status sfi_stand_weigh(const sf_stand *stand, const sf_pose *poses, const sf_grid *solid,
                          sf_task *task, float **density, size_t *count)
{
    batch b = {.stand = stand, .poses = poses, .lattice = sf_grid_lattice(solid), .task = task};
    size_t voxels;
    if (stand->options.density == NULL) {
        return SF_OK;
    }
    if (!sfi_size_mul(b.lattice.nx, b.lattice.ny, &voxels) ||
        !sfi_size_mul(voxels, b.lattice.nz, &voxels)) {
        return SF_ERR_OVERFLOW;
    }
    b.density = sfi_alloc_array(&stand->allocator, voxels, sizeof *b.density);
    if (b.density == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < voxels; i++) {
        b.density[i] = 1;
    }
    sf_status status = visit_all(&b, solid, ask);
    if (status != SF_OK) {
        sfi_free_array(&stand->allocator, b.density, voxels, sizeof *b.density);
        return status;
    }
    *density = b.density;
    *count = voxels;
    return SF_OK;
}

// --- What stays ----------------------------------------------------------------------------------

static sf_status keep(batch *b, size_t i)
{
    const sf_stand_options *o = &b->stand->options;
    const sf_lattice *l = &b->lattice;
    size_t row = b->voxel[i] / l->nx;
    return o->keep(o->keep_user, b->rest + 3 * i)
               ? sf_slice_set(sf_grid_slice(b->kept, (uint32_t)(row / l->ny)),
                              (uint32_t)(b->voxel[i] % l->nx), (uint32_t)(row % l->ny), 1)
               : SF_OK;
}

sf_status sfi_stand_keep(const sf_stand *stand, const sf_pose *poses, const sf_grid *solid,
                         sf_task *task, sf_grid *wall)
{
    batch b = {.stand = stand,
               .poses = poses,
               .lattice = sf_grid_lattice(solid),
               .task = task,
               .kept = wall};
    return stand->options.keep != NULL ? visit_all(&b, solid, keep) : SF_OK;
}

// --- Bodies --------------------------------------------------------------------------------------

sf_status sfi_stand_weigh_more(const sf_grid *grid, const float *density, sf_body *body)
{
    sf_body plain, dense;
    if (density == NULL) {
        return SF_OK;
    }
    SF_TRY(sf_grid_body(grid, NULL, NULL, &plain));
    SF_TRY(sf_grid_body(grid, density, NULL, &dense));
    *body = sf_body_add(*body, 1, sf_body_add(dense, -1, plain));
    return SF_OK;
}

static sf_status weigh_voxels(const sf_stand *stand, sf_mesh_view mesh, sf_task *task,
                              sf_grid *solid, sf_body *body)
{
    sf_voxelize_options how = sf_voxelize_options_default();
    float *density = NULL;
    size_t count = 0;
    how.fill = SF_FILL_WINDING;
    SF_TRY(sf_grid_voxelize(solid, mesh, &how, &stand->allocator, NULL, NULL));
    SF_TRY(sfi_stand_weigh(stand, NULL, solid, task, &density, &count));
    sf_status status = sfi_stand_weigh_more(solid, density, body);
    sfi_free_array(&stand->allocator, density, count, sizeof *density);
    return status;
}

sf_status sfi_stand_weigh_given(const sf_stand *stand, sf_mesh_view mesh, sf_task *task,
                                sf_body *body)
{
    sf_lattice lattice;
    sf_grid *solid = NULL;
    SF_TRY(sf_mesh_body(mesh, 1, body));
    if (stand->options.density == NULL) {
        return SF_OK;
    }
    SF_TRY(sfi_stand_lattice(stand, mesh, &lattice));
    SF_TRY(sf_grid_create(&lattice, &stand->allocator, &solid));
    sf_status status = weigh_voxels(stand, mesh, task, solid, body);
    sf_grid_destroy(solid);
    return status;
}

// --- What is carried along -----------------------------------------------------------------------

sf_status sfi_stand_carry(const sf_stand *stand, double mass, const double rest[3], double *scratch,
                          sfi_carved *carved)
{
    carved->loose_mass += mass;
    if (!sfi_stand_bends(stand)) {
        return SF_OK;
    }
    SF_TRY(sf_weights_at(stand->field, rest, scratch, NULL));
    sf_blend one = {rest, scratch, 1, sf_weights_centers(stand->field), stand->handle_count};
    double *phi = scratch + stand->handle_count;
    sfi_basis_at(&one, 0, phi);
    for (size_t b = 0; b < sfi_basis_size(&one); b++) {
        carved->loose_sums[b] += mass * phi[b];
    }
    return SF_OK;
}

static sf_status carry(batch *b, size_t i)
{
    double volume = b->lattice.pitch_x_mm * b->lattice.pitch_y_mm * b->lattice.layer_mm;
    double more = (double)b->known[b->voxel[i]] - 1;
    return more < 0 || more > 0
               ? sfi_stand_carry(b->stand, more * volume, b->rest + 3 * i, b->scratch, b->carved)
               : SF_OK;
}

sf_status sfi_stand_carry_all(const sf_stand *stand, const sf_pose *poses, const float *density,
                              sf_task *task, double *scratch, sfi_carved *carved)
{
    batch b = {.stand = stand,
               .poses = poses,
               .lattice = sf_grid_lattice(carved->result),
               .task = task,
               .known = density,
               .scratch = scratch,
               .carved = carved};
    // Where nothing bends, nothing is carried along.
    return density != NULL && sfi_stand_bends(stand) ? visit_all(&b, carved->result, carry) : SF_OK;
}
