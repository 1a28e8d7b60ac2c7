// SPDX-License-Identifier: MIT
// Which nodes handles hold, and which pieces hold none.
//
// A point holds the eight corners of its cell: so its weight is 1 wherever in the cell it lies, and
// does not depend on how the cell is cut by the lattice. A ball holds these and all corners within
// its radius, a base the corners of all cells that hold one of its voxels. Two handles cannot hold
// one node, because their weights there would have to be 1 and 0 at once.
//
// A piece is what is connected by edges of cells. One without a handle has no energy to tell its
// weights; it is left out of the solve, and follows its surroundings later.

#include "balance/handle/weights_claim.h"

#include "base/bits.h"
#include "base/status.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

typedef struct claim {
    const sfi_domain *domain;
    const sf_handle *handles;
    uint8_t *owner;
    sf_fault *fault;
} claim;

// ---------------------------------------------------------------------------------------------
// One node, one cell
// ---------------------------------------------------------------------------------------------

static sf_status hold_node(const claim *c, size_t handle, size_t node)
{
    uint8_t before = c->owner[node];
    if (before != SFI_NODE_FREE && before != handle) {
        return sfi_fault_set(
            c->fault, SF_ERR_INFEASIBLE, 0, 0,
            "handles %u and %u touch: they hold the same corner of a cell; move one "
            "away, or make the cells smaller",
            before + 1u, (unsigned)handle + 1u);
    }
    c->owner[node] = (uint8_t)handle;
    return SF_OK;
}

static sf_status hold_cell(const claim *c, size_t handle, uint32_t cell)
{
    for (size_t corner = 0; corner < 8; corner++) {
        SF_TRY(hold_node(c, handle, c->domain->corners[8 * (size_t)cell + corner]));
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Points, balls, bases
// ---------------------------------------------------------------------------------------------

static sf_status hold_point(const claim *c, size_t handle)
{
    sfi_spot spot = sfi_domain_search(c->domain, c->handles[handle].at_mm, NULL, INFINITY);
    if (spot.square > 0) {
        return sfi_fault_set(c->fault, SF_ERR_INFEASIBLE, 0, 0,
                             "handle %u lies outside the solid: move it inside",
                             (unsigned)handle + 1u);
    }
    return hold_cell(c, handle, spot.cell);
}

static sf_status hold_ball(const claim *c, size_t handle)
{
    const sfi_domain *d = c->domain;
    const sf_handle *h = &c->handles[handle];
    for (size_t node = 0; node < d->node_count; node++) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double by = d->planes[axis][d->node_place[3 * node + (size_t)axis]] - h->at_mm[axis];
            square += by * by;
        }
        if (square <= h->radius_mm * h->radius_mm) {
            SF_TRY(hold_node(c, handle, node));
        }
    }
    return SF_OK;
}

// The cell of a voxel of the lattice, or SFI_NO_CELL.
static uint32_t cell_of_voxel(const sfi_domain *d, const uint32_t voxel[3])
{
    uint32_t at[3];
    for (int axis = 0; axis < 3; axis++) {
        if (voxel[axis] < d->first[axis]) {
            return SFI_NO_CELL;
        }
        at[axis] = (voxel[axis] - d->first[axis]) / d->block[axis];
        if (at[axis] >= d->cells[axis]) {
            return SFI_NO_CELL;
        }
    }
    return d->cell_at[sfi_domain_box_index(d, at[0], at[1], at[2])];
}

// The voxels of one row; counts those of the region, and those that lie in cells.
static sf_status hold_row(const claim *c, size_t handle, const uint64_t *row, uint32_t width,
                          uint32_t voxel[3], uint64_t found[2])
{
    uint32_t last = SFI_NO_CELL;
    for (size_t i = 0; i < sfi_row_words(width); i++) {
        for (uint64_t word = sfi_row_word(row, i, width); word != 0; word &= word - 1) {
            voxel[0] = (uint32_t)(64 * i) + sfi_lowest_bit(word);
            uint32_t cell = cell_of_voxel(c->domain, voxel);
            found[0]++;
            found[1] += cell != SFI_NO_CELL;
            if (cell != SFI_NO_CELL && cell != last) {
                SF_TRY(hold_cell(c, handle, cell));
                last = cell;
            }
        }
    }
    return SF_OK;
}

static sf_status hold_base(const claim *c, size_t handle)
{
    const sf_grid *region = c->handles[handle].region;
    sf_lattice l = sf_grid_lattice(region);
    uint64_t found[2] = {0, 0};
    uint32_t voxel[3];
    for (voxel[2] = 0; voxel[2] < l.nz; voxel[2]++) {
        sf_slice slice = sf_grid_slice(region, voxel[2]);
        for (voxel[1] = 0; voxel[1] < l.ny; voxel[1]++) {
            SF_TRY(hold_row(c, handle, sfi_slice_row(slice, voxel[1]), l.nx, voxel, found));
        }
    }
    if (found[0] == 0) {
        return sfi_fault_set(c->fault, SF_ERR_ARGUMENT, 0, 0,
                             "handle %u is a base without a single voxel", (unsigned)handle + 1u);
    }
    if (found[1] == 0) {
        return sfi_fault_set(c->fault, SF_ERR_INFEASIBLE, 0, 0,
                             "handle %u is a base that lies outside the solid",
                             (unsigned)handle + 1u);
    }
    return SF_OK;
}

sf_status sfi_claim(const sfi_domain *domain, const sf_handle *handles, size_t count,
                    uint8_t *owner, sf_fault *fault)
{
    claim c = {domain, handles, owner, fault};
    memset(owner, SFI_NODE_FREE, domain->node_count);
    for (size_t j = 0; j < count; j++) {
        if (handles[j].kind == SF_HANDLE_BASE) {
            SF_TRY(hold_base(&c, j));
            continue;
        }
        SF_TRY(hold_point(&c, j));
        if (handles[j].kind == SF_HANDLE_BALL) {
            SF_TRY(hold_ball(&c, j));
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Pieces
// ---------------------------------------------------------------------------------------------

// Number what is connected with a node; returns whether a handle holds any of it.
static int flood(const sfi_level *l, const uint8_t *owner, uint32_t number, uint32_t from,
                 uint32_t *piece, uint32_t *queue, size_t *length)
{
    int held = 0;
    *length = 1;
    queue[0] = from;
    piece[from] = number;
    for (size_t at = 0; at < *length; at++) {
        uint32_t node = queue[at];
        held |= owner[node] != SFI_NODE_FREE;
        for (size_t n = 0; n < 6; n++) {
            uint32_t next = l->neighbour[6 * (size_t)node + n];
            if (piece[next] == UINT32_MAX) {
                piece[next] = number;
                queue[(*length)++] = next;
            }
        }
    }
    return held;
}

size_t sfi_claim_pieces(const sfi_level *level, uint8_t *owner, uint32_t *piece, uint32_t *queue)
{
    size_t loose = 0, length = 0;
    uint32_t number = 0;
    memset(piece, 0xff, level->count * sizeof *piece);
    for (size_t node = 0; node < level->count; node++) {
        if (piece[node] != UINT32_MAX) {
            continue;
        }
        if (!flood(level, owner, number++, (uint32_t)node, piece, queue, &length)) {
            loose++;
            for (size_t n = 0; n < length; n++) {
                owner[queue[n]] = SFI_NODE_LOOSE;
            }
        }
    }
    return loose;
}
