// SPDX-License-Identifier: MIT
// Lattices and grids: stacks of slices that own their memory, and where their voxels lie.
//
// A grid is a stack of slices on a lattice, z up; its rows lie on 64-byte boundaries. Slices are
// views of it (<sf/slice.h>). Arrays of voxels are in (layer, y, x) order.

#ifndef SF_GRID_H
#define SF_GRID_H

#include <sf/slice.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Largest number of layers in a grid. */
#define SF_LAYER_MAX 2147483647u

/** A half-open box of voxels: a rectangle in the layers z0 <= z < z1. */
typedef struct sf_box {
    uint32_t x0, y0, z0, x1, y1, z1; /**< first voxel, and one beyond the last, of each axis */
} sf_box;

/** An unsigned integer of 128 bits. */
typedef struct sf_wide {
    uint64_t low, high; /**< low + 2^64 high */
} sf_wide;

/** Exact sums over the solid voxels of a grid, in voxel indices. */
typedef struct sf_moments {
    uint64_t count;                 /**< number of solid voxels */
    sf_wide x, y, z;                /**< first moments */
    sf_wide xx, yy, zz, xy, xz, yz; /**< second moments */
} sf_moments;

// ---------------------------------------------------------------------------------------------
// Lattice and grid
// ---------------------------------------------------------------------------------------------

/** Where the voxels of a grid lie. The lower corner of voxel (0, 0, 0) is at origin_mm. */
typedef struct sf_lattice {
    uint32_t nx, ny, nz; /**< voxels along x and y (1..SF_EXTENT_MAX), layers (1..SF_LAYER_MAX) */
    double pitch_x_mm;   /**< voxel size along x, > 0 */
    double pitch_y_mm;   /**< voxel size along y, > 0 */
    double layer_mm;     /**< layer height, > 0; unused where heights_mm is given */
    const double *heights_mm; /**< NULL, or nz heights > 0, one per layer from the bottom */
    double origin_mm[3];      /**< x, y, z */
} sf_lattice;

/**
 * Check a lattice: counts within limits, lengths finite and positive.
 *
 * @param lattice  the lattice
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a count of 0, a pitch or height that is no
 * number in (0, 1e12], an origin beyond 1e12; SF_ERR_OVERFLOW: a count beyond its limit.
 * @cost constant, or O(nz) with heights.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_lattice_validate(const sf_lattice *lattice);

/**
 * Height of layer k in mm.
 *
 * @param lattice  a valid lattice, not NULL
 * @param k        the layer, below nz
 * @return the height.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API double sf_lattice_layer_height(const sf_lattice *lattice, uint32_t k);

/**
 * z of the bottom of layer k in mm, in the lattice's frame.
 *
 * @param lattice  a valid lattice, not NULL
 * @param k        the layer, or nz for the top
 * @return z; with heights it is their sum from the lowest up, so that it is the same everywhere.
 * @cost constant, or O(k) with heights.   @threads any.   @since 0.1
 */
SF_API double sf_lattice_layer_bottom(const sf_lattice *lattice, uint32_t k);

/** A stack of slices that owns its memory. */
typedef struct sf_grid sf_grid;

/**
 * Make a grid with all voxels empty on a lattice, which is copied, heights included.
 *
 * @param lattice    where the voxels lie; copied
 * @param allocator  for the grid; NULL for the C library's
 * @param grid       receives the grid
 * @return SF_OK; what sf_lattice_validate() says; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_OVERFLOW:
 * more bytes than a size_t holds; SF_ERR_MEMORY.
 * @cost one pass over new memory.   @threads any; one at a time for each allocator.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_create(const sf_lattice *lattice, const sf_allocator *allocator,
                                           sf_grid **grid);

/**
 * Make a copy of a grid.
 *
 * @param grid       the grid to copy
 * @param allocator  for the copy, and maybe another than the grid's own; NULL for the C library's
 * @param clone      receives the copy
 * @return as sf_grid_create().
 * @cost one pass.   @threads any that read; one at a time for each allocator.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_clone(const sf_grid *grid, const sf_allocator *allocator,
                                          sf_grid **clone);

/**
 * Free a grid.
 *
 * @param grid  the grid, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this grid.   @since 0.1
 */
SF_API void sf_grid_destroy(sf_grid *grid);

/**
 * The lattice of a grid.
 *
 * @param grid  the grid, not NULL
 * @return the lattice, by value; its heights_mm, if any, belong to the grid.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API sf_lattice sf_grid_lattice(const sf_grid *grid);

/**
 * View of slice k, to read or to write: it lives as long as the grid.
 *
 * @param grid  the grid; NULL has none
 * @param k     the layer
 * @return the slice; one without words when k is out of range or the grid NULL.
 * @cost constant.   @threads any; distinct slices may be written at once.   @since 0.1
 */
SF_API sf_slice sf_grid_slice(const sf_grid *grid, uint32_t k);

/**
 * Whether two grids have the same counts and the same solid voxels; lengths are not compared.
 *
 * @param a  one grid; NULL equals nothing
 * @param b  the other; NULL equals nothing
 * @return 1 or 0; 0 where either is NULL.
 * @cost one pass, up to the first row that differs.   @threads any.   @since 0.1
 */
SF_API int sf_grid_equal(const sf_grid *a, const sf_grid *b);

/**
 * Number of solid voxels.
 *
 * @param grid  the grid; NULL has no voxels
 * @return the number; 0 for NULL.
 * @cost one pass.   @threads any.   @since 0.1
 */
SF_API uint64_t sf_grid_popcount(const sf_grid *grid);

/**
 * Smallest box around the solid voxels.
 *
 * @param grid  the grid; NULL has no voxels
 * @return the box; all zero when there are none, or for NULL.
 * @cost one pass at most.   @threads any.   @since 0.1
 */
SF_API sf_box sf_grid_bounds(const sf_grid *grid);

/**
 * Exact moments of the solid voxels, in voxel indices; a failing call leaves `moments` as it was.
 *
 * @param grid     the grid
 * @param task     NULL, or progress, cancel and threads
 * @param moments  receives the sums
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer other than `task`; SF_ERR_CANCELLED, which is
 * heeded after every 64 slices.
 * @cost one pass, shared among the task's threads.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_measure(const sf_grid *grid, sf_task *task,
                                            sf_moments *moments);

#ifdef __cplusplus
}
#endif

#endif
