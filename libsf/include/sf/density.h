// SPDX-License-Identifier: MIT
// Densities: what 1 mm3 of each voxel weighs.
//
// One number for each voxel, solid or not, in (layer, y, x) order: nx * ny * nz floats. They come
// from what people know of a part: it is printed with dense walls and a sparse inside, this part of
// it is of another material, here sits a magnet. Densities are relative, in any unit, as long as it
// is the same for all that is weighed together.

#ifndef SF_DENSITY_H
#define SF_DENSITY_H

#include <sf/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Largest number of regions. */
#define SF_DENSITY_REGIONS_MAX 65534u

/** What a region is given by. */
typedef enum sf_density_shape {
    SF_DENSITY_BOX = 0,  /**< voxels whose centre lies in low_mm <= centre < high_mm */
    SF_DENSITY_MESH = 1, /**< voxels whose centre lies in the solid that a mesh bounds */
    SF_DENSITY_MASK = 2  /**< voxels that are solid in a grid */
} sf_density_shape;

/** A region of one density. Only what its shape names is looked at. */
typedef struct sf_density_region {
    sf_density_shape shape;       /**< how it is said: box, mesh or mask */
    double density;               /**< what 1 mm3 weighs, above 0; infill does not thin it */
    double low_mm[3], high_mm[3]; /**< corners of a box */
    sf_mesh_view mesh;            /**< as sf_grid_voxelize() takes it */
    const sf_grid *mask;          /**< of the grid's counts */
} sf_density_region;

/** Where densities come from. Fill with sf_density_options_default(). */
typedef struct sf_density_options {
    size_t struct_size;  /**< sizeof(sf_density_options), set by the default */
    double density;      /**< of everything that no region says otherwise of, above 0: 1 */
    double infill;       /**< share of that in what is not wall, above 0 and at most 1: 1 */
    const sf_grid *wall; /**< what is dense; NULL (default): all */
    const sf_density_region *regions; /**< of regions that overlap the last one counts */
    size_t region_count;              /**< 0 by default */
} sf_density_options;

/**
 * Options of densities: 1 everywhere.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_density_options sf_density_options_default(void);

/**
 * What 1 mm3 of each voxel weighs.
 *
 * @param lattice    where the voxels lie
 * @param options    NULL for the default
 * @param allocator  for working memory: 2 bytes for each voxel, and with meshes a grid; NULL for
 *                   the C library's
 * @param task       NULL, or progress, cancel and threads
 * @param density    receives nx * ny * nz numbers in (layer, y, x) order; untouched on failure
 * @return SF_OK; what sf_lattice_validate() and sf_grid_voxelize() say; SF_ERR_ARGUMENT: a NULL
 * pointer, options without their struct_size, a density that is not above 0 or not finite as a
 * float, an infill outside its range, regions without an array, a region without its shape;
 * SF_ERR_SHAPE: a wall or a mask of other counts; SF_ERR_OVERFLOW: more than SF_DENSITY_REGIONS_MAX
 * regions, or more voxels than the machine can address; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost one pass over the voxels for each region, and one more.
 * @threads any that write distinct arrays.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_lattice_density(const sf_lattice *lattice,
                                               const sf_density_options *options,
                                               const sf_allocator *allocator, sf_task *task,
                                               float *density);

#ifdef __cplusplus
}
#endif

#endif
