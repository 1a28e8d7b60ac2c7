// SPDX-License-Identifier: MIT
// Grow: the matter that is missing below a shape, as little of it as may be.
//
// A voxel that nothing carries is carried once a path below it is filled: one voxel in each layer,
// each within reach of the one above, down to matter, to the bed, or to a voxel that something else
// holds. A path finder gives the closest such path of one voxel; a path map those of all voxels; a
// brush put along a path gives it body; and sf_grid_grow() does all of a shape at once.
//
// The cost of a path is the number of its voxels, where one that ends on the bed pays for its last
// voxel the distance to the closest matter of the bed slice, in voxels, rounded up (one where that
// slice is empty). So paths stay close to the shape. This is the paper's cost with one change: it
// is zero at matter, and so a path ends at the first matter that it can reach.
//
// Nothing here removes matter. Of the terms' masks, `exempt`, `forbid` and `act` are heeded.

#ifndef SF_GROW_H
#define SF_GROW_H

#include <sf/support.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A voxel of a grid. */
typedef struct sf_voxel {
    uint32_t x, y, z; /**< column, row, layer */
} sf_voxel;

/** What matter a path may end on. */
typedef enum sf_landing {
    SF_LANDING_ANY = 0,  /**< any matter from the bed layer up, as in the paper; under slack, matter
                              that hangs in the air has no reach to spare */
    SF_LANDING_ALIVE = 1 /**< only what is alive under the whole rule; other matter is passed
                              through, a step like any other, and lies in the path */
} sf_landing;

/** What a path ends on. */
typedef enum sf_path_end {
    SF_PATH_END_MATTER = 0, /**< its last voxel rests on matter of the layer below */
    SF_PATH_END_BED = 1,    /**< its last voxel lies on the bed */
    SF_PATH_END_HELD = 2    /**< its last voxel is exempt: it needs nothing below it */
} sf_path_end;

/** What is known of a path beside its voxels. */
typedef struct sf_path {
    size_t count;        /**< voxels of the path: neither the one asked about nor matter below */
    sf_path_end end;     /**< what it ends on */
    sf_voxel landing;    /**< the matter below its last voxel; else its last voxel itself, which is
                              the one asked about where the path is empty */
    uint64_t cost;       /**< as told above */
    uint64_t bed_square; /**< on the bed: squared distance of its last voxel to the closest matter
                              of the bed slice, in voxels; 0 else, and where that slice is empty */
} sf_path;

// ---------------------------------------------------------------------------------------------
// Path finder
// ---------------------------------------------------------------------------------------------

/** Finds closest supporting paths in a grid, one at a time. */
typedef struct sf_path_finder sf_path_finder;

/**
 * Make a path finder for a grid.
 *
 * Where any matter may be landed on and the rule is box3, octagon or disk the finder looks at
 * nothing but the grid as it is when it is asked: changes count at once. Under slack, or for
 * landing on living matter only, it keeps what is alive, and sf_path_finder_refresh() brings that
 * up to date. Bridges carry what stands there, but a path does not count on new ones.
 *
 * @param grid       the shape; it and the masks must outlive the finder
 * @param terms      rule, bed layer and masks, copied. With SF_BED_AUTO the bed is the first layer
 *                   that holds matter now (or at the last refresh), layer 0 in an empty grid
 * @param landing    what matter a path may end on
 * @param allocator  for the finder and what its questions need; NULL for the C library's
 * @param task       NULL, or progress per slice; a cancel is honoured at every slice
 * @param finder     the finder
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such landing, terms without their
 * struct_size, a bed layer that the grid has not, a rule that does not serve all its layers;
 * SF_ERR_SHAPE: a mask of other counts; SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost a search for the bed. Where the finder keeps what is alive, a trim, and a bit for each
 * voxel; under slack another bit, and a byte for each voxel that lives with less than all reach to
 * spare; on layers of one height also some ten bytes for each layer and row of the grid, until a
 * cone fills its slices. At 512^3 and 45 degrees that is 40 MB.
 * @threads any; the grids are only read.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_path_finder_create(const sf_grid *grid, const sf_terms *terms,
                                                  sf_landing landing, const sf_allocator *allocator,
                                                  sf_task *task, sf_path_finder **finder);

/**
 * Free a path finder.
 *
 * @param finder  the finder, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this finder.   @since 0.1
 */
SF_API void sf_path_finder_destroy(sf_path_finder *finder);

/**
 * Bring what a finder keeps up to date with its grid: the bed, what is alive, its reach.
 *
 * @param finder  the finder; as it was when the call fails
 * @param task    NULL, or progress per slice; a cancel is honoured at every slice
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost as sf_path_finder_create().   @threads one per finder.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_path_finder_refresh(sf_path_finder *finder, sf_task *task);

/**
 * The closest supporting path of a voxel, solid or not: what to fill so that it is carried.
 *
 * The path goes from the layer below the voxel downwards, without the voxel itself and without the
 * matter that it lands on. It is empty where the voxel is carried already, lies on the bed or is
 * exempt, below the bed too: what is exempt stands wherever it lies. Among the paths of least cost:
 * matter before a held voxel before the bed; the least distance of the landing from the voxel in
 * the plane (on the bed first the least distance to the matter there), then the least y, then the
 * least x of it. Between voxel and landing the path stays close to the straight line. With a bed
 * slice that is empty it goes straight down if it may.
 *
 * @param finder    the finder
 * @param from      the voxel; whether it may be filled itself is not asked
 * @param path      the voxels, from the top; may be NULL where capacity is 0
 * @param capacity  places in `path`; the layers of the grid are always enough
 * @param found     what is known of the path
 * @return SF_OK; SF_ERR_CAPACITY: too few places, with `found` filled and `path` not written;
 * SF_ERR_INFEASIBLE: there is no path, as for a voxel below the bed layer that is not exempt, or
 * where the masks leave no way; SF_ERR_ARGUMENT: a NULL pointer, a voxel outside the grid;
 * SF_ERR_OVERFLOW; SF_ERR_MEMORY.
 * @cost O(t^3 / 64) word reads where the path is t layers long. Once, and again whenever the bed
 * slice has changed, the first path that ends on the bed asks for a distance transform of that
 * slice. Under slack on layers of different heights O(t^2) bytes are made, and kept until a voxel
 * of another layer is asked about. Where the masks lie in the way O(t^3) bytes, and memory for
 * them.
 * @threads one per finder; the grids are only read.
 * @source T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
 * Eurographics 2016, section 2.2 (grow), by a search of the downward cone in place of a map.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_path_finder_find(sf_path_finder *finder, sf_voxel from,
                                                sf_voxel *path, size_t capacity, sf_path *found);

// ---------------------------------------------------------------------------------------------
// Path map
// ---------------------------------------------------------------------------------------------

/** Costs and directions of the closest supporting paths of all voxels of a grid. */
typedef struct sf_path_map sf_path_map;

/** What a path costs. */
typedef enum sf_path_cost {
    SF_PATH_COST_COUNT = 0, /**< voxels, and on the bed the distance to its matter: as told above */
    SF_PATH_COST_NEARNESS = 1 /**< for each voxel the distance to the closest matter of its slice,
                                   in voxels, rounded up, and one where the slice is empty: the
                                   paper's first cost, which it found too dear */
} sf_path_cost;

/** How a path map is made. Fill with sf_path_map_options_default(). */
typedef struct sf_path_map_options {
    size_t struct_size; /**< sizeof(sf_path_map_options), set by the default */
    sf_landing landing; /**< any matter by default */
    sf_path_cost cost;  /**< SF_PATH_COST_COUNT by default */
} sf_path_map_options;

/**
 * Options of a path map: any matter may be landed on, the cost is the number of voxels.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_path_map_options sf_path_map_options_default(void);

/**
 * Make a path map: for many questions to a grid that does not change.
 *
 * Where no step reaches farther than a voxel (box3, octagon up to that reach), the cost is
 * SF_PATH_COST_COUNT and stays below 4095, the map is half a byte for each voxel: a direction. Else
 * it is four bytes, a cost, and directions are found while walking.
 *
 * @param grid       the shape; it and the masks must outlive the map and must not change
 * @param terms      rule, bed layer and masks, copied; bridges as in sf_path_finder_create()
 * @param options    the options
 * @param allocator  for the map; NULL for the C library's
 * @param task       NULL, or progress per slice; a cancel is honoured at every slice
 * @param map        the map
 * @return as sf_path_finder_create(); SF_ERR_ARGUMENT also: options without their struct_size or
 * with values that are none; SF_ERR_UNSUPPORTED: a slack rule, under which a cost is not a voxel's
 * alone.
 * @cost for half a byte a voxel about a nanosecond for four voxels; else voxels times those of the
 * element, and a distance transform of each slice for SF_PATH_COST_NEARNESS.
 * @threads any; the grids are only read.
 * @source T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
 * Eurographics 2016, sections 2.2 and 3.2, with costs that are zero at matter.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_path_map_create(const sf_grid *grid, const sf_terms *terms,
                                               const sf_path_map_options *options,
                                               const sf_allocator *allocator, sf_task *task,
                                               sf_path_map **map);

/**
 * Free a path map.
 *
 * @param map  the map, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this map.   @since 0.1
 */
SF_API void sf_path_map_destroy(sf_path_map *map);

/**
 * The path of a voxel by the map: one of the least cost.
 *
 * Each step goes to a voxel of least cost; among these to the closest in the plane, then to the
 * least y, then to the least x. So the path costs what sf_path_finder_find() finds, but need not
 * be the same.
 *
 * @param map       the map
 * @param from      as in sf_path_finder_find()
 * @param path      as in sf_path_finder_find()
 * @param capacity  as in sf_path_finder_find()
 * @param found     what is known of the path
 * @return as sf_path_finder_find(), but for memory, which is not needed.
 * @cost the length of the path; on a map of costs times the voxels of the element.
 * @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_path_map_walk(const sf_path_map *map, sf_voxel from, sf_voxel *path,
                                             size_t capacity, sf_path *found);

// ---------------------------------------------------------------------------------------------
// Brush along a path
// ---------------------------------------------------------------------------------------------

/** A brush, and where it goes. */
typedef struct sf_stroke {
    const sf_grid *brush; /**< a shape of any size, smaller than the grid or not */
    sf_voxel anchor;      /**< its voxel that comes to lie on each voxel of the path */
    const sf_voxel *path; /**< voxels, one for each layer, from the top, as a finder gives them */
    size_t count;         /**< number of voxels; 0 adds nothing */
} sf_stroke;

/** Counts of sf_grid_emit(). */
typedef struct sf_emit_report {
    uint64_t added_voxels;   /**< voxels that became solid */
    uint64_t trimmed_voxels; /**< voxels of the brush that were left out because nothing carries
                                  them; those outside the grid or the masks do not count */
} sf_emit_report;

/**
 * Put a brush on every voxel of a path, and leave out of it what would hang in the air.
 *
 * What was solid stays, whatever carries it. What is added is carried, by what was there or by what
 * is added; so the result is support-free if the shape was. The path itself is always added, with
 * or without the brush's anchor.
 *
 * @param grid       the shape, changed in place
 * @param terms      rule, bed layer and masks; nothing is added outside `act` or within `forbid`,
 *                   nor below the bed
 * @param stroke     brush and path
 * @param allocator  for working memory: the layers that the brush meets; NULL for the C library's
 * @param report     counts, or NULL
 * @return SF_OK; SF_ERR_INFEASIBLE: a voxel of the path may not be added, or would hang in the air;
 * SF_ERR_ARGUMENT: a NULL pointer, an anchor outside the brush, a path outside the grid, terms as
 * in sf_path_finder_create(), a brush or a mask that is the grid; SF_ERR_SHAPE: a mask of other
 * counts; SF_ERR_OVERFLOW; SF_ERR_MEMORY. Only SF_OK changes the grid.
 * @cost the brush's rows for each voxel of the path, and a trim of the layers it meets; under slack
 * of all layers up to there.
 * @threads one per grid.
 * @source T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
 * Eurographics 2016, section 2.2 (grow); that what is added must be trimmed is the library's own.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_emit(sf_grid *grid, const sf_terms *terms,
                                         const sf_stroke *stroke, const sf_allocator *allocator,
                                         sf_emit_report *report);

// ---------------------------------------------------------------------------------------------
// Whole grid
// ---------------------------------------------------------------------------------------------

/** Counts of sf_grid_grow(). */
typedef struct sf_grow_report {
    uint64_t kept_voxels;  /**< solid voxels before, all of which are left */
    uint64_t added_voxels; /**< voxels that became solid */
    uint32_t bed_layer;    /**< the bed layer; SF_BED_AUTO when the grid holds no matter */
} sf_grow_report;

/**
 * Add what a shape lacks to be support-free, in place; nothing is removed.
 *
 * From the top down: in each layer the voxels that nothing carries are given supporters below,
 * those from which the way to matter or to the bed is shortest, and among these those that carry
 * most; no supporter is kept without which all would be carried. What is added is little, but not
 * the least there is: that is a hard problem even in one layer. Exempt voxels need no support, and
 * what bridges keep alive needs none. The result is checked under the whole rule before the grid is
 * written.
 *
 * @param grid       the shape, changed in place
 * @param terms      rule, bed layer and masks
 * @param allocator  for working memory: two grids and two bytes for each voxel, under slack up to
 *                   four; NULL for the C library's
 * @param task       NULL, or progress per slice; a cancel is honoured at every slice
 * @param culprits   NULL, or a grid that is set, on SF_ERR_INFEASIBLE, to the voxels of the shape
 *                   that cannot be carried whatever may be added
 * @param report     counts, or NULL
 * @return SF_OK; SF_ERR_INFEASIBLE: some voxels cannot be carried, and the shape is as it was;
 * SF_ERR_ARGUMENT: a NULL pointer, a mask or culprits that are the grid, terms as in
 * sf_grid_feasible(); SF_ERR_SHAPE: grids that differ in counts; SF_ERR_OVERFLOW; SF_ERR_MEMORY;
 * SF_ERR_CANCELLED; SF_ERR_INTERNAL: the result failed its check.
 * @cost a map of costs (voxels times those of the element), and for each voxel without support and
 * for each one added the voxels of the element.
 * @threads one per grid.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_grow(sf_grid *grid, const sf_terms *terms,
                                         const sf_allocator *allocator, sf_task *task,
                                         sf_grid *culprits, sf_grow_report *report);

#ifdef __cplusplus
}
#endif

#endif
