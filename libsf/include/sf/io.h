// SPDX-License-Identifier: MIT
// Files: meshes in and out, stacks of pictures in and out, and saving without ever leaving half a
// file.
//
// Readers and writers work on sources and sinks and see no path. The one exception is the pair
// sf_file / sf_save, which is how a program turns a path into a source or a sink.

#ifndef SF_IO_H
#define SF_IO_H

#include <sf/mesh.h>
#include <sf/support.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Mesh file formats. */
typedef enum sf_mesh_format {
    SF_MESH_FORMAT_AUTO = 0, /**< reading: judge by the bytes, then by the name */
    SF_MESH_FORMAT_STL = 1,
    SF_MESH_FORMAT_OBJ = 2,
    SF_MESH_FORMAT_PLY = 3,
    SF_MESH_FORMAT_OFF = 4
} sf_mesh_format;

/** Bounds on what a reader takes. Fill with sf_read_limits_default(). */
typedef struct sf_read_limits {
    size_t struct_size;
    uint64_t bytes_max;   /**< most bytes read from the source (default 8 GiB) */
    size_t triangles_max; /**< most triangles (default 1e9, and what size_t holds) */
    size_t vertices_max;  /**< most vertices (default UINT32_MAX) */
} sf_read_limits;

SF_API sf_read_limits sf_read_limits_default(void);

/** Format that a file name's extension names; SF_MESH_FORMAT_AUTO when it names none. */
SF_API sf_mesh_format sf_mesh_format_from_name(const char *name);

/** Read a mesh. `limits` NULL means the defaults. On failure *mesh is untouched. */
SF_API SF_CHECKED sf_status sf_mesh_read(sf_source source, sf_mesh_format format,
                                         const sf_read_limits *limits,
                                         const sf_allocator *allocator, sf_mesh **mesh,
                                         sf_fault *fault);

/** Write a mesh: binary STL, OBJ, or binary little-endian PLY. */
SF_API SF_CHECKED sf_status sf_mesh_write(sf_mesh_view mesh, sf_mesh_format format, sf_sink sink);

/** A folder as a stack sees it: named files, each read or written whole. */
typedef struct sf_folder {
    /** Open file `name` for reading. SF_ERR_IO when it is not there. */
    sf_status (*open)(void *user, const char *name, sf_source *source);
    /** Done with a source from `open`. */
    void (*close)(void *user, sf_source source);
    /** Begin file `name`; nothing shows under that name until `commit`. */
    sf_status (*begin)(void *user, const char *name, sf_sink *sink);
    /** Finish the file begun last: publish it (keep != 0) or drop it. */
    sf_status (*commit)(void *user, int keep);
    void *user;
} sf_folder;

/** The rule that a stack was made under, as stack.json carries it. */
typedef struct sf_stack_info {
    int has_rule;
    sf_rule_kind rule;
    double angle_rad;
    uint32_t bed_layer; /**< layer that rests on the bed: the rule's phase counts from layer 0 */
} sf_stack_info;

/** 1 when this build writes and reads PNG, 0 when stacks are PBM. */
SF_API int sf_stack_has_png(void);

/** Write a grid as layer_00000.png ... and stack.json (last). */
SF_API SF_CHECKED sf_status sf_stack_write(const sf_grid *grid, const sf_stack_info *info,
                                           sf_folder folder, sf_task *task, sf_fault *fault);

/** Read a stack back. */
SF_API SF_CHECKED sf_status sf_stack_read(sf_folder folder, const sf_allocator *allocator,
                                          sf_task *task, sf_grid **grid, sf_stack_info *info,
                                          sf_fault *fault);

/** Write an 8-bit RGB picture as PNG. SF_ERR_UNSUPPORTED in a build without PNG. */
SF_API SF_CHECKED sf_status sf_png_write_rgb(const uint8_t *pixels, uint32_t width, uint32_t height,
                                             sf_sink sink);

/** A file being read. */
typedef struct sf_file sf_file;
SF_API SF_CHECKED sf_status sf_file_open(const char *path, const sf_allocator *allocator,
                                         sf_file **file, sf_fault *fault);
SF_API sf_source sf_file_source(sf_file *file);
SF_API void sf_file_close(sf_file *file);

/** A file being written: nothing shows under its path until sf_save_commit() (temporary, fsync,
 * rename). */
typedef struct sf_save sf_save;
SF_API SF_CHECKED sf_status sf_save_begin(const char *path, const sf_allocator *allocator,
                                          sf_save **save, sf_fault *fault);
SF_API sf_sink sf_save_sink(sf_save *save);
/** Publish the file; on failure the old file, if any, is untouched. Frees save either way. */
SF_API SF_CHECKED sf_status sf_save_commit(sf_save *save, sf_fault *fault);
/** Drop what was written and free save; NULL does nothing. */
SF_API void sf_save_abort(sf_save *save);

/** A folder of the disk, read or written. */
typedef struct sf_directory sf_directory;
SF_API SF_CHECKED sf_status sf_directory_read(const char *path, const sf_allocator *allocator,
                                              sf_directory **directory, sf_fault *fault);
SF_API SF_CHECKED sf_status sf_directory_write(const char *path, const sf_allocator *allocator,
                                               sf_directory **directory, sf_fault *fault);
SF_API sf_folder sf_directory_folder(sf_directory *directory);
SF_API SF_CHECKED sf_status sf_directory_commit(sf_directory *directory, sf_fault *fault);
SF_API void sf_directory_close(sf_directory *directory);

#ifdef __cplusplus
}
#endif

#endif
