// SPDX-License-Identifier: MIT
// Files: meshes in and out, stacks of pictures in and out, and saving without ever leaving half a
// file.
//
// Readers and writers work on sources and sinks and see no path. The exceptions are the three types
// at the end, which is how a program turns a path into them: sf_file (a file being read), sf_save
// (a file being written) and sf_directory (a folder, read or written).
//
// These functions are in libsf-io, a library of its own beside libsf.

#ifndef SF_IO_H
#define SF_IO_H

#include <sf/certificate.h>
#include <sf/mesh.h>
#include <sf/support.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Meshes
// ---------------------------------------------------------------------------------------------

/** Mesh file formats. */
typedef enum sf_mesh_format {
    SF_MESH_FORMAT_AUTO = 0, /**< reading only: judge by the bytes */
    SF_MESH_FORMAT_STL = 1,  /**< text and binary in, binary out */
    SF_MESH_FORMAT_OBJ = 2,  /**< in and out */
    SF_MESH_FORMAT_PLY = 3,  /**< text and both binary orders in, binary little-endian out */
    SF_MESH_FORMAT_OFF = 4,  /**< text, in only */
    SF_MESH_FORMAT_THREEMF =
        5, /**< .3mf in and out, where sf_threemf_is_served(): <sf/threemf.h> */
    SF_MESH_FORMAT_GLTF =
        6 /**< .glb and .gltf in, where sf_gltf_is_served(); .glb out: <sf/gltf.h> */
} sf_mesh_format;

/** Bounds on what a reader takes. Fill with sf_read_limits_default(). */
typedef struct sf_read_limits {
    size_t struct_size;   /**< sizeof(sf_read_limits), set by the default */
    uint64_t bytes_max;   /**< most bytes read from the source (default 8 GiB) */
    size_t triangles_max; /**< most triangles (default 1e9) */
    size_t
        vertices_max; /**< most vertices, corners of STL facets one by one (default UINT32_MAX) */
} sf_read_limits;

/**
 * The default bounds: 8 GiB, 1e9 triangles, UINT32_MAX vertices.
 *
 * @return the limits, by value, with struct_size set.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_read_limits sf_read_limits_default(void);

/**
 * The mesh format that the extension of a file name stands for.
 *
 * @param name  a file name or a path, upper or lower case; NULL is allowed
 * @return the format; SF_MESH_FORMAT_AUTO when the name ends in none of .stl .obj .ply .off
 * .3mf .glb .gltf.
 * @cost the length of the name.   @threads any.
 * @since 0.1
 */
SF_API sf_mesh_format sf_mesh_format_from_name(const char *name);

/**
 * Read a mesh from any source of bytes: STL, OBJ, PLY, OFF, 3MF or glTF.
 *
 * Coordinates are taken as they are, as mm. Polygons become fans about their first corner. What is
 * no triangle and no vertex (normals, colours, materials, lines, unknown elements) is passed over.
 * STL has no shared vertices, so every facet brings three of its own; sf_mesh_merge() joins them.
 * Of 3MF, which has units and a build, the whole build becomes one mesh in mm, as
 * sf_threemf_read() and sf_threemf_merge() do it.
 *
 * glTF says which way is up: it is turned to mm with z up, as sf_gltf_read()
 * says, which also reads buffers in other files. Its text form is not told from others by its
 * bytes.
 *
 * No count in a file is believed: memory grows as the bytes come. A binary STL file is as long as
 * its count says or longer (a count of 0 or 2^32 - 1 means: to the end); text STL ends with
 * endsolid; a file that is shorter is refused, because half a part looks like a whole one. So are
 * coordinates that are not finite, faces of fewer than three corners, corners that name no vertex,
 * and files without a triangle. Numbers are read exactly, whatever the locale.
 *
 * @param source     the file; read to where the mesh ends, or somewhat beyond
 * @param format     the format, or SF_MESH_FORMAT_AUTO to judge by the first 4096 bytes
 * @param limits     NULL for sf_read_limits_default()
 * @param allocator  for the mesh and for reading; NULL for the C library's
 * @param mesh       where the new mesh is left, to be destroyed by the caller; untouched on failure
 * @param fault      NULL, or filled on failure: what is wrong, at which line (of text files) and
 * byte, and what to do
 * @return SF_OK; SF_ERR_FORMAT: the bytes are no mesh; SF_ERR_UNSUPPORTED: glTF or 3MF
 * that sf_gltf_read() or sf_threemf_read() do not serve; SF_ERR_OVERFLOW: more than `limits`;
 * SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer or an unknown format; or what the source returned.
 * @cost one pass over the file; while it grows, memory for two and a half times the mesh.
 * @threads any, on distinct sources; one at a time for each allocator.
 * @source 3D Systems, "StereoLithography Interface Specification", 1989; Wavefront, "Object Files";
 * G. Turk, "The PLY Polygon File Format", 1994; the Geomview manual, "OFF Files".
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_read(sf_source source, sf_mesh_format format,
                                         const sf_read_limits *limits,
                                         const sf_allocator *allocator, sf_mesh **mesh,
                                         sf_fault *fault);

/**
 * Write a mesh as binary STL, OBJ, binary little-endian PLY, 3MF or binary glTF.
 *
 * OBJ and PLY keep every bit of every coordinate: OBJ as the fewest of 15 to 17 digits that read
 * back as the same double, PLY as doubles. STL has floats and unit normals; vertices that are equal
 * stay equal. glTF is what sf_gltf_write() writes, without colours; 3MF has one object, as
 * sf_threemf_write() writes it. Everything is checked before the first byte is written.
 *
 * @param mesh    the mesh; what sf_mesh_validate() takes
 * @param format  SF_MESH_FORMAT_STL, _OBJ, _PLY, _THREEMF or _GLTF
 * @param sink    where the bytes go; on failure it may have had some
 * @return SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: no sink or no format;
 * SF_ERR_UNSUPPORTED: SF_MESH_FORMAT_OFF, or 3MF in a build without; SF_ERR_OVERFLOW: for STL and
 * glTF, a coordinate beyond the range of floats, more than UINT32_MAX triangles, and for glTF and
 * 3MF a file of 4 GiB; SF_ERR_MEMORY: for 3MF; or what the sink returned.
 * @cost one pass to check, one to write; 8 KiB of stack, and 300 KiB of memory for 3MF alone.
 * @threads any, on distinct sinks.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mesh_write(sf_mesh_view mesh, sf_mesh_format format, sf_sink sink);

// ---------------------------------------------------------------------------------------------
// Stacks of pictures
// ---------------------------------------------------------------------------------------------

/**
 * A folder as a stack sees it: named files, each read or written whole, one at a time.
 *
 * A folder that is only written may leave `open` and `close` NULL, one that is only read the
 * others. sf_directory_folder() makes one of a folder of the disk.
 */
typedef struct sf_folder {
    /** Open file `name` for reading. SF_ERR_IO when it is not there. */
    sf_status (*open)(void *user, const char *name, sf_source *source);
    /** Done with a source from `open`. */
    void (*close)(void *user, sf_source source);
    /** Begin file `name`; nothing shows under that name until `commit`. */
    sf_status (*begin)(void *user, const char *name, sf_sink *sink);
    /** Finish the file begun last: publish it (keep != 0) or drop it. */
    sf_status (*commit)(void *user, int keep);
    void *user; /**< handed to all four; may be NULL */
} sf_folder;

/** The rule that a stack was made under, as stack.json carries it. */
typedef struct sf_stack_info {
    int has_rule;          /**< 0: the stack says nothing of a rule, and the rest is 0 */
    sf_rule_kind rule;     /**< which rule */
    double angle_rad;      /**< its overhang angle, SF_RULE_ANGLE_MIN_RAD to _MAX_RAD; box3: 0 */
    uint32_t bed_layer;    /**< layer that rests on the bed, or SF_BED_AUTO; the rule's phase counts
                              from layer 0 */
    double bridge_span_mm; /**< bridges of the rule, 0: none; see sf_rule_set_bridges() */
    double bridge_anchor_mm; /**< carried matter that each end of one must have */
} sf_stack_info;

/**
 * Whether this build writes and reads PNG.
 *
 * @return 1 when it does; 0 when stacks are written as PBM, PNG stacks cannot be read, and
 * sf_png_write_rgb() does not work.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API int sf_stack_has_png(void);

/**
 * Write a grid as a stack: layer_00000.png and so on from the bottom, and last stack.json.
 *
 * Each picture has nx by ny pixels, one bit of grey each: white is solid. It shows the layer from
 * above: x to the right, y upward, so its top row is the largest y. In a build without PNG the
 * pictures are PBM (P4), layer_00000.pbm. stack.json says it all:
 *
 *     {"format": "libsf-stack", "version": 1, "units": "mm",
 *      "lattice": {"nx", "ny", "nz", "pitch_mm": [x, y],
 *                  "layer_mm" or "heights_mm": [...], "origin_mm": [x, y, z]},
 *      "rule": null or {"kind": "box3" | "octagon" | "disk" | "slack",
 *                       "angle_deg", "angle_rad", "bridge_mm": [span, anchor], "bed_layer",
 *                       "phase_layer": 0},
 *      "layers": {"pattern": "layer_%05u.png", "count": nz},
 *      "solid": "white", "row_order": "top_is_max_y"}
 *
 * Its numbers read back as the same doubles. angle_deg is for people: the reader takes angle_rad;
 * box3 has neither. bridge_mm is there only where the rule has bridges, and then the version is 2.
 * bed_layer is null for SF_BED_AUTO. phase_layer is the layer that the rule's phase counts from (an
 * octagon's steps differ from layer to layer); so far that is always 0, so a reader takes nothing
 * else, and 0 where it is absent. A folder without stack.json is no stack, so a call that fails
 * leaves none in a folder that had none; over sf_directory_write() it leaves nothing at all.
 *
 * @param grid    the shape
 * @param info    the rule it was made under, or NULL
 * @param folder  where to; needs `begin` and `commit`
 * @param task    NULL, or progress per layer and a cancel between layers
 * @param fault   NULL, or filled on failure with the file that could not be written
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, or a rule, angle or bed layer that there is not;
 * SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_INTERNAL: libspng refuses what it should take; or what
 * the folder or its sinks returned.
 * @cost one pass over the grid, mostly in the compressor; 12 KiB of stack. libspng and zlib take
 * some 300 KiB from the C library, because they know no other allocators.
 * @threads any that only read the grid, on distinct folders.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_stack_write(const sf_grid *grid, const sf_stack_info *info,
                                           sf_folder folder, sf_task *task, sf_fault *fault);

/**
 * Read a stack back: the grid, its lattice, and the rule it was made under.
 *
 * Layers of materials (<sf/layers.h>) are read as what is solid. Pictures may also be grey of 2 to
 * 8 bits, as picture editors save them: half-way and above is solid. Before memory is taken for the
 * grid, every picture that stack.json claims must be there with the claimed size. Fields of
 * stack.json that are not known are passed over.
 *
 * @param folder     where from; needs `open` and `close`
 * @param allocator  for the grid and for reading; NULL for the C library's
 * @param task       NULL, or progress per layer and a cancel between layers
 * @param grid       where the new grid is left, to be destroyed by the caller; untouched on failure
 * @param info       NULL, or where the rule is left; untouched on failure
 * @param fault      NULL, or filled on failure: which file, what is wrong, what to do
 * @return SF_OK; SF_ERR_FORMAT: stack.json or a picture is damaged, or they disagree;
 * SF_ERR_UNSUPPORTED: a version, rule or kind of picture that this build does not know, or a build
 * without jansson, which reads no stacks; SF_ERR_OVERFLOW: larger than this machine addresses;
 * SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_INTERNAL: libspng
 * refuses what it should take; SF_ERR_IO: a source that claims more than it was asked for; or what
 * the folder or its sources returned.
 * @cost two opens of each picture, one pass over their bytes. jansson, libspng and zlib take memory
 * from the C library, in proportion to stack.json (at most 64 MiB) and to a row.
 * @threads any, on distinct folders; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_stack_read(sf_folder folder, const sf_allocator *allocator,
                                          sf_task *task, sf_grid **grid, sf_stack_info *info,
                                          sf_fault *fault);

/**
 * Write a certificate as JSON, for sf-verify and whoever else wants to check it.
 *
 * docs/certificate.md says what each field holds. The last one is the SHA-256 of every byte before
 * it, so the file is to be kept as it is: the same JSON in other words is refused.
 *
 * @param certificate  the certificate
 * @param sink         where the bytes go; on failure it may have had some
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; or what the sink returned.
 * @cost the length of the file; 12 KiB of stack, no memory.   @threads any, on distinct sinks.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_certificate_write(const sf_certificate *certificate, sf_sink sink);

/**
 * Write a colour picture as PNG, eight bits of red, green and blue a pixel.
 *
 * @param pixels  3 * width * height bytes: red, green, blue, row after row from the top
 * @param width   1..SF_EXTENT_MAX
 * @param height  1..SF_EXTENT_MAX
 * @param sink    where the bytes go; on failure it may have had some
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer or a size outside its range; SF_ERR_UNSUPPORTED: a
 * build without PNG; SF_ERR_MEMORY; SF_ERR_INTERNAL: libspng refuses what it should take; or what
 * the sink returned.
 * @cost one pass, mostly in the compressor, which takes its memory from the C library.
 * @threads any, on distinct sinks.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_png_write_rgb(const uint8_t *pixels, uint32_t width, uint32_t height,
                                             sf_sink sink);

// ---------------------------------------------------------------------------------------------
// Paths
// ---------------------------------------------------------------------------------------------

/** A file being read. */
typedef struct sf_file sf_file;

/**
 * Open a file for reading.
 *
 * @param path       path of the file, as the C library takes it
 * @param allocator  for the object; NULL for the C library's
 * @param file       where the open file is left, to be closed by the caller; untouched on failure
 * @param fault      NULL, or filled on failure with the path and the reason
 * @return SF_OK; SF_ERR_IO: it is not there, is a folder, or may not be read; SF_ERR_MEMORY;
 * SF_ERR_ARGUMENT: a NULL pointer.
 * @cost constant.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_file_open(const char *path, const sf_allocator *allocator,
                                         sf_file **file, sf_fault *fault);

/**
 * The source that reads an open file, from where it stands to its end.
 *
 * @param file  the file; NULL gives a source without `read`
 * @return the source; valid until the file is closed. It returns SF_ERR_IO when the disk fails.
 * @cost constant.   @threads one per file.
 * @since 0.1
 */
SF_API sf_source sf_file_source(sf_file *file);

/**
 * Close a file.
 *
 * @param file  the file, freed; NULL does nothing
 * @cost constant.   @threads one per file.
 * @since 0.1
 */
SF_API void sf_file_close(sf_file *file);

/** A file being written: nothing shows under its path until sf_save_commit(). */
typedef struct sf_save sf_save;

/**
 * Begin to write a file, without touching what stands at its path.
 *
 * The bytes go to a new file beside it, PATH.sf-PROCESS-NUMBER.tmp, until sf_save_commit() renames
 * that. A symbolic link at the path is replaced by the file, not followed.
 *
 * @param path       path of the file; what stands there must be an ordinary file or nothing
 * @param allocator  for the object; NULL for the C library's
 * @param save       where the object is left, for sf_save_commit() or sf_save_abort(); untouched on
 *                   failure
 * @param fault      NULL, or filled on failure with the path and the reason
 * @return SF_OK; SF_ERR_IO: a folder or a device stands there, or no file can be made beside it;
 * SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer or an empty path.
 * @cost constant.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_save_begin(const char *path, const sf_allocator *allocator,
                                          sf_save **save, sf_fault *fault);

/**
 * The sink that writes a file being saved.
 *
 * @param save  the file; NULL gives a sink without `write`
 * @return the sink; valid until the commit or abort. After a failed write it takes nothing more.
 * @cost constant.   @threads one per file.
 * @since 0.1
 */
SF_API sf_sink sf_save_sink(sf_save *save);

/**
 * Publish a file: sync it to the disk, rename it over its path, sync the folder.
 *
 * Whoever opens the path at any time finds the old file or the new one, whole; on failure the old
 * one, and the new one is gone. The new file has the access rights of the old.
 *
 * @param save   the file; freed, whatever is returned
 * @param fault  NULL, or filled on failure with the path and the reason
 * @return SF_OK; SF_ERR_IO: a write or the sync failed, or the path cannot be replaced;
 * SF_ERR_ARGUMENT: NULL.
 * @cost a sync of the disk.   @threads one per file.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_save_commit(sf_save *save, sf_fault *fault);

/**
 * Drop a file being saved; what stands at its path stays.
 *
 * @param save  the file, freed; NULL does nothing
 * @cost constant.   @threads one per file.
 * @since 0.1
 */
SF_API void sf_save_abort(sf_save *save);

/** A folder of the disk, being read or being written. */
typedef struct sf_directory sf_directory;

/**
 * Open a folder for reading its files.
 *
 * @param path       path of the folder
 * @param allocator  for the object and the files it opens; NULL for the C library's
 * @param directory  where the object is left, for sf_directory_close(); untouched on failure
 * @param fault      NULL, or filled on failure with the path and the reason
 * @return SF_OK; SF_ERR_IO: it is not there or no folder; SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL
 * pointer or an empty path.
 * @cost constant.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_directory_read(const char *path, const sf_allocator *allocator,
                                              sf_directory **directory, sf_fault *fault);

/**
 * Begin to write a folder of files, without touching what stands at its path.
 *
 * The files go to a new folder beside it, PATH.sf-PROCESS-NUMBER.tmp, until sf_directory_commit()
 * renames that. Only an empty folder or an earlier stack is replaced: a folder that holds
 * stack.json, pictures named like layers, and nothing else.
 *
 * @param path       path of the folder to be; its parent exists
 * @param allocator  for the object; NULL for the C library's
 * @param directory  where the object is left, for sf_directory_commit() or sf_directory_close();
 *                   untouched on failure
 * @param fault      NULL, or filled on failure with the path and the reason
 * @return SF_OK; SF_ERR_IO: something else stands there, or no folder can be made beside it;
 * SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer or an empty path.
 * @cost the number of entries of the folder that stands there.   @threads any; one at a time for
 * each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_directory_write(const char *path, const sf_allocator *allocator,
                                               sf_directory **directory, sf_fault *fault);

/**
 * The folder that a stack is read from or written to.
 *
 * File names are plain: no separators, no "..". Each file is synced to the disk as it is committed.
 *
 * @param directory  the folder; NULL gives a folder without functions
 * @return the folder; valid until the commit or close. One file is written at a time; `begin`
 * returns SF_ERR_ARGUMENT for a second one, for a name that is not plain, and for a folder being
 * read.
 * @cost constant.   @threads one per folder.
 * @since 0.1
 */
SF_API sf_folder sf_directory_folder(sf_directory *directory);

/**
 * Publish a folder: rename it to its path, in place of an empty folder or an earlier stack.
 *
 * An earlier stack is first renamed aside (PATH.sf-PROCESS-NUMBER.old) and removed when the new one
 * stands: a crash in between leaves both, whole. On failure the old one stays and the new one is
 * gone.
 *
 * @param directory  a folder from sf_directory_write(); freed, whatever is returned
 * @param fault      NULL, or filled on failure with the path and the reason
 * @return SF_OK; SF_ERR_IO: the path cannot be replaced, or now holds something else;
 * SF_ERR_MEMORY; SF_ERR_ARGUMENT: NULL, or a folder being read.
 * @cost a sync of the disk, and the number of files of an earlier stack.   @threads one per folder.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_directory_commit(sf_directory *directory, sf_fault *fault);

/**
 * Close a folder being read, or drop one being written; what stands at its path stays.
 *
 * @param directory  the folder, freed; NULL does nothing
 * @cost for one being written, the number of its files; it needs no memory.   @threads one per
 * folder.
 * @since 0.1
 */
SF_API void sf_directory_close(sf_directory *directory);

#ifdef __cplusplus
}
#endif

#endif
