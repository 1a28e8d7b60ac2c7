// SPDX-License-Identifier: MIT
// Contours: layers as closed polygons, which is how slicers and laser machines exchange them.
//
// A layer is a set of closed polygons in the plane, in mm. What lies inside is said by a fill rule,
// and both rules that are in use are here: nonzero (what the polygons wind around, so holes turn
// the other way than what they are holes in) and even-odd (what an odd number of polygons encloses,
// whichever way they turn). A voxel is solid when its centre is inside. Centres that lie on an edge
// belong to one side only: to what lies right of it or above it. So polygons that share edges share
// no voxel and leave none out.
//
// Points are rounded to 1/8192 of a voxel, and what follows is exact, in integers: the same voxels
// on every machine.
//
// A stack of contours owns layers with their heights, from the bottom up. Files of contours are
// read into one, and grids can be drawn from it or traced into it.

#ifndef SF_CONTOUR_H
#define SF_CONTOUR_H

#include <sf/grid.h>
#include <sf/slice.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Farthest that a point may lie from the corner of a lattice, in voxels along x or y. */
#define SF_CONTOUR_REACH_MAX 131072.0

/** What a set of polygons has inside. */
typedef enum sf_contour_fill {
    SF_CONTOUR_NONZERO = 0, /**< what the polygons wind around, as their turns sum up: not 0 */
    SF_CONTOUR_EVEN_ODD = 1 /**< what an odd number of polygons encloses */
} sf_contour_fill;

/**
 * A view of the closed polygons of one layer.
 *
 * Contour i has the points starts[i] to starts[i + 1] - 1, and its last point is joined to its
 * first. Fewer than three points enclose nothing. A first point that is said again at the end does
 * no harm.
 */
typedef struct sf_contours {
    const double *points_mm; /**< x and y of each point; may be NULL where there are none */
    const size_t *starts;    /**< contour_count + 1 numbers that never fall, the first is 0; may be
                                  NULL where there is no contour */
    size_t contour_count;    /**< how many polygons */
} sf_contours;

/** Layers of contours with their heights; it owns its memory. */
typedef struct sf_contour_stack sf_contour_stack;

// ---------------------------------------------------------------------------------------------
// Contours to voxels
// ---------------------------------------------------------------------------------------------

/**
 * Draw contours into a slice: dst is solid where they have it inside, and empty elsewhere.
 *
 * @param dst        the slice, written; of the lattice's nx and ny
 * @param lattice    where voxels lie: nx, ny, pitch and origin are looked at
 * @param contours   the polygons, in the frame of the lattice; what stands out is cut off
 * @param fill       what is inside
 * @param allocator  for 32 bytes a point and 4 a row while it works; NULL for the C library's
 * @param fault      NULL, or filled where a point is refused
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a slice that is none, starts that fall, a point
 * that is not finite, no such fill; what sf_lattice_validate() says; SF_ERR_SHAPE: a slice of
 * another size; SF_ERR_OVERFLOW: a point farther than SF_CONTOUR_REACH_MAX voxels from the
 * lattice's corner, 2^32 - 1 points or more; SF_ERR_MEMORY.
 * @cost one pass, and n log n in the crossings of each row.   @threads any that write to distinct
 * slices; one at a time for each allocator.
 * @source W. J. Bouknight, "A Procedure for Generation of Three-Dimensional Half-Toned Computer
 * Graphics Presentations", 1970 (lists of edges that a row crosses).
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_slice_from_contours(sf_slice dst, const sf_lattice *lattice,
                                                   const sf_contours *contours,
                                                   sf_contour_fill fill,
                                                   const sf_allocator *allocator, sf_fault *fault);

/**
 * Signed area of contours: what turns to the left counts, what turns to the right is taken away.
 *
 * For contours that cross nothing and whose holes turn the other way it is the area inside, under
 * either fill.
 *
 * @param contours  the polygons; NULL has none
 * @return the area in mm2; not a number where starts fall.
 * @cost one pass.   @threads any.
 * @since 0.1
 */
SF_API double sf_contours_area_mm2(const sf_contours *contours);

// ---------------------------------------------------------------------------------------------
// Stacks of contours
// ---------------------------------------------------------------------------------------------

/**
 * Make a stack without layers.
 *
 * @param bottom_mm  height of the lowest layer's underside
 * @param allocator  for the stack; NULL for the C library's
 * @param stack      receives the stack
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a height that is not finite or beyond 1e12;
 * SF_ERR_MEMORY.
 * @cost constant.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_contour_stack_create(double bottom_mm, const sf_allocator *allocator,
                                                    sf_contour_stack **stack);

/**
 * Add a layer on top: it reaches from the top of the one below to `top_mm`.
 *
 * @param stack     the stack
 * @param top_mm    above the stack's top so far
 * @param contours  the polygons, copied
 * @param fault     NULL, or filled where something is refused
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a top that does not rise or is beyond 1e12,
 * starts that fall, a point that is not finite or beyond 1e12; SF_ERR_OVERFLOW: more than
 * SF_LAYER_MAX layers, or sizes that do not fit the machine; SF_ERR_MEMORY.
 * @cost the points.   @threads one per stack.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_contour_stack_add(sf_contour_stack *stack, double top_mm,
                                                 const sf_contours *contours, sf_fault *fault);

/**
 * Trace the border of a slice's voxels and add it as the next layer.
 *
 * Each contour runs along the sides of voxels with matter on its left: around a piece it turns to
 * the left, around a hole to the right. Pieces that meet in a corner only stay apart. Points are
 * where it turns, so drawing the layer again, under either fill, gives the same voxels.
 *
 * @param stack    the stack
 * @param top_mm   above the stack's top so far
 * @param slice    the slice, of the lattice's nx and ny
 * @param lattice  where voxels lie: nx, ny, pitch and origin are looked at
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a slice that is none, a top that does not rise or
 * is beyond 1e12; what sf_lattice_validate() says; SF_ERR_SHAPE: a slice of another size;
 * SF_ERR_OVERFLOW; SF_ERR_MEMORY.
 * @cost a pass over the slice, and the length of the border in voxels; a slice of memory while it
 * works.   @threads one per stack.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_contour_stack_trace(sf_contour_stack *stack, double top_mm,
                                                   sf_slice slice, const sf_lattice *lattice);

/**
 * Number of layers.
 *
 * @param stack  the stack; NULL has none
 * @return the number.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API uint32_t sf_contour_stack_count(const sf_contour_stack *stack);

/**
 * The contours of a layer and its heights.
 *
 * @param stack      the stack
 * @param k          the layer, below sf_contour_stack_count()
 * @param contours   receives a view, good until the stack is changed or destroyed; may be NULL
 * @param bottom_mm  receives the height of its underside; may be NULL
 * @param top_mm     receives the height of its top; may be NULL
 * @return SF_OK; SF_ERR_ARGUMENT: no stack, or no such layer.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_contour_stack_layer(const sf_contour_stack *stack, uint32_t k,
                                                   sf_contours *contours, double *bottom_mm,
                                                   double *top_mm);

/**
 * A lattice that holds all contours of a stack, one layer each.
 *
 * Its corner is the least x, y and z; it ends at the first voxel beyond the greatest. Heights are
 * rounded to nanometres, as sums of decimals need it; where all are the same, one stands for them.
 *
 * @param stack       the stack
 * @param pitch_x_mm  voxel size along x, above 0
 * @param pitch_y_mm  voxel size along y, above 0
 * @param heights_mm  receives a height for each layer; kept by the lattice where they differ
 * @param capacity    places in heights_mm, at least sf_contour_stack_count()
 * @param lattice     receives the lattice
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a pitch that cannot be, a stack without layers or
 * without points; SF_ERR_CAPACITY: too few places; SF_ERR_OVERFLOW: more than SF_EXTENT_MAX voxels
 * along x or y.
 * @cost one pass.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_contour_stack_lattice(const sf_contour_stack *stack,
                                                     double pitch_x_mm, double pitch_y_mm,
                                                     double *heights_mm, size_t capacity,
                                                     sf_lattice *lattice);

/**
 * Draw a stack into a new grid, layer by layer.
 *
 * @param stack      the stack
 * @param lattice    where voxels lie, with as many layers as the stack; heights and z are copied,
 *                   but not compared
 * @param fill       what is inside
 * @param allocator  for the grid, and as in sf_slice_from_contours(); NULL for the C library's
 * @param task       NULL, or progress per layer; a cancel is honoured at every layer
 * @param grid       receives the grid, to be destroyed by the caller
 * @return as sf_slice_from_contours() and sf_grid_create(); SF_ERR_SHAPE: another number of layers;
 * SF_ERR_CANCELLED.
 * @cost sf_slice_from_contours() for each layer.   @threads any that read; one at a time for each
 * allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_from_contours(const sf_contour_stack *stack,
                                                  const sf_lattice *lattice, sf_contour_fill fill,
                                                  const sf_allocator *allocator, sf_task *task,
                                                  sf_grid **grid);

/**
 * Free a stack.
 *
 * @param stack  the stack, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this stack.
 * @since 0.1
 */
SF_API void sf_contour_stack_destroy(sf_contour_stack *stack);

#ifdef __cplusplus
}
#endif

#endif
