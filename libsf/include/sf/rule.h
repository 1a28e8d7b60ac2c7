// SPDX-License-Identifier: MIT
// Rules: what may rest on what.
//
// A rule says what slice S_{k+1} may hold, given what is alive in slice k. Box3, octagon and disk
// have an element for each step: a voxel is carried when the element around it meets living matter
// below. Slack is exact in the angle: each living voxel knows how much farther matter above it may
// reach out, gains a step's reach with each layer, and pays for what it reaches. On top of any of
// these, bridges: a gap of at most a given span between two anchored ends of one layer may stay.
//
// Every rule is monotone, in the slice and in what is alive below: more matter never kills. That is
// all that the operators ask of a rule, so they hold for each of them and for what comes later.
//
// A rule holds integers only and is computed with integers only, so that a printer's processor
// comes to the same judgement; angles and millimetres are turned into them by sf_rule_make().

#ifndef SF_RULE_H
#define SF_RULE_H

#include <sf/voxel.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Rule
// ---------------------------------------------------------------------------------------------

/** Which voxels below can carry a voxel. */
typedef enum sf_rule_kind {
    SF_RULE_BOX3 = 0,    /**< the nine voxels below: the papers' rule; takes no angle */
    SF_RULE_OCTAGON = 1, /**< a schedule of pluses and squares that stays within the asked angle */
    SF_RULE_DISK = 2, /**< an ellipse in voxels, a disk in mm, the same for layers of one height */
    SF_RULE_SLACK = 3 /**< the exact angle: what one layer does not reach the next may, added up */
} sf_rule_kind;

/** Longest gap that bridges may span, in voxels. */
#define SF_BRIDGE_SPAN_MAX 32767u

/**
 * Gaps that matter may span between two anchored ends, in voxels along x, y and both diagonals.
 *
 * Let A be the voxels of a slice that are carried by what is alive below, and let A* be the opening
 * of A along a direction by the anchor: what lies in carried runs of at least that length. A gap is
 * a maximal run, along that direction, of the slice's voxels outside A*; it is bridged when A*
 * bounds it on both ends and it is no longer than the span. Bridged voxels are alive, but have no
 * reach to spare, and bridge nothing themselves in their own layer.
 */
typedef struct sf_bridge {
    uint16_t span_x, span_y, span_diagonal;       /**< longest gap; 0: none along this direction */
    uint16_t anchor_x, anchor_y, anchor_diagonal; /**< carried voxels at each end; 0 counts as 1 */
} sf_bridge;

/** Smallest overhang angle that a rule can be made for, in radians: 5 degrees. */
#define SF_RULE_ANGLE_MIN_RAD 0.08726646259971647
/** Largest overhang angle that a rule can be made for, in radians: 85 degrees. */
#define SF_RULE_ANGLE_MAX_RAD 1.4835298641951802

/**
 * A support rule for one lattice: make it with sf_rule_box3() or sf_rule_make(), and only read it.
 *
 * Holds integers only: reaches are in 1/2^24 voxel. The reach of a step is how far, measured in the
 * plane, matter may lie beyond the matter that carries it. `table` belongs to the caller of
 * sf_rule_make() and must outlive every use of the rule.
 */
typedef struct sf_rule {
    sf_rule_kind kind;     /**< which rule */
    uint32_t table_count;  /**< layers that the table serves; 0 when all layers have one height */
    uint64_t reach_x_q24;  /**< one height: reach of one step along x */
    uint64_t reach_y_q24;  /**< one height: reach of one step along y */
    const uint64_t *table; /**< table_count numbers for x, then as many for y; or NULL. Octagon and
                                slack: reach from layer 0 to each layer. Disk: of each step. */
    uint16_t slack_x;      /**< slack: units of reach in one voxel along x */
    uint16_t slack_y;      /**< slack: the same along y */
    uint16_t slack_cap;    /**< slack: most that a voxel has to spare, in units, at most 254 */
    sf_bridge bridge;      /**< all zero: no bridges; see sf_rule_set_bridges() */
} sf_rule;

/**
 * What a rule allows on its lattice, for people: angles from the vertical, in radians.
 *
 * The first three hold in the long run, over many layers, in every layer of the lattice; the last
 * is exceeded nowhere but for rounding (octagon: less than 1.502 voxel in the plane, however long
 * the overhang).
 */
typedef struct sf_rule_angles {
    double axis_x_rad;   /**< an overhang along x is accepted up to this angle */
    double axis_y_rad;   /**< the same along y */
    double diagonal_rad; /**< the same along the diagonal of a pixel */
    double steepest_rad; /**< no overhang beyond this angle is accepted in any direction */
} sf_rule_angles;

/**
 * The papers' rule: a voxel is carried by any of the nine below it.
 *
 * It takes no angle. On cubic voxels it accepts 45 degrees along the axes and 54.7 degrees along
 * diagonals; sf_rule_measure() says what it accepts on another lattice.
 *
 * @return the rule; it serves every lattice.
 * @cost constant.   @threads any.
 * @source T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
 * Eurographics 2016, section 3.2.
 * @since 0.1
 */
SF_API sf_rule sf_rule_box3(void);

/**
 * Number of uint64_t that the table of sf_rule_make() needs for a lattice.
 *
 * @param lattice  any lattice; NULL counts as uniform
 * @return 0 where all layers have one height (heights_mm == NULL, or one layer), else 2 * nz.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API size_t sf_rule_table_count(const sf_lattice *lattice);

/**
 * Make a rule for an overhang angle on a lattice.
 *
 * The angle is measured from the vertical: 45 degrees is as far out as up, and larger is more
 * daring. The reach of a step from layer k is height_k * tan(angle) / pitch voxels, rounded down to
 * 1/2^24 voxel after one part in 2^40 has been forgiven, so that 45 degrees on cubes is exactly 1
 * whatever way the angle and the pitch were written.
 *
 * Octagon is the rule to take where an angle is given and pixels are square: it never reaches
 * beyond the asked angle but for less than 1.502 voxel, in any direction and over any number of
 * layers; along the axes and the diagonals it stays at atan(0.924 tan(angle)). Disk is good where
 * the reach is three voxels or more, because each step rounds down anew; it serves pixels that are
 * not square. Box3 ignores the angle. Slack is the rule to take where pixels are not square or
 * where the angle must be met in every direction: no chain of any length reaches beyond the asked
 * angle but for its cap, which is the longest single step, and in the long run it reaches the asked
 * angle to within three percent of its tangent (seven where pixels are oblong). It costs a byte for
 * each voxel of two layers.
 *
 * @param kind       which rule
 * @param angle_rad  SF_RULE_ANGLE_MIN_RAD to SF_RULE_ANGLE_MAX_RAD (5 to 85 degrees, each bound
 *                   with 1e-9 to spare); ignored by box3
 * @param lattice    the lattice that slices lie on
 * @param table      sf_rule_table_count() numbers, or NULL where that is 0 or for box3; written,
 *                   and kept by the rule
 * @param rule       the rule
 * @param fault      NULL, or where a refusal is explained
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such kind, an angle outside its range or not a
 * number; SF_ERR_UNSUPPORTED: octagon on pixels that are not square, disk where a step reaches less
 * than a voxel, a step that reaches more than SF_REACH_MAX voxels, slack where one reaches more
 * than 63 or where pixels are more than 25 times as long as wide; what sf_lattice_validate() says.
 * @cost O(nz) where heights differ, else constant.   @threads any.
 * @source The octagon's schedule is a Bresenham line in the number of pluses and squares
 * (J. E. Bresenham, 1965).
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_rule_make(sf_rule_kind kind, double angle_rad,
                                         const sf_lattice *lattice, uint64_t *table, sf_rule *rule,
                                         sf_fault *fault);

/**
 * The element of one step: slice k + 1 must lie within slice k dilated by it.
 *
 * Under slack the element holds what can carry at all, where there is slack enough; bridges are not
 * in it. The octagon's elements differ from step to step even where all layers have one height, so
 * k is always the lattice's layer, never a count from the bed.
 *
 * @param rule     the rule
 * @param k        layer below the step, counted from the lattice's layer 0
 * @param element  the element
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a rule that sf_rule_make() did not make, or a
 * table that does not reach to layer k + 1.
 * @cost O(reach).   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_rule_element(const sf_rule *rule, uint32_t k, sf_element *element);

/**
 * Let a rule accept bridges: gaps of at most a span between two anchored ends of one layer.
 *
 * They run along x, along y and along both diagonals of a pixel. The span is rounded down to whole
 * voxels, the anchor up, each after one part in 2^20 of a voxel has been forgiven; layer heights do
 * not matter.
 *
 * @param rule       a rule of any kind; only its bridges are changed
 * @param span_mm    longest gap that is spanned, 0 for no bridges
 * @param anchor_mm  length of carried matter that each end must have; a voxel is asked for at least
 * @param lattice    the lattice that the rule was made for
 * @param fault      NULL, or where a refusal is explained
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a span or an anchor that is negative or not a
 * number; SF_ERR_UNSUPPORTED: a span or an anchor of more than SF_BRIDGE_SPAN_MAX voxels, a span
 * greater than 0 that is less than a voxel along every direction; what sf_lattice_validate() says.
 * @cost constant.   @threads one per rule.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_rule_set_bridges(sf_rule *rule, double span_mm, double anchor_mm,
                                                const sf_lattice *lattice, sf_fault *fault);

/**
 * Angles that a rule allows on a lattice.
 *
 * Box3 and disk: from the reach of single steps, the worst over the layers. Octagon: from its mean
 * reach; a window of L layers is within 1.502 voxel of that. Slack: the asked angle and what its
 * polygon of steps makes of it; a window of L layers is within the cap of that. Bridges are not
 * overhangs and do not count.
 *
 * @param rule     the rule
 * @param lattice  the lattice that it was made for; any for box3
 * @param angles   the angles
 * @return SF_OK; SF_ERR_ARGUMENT: as sf_rule_element(); SF_ERR_SHAPE: the rule was made for another
 * number of layers; what sf_lattice_validate() says.
 * @cost O(nz + d * reach^2) where d neighbouring layers differ in height.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_rule_measure(const sf_rule *rule, const sf_lattice *lattice,
                                            sf_rule_angles *angles);

/**
 * The rule kind of a name, as sf_rule_kind_name() gives it.
 *
 * @param name  zero-terminated; NULL is the name of none
 * @param kind  the kind
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, or the name of no kind.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_rule_kind_from_name(const char *name, sf_rule_kind *kind);

/**
 * Name of a rule kind, as the command line and stack.json spell it.
 *
 * @param kind  any value
 * @return "box3", "octagon", "disk", "slack", or "unknown"; a static string, never NULL.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API const char *sf_rule_kind_name(sf_rule_kind kind);

#ifdef __cplusplus
}
#endif

#endif
