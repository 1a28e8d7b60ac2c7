// SPDX-License-Identifier: MIT
// Builders: cages of simple shapes, to begin with.
//
// A block, faces that are drawn along a line or turned about an axis, and a skeleton of struts,
// which is how one sketches a body. None of them has properties; those are added to the cage, and
// filled by a function of the place if one likes.

#ifndef SF_CAGE_BUILD_H
#define SF_CAGE_BUILD_H

#include <sf/base.h>
#include <sf/cage.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * A block of hexahedra.
 *
 * Point (i, j, k) is number i + (nx + 1) (j + (ny + 1) k), cell (i, j, k) number i + nx (j + ny k).
 *
 * @param counts     cells along x, y and z, at least 1
 * @param low_mm     its lower corner
 * @param high_mm    its upper corner, above the lower one along each axis
 * @param allocator  NULL for the C library's
 * @param cage       receives the cage
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a count of 0, corners that are no box or beyond
 * 10^12 mm; SF_ERR_OVERFLOW: more than SF_CAGE_POINT_MAX points or corners; SF_ERR_MEMORY.
 * @cost linear.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_block(const uint32_t counts[3], const double low_mm[3],
                                          const double high_mm[3], const sf_allocator *allocator,
                                          sf_cage **cage);

/**
 * Draw faces along a line: prisms, of quadrilaterals hexahedra.
 *
 * The points of layer k are those of the faces, in their order, k / layers of the way; the cells of
 * a layer follow each other in the order of the faces.
 *
 * @param faces      a cage of dimension 2
 * @param vector_mm  how far, across the faces
 * @param layers     how many cells that is, at least 1
 * @param allocator  NULL for the C library's
 * @param cage       receives the cage
 * @param fault      NULL, or receives a sentence on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no layers, a vector that is not finite or leads
 * farther than 2 10^12 mm, a face within 10^-9 of along it, faces that look to both sides of it;
 * SF_ERR_UNSUPPORTED: a cage of dimension 3, or what sf_cage_create() refuses; SF_ERR_OVERFLOW;
 * SF_ERR_MEMORY.
 * @cost linear.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_extrude(const sf_cage *faces, const double vector_mm[3],
                                            uint32_t layers, const sf_allocator *allocator,
                                            sf_cage **cage, sf_fault *fault);

/**
 * Turn faces about the z axis.
 *
 * The faces lie in the half-plane of x at least 0 and y = 0; y is not looked at. An edge on the
 * axis stays one: a quadrilateral there becomes a wedge, a triangle a tetrahedron. On the axis are
 * points whose x is 0 and no other number: round what was measured or read.
 *
 * @param faces      a cage of dimension 2
 * @param sectors    how many cells around, at least 3 for a full turn, else at least 1
 * @param angle_rad  how far, above 0 and at most a full turn; only the double nearest to 2 pi
 * closes; for parts less than pi for each sector
 * @param allocator  NULL for the C library's
 * @param cage       receives the cage
 * @param fault      NULL, or receives a sentence on failure, which names the face at fault
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, sectors or an angle out of range, a point with x
 * below 0; SF_ERR_UNSUPPORTED: a cage of dimension 3, a face that touches the axis in a point only
 * or that becomes no served cell, or what sf_cage_create() refuses; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
 * @cost linear.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_revolve(const sf_cage *faces, uint32_t sectors,
                                            double angle_rad, const sf_allocator *allocator,
                                            sf_cage **cage, sf_fault *fault);

/** A place where struts meet: a cube along the axes. */
typedef struct sf_skeleton_node {
    double at_mm[3];     /**< its middle */
    double half_side_mm; /**< half of the cube's side, above 0 */
} sf_skeleton_node;

/** A strut between two nodes. */
typedef struct sf_skeleton_strut {
    uint32_t nodes[2]; /**< which two, not the same */
    uint32_t cells;    /**< into how many cells it is cut, at least 1 */
} sf_skeleton_strut;

/**
 * A body along a skeleton: cubes at the nodes, and struts between them, all hexahedra.
 *
 * A strut leaves a node through the side that its direction is nearest to, and no two struts
 * through the same side. It is not twisted more than it must be. Whether cubes or struts run into
 * each other is not looked at.
 *
 * @param node_count   1 or more
 * @param nodes        the nodes; their cubes are the first cells, in their order
 * @param strut_count  may be 0
 * @param struts       the struts; their cells follow
 * @param allocator    NULL for the C library's
 * @param cage         receives the cage
 * @param fault        NULL, or receives a sentence on failure, which names the node or strut at
 * fault
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no nodes, a number out of range, a strut from a
 * node to itself; SF_ERR_UNSUPPORTED: two struts through one side of a node, a strut shorter than
 * its nodes' cubes are wide, or what sf_cage_create() refuses; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
 * @cost linear.   @threads any; one at a time for each allocator.
 * @source C. Altenhofen and others, "Continuous property gradation for multi-material 3D-printed
 * objects", 2018, on sketched control meshes.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_skeleton(size_t node_count, const sf_skeleton_node *nodes,
                                             size_t strut_count, const sf_skeleton_strut *struts,
                                             const sf_allocator *allocator, sf_cage **cage,
                                             sf_fault *fault);

/** A place for another one: what it is before is found in `moved_mm`. Returns 0 to give up. */
typedef int (*sf_cage_place_function)(void *user, const double at_mm[3], double moved_mm[3]);
/** A value for a place: what it is before is found in `value`. Returns 0 to give up. */
typedef int (*sf_cage_value_function)(void *user, const double at_mm[3], double *value);

/**
 * Move all points by a function of their places.
 *
 * @param cage       the cage; on failure it is as it was
 * @param function   called for each point in its order
 * @param user       handed to it
 * @param allocator  for scratch; NULL for the C library's
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a place beyond 10^12 mm or not finite;
 * SF_ERR_MEMORY; SF_ERR_CANCELLED: the function gave up.
 * @cost O(points).   @threads one for each cage.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_map_positions(sf_cage *cage, sf_cage_place_function function,
                                                  void *user, const sf_allocator *allocator);

/**
 * Set all values of a property by a function of the places of their points.
 *
 * @param cage       the cage; on failure it is as it was
 * @param channel    which property; a value that several corners name gets that of the last one's
 * place
 * @param function   called for each point in its order, or for each corner
 * @param user       handed to it
 * @param allocator  for scratch; NULL for the C library's
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such property, a value that it does not allow;
 * SF_ERR_MEMORY; SF_ERR_CANCELLED: the function gave up.
 * @cost O(points and corners).   @threads one for each cage.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_map_values(sf_cage *cage, size_t channel,
                                               sf_cage_value_function function, void *user,
                                               const sf_allocator *allocator);

#ifdef __cplusplus
}
#endif

#endif
