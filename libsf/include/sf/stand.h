// SPDX-License-Identifier: MIT
// Make it stand: carve the inside of a shape and bend its outside until it rests as it is meant to.
//
// A shape falls because its weight lies in the wrong place. Some of the weight can go: the inside
// is carved, but for a wall. Where that is not enough the shape is bent, by a few handles and as
// little as will do; then it is carved again, because another shape has another inside. Both aim at
// the same half-spaces, those of its stances (<sf/stance.h>), so that several stances at once,
// standing, hanging and rocking, are one job. What is returned always comes from a carving of the
// shape as it is: wall, cavity and margin are those of the last round, and not of an earlier shape.
//
// The build direction is z: turn the mesh first where it is another. Gravity is each stance's own.

#ifndef SF_STAND_H
#define SF_STAND_H

#include <sf/carve.h>
#include <sf/handles.h>
#include <sf/stance.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How handles are moved. */
typedef enum sf_stand_solver {
    SF_STAND_PROGRAMS = 0, /**< quadratic programs, with the safe set as constraint */
    SF_STAND_DESCENT = 1   /**< the paper's gradient descent on a weighed sum; for comparison */
} sf_stand_solver;

/** What matter weighs at a place of the shape as it was before bending: 1 is the part's own; above
    0, and finite as a float. Asked once a round for each voxel. */
typedef double (*sf_density_field)(void *user, const double p_mm[3]);

/** Whether what is at a place of the shape as it was before bending must stay: 1, or 0 where it may
    be carved away. Asked once a round for each voxel. */
typedef int (*sf_keep_field)(void *user, const double p_mm[3]);

/** How a shape is made to stand. Fill with sf_stand_options_default(). */
typedef struct sf_stand_options {
    size_t struct_size; /**< sizeof(sf_stand_options), set by the default */
    double pitch_mm;    /**< voxels are cubes of this edge; 0 (default): a sixty-fourth of the
                             longest side */
    double wall_mm;     /**< how thick the wall must be everywhere; 0 (default): a hundredth of the
                             longest side */
    int carve;          /**< 1 (default): the inside is carved; 0: it stays solid */
    int deform;         /**< 1 (default): the outside is bent where carving is not enough */
    sf_carve_mode carve_mode; /**< support-free by default */
    uint32_t strut_width_vx;  /**< support-free: width of what is left standing inside; 2 */
    sf_rule_kind rule;        /**< support-free: what may rest on what; octagon */
    double angle_rad;         /**< and how far it may hang over; 45 degrees */
    sf_stand_solver solver;   /**< quadratic programs by default */
    double mu;                /**< descent: what the shape weighs in the sum at first; 0.5; 0..1 */
    double weight_details;    /**< what lost details cost; 1; at least 0, as are all three */
    double weight_shifts;     /**< what moved matter costs; 0.3 */
    double weight_scales;     /**< what changed sizes cost; 0.05 */
    double scale_low;         /**< handles scale by no less; 0.7; more than 0, at most 1 */
    double scale_high;        /**< and by no more; 1.4; at least 1 */
    double shift_max_mm;      /**< handles move no farther along x, y or z, but by hand or by
                                   descent; 0 (default): half the longest side */
    int turn;                 /**< 1: handles may turn as well; 0 by default, as in the paper */
    double clearance_mm;      /**< how far above the ground all must stay that does not stand on it;
                                   0 (default): a hundredth of the longest side */
    double reserve_rad;       /**< bending aims at so much more than the stances ask for, because
                                   the carving after it is another; a tenth of a degree */
    uint32_t rounds_max;      /**< most rounds; 0 (default): 40, or 400 of descent, a step each */
    const sf_ballast *ballast; /**< masses that sit in the shape, where they are before bending;
                                    copied; may be NULL where there are none */
    size_t ballast_count;      /**< how many; 0 by default */
    sf_density_field density;  /**< NULL (default): 1 everywhere */
    void *density_user;        /**< handed to it; may be NULL */
    sf_keep_field keep; /**< what is never carved, beside the wall; NULL (default): nothing */
    void *keep_user;    /**< handed to it; may be NULL */
} sf_stand_options;

/**
 * Options of standing, each at its default.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_stand_options sf_stand_options_default(void);

/** A shape on its way to standing. */
typedef struct sf_stand sf_stand;

/** How far a shape has come. Angles are the least over all stances. */
typedef struct sf_stand_report {
    uint32_t rounds;          /**< rounds so far */
    uint32_t steps;           /**< steps of the solver so far */
    int ended;                /**< 1: another round would change nothing */
    int stands;               /**< 1: in every stance it rests by itself, but maybe not safely */
    int safe;                 /**< 1: every stance has the margin that it asks for */
    int succeeded;            /**< 1: it is safe, and bending has neither folded it over nor sunk it
                                   into the ground by more than a ten-thousandth of its size */
    double margin_rad;        /**< the margin, as sf_stance_judge() gives it: the least */
    double margin_before_rad; /**< of the solid as it was given, densities included */
    double bound_rad;         /**< standing alone: no carving of the shape as it was given has a
                                   better margin, were voxels carved by any fraction, support-free
                                   or not; 90 degrees where nothing was carved, where handles were
                                   posed before the first round, and where carving could bring the
                                   centre of mass to the ground, off a table's edge */
    double com_mm[3];         /**< centre of mass of the shape as it is */
    double com_before_mm[3];  /**< and as it was given */
    double mass;              /**< density times volume in mm3 */
    double carved_mm3;        /**< volume of the cavity */
    double energy;            /**< what bending costs */
    double displacement_mm;   /**< how far the vertex that moved most was bent, from where it was
                                   with its feet flat */
    double least_det;         /**< least factor by which bending changes volume, anywhere: not above
                                   0 the shape is folded over */
    uint64_t folded;          /**< places where it is */
    uint64_t overlap_voxels;  /**< voxels that the shape fills twice: it runs into itself */
    double sunk_mm;           /**< how far the lowest vertex that does not stand is too low */
    uint64_t hanging_voxels;  /**< voxels of the carved shape that nothing supports and that were
                                   supported in the solid: 0 but for the paper's carving */
} sf_stand_report;

/**
 * Prepare a shape: voxels, weights of handles, the energy of bending.
 *
 * Contacts of the stances are put onto the ground (sf_stance_flatten()), and the cells that they
 * lie in, with the point that it hangs from, are a handle of their own that holds still.
 *
 * @param mesh          the surface, closed and oriented outwards, in mm, with z the build direction
 * @param stances       what it is to rest on: each with its own up and contacts
 * @param stance_count  how many, 1..32
 * @param handles       what bends it, in the mesh's frame, points or balls; those that are locked
 *                      keep their pose
 * @param handle_count  how many; 0 where it is not to be bent, and at most SF_HANDLE_MAX - 1
 * @param options       NULL for the default
 * @param allocator     for all memory: the mesh twice, 8 bytes a vertex and handle, three grids,
 * the weights, and with densities 4 bytes a voxel; NULL for the C library's
 * @param task          NULL, or progress, cancel and threads
 * @param stand         receives the shape
 * @param fault         NULL, or receives a sentence on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options out of range or without their
 * struct_size, a number of stances or handles out of range, what sf_mesh_validate() and
 * sf_stance_create() refuse, a base among the handles, a density that is not above 0 or not finite;
 * SF_ERR_UNSUPPORTED: a mesh that is open or
 * inside out, a rule that does not serve; SF_ERR_INFEASIBLE: a handle outside the shape, or two
 * that touch, also the one that holds still; SF_ERR_OVERFLOW: a coordinate beyond 1e12, more voxels
 * along an axis than a lattice has; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost weights, and 0.2 s for the energy of 172 000 triangles and six handles.
 * @threads any; one at a time for each allocator.
 * @source R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing Shapes
 * for 3D Fabrication", SIGGRAPH 2013.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_stand_create(sf_mesh_view mesh, const sf_stance_options *stances,
                                            size_t stance_count, const sf_handle *handles,
                                            size_t handle_count, const sf_stand_options *options,
                                            const sf_allocator *allocator, sf_task *task,
                                            sf_stand **stand, sf_fault *fault);

/**
 * Free a shape.
 *
 * @param stand  the shape, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this shape.   @since 0.1
 */
SF_API void sf_stand_destroy(sf_stand *stand);

/**
 * One round: bend, then carve the shape as it is then. The first only carves.
 *
 * @param stand   the shape; on failure it is as it was
 * @param task    NULL, or progress, cancel and threads; the result is the same bytes with any
 * @param report  NULL, or receives how far it has come
 * @return SF_OK, be it standing or not; SF_ERR_ARGUMENT: NULL, a density that is not above 0 or not
 * finite, poses by hand that leave a shape without mass; SF_ERR_OVERFLOW: poses that make it too
 * large for its voxels; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost voxels, the exact wall, a carving and a few steps of the solver: some 0.2 s at 172 000
 * triangles and 80 000 voxels with the paper's carving.   @threads one for each shape.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_stand_round(sf_stand *stand, sf_task *task, sf_stand_report *report);

/**
 * Rounds until the shape is safe and bent no more than it must be, or nothing improves.
 *
 * @param stand   the shape; on failure it is as the last whole round left it
 * @param task    NULL, or progress, cancel and threads
 * @param report  NULL, or receives how far it came: `succeeded` says whether it does what was asked
 * @return as sf_stand_round().
 * @cost rounds_max rounds at most.   @threads one for each shape.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_stand_run(sf_stand *stand, sf_task *task, sf_stand_report *report);

/**
 * How far a shape has come.
 *
 * @param stand  the shape; NULL gives a report of zeros
 * @return the report, by value; all zero for NULL.
 * @cost constant.   @threads any, while no round runs.   @since 0.1
 */
SF_API sf_stand_report sf_stand_describe(const sf_stand *stand);

/**
 * Pose a handle by hand: the next round starts from it, and the count of rounds anew.
 *
 * @param stand   the shape
 * @param handle  which of those handed in
 * @param pose    what becomes of it; its numbers finite, its scale above 0
 * @param lock    1: it keeps this pose; 0: it may be moved on
 * @return SF_OK; SF_ERR_ARGUMENT.
 * @cost constant.   @threads one for each shape.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_stand_set_pose(sf_stand *stand, size_t handle, const sf_pose *pose,
                                              int lock);

/**
 * Pose of a handle.
 *
 * @param stand   the shape; NULL has no handles
 * @param handle  which of those handed in
 * @return the pose, by value; the identity for a handle that there is not.
 * @cost constant.   @threads any, while no round runs.   @since 0.1
 */
SF_API sf_pose sf_stand_get_pose(const sf_stand *stand, size_t handle);

/**
 * The outside: the triangles of the mesh that was handed in, with its vertices where they are now.
 *
 * @param stand  the shape; NULL gives a view of nothing
 * @return the view, valid until the next round; one of nothing for NULL.
 * @cost constant.   @threads any, while no round runs.   @since 0.1
 */
SF_API sf_mesh_view sf_stand_outer(const sf_stand *stand);

/**
 * The cavity: closed surfaces whose triangles look into the hollow; none before the first round.
 *
 * @param stand  the shape; NULL gives a view of nothing
 * @return the view, valid until the next round; one of nothing for NULL.
 * @cost constant.   @threads any, while no round runs.   @since 0.1
 */
SF_API sf_mesh_view sf_stand_cavity(const sf_stand *stand);

/**
 * The carved shape as voxels; NULL before the first round.
 *
 * @param stand  the shape; NULL has none
 * @return the grid, valid until the next round, or NULL.
 * @cost constant.   @threads any, while no round runs.   @since 0.1
 */
SF_API const sf_grid *sf_stand_grid(const sf_stand *stand);

/**
 * What 1 mm3 weighs in each voxel of sf_stand_grid(), in (layer, y, x) order, with those that were
 * carved; NULL where that is 1 everywhere, and before the first round.
 *
 * @param stand  the shape; NULL has none
 * @return the array, valid until the next round, or NULL; it means nothing where the shape was
 * empty.
 * @cost constant.   @threads any, while no round runs.   @since 0.1
 */
SF_API const float *sf_stand_density(const sf_stand *stand);

/**
 * A stance of the shape as it is; NULL for one that there is not.
 *
 * @param stand  the shape; NULL has none
 * @param index  which of the stances handed in
 * @return the stance, valid until the next round, or NULL.
 * @cost constant.   @threads any, while no round runs.   @since 0.1
 */
SF_API const sf_stance *sf_stand_stance(const sf_stand *stand, size_t index);

#ifdef __cplusplus
}
#endif

#endif
