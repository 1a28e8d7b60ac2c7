// SPDX-License-Identifier: MIT
// Bending: what a change of shape does to the balance, and what it costs in looks.
//
// Everything that an optimiser asks, whichever it is: the gradients of mass and centre of mass by
// the vertices of a mesh, the same through the handles that bend it, and the energy that says how
// far the bent surface has lost its details.

#ifndef SF_BEND_H
#define SF_BEND_H

#include <sf/body.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Gradient of the mass and the first moments of a closed mesh by its vertices.
 *
 * @param mesh      closed and oriented, else the figures depend on where the mesh lies
 * @param density   what 1 mm3 weighs; finite
 * @param gradient  receives 12 numbers for each vertex: the derivatives of the mass by the vertex's
 *                  x, y, z, then those of the moments along x, y and z; not the mesh's own arrays
 * @return SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: a NULL pointer, a mesh without
 * triangles, a density that is not finite.
 * @cost one pass over the triangles, after one over the vertices.   @threads any that write
 * distinct arrays.
 * @source R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand: Balancing Shapes
 * for 3D Fabrication", SIGGRAPH 2013, appendix, with diag(v_i + v_j + v_k + v_p) for the derivative
 * of g.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_body_gradient(sf_mesh_view mesh, double density,
                                                  double *gradient);

/**
 * Gradient of a centre of mass: (d moment - com d mass) / mass.
 *
 * @param body          the body as it is, all parts together
 * @param gradient      12 numbers for each of `count` points, as sf_mesh_body_gradient() gives them
 * @param count         number of points
 * @param com_gradient  receives 9 numbers for each: the derivatives of the centre's x by the
 *                      point's x, y, z, then those of its y and of its z; not `gradient`
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer where count is not 0, a body without mass.
 * @cost linear.   @threads any that write distinct arrays.
 * @source the same; (d m / d v) c is an outer product.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_body_com_gradient(sf_body body, const double *gradient, size_t count,
                                                 double *com_gradient);

#ifdef __cplusplus
}
#endif

#endif
