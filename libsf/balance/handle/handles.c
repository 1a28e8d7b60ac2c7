// SPDX-License-Identifier: MIT
// What handles hold: the foot of a solid, and a solid with all of its surface.
//
// A base is held as a region of voxels, because what touches the ground need not be flat. The foot
// is the simplest region: what lies lowest. Heights are sums of three products in a fixed order, so
// that a foot is the same voxels everywhere.

#include <sf/handles.h>

#include "base/bits.h"
#include "base/status.h"
#include "voxel/slice.h"

#include <sf/body.h>

#include <math.h>

sf_status sf_handle_base(const sf_grid *region, sf_handle *handle)
{
    sf_body body;
    sf_handle made = {SF_HANDLE_BASE, {0, 0, 0}, 0, region, 1};
    if (region == NULL || handle == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_grid_body(region, NULL, NULL, &body));
    SF_TRY(sf_body_com(body, made.at_mm));
    *handle = made;
    return SF_OK;
}

// Height of a voxel's centre along `up`, from the lattice's origin.
static double height_of(const sf_lattice *l, const double up[3], uint32_t x, uint32_t y, double z)
{
    return (up[0] * ((x + 0.5) * l->pitch_x_mm) + up[1] * ((y + 0.5) * l->pitch_y_mm)) + up[2] * z;
}

// Visit the solid voxels of a slice: lower `least` to the lowest height, or with a target set what
// is no higher than `least`.
static void visit_slice(const sf_lattice *l, sf_slice slice, const double up[3], double z,
                        double *least, const sf_slice *target)
{
    for (uint32_t y = 0; y < slice.height; y++) {
        const uint64_t *row = sfi_slice_row(slice, y);
        for (size_t i = 0; i < sfi_row_words(slice.width); i++) {
            for (uint64_t w = sfi_row_word(row, i, slice.width); w != 0; w &= w - 1) {
                uint32_t bit = sfi_lowest_bit(w);
                double height = height_of(l, up, (uint32_t)(64 * i) + bit, y, z);
                if (target == NULL) {
                    *least = height < *least ? height : *least;
                } else if (height <= *least) {
                    sfi_slice_row(*target, y)[i] |= UINT64_C(1) << bit;
                }
            }
        }
    }
}

static void visit(const sf_grid *solid, const double up[3], double *least, sf_grid *foot)
{
    sf_lattice l = sf_grid_lattice(solid);
    double bottom = 0;
    for (uint32_t k = 0; k < l.nz; k++) {
        double height = sf_lattice_layer_height(&l, k);
        sf_slice target = sf_grid_slice(foot, k);
        visit_slice(&l, sf_grid_slice(solid, k), up, bottom + 0.5 * height, least,
                    foot != NULL ? &target : NULL);
        bottom += height;
    }
}

sf_status sf_grid_foot(const sf_grid *solid, const double up[3], double height_mm,
                       const sf_allocator *allocator, sf_grid **foot)
{
    double unit[3], least = INFINITY;
    sf_grid *made;
    if (solid == NULL || up == NULL || foot == NULL || !(height_mm >= 0)) {
        return SF_ERR_ARGUMENT;
    }
    double length = sqrt((up[0] * up[0] + up[1] * up[1]) + up[2] * up[2]);
    if (!(length > 1e-100 && length < 1e100)) { // beyond these squares are no numbers
        return SF_ERR_ARGUMENT;
    }
    for (int axis = 0; axis < 3; axis++) {
        unit[axis] = up[axis] / length;
    }
    visit(solid, unit, &least, NULL);
    if (least == INFINITY) {
        return SF_ERR_ARGUMENT;
    }
    sf_lattice lattice = sf_grid_lattice(solid);
    SF_TRY(sf_grid_create(&lattice, allocator, &made));
    least += height_mm;
    visit(solid, unit, &least, made);
    *foot = made;
    return SF_OK;
}

sf_status sf_grid_cover(const sf_grid *solid, sf_mesh_view surface, const sf_allocator *allocator,
                        sf_task *task, sf_grid **covered)
{
    sf_voxelize_options options = sf_voxelize_options_default();
    sf_grid *made;
    if (solid == NULL || covered == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_lattice lattice = sf_grid_lattice(solid);
    SF_TRY(sf_grid_create(&lattice, allocator, &made));
    options.fill = SF_FILL_SURFACE;
    sf_status status = sf_grid_voxelize(made, surface, &options, allocator, task, NULL);
    for (uint32_t k = 0; status == SF_OK && k < lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(made, k);
        status = sf_slice_or(slice, slice, sf_grid_slice(solid, k));
    }
    if (status != SF_OK) {
        sf_grid_destroy(made);
        return status;
    }
    *covered = made;
    return SF_OK;
}
