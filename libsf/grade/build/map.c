// SPDX-License-Identifier: MIT
// Positions and values by a function of the place.

#include <sf/cage_build.h>

#include "base/memory.h"
#include "base/status.h"
#include "grade/cage/cage.h"

#include <string.h>

sf_status sf_cage_map_positions(sf_cage *cage, sf_cage_place_function function, void *user,
                                const sf_allocator *allocator)
{
    if (cage == NULL || function == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    double *moved = sfi_alloc_array(&kept, cage->points, 3 * sizeof *moved);
    sf_status status = moved == NULL ? SF_ERR_MEMORY : SF_OK;
    for (size_t i = 0; status == SF_OK && i < cage->points; i++) {
        memcpy(moved + 3 * i, cage->positions + 3 * i, 3 * sizeof *moved);
        status = function(user, cage->positions + 3 * i, moved + 3 * i) ? SF_OK : SF_ERR_CANCELLED;
    }
    if (status == SF_OK) {
        status = sf_cage_set_positions(cage, 0, cage->points, moved);
    }
    sfi_free_array(&kept, moved, cage->points, 3 * sizeof *moved);
    return status;
}

sf_status sf_cage_map_values(sf_cage *cage, size_t channel, sf_cage_value_function function,
                             void *user, const sf_allocator *allocator)
{
    if (cage == NULL || function == NULL || channel >= cage->channels.count) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    const sf_channel *c = &cage->channels.at[channel];
    double *values = sfi_alloc_array(&kept, c->value_count, sizeof *values);
    size_t count = c->indices == NULL ? cage->points : cage->starts[cage->cells];
    sf_status status = values == NULL ? SF_ERR_MEMORY : SF_OK;
    if (status == SF_OK) {
        memcpy(values, c->values, c->value_count * sizeof *values);
    }
    for (size_t i = 0; status == SF_OK && i < count; i++) {
        size_t point = c->indices == NULL ? i : cage->corners[i];
        size_t value = c->indices == NULL ? i : c->indices[i];
        values[value] = c->values[value]; // not what another corner has made of it
        status =
            function(user, cage->positions + 3 * point, &values[value]) ? SF_OK : SF_ERR_CANCELLED;
    }
    if (status == SF_OK) {
        status = sf_cage_set_values(cage, channel, 0, c->value_count, values);
    }
    sfi_free_array(&kept, values, c->value_count, sizeof *values);
    return status;
}
