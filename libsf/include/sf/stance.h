// SPDX-License-Identifier: MIT
// Stances: what a body stands, hangs or rocks on, and where its centre of mass may lie for it.
//
// A stance is made from a mesh and says how it is to come to rest: which way is up, and by what it
// touches the ground or the string. It knows nothing of weight. What it has to say about weight is
// a set of half-spaces: the body is safe when its centre of mass lies in all of them, and because
// each is linear in the centre of mass, whoever carves or bends a body can aim at them. Several
// stances of one body are several objects, whose half-spaces add up.
//
// Everything is in the frame of the mesh: it is gravity that turns, not the body.

#ifndef SF_STANCE_H
#define SF_STANCE_H

#include <sf/body.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a body comes to rest. */
typedef enum sf_stance_kind {
    SF_STANCE_STAND = 0, /**< on its lowest vertices, and stays when it is tilted */
    SF_STANCE_HANG = 1,  /**< from a point, tied to a string */
    SF_STANCE_ROCK = 2   /**< on a rounded base, and rolls back to the pose asked for */
} sf_stance_kind;

/** What is asked of a stance. Fill with sf_stance_options_default(). */
typedef struct sf_stance_options {
    size_t struct_size;       /**< sizeof(sf_stance_options), set by the default */
    sf_stance_kind kind;      /**< standing by default */
    double up[3];             /**< the direction away from the ground, of any length from 1e-100 to
                                   1e100: +z */
    double gamma_rad;         /**< standing: the tilt of the ground, in whatever direction, that it
                                   must survive: 4 degrees; 0 to 80 degrees */
    double tolerance_rad;     /**< hanging, rocking: how far from the pose asked for it may come to
                                   rest: 1 degree; more than 0, at most 45 degrees */
    double range_rad;         /**< rocking: the tilt from which it must still roll back: 20 degrees;
                                   more than tolerance_rad, at most 80 degrees */
    double contact_mm;        /**< vertices this close above the lowest one touch the ground; 0, the
                                   default: a millionth of the diagonal of the mesh's box */
    double region_low_mm[3];  /**< only vertices in this box can touch the ground, borders included:
                                   everywhere by default */
    double region_high_mm[3]; /**< the box's upper corner */
    double point_mm[3];       /**< hanging: where the string is tied: the origin */
    double lever_mm;          /**< hanging: how far below the point the centre of mass must lie; 0,
                                   the default: a hundredth of the diagonal */
} sf_stance_options;

/**
 * Options of a stance, each at its default.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_stance_options sf_stance_options_default(void);

/** A way for one mesh to come to rest. */
typedef struct sf_stance sf_stance;

/**
 * Make a stance: find what touches the ground, and where the centre of mass may lie.
 *
 * Standing. The ground lies below the lowest vertex within the region, perpendicular to `up`, and
 * what touches it is every vertex within contact_mm above it. The support polygon is their convex
 * hull, dropped onto the ground. It may be a segment or a point, and then no centre of mass is
 * safe.
 *
 * Hanging. The body swings freely about the point and comes to rest with its centre of mass
 * straight below.
 *
 * Rocking. The body stands on its convex hull (that of the vertices within the region), in the pose
 * in which `up` points up; let go from a tilt of up to range_rad in any direction, it must come
 * back to within tolerance_rad. How it rolls is said at sf_mesh_rest(). The pose asked for need not
 * be a face of the hull.
 *
 * The mesh is not kept. Only vertices that triangles use count. It need not be closed.
 *
 * @param mesh       vertices in mm, with triangles; coordinates up to 1e12
 * @param options    what is asked for
 * @param allocator  for the stance and for scratch, 30 bytes a vertex, or 500 where it rocks; NULL
 *                   for the C library's
 * @param stance     receives the stance
 * @param fault      NULL, or receives a sentence on failure
 * @return SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer, options out of
 * range or without their struct_size, a mesh without triangles, no vertex within the region, a
 * rocking body whose vertices all lie on a line; SF_ERR_OVERFLOW: a coordinate beyond 1e12, more
 * than 2^30 vertices of a body that rocks; SF_ERR_MEMORY.
 * @cost two passes over the mesh; n log n in the vertices that touch the ground; rocking, that of a
 * hull, and the square of the faces and edges within the range, in stretches of 256.
 * @threads any; one at a time for each allocator.
 * @source R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing Shapes
 * for 3D Fabrication", 2013, section 3, figure 2 and the rocking toy of table 1.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_stance_create(sf_mesh_view mesh, const sf_stance_options *options,
                                             const sf_allocator *allocator, sf_stance **stance,
                                             sf_fault *fault);

/**
 * Free a stance; NULL does nothing.
 *
 * @param stance  the stance, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this stance.
 * @since 0.1
 */
SF_API void sf_stance_destroy(sf_stance *stance);

/**
 * The options that a stance was made with, `up` with length 1 and every 0 replaced by what it
 * stands for.
 *
 * @param stance  the stance, not NULL
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_stance_options sf_stance_get_options(const sf_stance *stance);

/**
 * Height of the ground: its points p have up . p equal to it. Hanging: the height of the point.
 *
 * @param stance  the stance, not NULL
 * @return the height in mm, in the mesh's frame.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API double sf_stance_ground(const sf_stance *stance);

/**
 * The support polygon: corners on the ground, counter-clockwise for an eye that `up` points to.
 *
 * It has 2 corners where all contacts lie on a line, and 1 where they are one point, or where the
 * body hangs: the point itself.
 *
 * @param stance    the stance
 * @param xyz       receives x, y, z of each corner, in mm; may be NULL where capacity is 0
 * @param capacity  corners that it has room for
 * @param count     receives how many corners there are
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_CAPACITY: too little room, with the number
 * of corners in `count`.
 * @cost linear.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_stance_polygon(const sf_stance *stance, double *xyz, size_t capacity,
                                              size_t *count);

/**
 * The vertices that touch the ground, by rising number; none where the body hangs.
 *
 * @param stance    the stance
 * @param vertices  receives their numbers in the mesh; may be NULL where capacity is 0
 * @param capacity  numbers that it has room for
 * @param count     receives how many there are
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_CAPACITY: too little room, with the number
 * of contacts in `count`.
 * @cost linear.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_stance_contacts(const sf_stance *stance, uint32_t *vertices,
                                               size_t capacity, size_t *count);

/**
 * Move every contact straight down onto the ground, in the caller's array of vertices.
 *
 * With a contact_mm of, say, a tenth of a millimetre, this makes a foot that is almost flat flat,
 * and the support polygon is then what really touches.
 *
 * @param stance        the stance
 * @param vertices      x, y, z of each vertex of the mesh that the stance was made from, or of a
 *                      deformed one with the same vertices; those of contacts are changed
 * @param vertex_count  how many vertices
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_SHAPE: the mesh had another number of
 * vertices.
 * @cost linear in the contacts.   @threads any that write to distinct arrays.
 * @source R. Prevost and others, "Make It Stand", 2013, section 3: "we flatten faces surrounding
 * the support, within a threshold".
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_stance_flatten(const sf_stance *stance, double *vertices,
                                              size_t vertex_count);

/**
 * Where the centre of mass may lie: in all of these half-spaces.
 *
 * Standing, one for each edge of the support polygon: with its inward direction n, a corner p and
 * the height h of the centre c above the ground, n . (c - p) >= h tan(gamma). That is exact: the
 * body survives a tilt of gamma in every direction if and only if all hold. A segment has one for
 * either side and either end, a point one for each of four directions; where the mesh goes on below
 * the ground, outside of the region, one more asks for h >= 0.
 *
 * Hanging, sixteen planes through the point, which make a pyramid inside the cone of the tolerance
 * (they touch it along the pyramid's edges, and come within 2 % of it between them), and one that
 * asks for the lever.
 *
 * Rocking, as many as it takes (some twenty) so that from every tilt between the tolerance and the
 * range the body rolls straight towards the pose, on a floor that may lean by a tenth of a
 * degree. That is sufficient, not necessary: a body may also come back on a detour. Half-spaces
 * that others imply for all that lies in or near the mesh's box are left out. A centre of mass
 * straight above what touches the ground in the pose, and low enough, is always in all of them, but
 * for the height of the facets within the tolerance.
 *
 * @param stance      the stance
 * @param halfspaces  receives them, their normals with length 1; may be NULL where capacity is 0
 * @param capacity    half-spaces that it has room for
 * @param count       receives how many there are
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_CAPACITY: too little room, with the number
 * of half-spaces in `count`.
 * @cost linear.   @threads any.
 * @source standing: Prevost and others, "Make It Stand", 2013, figure 2, but with the height of the
 * centre of mass as it is, where the paper takes it for fixed.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_stance_halfspaces(const sf_stance *stance, sf_halfspace *halfspaces,
                                                 size_t capacity, size_t *count);

/** How a body of a given centre of mass fares in a stance. */
typedef struct sf_stance_verdict {
    double margin_rad;    /**< standing: the least tilt of the ground, over all directions, that
                               makes it fall, negative where it falls as it is; hanging: minus the
                               angle between the pose asked for and the one it comes to rest in;
                               rocking: the same, the worst of those it comes to from the pose and
                               from sixteen directions at the end of the range */
    double slack_mm;      /**< how far inside of the nearest half-space's plane the centre of mass
                               lies; negative outside */
    double edge_mm[2][3]; /**< standing: the edge over which it falls first, two corners; twice the
                               same point where the polygon is one, or where the body hangs;
                               rocking: an edge of what it comes to rest on */
    int stands;           /**< standing: margin_rad >= 0; hanging, rocking: it comes to rest within
                               the tolerance, hanging with the centre of mass not in the point */
    int safe; /**< it is in all half-spaces, to a billionth of the diagonal; standing, it
                   also lies above the ground */
} sf_stance_verdict;

/**
 * Judge a centre of mass.
 *
 * Standing, a centre of mass that is not above the ground never tips while it lies inside of an
 * edge (a margin of 90 degrees), and has fallen where it lies outside (minus 90 degrees).
 *
 * @param stance   the stance
 * @param com_mm   the centre of mass
 * @param verdict  receives the verdict
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a centre of mass that is no place within 1e12 mm;
 * SF_ERR_MEMORY: only of a body that rocks.
 * @cost linear in the half-spaces; rocking, seventeen times that of sf_mesh_rest() without its
 * hull.
 * @threads any; one at a time for each allocator where the body rocks.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_stance_judge(const sf_stance *stance, const double com_mm[3],
                                            sf_stance_verdict *verdict);

// ---------------------------------------------------------------------------------------------
// Rest
// ---------------------------------------------------------------------------------------------

/** How a body lies once it has come to rest on level ground. */
typedef struct sf_rest {
    double up[3];         /**< the direction, in the mesh's frame, away from the ground; length 1 */
    double tilt_rad;      /**< between the start's up and this one */
    double height_mm;     /**< of the centre of mass above the ground */
    double margin_rad;    /**< the least tilt of the ground that makes it leave */
    size_t contact_count; /**< corners of the convex hull that touch the ground */
    uint64_t turn_count;  /**< how many edges and corners it tipped over on its way */
} sf_rest;

/**
 * Where a body comes to rest that is put on level ground in some orientation, and let go.
 *
 * It rolls on its convex hull as a body that tips slowly, neither slides nor gains momentum: it
 * tips about the point of what touches the ground that is nearest to the centre of mass seen from
 * above, an edge or a corner, until more of it touches; and so on, until the centre of mass lies
 * over what it touches the ground with. That is the steepest descent of the height of the centre of
 * mass over all orientations, and ends in a local minimum. A start that is balanced on an edge or a
 * corner falls to one side, always the same. Corners within a millionth of the diagonal above the
 * lowest one touch.
 *
 * A body that is flat lies down on a side; one without any width comes to rest as it lies.
 *
 * @param mesh       vertices in mm, with triangles; coordinates up to 1e12; only vertices that
 *                   triangles use count, and it need not be closed
 * @param com_mm     its centre of mass, in its convex hull (to a millionth of the diagonal)
 * @param ups        of each start, the direction of the mesh that points up, of any length from
 *                   1e-100 to 1e100
 * @param count      how many starts
 * @param allocator  for scratch, 500 bytes a vertex at worst; NULL for the C library's
 * @param rests      receives one for each start
 * @param fault      NULL, or receives a sentence on failure
 * @return SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer, a mesh without
 * triangles, a centre of mass outside of the hull, a start that is no direction; SF_ERR_OVERFLOW: a
 * coordinate beyond 1e12, more than 2^30 vertices; SF_ERR_MEMORY.
 * @cost typically n log n for n vertices; for each start and edge or corner it tips over, one pass
 * over the corners of the hull.
 * @threads any; one at a time for each allocator.
 * @source hull: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull Algorithm for Convex
 * Hulls", 1996; rolling: M. Goldberg, R. K. Guy, "Stability of Polyhedra (J. H. Conway and R. K.
 * Guy)", 1969.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_rest(sf_mesh_view mesh, const double com_mm[3],
                                         const double *ups, size_t count,
                                         const sf_allocator *allocator, sf_rest *rests,
                                         sf_fault *fault);

#ifdef __cplusplus
}
#endif

#endif
