// SPDX-License-Identifier: MIT
// Cages: control meshes of cells, or of faces alone, with named properties.
//
// A cage bounds nothing by itself: it is what a smooth shape is made from by subdivision
// (<sf/refine.h>, <sf/limit.h>). Every point has a position and, for each property, a value; both
// are subdivided alike, so that a density or a stiffness is defined, and smooth, at every place of
// the solid. Cells that name values of their own at their corners need not agree with their
// neighbours: there the property jumps, and the shape does not.
//
// A cell is given by its corners alone: 4 are a tetrahedron, 2 n a prism over a polygon of n
// corners (6 a wedge, 8 a hexahedron): first the lower polygon, counter-clockwise seen from above,
// then the upper one in the same order; of a tetrahedron first a face, counter-clockwise seen from
// the fourth corner. These are the cells all of whose corners have three faces, so that one step of
// subdivision leaves nothing but hexahedra. In dimension 2 cells are faces of 3 corners or more,
// counter-clockwise seen from outside.

#ifndef SF_CAGE_H
#define SF_CAGE_H

#include <sf/base.h>
#include <sf/property.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Largest number of corners of a face. */
#define SF_CAGE_POLYGON_MAX 32
/** Largest number of points, and of corners of all cells. */
#define SF_CAGE_POINT_MAX 0x7fffffffu
/** From this sharpness on a crease or a point stays sharp for ever. */
#define SF_SHARP 10.0

/** An edge that is kept sharp for a while: by a whole number of steps, or part of one more. */
typedef struct sf_crease {
    uint32_t points[2]; /**< its ends; in dimension 3 an edge of the boundary */
    double sharpness;   /**< 0: smooth; SF_SHARP and more: for ever */
} sf_crease;

/** A point that is kept sharp: a corner of the surface. */
typedef struct sf_sharp_point {
    uint32_t point;   /**< in dimension 3 one of the boundary */
    double sharpness; /**< as a crease's */
} sf_sharp_point;

/**
 * A cage in somebody's arrays.
 *
 * Refined cages and what is read from files come as this, too. The open edges of a cage of
 * dimension 2 are sharp by themselves; its boundary is cut off square there.
 */
typedef struct sf_cage_view {
    uint32_t dimension;           /**< 3: cells; 2: faces */
    size_t point_count;           /**< at most SF_CAGE_POINT_MAX */
    const double *positions;      /**< x, y, z of each point, mm */
    size_t cell_count;            /**< at least 1 */
    const uint32_t *starts;       /**< cell_count + 1: where the corners of each cell begin */
    const uint32_t *corners;      /**< points */
    size_t crease_count;          /**< edges that are sharp */
    const sf_crease *creases;     /**< each edge once */
    size_t sharp_count;           /**< points that are sharp */
    const sf_sharp_point *sharps; /**< each point once */
    size_t channel_count;         /**< properties */
    const sf_channel *channels;   /**< each UUID and each name once */
} sf_cage_view;

/** A cage that owns its arrays. */
typedef struct sf_cage sf_cage;

/**
 * Make a cage of somebody's arrays, which are copied.
 *
 * Refused is what has no limit: a cell with a point twice, a face of three cells, a boundary that
 * meets itself in an edge or in a point only, cells that lie on the same side of a face they share.
 * Whether cells are inverted is another question: sf_cage_check().
 *
 * @param view       the arrays
 * @param allocator  for the cage and for scratch; NULL for the C library's
 * @param cage       receives the cage
 * @param fault      NULL, or receives a sentence that names the first cell, point, crease or
 *                   property at fault
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a dimension other than 2 or 3, no points or
 * cells, an index out of range, a coordinate that is not finite or beyond 10^12 mm, a value outside
 * its property's bounds, a name or UUID that is empty or there twice, a crease that is no edge,
 * cells that disagree as above; SF_ERR_UNSUPPORTED: a cell of a number of corners that no served
 * cell has, a boundary that meets itself, a crease or sharp point inside of the solid;
 * SF_ERR_OVERFLOW: more points or corners than SF_CAGE_POINT_MAX; SF_ERR_MEMORY.
 * @cost linear, but for collisions in a hash table.   @threads any; one at a time for each
 * allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_create(const sf_cage_view *view, const sf_allocator *allocator,
                                           sf_cage **cage, sf_fault *fault);

/**
 * Free a cage.
 *
 * @param cage  the cage, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this cage.   @since 0.1
 */
SF_API void sf_cage_destroy(sf_cage *cage);

/**
 * View of a cage.
 *
 * @param cage  the cage; NULL gives a view of nothing
 * @return the view, valid until properties are added or removed, or the cage is destroyed; its
 * values are those of the cage as it changes. NULL gives a view of nothing.
 * @cost constant.   @threads any, while nobody changes the cage.   @since 0.1
 */
SF_API sf_cage_view sf_cage_get_view(const sf_cage *cage);

/**
 * Move points.
 *
 * @param cage   the cage
 * @param first  the first point
 * @param count  how many; may be 0
 * @param xyz    3 * count coordinates, mm; not in the cage's own arrays
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, points that there are not, a coordinate that is
 * not finite.
 * @cost O(count).   @threads one for each cage.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_set_positions(sf_cage *cage, size_t first, size_t count,
                                                  const double *xyz);

/**
 * Change values of a property.
 *
 * @param cage     the cage
 * @param channel  which property, below channel_count
 * @param first    the first value
 * @param count    how many; may be 0
 * @param values   the values; not in the cage's own arrays
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, values that there are not, one that is not finite
 * or lies outside the property's bounds.
 * @cost O(count).   @threads one for each cage.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_set_values(sf_cage *cage, size_t channel, size_t first,
                                               size_t count, const double *values);

/**
 * Add a property, as the last channel.
 *
 * @param cage     the cage; on failure it is as it was
 * @param channel  what it is, and its values; they are copied
 * @param fault    NULL, or receives a sentence on failure
 * @return SF_OK; SF_ERR_ARGUMENT: as sf_cage_create(), more than SF_PROPERTY_MAX;
 * SF_ERR_OVERFLOW; SF_ERR_MEMORY.
 * @cost O(values and corners).   @threads one for each cage.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_add_property(sf_cage *cage, const sf_channel *channel,
                                                 sf_fault *fault);

/**
 * Remove a property; those after it move up.
 *
 * @param cage     the cage
 * @param channel  number of the property, counted from 0
 * @return SF_OK; SF_ERR_ARGUMENT: NULL, or there is no such channel.
 * @cost constant.   @threads one for each cage.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_remove_property(sf_cage *cage, size_t channel);

/** What sf_cage_check() counts. */
typedef struct sf_cage_report {
    size_t boundary_faces;   /**< in dimension 3: faces of one cell; in dimension 2: open edges */
    size_t boundary_points;  /**< points on them */
    size_t loose_points;     /**< points that no cell uses; they are left alone */
    size_t components;       /**< parts that share no point */
    size_t inverted_cells;   /**< with a corner where the three edges span no positive volume */
    size_t first_inverted;   /**< the first of them; the number of cells where there is none */
    size_t irregular_points; /**< inside, with other than 8 cells (in dimension 2: 4 faces) */
    size_t irregular_edges;  /**< inside, with other than 4 cells; dimension 3 */
    double volume_mm3;       /**< of the cells themselves; dimension 3 */
} sf_cage_report;

/**
 * Look at a cage: how it hangs together, and whether its cells are the right way out.
 *
 * @param cage       the cage
 * @param allocator  for scratch; NULL for the C library's
 * @param report     receives what was found
 * @param fault      NULL, or receives a sentence that names the first inverted cell, where there is
 * one
 * @return SF_OK, also where cells are inverted; SF_ERR_ARGUMENT: NULL; SF_ERR_OVERFLOW;
 * SF_ERR_MEMORY.
 * @cost linear.   @threads any; one at a time for each allocator.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_check(const sf_cage *cage, const sf_allocator *allocator,
                                          sf_cage_report *report, sf_fault *fault);

#ifdef __cplusplus
}
#endif

#endif
