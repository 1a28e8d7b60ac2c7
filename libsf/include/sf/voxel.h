// SPDX-License-Identifier: MIT
// Voxels: slices, structuring elements, lattices and grids.
//
// A slice is a plane of bits, a grid is a stack of slices on a lattice, z up. Said once, for the
// whole library: voxel x of row y is bit x % 64 of words[y * stride + x / 64]; bits past the width
// are zero in what a call writes and ignored on entry; a voxel is solid or not at its centre. What
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
    SF_ISA_AVX512 = 5,    /**< x86, 512 bits, with VBMI2 */
    SF_ISA_COUNT = 6      /**< number of instruction sets, not one of them */
} sf_isa;

/**
 * Use no instruction set above `limit`, for tests and benches; results never depend on it.
 *
 * @param limit  the highest set to use; SF_ISA_COUNT or any other value lifts the limit
 * @return the name of the set now in use: the best one that the processor has within the limit.
 * @cost constant.   @threads any; work under way elsewhere may end on the old set.   @since 0.1
 */
SF_API const char *sf_isa_limit(sf_isa limit);

// ---------------------------------------------------------------------------------------------
// Slices
// ---------------------------------------------------------------------------------------------

/**
 * Words from row to row in slices that the library allocates: rows start on 64-byte boundaries.
 *
 * @return the smallest multiple of 8 words that holds `width` voxels.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API size_t sf_slice_stride(uint32_t width);

/**
 * Whether voxel (x, y) is solid.
 *
 * @return 1 or 0; 0 for a voxel outside the slice and for a slice without words.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API int sf_slice_get(sf_slice slice, uint32_t x, uint32_t y);

/**
 * Make voxel (x, y) solid (value != 0) or empty.
 *
 * @return SF_OK; SF_ERR_ARGUMENT: a slice that is none (no words, a width or height outside its
 * range, a stride that is too small), a voxel outside.
 * @cost constant.   @threads one per slice.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_set(sf_slice slice, uint32_t x, uint32_t y, int value);

/**
 * Make every voxel of a rectangle solid (value != 0) or empty; an empty rectangle changes nothing.
 *
 * @return SF_OK; SF_ERR_ARGUMENT: a slice that is none, a rectangle that leaves it.
 * @cost the words of the rectangle.   @threads one per slice.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_fill(sf_slice slice, sf_rect rect, int value);

/**
 * dst = src.
 *
 * Both have one size, with any strides. dst may be src (the same words and stride), but must not
 * lie across it; so too for both inputs of the four functions that follow.
 *
 * @return SF_OK; SF_ERR_ARGUMENT: a slice that is none, a dst across an input; SF_ERR_SHAPE: slices
 * that differ in size.
 * @cost one pass over the slices.   @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_copy(sf_slice dst, sf_slice src);

/**
 * dst = a AND b: solid where both are.
 *
 * @return as sf_slice_copy().
 * @cost one pass.   @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_and(sf_slice dst, sf_slice a, sf_slice b);

/**
 * dst = a OR b: solid where either is.
 *
 * @return as sf_slice_copy().
 * @cost one pass.   @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_or(sf_slice dst, sf_slice a, sf_slice b);

/**
 * dst = a XOR b: solid where just one is.
 *
 * @return as sf_slice_copy().
 * @cost one pass.   @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_xor(sf_slice dst, sf_slice a, sf_slice b);

/**
 * dst = a AND NOT b: solid where a is and b is not.
 *
 * @return as sf_slice_copy().
 * @cost one pass.   @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_subtract(sf_slice dst, sf_slice a, sf_slice b);

/**
 * Whether two slices have the same size and the same solid voxels.
 *
 * @return 1 or 0; 0 where either is no slice.
 * @cost one pass, up to the first row that differs.   @threads any.   @since 0.1
 */
SF_API int sf_slice_equal(sf_slice a, sf_slice b);

/**
 * Number of solid voxels.
 *
 * @return the number; 0 for a slice that is none.
 * @cost one pass.   @threads any.   @since 0.1
 */
SF_API uint64_t sf_slice_popcount(sf_slice slice);

/**
 * Smallest rectangle around the solid voxels.
 *
 * @return the rectangle; all zero where nothing is solid, and for a slice that is none.
 * @cost one pass at most.   @threads any.   @since 0.1
 */
SF_API sf_rect sf_slice_bounds(sf_slice slice);

/**
 * Exact integer sums over the solid voxels: their number, and those of x, y and their products.
 *
 * @return SF_OK; SF_ERR_ARGUMENT: a slice that is none, a NULL pointer.
 * @cost one pass.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_measure(sf_slice slice, sf_slice_sums *sums);

// ---------------------------------------------------------------------------------------------
// Morphology
// ---------------------------------------------------------------------------------------------

/**
 * The 3x3 square.
 *
 * @return the element, by value.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API sf_element sf_element_box3(void);

/**
 * The plus: a voxel and its four edge neighbours.
 *
 * @return the element, by value.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API sf_element sf_element_plus3(void);

/**
 * Lattice points of the ellipse (dx / rx)^2 + (dy / ry)^2 <= 1, with radii in 1/65536 voxel.
 *
 * Exact: no point is lost or won by rounding. A radius below a voxel gives no reach on its axis.
 *
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_OVERFLOW: a radius of SF_REACH_MAX + 1
 * voxels or more.
 * @cost O(rx + ry), in voxels.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_element_ellipse(uint64_t rx_q16, uint64_t ry_q16,
                                               sf_element *element);

/**
 * Minkowski sum of two elements: dilating by it is dilating by one and then by the other.
 *
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, an element that breaks its promises;
 * SF_ERR_OVERFLOW: a sum that reaches beyond SF_REACH_MAX. `sum` may be `a` or `b`.
 * @cost the product of both reaches along y.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_element_sum(const sf_element *a, const sf_element *b,
                                           sf_element *sum);

/**
 * Dilation: dst is solid where the element, placed there, meets src or, beyond it, the border.
 *
 * Both have one size. dst must not overlap src.
 *
 * @return SF_OK; SF_ERR_ARGUMENT: a slice that is none, an element that breaks its promises, no
 * such border, a dst that overlaps src; SF_ERR_SHAPE: slices that differ in size.
 * @cost 2 reach_y + 1 unions of rows for each row, and a few shifts where half widths change.
 * @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_dilate(sf_slice dst, sf_slice src, const sf_element *element,
                                            sf_border border);

/**
 * Erosion: dst is solid where the element, placed there, lies in src and, beyond it, in the border.
 *
 * It is the complement of the dilation of the complement, the border complemented as well.
 *
 * @return as sf_slice_dilate().
 * @cost as sf_slice_dilate().   @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_erode(sf_slice dst, sf_slice src, const sf_element *element,
                                           sf_border border);

/**
 * One step of trimming in one pass: dst = src AND dilate(below), outside empty.
 *
 * All three have one size. dst may be src, and must not overlap below.
 *
 * @return as sf_slice_dilate().
 * @cost one pass for the square and the plus, else as sf_slice_dilate().
 * @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_and_dilate(sf_slice dst, sf_slice src, sf_slice below,
                                                const sf_element *element);

// ---------------------------------------------------------------------------------------------
// Runs and components
// ---------------------------------------------------------------------------------------------

/**
 * Number of runs of solid voxels: the capacity that sf_slice_runs() needs.
 *
 * @return SF_OK; SF_ERR_ARGUMENT: a slice that is none, a NULL pointer; SF_ERR_OVERFLOW: more runs
 * than a size_t holds.
 * @cost one pass.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_run_count(sf_slice slice, size_t *count);

/**
 * The runs of a slice in row order, from left to right, with label 0.
 *
 * @return SF_OK; SF_ERR_CAPACITY: more runs than places, with their number in `count` and nothing
 * else written; else as sf_slice_run_count(). `runs` may be NULL where there are none.
 * @cost two passes, and the runs.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_runs(sf_slice slice, sf_run *runs, size_t capacity,
                                          size_t *count);

/**
 * Paint runs, in any order and free to overlap: dst is solid where a run is, and empty elsewhere.
 *
 * @return SF_OK; SF_ERR_ARGUMENT: a slice that is none, a NULL pointer, a run that is empty or
 * leaves the slice.
 * @cost one pass, and the runs.   @threads one per slice.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_from_runs(sf_slice dst, const sf_run *runs, size_t count);

/**
 * Label runs with their connected component, in place, numbered from 0 by first run.
 *
 * The runs are those of sf_slice_runs(): in row order, from left to right, with an empty voxel
 * between those of one row. Labels on entry are ignored.
 *
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such connectivity, runs that are empty, out of
 * order or beyond the largest slice; SF_ERR_OVERFLOW: more than UINT32_MAX runs.
 * @cost nearly linear in the runs; no memory.   @threads one per array.
 * @source R. E. Tarjan, "Efficiency of a Good But Not Linear Set Union Algorithm", 1975. @since 0.1
 */
SF_API SF_CHECKED sf_status sf_runs_label(sf_run *runs, size_t count, sf_connectivity connectivity,
                                          uint32_t *component_count);

/**
 * Area and bounds of each labelled component; places that no run names become zero.
 *
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a run that is empty or beyond the largest slice;
 * SF_ERR_CAPACITY: a label without a place.
 * @cost linear in runs and places.   @threads any that write to distinct arrays.   @since 0.1
 */
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

/**
 * Check a lattice: counts within limits, lengths finite and positive.
 *
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a count of 0, a pitch or height that is no
 * number in (0, 1e12], an origin beyond 1e12; SF_ERR_OVERFLOW: a count beyond its limit.
 * @cost constant, or O(nz) with heights.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_lattice_validate(const sf_lattice *lattice);

/**
 * Height of layer k in mm; k must be below nz.
 *
 * @return the height.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API double sf_lattice_layer_height(const sf_lattice *lattice, uint32_t k);

/**
 * z of the bottom of layer k in mm, in the lattice's frame; k may be nz, which gives the top.
 *
 * @return z; with heights it is their sum from the lowest up, so that it is the same everywhere.
 * @cost constant, or O(k) with heights.   @threads any.   @since 0.1
 */
SF_API double sf_lattice_layer_bottom(const sf_lattice *lattice, uint32_t k);

/** A stack of slices that owns its memory. */
typedef struct sf_grid sf_grid;

/**
 * Make a grid with all voxels empty on a lattice, which is copied, heights included.
 *
 * @return SF_OK; what sf_lattice_validate() says; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_OVERFLOW:
 * more bytes than a size_t holds; SF_ERR_MEMORY. `allocator` may be NULL.
 * @cost one pass over new memory.   @threads any; one at a time for each allocator.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_create(const sf_lattice *lattice, const sf_allocator *allocator,
                                           sf_grid **grid);

/**
 * Make a copy of a grid, with memory from `allocator`, which may be NULL and another than its own.
 *
 * @return as sf_grid_create().
 * @cost one pass.   @threads any that read; one at a time for each allocator.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_clone(const sf_grid *grid, const sf_allocator *allocator,
                                          sf_grid **clone);

/**
 * Free a grid; NULL does nothing.
 *
 * @cost constant.   @threads one, and nobody else with this grid.   @since 0.1
 */
SF_API void sf_grid_destroy(sf_grid *grid);

/**
 * The lattice of a grid, which must not be NULL.
 *
 * @return the lattice, by value; its heights_mm, if any, belong to the grid.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API sf_lattice sf_grid_lattice(const sf_grid *grid);

/**
 * View of slice k, to read or to write: it lives as long as the grid.
 *
 * @return the slice; one without words when k is out of range or the grid NULL.
 * @cost constant.   @threads any; distinct slices may be written at once.   @since 0.1
 */
SF_API sf_slice sf_grid_slice(const sf_grid *grid, uint32_t k);

/**
 * Whether two grids have the same counts and the same solid voxels; lengths are not compared.
 *
 * @return 1 or 0; 0 where either is NULL.
 * @cost one pass, up to the first row that differs.   @threads any.   @since 0.1
 */
SF_API int sf_grid_equal(const sf_grid *a, const sf_grid *b);

/**
 * Number of solid voxels.
 *
 * @return the number; 0 for NULL.
 * @cost one pass.   @threads any.   @since 0.1
 */
SF_API uint64_t sf_grid_popcount(const sf_grid *grid);

/**
 * Smallest box around the solid voxels.
 *
 * @return the box; all zero when there are none, or for NULL.
 * @cost one pass at most.   @threads any.   @since 0.1
 */
SF_API sf_box sf_grid_bounds(const sf_grid *grid);

/**
 * Exact moments of the solid voxels, in voxel indices; a failing call leaves `moments` as it was.
 *
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
