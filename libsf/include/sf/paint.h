// SPDX-License-Identifier: MIT
// Painting: changing properties and positions of a cage, point by point or by brush.
//
// Two steps, so that they can be mixed: a selection gives each point of the cage a weight from 0 to
// 1, by a brush or by hand; an operation then changes what the weights say. Nothing is refined
// here: who shows the result updates a refinement or a limit of the cage.

#ifndef SF_PAINT_H
#define SF_PAINT_H

#include <sf/base.h>
#include <sf/cage.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How the weight of a brush falls from its middle, with t the distance over the radius. */
typedef enum sf_falloff {
    SF_FALLOFF_CONSTANT = 0, /**< 1 up to the radius */
    SF_FALLOFF_LINEAR = 1,   /**< 1 - t */
    SF_FALLOFF_SMOOTH = 2,   /**< 1 - 3 t^2 + 2 t^3 */
    SF_FALLOFF_GAUSSIAN = 3  /**< (g(t) - g(1)) / (1 - g(1)), g(t) = exp(-9 t^2 / 2): a bell whose
                                  standard deviation is a third of the radius, 0 at the rim */
} sf_falloff;

/** Which points a brush takes. */
typedef enum sf_paint_where {
    SF_PAINT_ALL = 0,     /**< all */
    SF_PAINT_OUTSIDE = 1, /**< those on the boundary */
    SF_PAINT_INSIDE = 2   /**< the others */
} sf_paint_where;

/** A brush: a ball, or what a ball sweeps that is drawn along a line. Make one with
 * sf_paint_brush_default(). */
typedef struct sf_paint_brush {
    size_t struct_size;   /**< sizeof(sf_paint_brush), set by sf_paint_brush_default() */
    double from_mm[3];    /**< where the middle begins, within 10^12; 0, 0, 0 */
    double to_mm[3];      /**< where it ends, within 10^12; 0, 0, 0 */
    double radius_mm;     /**< above 0, and may be infinite: all points; 1 */
    double strength;      /**< weight in the middle, above 0 and at most 1; 1 */
    sf_falloff falloff;   /**< SF_FALLOFF_SMOOTH */
    sf_paint_where where; /**< SF_PAINT_ALL */
} sf_paint_brush;

/**
 * A ball of radius 1 about the origin, smooth.
 *
 * @return the brush, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_paint_brush sf_paint_brush_default(void);

/**
 * Add to a selection what a brush touches: each weight becomes the greater of itself and the
 * brush's.
 *
 * @param cage     the cage
 * @param brush    the brush
 * @param weights  one for each point of the cage, 0 to 1
 * @param touched  NULL, or receives how many points the brush gives a weight above 0
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a brush or weight out of range.
 * @cost O(points).   @threads any, while nobody changes the cage.
 * @source C. Altenhofen and others, "Continuous property gradation for multi-material 3D-printed
 * objects", 2018, "Interaction techniques".
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_paint_select(const sf_cage *cage, const sf_paint_brush *brush,
                                            double *weights, size_t *touched);

/** What is done to a value v of weight w. */
typedef enum sf_paint_operation {
    SF_PAINT_SET = 0,   /**< v + w (amount - v) */
    SF_PAINT_ADD = 1,   /**< v + w amount */
    SF_PAINT_SMOOTH = 2 /**< v + w amount (mean of its neighbours along edges - v), amount 0 to 1 */
} sf_paint_operation;

/**
 * Change values of a property. What would leave the property's bounds stays at them.
 *
 * A value that corners name has the greatest weight of the points where it is named; its neighbours
 * are the values at the other ends of edges, on its own side of a jump.
 *
 * @param cage       the cage; on failure it is as it was
 * @param channel    which property
 * @param weights    one for each point, 0 to 1
 * @param operation  what is done
 * @param amount     by how much
 * @param allocator  for scratch; NULL for the C library's
 * @param changed    NULL, or receives how many values are not what they were
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such property or operation, a weight or amount
 * out of range or not finite; SF_ERR_MEMORY.
 * @cost O(points and edges).   @threads one for each cage.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_paint_values(sf_cage *cage, size_t channel, const double *weights,
                                            sf_paint_operation operation, double amount,
                                            const sf_allocator *allocator, size_t *changed);

/**
 * Move points, each by its weight times a vector.
 *
 * @param cage       the cage; on failure it is as it was
 * @param weights    one for each point, 0 to 1
 * @param vector_mm  the vector
 * @param allocator  for scratch; NULL for the C library's
 * @param changed    NULL, or receives how many points are not where they were
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a weight out of range, a point that would lie
 * beyond 10^12 mm; SF_ERR_MEMORY.
 * @cost O(points).   @threads one for each cage.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_paint_move(sf_cage *cage, const double *weights,
                                          const double vector_mm[3], const sf_allocator *allocator,
                                          size_t *changed);

/**
 * Move points towards the means of their neighbours along edges; those on the boundary towards
 * neighbours on the boundary only, so that an outside does not shrink into its inside.
 *
 * @param cage       the cage; on failure it is as it was
 * @param weights    one for each point, 0 to 1
 * @param amount     how far, 0 to 1
 * @param allocator  for scratch; NULL for the C library's
 * @param changed    NULL, or receives how many points are not where they were
 * @return as sf_paint_move().
 * @cost O(points and edges).   @threads one for each cage.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_paint_smooth(sf_cage *cage, const double *weights, double amount,
                                            const sf_allocator *allocator, size_t *changed);

#ifdef __cplusplus
}
#endif

#endif
