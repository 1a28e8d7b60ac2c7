// SPDX-License-Identifier: MIT
// Cages: checked once, then changed only by what cannot break them.
//
// All that a cage may be wrong in is looked for when it is made: what is done with it later, a
// refinement, an evaluation at a place, need not ask again. So its topology never changes; values
// do, and properties come and go.

#include "grade/cage/cage.h"

#include "base/memory.h"
#include "base/status.h"
#include "grade/cage/sharp.h"
#include "grade/cage/surface.h"

#include <math.h>
#include <string.h>

static sfi_channel_shape shape_of(const sf_cage *cage)
{
    sfi_channel_shape shape = {cage->points, cage->starts[cage->cells]};
    return shape;
}

void sf_cage_destroy(sf_cage *cage)
{
    if (cage == NULL) {
        return;
    }
    sf_allocator allocator = cage->allocator;
    sfi_complex_free(&cage->complex);
    if (cage->starts != NULL) {
        size_t corners = cage->starts[cage->cells];
        sfi_channels_clear(&cage->channels, shape_of(cage), &allocator);
        sfi_free_array(&allocator, cage->corners, corners, sizeof *cage->corners);
    }
    sfi_free_array(&allocator, cage->starts, (size_t)cage->cells + 1, sizeof *cage->starts);
    sfi_free_array(&allocator, cage->positions, 3 * (size_t)cage->points, sizeof *cage->positions);
    sfi_free_array(&allocator, cage->creases, cage->crease_count, sizeof *cage->creases);
    sfi_free_array(&allocator, cage->sharps, cage->sharp_count, sizeof *cage->sharps);
    sfi_free_array(&allocator, cage, 1, sizeof *cage);
}

sf_status sfi_positions_check(size_t points, const double *positions, sf_fault *fault)
{
    for (size_t i = 0; i < 3 * points; i++) {
        if (!(fabs(positions[i]) <= SFI_CAGE_REACH)) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "point %zu has a coordinate that is not finite or beyond 10^12 mm",
                                 i / 3);
        }
    }
    return SF_OK;
}

static sf_status check_counts(const sf_cage_view *v, sf_fault *fault)
{
    if (v->dimension != 2 && v->dimension != 3) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "the dimension is %lu; it is 3 (cells) or 2 (faces)",
                             (unsigned long)v->dimension);
    }
    if (v->point_count == 0 || v->cell_count == 0 || v->positions == NULL || v->starts == NULL ||
        v->corners == NULL || (v->crease_count > 0 && v->creases == NULL) ||
        (v->sharp_count > 0 && v->sharps == NULL) ||
        (v->channel_count > 0 && v->channels == NULL)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "there are no points or no cells, or an array is missing");
    }
    if (v->point_count > INT32_MAX || v->cell_count > INT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    return SF_OK;
}

// Starts first, all of them: where they do not rise, corners would be read beyond their end.
static sf_status check_starts(const sf_cage_view *v, sf_fault *fault)
{
    for (size_t i = 0; i < v->cell_count; i++) {
        if (v->starts[0] != 0 || v->starts[i + 1] < v->starts[i] || v->starts[i + 1] > INT32_MAX) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "the corners of cell %zu begin behind those of the next, or those "
                                 "of the first not at 0",
                                 i);
        }
    }
    return SF_OK;
}

static sf_status check_arrays(const sf_cage_view *v, sf_fault *fault)
{
    SF_TRY(check_starts(v, fault));
    for (size_t i = 0; i < v->cell_count; i++) {
        for (uint32_t j = v->starts[i]; j < v->starts[i + 1]; j++) {
            if (v->corners[j] >= v->point_count) {
                return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                     "cell %zu has point %lu; there are %zu", i,
                                     (unsigned long)v->corners[j], v->point_count);
            }
        }
    }
    return sfi_positions_check(v->point_count, v->positions, fault);
}

static int copy_arrays(const sf_cage_view *v, sf_cage *cage)
{
    const sf_allocator *allocator = &cage->allocator;
    size_t corners = v->starts[v->cell_count];
    void *starts, *items, *positions, *creases, *sharps;
    int done = sfi_copy_array(allocator, v->starts, v->cell_count + 1, sizeof *v->starts, &starts);
    cage->starts = starts;
    done = done && sfi_copy_array(allocator, v->corners, corners, sizeof *v->corners, &items);
    cage->corners = done ? items : NULL;
    done = done && sfi_copy_array(allocator, v->positions, 3 * v->point_count, sizeof *v->positions,
                                  &positions);
    cage->positions = done ? positions : NULL;
    done = done &&
           sfi_copy_array(allocator, v->creases, v->crease_count, sizeof *v->creases, &creases);
    cage->creases = done ? creases : NULL;
    done = done && sfi_copy_array(allocator, v->sharps, v->sharp_count, sizeof *v->sharps, &sharps);
    cage->sharps = done ? sharps : NULL;
    return done;
}

static sf_status fill(const sf_cage_view *v, sf_cage *cage, sf_fault *fault)
{
    const sf_allocator *allocator = &cage->allocator;
    sfi_corners corners = {v->dimension, (uint32_t)v->point_count, (uint32_t)v->cell_count,
                           v->starts, v->corners};
    SF_TRY(sfi_complex_build(&corners, allocator, &cage->complex, fault));
    SF_TRY(sfi_surface_check(&cage->complex, fault));
    SF_TRY(sfi_sharp_set(v, &cage->complex, fault));
    if (!copy_arrays(v, cage)) {
        return SF_ERR_MEMORY;
    }
    return sfi_channels_copy(&cage->channels, v->channel_count, v->channels, shape_of(cage),
                             allocator, fault);
}

sf_status sf_cage_create(const sf_cage_view *view, const sf_allocator *allocator, sf_cage **cage,
                         sf_fault *fault)
{
    if (view == NULL || cage == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(check_counts(view, fault));
    SF_TRY(check_arrays(view, fault));
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_cage *made = sfi_alloc_array(&kept, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = kept;
    made->points = (uint32_t)view->point_count;
    made->cells = (uint32_t)view->cell_count;
    made->crease_count = view->crease_count;
    made->sharp_count = view->sharp_count;
    sf_status status = fill(view, made, fault);
    if (status != SF_OK) {
        sf_cage_destroy(made);
        return status;
    }
    *cage = made;
    return SF_OK;
}

sf_cage_view sf_cage_get_view(const sf_cage *cage)
{
    sf_cage_view view = {0, 0, NULL, 0, NULL, NULL, 0, NULL, 0, NULL, 0, NULL};
    if (cage != NULL) {
        view.dimension = cage->complex.dimension;
        view.point_count = cage->points;
        view.positions = cage->positions;
        view.cell_count = cage->cells;
        view.starts = cage->starts;
        view.corners = cage->corners;
        view.crease_count = cage->crease_count;
        view.creases = cage->creases;
        view.sharp_count = cage->sharp_count;
        view.sharps = cage->sharps;
        view.channel_count = cage->channels.count;
        view.channels = cage->channels.at;
    }
    return view;
}

sf_status sf_cage_set_positions(sf_cage *cage, size_t first, size_t count, const double *xyz)
{
    if (cage == NULL || xyz == NULL || first > cage->points || count > cage->points - first) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_positions_check(count, xyz, NULL));
    memcpy(cage->positions + 3 * first, xyz, 3 * count * sizeof *xyz);
    return SF_OK;
}

sf_status sf_cage_set_values(sf_cage *cage, size_t channel, size_t first, size_t count,
                             const double *values)
{
    if (cage == NULL || channel >= cage->channels.count) {
        return SF_ERR_ARGUMENT;
    }
    return sfi_channel_set(&cage->channels.at[channel], first, count, values);
}

sf_status sf_cage_add_property(sf_cage *cage, const sf_channel *channel, sf_fault *fault)
{
    if (cage == NULL || channel == NULL) {
        return SF_ERR_ARGUMENT;
    }
    return sfi_channels_add(&cage->channels, channel, shape_of(cage), &cage->allocator, fault);
}

sf_status sf_cage_remove_property(sf_cage *cage, size_t channel)
{
    if (cage == NULL || channel >= cage->channels.count) {
        return SF_ERR_ARGUMENT;
    }
    sfi_channels_remove(&cage->channels, channel, shape_of(cage), &cage->allocator);
    return SF_OK;
}
