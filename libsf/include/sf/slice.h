// SPDX-License-Identifier: MIT
// Slices: planes of bits, structuring elements, runs and components.
//
// Voxel x of row y is bit x % 64 of words[y * stride + x / 64]; bits past the width are zero in
// what a call writes and ignored on entry. What lies outside a slice is an argument of each call
// that looks there, never a global. A slice is a view: it owns nothing.

#ifndef SF_SLICE_H
#define SF_SLICE_H

#include <sf/base.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Limits, views and small values
// ---------------------------------------------------------------------------------------------

/** Largest width and height of a slice, in voxels. */
#define SF_EXTENT_MAX 65535u
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
    uint32_t x0, y0, x1, y1; /**< first column and row, and those after the last */
} sf_rect;

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
 * @return the name of the set now in use: the best one that the processor has within the limit;
 * a static string, never NULL.
 * @cost constant.   @threads any; work under way elsewhere may end on the old set.   @since 0.1
 */
SF_API const char *sf_isa_limit(sf_isa limit);

// ---------------------------------------------------------------------------------------------
// Slices
// ---------------------------------------------------------------------------------------------

/**
 * Words from row to row in slices that the library allocates: rows start on 64-byte boundaries.
 *
 * @param width  voxels along x
 * @return the smallest multiple of 8 words that holds `width` voxels.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API size_t sf_slice_stride(uint32_t width);

/**
 * Whether voxel (x, y) is solid.
 *
 * @param slice  the slice
 * @param x      column
 * @param y      row
 * @return 1 or 0; 0 for a voxel outside the slice and for a slice without words.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API int sf_slice_get(sf_slice slice, uint32_t x, uint32_t y);

/**
 * Make voxel (x, y) solid (value != 0) or empty.
 *
 * @param slice  the slice, written
 * @param x      column, below the width
 * @param y      row, below the height
 * @param value  0: empty; else solid
 * @return SF_OK; SF_ERR_ARGUMENT: a slice that is none (no words, a width or height outside its
 * range, a stride that is too small), a voxel outside.
 * @cost constant.   @threads one per slice.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_set(sf_slice slice, uint32_t x, uint32_t y, int value);

/**
 * Make every voxel of a rectangle solid (value != 0) or empty; an empty rectangle changes nothing.
 *
 * @param slice  the slice, written
 * @param rect   the voxels, all within the slice
 * @param value  0: empty; else solid
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
 * @param dst  the copy, written
 * @param src  what is copied
 * @return SF_OK; SF_ERR_ARGUMENT: a slice that is none, a dst across an input; SF_ERR_SHAPE: slices
 * that differ in size.
 * @cost one pass over the slices.   @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_copy(sf_slice dst, sf_slice src);

/**
 * dst = a AND b: solid where both are.
 *
 * @param dst  the result, written
 * @param a    one slice
 * @param b    the other
 * @return as sf_slice_copy().
 * @cost one pass.   @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_and(sf_slice dst, sf_slice a, sf_slice b);

/**
 * dst = a OR b: solid where either is.
 *
 * @param dst  the result, written
 * @param a    one slice
 * @param b    the other
 * @return as sf_slice_copy().
 * @cost one pass.   @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_or(sf_slice dst, sf_slice a, sf_slice b);

/**
 * dst = a XOR b: solid where just one is.
 *
 * @param dst  the result, written
 * @param a    one slice
 * @param b    the other
 * @return as sf_slice_copy().
 * @cost one pass.   @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_xor(sf_slice dst, sf_slice a, sf_slice b);

/**
 * dst = a AND NOT b: solid where a is and b is not.
 *
 * @param dst  the result, written
 * @param a    one slice
 * @param b    what is taken away from it
 * @return as sf_slice_copy().
 * @cost one pass.   @threads any that write to distinct slices.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_subtract(sf_slice dst, sf_slice a, sf_slice b);

/**
 * Whether two slices have the same size and the same solid voxels.
 *
 * @param a  one slice
 * @param b  the other
 * @return 1 or 0; 0 where either is no slice.
 * @cost one pass, up to the first row that differs.   @threads any.   @since 0.1
 */
SF_API int sf_slice_equal(sf_slice a, sf_slice b);

/**
 * Number of solid voxels.
 *
 * @param slice  the slice
 * @return the number; 0 for a slice that is none.
 * @cost one pass.   @threads any.   @since 0.1
 */
SF_API uint64_t sf_slice_popcount(sf_slice slice);

/**
 * Smallest rectangle around the solid voxels.
 *
 * @param slice  the slice
 * @return the rectangle; all zero where nothing is solid, and for a slice that is none.
 * @cost one pass at most.   @threads any.   @since 0.1
 */
SF_API sf_rect sf_slice_bounds(sf_slice slice);

/**
 * Exact integer sums over the solid voxels: their number, and those of x, y and their products.
 *
 * @param slice  the slice
 * @param sums   receives the sums
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
 * @param rx_q16   radius along x, in 1/65536 voxel
 * @param ry_q16   radius along y, in 1/65536 voxel
 * @param element  receives the element
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_OVERFLOW: a radius of SF_REACH_MAX + 1
 * voxels or more.
 * @cost O(rx + ry), in voxels.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_element_ellipse(uint64_t rx_q16, uint64_t ry_q16,
                                               sf_element *element);

/**
 * Minkowski sum of two elements: dilating by it is dilating by one and then by the other.
 *
 * @param a    one element
 * @param b    the other
 * @param sum  receives the sum; may be `a` or `b`
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, an element that breaks its promises;
 * SF_ERR_OVERFLOW: a sum that reaches beyond SF_REACH_MAX.
 * @cost the product of both reaches along y.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_element_sum(const sf_element *a, const sf_element *b,
                                           sf_element *sum);

/**
 * Dilation: dst is solid where the element, placed there, meets src or, beyond it, the border.
 *
 * Both have one size. dst must not overlap src.
 *
 * @param dst      the result, written
 * @param src      what is dilated
 * @param element  by what
 * @param border   what lies outside src
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
 * @param dst      the result, written
 * @param src      what is eroded
 * @param element  by what
 * @param border   what lies outside src
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
 * @param dst      the result, written
 * @param src      the layer that is trimmed
 * @param below    the layer below it, which is dilated
 * @param element  by what
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
 * @param slice  the slice
 * @param count  receives the number
 * @return SF_OK; SF_ERR_ARGUMENT: a slice that is none, a NULL pointer; SF_ERR_OVERFLOW: more runs
 * than a size_t holds.
 * @cost one pass.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_run_count(sf_slice slice, size_t *count);

/**
 * The runs of a slice in row order, from left to right, with label 0.
 *
 * @param slice     the slice
 * @param runs      receives the runs; may be NULL where there are none
 * @param capacity  places in `runs`
 * @param count     receives the number of runs
 * @return SF_OK; SF_ERR_CAPACITY: more runs than places, with their number in `count` and nothing
 * else written; else as sf_slice_run_count().
 * @cost two passes, and the runs.   @threads any.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_runs(sf_slice slice, sf_run *runs, size_t capacity,
                                          size_t *count);

/**
 * Paint runs, in any order and free to overlap: dst is solid where a run is, and empty elsewhere.
 *
 * @param dst    the slice, written
 * @param runs   the runs; labels are ignored; may be NULL where count is 0
 * @param count  how many
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
 * @param runs             the runs, whose labels are written; may be NULL where count is 0
 * @param count            how many
 * @param connectivity     which voxels are neighbours
 * @param component_count  receives the number of components
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
 * @param runs        labelled runs; may be NULL where count is 0
 * @param count       how many
 * @param components  receives area and bounds, by label; may be NULL where capacity is 0
 * @param capacity    places in `components`
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a run that is empty or beyond the largest slice;
 * SF_ERR_CAPACITY: a label without a place.
 * @cost linear in runs and places.   @threads any that write to distinct arrays.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_runs_measure(const sf_run *runs, size_t count,
                                            sf_component *components, size_t capacity);

#ifdef __cplusplus
}
#endif

#endif
