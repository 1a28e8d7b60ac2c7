// SPDX-License-Identifier: MIT
// Carving: matter taken out of the inside of a solid, so that it is lighter, and stands.
//
// A solid, the wall that must stay around its inside, and what comes out between the two:
//
//     wall within result within solid
//
// How much comes out, and where, is decided by where the centre of mass may lie (the half-spaces of
// stances, <sf/stance.h>); without stances as much as is allowed. What has no way out of a cavity
// gets one by a drain. Which voxels are the wall is a matter of exact distances: no voxel that may
// be carved has a point nearer to the surface than the wall is thick.
//
// Everything lives in the frame of the lattice; the build direction is its z.

#ifndef SF_CARVE_H
#define SF_CARVE_H

#include <sf/stance.h>
#include <sf/support.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Walls
// ---------------------------------------------------------------------------------------------

/**
 * The wall of a solid: its voxels of which any point is nearer than a thickness to a surface.
 *
 * Voxels are boxes, and the distance of a box to a triangle is exact but for rounding: a voxel of
 * the solid that is not wall has no point nearer than wall_mm, less one part in 2^40 of the largest
 * coordinate. So much is forgiven, so that walls are whole voxels where the surface lies along the
 * lattice. Of a surface that is not closed only its triangles count: unite this wall with that of
 * sf_grid_wall_inside(). Triangles inside of the solid, where shells run through each other, have a
 * wall around them as well.
 *
 * @param solid      the solid
 * @param surface    its surface; it may reach beyond the lattice
 * @param wall_mm    thickness; 0 gives no wall
 * @param allocator  for working memory: two grids, 48 slices, and 100 bytes a triangle; NULL for
 *                   the C library's
 * @param task       NULL, or progress, cancel and threads; the result is the same bytes with any
 * @param wall       of the solid's counts, and not the solid: set to the wall
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, one grid given twice, a thickness that is
 * negative or not finite; what sf_mesh_bounds() says; SF_ERR_SHAPE: grids that differ in counts;
 * SF_ERR_OVERFLOW: a coordinate beyond 1e12 mm, a surface around a lattice that is as large as can
 * be; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost sorts the triangles; some reach * reach passes over bits, with the reach of the wall in
 * voxels; and for about one layer of voxels each the triangles that lie just so far.
 * @threads any that write distinct walls; the task's hook may run up to 16 pieces at once; one at a
 * time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_wall(const sf_grid *solid, sf_mesh_view surface, double wall_mm,
                                         const sf_allocator *allocator, sf_task *task,
                                         sf_grid *wall);

/**
 * The wall of a solid without a mesh: its voxels that are nearer than a thickness to what is not
 * solid, the outside of the grid included.
 *
 * The distance is the gap between two boxes, less the same that sf_grid_wall() forgives.
 *
 * @param solid      the solid
 * @param wall_mm    thickness; 0 gives no wall
 * @param allocator  for working memory: a grid and two slices; NULL for the C library's
 * @param task       NULL, or progress per slice; a cancel is honoured at every slice
 * @param wall       of the solid's counts, and not the solid: set to the wall
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, one grid given twice, a thickness that is
 * negative or not finite; SF_ERR_SHAPE: grids that differ in counts; SF_ERR_UNSUPPORTED: a wall of
 * more than 253 voxels along x or y; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost reach * reach passes over bits, with the reach of the wall in voxels.
 * @threads any that write distinct walls.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_wall_inside(const sf_grid *solid, double wall_mm,
                                                const sf_allocator *allocator, sf_task *task,
                                                sf_grid *wall);

/**
 * How near the voxels of a grid come to a surface: of a cavity, how thick the wall around it is.
 *
 * The least distance of any point of a solid voxel, as a box, to any point of a triangle; exact but
 * for rounding, and 0 where a triangle comes within 2^-20 of a voxel or so.
 *
 * @param grid       the voxels
 * @param surface    the triangles; they may reach beyond the lattice
 * @param allocator  for working memory: a grid and 100 bytes a triangle; NULL for the C library's
 * @param task       NULL, or progress, cancel and threads; the result is the same bytes with any
 * @param least_mm   receives the distance; infinite where nothing is solid
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; what sf_mesh_bounds() says; SF_ERR_OVERFLOW: as
 * sf_grid_wall(); SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost sorts the triangles; and for each voxel at the border of what is solid the triangles that
 * lie as near as the nearest.
 * @threads any; the task's hook may run up to 16 pieces at once; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_clearance(const sf_grid *grid, sf_mesh_view surface,
                                              const sf_allocator *allocator, sf_task *task,
                                              double *least_mm);

// ---------------------------------------------------------------------------------------------
// Carving
// ---------------------------------------------------------------------------------------------

/** How a solid is carved. */
typedef enum sf_carve_mode {
    SF_CARVE_SUPPORT_FREE = 0, /**< the result prints without supports where the solid did */
    SF_CARVE_PLANE = 1         /**< the paper's: in the order of the distance to a plane, for
                                    powder beds and for comparison. Ceilings may hang */
} sf_carve_mode;

/** When there is enough carved. */
typedef enum sf_carve_goal {
    SF_CARVE_ENOUGH = 0,  /**< as much matter stays as can while every half-space holds; where they
                               cannot all hold, as SF_CARVE_NEAREST; support-free: _DEEPEST */
    SF_CARVE_NEAREST = 1, /**< the paper's: least distance to the targets, each of them the place of
                               the safe region that is nearest to the centre of mass. Support-free:
                               as SF_CARVE_ENOUGH */
    SF_CARVE_DEEPEST = 2, /**< largest least slack: as far inside all half-spaces as can be */
    SF_CARVE_LIGHTEST = 3 /**< support-free: as little matter stays as can while every half-space
                               holds; where they cannot all hold, as SF_CARVE_DEEPEST */
} sf_carve_goal;

/** How to carve. Fill with sf_carve_options_default(). */
typedef struct sf_carve_options {
    size_t struct_size;   /**< sizeof(sf_carve_options), set by the default */
    sf_carve_mode mode;   /**< SF_CARVE_SUPPORT_FREE by default */
    sf_carve_goal goal;   /**< SF_CARVE_ENOUGH by default; without stances not looked at */
    const float *density; /**< what 1 mm3 of each voxel weighs, above 0, in (layer, y, x) order;
                               NULL (default): 1. What is not solid is not looked at */
    sf_body rest;         /**< what else the part weighs: ballast, and the mesh less its voxels */
    const sf_stance *const *stances; /**< where the centre of mass may lie: in all of them */
    size_t stance_count;             /**< 0 (default): as much is carved as is allowed */
    uint32_t strut_width_vx; /**< support-free: struts are squares of that many voxels where there
                                  is room, 1 to SF_REACH_MAX; 2 by default */
    uint32_t rounds_max;     /**< plane: most rounds, each with a plane of its own; 64 by default */
} sf_carve_options;

/**
 * Options of carving: support-free, as little as is enough, density 1, no stances, struts two
 * voxels wide.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_carve_options sf_carve_options_default(void);

/** What carving did. Bodies hold `rest`; slacks and distances are over all stances. */
typedef struct sf_carve_report {
    uint64_t solid_voxels;     /**< of the solid */
    uint64_t wall_voxels;      /**< of the wall */
    uint64_t removed_voxels;   /**< carved out */
    uint64_t kept_voxels;      /**< neither wall nor carved: what is left inside */
    double removed_mm3;        /**< their volume */
    sf_body before;            /**< body of the solid */
    sf_body after;             /**< body of the result */
    double slack_before_mm;    /**< least over all half-spaces of how far inside it the centre of
                                    mass lies; negative: outside. 0 without stances */
    double slack_mm;           /**< the same of the result */
    double distance_before_mm; /**< root of the sum, over stances, of the squared distance from the
                                   centre of mass to the safe region, across the stance's up */
    double distance_mm;        /**< the same of the result */
    uint32_t rounds;           /**< plane: rounds that took something away */
    uint64_t floating_pieces; /**< pieces of the result, connected by faces, edges and corners, that
                                   hold no voxel of the wall; 0 where there is no wall */
    uint64_t floating_voxels; /**< and their voxels */
    int safe;                 /**< 1 when every half-space holds, as it does without stances */
} sf_carve_report;

/**
 * Carve a solid: result holds the wall, lies within the solid, and weighs as the stances need.
 *
 * Support-free: what is supported in the solid, exempt voxels included, is supported in the result,
 * under the whole rule; what hangs in the solid may hang on, and counts as exempt. Struts of
 * strut_width_vx stand under what the wall does not carry itself; single voxels where no square
 * fits, and all of them where under slack a step reaches less than a voxel along x or y. Without
 * stances as little stays as is found. With stances, by the goal: the result is close to the best
 * that any carving can do, and what it misses is the price of the struts (docs/balance.md has
 * figures). Where the wall is closed around the inside, no piece floats.
 *
 * Plane, after the paper: with c the centre of mass and, for each stance with up u, c* the place
 * nearest to it among those that are safe at its height, voxels that are not wall are sorted by
 * d = sum over stances of max(0, (r - c*) . (c - c*)), taken across u; those with d above 0 are
 * removed one by one from the largest d on, of equal ones the lowest layer, row and x first (d is
 * told apart to one part in 2^32 of the largest), the energy, which is the sum of the squared
 * distances to the c*, is followed through all of them, and the best prefix is kept. This is done
 * again with the new c until every half-space holds (ENOUGH), or a round removes less than a
 * thousandth of what could be, or does not improve. With SF_CARVE_ENOUGH the best prefix is the
 * first in which every half-space holds; with SF_CARVE_DEEPEST it has the largest slack, and c* is
 * the place of largest slack. Where nothing is safe at that height, c* is the place of largest
 * slack as well. Without stances this mode carves nothing.
 *
 * The order leaves no floating pieces around one plane in a solid with a wall all around; several
 * rounds or stances may, so they are looked for.
 *
 * @param solid      the solid
 * @param wall       what must stay, within the solid; see sf_grid_wall()
 * @param terms      support-free: rule, bed layer and exempt voxels; `keep` stays too, and nothing
 *                   outside `act` is removed. NULL in mode plane, which looks at no terms
 * @param options    NULL for the default
 * @param allocator  for working memory: NULL for the C library's. Plane: a grid, and 24 bytes for
 *                   each voxel that may be carved. Support-free: a dozen grids, and 25 bytes for
 *                   each voxel of the solid
 * @param task       NULL, or progress; a cancel is honoured at least at every layer or round
 * @param result     of the solid's counts, another grid than all others
 * @param report     what was done; may be NULL
 * @return SF_OK, be it safe or not; SF_ERR_ARGUMENT: a NULL pointer, options without their
 * struct_size or with values outside their range, a density of a solid voxel that is not above 0 or
 * not finite, a body without mass, no terms in mode support-free or terms that do not serve the
 * solid, one grid given twice; SF_ERR_SHAPE: grids that differ in counts; SF_ERR_INFEASIBLE: the
 * wall is not within the solid; SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED;
 * SF_ERR_INTERNAL: the result failed its check.
 * @cost plane: for each round a sort in linear time, and a step for each voxel and half-space.
 * Support-free: some 20 sweeps over the solid's voxels without stances, and two more for each of
 * some 10 to 60 questions with them: 82,500 voxels in 0.1 s, 808,000 in half a second.
 * @threads any that write distinct results.
 * @source R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing Shapes
 * for 3D Fabrication", SIGGRAPH 2013, section 4 and equations 7 and 8.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_carve(const sf_grid *solid, const sf_grid *wall,
                                          const sf_terms *terms, const sf_carve_options *options,
                                          const sf_allocator *allocator, sf_task *task,
                                          sf_grid *result, sf_carve_report *report);

// ---------------------------------------------------------------------------------------------
// Drain holes
// ---------------------------------------------------------------------------------------------

/** One hole: a shaft from a void down to the open. */
typedef struct sf_drain {
    double from_mm[3];    /**< middle of its upper end, in the void */
    double to_mm[3];      /**< middle of its lower end; straight below where it could be */
    uint64_t voxels;      /**< solid voxels that were drilled out */
    sf_body body;         /**< what they weighed */
    uint64_t void_voxels; /**< of the void that it was drilled for */
} sf_drain;

/** How holes are drilled. Fill with sf_drain_options_default(), and set the diameter. */
typedef struct sf_drain_options {
    size_t struct_size; /**< sizeof(sf_drain_options), set by the default */
    double diameter_mm; /**< a round rod of that diameter passes; above 0 */
    uint32_t count;     /**< holes for each void, far from each other; 1 by default */
    uint64_t void_min;  /**< voids of fewer voxels get none; 0 by default */
    int fill; /**< 1: a void that no hole fits into, or of fewer voxels than void_min, is filled
                   where that leaves all of it supported and the terms let matter be added;
                   0 (default): it stays as it is */
    const float *density; /**< of each voxel, as in sf_carve_options; NULL (default): 1 */
    sf_body body;         /**< what the whole part weighs; looked at where there are stances */
    const sf_stance *const *stances; /**< whose balance is to change least */
    size_t stance_count;             /**< 0 (default): holes are as short as can be */
    sf_drain *drains;                /**< the caller's array, or NULL for counts only (default) */
    size_t drain_capacity;           /**< places in it */
} sf_drain_options;

/**
 * Options of drains: no diameter yet, a hole for each void, no stances, counts only.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_drain_options sf_drain_options_default(void);

/** What became of the voids. */
typedef struct sf_drain_report {
    uint64_t void_count;     /**< voids that were closed */
    uint64_t void_voxels;    /**< and their voxels */
    uint64_t drained_count;  /**< of these, voids that are open now */
    uint64_t filled_count;   /**< voids that were filled */
    uint64_t filled_voxels;  /**< and their voxels */
    uint64_t closed_count;   /**< voids that are closed still: no hole fits and they are not filled,
                                  or none may be drilled. sf_grid_voids() with an open bed names
                                  them */
    uint64_t closed_voxels;  /**< and their voxels */
    uint64_t drain_count;    /**< holes */
    uint64_t drains_dropped; /**< holes without a place in the array */
    uint64_t removed_voxels; /**< voxels of all holes */
    sf_body removed;         /**< what they weighed */
} sf_drain_report;

/**
 * Drill a hole into every void that is closed, in place: what is in it can leave.
 *
 * A void is closed when its empty voxels, connected through faces, touch no side of the grid, nor
 * its top or bottom: the bed is open once the part is off it. Its holes start where a disk of the
 * diameter fits into it, and go straight down until all of the disk is in the open, the holes of
 * other voids included; voids that they pass through are open then too. Where none may be drilled
 * straight, holes go down aslant, in eight directions, as flat as the rule lets ceilings be. Of all
 * places the one is taken whose volume, times its distance from the centre of mass across up where
 * there are stances (the largest of them), is least.
 *
 * With terms no hole is drilled that leaves anything unsupported that was supported before it,
 * exempt voxels included, that takes a voxel of `keep`, or one outside `act`; and no void is filled
 * that reaches into `forbid`, or out of `act`. Where no place will do, a hole may take with it what
 * would hang around its lower end, as long as that is no more than a quarter of the hole.
 *
 * @param grid       the part, changed in place
 * @param terms      rule, bed layer and masks; NULL: nothing needs support
 * @param options    diameter, count, stances
 * @param allocator  for working memory: four grids, the runs of what is empty, and 24 bytes for
 *                   each voxel of a void's surface; NULL for the C library's
 * @param task       NULL, or progress per void; a cancel is honoured before each try
 * @param report     counts; may be NULL
 * @return SF_OK, be all voids open or not; SF_ERR_ARGUMENT: a NULL pointer, options without their
 * struct_size, a diameter that is not above 0 or not finite, a count of 0, a capacity without an
 * array, a density of a drilled voxel or a body that is not finite, stances and a body without
 * mass, terms that do not serve the grid, or name it; SF_ERR_SHAPE: masks of other counts;
 * SF_ERR_UNSUPPORTED: a diameter of more than 500 voxels; SF_ERR_OVERFLOW; SF_ERR_MEMORY;
 * SF_ERR_CANCELLED.
 * @cost for each hole, and each place that was tried in vain, at most 64 for a void, a trim.
 * @threads one per grid.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_drain(sf_grid *grid, const sf_terms *terms,
                                          const sf_drain_options *options,
                                          const sf_allocator *allocator, sf_task *task,
                                          sf_drain_report *report);

#ifdef __cplusplus
}
#endif

#endif
