// SPDX-License-Identifier: MIT
// Tetrahedra that are implicit in a refined cage.
//
// A step numbers its points by what they come of: points first, then edges, faces and cells. Of the
// corners of one of its cells one is of a point, three are of edges, three of faces and one of a
// cell; along the edges of the cell numbers rise from the first to the last. The six ways from it
// to the cell's, up along three edges, are the six tetrahedra. Two cells that share a side cut it
// along the same diagonal, that between its least and its greatest number.

#include "grade/refine/refinement.h"
#include "grade/tetra/tets.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

// Axes in the order in which each way goes along them; the first three turn one way, the others the
// other.
static const uint8_t ways[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                   {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};

// The place of the corner with the least number.
static uint32_t least_place(const uint32_t *corners)
{
    uint32_t least = 0;
    for (uint32_t i = 1; i < 8; i++) {
        least = corners[i] < corners[least] ? i : least;
    }
    return sfi_hex_bits(least);
}

// The corners of the tetrahedra in a cell, as corners of the cell. A way that begins at a corner
// with an odd number of high coordinates turns the other way.
static void cut_cell(const uint32_t *corners, uint8_t tets[24])
{
    uint32_t start = least_place(corners);
    int mirrored = (start ^ start >> 1 ^ start >> 2) & 1;
    for (int way = 0; way < 6; way++) {
        uint32_t place = start;
        uint8_t *tet = tets + 4 * way;
        tet[0] = (uint8_t)sfi_hex_bits(place);
        for (int i = 0; i < 3; i++) {
            place ^= 1u << ways[way][i];
            tet[i + 1] = (uint8_t)sfi_hex_bits(place);
        }
        if (mirrored ^ (way >= 3)) {
            uint8_t second = tet[1];
            tet[1] = tet[2];
            tet[2] = second;
        }
    }
}

static void cut_cells(const uint32_t *cells, size_t count, const uint32_t *items, uint32_t *corners)
{
    for (size_t i = 0; i < count; i++) {
        uint8_t tets[24];
        cut_cell(cells + 8 * i, tets);
        for (size_t j = 0; j < 24; j++) {
            corners[24 * i + j] = items[8 * i + tets[j]];
        }
    }
}

static sf_status add_channels(const sf_refinement *r, uint32_t step, sf_tets *tets)
{
    const uint32_t *cells = r->layouts[0].corners[step];
    for (size_t i = 0; i < r->channel_count; i++) {
        const sf_channel *from = &r->views[step][i];
        sf_channel *channel = &tets->channels.at[i];
        *channel = *from;
        channel->indices = NULL;
        tets->channels.count++;
        if (from->indices != NULL) {
            uint32_t *indices = sfi_alloc_array(&tets->allocator, 4 * tets->tets, sizeof *indices);
            if (indices == NULL) {
                return SF_ERR_MEMORY;
            }
            cut_cells(cells, r->cells[step], from->indices, indices);
            channel->indices = indices;
        }
    }
    return SF_OK;
}

sf_status sf_tets_of_refinement(const sf_refinement *refinement, uint32_t step,
                                const sf_allocator *allocator, sf_tets **tets)
{
    if (refinement == NULL || tets == NULL || step < 1 || step > refinement->steps) {
        return SF_ERR_ARGUMENT;
    }
    if (refinement->dimension != 3) {
        return SF_ERR_UNSUPPORTED;
    }
    if (refinement->cells[step] > SFI_TET_MAX / 6) {
        return SF_ERR_OVERFLOW;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_tets *made = sfi_alloc_array(&kept, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = kept;
    made->points = refinement->layouts[0].points[step];
    made->tets = 6 * refinement->cells[step];
    made->seen = refinement->positions[step];
    made->corners = sfi_alloc_array(&kept, made->tets, 4 * sizeof *made->corners);
    sf_status status = made->corners == NULL ? SF_ERR_MEMORY : add_channels(refinement, step, made);
    if (status != SF_OK) {
        sf_tets_destroy(made);
        return status;
    }
    const uint32_t *cells = refinement->layouts[0].corners[step];
    cut_cells(cells, refinement->cells[step], cells, made->corners);
    *tets = made;
    return SF_OK;
}
