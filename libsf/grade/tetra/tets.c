// SPDX-License-Identifier: MIT
// Tetrahedra that own their arrays.

#include "grade/tetra/tets.h"

#include "base/memory.h"
#include "base/status.h"
#include "grade/cage/cage.h"

#include <string.h>

static sfi_channel_shape shape_of(const sf_tets *tets)
{
    sfi_channel_shape shape = {tets->points, 4 * tets->tets};
    return shape;
}

void sf_tets_destroy(sf_tets *tets)
{
    if (tets == NULL) {
        return;
    }
    sf_allocator allocator = tets->allocator;
    for (size_t i = 0; tets->positions == NULL && i < tets->channels.count; i++) {
        tets->channels.at[i].values = NULL; // the refinement's
    }
    sfi_channels_clear(&tets->channels, shape_of(tets), &allocator);
    sfi_free_array(&allocator, tets->positions, tets->points, 3 * sizeof *tets->positions);
    sfi_free_array(&allocator, tets->corners, tets->tets, 4 * sizeof *tets->corners);
    sfi_free_array(&allocator, tets, 1, sizeof *tets);
}

static sf_status check_corners(const sf_tets_view *v, sf_fault *fault)
{
    for (size_t i = 0; i < v->tet_count; i++) {
        const uint32_t *c = v->corners + 4 * i;
        for (int j = 0; j < 4; j++) {
            if (c[j] >= v->point_count) {
                return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                     "tetrahedron %zu has point %lu; there are %zu", i,
                                     (unsigned long)c[j], v->point_count);
            }
        }
        if (c[0] == c[1] || c[0] == c[2] || c[0] == c[3] || c[1] == c[2] || c[1] == c[3] ||
            c[2] == c[3]) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "tetrahedron %zu has one point at two corners", i);
        }
    }
    return SF_OK;
}

static sf_status check(const sf_tets_view *v, sf_fault *fault)
{
    if (v->point_count == 0 || v->tet_count == 0 || v->positions == NULL || v->corners == NULL ||
        (v->channel_count > 0 && v->channels == NULL)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "there are no points or no tetrahedra, or an array is missing");
    }
    if (v->point_count > INT32_MAX || v->tet_count > SFI_TET_MAX) {
        return SF_ERR_OVERFLOW;
    }
    SF_TRY(sfi_positions_check(v->point_count, v->positions, fault));
    return check_corners(v, fault);
}

sf_status sf_tets_create(const sf_tets_view *view, const sf_allocator *allocator, sf_tets **tets,
                         sf_fault *fault)
{
    if (view == NULL || tets == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(check(view, fault));
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_tets *made = sfi_alloc_array(&kept, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = kept;
    made->points = view->point_count;
    made->tets = view->tet_count;
    made->positions = sfi_alloc_array(&kept, made->points, 3 * sizeof *made->positions);
    made->seen = made->positions;
    made->corners = sfi_alloc_array(&kept, made->tets, 4 * sizeof *made->corners);
    sf_status status = made->positions == NULL || made->corners == NULL
                           ? SF_ERR_MEMORY
                           : sfi_channels_copy(&made->channels, view->channel_count, view->channels,
                                               shape_of(made), &kept, fault);
    if (status != SF_OK) {
        sf_tets_destroy(made);
        return status;
    }
    memcpy(made->positions, view->positions, 3 * made->points * sizeof *made->positions);
    memcpy(made->corners, view->corners, 4 * made->tets * sizeof *made->corners);
    *tets = made;
    return SF_OK;
}

sf_tets_view sf_tets_get_view(const sf_tets *tets)
{
    sf_tets_view view = {0, NULL, 0, NULL, 0, NULL};
    if (tets != NULL) {
        view.point_count = tets->points;
        view.positions = tets->seen;
        view.tet_count = tets->tets;
        view.corners = tets->corners;
        view.channel_count = tets->channels.count;
        view.channels = tets->channels.at;
    }
    return view;
}

sf_status sf_tets_set_values(sf_tets *tets, size_t channel, size_t first, size_t count,
                             const double *values)
{
    if (tets == NULL || channel >= tets->channels.count) {
        return SF_ERR_ARGUMENT;
    }
    if (tets->positions == NULL) {
        return SF_ERR_UNSUPPORTED;
    }
    return sfi_channel_set(&tets->channels.at[channel], first, count, values);
}
