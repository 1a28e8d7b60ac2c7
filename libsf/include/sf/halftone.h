// SPDX-License-Identifier: MIT
// Halftones: from how much of each material belongs somewhere to one material in every voxel.
//
// A tone is the fraction of a voxel's neighbourhood that a material should fill. A mask is a block
// of ranks that is repeated through space: each rank 0 .. N - 1 of its N voxels occurs once. With
// tones f_0, f_1, ... that add up to 1, and T_j = floor((f_0 + ... + f_j) N + 1/2), a voxel gets
// material j where
//
//     T_{j-1} <= rank < T_j          (T_{-1} = 0, the last T is N):
//
// one comparison a boundary, whatever its neighbours got. So any slice can be made first, and over
// whole periods a constant tone comes out exactly to 1 / N. Ranks are such that what is below any
// threshold, or between two, is spread evenly, in millimetres: no clumps, no rows.
//
// Materials are numbered from 0. In bytes that hold materials 0 means none, and material j is
// j + 1.

#ifndef SF_HALFTONE_H
#define SF_HALFTONE_H

#include <sf/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Largest number of materials. */
#define SF_MATERIAL_MAX 16u
/** Largest number of voxels in a mask. */
#define SF_MASK_SIZE_MAX 4194304u

// ---------------------------------------------------------------------------------------------
// Masks
// ---------------------------------------------------------------------------------------------

/** Between which voxels a mask keeps what is alike apart. */
typedef enum sf_mask_kind {
    SF_MASK_SLICE = 0,    /**< within each slice, and along each column: slices look even */
    SF_MASK_ISOTROPIC = 1 /**< in all directions alike: the solid is even, its slices less so */
} sf_mask_kind;

/** How a mask is made. Fill with sf_mask_options_default(). */
typedef struct sf_mask_options {
    size_t struct_size;  /**< sizeof(sf_mask_options), set by the default */
    sf_mask_kind kind;   /**< SF_MASK_SLICE by default */
    uint32_t nx, ny, nz; /**< period in voxels, 32 each: nx a power of two in 4..256, the others in
                              1..256, their product at most SF_MASK_SIZE_MAX */
    double pitch_mm[3];  /**< of a voxel; 1 each; no two differ by a factor above 64 */
    double spread;       /**< standard deviation of the Gaussian that keeps voxels apart, in mean
                              pitches (geometric: of x and y, or of all three); 0.5..4, 1.5 */
    uint64_t seed;       /**< another seed, another mask: 0 */
} sf_mask_options;

/** A block of ranks, repeated along x, y and z. */
typedef struct sf_mask sf_mask;

/**
 * Options of a mask: those that the built-in one was made with.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_mask_options sf_mask_options_default(void);

/**
 * The mask of 32 x 32 x 32 voxels that is part of the library: what the default options make.
 *
 * @return the mask, which lives as long as the program, never NULL.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API const sf_mask *sf_mask_builtin(void);

/**
 * Make a mask by void and cluster: the same ranks for the same options, on every machine.
 *
 * @param options    NULL for the default
 * @param allocator  for the mask and for working memory, 38 bytes a voxel in all; NULL for the C
 *                   library's
 * @param task       NULL, or progress and cancel
 * @param mask       receives the mask
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size or outside
 * their ranges; SF_ERR_OVERFLOW: more than SF_MASK_SIZE_MAX voxels; SF_ERR_MEMORY;
 * SF_ERR_CANCELLED.
 * @cost about linear in the voxels: 32^3 takes 0.1 s, 64^3 1.5 s.
 * @threads any; one at a time for each allocator.
 * @source R. Ulichney, "The void-and-cluster method for dither array generation", 1993; for slices
 * A. Wolfe, N. Morrical, T. Akenine-Moeller, R. Ramamoorthi, "Spatiotemporal Blue Noise Masks",
 * 2022.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mask_create(const sf_mask_options *options,
                                           const sf_allocator *allocator, sf_task *task,
                                           sf_mask **mask);

/**
 * Make a mask from ranks that were kept, in (layer, y, x) order.
 *
 * @param nx         period along x, as in sf_mask_options
 * @param ny         along y
 * @param nz         along z
 * @param ranks      nx * ny * nz numbers: each of 0 .. nx * ny * nz - 1 once
 * @param allocator  NULL for the C library's
 * @param mask       receives the mask
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a period outside its range; SF_ERR_FORMAT: a rank
 * that is too large or occurs twice; SF_ERR_OVERFLOW: more than SF_MASK_SIZE_MAX voxels;
 * SF_ERR_MEMORY.
 * @cost one pass.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mask_from_ranks(uint32_t nx, uint32_t ny, uint32_t nz,
                                               const uint32_t *ranks, const sf_allocator *allocator,
                                               sf_mask **mask);

/**
 * Free a mask.
 *
 * @param mask  the mask, freed; NULL and the built-in one do nothing
 * @cost constant.   @threads one, and nobody else with this mask.
 * @since 0.1
 */
SF_API void sf_mask_destroy(sf_mask *mask);

/**
 * The period of a mask along x, y and z, in voxels.
 *
 * @param mask  the mask; NULL has no size
 * @param size  receives the period along x, y and z; not NULL
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API void sf_mask_size(const sf_mask *mask, uint32_t size[3]);

/**
 * The rank at a voxel, anywhere: the mask is repeated.
 *
 * @param mask  the mask; NULL gives 0
 * @param x     column, of the repeated mask
 * @param y     row
 * @param z     layer
 * @return the rank; 0 for NULL.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API uint32_t sf_mask_rank(const sf_mask *mask, uint32_t x, uint32_t y, uint32_t z);

// ---------------------------------------------------------------------------------------------
// Tones in, materials out
// ---------------------------------------------------------------------------------------------

/** What tones are kept in. */
typedef enum sf_tone_type {
    SF_TONE_U8 = 0,  /**< uint8_t: 255 is all */
    SF_TONE_F32 = 1, /**< float: 1 is all */
    SF_TONE_F64 = 2  /**< double: 1 is all */
} sf_tone_type;

/** Tones of one material over a rectangle. */
typedef struct sf_tone_plane {
    const void *values; /**< first tone of row 0, in the type's own alignment */
    size_t stride;      /**< tones from one row to the next, at least the width */
} sf_tone_plane;

/** Where a material must not be. */
typedef struct sf_keep_out {
    sf_slice where;    /**< of the rectangle's size: solid where it must not be */
    uint32_t material; /**< which */
    uint32_t instead;  /**< which material takes its place there; another one */
} sf_keep_out;

/** A rectangle of one slice, to be halftoned. Zero what is not needed. */
typedef struct sf_tones {
    size_t struct_size;          /**< sizeof(sf_tones) */
    uint32_t width, height;      /**< voxels, 1..SF_EXTENT_MAX each */
    uint32_t x0, y0, layer;      /**< where its first voxel lies: which part of the mask applies */
    sf_tone_type type;           /**< of all planes */
    const sf_tone_plane *planes; /**< one for each material but the last, which gets what is left */
    sf_slice solid;              /**< words NULL: all; else what is empty there gets no material,
                                      and its tones are not looked at */
    const sf_keep_out *keep_outs; /**< applied in their order; may be NULL where there are none */
    size_t keep_out_count;        /**< how many */
} sf_tones;

/** Where materials go. Each pointer may be NULL. Nothing here may overlap what is read. */
typedef struct sf_materials {
    const sf_slice *slices; /**< NULL, or one for each material, of the rectangle's size; their
                               words may be NULL */
    uint8_t *ids;           /**< NULL, or a byte a voxel: 0, or material + 1 */
    size_t ids_stride;      /**< bytes from one row to the next, at least the width */
    uint64_t *counts;       /**< NULL, or receives voxels of each material in the rectangle */
} sf_materials;

/** A mask made ready for a number of materials. Slices are made from it at any time, in any order,
 * by any number of threads. */
typedef struct sf_halftone sf_halftone;

/**
 * Make a mask ready.
 *
 * @param mask            only read, and only during the call
 * @param material_count  2..SF_MATERIAL_MAX
 * @param allocator       5 bytes for each voxel of the mask, three times that where nx is 32; NULL
 *                        for the C library's
 * @param halftone        receives the object
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a number of materials out of range;
 * SF_ERR_OVERFLOW: more memory than the machine addresses; SF_ERR_MEMORY.
 * @cost a pass over the mask.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_halftone_create(const sf_mask *mask, uint32_t material_count,
                                               const sf_allocator *allocator,
                                               sf_halftone **halftone);

/**
 * Free a halftone.
 *
 * @param halftone  the halftone, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this halftone.
 * @since 0.1
 */
SF_API void sf_halftone_destroy(sf_halftone *halftone);

/**
 * Halftone a rectangle of a slice: a row, a tile or all of it, whichever comes first.
 *
 * Tones of solid voxels are at least 0 and add up to at most 1 (with 1e-6 to spare) or 255.
 *
 * @param halftone   mask and number of materials
 * @param tones      what each material should fill
 * @param materials  receives materials; bits past the width become zero
 * @param task       NULL, or cancel, heeded at the start, and threads, at most 16 pieces at once
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a missing struct_size, a size, stride, type or
 * material out of range, a slice written that overlaps another, a tone that is no number or out of
 * range; SF_ERR_SHAPE: a slice of another size; SF_ERR_CANCELLED. Then nothing was written.
 * @cost one pass over the tones; two over those that can be wrong: all but the bytes of two
 * materials. No memory.
 * @threads any, on distinct materials.
 * @source R. Ulichney, "Digital Halftoning", 1987, ordered dither.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_halftone_slice(const sf_halftone *halftone, const sf_tones *tones,
                                              const sf_materials *materials, sf_task *task);

// ---------------------------------------------------------------------------------------------
// Error diffusion
// ---------------------------------------------------------------------------------------------

/** Error diffusion from slice to slice: what one voxel could not be, the next ones are. */
typedef struct sf_diffuser sf_diffuser;

/** What became of the tones of one material so far, in voxels: asked = placed + dropped + carried,
 * each to 2^-24 of a voxel. */
typedef struct sf_diffusion {
    double asked;   /**< sum of the tones of solid voxels */
    double placed;  /**< voxels of the material, before keep-outs */
    double dropped; /**< lost where the next voxel up is empty */
    double carried; /**< waiting for the next slice */
} sf_diffusion;

/**
 * Begin diffusing errors through slices of one size, from the lowest up.
 *
 * Each voxel gets the material that it lacks most, and what it got too much or too little goes to
 * the next voxel in the row, the two behind it in the next row, and the one above, more to those
 * that are nearer in mm. Rows run to and fro. Shares of voxels that are empty or outside go up.
 *
 * @param width           1..SF_EXTENT_MAX
 * @param height          1..SF_EXTENT_MAX
 * @param material_count  2..SF_MATERIAL_MAX
 * @param pitch_mm        of a voxel: x, y, z, above 0; no two differ by a factor above 64
 * @param allocator       4 bytes for each voxel of a slice and material; NULL for the C library's
 * @param diffuser        receives the object
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a value out of range; SF_ERR_OVERFLOW: more
 * memory than the machine addresses; SF_ERR_MEMORY.
 * @cost one pass over the memory.   @threads any; one at a time for each allocator.
 * @source R. Floyd, L. Steinberg, "An adaptive algorithm for spatial greyscale", 1976, with
 * vectors, in three dimensions.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_diffuser_create(uint32_t width, uint32_t height,
                                               uint32_t material_count, const double pitch_mm[3],
                                               const sf_allocator *allocator,
                                               sf_diffuser **diffuser);

/**
 * Free a diffuser.
 *
 * @param diffuser  the diffuser, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this diffuser.
 * @since 0.1
 */
SF_API void sf_diffuser_destroy(sf_diffuser *diffuser);

/**
 * Halftone the next slice up.
 *
 * @param diffuser   what the slices below left over
 * @param tones      of the diffuser's width and height; x0, y0 and layer are not looked at
 * @param materials  receives materials; bits past the width become zero
 * @return as sf_halftone_slice(), but never SF_ERR_CANCELLED; SF_ERR_SHAPE also where width or
 * height differ from the diffuser's.
 * @cost some 20 operations for each voxel and material, one after the other. No memory.
 * @threads one at a time for each diffuser.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_diffuser_slice(sf_diffuser *diffuser, const sf_tones *tones,
                                              const sf_materials *materials);

/**
 * What became of the tones so far.
 *
 * @param diffuser  the diffuser
 * @param report    receives one entry for each material
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer.
 * @cost one pass over its memory.   @threads one at a time for each diffuser.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_diffuser_report(const sf_diffuser *diffuser, sf_diffusion *report);

// ---------------------------------------------------------------------------------------------
// Shells
// ---------------------------------------------------------------------------------------------

/** The voxels near the surface of a mesh, a slice at a time. */
typedef struct sf_shell sf_shell;

/**
 * Prepare to find the voxels that come nearer than a distance to the surface of a mesh.
 *
 * Conservative: with S the voxels whose closed boxes the surface touches, the shell is S and each
 * voxel whose box is less than the distance from the box of one of S. So no point of any other
 * voxel is nearer to the surface than the distance, wherever within its voxels the surface runs,
 * but for the 1/256 voxel to which sf_voxelizer_create() rounds corners.
 *
 * @param mesh         vertices in mm; its arrays must outlive the shell
 * @param lattice      where voxels lie; copied
 * @param distance_mm  0 (S itself) or more; its reach may be at most 255 voxels along each axis
 * @param allocator    for the voxeliser, a slice for each layer within reach, and four more; NULL
 *                     for the C library's
 * @param shell        receives the object
 * @param fault        NULL, or receives a sentence on failure
 * @return SF_OK; what sf_lattice_validate() and sf_voxelizer_create() say; SF_ERR_ARGUMENT: a NULL
 * pointer, a distance that is negative or no number; SF_ERR_OVERFLOW: a reach above 255 voxels;
 * SF_ERR_MEMORY.
 * @cost as sf_voxelizer_create().   @threads any; one at a time for each allocator.
 * @source M. Schwarz, H.-P. Seidel, "Fast parallel surface and solid voxelization on GPUs", 2010.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_shell_create(sf_mesh_view mesh, const sf_lattice *lattice,
                                            double distance_mm, const sf_allocator *allocator,
                                            sf_shell **shell, sf_fault *fault);

/**
 * Free a shell.
 *
 * @param shell  the shell, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this shell.
 * @since 0.1
 */
SF_API void sf_shell_destroy(sf_shell *shell);

/**
 * The shell's voxels in layer k: the same bytes in whatever order layers are asked for.
 *
 * @param shell  the shell
 * @param k      layer, below the lattice's nz
 * @param slice  nx by ny voxels; what it held is lost
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a slice that is none, a layer out of range;
 * SF_ERR_SHAPE: a slice that is not nx by ny.
 * @cost the surface voxels of layers not yet at hand, and a dilation for each layer within reach.
 * @threads one at a time for each shell.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_shell_slice(sf_shell *shell, uint32_t k, sf_slice slice);

// ---------------------------------------------------------------------------------------------
// How much of what
// ---------------------------------------------------------------------------------------------

/** How much of a material a part takes. */
typedef struct sf_material_use {
    uint64_t voxels;   /**< how many */
    double volume_mm3; /**< of these */
    double mass_g;     /**< by its density; 0 without one */
} sf_material_use;

/**
 * Voxels, volume and grams of each material, from the counts of each layer.
 *
 * @param lattice         where voxels lie; its heights count
 * @param counts          lattice->nz times material_count numbers: those of sf_materials, layer
 *                        after layer
 * @param material_count  1..255
 * @param density_g_cm3   of each material, 0 or more; NULL: no masses, 0
 * @param uses            receives one entry for each material
 * @return SF_OK; what sf_lattice_validate() says; SF_ERR_ARGUMENT: a NULL pointer, a number of
 * materials or a density out of range; SF_ERR_OVERFLOW: more voxels than 64 bits count.
 * @cost one pass over the counts, in their order: the same bytes everywhere.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_material_uses(const sf_lattice *lattice, const uint64_t *counts,
                                             uint32_t material_count, const double *density_g_cm3,
                                             sf_material_use *uses);

#ifdef __cplusplus
}
#endif

#endif
