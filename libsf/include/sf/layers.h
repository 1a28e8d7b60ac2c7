// SPDX-License-Identifier: MIT
// Layers of several materials, out: what a printer of many materials takes.
//
// One picture a layer, whose pixels name materials by a palette, and stack.json with the lattice
// and a table of the materials: how much of each there is, in voxels, mm3 and grams. Pictures are
// written as slices are made, from the bottom up, so that no more than one is ever held.

#ifndef SF_LAYERS_H
#define SF_LAYERS_H

#include <sf/halftone.h>
#include <sf/io.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Bytes of a material's name, the 0 at its end included. */
#define SF_MATERIAL_NAME_SIZE 48

/** What a material is called, looks like and weighs. */
typedef struct sf_material {
    char name[SF_MATERIAL_NAME_SIZE]; /**< UTF-8, not empty, no control characters, ended by a 0 */
    uint8_t colour[3];                /**< red, green and blue in its pictures */
    double density_g_cm3;             /**< above 0; 0: not known, and then no grams are said */
} sf_material;

/** Layers being written. */
typedef struct sf_layers sf_layers;

/**
 * Begin to write layers.
 *
 * Pixels are nx by ny, x to the right and y upward, as in sf_stack_write(). Entry 0 of the palette
 * is empty space, black and transparent; entry i + 1 is material i.
 *
 * @param folder          where to; needs `begin` and `commit`, and must stay
 * @param lattice         where voxels lie; copied
 * @param material_count  1..SF_MATERIAL_MAX
 * @param materials       the materials, in the order of ids; copied; names differ
 * @param allocator       for the object; NULL for the C library's
 * @param layers          receives the object
 * @param fault           NULL, or filled on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a lattice that cannot be, no materials or too
 * many, a name or density that cannot be; SF_ERR_UNSUPPORTED: a build without PNG; SF_ERR_MEMORY.
 * @cost O(nz).   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_layers_begin(sf_folder folder, const sf_lattice *lattice,
                                            uint32_t material_count, const sf_material *materials,
                                            const sf_allocator *allocator, sf_layers **layers,
                                            sf_fault *fault);

/**
 * Write the next layer up: layer_00000.png and so on.
 *
 * @param layers  the layers
 * @param ids     a byte a voxel, row 0 first: 0, or material + 1, as sf_materials has them
 * @param stride  bytes from one row to the next, at least nx
 * @param fault   NULL, or filled on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a stride that is too small, a material that there
 * is not, more layers than the lattice has; SF_ERR_MEMORY; SF_ERR_INTERNAL: libspng refuses what it
 * should take; or what the folder or its sinks returned.
 * @cost a pass, mostly in the compressor, which takes its memory from the C library.   @threads one
 * for these layers.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_layers_add(sf_layers *layers, const uint8_t *ids, size_t stride,
                                          sf_fault *fault);

/**
 * Write stack.json, when all layers are there.
 *
 *     {"format": "libsf-stack", "version": 3, "units": "mm", "lattice": as sf_stack_write() has it,
 *      "rule": null,
 *      "layers": {"pattern": "layer_%05u.png", "count": nz},
 *      "materials": [{"index": 1, "name", "colour": "#rrggbb", "density_g_cm3" or null,
 *                     "voxels", "volume_mm3", "grams" or null}, ...],
 *      "solid": "not 0", "row_order": "top_is_max_y"}
 *
 * @param layers  the layers
 * @param uses    NULL, or receives what of each material there is
 * @param fault   NULL, or filled on failure
 * @return SF_OK; SF_ERR_ARGUMENT: NULL, or layers are missing; or what the folder or its sinks
 * returned.
 * @cost O(nz).   @threads one for these layers.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_layers_finish(sf_layers *layers, sf_material_use *uses,
                                             sf_fault *fault);

/**
 * Free what layers hold; the folder is the caller's.
 *
 * @param layers  the layers, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with these layers.
 * @since 0.1
 */
SF_API void sf_layers_end(sf_layers *layers);

#ifdef __cplusplus
}
#endif

#endif
