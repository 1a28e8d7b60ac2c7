// SPDX-License-Identifier: MIT
// OpenSubdiv's limit surface of a cage's boundary: to draw it, and to hold our own against it.
//
// The boundary of a cage of cells, or a cage of faces, is a control mesh as films and modelling
// programs have them; OpenSubdiv is their common reference. What it makes of the same mesh, creases
// and sharp points is found by other code than <sf/limit.h>, so that either tells of faults in the
// other.
//
// These functions are in libsf-opensubdiv, a library of its own beside libsf.

#ifndef SF_LINK_OPENSUBDIV_H
#define SF_LINK_OPENSUBDIV_H

#include <sf/cage.h>
#include <sf/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Most steps of refinement. */
#define SF_OPENSUBDIV_STEP_MAX 10u
/** Most faces that are made on the way. */
#define SF_OPENSUBDIV_FACE_MAX 0x1000000u

/** What is made of a cage. Fill with sf_opensubdiv_options_default(). */
typedef struct sf_opensubdiv_options {
    size_t struct_size; /**< sizeof(sf_opensubdiv_options), set by the default */
    uint32_t steps;     /**< steps of refinement, 0 to SF_OPENSUBDIV_STEP_MAX; 2 */
    int on_limit; /**< whether points are moved to the limit surface: 1; or stay where the steps
                     leave them: 0 */
} sf_opensubdiv_options;

/**
 * Two steps, on the limit.
 *
 * @return the options, by value, with struct_size set.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_opensubdiv_options sf_opensubdiv_options_default(void);

/**
 * The boundary of a cage, refined by OpenSubdiv, as a mesh.
 *
 * Faces of one cell alone, outside outwards, or all faces of a cage of dimension 2, are refined by
 * Catmull and Clark's rules; open edges are sharp. Vertices are those after the steps, in
 * OpenSubdiv's order, each at the place on the limit surface that it tends to. Half sharp creases
 * are followed to where they have become smooth, for which OpenSubdiv refines on where the steps
 * are fewer. Each face becomes a fan of triangles. OpenSubdiv keeps sharpness in single precision.
 * Where a crease that lasts ends within the surface, its mask is that of a smooth point, so that
 * this point alone is not quite on the limit: by a hundredth of an edge, and less with every step.
 *
 * @param cage       the cage
 * @param options    NULL for sf_opensubdiv_options_default()
 * @param allocator  for the mesh; NULL for the C library's. OpenSubdiv takes from the C++ library
 * @param task       NULL, or progress, and a cancel between steps
 * @param mesh       where the new mesh is left, to be destroyed by the caller; untouched on failure
 * @param fault      NULL, or filled on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, too many steps; SF_ERR_OVERFLOW: more than
 * SF_OPENSUBDIV_FACE_MAX faces; SF_ERR_UNSUPPORTED: a cage whose cells leave no boundary, or that
 * OpenSubdiv refuses; SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_INTERNAL: OpenSubdiv failed
 * otherwise.
 * @cost some microseconds for each face that is made.   @threads any; one at a time for each
 * allocator.
 * @source Pixar, OpenSubdiv 3; E. Catmull, J. Clark, "Recursively generated B-spline surfaces on
 * arbitrary topological meshes", 1978; T. DeRose, M. Kass, T. Truong, "Subdivision surfaces in
 * character animation", 1998.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_opensubdiv_mesh(const sf_cage *cage,
                                               const sf_opensubdiv_options *options,
                                               const sf_allocator *allocator, sf_task *task,
                                               sf_mesh **mesh, sf_fault *fault);

#ifdef __cplusplus
}
#endif

#endif
