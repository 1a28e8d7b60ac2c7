// SPDX-License-Identifier: MIT
// Tetrahedra inside of a closed surface, by TetGen.
//
// TetGen is under the GNU Affero General Public Licence, version 3: a program that is linked to
// this library is, too. So this adapter is built only where it is asked for, and no other part of
// libsf is ever linked to it. sf_tets_of_grid() does a like job on voxels.
//
// These functions are in libsf-tetgen, a library of its own beside libsf.

#ifndef SF_LINK_TETGEN_H
#define SF_LINK_TETGEN_H

#include <sf/mesh.h>
#include <sf/tetra.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a surface is filled. Fill with sf_tetgen_options_default(). */
typedef struct sf_tetgen_options {
    size_t struct_size; /**< sizeof(sf_tetgen_options), set by the default */
    double quality;  /**< most radius of the circumscribed ball by shortest edge: 2; 1.1 to 100 */
    double most_mm3; /**< most volume of a tetrahedron; 0: the volume by 20000 */
    const double
        *values; /**< NULL, or of each vertex of the surface its value; NaN where it is free */
    const sf_property *property; /**< what the values are; needed with them */
} sf_tetgen_options;

/**
 * Quality 2, at least some 20,000 tetrahedra, no values.
 *
 * @return the options, by value, with struct_size set.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_tetgen_options sf_tetgen_options_default(void);

/**
 * Fill a closed surface with tetrahedra, and spread what is painted on it over all of them.
 *
 * Vertices at one place are one vertex; where they have several values, the last counts. The
 * surface stays as it is: TetGen adds points inside, and on it where it must, which take their
 * values between the vertices of its triangles. Values go inside by sf_tets_spread(). A surface
 * that goes through itself is refused, because TetGen cannot fill it; sf_tets_of_grid() can.
 *
 * @param mesh       the surface; what sf_mesh_validate() takes
 * @param options    NULL for sf_tetgen_options_default()
 * @param allocator  for the tetrahedra and for scratch; NULL for the C library's. TetGen takes from
 * the C++ library
 * @param task       NULL, or cancel, before and after TetGen, which hears nothing
 * @param tets       receives the tetrahedra, with one property where there are values; untouched on
 *                   failure
 * @param fault      NULL, or filled on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, an option out of range, values without a
 * property, a value outside of its bounds; what sf_mesh_validate() says; SF_ERR_UNSUPPORTED: a
 * surface that is not closed or goes through itself, or of which TetGen makes nothing;
 * SF_ERR_OVERFLOW: more than 2^28 triangles or tetrahedra; SF_ERR_INFEASIBLE: as sf_tets_spread();
 * SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_INTERNAL: TetGen failed otherwise.
 * @cost some ten microseconds for each tetrahedron.   @threads one at a time in a process, because
 * TetGen keeps global state.
 * @source H. Si, "TetGen, a Delaunay-based quality tetrahedral mesh generator", 2015.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_tetgen_fill(sf_mesh_view mesh, const sf_tetgen_options *options,
                                           const sf_allocator *allocator, sf_task *task,
                                           sf_tets **tets, sf_fault *fault);

#ifdef __cplusplus
}
#endif

#endif
