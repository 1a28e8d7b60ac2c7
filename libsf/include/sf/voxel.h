// SPDX-License-Identifier: MIT
// Voxels: slices, structuring elements, lattices and grids.
//
// A slice is a plane of bits, a grid is a stack of slices on a lattice, z up. Said once, for the
// whole library: voxel x of row y is bit x % 64 of words[y * stride + x / 64]; bits past the width
// are zero after every call and are ignored on entry; a voxel is solid or not at its centre. What
// lies outside a slice is an argument of each call that looks there, never a global. Arrays of
// voxels are in (layer, y, x) order. Lengths are millimetres (_mm) or voxels (_vx).
//
// A slice is a view: it owns nothing. A grid owns its memory, with rows on 64-byte boundaries.

#ifndef SF_VOXEL_H
#define SF_VOXEL_H

#include <sf/base.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Limits, views and small values
// ---------------------------------------------------------------------------------------------

/** Largest width and height of a slice, in voxels. */
#define SF_EXTENT_MAX 65535u
/** Largest number of layers in a grid. */
#define SF_LAYER_MAX 2147483647u
/** Largest reach of a structuring element along x and along y, in voxels. */
#define SF_REACH_MAX 255u

/** A view of a plane of bits. Passed by value; the words belong to somebody else. */
typedef struct sf_slice {
    uint64_t *words; /**< first word of row 0, 8-byte aligned */
    uint32_t width;  /**< voxels along x, 1..SF_EXTENT_MAX */
    uint32_t height; /**< rows along y, 1..SF_EXTENT_MAX */
    size_t stride;   /**< words from one row to the next, at least (width + 63) / 64 */
} sf_slice;

/** What the voxels outside a slice are taken for. */
typedef enum sf_border {
    SF_BORDER_EMPTY = 0, /**< nothing outside */
    SF_BORDER_SOLID = 1  /**< matter everywhere outside */
} sf_border;

/** A half-open rectangle of voxels: x0 <= x < x1, y0 <= y < y1; empty when x0 >= x1 or y0 >= y1. */
typedef struct sf_rect {
    uint32_t x0, y0, x1, y1;
} sf_rect;

/** A half-open box of voxels: a rectangle in the layers z0 <= z < z1. */
typedef struct sf_box {
    uint32_t x0, y0, z0, x1, y1, z1;
} sf_box;

/**
 * A structuring element that is symmetric in x and in y and convex along rows.
 *
 * Offset (dx, dy) belongs to it when |dy| <= reach_y and |dx| <= half_width[|dy|]; half_width never
 * grows with |dy|. A single voxel, the plus, the 3x3 square, ellipses and Minkowski sums of these
 * are of this kind.
 */
typedef struct sf_element {
    uint16_t reach_y;                      /**< 0..SF_REACH_MAX */
    uint16_t half_width[SF_REACH_MAX + 1]; /**< each 0..SF_REACH_MAX; entries past reach_y unused */
} sf_element;

/** Exact sums over the solid voxels of a slice, in voxel indices. */
typedef struct sf_slice_sums {
    uint64_t count;      /**< number of solid voxels */
    uint64_t x, y;       /**< sum of x, of y */
    uint64_t xx, yy, xy; /**< sum of x*x, y*y, x*y; all fit for every slice within the limits */
} sf_slice_sums;

/** An unsigned integer of 128 bits. */
typedef struct sf_wide {
    uint64_t low, high;
} sf_wide;

/** Exact sums over the solid voxels of a grid, in voxel indices. */
typedef struct sf_moments {
    uint64_t count;                 /**< number of solid voxels */
    sf_wide x, y, z;                /**< first moments */
    sf_wide xx, yy, zz, xy, xz, yz; /**< second moments */
} sf_moments;

/** Which voxels of a slice count as neighbours. */
typedef enum sf_connectivity {
    SF_CONNECT_EDGES = 4,  /**< four neighbours: those that share an edge */
    SF_CONNECT_CORNERS = 8 /**< eight neighbours: those that share an edge or a corner */
} sf_connectivity;

/** A maximal run of solid voxels in one row: x0 <= x < x1. */
typedef struct sf_run {
    uint32_t x0, x1; /**< half-open */
    uint32_t y;      /**< row */
    uint32_t label;  /**< component, once labelled; 0-based */
} sf_run;

/** One connected component of a slice. */
typedef struct sf_component {
    uint64_t area;  /**< voxels */
    sf_rect bounds; /**< smallest rectangle around it */
} sf_component;

// ---------------------------------------------------------------------------------------------
// Instruction sets
// ---------------------------------------------------------------------------------------------

/** Instruction sets that kernels are written for, from plain to fast. */
typedef enum sf_isa {
    SF_ISA_REFERENCE = 0, /**< one bit at a time: the specification */
    SF_ISA_WORD = 1,      /**< 64-bit words, plain C */
    SF_ISA_SSE2 = 2,      /**< x86, 128 bits */
    SF_ISA_NEON = 3,      /**< Arm, 128 bits */
    SF_ISA_AVX2 = 4,      /**< x86, 256 bits */
    SF_ISA_COUNT = 5      /**< number of instruction sets, not one of them */
} sf_isa;

/**
 * Use no instruction set above `limit`, for tests and benches; results never depend on it.
 *
 * @param limit  the highest set to use; SF_ISA_AVX2 or any other value lifts the limit
 * @return the name of the set now in use: the best one that the processor has within the limit.
 * @cost constant.   @threads any; work under way on other threads may finish on the old set.
 * @since 0.1
 */
SF_API const char *sf_isa_limit(sf_isa limit);

// ---------------------------------------------------------------------------------------------
// Slices
// ---------------------------------------------------------------------------------------------

/** Words from row to row in slices that the library allocates: rows start on 64-byte boundaries. */
SF_API size_t sf_slice_stride(uint32_t width);

/** Whether voxel (x, y) is solid; a voxel outside is not. */
SF_API int sf_slice_get(sf_slice slice, uint32_t x, uint32_t y);

/** Make voxel (x, y) solid (value != 0) or empty. SF_ERR_ARGUMENT when it lies outside. */
SF_API SF_CHECKED sf_status sf_slice_set(sf_slice slice, uint32_t x, uint32_t y, int value);

/** Make every voxel of a rectangle solid or empty. */
SF_API SF_CHECKED sf_status sf_slice_fill(sf_slice slice, sf_rect rect, int value);

/** dst = src. */
SF_API SF_CHECKED sf_status sf_slice_copy(sf_slice dst, sf_slice src);

/** dst = a AND b. */
SF_API SF_CHECKED sf_status sf_slice_and(sf_slice dst, sf_slice a, sf_slice b);

/** dst = a OR b. */
SF_API SF_CHECKED sf_status sf_slice_or(sf_slice dst, sf_slice a, sf_slice b);

/** dst = a XOR b. */
SF_API SF_CHECKED sf_status sf_slice_xor(sf_slice dst, sf_slice a, sf_slice b);

/** dst = a AND NOT b. */
SF_API SF_CHECKED sf_status sf_slice_subtract(sf_slice dst, sf_slice a, sf_slice b);

/** 1 when both have the same size and the same solid voxels, else 0. */
SF_API int sf_slice_equal(sf_slice a, sf_slice b);

/** Number of solid voxels. */
SF_API uint64_t sf_slice_popcount(sf_slice slice);

/** Smallest rectangle around the solid voxels; empty (all zero) when there are none. */
SF_API sf_rect sf_slice_bounds(sf_slice slice);

/** Exact integer sums over the solid voxels. */
SF_API SF_CHECKED sf_status sf_slice_measure(sf_slice slice, sf_slice_sums *sums);

// ---------------------------------------------------------------------------------------------
// Morphology
// ---------------------------------------------------------------------------------------------

/** The 3x3 square. */
SF_API sf_element sf_element_box3(void);

/** The plus: a voxel and its four edge neighbours. */
SF_API sf_element sf_element_plus3(void);

/** Lattice points of the ellipse (dx/rx)^2 + (dy/ry)^2 <= 1; radii in 1/65536 voxel, exact. */
SF_API SF_CHECKED sf_status sf_element_ellipse(uint64_t rx_q16, uint64_t ry_q16,
                                               sf_element *element);

/** Minkowski sum of two elements. SF_ERR_OVERFLOW when it would reach beyond SF_REACH_MAX. */
SF_API SF_CHECKED sf_status sf_element_sum(const sf_element *a, const sf_element *b,
                                           sf_element *sum);

/** Dilation: dst is solid where the element, placed there, meets src. dst must not overlap src. */
SF_API SF_CHECKED sf_status sf_slice_dilate(sf_slice dst, sf_slice src, const sf_element *element,
                                            sf_border border);

/** Erosion: dst is solid where the element, placed there, lies in src. dst must not overlap src. */
SF_API SF_CHECKED sf_status sf_slice_erode(sf_slice dst, sf_slice src, const sf_element *element,
                                           sf_border border);

/**
 * dst = src AND dilate(below), outside empty: one step of trimming, in one pass. dst may be src.
 */
SF_API SF_CHECKED sf_status sf_slice_and_dilate(sf_slice dst, sf_slice src, sf_slice below,
                                                const sf_element *element);

// ---------------------------------------------------------------------------------------------
// Runs and components
// ---------------------------------------------------------------------------------------------

/** Number of runs of solid voxels: the capacity that sf_slice_runs needs. */
SF_API SF_CHECKED sf_status sf_slice_run_count(sf_slice slice, size_t *count);

/** The runs in row order, left to right, labels 0. SF_ERR_CAPACITY, with the need in count. */
SF_API SF_CHECKED sf_status sf_slice_runs(sf_slice slice, sf_run *runs, size_t capacity,
                                          size_t *count);

/** Paint runs into a slice (solid where a run is, empty elsewhere). */
SF_API SF_CHECKED sf_status sf_slice_from_runs(sf_slice dst, const sf_run *runs, size_t count);

/**
 * Label runs in row order with their connected component, in place, 0-based in order of first run.
 */
SF_API SF_CHECKED sf_status sf_runs_label(sf_run *runs, size_t count, sf_connectivity connectivity,
                                          uint32_t *component_count);

/** Area and bounds of each labelled component. */
SF_API SF_CHECKED sf_status sf_runs_measure(const sf_run *runs, size_t count,
                                            sf_component *components, size_t capacity);

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

/** Check a lattice: counts within limits, pitches and heights finite and positive. */
SF_API SF_CHECKED sf_status sf_lattice_validate(const sf_lattice *lattice);

/** Height of layer k in mm. */
SF_API double sf_lattice_layer_height(const sf_lattice *lattice, uint32_t k);

/** z of the bottom of layer k in mm, in the lattice's frame; k may be nz, which gives the top. */
SF_API double sf_lattice_layer_bottom(const sf_lattice *lattice, uint32_t k);

/** A stack of slices that owns its memory. */
typedef struct sf_grid sf_grid;

/** Make an empty grid (all voxels empty) on a lattice, which is copied, heights included. */
SF_API SF_CHECKED sf_status sf_grid_create(const sf_lattice *lattice, const sf_allocator *allocator,
                                           sf_grid **grid);

/** Make a copy of a grid. */
SF_API SF_CHECKED sf_status sf_grid_clone(const sf_grid *grid, const sf_allocator *allocator,
                                          sf_grid **clone);

/** Free a grid; NULL does nothing. */
SF_API void sf_grid_destroy(sf_grid *grid);

/** The grid's lattice; its heights_mm, if any, belong to the grid. */
SF_API sf_lattice sf_grid_lattice(const sf_grid *grid);

/** View of slice k; a slice with words == NULL when k is out of range. */
SF_API sf_slice sf_grid_slice(const sf_grid *grid, uint32_t k);

/** 1 when both grids have the same counts and the same solid voxels. */
SF_API int sf_grid_equal(const sf_grid *a, const sf_grid *b);

/** Number of solid voxels. */
SF_API uint64_t sf_grid_popcount(const sf_grid *grid);

/** Smallest box around the solid voxels; empty (all zero) when there are none. */
SF_API sf_box sf_grid_bounds(const sf_grid *grid);

/** Exact moments of the solid voxels. */
SF_API SF_CHECKED sf_status sf_grid_measure(const sf_grid *grid, sf_task *task,
                                            sf_moments *moments);

#ifdef __cplusplus
}
#endif

#endif
