// SPDX-License-Identifier: MIT
// 3MF: what slicers and printers exchange, read and written as a whole.
//
// A 3MF file is a zip archive with XML in it: objects of triangles, what they are made of, and a
// build, which says where each object goes. sf_mesh_read() makes one mesh of the build, and
// sf_mesh_write() a file of one mesh; here is the rest: objects one by one, materials and colours,
// and what a program says of a solid beside its surface.
//
// Read are the core specification and its extensions production, materials and colours, and slices.
// A file that requires another one is refused, because half a part looks like a whole one: beam
// lattices, implicit functions, encryption. Nothing in a file is ever acted on: no metadata is
// looked at, no path leads out of the archive, XML has no entities of its own, and what a file may
// unfold to is bounded.
//
// These functions are in libsf-io. A build without expat and zlib has them too, and they
// return SF_ERR_UNSUPPORTED.

#ifndef SF_THREEMF_H
#define SF_THREEMF_H

#include <sf/contour.h>
#include <sf/io.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What stands for no colour and no stack. */
#define SF_THREEMF_NONE UINT32_MAX

/** What an object is for, as its file says. */
typedef enum sf_threemf_kind {
    SF_THREEMF_MODEL = 0,         /**< a part */
    SF_THREEMF_SOLID_SUPPORT = 1, /**< a support that is printed as it is */
    SF_THREEMF_SUPPORT = 2,       /**< a support that the printer's program makes solid */
    SF_THREEMF_SURFACE = 3,       /**< a surface without an inside */
    SF_THREEMF_OTHER = 4          /**< anything else, which is not printed */
} sf_threemf_kind;

/** A material, or a colour of a group. */
typedef struct sf_threemf_colour {
    const char *name; /**< of a base material; "" for a colour of a group */
    uint8_t rgba[4];  /**< red, green, blue, and 255 for opaque; sRGB */
    uint32_t group;   /**< colours of one group of the file have the same number, from 0 */
} sf_threemf_colour;

/** An object that has triangles of its own. */
typedef struct sf_threemf_object {
    const char *name;        /**< as the file says, or "" */
    sf_threemf_kind kind;    /**< what it is for */
    sf_mesh_view mesh;       /**< in mm, in the object's own axes */
    const uint32_t *colours; /**< 3 for each triangle, of its corners: numbers of colours, or
                                  SF_THREEMF_NONE; NULL where no triangle has any */
    uint32_t stack;          /**< number of its stack of slices, or SF_THREEMF_NONE */
    int is_rough;            /**< 1 where the file says that the triangles only stand for slices */
} sf_threemf_object;

/** An object in its place on the printer's bed. Components are resolved: each of them is one. */
typedef struct sf_threemf_item {
    uint32_t object;     /**< number of the object */
    sf_transform placed; /**< from the object's axes to the bed's, in mm */
} sf_threemf_item;

/** A view of what a file holds; good until the document is destroyed. */
typedef struct sf_threemf_view {
    const sf_threemf_colour *colours; /**< all materials and colours of all groups */
    size_t colour_count;              /**< how many */
    const sf_threemf_object *objects; /**< those with triangles, in the order of the file */
    size_t object_count;              /**< how many */
    const sf_threemf_item *items;     /**< what is built, in the order of the file */
    size_t item_count;                /**< how many */
    size_t stack_count;               /**< how many stacks of slices objects have */
} sf_threemf_view;

/** A 3MF file that was read. */
typedef struct sf_threemf sf_threemf;

/**
 * Whether this build reads and writes 3MF.
 *
 * @return 1 where it has expat and zlib, else 0.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API int sf_threemf_is_served(void);

/**
 * Read a 3MF file whole.
 *
 * Lengths become mm, whatever the file's unit. Components become items, one for each place that
 * an object takes. Textures, composites and mixtures of properties are passed over: what they cover
 * has no colour. Metadata, thumbnails, print tickets and elements that are not known are passed
 * over too.
 *
 * What unfolds is bounded: an XML part to 250 times its size in the archive and 1 MiB, all parts
 * together to `bytes_max`, components to 64 within one another and 100,000 items. A DOCTYPE is
 * refused, and so are names that lead out of the archive, two parts with one name, objects that
 * contain themselves, transforms that flatten, and numbers that are not finite.
 *
 * @param source     the file, read to its end
 * @param limits     NULL for sf_read_limits_default(); triangles and vertices of all objects
 *                   together
 * @param allocator  for the document and for reading; NULL for the C library's, which expat
 *                   takes in any case
 * @param document   receives the document, to be destroyed by the caller; untouched on failure
 * @param fault      NULL, or filled on failure: what is wrong, in which part and line of it
 * @return SF_OK; SF_ERR_FORMAT: no 3MF file, or a damaged one; SF_ERR_UNSUPPORTED: the file
 * requires an extension that is not read, or the build reads no 3MF; SF_ERR_OVERFLOW: more than a
 * limit; SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_IO: a source that claims more than
 * it was asked for; or what the source returned.
 * @cost the file is held in memory while it is read; one pass over what its parts unfold to.
 * @threads any, on distinct sources; one at a time for each allocator.
 * @source 3MF Consortium, "3MF Core Specification" 1.3, "Production Extension" 1.1, "Materials and
 * Properties Extension" 1.2, "Slice Extension" 1.0.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_threemf_read(sf_source source, const sf_read_limits *limits,
                                            const sf_allocator *allocator, sf_threemf **document,
                                            sf_fault *fault);

/**
 * What a document holds.
 *
 * @param document  the document; NULL holds nothing
 * @return a view, good until the document is destroyed.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_threemf_view sf_threemf_get_view(const sf_threemf *document);

/**
 * One mesh of all that a document builds: parts and solid supports, in their places.
 *
 * @param document   the document
 * @param limits     NULL for sf_read_limits_default(); items repeat what they place
 * @param allocator  for the mesh; NULL for the C library's
 * @param mesh       receives the mesh, to be destroyed by the caller; untouched on failure
 * @param fault      NULL, or filled on failure
 * @return SF_OK; SF_ERR_FORMAT: nothing is built that has an inside; SF_ERR_OVERFLOW: more than a
 * limit, or a vertex that would not be finite; SF_ERR_UNSUPPORTED: triangles that only stand for
 * slices, or a build without 3MF; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_MEMORY.
 * @cost the size of the mesh.   @threads any that read; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_threemf_merge(const sf_threemf *document,
                                             const sf_read_limits *limits,
                                             const sf_allocator *allocator, sf_mesh **mesh,
                                             sf_fault *fault);

/**
 * Whether all that a document builds has slices: its parts and solid supports.
 *
 * @param document  the document; NULL has none
 * @return 1 when each of them has a stack of slices, else 0.
 * @cost the number of items.   @threads any.
 * @since 0.1
 */
SF_API int sf_threemf_is_sliced(const sf_threemf *document);

/**
 * The slices of all that a document builds, in their places: parts and solid supports.
 *
 * What is inside is what the contours wind around, SF_CONTOUR_NONZERO: the specification's fill,
 * where holes turn the other way than what they are holes in. Contours of several items stand
 * beside one another in each layer, so their layers must have the same heights.
 *
 * @param document   the document
 * @param allocator  for the stack; NULL for the C library's
 * @param stack      receives the stack, to be destroyed by the caller; untouched on failure
 * @param fault      NULL, or filled on failure
 * @return SF_OK; SF_ERR_FORMAT: something that is built has no slices, a slice that is not above
 * the one before, or a transform that tilts layers; SF_ERR_UNSUPPORTED: items whose layers have
 * other heights, or a build without 3MF; SF_ERR_ARGUMENT: a NULL pointer, heights or points beyond
 * 1e12 mm; SF_ERR_OVERFLOW: more than SF_LAYER_MAX layers; SF_ERR_MEMORY.
 * @cost the points.   @threads any that read; one at a time for each allocator.
 * @source 3MF Consortium, "3MF Slice Extension" 1.0.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_threemf_contours(const sf_threemf *document,
                                                const sf_allocator *allocator,
                                                sf_contour_stack **stack, sf_fault *fault);

/**
 * Free a document.
 *
 * @param document  the document, freed; NULL does nothing
 * @cost the number of its objects.   @threads one, and nobody else with this document.
 * @since 0.1
 */
SF_API void sf_threemf_destroy(sf_threemf *document);

// ---------------------------------------------------------------------------------------------
// Writing
// ---------------------------------------------------------------------------------------------

/** A property that varies inside an object. */
typedef struct sf_threemf_field {
    const char *name; /**< UTF-8, for people; not "" */
    double low;       /**< the value that 0 stands for */
    double high;      /**< the value that 65535 stands for, above `low` */
} sf_threemf_field;

/** Properties inside an object, on a lattice: the volumetric extension's stacks of pictures. */
typedef struct sf_threemf_volume {
    uint32_t object;                /**< number of the object that they fill */
    sf_lattice lattice;             /**< in the object's axes; heights_mm is NULL */
    size_t field_count;             /**< how many properties, 1 to 64 */
    const sf_threemf_field *fields; /**< what they are */
    uint32_t mixed_group;           /**< number of a group of base materials whose fractions are the
                                         first properties, one for each; or SF_THREEMF_NONE */
    /** Fill a layer: planes[f][y * nx + x] for each property f. Called once for each layer, from
     * the bottom up; a status other than SF_OK ends the writing and is passed on. */
    sf_status (*layer)(void *user, uint32_t k, uint16_t *const *planes);
    void *user; /**< handed to it; may be NULL */
} sf_threemf_volume;

/** What a file may hold beside its objects. Fill with sf_threemf_extras_default(). */
typedef struct sf_threemf_extras {
    size_t struct_size;              /**< sizeof(sf_threemf_extras), set by the default */
    const void *thumbnail;           /**< a picture of it, a PNG file; NULL: none */
    size_t thumbnail_size;           /**< its bytes */
    const sf_threemf_volume *volume; /**< properties inside one of the objects; NULL: none */
} sf_threemf_extras;

/**
 * Nothing beside the objects.
 *
 * @return the extras, by value, with struct_size set.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_threemf_extras sf_threemf_extras_default(void);

/**
 * Write a 3MF file: objects, their materials and colours, where they go, and what fills them.
 *
 * Coordinates are written in mm, as the fewest of 15 to 17 digits that read back as the same
 * double. Triangles with two equal corners are left out, because 3MF has none. A group whose
 * colours have names becomes base materials, another one a group of colours. Equal input gives
 * equal bytes. Everything but the volume is checked before the first byte is written.
 *
 * A volume's property is written as a stack of PNG pictures of 16 bits grey, 3D/volume_F_K.png with
 * the largest y on top, a function that makes values of them, and a property of the object's volume
 * data, in the namespace urn:libsf:property:1; fractions of materials are its composite besides.
 * Between the centres of voxels it is linear.
 *
 * @param what       objects with triangles, their colours, and items; `stack` of each is
 *                   SF_THREEMF_NONE. Colours of a triangle are of one group, or all
 *                   SF_THREEMF_NONE; base materials do not vary within a triangle
 * @param extras     NULL for sf_threemf_extras_default()
 * @param sink       where the bytes go; on failure it may have had some
 * @param allocator  for the compressor, the directory and a layer; NULL for the C library's
 * @param task       NULL, or progress per layer of a volume and a cancel between layers
 * @param fault      NULL, or filled on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, what sf_mesh_validate() or
 * sf_lattice_validate() says, an object without a triangle of three corners, a number that names
 * nothing, a name that is no UTF-8, a map that flattens, a thumbnail that is no PNG;
 * SF_ERR_UNSUPPORTED: slices, a volume in a build without PNG, or a build without 3MF;
 * SF_ERR_OVERFLOW: more than 4 GiB in the archive or in a part of it (some 40 million triangles),
 * or 65,000 layers; SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_INTERNAL: a compressor refuses what it
 * should take; or what the sink or `layer` returned.
 * @cost one pass to check and one to write, mostly in the compressor; some 300 KiB, and 2 bytes for
 * each voxel of a layer of a volume.   @threads any, on distinct sinks; one at a time for each
 * allocator.
 * @source 3MF Consortium, "3MF Core Specification" 1.3, "Volumetric Extension" 0.8.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_threemf_write(const sf_threemf_view *what,
                                             const sf_threemf_extras *extras, sf_sink sink,
                                             const sf_allocator *allocator, sf_task *task,
                                             sf_fault *fault);

#ifdef __cplusplus
}
#endif

#endif
