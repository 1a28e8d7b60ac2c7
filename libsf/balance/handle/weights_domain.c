// SPDX-License-Identifier: MIT
// The cells on which weights live: blocks of voxels that hold a solid one.
//
// Weights are smooth, so that some ten thousand cells tell as much of them as millions of voxels.
// A cell is a block of voxels, as many along each axis as make it nearly a cube: flat voxels are
// piled up, because a Laplacian of flat cells is solved slowly and gains nothing. How much of a
// cell is solid is kept as its volume, so that a thin limb conducts no more for being blocked.
//
// The box around the solid voxels is tiled from its lower corner. Where the last block reaches
// beyond the lattice its planes go on with the pitch, or the height of the last layer.
//
// The coarser levels of the solver are domains as well: two cells together along each axis, where
// one is left over it stays alone, so that the upper planes stay what they are.

#include "balance/handle/weights_domain.h"

#include "base/bits.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

#define NODES_MAX (UINT32_C(1) << 31)

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

void sfi_domain_destroy(sfi_domain *d)
{
    const sf_allocator *a = &d->allocator;
    for (int axis = 0; axis < 3; axis++) {
        sfi_free_array(a, d->planes[axis], d->cells[axis] + 1u, sizeof(double));
    }
    sfi_free_array(a, d->cell_at, d->box_count, sizeof *d->cell_at);
    sfi_free_array(a, d->closest, d->box_count, sizeof *d->closest);
    sfi_free_array(a, d->place, 3 * d->cell_count, sizeof *d->place);
    sfi_free_array(a, d->volume, d->cell_count, sizeof *d->volume);
    sfi_free_array(a, d->corners, 8 * d->cell_count, sizeof *d->corners);
    sfi_free_array(a, d->node_place, 3 * d->node_count, sizeof *d->node_place);
    memset(d, 0, sizeof *d);
}

// The box and its planes; cells come later.
static sf_status reserve_box(sfi_domain *d)
{
    size_t plane;
    if (!sfi_size_mul(d->cells[0], d->cells[1], &plane) ||
        !sfi_size_mul(plane, d->cells[2], &d->box_count)) {
        d->box_count = 0;
        return SF_ERR_OVERFLOW;
    }
    for (int axis = 0; axis < 3; axis++) {
        d->planes[axis] = sfi_alloc_array(&d->allocator, d->cells[axis] + 1u, sizeof(double));
        if (d->planes[axis] == NULL) {
            return SF_ERR_MEMORY;
        }
    }
    d->cell_at = sfi_alloc_array(&d->allocator, d->box_count, sizeof *d->cell_at);
    return d->cell_at != NULL ? SF_OK : SF_ERR_MEMORY;
}

static sf_status reserve_cells(sfi_domain *d, size_t count)
{
    size_t corners;
    if (count >= NODES_MAX || !sfi_size_mul(count, 8, &corners)) {
        return SF_ERR_OVERFLOW;
    }
    d->cell_count = count;
    d->place = sfi_alloc_array(&d->allocator, 3 * count, sizeof *d->place);
    d->volume = sfi_alloc_array(&d->allocator, count, sizeof *d->volume);
    d->corners = sfi_alloc_array(&d->allocator, corners, sizeof *d->corners);
    return d->place != NULL && d->volume != NULL && d->corners != NULL ? SF_OK : SF_ERR_MEMORY;
}

// ---------------------------------------------------------------------------------------------
// Corners
// ---------------------------------------------------------------------------------------------

// Number the corners of all cells in (z, y, x) order. `table` has a place for each corner of the
// box.
static void number_nodes(sfi_domain *d, uint32_t *table, size_t table_count)
{
    size_t row = d->cells[0] + 1u, slab = row * (d->cells[1] + 1u);
    memset(table, 0, table_count * sizeof *table);
    for (size_t c = 0; c < d->cell_count; c++) {
        const uint32_t *p = d->place + 3 * c;
        size_t at = p[2] * slab + p[1] * row + p[0];
        for (size_t corner = 0; corner < 8; corner++) {
            table[at + (corner & 1) + (corner >> 1 & 1) * row + (corner >> 2) * slab] = 1;
        }
    }
    uint32_t count = 0;
    for (size_t i = 0; i < table_count; i++) {
        if (table[i] != 0) {
            table[i] = count++;
        }
    }
    d->node_count = count;
    for (size_t c = 0; c < d->cell_count; c++) {
        const uint32_t *p = d->place + 3 * c;
        size_t at = p[2] * slab + p[1] * row + p[0];
        for (size_t corner = 0; corner < 8; corner++) {
            d->corners[8 * c + corner] =
                table[at + (corner & 1) + (corner >> 1 & 1) * row + (corner >> 2) * slab];
        }
    }
}

static void place_nodes(sfi_domain *d)
{
    for (size_t c = 0; c < d->cell_count; c++) {
        for (uint32_t corner = 0; corner < 8; corner++) {
            uint32_t *to = d->node_place + 3 * (size_t)d->corners[8 * c + corner];
            to[0] = d->place[3 * c] + (corner & 1);
            to[1] = d->place[3 * c + 1] + (corner >> 1 & 1);
            to[2] = d->place[3 * c + 2] + (corner >> 2);
        }
    }
}

static sf_status make_nodes(sfi_domain *d)
{
    size_t table_count;
    if (!sfi_size_mul((size_t)d->cells[0] + 1, (size_t)d->cells[1] + 1, &table_count) ||
        !sfi_size_mul(table_count, (size_t)d->cells[2] + 1, &table_count)) {
        return SF_ERR_OVERFLOW;
    }
    uint32_t *table = sfi_alloc_array(&d->allocator, table_count, sizeof *table);
    if (table == NULL) {
        return SF_ERR_MEMORY;
    }
    number_nodes(d, table, table_count);
    sfi_free_array(&d->allocator, table, table_count, sizeof *table);
    if (d->node_count >= NODES_MAX) {
        return SF_ERR_OVERFLOW;
    }
    d->node_place = sfi_alloc_array(&d->allocator, 3 * d->node_count, sizeof *d->node_place);
    if (d->node_place == NULL) {
        return SF_ERR_MEMORY;
    }
    place_nodes(d);
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Blocks of voxels
// ---------------------------------------------------------------------------------------------

// Solid voxels in each cell of one row of cells.
static void count_row(const sf_grid *solid, const sfi_domain *d, uint32_t j, uint32_t k,
                      uint32_t *counts)
{
    sf_lattice l = sf_grid_lattice(solid);
    memset(counts, 0, d->cells[0] * sizeof *counts);
    uint32_t z0 = d->first[2] + k * d->block[2], y0 = d->first[1] + j * d->block[1];
    for (uint32_t z = z0; z < z0 + d->block[2] && z < l.nz; z++) {
        sf_slice slice = sf_grid_slice(solid, z);
        for (uint32_t y = y0; y < y0 + d->block[1] && y < l.ny; y++) {
            const uint64_t *row = sfi_slice_row(slice, y);
            for (size_t i = 0; i < sfi_row_words(l.nx); i++) {
                for (uint64_t word = sfi_row_word(row, i, l.nx); word != 0; word &= word - 1) {
                    uint32_t x = (uint32_t)(64 * i) + sfi_lowest_bit(word);
                    counts[(x - d->first[0]) / d->block[0]]++;
                }
            }
        }
    }
}

// Call for every row of cells; returns how many cells hold a solid voxel. With `fill`, sets the
// table of the box to the number of solid voxels.
static size_t count_cells(const sf_grid *solid, const sfi_domain *d, uint32_t *counts, int fill)
{
    size_t cells = 0;
    for (uint32_t k = 0; k < d->cells[2]; k++) {
        for (uint32_t j = 0; j < d->cells[1]; j++) {
            uint32_t *to = fill ? d->cell_at + sfi_domain_box_index(d, 0, j, k) : counts;
            count_row(solid, d, j, k, to);
            for (uint32_t i = 0; i < d->cells[0]; i++) {
                cells += to[i] != 0;
            }
        }
    }
    return cells;
}

static double mean_layer(const sf_lattice *l)
{
    return l->heights_mm == NULL ? l->layer_mm
                                 : (sf_lattice_layer_bottom(l, l->nz) - l->origin_mm[2]) / l->nz;
}

// As many voxels along each axis as come closest to an edge of `edge_mm`.
static void choose_block(const sf_lattice *l, sf_box box, double edge_mm, sfi_domain *d)
{
    double pitch[3] = {l->pitch_x_mm, l->pitch_y_mm, mean_layer(l)};
    uint32_t extent[3] = {box.x1 - box.x0, box.y1 - box.y0, box.z1 - box.z0};
    for (int axis = 0; axis < 3; axis++) {
        double ratio = floor(edge_mm / pitch[axis] + 0.5);
        d->block[axis] = !(ratio > 1) ? 1 : ratio > extent[axis] ? extent[axis] : (uint32_t)ratio;
        d->cells[axis] = (extent[axis] - 1) / d->block[axis] + 1;
    }
}

// Blocks of growing size, until they are few enough. A block of s^3 voxels holds no more than
// that, so that there is no use in trying an s whose cells could not hold all.
static sf_status choose_cells(const sf_grid *solid, double cell_mm, uint32_t most, sfi_domain *d)
{
    sf_lattice l = sf_grid_lattice(solid);
    sf_box box = sf_grid_bounds(solid);
    double voxels = (double)sf_grid_popcount(solid), pitch = mean_layer(&l);
    pitch = l.pitch_x_mm > pitch ? l.pitch_x_mm : pitch;
    pitch = l.pitch_y_mm > pitch ? l.pitch_y_mm : pitch;
    d->first[0] = box.x0;
    d->first[1] = box.y0;
    d->first[2] = box.z0;
    if (cell_mm > 0) {
        choose_block(&l, box, cell_mm, d);
        return SF_OK;
    }
    uint32_t *counts = sfi_alloc_array(&d->allocator, box.x1 - box.x0, sizeof *counts);
    if (counts == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t s = 1;; s++) {
        choose_block(&l, box, s * pitch, d);
        double room = (double)d->block[0] * d->block[1] * d->block[2] * most;
        int is_one = d->cells[0] == 1 && d->cells[1] == 1 && d->cells[2] == 1;
        if (is_one || (voxels <= room && count_cells(solid, d, counts, 0) <= most)) {
            break;
        }
    }
    sfi_free_array(&d->allocator, counts, box.x1 - box.x0, sizeof *counts);
    return SF_OK;
}

static void place_planes(const sf_lattice *l, sfi_domain *d)
{
    double pitch[2] = {l->pitch_x_mm, l->pitch_y_mm};
    for (int axis = 0; axis < 2; axis++) {
        for (uint32_t i = 0; i <= d->cells[axis]; i++) {
            double voxel = d->first[axis] + (double)i * d->block[axis];
            d->planes[axis][i] = l->origin_mm[axis] + voxel * pitch[axis];
        }
    }
    d->unit_mm = pitch[0] * d->block[0];
    double z = sf_lattice_layer_bottom(l, d->first[2]);
    uint32_t layer = d->first[2];
    for (uint32_t k = 0; k <= d->cells[2]; k++) {
        d->planes[2][k] = z;
        for (uint32_t n = 0; n < d->block[2]; n++, layer++) {
            z += sf_lattice_layer_height(l, layer < l->nz ? layer : l->nz - 1);
        }
    }
}

// Turn the table of counts into cells.
static void number_cells(sfi_domain *d)
{
    double whole = (double)d->block[0] * d->block[1] * d->block[2];
    size_t box = 0, cell = 0;
    for (uint32_t k = 0; k < d->cells[2]; k++) {
        for (uint32_t j = 0; j < d->cells[1]; j++) {
            for (uint32_t i = 0; i < d->cells[0]; i++, box++) {
                uint32_t count = d->cell_at[box];
                d->cell_at[box] = count != 0 ? (uint32_t)cell : SFI_NO_CELL;
                if (count != 0) {
                    const uint32_t at[3] = {i, j, k};
                    double part = count / whole;
                    for (int axis = 0; axis < 3; axis++) {
                        const double *plane = d->planes[axis] + at[axis];
                        d->place[3 * cell + (size_t)axis] = at[axis];
                        part *= (plane[1] - plane[0]) / d->unit_mm;
                    }
                    d->volume[cell++] = (float)part;
                }
            }
        }
    }
}

static sf_status fill_domain(const sf_grid *solid, double cell_mm, uint32_t most, sfi_domain *d)
{
    sf_lattice l = sf_grid_lattice(solid);
    SF_TRY(choose_cells(solid, cell_mm, most, d));
    SF_TRY(reserve_box(d));
    place_planes(&l, d);
    SF_TRY(reserve_cells(d, count_cells(solid, d, NULL, 1)));
    number_cells(d);
    return make_nodes(d);
}

sf_status sfi_domain_create(const sf_grid *solid, double cell_mm, uint32_t most_cells,
                            const sf_allocator *allocator, sfi_domain *domain)
{
    sfi_domain made = {.allocator = *allocator};
    if (sf_grid_popcount(solid) == 0) {
        return SF_ERR_ARGUMENT;
    }
    sf_status status = fill_domain(solid, cell_mm, most_cells, &made);
    if (status != SF_OK) {
        sfi_domain_destroy(&made);
        return status;
    }
    *domain = made;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Two together
// ---------------------------------------------------------------------------------------------

static size_t mark_parents(const sfi_domain *fine, sfi_domain *d)
{
    size_t count = 0;
    for (size_t i = 0; i < d->box_count; i++) {
        d->cell_at[i] = SFI_NO_CELL;
    }
    for (size_t c = 0; c < fine->cell_count; c++) {
        const uint32_t *p = fine->place + 3 * c;
        d->cell_at[sfi_domain_box_index(d, p[0] / 2, p[1] / 2, p[2] / 2)] = 0;
    }
    for (size_t i = 0; i < d->box_count; i++) {
        if (d->cell_at[i] == 0) {
            d->cell_at[i] = (uint32_t)count++;
        }
    }
    return count;
}

static void sum_parents(const sfi_domain *fine, sfi_domain *d)
{
    memset(d->volume, 0, d->cell_count * sizeof *d->volume);
    for (size_t c = 0; c < fine->cell_count; c++) {
        const uint32_t *p = fine->place + 3 * c;
        size_t parent = d->cell_at[sfi_domain_box_index(d, p[0] / 2, p[1] / 2, p[2] / 2)];
        d->volume[parent] += fine->volume[c];
        for (int axis = 0; axis < 3; axis++) {
            d->place[3 * parent + (size_t)axis] = p[axis] / 2;
        }
    }
}

static sf_status fill_coarse(const sfi_domain *fine, sfi_domain *d)
{
    d->unit_mm = fine->unit_mm;
    for (int axis = 0; axis < 3; axis++) {
        d->cells[axis] = (fine->cells[axis] + 1) / 2;
    }
    SF_TRY(reserve_box(d));
    for (int axis = 0; axis < 3; axis++) {
        for (uint32_t i = 0; i <= d->cells[axis]; i++) {
            uint32_t from = 2 * i < fine->cells[axis] ? 2 * i : fine->cells[axis];
            d->planes[axis][i] = fine->planes[axis][from];
        }
    }
    SF_TRY(reserve_cells(d, mark_parents(fine, d)));
    sum_parents(fine, d);
    return make_nodes(d);
}

sf_status sfi_domain_coarsen(const sfi_domain *fine, sfi_domain *coarse)
{
    sfi_domain made = {.allocator = fine->allocator};
    sf_status status = fill_coarse(fine, &made);
    if (status != SF_OK) {
        sfi_domain_destroy(&made);
        return status;
    }
    *coarse = made;
    return SF_OK;
}
