// SPDX-License-Identifier: MIT
// Loose: what rests on the bed or hangs as it did, and touches no wall.
//
// All that is carried stands on the wall, on the bed, or on what hung in the solid already. Where
// the wall is closed around the inside the last two are wall as well, and there is one piece. Where
// it is not, a block may have been kept that is connected with nothing: inside the part it would
// rattle. It carries nothing but itself, unless a rule's step reaches beyond a voxel's neighbours,
// so it may go; where the rest is not supported without it after all, it stays.

#include "balance/forest/loose.h"

#include "base/memory.h"
#include "base/status.h"
#include "voxel/grid.h"
#include "voxel/pieces.h"
#include "voxel/slice.h"

static int meets(const uint64_t *row, const sf_run *run)
{
    for (uint32_t x = run->x0; x < run->x1; x++) {
        if ((row[x / 64] >> (x % 64) & 1) != 0) {
            return 1;
        }
    }
    return 0;
}

// is_held[i] = whether piece i holds a voxel of the wall; returns how many do.
static uint32_t find_held(const sfi_interior *in, const sfi_pieces *p, uint8_t *is_held)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < p->count; i++) {
        is_held[i] = 0;
    }
    for (uint32_t k = 0; k < in->lattice.nz; k++) {
        sf_slice wall = sf_grid_slice(in->given, k);
        for (size_t i = p->first[k]; i < p->first[k + 1]; i++) {
            const sf_run *run = &p->runs[i];
            if (!is_held[run->label] && meets(sfi_slice_row(wall, run->y), run)) {
                is_held[run->label] = 1;
                count++;
            }
        }
    }
    return count;
}

// rest = the shape without the pieces that are not held.
static sf_status leave_out(const sfi_pieces *p, const uint8_t *is_held, uint32_t nz, sf_grid *rest)
{
    for (uint32_t k = 0; k < nz; k++) {
        for (size_t i = p->first[k]; i < p->first[k + 1]; i++) {
            const sf_run *run = &p->runs[i];
            sf_rect rect = {run->x0, run->y, run->x1, run->y + 1};
            if (!is_held[run->label]) {
                SF_TRY(sf_slice_fill(sf_grid_slice(rest, k), rect, 0));
            }
        }
    }
    return SF_OK;
}

// The shape without loose pieces, if that is supported.
static sf_status drop(const sfi_interior *in, const sfi_pieces *p, const uint8_t *is_held,
                      sf_grid *shape)
{
    sf_grid *rest = NULL, *alive = NULL;
    sf_terms terms = sfi_interior_terms(in);
    sf_status status = sf_grid_clone(shape, &in->allocator, &rest);
    if (status == SF_OK) {
        status = leave_out(p, is_held, in->lattice.nz, rest);
    }
    if (status == SF_OK) {
        status = sf_grid_create(&in->lattice, &in->allocator, &alive);
    }
    if (status == SF_OK) {
        status = sfi_trim_into(alive, rest, &terms, in->bed, &in->allocator, NULL);
    }
    if (status == SF_OK && sf_grid_equal(alive, rest)) {
        status = sfi_grid_copy(shape, rest);
    }
    sf_grid_destroy(rest);
    sf_grid_destroy(alive);
    return status;
}

sf_status sfi_drop_loose(const sfi_interior *in, sf_grid *shape)
{
    sfi_pieces p;
    SF_TRY(sfi_pieces_create(shape, SFI_PIECES_SOLID, &in->allocator, in->task, &p));
    sf_status status = SF_OK;
    uint8_t *is_held = NULL;
    if (p.count > 1) {
        is_held = sfi_alloc_array(&in->allocator, p.count, 1);
        status = is_held != NULL ? SF_OK : SF_ERR_MEMORY;
    }
    if (is_held != NULL) {
        uint32_t held = find_held(in, &p, is_held);
        if (held > 0 && held < p.count) {
            status = drop(in, &p, is_held, shape);
        }
    }
    sfi_free_array(&in->allocator, is_held, p.count, 1);
    sfi_pieces_destroy(&p, &in->allocator);
    return status;
}
