// SPDX-License-Identifier: MIT
// The cells on which weights live: boxes of a rectilinear lattice, and their corners.

#ifndef SF_BALANCE_WEIGHTS_DOMAIN_H
#define SF_BALANCE_WEIGHTS_DOMAIN_H

#include <sf/voxel.h>

// No cell here.
#define SFI_NO_CELL UINT32_MAX

typedef struct sfi_domain {
    sf_allocator allocator;
    uint32_t first[3]; // voxel in which cell 0 begins
    uint32_t block[3]; // voxels of a cell
    uint32_t cells[3]; // cells of the box around all
    double *planes[3]; // cells + 1 coordinates along each axis in mm, rising
    double unit_mm;    // about the edge of a cell, of the finest domain
    size_t box_count;  // product of `cells`
    uint32_t *cell_at; // the cell at each place of the box, or SFI_NO_CELL
    uint32_t *closest; // NULL, or a cell about as close as any to each place of the box
    size_t cell_count; // cells and nodes are numbered in (z, y, x) order
    uint32_t *place;   // three indices of each cell
    float *volume;     // of each cell, what of it is solid, in units^3
    uint32_t *corners; // eight nodes of each cell, x fastest
    size_t node_count;
    uint32_t *node_place; // three indices of each node, into the planes
} sfi_domain;

// The cells of a grid: blocks of voxels that hold a solid one. Blocks are as near to cubes as the
// lattice lets them; with cell_mm 0 they grow until there are no more than most_cells of them.
// SF_ERR_ARGUMENT: nothing is solid; SF_ERR_OVERFLOW: 2^31 nodes or more; SF_ERR_MEMORY.
sf_status sfi_domain_create(const sf_grid *solid, double cell_mm, uint32_t most_cells,
                            const sf_allocator *allocator, sfi_domain *domain);
void sfi_domain_destroy(sfi_domain *domain);

// The same with two cells taken together along each axis.
sf_status sfi_domain_coarsen(const sfi_domain *fine, sfi_domain *coarse);

// Place of the box by its three indices, in cells.
static inline size_t sfi_domain_box_index(const sfi_domain *d, uint32_t i, uint32_t j, uint32_t k)
{
    return ((size_t)k * d->cells[1] + j) * d->cells[0] + i;
}

// The middle of a cell, in mm.
static inline void sfi_domain_middle(const sfi_domain *d, size_t cell, double middle[3])
{
    for (int axis = 0; axis < 3; axis++) {
        const double *plane = d->planes[axis] + d->place[3 * cell + (size_t)axis];
        middle[axis] = 0.5 * (plane[0] + plane[1]);
    }
}

// Where a point is taken to lie.
typedef struct sfi_spot {
    uint32_t cell; // SFI_NO_CELL where none was found
    double at[3];  // the point, or the closest one of that cell
    double square; // of the distance between them
    int moved[3];  // whether it was moved along each axis
} sfi_spot;

// A point taken into a cell.
sfi_spot sfi_domain_spot(const sfi_domain *domain, const double p[3], uint32_t cell);

// The cell whose closed box lies closest to a point, which must be finite: the one that holds it,
// if there is one; of several the last in (z, y, x) order. Cells with `skip` != 0, which may be
// NULL, do not count, nor do those whose distance is not below the root of `limit`. Costs the boxes
// nearer than that cell.
sfi_spot sfi_domain_search(const sfi_domain *domain, const double p[3], const uint8_t *skip,
                           double limit);

// Make `closest`. SF_ERR_MEMORY.
sf_status sfi_domain_reach(sfi_domain *domain);

// The same as a search without skip and limit, where the closest cell lies within two boxes; else a
// cell about as close. Needs `closest`; costs little.
sfi_spot sfi_domain_find(const sfi_domain *domain, const double p[3]);

#endif
