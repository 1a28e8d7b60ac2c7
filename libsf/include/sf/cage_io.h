// SPDX-License-Identifier: MIT
// Files of cages: control meshes in from Medit, MFEM and VTK, and out as VTK.
//
// As everywhere in libsf-io, readers and writers work on sources and sinks; sf_file and sf_save of
// <sf/io.h> turn a path into them. What comes in is a cage of <sf/cage.h>, checked as every cage.

#ifndef SF_CAGE_IO_H
#define SF_CAGE_IO_H

#include <sf/cage.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Cage file formats. */
typedef enum sf_cage_format {
    SF_CAGE_FORMAT_AUTO = 0,  /**< judge by the first words */
    SF_CAGE_FORMAT_MEDIT = 1, /**< Medit .mesh, text, versions 1 to 4 */
    SF_CAGE_FORMAT_MFEM = 2,  /**< MFEM .mesh, version 1.x, conforming */
    SF_CAGE_FORMAT_VTK = 3    /**< legacy VTK, unstructured grid, text and binary */
} sf_cage_format;

/** What a reader expects and takes at most. Fill with sf_cage_read_options_default(). */
typedef struct sf_cage_read_options {
    size_t struct_size;    /**< sizeof(sf_cage_read_options), set by the default */
    sf_cage_format format; /**< the format */
    uint64_t bytes_max;    /**< most bytes read from the source */
    size_t points_max;     /**< most points; beyond SF_CAGE_POINT_MAX it is that */
    size_t corners_max;    /**< most corners of all cells; beyond SF_CAGE_POINT_MAX it is that */
} sf_cage_read_options;

/**
 * The default options: any format, 8 GiB, SF_CAGE_POINT_MAX points and corners.
 *
 * @return the options, by value, with struct_size set.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_cage_read_options sf_cage_read_options_default(void);

/** What reading found besides the cage. */
typedef struct sf_cage_reading {
    sf_cage_format format; /**< the format of the file */
    size_t turned_cells;   /**< cells that were inverted at every corner, and were turned */
    size_t passed_over;    /**< elements of a lower dimension than the cage's, which it lacks */
} sf_cage_reading;

/**
 * Read a cage from any source of bytes.
 *
 * Coordinates are taken as they are, as mm. Where a file has cells, its faces are passed over;
 * where it has none, its faces are the cage, of dimension 2. A cell that is inverted at every one
 * of its corners, as the wedges of one half of all programs are, is turned: its lower polygon
 * becomes the upper one. Cells that are inverted in part are left to sf_cage_check(); faces are
 * never turned. A cell is numbered, in sentences too, among the cells that the cage has, from 0.
 *
 * - Medit: Vertices, Tetrahedra, Prisms (or Wedges, or Pentahedra), Hexahedra, Triangles and
 *   Quadrilaterals; Corners become sharp points, the Edges that Ridges names become creases, both
 *   sharp for ever. Where the references of cells are not all the same, they become the property
 *   "reference", one value for each cell. Other sections of the format are passed over.
 * - MFEM: elements, vertices or nodes. Of nodes, the points are taken: what is curved between them
 *   is not kept. Attributes become the property "attribute", as references do. Meshes with hanging
 *   nodes are refused: faces that meet half a face have no common limit.
 * - VTK: versions 2.0 to 5.1. Tetrahedra, wedges, hexahedra, voxels, prisms over five and six
 *   corners; triangles, quads, pixels and polygons. Point data and cell data with one component are
 *   properties under their names; cell data become one value for each cell. Data of several
 *   components are passed over. What sf_cage_write_vtk() has written comes back as it was.
 *
 * A property of a foreign file has no unit, no bounds, and a UUID that is made of its name
 * (version 8 of RFC 9562: the first 128 bits of the SHA-256 of "libsf property " and the name).
 *
 * No count in a file is believed: memory grows as the bytes come. Refused are pyramids, elements
 * with curved edges of their own, a cell whose type disagrees with its number of corners, corners
 * that name no point, numbers that are not finite, files that are cut short, and what
 * sf_cage_create() refuses; where hanging nodes are the reason for that, the sentence names one. To
 * stop early, let the source return SF_ERR_CANCELLED.
 *
 * @param source     the file, read to where the cage ends, or somewhat beyond
 * @param options    NULL for sf_cage_read_options_default()
 * @param allocator  for the cage and for reading; NULL for the C library's
 * @param cage       where the new cage is left, to be destroyed by the caller; untouched on failure
 * @param reading    NULL, or what was found; untouched on failure
 * @param fault      NULL, or filled on failure: what is wrong, at which line (of text files) and
 * byte, and what to do
 * @return SF_OK; SF_ERR_FORMAT: the bytes are no cage; SF_ERR_UNSUPPORTED: a mesh that a cage
 * cannot be; SF_ERR_OVERFLOW: more than the options allow; SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL
 * pointer or an unknown format; or what the source returned.
 * @cost one pass over the file; memory for about three times the cage.
 * @threads any, on distinct sources; one at a time for each allocator.
 * @source P. Frey, "MEDIT: An interactive mesh visualization software", 2001; the MFEM project,
 * "MFEM mesh formats"; Kitware, "VTK file formats", legacy.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_read(sf_source source, const sf_cage_read_options *options,
                                         const sf_allocator *allocator, sf_cage **cage,
                                         sf_cage_reading *reading, sf_fault *fault);

/**
 * Write a cage, or a refined one, as a legacy VTK file, version 3.0, that ParaView opens.
 *
 * A property is data of points; one that is the same at all corners of each cell, by its indices,
 * is data of cells. Where a property jumps, a point is written once for each set of values that
 * its corners have: first all points in their order, then the other copies. Then the data of
 * points "sf_point" say which point each one is a copy of. What VTK has no place for are fields of
 * the grid: "sf_creases", rows of two points and a sharpness; "sf_sharps", rows of a point and a
 * sharpness; "sf_property:NAME", of each property, 27 numbers: the bytes of its UUID, the
 * exponents of its unit, then 1 and the low bound or 0 and 0, and the same for the high bound. In
 * names, blanks, % and quotation marks are written as VTK does, % and two digits.
 *
 * sf_cage_read() makes the same cage of it: the same points, cells and sharp things, and at every
 * corner the same value; corners of a point that have the same value then name the same one.
 * Numbers read back as the same doubles; a zero with a sign loses it in text. A sharpness beyond
 * SF_SHARP is written as that.
 *
 * @param view       the cage; what is read of it is checked before the first byte is written
 * @param binary     0: text; else binary
 * @param allocator  for scratch; NULL for the C library's
 * @param sink       where the bytes go; on failure it may have had some
 * @param fault      NULL, or receives a sentence on failure, but for one of memory or of the sink
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a dimension other than 2 or 3, no points or
 * cells, an index out of range, a number that is not finite, a property without a name, with that
 * of another, or called "sf_point"; SF_ERR_UNSUPPORTED: a cell of a number of corners for which VTK
 * has no type, a prism over more than six; SF_ERR_OVERFLOW: more than 2^31 - 1 points, copies
 * included; SF_ERR_MEMORY; or what the sink returned.
 * @cost one pass to check, one to write; where a property jumps, 12 bytes for each point and 16 for
 * each corner.
 * @threads any, on distinct sinks; one at a time for each allocator.
 * @source Kitware, "VTK file formats", legacy.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_write_vtk(const sf_cage_view *view, int binary,
                                              const sf_allocator *allocator, sf_sink sink,
                                              sf_fault *fault);

#ifdef __cplusplus
}
#endif

#endif
