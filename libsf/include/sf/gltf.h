// SPDX-License-Identifier: MIT
// glTF 2.0: meshes of the web and of modelling programs, in and out.
//
// A glTF file is a scene: a tree of nodes, each with a place of its own, that carry meshes. What is
// read of it is what would be seen of it standing still: the triangles of the scene, each where its
// nodes put it. glTF is in metres with y up; here everything is in mm with z up, so what is read
// is turned upright and enlarged, (x, y, z) to 1000 (x, -z, y), and what is written is turned back.
//
// Reading wants tinygltf, and a build without it says so; writing wants nothing.

#ifndef SF_GLTF_H
#define SF_GLTF_H

#include <sf/io.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Whether this build reads glTF.
 *
 * @return 1 where it has tinygltf, else 0.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API int sf_gltf_is_served(void);

/** How glTF is read. Fill with sf_gltf_options_default(). */
typedef struct sf_gltf_options {
    size_t struct_size;      /**< sizeof(sf_gltf_options), set by the default */
    sf_read_limits limits;   /**< most bytes, those of the folder's files included; most triangles
                                and vertices */
    const sf_folder *folder; /**< where buffers outside of the file are, read with `open` and
                                `close`; NULL: there are none */
} sf_gltf_options;

/**
 * The default: sf_read_limits_default(), and no folder.
 *
 * @return the options, by value, with struct_size set.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_gltf_options sf_gltf_options_default(void);

/** What was read of a glTF file, and what was passed over. */
typedef struct sf_gltf_report {
    size_t nodes;   /**< nodes of the scene */
    size_t pieces;  /**< sets of triangles that were placed */
    size_t passed;  /**< sets of points and lines: passed over */
    size_t skinned; /**< nodes with a skin, whose meshes are taken as modelled, not as posed */
    size_t morphed; /**< sets of triangles with other shapes to blend to, which are not blended */
    size_t animations; /**< animations of the file, none of which is played */
} sf_gltf_report;

/**
 * Read a glTF file, binary (.glb) or as text (.gltf), as one mesh, in mm with z up.
 *
 * The mesh holds the triangles of the scene that the file shows first (without scenes, of all
 * nodes), one vertex for each that the file has, times the nodes that show it; strips and fans
 * become triangles; a node that mirrors turns its triangles, so that outside stays outside.
 * Materials, colours, pictures, cameras and lights are passed over; skins, animations and shapes to
 * blend to as well, and the report counts them. Positions may be interleaved, sparse, and whole
 * numbers (KHR_mesh_quantization). Refused are files that require extensions which change the shape
 * and are not served, such as compressed meshes.
 *
 * No path is followed. A buffer may stand in the file itself or be a data: URI; another file's name
 * is asked of `folder` only if it is plain (no separators, no "..", no scheme). Pictures are not
 * decoded, and files named like them not opened. Before tinygltf sees it, JSON is held against
 * bounds: 64 levels, 200,000 objects and lists, 2 million values; so its memory, which comes from
 * the C++ library, is some hundred MiB at most beside a few times the file. But it was not made for
 * files that mean harm, and ends the process where memory is too short to destroy its JSON: read
 * files of strangers in a process of its own. Nodes may repeat a mesh,
 * up to 64 times the bytes of the file and 256 MiB.
 *
 * @param source     the file, read to its end
 * @param options    NULL for sf_gltf_options_default()
 * @param allocator  for the mesh and for reading; NULL for the C library's
 * @param mesh       where the new mesh is left, to be destroyed by the caller; untouched on failure
 * @param report     NULL, or what was passed over; untouched on failure
 * @param fault      NULL, or filled on failure: what is wrong and what to do
 * @return SF_OK; SF_ERR_FORMAT: no glTF 2.0, damaged, coordinates that are not finite, no
 * triangles; SF_ERR_UNSUPPORTED: a required extension that is not served, a build without tinygltf;
 * SF_ERR_OVERFLOW: more than the limits; SF_ERR_MEMORY; SF_ERR_IO: a buffer's file is not there or
 * its name is not plain; SF_ERR_ARGUMENT: a NULL pointer; or what a source returned.
 * @cost one pass; the file is held in memory, its buffers twice for a while.
 * @threads any, on distinct sources; one at a time for each allocator.
 * @source The Khronos Group, "glTF 2.0 Specification", 2021.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_gltf_read(sf_source source, const sf_gltf_options *options,
                                         const sf_allocator *allocator, sf_mesh **mesh,
                                         sf_gltf_report *report, sf_fault *fault);

/**
 * Write a mesh as binary glTF, with a colour for each vertex or without.
 *
 * Positions are floats in mm; a node turns them to glTF's axes and metres. What sf_gltf_read()
 * makes of the file is the same floats again. Colours are given as they are shown on a screen
 * (sRGB) and written as light (linear, 16 bits), which is how glTF has them. The material is matt
 * and seen from both sides.
 *
 * @param mesh    the mesh; what sf_mesh_validate() takes, with triangles
 * @param colors  NULL, or 3 * vertex_count bytes: red, green, blue of each vertex
 * @param sink    where the bytes go; on failure it may have had some
 * @return SF_OK; what sf_mesh_validate() says; SF_ERR_ARGUMENT: no sink, no triangles;
 * SF_ERR_OVERFLOW: a coordinate beyond the range of floats, or a file of 4 GiB; or what the sink
 * returned.
 * @cost one pass to check, one to write; 8 KiB of stack, no memory.   @threads any, on distinct
 * sinks.
 * @source The Khronos Group, "glTF 2.0 Specification", 2021; IEC 61966-2-1, "sRGB", 1999.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_gltf_write(sf_mesh_view mesh, const uint8_t *colors, sf_sink sink);

#ifdef __cplusplus
}
#endif

#endif
